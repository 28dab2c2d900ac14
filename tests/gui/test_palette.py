"""The palette: what belongs together stands together, and the outline keeps its room."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtWidgets import QLabel

from situ_studio.panels.palette import PaletteItem

Start = Callable[..., Any]


@pytest.fixture
def used(studio: Start, project: Callable[[str], Path]) -> Any:
    made = studio(project("reception"))
    made.window.open_file("reception.rbd.xml")
    made.settle()
    return made


def told(used: Any) -> list[str]:
    return [label.text() for label in used.window.palette_.findChildren(QLabel)]


def test_no_row_has_kinds_of_two_groups(used: Any) -> None:
    rows: dict[int, set[str]] = {}
    for item in used.window.palette_.findChildren(PaletteItem):
        rows.setdefault(item.y(), set()).add(item.kind.palette)
    assert [len(groups) for groups in rows.values()] == [1] * len(rows)
    in_order = [next(iter(rows[y])) for y in sorted(rows)]
    assert list(dict.fromkeys(in_order)) == ["application", "action", "screen", "drawing"]


def test_groups_have_names_where_the_window_is_high(used: Any) -> None:
    assert told(used) == []
    used.window.resize(1280, 1100)
    used.settle()
    assert told(used) == ["Actions", "On its screen"]


def test_where_nothing_is_drawn_it_says_where_something_is(used: Any) -> None:
    used.window.open_file("texts")
    used.settle()
    assert used.window.palette_.findChildren(PaletteItem) == []
    assert told(used) == ["Open a drawing to add to it."]
    assert "drawing" in used.window.inspector._words.text()
    used.window.open_file("reception.rbd.xml")
    used.settle()
    assert told(used) == []
