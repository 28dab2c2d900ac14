"""A rehearsal is ended where it was begun, and leaves the window as it was."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from situ_studio.project.projects import new_project
from situ_studio.rehearsing.saving import SavingScenario


def test_the_forms_are_as_wide_after_a_rehearsal_as_before(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    used = studio(project("reception"))
    window, forms = used.window, used.window.docks["inspector"]
    window.open_file("reception.rbd.xml")
    used.settle()
    before = forms.width()
    window.rehearsing.rehearse()
    used.settle()
    assert window.docks["rehearsal"].width() > before
    window.rehearsing.end()
    used.settle()
    assert forms.width() == before


def test_it_is_ended_in_the_toolbar_while_it_runs(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    used = studio(project("reception"))
    window = used.window
    action = window.actions_.actions["rehearse.end"]
    button = window.toolbar.widgetForAction(action)
    assert not button.isVisible()
    used.click(window.toolbar.widgetForAction(window.actions_.actions["rehearse"]))
    assert window.rehearsing.running is not None
    used.click(button)
    assert window.rehearsing.running is None
    assert not button.isVisible()


def test_where_nobody_can_say_anything_nothing_is_told_of_what_people_say(
    studio: Callable[..., Any], tmp_path: Path
) -> None:
    used = studio(new_project(tmp_path, "silent", "empty"))
    used.window.rehearsing.rehearse()
    used.settle()
    desk = used.window.rehearsing.desk
    seen = {label.text() for label in desk.findChildren(QLabel) if label.isVisible()}
    assert "People say" not in seen
    assert desk.isVisible()
    used.window.rehearsing.end()


def test_a_click_on_a_row_chooses_what_shall_happen_again(desk: Any) -> None:
    used = desk("conversation")
    used.go_on(1)
    used.studio.click(used.desk.clock.save)
    (saving,) = used.window.findChildren(SavingScenario)
    before = len(saving.expected)
    row = saving.list.visualItemRect(saving.list.item(0))
    at = row.center()
    QTest.mouseClick(saving.list.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert len(saving.expected) == before - 1
    QTest.mouseClick(saving.list.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert len(saving.expected) == before
    QTest.mouseClick(saving.list.viewport(), Qt.MouseButton.RightButton, pos=at)
    assert len(saving.expected) == before
    assert saving.list.item(0).toolTip() == saving.list.item(0).text()
    saving.reject()
