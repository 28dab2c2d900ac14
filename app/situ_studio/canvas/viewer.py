"""The seam's lower half: NodeGraphQt's viewer, whose gestures become intents (canvas.md).

The viewer never writes a model. It collects what a gesture touched and what it
asked for, and says ``settled`` when no gesture is under way any more; the graph
then turns it into one edit or none and puts the picture back to the document.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QMimeData, QPoint, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QAccessible,
    QContextMenuEvent,
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
    QKeyEvent,
    QMouseEvent,
)
from PySide6.QtWidgets import QApplication
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas.drawn_pipe import DrawnPipe
from situ_studio.canvas.ground import Ground
from situ_studio.canvas.nodes import OUT, NodeFace, Spot
from situ_studio.canvas.pipes import RoutedPipe
from situ_studio.canvas.style import Look
from situ_studio.kinds import MIME, MODULE_MIME

SLOP = 4.0
"""How far off a press may be, in px on screen."""


class _Press:
    """What NodeGraphQt's scene handlers read of a mouse event, at a place of our choice."""

    def __init__(self, spot: QPointF) -> None:
        self._spot = QPointF(spot)

    def scenePos(self) -> QPointF:
        return QPointF(self._spot)

    def button(self) -> Qt.MouseButton:
        return Qt.MouseButton.LeftButton


