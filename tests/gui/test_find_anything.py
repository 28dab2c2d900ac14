"""Ctrl+K: what is found by which letters, in which order, and why a command can not be done."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QSettings, Qt

from situ_studio.actions import COMMANDS
from situ_studio.commands.reasons import reasons
from situ_studio.finding.find import FOUND, Find, letters

CONTROL = Qt.KeyboardModifier.ControlModifier

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def found(used: Studio) -> list[Find]:
    model = used.window.finder.list.model()
    return [model.index(row, 0).data(FOUND) for row in range(model.rowCount())]


def test_every_condition_of_a_command_has_its_reason() -> None:
    assert {one for c in COMMANDS for one in c.when.split()} == set(reasons())


@pytest.mark.parametrize(
    ("query", "text", "fits"),
    [
        ("se", "Show everything", 2),
        ("sheve", "Show everything", 2),
        ("se", "Save", 22),
        ("es", "Show everything", None),
        ("saev", "Save", None),
    ],
)
def test_letters_fit_in_their_order_and_best_where_words_begin(
    query: str, text: str, fits: int | None
) -> None:
    assert letters(query, text) == fits


def test_initials_find_a_command_before_scattered_letters(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_K, CONTROL)
    used.type("zi")
    assert found(used)[0].text == "Zoom in"
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("shevng")
    assert found(used)[0].text == "Show everything"
    used.key(Qt.Key.Key_Escape)


def test_what_was_used_lately_stands_first_also_at_the_next_start(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    folder = project("reception")
    used = studio(folder)
    used.key(Qt.Key.Key_9, CONTROL)
    used.key(Qt.Key.Key_A, CONTROL)
    again = studio(folder)
    for one in (used, again):
        one.window.activateWindow()
        one.window.commands.find()
        one.settle()
        assert [f.command for f in found(one)][:2] == ["select_all", "zoom_fit"]
        one.key(Qt.Key.Key_Escape)


def test_what_can_not_be_done_stands_at_the_end_and_says_why(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select()
    used.key(Qt.Key.Key_K, CONTROL)
    every = [bool(f.why) for f in found(used)]
    assert every == sorted(every)
    assert True in every
    used.type("undo")
    first = found(used)[0]
    assert (first.text, first.detail) == ("Undo", "nothing was changed")
    used.key(Qt.Key.Key_Return)
    assert not used.window.finder.isVisible()
    assert used.window.status.said.text() == "Undo: nothing was changed"
