"""The keys of a sheet: all that the mouse does on it is done with them too."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent, QKeySequence

from situ_studio.screens import placing
from situ_studio.screens.placing import Box

if TYPE_CHECKING:
    from situ_studio.screens.sheet import Sheet

KEYS: tuple[tuple[str, str], ...] = (
    ("Tab, Shift+Tab", "The next component, the one before"),
    ("Arrows", "Move the selected components by 1 %, with Shift by 10 %"),
    ("Alt+arrows, Ctrl+arrows", "Make them larger or smaller by 1 %, with Shift by 10 %"),
    ("Tab behind the last component", "The guides, one after the other"),
    ("Arrows, Del on a guide", "Move it by 1 %, with Shift by 10 %, with Alt by 0.1 %; remove it"),
    ("F2", "Write the component's text where it stands"),
    ("A letter", "Write another text"),
    ("Enter", "To the form of the component"),
    ("Ctrl+A", "Select all components"),
    ("Del", "Delete the selected components"),
    ("Esc", "Give up a drag or a text; select the state again"),
    ("Shift while dragging", "Along one axis; resize in proportion"),
    ("Alt while dragging", "Free of guides and grid"),
    ("Alt+click", "What lies under the selected component"),
)
"""With what a person reads of each (``commands.shortcuts``)."""

ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, -1),
    Qt.Key.Key_Down: (0, 1),
}
DELETE = (Qt.Key.Key_Delete, Qt.Key.Key_Backspace)
ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
RESIZE = Qt.KeyboardModifier.AltModifier | Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


def takes(sheet: Sheet, event: QKeyEvent) -> bool:
    """Whether a key that is a command's elsewhere is the sheet's, where it has the focus."""
    if event.matches(QKeySequence.StandardKey.SelectAll):
        return bool(sheet.own())
    if not sheet.selected:
        return False
    return event.key() in (*ARROWS, *DELETE, Qt.Key.Key_F2)


def step(sheet: Sheet, event: QKeyEvent) -> bool:
    """Tab goes from component to component, and on behind the last one; whether it did."""
    if event.key() not in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
        return False
    if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
        return False
    every = list(sheet.own())
    way = -1 if event.key() == Qt.Key.Key_Backtab else 1
    now = [every.index(id) for id in sheet.selected]
    # From nothing to the first one or the last one.
    at = (max(now, default=-1) if way > 0 else min(now, default=len(every))) + way
    if not 0 <= at < len(every):
        return False
    sheet.choose((every[at],))
    return True


def press(sheet: Sheet, event: QKeyEvent) -> bool:
    """Does what a key says; whether it says anything."""
    boxes, key, held = sheet.selected_boxes(), Qt.Key(event.key()), event.modifiers()
    if event.matches(QKeySequence.StandardKey.SelectAll) and sheet.own():
        sheet.select_all()
    elif not boxes:
        return False
    elif key in ARROWS:
        far = 10 if held & SHIFT else 1
        dx, dy = (far * one for one in ARROWS[key])
        if held & RESIZE:
            sheet.place(_resized(boxes, dx, dy), sheet.tr("Resize {0}"))
        else:
            sheet.place(placing.moved(boxes, dx, dy), sheet.tr("Move {0}"))
    elif key in DELETE:
        screen = sheet.screen_shown
        assert screen is not None
        sheet.tell(placing.without(screen, boxes), sheet.tr("Delete {0}"))
        sheet.choose(())
    elif key in ENTER:
        sheet.opened.emit(next(iter(boxes)))
    elif key == Qt.Key.Key_Escape:
        sheet.choose(())
    elif key == Qt.Key.Key_F2:
        sheet.writing.begin(next(iter(boxes)))
    else:
        return len(boxes) == 1 and _types(sheet, event)
    return True


def _resized(boxes: dict[str, Box], dx: float, dy: float) -> dict[str, Box]:
    """The right or lower edge goes; at the edge of the screen, the other one."""
    whole = placing.around(boxes.values())
    if dx:
        at_edge = dx > 0 and whole.right >= 99.995
        return placing.resized(boxes, "w" if at_edge else "e", -dx if at_edge else dx, 0)
    at_edge = dy > 0 and whole.bottom >= 99.995
    return placing.resized(boxes, "n" if at_edge else "s", 0, -dy if at_edge else dy)


def _types(sheet: Sheet, event: QKeyEvent) -> bool:
    """A letter begins another text."""
    text, keys = event.text(), Qt.KeyboardModifier
    command = event.modifiers() & (keys.ControlModifier | keys.AltModifier | keys.MetaModifier)
    if command or not text.isprintable() or not text.strip():
        return False
    return sheet.writing.begin(sheet.selected[0], text)