class Viewer(Ground):
    """touched: uids whose picture may differ from the document since the last ``settled``.

    held: modifiers of the latest mouse event. on_key: what to do with a key; True
    where it was for us. accepts: whether a pipe from an exit to an input means
    something. pipe_kind: the items that pipes are.
    """

    # NodeGraphQt's own, untyped.
    _LIVE_PIPE: Any
    _start_port: Any
    _detached_port: Any

    settled = Signal()
    cancelled = Signal()
    """Esc in the middle of a gesture: nothing of it counts."""
    dropped = Signal(object, QPointF)
    """A pipe was dropped on empty canvas: its exit's item, where."""
    double_click = Signal(object, QPointF)
    clicked = Signal(object, QPointF)
    """A press and release at one place: the node's item or None, where on it."""
    refused = Signal(object, QPointF)
    """A pipe from an exit was dropped on a card that it can not lead to."""
    moved = Signal()
    """Cards are where they were not; the pipes have to follow."""
    menu_wanted = Signal(object, QPoint)

    def __init__(self, look: Look, parent: Widget | None = None) -> None:
        self.touched: set[str] = set()
        self._buried: list[Any] = []
        self._old: list[Any] = []
        self._waiting: tuple[Any, QPointF, QPoint] | None = None
        self._forced: Any = None
        self._pan: QPoint | None = None
        self._space = False
        self._pressed: tuple[QPoint, Any] | None = None
        self._travelled = False
        self._at = QPoint()
        self.speaker: Any = None
        self.spoken_as: Any = None
        self.held = Qt.KeyboardModifier.NoModifier
        self.on_key: Callable[[QKeyEvent], bool] = lambda event: False
        self.accepts: Callable[[Any, Any], bool] = lambda start, end: True
        self.pipe_kind: type[RoutedPipe] = RoutedPipe
        super().__init__(look, parent)
        # A top-level widget of the library's that nobody asked for.
        self._search_widget.setParent(self)
        self._search_widget.hide()
        stock: Any = self._LIVE_PIPE
        self.scene().removeItem(stock)
        self._old = [stock]
        self._LIVE_PIPE = DrawnPipe(look)
        self._LIVE_PIPE.setVisible(False)
        self.scene().addItem(self._LIVE_PIPE)
        self._cursor_text.setVisible(False)
        self.acyclic = False
        self.viewport().setMouseTracking(True)

    # -- keeping items alive ----------------------------------------------------------

    def bury(self, item: Any) -> None:
        """Keeps a removed item alive until the show after the next: Qt may still hold it."""
        self._buried.append(item)

    def forget(self) -> None:
        self._old = self._buried
        self._buried = []

    # -- gestures: what NodeGraphQt calls ----------------------------------------------

    def establish_connection(self, start_port: Any, end_port: Any) -> None:
        pipe = self.pipe_kind(self.look)
        self.hold_pipe(pipe)
        pipe.set_connections(start_port, end_port)
        self.touched.add(start_port.node.uid)
        self.touched.add(end_port.node.uid)

    def _items_near(
        self, pos: QPointF, item_type: Any = None, width: int = 20, height: int = 20
    ) -> list[Any]:
        """What lies under the cursor, not 20 px up and left of it."""
        if self._forced is not None:
            return [self._forced]
        slop = SLOP / max(self.look.zoom, 0.01)
        area = QRectF(pos.x() - slop, pos.y() - slop, 2 * slop, 2 * slop)
        found = []
        for item in self.scene().items(area):
            if item in (self._LIVE_PIPE, self._SLICER_PIPE):
                continue
            if item_type is None or isinstance(item, item_type):
                found.append(item)
        return found

    def hit(self, pos: QPointF) -> Any:
        """The port, pipe or node that a press at ``pos`` means, or None.

        An exit counts within its own few px even where a card lies on it.
        """
        nodes = under = None
        exits: list[Spot] = []
        pipes: list[RoutedPipe] = []
        for item in self._items_near(pos):
            if isinstance(item, Spot):
                if item.port_type == OUT and item.node is not None:
                    exits.append(item)
            elif isinstance(item, NodeFace):
                if not item.shape().contains(item.mapFromScene(pos)):
                    continue
                if item.zValue() < 0:
                    # A frame: what lies on it goes first.
                    under = under or item
                elif nodes is None:
                    nodes = item
            elif isinstance(item, RoutedPipe):
                pipes.append(item)
        if exits:
            return min(exits, key=lambda spot: (spot.centre() - pos).manhattanLength())
        pipe = min(pipes, key=lambda pipe: pipe.distance(pos), default=None)
        return nodes or pipe or under

    def sceneMousePressEvent(self, event: Any) -> None:
        if self._LIVE_PIPE.isVisible():
            self.apply_live_connection(event)
            return
        if event.button() != Qt.MouseButton.LeftButton or self.ALT_state or self.SHIFT_state:
            return
        item = self.hit(event.scenePos())
        if isinstance(item, Spot | RoutedPipe):
            # Taken off only when it is really dragged (canvas.md, 9).
            self._waiting = item, QPointF(event.scenePos()), event.screenPos()

    def _begin_live(self) -> None:
        assert self._waiting is not None
        item, spot, _ = self._waiting
        self._waiting = None
        if item.scene() is None:
            return
        self._forced = item
        try:
            super().sceneMousePressEvent(_Press(spot))
        finally:
            self._forced = None

    def sceneMouseMoveEvent(self, event: Any) -> None:
        if self._waiting is not None:
            way = event.screenPos() - self._waiting[2]
            if way.manhattanLength() < QApplication.startDragDistance():
                return
            self._begin_live()
        if self._LIVE_PIPE.isVisible() and self._start_port is not None:
            spot = self._target(event.scenePos())
            if isinstance(spot, Spot):
                self._LIVE_PIPE.aim(True)
                self._LIVE_PIPE.draw_path(self._start_port, cursor_pos=spot.centre())
            else:
                self._LIVE_PIPE.aim(False)
                self._LIVE_PIPE.draw_path(self._start_port, cursor_pos=event.scenePos())

    def _target(self, pos: QPointF) -> Any:
        """The input that a pipe dropped at ``pos`` goes to; False over a card that takes none."""
        start = self._start_port
        for item in self.scene().items(pos):
            node = item if isinstance(item, NodeFace) else None
            if isinstance(item, Spot):
                node = item.node
            if node is None or node.zValue() < 0:
                continue
            if node is start.node and (pos - start.centre()).manhattanLength() < 24:
                return False
            entries = [s for s in node.inputs if self.accepts(start, s)]
            near = min(entries, key=lambda s: (s.centre() - pos).manhattanLength(), default=None)
            return near if near is not None else False
        return None

    def apply_live_connection(self, event: Any) -> None:
        if not self._LIVE_PIPE.isVisible() or self._start_port is None:
            return
        start, spot = self._start_port, event.scenePos()
        start.hovered = False
        target = self._target(spot)
        if isinstance(target, Spot):
            gone = [(start, self._detached_port)] if self._detached_port is not None else []
            if self._detached_port is not target:
                self.connection_changed.emit(gone, [(start, target)])
        elif target is None:
            self.dropped.emit(start, QPointF(spot))
        else:
            self.refused.emit(start, QPointF(spot))
        self.cancel()

    def cancel(self) -> None:
        """Ends a pipe that is being drawn; what it was taken off is put back by ``settled``."""
        self._waiting = None
        self._detached_port = None
        if self._LIVE_PIPE.isVisible():
            self.end_live_connection()

    def takes_press(self) -> bool:
        """Whether the press under way means an exit or a pipe."""
        return self._waiting is not None or self.busy()

    def give_up(self) -> None:
        """Ends whatever gesture is under way, as if it had not begun."""
        self.cancel()
        self._pressed = None
        grabber = self.scene().mouseGrabberItem()
        if grabber is not None:
            grabber.ungrabMouse()
        if self._rubber_band.isActive:
            self._rubber_band.isActive = False
            self._rubber_band.hide()
        self.cancelled.emit()

    def drop_dead_ends(self) -> None:
        """The document changed under a gesture: what it started from may be gone."""
        if self._waiting is not None and self._waiting[0].scene() is None:
            self._waiting = None
        start = self._start_port
        if self.busy() and (start is None or start.scene() is None or start.node is None):
            self.cancel()
        elif self._detached_port is not None and self._detached_port.scene() is None:
            self._detached_port = None

    def dragged_to(self) -> QPointF | None:
        """Where in the scene the cursor has a card; None where it has none."""
        if self._pressed is None or not self._travelled:
            return None
        return self.mapToScene(self._at) if isinstance(self._pressed[1], NodeFace) else None

    def selected_before(self) -> list[Any]:
        """The nodes that were selected when the latest press came."""
        return list(self._prev_selection_nodes)

    def busy(self) -> bool:
        """Whether a pipe is being drawn."""
        return bool(self._LIVE_PIPE.isVisible())

    def card_moved(self, card: NodeFace) -> None:
        self.touched.add(card.uid)
        self.moved.emit()

    def double_clicked(self, card: NodeFace, spot: QPointF) -> None:
        self.double_click.emit(card, spot)

    # -- mouse ------------------------------------------------------------------------

    def _modifiers(self, event: Any) -> None:
        """Modifiers as the event has them: a key released over another window is not missed."""
        held = self.held = event.modifiers()
        shift = Qt.KeyboardModifier.ShiftModifier
        control = Qt.KeyboardModifier.ControlModifier
        alt = Qt.KeyboardModifier.AltModifier
        self.ALT_state = bool(held & alt) and bool(held & shift)
        self.SHIFT_state = bool(held & (shift | control)) or self.ALT_state
        self.CTRL_state = False

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._modifiers(event)
        middle = event.button() == Qt.MouseButton.MiddleButton
        left = event.button() == Qt.MouseButton.LeftButton
        if middle or (left and self._space):
            self._pan = event.position().toPoint()
            self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)
            event.accept()
            return
        if not left:
            if event.button() == Qt.MouseButton.RightButton:
                self._select_under(event.position().toPoint())
            event.accept()
            return
        self._travelled = False
        self._pressed = (
            event.position().toPoint(),
            self.hit(self.mapToScene(event.position().toPoint())),
        )
        super().mousePressEvent(event)

    def _select_under(self, at: QPoint) -> None:
        item = self.hit(self.mapToScene(at))
        if isinstance(item, Spot):
            item = item.node
        if item is not None and not item.isSelected():
            self.scene().clearSelection()
            item.setSelected(True)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._modifiers(event)
        if self._pan is not None:
            at = event.position().toPoint()
            way = self.mapToScene(self._pan) - self.mapToScene(at)
            self._pan = at
            self._set_viewer_pan(way.x(), way.y())
            event.accept()
            return
        self._at = event.position().toPoint()
        if self._pressed is not None:
            way = self._at - self._pressed[0]
            if way.manhattanLength() >= QApplication.startDragDistance():
                self._travelled = True
            elif not self._travelled and isinstance(self._pressed[1], NodeFace):
                # A hand that trembles does not move a card.
                event.accept()
                return
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._pan is not None:
            self._pan = None
            self._show_cursor()
            event.accept()
            return
        if event.button() != Qt.MouseButton.LeftButton:
            event.accept()
            return
        self.held = event.modifiers()
        pressed, self._pressed = self._pressed, None
        banded = self._rubber_band.isActive and self._rubber_band.isVisible()
        try:
            super().mouseReleaseEvent(event)
        finally:
            self._waiting = None
            if banded:
                self._drop_loose_pipes()
            if not self.busy():
                self.settled.emit()
        if pressed is not None and not self._travelled and not banded:
            item = pressed[1] if pressed[1] is not None and pressed[1].scene() is not None else None
            self.clicked.emit(item, self.mapToScene(event.position().toPoint()))

    def _drop_loose_pipes(self) -> None:
        """A rubber band takes cards, and of the pipes only those between them."""
        for pipe in self.selected_pipes():
            if not (pipe.input_port.node.isSelected() and pipe.output_port.node.isSelected()):
                pipe.setSelected(False)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        item = self.hit(self.mapToScene(event.pos()))
        self.menu_wanted.emit(item, event.globalPos())
        event.accept()

    # -- drops -----------------------------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        event.setAccepted(_is_ours(event.mimeData()))

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        event.setAccepted(_is_ours(event.mimeData()))

    def dropEvent(self, event: QDropEvent) -> None:
        if _is_ours(event.mimeData()):
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
            spot = self.mapToScene(event.position().toPoint())
            self.data_dropped.emit(event.mimeData(), spot.toPoint())

    # -- keys -------------------------------------------------------------------------

    def focusNextPrevChild(self, next: bool) -> bool:
        # Tab goes from card to card; F6 leaves the drawing.
        return False

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and (self.busy() or self._pressed is not None):
            self.give_up()
            event.accept()
            return
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._space = True
            self._show_cursor()
            event.accept()
            return
        event.setAccepted(self.on_key(event))

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._space = False
            self._show_cursor()

    def focusInEvent(self, event: Any) -> None:
        super().focusInEvent(event)
        if QAccessible.isActive():
            # Qt tells of the drawing itself right after this.
            QTimer.singleShot(0, self, self._tell_focus)

    def _tell_focus(self) -> None:
        if self.spoken_as is not None and self.hasFocus():
            self.spoken_as.on_focused()

    def focusOutEvent(self, event: Any) -> None:
        self._space = False
        self._show_cursor()
        super().focusOutEvent(event)

    def _show_cursor(self) -> None:
        if self._space:
            self.viewport().setCursor(Qt.CursorShape.OpenHandCursor)
        else:
            self.viewport().unsetCursor()


def _is_ours(mime: QMimeData) -> bool:
    return mime.hasFormat(MIME) or mime.hasFormat(MODULE_MIME)
