"""What is selected is called by its name: in the status bar, and above its form."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt

Start = Callable[..., Any]
Copy = Callable[[str], Path]

TOLD = {
    ("state", "7"): "1 state selected",
    ("state", "7", "event", "0"): "1 event selected",
    ("state", "7", "action", "0"): "1 action selected",
    ("state", "7", "timeout"): "1 timeout selected",
    ("state", "7", "screen"): "1 screen selected",
    ("state", "4", "screen", "confirm"): "1 component selected",
    ("always", "event", "0"): "1 event selected",
    ("always", "screen"): "1 screen selected",
}


def test_the_status_bar_calls_what_is_selected_by_its_kind(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.open_file("reception.rbd.xml")
    told = {}
    for place in TOLD:
        used.select(*place)
        told[place] = used.window.status.selection.text()
    assert told == TOLD


def test_a_name_above_the_form_is_not_cut_for_what_it_is(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window, inspector = used.window, used.window.inspector
    window.open_file("reception.rbd.xml")
    used.settle()
    used.select("state", "1", "event", "0")
    title, pill = inspector._title, inspector._pill
    assert title.text() == "screenTouched"
    assert pill.text() == "Event"
    assert pill.toolTip() == "Event of state 1"
    assert title.width() >= title.fontMetrics().horizontalAdvance(title.text())
    for number in "24":
        used.select("state", "7", "event", number)
        assert title.width() >= title.fontMetrics().horizontalAdvance(title.text())
    used.select("state", "7")
    assert pill.text() == "State 7"
    assert not pill.toolTip()
    used.select("state", "1", "event", "0")
    window.resizeDocks([window.docks["inspector"]], [400], Qt.Orientation.Horizontal)
    used.settle()
    assert pill.text() == "Event of state 1"
