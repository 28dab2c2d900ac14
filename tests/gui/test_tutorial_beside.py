"""The tutorial in a window of its own, beside the one that it is done in."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QMargins, QSettings, Qt
from PySide6.QtGui import QImage, QTextDocument
from PySide6.QtTest import QTest

from situ.resources import tutorial
from situ_studio.help.tutorial import STEP, Step, steps

Start = Callable[..., Any]
IMAGE = QTextDocument.ResourceType.ImageResource.value


@pytest.fixture
def used(studio: Start) -> Any:
    return studio()


def opened(used: Any) -> Any:
    used.click(used.window.welcome.tutorial)
    return used.window.helping.tutorial


def test_a_step_is_a_section_and_what_leads_out_of_it_is_words() -> None:
    text = "# A\n\nSee [x.md](x.md).\n\n## 1. B\n\n![y](tutorial/y.png)\n\nC\n"
    assert steps(text) == [Step("A", "See x.md."), Step("1. B", "![y](tutorial/y.png)\n\nC")]


def test_every_picture_of_a_step_is_shown_and_no_wider_than_the_window(used: Any) -> None:
    window = opened(used)
    pictures = sorted((tutorial().with_suffix("")).glob("*.png"))
    named = [one for one in pictures if any(one.name in step.text for step in window.steps)]
    assert named == pictures
    shown = window.pages.loadResource(IMAGE, f"tutorial/{pictures[0].name}")
    assert isinstance(shown, QImage)
    assert 0 < shown.deviceIndependentSize().width() <= window.pages.viewport().width()


def test_it_is_gone_through_by_mouse_and_keys_and_goes_on_where_one_left_off(
    used: Any, settings: QSettings
) -> None:
    window = opened(used)
    assert window.title.text() == window.steps[0].title
    assert not window.back.isEnabled()
    used.click(window.next)
    QTest.keyClick(window.next, Qt.Key.Key_Space)
    assert window.title.text() == window.steps[2].title
    assert "2" in window.where.text()
    used.click(window.back)
    assert window.title.text() == window.steps[1].title
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert not window.isVisible()
    assert int(str(settings.value(STEP))) == 1
    window.show_step(99)
    assert not window.next.isEnabled()
    used.window.actions_.actions["tutorial"].trigger()
    assert window.isVisible()
    assert window.title.text() == window.steps[-1].title
    window.close()


@pytest.mark.parametrize(("kept", "shown"), [("2", 2), ("one", 0), (99, -1), (-3, 0)])
def test_it_begins_at_a_step_that_there_is_whatever_was_kept(
    used: Any, settings: QSettings, kept: object, shown: int
) -> None:
    settings.setValue(STEP, kept)
    window = opened(used)
    assert window.title.text() == window.steps[shown].title
    window.close()


def test_it_is_as_large_as_it_was_made(studio: Start) -> None:
    first = studio()
    window = opened(first)
    usual = window.size()
    larger = usual.grownBy(QMargins(0, 0, 60, 40))
    window.resize(larger)
    window.close()
    first.window.close()
    again = opened(studio())
    assert again.size() == larger != usual
    again.close()


def test_what_is_typed_stands_out_in_the_colours_of_the_window(used: Any) -> None:
    window = opened(used)
    window.show_step(2)

    def grounds() -> set[str]:
        document = window.pages.document()
        found, block = set(), document.begin()
        while block.isValid():
            found |= {
                at.fragment().charFormat().background().color().name()
                for at in block
                if at.fragment().charFormat().background().style() != Qt.BrushStyle.NoBrush
            }
            block = block.next()
        return found

    light = grounds()
    used.window.choose_theme("dark")
    used.settle()
    assert len(light) == 1
    assert len(grounds()) == 1
    assert grounds() != light
    window.close()


def test_the_first_page_of_the_help_is_a_click_away(used: Any) -> None:
    used.click(used.window.welcome.help)
    assert used.window.helping.shown.topic == "page/first"
    used.window.helping.shown.close()
