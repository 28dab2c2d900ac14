"""Tab and F6: every panel and every field is reached, in the order in which one reads."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QApplication, QWidget

from situ_studio.assistive.tab_order import reading_order

Start = Callable[..., Any]
Copy = Callable[[str], Path]
SHIFT = Qt.KeyboardModifier.ShiftModifier


def said(widget: QWidget) -> str:
    interface = QAccessible.queryAccessibleInterface(widget)
    return interface.text(QAccessible.Text.Name)


def focused() -> QWidget:
    widget = QApplication.focusWidget()
    assert widget is not None
    return widget


def test_areas_are_read_line_by_line() -> None:
    areas = [
        QRect(100, 2, 20, 20),  # a button a little lower than the field before it
        QRect(0, 0, 80, 24),
        QRect(0, 30, 80, 24),
        QRect(0, 60, 20, 20),
        QRect(100, 58, 20, 24),
    ]
    assert reading_order(areas) == [1, 0, 2, 3, 4]
    # A list with no rows may have no height; it has its turn all the same.
    assert reading_order([QRect(0, 10, 80, 0), QRect(0, 0, 80, 8)]) == [1, 0]


def test_tab_goes_through_a_form_from_its_upper_to_its_lower_edge(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    form = used.window.inspector.form
    form.field("name").setFocus()
    seen: list[QWidget] = []
    while form.isAncestorOf(focused()):
        seen.append(focused())
        used.key(Qt.Key.Key_Tab)
    tops = [w.mapTo(form, w.rect().center()).y() for w in seen]
    assert len(seen) > 12
    assert all(b > a - 12 for a, b in pairwise(tops)), [said(w) for w in seen]
    # And back again.
    used.key(Qt.Key.Key_Tab, SHIFT)
    assert focused() is seen[-1]


def test_f6_goes_round_the_panels_and_leaves_the_drawing(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    used.select("state", "2")
    window.current_view.canvas.viewer.setFocus()
    visited = []
    for _ in range(14):
        used.key(Qt.Key.Key_F6)
        focus = focused()
        visited.append(next(p for p in window.panels_in_order if _holds(p, focus)))
    for panel in (
        window.inspector,
        window.bottom.strip,
        window.status,
        window.toolbar,
        window.project_tree,
        window.outline,
        window.current_view.canvas,
    ):
        assert panel in visited
    assert visited.index(window.inspector) < visited.index(window.toolbar)
    used.key(Qt.Key.Key_F6, SHIFT)
    assert _holds(visited[-2], focused())


def test_after_something_was_found_the_focus_is_in_the_drawing(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    used.type("save profile")
    used.key(Qt.Key.Key_Return)
    assert used.window.current_view.selected == (("state", "9"),)
    assert focused() is used.window.current_view.canvas.viewer


def _holds(panel: QWidget, widget: QWidget) -> bool:
    return panel is widget or panel.isAncestorOf(widget)


PLACES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("reception.rbd.xml", ()),
    ("reception.rbd.xml", ("always",)),
    ("reception.rbd.xml", ("state", "1")),
    ("reception.rbd.xml", ("state", "1", "event", "2")),
    ("reception.rbd.xml", ("state", "7", "action", "1")),
    ("reception.rbd.xml", ("state", "1", "screen", "english")),
    ("reception.rbd.xml", ("state", "16")),
    ("modules.xml", ()),
)
SCRIPT: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("conversation.spds.xml", ()),
    ("conversation.spds.xml", ("situation", "invited")),
    ("conversation.spds.xml", ("situation", "invited", "entry", "0")),
    ("modules.xml", ("module", "nod")),
)


def test_nothing_that_takes_the_focus_is_without_a_name(studio: Start, project: Copy) -> None:
    used = studio()
    nameless(used.window, "welcome")
    for name, places in (("reception", PLACES), ("conversation", SCRIPT)):
        used.window.open_project(project(name))
        for file, place in places:
            for mode in ("graph", "outline"):
                used.window.open_file(file)
                used.window.show_mode(mode)
                used.select(*place)
                nameless(used.window, f"{file} {place} {mode}")
    used.key(Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    nameless(used.window.finder, "finder")
    used.key(Qt.Key.Key_Escape)


def nameless(top: QWidget, where: str) -> None:
    every = [w for w in top.findChildren(QWidget) if w.isVisible() and w.isEnabled()]
    stops = [w for w in every if w.focusPolicy() != Qt.FocusPolicy.NoFocus and not w.focusProxy()]
    assert stops
    found = [f"{type(w).__name__} at {w.mapTo(top, QPoint())}" for w in stops if not said(w)]
    assert not found, f"{where}: {found}"
