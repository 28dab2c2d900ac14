"""The timeline's drawing in use: hands and keys that move its cursor, and what is seen."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QFocusEvent,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPaintEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QToolTip

from situ_studio.assistive.announcing import announce
from situ_studio.assistive.heard_as import hear_as
from situ_studio.live.timeline.bookmarks import Bookmarks
from situ_studio.live.timeline.drawing import TimelineDrawing
from situ_studio.live.timeline.painting import EDGE, GUTTER, StateName
from situ_studio.live.timeline.telling import told_moment
from situ_studio.live.viewing import Viewing
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.focus_ring import paint_ring

NEAR = 4
"""Px within which a hand is on the cursor, or has not moved."""
ZOOM = 1.25

_KEYS = {
    Qt.Key.Key_Left,
    Qt.Key.Key_Right,
    Qt.Key.Key_Home,
    Qt.Key.Key_End,
    Qt.Key.Key_Space,
    Qt.Key.Key_Plus,
    Qt.Key.Key_Equal,
    Qt.Key.Key_Minus,
    Qt.Key.Key_B,
    Qt.Key.Key_PageUp,
    Qt.Key.Key_PageDown,
}


class TimelineChart(TimelineDrawing):
    """Moves the cursor of what it shows, and changes nothing else.

    Click or drag at the top or on the cursor moves the cursor, a click elsewhere puts it there,
    a drag elsewhere moves what is seen, the wheel zooms (over the names: scrolls; with Shift, or
    sideways: moves what is seen).
    """

    mark_asked = Signal()
    """A bookmark is wanted at the cursor."""

    def __init__(
        self, theme: Theme, viewing: Viewing, bookmarks: Bookmarks, state_name: StateName
    ) -> None:
        super().__init__(theme, viewing, bookmarks, state_name)
        self._hand = ""
        self._from = QPointF()
        hear_as(self, QAccessible.Role.Slider)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.viewport().setMouseTracking(True)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if event.button() != Qt.MouseButton.LeftButton or at.x() < px(GUTTER):
            return
        on_cursor = abs(self.axis.x(self.viewing.t) + px(GUTTER) - at.x()) <= NEAR
        self._hand, self._held = "scrub" if at.y() < px(EDGE) or on_cursor else "press", True
        self._from = at
        # Of flags upon each other the last is seen.
        flags = reversed(self._flags())
        marked = next((mark for mark, flag in flags if flag.contains(at)), None)
        if marked is not None and not (on_cursor and marked.t == self.viewing.t):
            # The hand lies on its name, beside its moment: what is meant is that.
            self._hand, self._held = "", False
            self.viewing.seek(marked.t)
        elif self._hand == "scrub" and not on_cursor:
            self.viewing.seek(self.axis.t(at.x() - px(GUTTER)))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if self._hand == "scrub":
            x = min(max(at.x() - px(GUTTER), 0.0), self.axis.width)
            self.viewing.seek(self.axis.t(x))
        elif self._hand == "press" and abs(at.x() - self._from.x()) >= NEAR:
            self._hand = "pan"
            self.viewing.pause()
        if self._hand == "pan":
            self.axis.pan(at.x() - self._from.x())
            self._from = at
            self.marked.emit()
            self.viewport().update()
        on_edge = at.x() >= px(GUTTER) and at.y() < px(EDGE)
        near = abs(self.axis.x(self.viewing.t) + px(GUTTER) - at.x()) <= NEAR
        shape = Qt.CursorShape.SplitHCursor if near or on_edge else Qt.CursorShape.ArrowCursor
        if self._hand == "pan":
            shape = Qt.CursorShape.ClosedHandCursor
        self.viewport().setCursor(shape)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        hand, self._hand, self._held = self._hand, "", False
        if hand == "press":
            self.viewing.seek(self.axis.t(event.position().x() - px(GUTTER)))

    def wheelEvent(self, event: QWheelEvent) -> None:
        turned, at = event.angleDelta(), event.position()
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if at.x() < px(GUTTER):
            super().wheelEvent(event)
        elif shift or abs(turned.x()) > abs(turned.y()):
            self.viewing.pause()
            self.axis.pan((turned.x() or turned.y()) / 2)
            self._changed()
        elif turned.y():
            follows = self.viewing.follows
            about = self.viewing.t if follows else self.axis.t(at.x() - px(GUTTER))
            self.axis.zoom(ZOOM ** (-turned.y() / 120), about)
            self._changed()
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        before = self.viewing.t
        self._press(event)
        # What follows goes on by itself.
        if not self.viewing.follows and self.viewing.t != before:
            announce(self, self.told_now())

    def step(self, by: int) -> None:
        """To the event after, or before, as a button does."""
        self.viewing.step(by)
        announce(self, self.told_now())

    def focusInEvent(self, event: QFocusEvent) -> None:
        self.setAccessibleDescription(self.told_now())
        super().focusInEvent(event)
        self.viewport().update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.viewport().update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.hasFocus():
            paint_ring(self.viewport())

    def told_now(self) -> str:
        """What stands at the cursor."""
        t, own = self.viewing.t, [row for row in self.rows if row.run == 0]
        return told_moment(self.clock(t), t, own, self.bookmarks.every, self._painter.state_name)

    def _press(self, event: QKeyEvent) -> None:
        viewing, key = self.viewing, Qt.Key(event.key())
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if not self._takes(event):
            super().keyPressEvent(event)
        elif key in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            by = 1 if key == Qt.Key.Key_Right else -1
            if shift:
                viewing.seek(viewing.t + by)
            else:
                viewing.step(by)
        elif key == Qt.Key.Key_Home:
            viewing.seek(viewing.span[0])
        elif key == Qt.Key.Key_End:
            viewing.seek(viewing.span[1])
        elif key == Qt.Key.Key_Space:
            self.toggle()
        elif key == Qt.Key.Key_B:
            self.mark_asked.emit()
        elif key in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            find = self.bookmarks.before if key == Qt.Key.Key_PageUp else self.bookmarks.after
            mark = find(viewing.t)
            if mark is not None:
                viewing.seek(mark.t)
        else:
            self.zoom(ZOOM if key == Qt.Key.Key_Minus else 1 / ZOOM)

    def toggle(self) -> None:
        """The cursor stays where it is, or goes to the end and with it."""
        if self.viewing.follows:
            self.viewing.pause()
        else:
            self.viewing.follow()

    def event(self, event: QEvent) -> bool:
        override = event.type() == QEvent.Type.ShortcutOverride
        if override and isinstance(event, QKeyEvent) and self._takes(event):
            event.accept()
            return True
        return super().event(event)

    def viewportEvent(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            words = self.told_at(event.pos())
            QToolTip.showText(event.globalPos(), words, self.viewport())
            return True
        return super().viewportEvent(event)

    @staticmethod
    def _takes(event: QKeyEvent) -> bool:
        held = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        plain = held in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier)
        return plain and event.key() in _KEYS
