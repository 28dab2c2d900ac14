"""Nodes and ports under NodeGraphQt: what every card of either canvas has in common.

One item with one ``paint()`` a node; the library's child items for text, icon
and overlay are not made. Ports are items without a picture, only there to be
hit; the card draws them.
"""

from __future__ import annotations

from typing import Any, Protocol

from msgspec.structs import replace
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath
from PySide6.QtWidgets import QGraphicsItem, QGraphicsSceneMouseEvent, QStyleOptionGraphicsItem
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas.library import AbstractNodeItem, BaseNode, NodeItem, Port, PortItem
from situ_studio.canvas.style import Look

IN, OUT = "in", "out"


class Face(Protocol):
    """What a node shows: a value of a projection."""

    @property
    def uid(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def x(self) -> float: ...
    @property
    def y(self) -> float: ...
    @property
    def width(self) -> float: ...
    @property
    def height(self) -> float: ...
    @property
    def inputs(self) -> tuple[str, ...]: ...
    @property
    def outputs(self) -> tuple[str, ...]: ...
    @property
    def many(self) -> bool:
        """Whether an exit may lead to several nodes."""
        ...

    def port(self, name: str) -> tuple[float, float]: ...
    def spoken(self) -> str: ...
    def hint(self, name: str = "") -> str:
        """What is said of the node, or of one of its exits, while the mouse rests on it."""
        ...


class Spot(PortItem):
    """A port: 18 px of card edge that can be hit. Its node paints it."""

    HALF = 8.0

    def __init__(self, parent: QGraphicsItem) -> None:
        super().__init__(parent)
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemHasNoContents, True)
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemSendsScenePositionChanges, False)
        self.setCacheMode(QGraphicsItem.CacheMode.NoCache)

    def boundingRect(self) -> QRectF:
        return QRectF(0, 0, 2 * self.HALF, 2 * self.HALF)

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        return

    def place(self, x: float, y: float) -> None:
        """Puts the port's centre there, from the card's corner."""
        self.setPos(x - self.HALF, y - self.HALF)

    def centre(self) -> QPointF:
        """In the scene."""
        return QPointF(self.scenePos() + QPointF(self.HALF, self.HALF))

    def hoverEnterEvent(self, event: Any) -> None:
        super().hoverEnterEvent(event)
        if self.port_type == OUT:
            self.setCursor(Qt.CursorShape.CrossCursor)
        self.node.hover(self.name if self.port_type == OUT else None)

    def hoverLeaveEvent(self, event: Any) -> None:
        super().hoverLeaveEvent(event)
        self.node.hover(None)

    def mousePressEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        # An exit takes the press, or a card below would be dragged; an input is part of its card.
        if self.port_type == OUT:
            event.accept()
        else:
            event.ignore()


