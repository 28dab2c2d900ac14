"""The screen under the mouse: components are selected, moved, resized and taken away."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QWidget

from situ.document import rbd
from situ_studio.kinds import COMPONENTS, MIME
from situ_studio.panels.preview import ScreenPreview
from situ_studio.screens import placing
from situ_studio.screens.placing import Box
from situ_studio.theme import Theme

GRIP = 7.0
"""Side of a handle, px."""
SLACK = 4.0
"""How far the mouse goes, in px, before a press is a drag."""
_ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, -1),
    Qt.Key.Key_Down: (0, 1),
}
_CURSORS = {
    "nw": Qt.CursorShape.SizeFDiagCursor,
    "se": Qt.CursorShape.SizeFDiagCursor,
    "ne": Qt.CursorShape.SizeBDiagCursor,
    "sw": Qt.CursorShape.SizeBDiagCursor,
    "n": Qt.CursorShape.SizeVerCursor,
    "s": Qt.CursorShape.SizeVerCursor,
    "e": Qt.CursorShape.SizeHorCursor,
    "w": Qt.CursorShape.SizeHorCursor,
}


class _Drag(NamedTuple):
    """What the mouse holds since it was pressed at ``start``: a handle, or all of it ("")."""

    start: QPointF
    handle: str
    boxes: Mapping[str, Box]


class Sheet(ScreenPreview):
    """A screen whose components a person places.

    What is painted while something is dragged is a proposal: the document is another one when the
    mouse is let go, in one step. Components that Always adds are shown, not touched.
    """

    chosen = Signal(tuple)
    """The ids of the components that a person selected; () is the screen itself."""
    edited = Signal(object, str)
    """Another screen, and the name of the step."""
    dropped = Signal(str, float, float)
    """A kind of component was dropped: its name, and where its middle shall be."""
    opened = Signal(str)
    """A double click or Enter: the component is to be filled in."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(theme, parent)
        self._chosen: tuple[str, ...] = ()
        self._drag: _Drag | None = None
        self._proposed: rbd.Screen | None = None
        self._guides = placing.Snap(0, 0)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.setCursor(Qt.CursorShape.ArrowCursor)

    def select(self, ids: tuple[str, ...]) -> None:
        """Shows which components are selected."""
        self._chosen = ids
        self.update()

    @property
    def selected(self) -> tuple[str, ...]:
        """The ids of the selected components that are there."""
        return tuple(self._selected())

    def align(self, edge: str) -> None:
        """Places what is selected, as ``placing.aligned`` says."""
        if self._screen is not None:
            after = placing.placed(self._screen, placing.aligned(self._selected(), edge))
            self._tell(after, self.tr("Align {0}"))

    # -- measures ------------------------------------------------------------------------

    def _own(self) -> dict[str, Box]:
        screen = self._screen
        return {c.id: placing.box_of(c) for c in screen.components} if screen is not None else {}

    def _selected(self) -> dict[str, Box]:
        own = self._own()
        return {id: own[id] for id in self._chosen if id in own}

    def area(self, box: Box) -> QRectF:
        """Where a box lies in the widget, px."""
        across, down = self.width() / 100, self.height() / 100
        return QRectF(box.x * across, box.y * down, box.width * across, box.height * down)

    def handle_at(self, name: str) -> QPointF:
        """The middle of a handle of what is selected."""
        area = self.area(placing.around(self._selected().values()))
        x = area.left() if "w" in name else area.right() if "e" in name else area.center().x()
        y = area.top() if "n" in name else area.bottom() if "s" in name else area.center().y()
        return QPointF(x, y)

    def _handle_under(self, at: QPointF) -> str:
        if len(self._selected()) != 1:
            return ""
        for name in placing.HANDLES:
            if (self.handle_at(name) - at).manhattanLength() <= GRIP:
                return name
        return ""

    def _under(self, at: QPointF) -> str | None:
        """The uppermost component there."""
        for id, box in reversed(self._own().items()):
            if self.area(box).contains(at):
                return id
        return None

    # -- mouse ---------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        at = event.position()
        handle = self._handle_under(at)
        if not handle:
            self._choose(
                self._under(at), bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            )
        self._drag = _Drag(at, handle, self._selected())

    def _choose(self, id: str | None, more: bool) -> None:
        if id is None:
            ids = self._chosen if more else ()
        elif more:
            ids = tuple(i for i in self._chosen if i != id)
            ids = (*ids, id) if len(ids) == len(self._chosen) else ids
        else:
            ids = self._chosen if id in self._chosen else (id,)
        self.select(ids)
        self.chosen.emit(ids)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if self._drag is None:
            handle = self._handle_under(at)
            self.setCursor(_CURSORS.get(handle, Qt.CursorShape.ArrowCursor))
            return
        way = at - self._drag.start
        if not self._drag.boxes or self._screen is None:
            return
        if self._proposed is None and way.manhattanLength() < SLACK:
            return
        free = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        self._propose(way.x() / self.width() * 100, way.y() / self.height() * 100, free)

    def _propose(self, dx: float, dy: float, free: bool) -> None:
        assert self._drag is not None
        assert self._screen is not None
        _, handle, boxes = self._drag
        guides = placing.Snap(dx, dy)
        if not free:
            others = [box for id, box in self._own().items() if id not in boxes]
            others += [placing.box_of(c) for c in self._above]
            whole = placing.around(boxes.values())
            guides = placing.snapped(whole, others, dx, dy, handle or "wens", not handle)
        if handle:
            after = {
                id: placing.resized(box, handle, guides.dx, guides.dy) for id, box in boxes.items()
            }
        else:
            after = placing.moved(boxes, guides.dx, guides.dy)
        self._guides = guides
        self._proposed = placing.placed(self._screen, after)
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        drag, proposed = self._drag, self._proposed
        self._end_drag()
        if drag is None or proposed is None:
            return
        self._tell(proposed, self.tr("Resize {0}") if drag.handle else self.tr("Move {0}"))

    def _end_drag(self) -> None:
        self._drag = self._proposed = None
        self._guides = placing.Snap(0, 0)
        self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self._end_drag()
        if (id := self._under(event.position())) is not None:
            self.opened.emit(id)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        event.setAccepted(_component_in(event) != "")

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        event.setAccepted(_component_in(event) != "")

    def dropEvent(self, event: QDropEvent) -> None:
        name, at = _component_in(event), event.position()
        if name:
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
            self.setFocus()
            across, down = at.x() / self.width() * 100, at.y() / self.height() * 100
            self.dropped.emit(name, across, down)

    # -- keys ----------------------------------------------------------------------------

    def event(self, event: QEvent) -> bool:
        # What is done with a component here is not done with its state on the graph.
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            deletes = event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace)
            if self._selected() and (deletes or event.key() in _ARROWS):
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        boxes, screen, key = self._selected(), self._screen, Qt.Key(event.key())
        if key == Qt.Key.Key_Escape and self._drag is not None:
            self._end_drag()
        elif screen is None or not boxes:
            super().keyPressEvent(event)
        elif key in _ARROWS:
            step = 10 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1
            dx, dy = (step * one for one in _ARROWS[key])
            self._tell(placing.placed(screen, placing.moved(boxes, dx, dy)), self.tr("Move {0}"))
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            after = placing.without(screen, boxes)
            self._tell(after, self.tr("Delete {0}"))
            self._choose(None, False)
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.opened.emit(next(iter(boxes)))
        else:
            super().keyPressEvent(event)

    def _tell(self, after: rbd.Screen, text: str) -> None:
        if after is not self._screen:
            self.edited.emit(after, text.format(", ".join(self._selected())))

    # -- painting ------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        kept = self._screen
        self._screen = self._proposed if self._proposed is not None else kept
        try:
            super().paintEvent(event)
            self._paint_marks()
        finally:
            self._screen = kept

    def _paint_marks(self) -> None:
        painter = QPainter(self)
        across, down = self.width() / 100, self.height() / 100
        painter.setPen(QPen(self._theme.color("guides"), 1))
        for x in self._guides.upright:
            painter.drawLine(QLineF(x * across, 0, x * across, self.height()))
        for y in self._guides.lying:
            painter.drawLine(QLineF(0, y * down, self.width(), y * down))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        boxes = self._selected()
        accent = self._theme.color("accent")
        painter.setPen(QPen(accent, 2))
        for box in boxes.values():
            painter.drawRoundedRect(self.area(box), 3, 3)
        if len(boxes) == 1:
            painter.setPen(QPen(accent, 1.5))
            painter.setBrush(self._theme.color("card"))
            for name in placing.HANDLES:
                grip = QRectF(0, 0, GRIP, GRIP)
                grip.moveCenter(self.handle_at(name))
                painter.drawRoundedRect(grip, 1.5, 1.5)
        painter.end()


def _component_in(event: QDropEvent) -> str:
    """The kind of component that is dragged; "" for anything else."""
    name = bytes(event.mimeData().data(MIME).data()).decode()
    return name if any(kind.name == name for kind in COMPONENTS) else ""