class NodeFace(NodeItem):
    """The item of a node. ``face`` is what it shows; subclasses paint it."""

    def __init__(self, name: str = "node", parent: QGraphicsItem | None = None) -> None:
        # Not NodeItem's: it would make five child items a node.
        AbstractNodeItem.__init__(self, name, parent)
        self._input_items: dict[Spot, None] = {}
        self._output_items: dict[Spot, None] = {}
        self._widgets: dict[str, Any] = {}
        self.uid = ""
        self.face: Any = None
        self.look: Look | None = None
        self.hovered: str | None = None
        self.row: str | None = None
        """The exit that is selected by itself."""
        self._rect = QRectF(0, 0, 1, 1)
        self._shape = QPainterPath()
        self.setCacheMode(QGraphicsItem.CacheMode.NoCache)
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemSendsGeometryChanges, True)
        self.setAcceptHoverEvents(True)
        self.setZValue(1)

    # -- what the graph calls ------------------------------------------------------

    def show_face(self, face: Any) -> None:
        before, self.face = self.face, face
        if not _is_moved(before, face):
            self.prepareGeometryChange()
            self._width, self._height = face.width, face.height
            self._rect = self.room(face)
            self._shape = QPainterPath()
            self._shape.addRect(QRectF(0, 0, face.width, face.height))
            _hint(self, face.hint())
        self.prepare()
        self.update()

    def room(self, face: Any) -> QRectF:
        """All that is painted: the card, its rings, what hangs beside it."""
        return QRectF(-18, -18, face.width + 84, face.height + 36)

    def prepare(self) -> None:
        """Lays out texts for ``face``; called when face, theme or zoom changed."""

    def add_spot(self, name: str, kind: str) -> Spot:
        spot = Spot(self)
        spot.name = name
        spot._port_type = kind
        spot._multi_connection = kind == IN or self.face.many
        (self._input_items if kind == IN else self._output_items)[spot] = None
        return spot

    def remove_spot(self, spot: Spot) -> None:
        self._input_items.pop(spot, None)
        self._output_items.pop(spot, None)
        spot.setParentItem(None)
        if spot.scene() is not None:
            spot.scene().removeItem(spot)

    def hover(self, port: str | None) -> None:
        if port != self.hovered:
            self.hovered = port
            self.update()

    # -- what Qt and NodeGraphQt call ----------------------------------------------

    def boundingRect(self) -> QRectF:
        return self._rect

    def shape(self) -> QPainterPath:
        return self._shape

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        raise NotImplementedError

    def draw_node(self) -> None:
        return

    def post_init(self, viewer: Any = None, pos: Any = None) -> None:
        if pos:
            self.setPos(*pos)

    def hoverEnterEvent(self, event: Any) -> None:
        self.update()

    def hoverLeaveEvent(self, event: Any) -> None:
        self.hover(None)
        self.update()

    def mousePressEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        viewer = self.viewer()
        if viewer is not None and viewer.takes_press():
            # An exit or a pipe that reaches over this card: the card must not follow the cursor.
            event.ignore()
            return
        AbstractNodeItem.mousePressEvent(self, event)

    def mouseDoubleClickEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        viewer = self.viewer()
        if viewer is not None:
            viewer.double_clicked(self, event.pos())
        event.accept()

    def itemChange(self, change: QGraphicsItem.GraphicsItemChange, value: Any) -> Any:
        if change == QGraphicsItem.GraphicsItemChange.ItemPositionHasChanged:
            viewer = self.viewer()
            if viewer is not None:
                viewer.card_moved(self)
        elif change == QGraphicsItem.GraphicsItemChange.ItemSelectedHasChanged:
            self.row = None
            self.setZValue(2 if value else 1)
            for spot in (*self._input_items, *self._output_items):
                for pipe in spot.connected_pipes:
                    pipe.refresh()
            self.update()
        return QGraphicsItem.itemChange(self, change, value)

    @property
    def name(self) -> str:
        return str(self._properties["name"])

    @name.setter
    def name(self, name: str = "") -> None:
        self._properties["name"] = name

    @property
    def width(self) -> float:
        return float(self._width)

    @width.setter
    def width(self, width: float = 0.0) -> None:
        self._width = width

    @property
    def height(self) -> float:
        return float(self._height)

    @height.setter
    def height(self, height: float = 0.0) -> None:
        self._height = height

    @property
    def layout_direction(self) -> int:
        return int(self._properties["layout_direction"])

    @layout_direction.setter
    def layout_direction(self, value: int = 0) -> None:
        self._properties["layout_direction"] = value


class Node(BaseNode):
    """One node of NodeGraphQt's model. ``uid`` is ours; written only by ``Graph.show_picture``."""

    __identifier__ = "situ"
    NODE_NAME = "node"

    def __init__(self, item: type[NodeFace], look: Look) -> None:
        super().__init__(item)
        self.uid = ""
        self.face: Any = None
        self.view.look = look

    def show_face(self, face: Any) -> None:
        """Name, size, position and ports as ``face`` has them; ports that go must be free."""
        before, self.face = self.face, face
        self.uid = self.view.uid = face.uid
        self.model.name = face.name
        self.view.name = face.name
        self.model.width, self.model.height = face.width, face.height
        self.model.pos = [face.x, face.y]
        self.view.show_face(face)
        if not _is_moved(before, face):
            self._set_ports(IN, face.inputs)
            self._set_ports(OUT, face.outputs)
        if (self.view.x(), self.view.y()) != (face.x, face.y):
            self.view.setPos(face.x, face.y)

    def _set_ports(self, kind: str, names: tuple[str, ...]) -> None:
        ports = self._inputs if kind == IN else self._outputs
        models = self.model.inputs if kind == IN else self.model.outputs
        kept = {p.name(): p for p in ports}
        for name in [n for n in kept if n not in names]:
            port = kept.pop(name)
            self.view.remove_spot(port.view)
            viewer = self.view.viewer()
            if viewer is not None:
                viewer.bury(port.view)
        for name in names:
            if name not in kept:
                kept[name] = self._port(kind, name)
            kept[name].view.place(*self.face.port(name))
            _hint(kept[name].view, self.face.hint(name) if kind == OUT else "")
        ports[:] = [kept[name] for name in names]
        models.clear()
        models.update((name, kept[name].model) for name in names)

    def _port(self, kind: str, name: str) -> Any:
        port = Port(self, self.view.add_spot(name, kind))
        port.model.type_ = kind
        port.model.name = name
        port.model.multi_connection = kind == IN or self.face.many
        return port

    def port(self, kind: str, name: str) -> Any:
        """The port object, or None."""
        every = self._inputs if kind == IN else self._outputs
        return next((p for p in every if p.name() == name), None)


def _is_moved(before: Any, face: Any) -> bool:
    """Whether a face is what it was, but for its place: all on it stays as it is."""
    return before is not None and replace(before, x=face.x, y=face.y) == face


def _hint(item: QGraphicsItem, said: str) -> None:
    """Tells it where the mouse rests: Qt asks Python each time that an item is told anything."""
    if item.toolTip() != said:
        item.setToolTip(said)
