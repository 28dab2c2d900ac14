"""Pipes of a script: cubic, with the priority in a pill; and the paler ones that are taken over."""

from __future__ import annotations

import math
from functools import lru_cache
from itertools import pairwise

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPainterPath, QPainterPathStroker, QPen, Qt
from PySide6.QtWidgets import (
    QGraphicsItem,
    QGraphicsPathItem,
    QGraphicsSceneMouseEvent,
    QStyleOptionGraphicsItem,
)
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas.chips import arrow
from situ_studio.canvas.live import LiveScript
from situ_studio.canvas.pipe_labels import LEAST, PIXELS
from situ_studio.canvas.pipes import ABOVE, HIT, UNDER, RoutedPipe
from situ_studio.canvas.routes import Route
from situ_studio.canvas.script_faces import Inherited, ScriptLink
from situ_studio.canvas.style import Label, Look
from situ_studio.wording.language import tr

PILL = 18.0
FAR_SIGN = 16.0
"""Px on screen that the sign of a problem keeps in the smallest drawings."""
DOT = 2.5
BELOW = UNDER - 0.25
"""Where lies what strikes no number: below all pipes."""
REACH = 0.45
"""How much wider and higher a pill can be painted at each side, as a part of its own size."""


def curve(start: QPointF, end: QPointF) -> QPainterPath:
    """A cubic with half the gap as handle; its end leaves room for the arrow."""
    half = (end.x() - start.x()) / 2
    tip = end - QPointF(5, 0)
    path = QPainterPath(start)
    path.cubicTo(start + QPointF(half, 0), QPointF(end.x() - half, end.y()), tip)
    return path


@lru_cache(maxsize=8192)
def along(across: float, down: float, part: float) -> tuple[float, float]:
    """Where a part of the length of such a curve ends, from its start: Qt measures it each time."""
    at = curve(QPointF(0, 0), QPointF(across, down)).pointAtPercent(part)
    return at.x(), at.y()


def pill_area(centre: QPointF, text: Label, mark: bool) -> QRectF:
    wide = max(30.0, text.width + 16 + (18 if mark else 0))
    return QRectF(centre.x() - wide / 2, centre.y() - PILL / 2, wide, PILL)


def _off(spot: QPointF, a: QPointF, b: QPointF) -> float:
    """How far a spot is from the line between two others."""
    way, to = b - a, spot - a
    long = QPointF.dotProduct(way, way)
    part = max(0.0, min(1.0, QPointF.dotProduct(to, way) / long)) if long else 0.0
    rest = to - way * part
    return math.hypot(rest.x(), rest.y())


class CurvedPipe(RoutedPipe):
    """A pipe of a script; ``link`` is a ScriptLink. part: where along it the pill sits."""

    link: ScriptLink

    def __init__(self, look: Look) -> None:
        super().__init__(look)
        self._part = 0.5
        self._pill = QRectF()
        self._pill_text: Label | None = None
        self._stroke = QPainterPath()

    def set_curve(self, start: QPointF, end: QPointF) -> None:
        """Gives it its way; the priority stands in the middle of it."""
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemHasNoContents, False)
        link = self.link
        self._pill_text = None
        if link.kind == "priority":
            said = tr("none") if link.priority is None else str(link.priority)
            self._pill_text = Label(said, PIXELS, 600)
        self.route = Route(points=((start.x(), start.y()), (end.x(), end.y())))
        way = self._way = curve(start, end)
        stroker = QPainterPathStroker()
        stroker.setWidth(HIT)
        self._stroke = stroker.createStroke(way)
        self._put_pill(0.5)

    def _put_pill(self, part: float) -> None:
        self.prepareGeometryChange()
        self._part, self._pill = part, self._pill_at(part)
        self._hit = self._stroke
        self._rect = self.path().boundingRect().adjusted(-8, -8, 8, 8)
        if self._pill_text is not None:
            self._hit = QPainterPath(self._stroke)
            self._hit.addRect(self._pill)
            more_x, more_y = self._pill.width() * REACH, max(self._pill.height() * REACH, 44.0)
            self._rect = self._rect.united(
                self._pill.adjusted(-more_x - 3, -more_y, more_x + 3, more_y)
            )
        self.update()

    def pill(self, part: float | None = None) -> QRectF:
        """Where the priority stands, in the scene, or would stand; empty for pipes without."""
        return QRectF(self._pill) if part is None else self._pill_at(part)

    def _pill_at(self, part: float) -> QRectF:
        if self._pill_text is None:
            return QRectF()
        (left, top), (right, bottom) = self.route.points
        across, down = along(right - left, bottom - top, part)
        at = QPointF(left + across, top + down)
        return pill_area(at, self._pill_text, bool(self.link.mark))

    def move_pill(self, part: float) -> None:
        """Puts the priority elsewhere on the pipe."""
        if part != self._part:
            self._put_pill(part)

    def distance(self, spot: QPointF) -> float:
        if self.pill().contains(spot):
            return 0.0
        points = [p for shape in self.path().toSubpathPolygons() for p in shape.toList()]
        return min((_off(spot, a, b) for a, b in pairwise(points)), default=0.0)

    def selected(self) -> bool:
        if self.isSelected():
            return True
        if self._input_port is None or self._output_port is None:
            return False
        source, target = self._output_port.node, self._input_port.node
        if source.isSelected() or target.isSelected():
            return True
        return bool(self.chosen)

    def wrong(self) -> ScriptLink | None:
        return self.link if self.link.mark else None

    def sign_area(self) -> QRectF:
        """In the pill, behind the number."""
        box = self.pill()
        if self._pill_text is None or not self.link.mark:
            return QRectF()
        return QRectF(box.right() - 22, box.top(), 22, box.height())

    def _hint(self) -> str:
        return "\n".join((self._told(), *self.link.wrong.told()))

    def _told(self) -> str:
        link = self.link
        source, target = self._output_port.node.face, self._input_port.node.face
        if link.kind == "priority":
            if link.none:
                told = tr("{0} takes away what it took over for {1}")
                return told.format(source.name, target.name)
            told = tr("{0} has priority {1} in {2}")
            return told.format(target.name, link.priority, source.name)
        if link.kind == "observes":
            row = next((r for r in target.rows if r.path == link.entry), None)
            return f"{row.tag} {row.text}" if row is not None else ""
        if link.kind == "uses":
            return tr("{0} uses {1}").format(source.name, target.name)
        return str(source.hint())

    roomy = True
    """Whether its priority has room to be enlarged in a small drawing."""
    chosen = False
    """On the way to the selected situation, or on from it, without touching it."""

    def _live(self) -> bool:
        live, link = self.look.live, self.link
        if not isinstance(live, LiveScript):
            return False
        source, target = self._output_port.node.face, self._input_port.node.face
        match link.kind:
            case "uses":
                return bool(live.authority.get(target.name) == source.name)
            case "priority":
                current = live.situation == source.name
                return current and target.name in live.authority.values()
            case "holds":
                return bool(target.name in live.holds)
        return False

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        look, link = self.look, self.link
        if len(self.route.points) < 2:
            return
        strong, live = self.selected() or self.hovered, self._live()
        color = look["live"] if live else look["accent"] if strong else look["pipe"]
        thin = link.kind == "uses" and not (strong or live)
        width = 2.75 if live else 2.0 if strong else 1.3 if thin else 1.6
        painter.setOpacity(0.8 if thin else 1.0)
        pen = QPen(color, width)
        if link.none:
            pen.setDashPattern([2, 3])
        painter.setPen(pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(self.path())
        x, y = self.route.points[-1]
        arrow(painter, color, x, y)
        painter.setOpacity(1.0)
        if self._pill_text is None:
            return
        painted = self.painted_pill()
        if painted.isEmpty():
            self._paint_far(painter)
            return
        box = self.pill()
        if look.level == "half":
            scale = painted.width() / (box.width() - 6)
            box = box.adjusted(3, 2, -3, -2)
            painter.translate(box.center())
            painter.scale(scale, scale)
            painter.translate(-box.center())
        if link.mark:
            painter.setPen(QPen(look[link.mark], 1.25))
            painter.setBrush(look[f"{link.mark}_soft"])
            ink = look[link.mark]
        else:
            ink = look["live"] if live else look["accent"] if strong else look["module"]
            if link.none:
                ink = look["text3"]
            painter.setPen(QPen(ink, 1.25))
            painter.setBrush(look["panel"])
        painter.drawRoundedRect(box, PILL / 2, PILL / 2)
        centre = box.center()
        if link.mark:
            self._pill_text.draw_middle(painter, centre.x() - 9, centre.y() + 4.5, ink)
            look.icon(painter, link.mark, box.right() - 20, centre.y() - 7, 14, ink)
        else:
            self._pill_text.draw_middle(painter, centre.x(), centre.y() + 4.5, ink)

    def painted_pill(self) -> QRectF:
        """The pill as it is painted at this zoom, in the scene: its number can be read; empty where
        it has no room for that, and where cards are too small.
        """
        look, box = self.look, self.pill()
        if look.level == "full":
            return box
        if look.level != "half" or not (self.roomy or self.selected() or self.hovered):
            return QRectF()
        # Enlarged as a whole, it would reach the pills above and below.
        scale = max(1.0, LEAST / PIXELS / look.zoom)
        made = QRectF(0, 0, (box.width() - 6) * scale, (box.height() - 4) * scale)
        made.moveCenter(box.center())
        return made

    def _paint_far(self, painter: QPainter) -> None:
        """Where a number has no room to be read: that there is one, and what is wrong with it."""
        look, mark = self.look, self.link.mark
        if not mark and look.level == "half":
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(look["module"])
            painter.drawEllipse(self.pill().center(), DOT / look.zoom, DOT / look.zoom)
        elif mark and look.level != "tiny":
            side = FAR_SIGN / look.zoom
            area = QRectF(0, 0, side, side)
            area.moveCenter(self.pill().center())
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(look["panel"])
            painter.drawEllipse(area)
            look.icon(painter, mark, area.left(), area.top(), side, look[mark])


class InheritedWay(QGraphicsPathItem):
    """The line of a priority that is taken over: under all pipes, so that it strikes no number."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._end = QPointF()
        self.setAcceptedMouseButtons(Qt.MouseButton.NoButton)
        self.setZValue(BELOW)

    def set_curve(self, start: QPointF, end: QPointF) -> None:
        self.prepareGeometryChange()
        self._end = end
        self.setPath(curve(start, end))

    def boundingRect(self) -> QRectF:
        return self.path().boundingRect().adjusted(-8, -8, 8, 8)

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        painter.setOpacity(0.65)
        pen = QPen(self._look["accent"], 1.5)
        pen.setDashPattern([4 / 1.5, 4 / 1.5])
        painter.setPen(pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(self.path())
        arrow(painter, self._look["accent"], self._end.x(), self._end.y())


class InheritedPipe(QGraphicsItem):
    """A priority that the selected situation takes over: pale and dashed, not in the document.
    way: its line, which lies deeper than its number."""

    def __init__(self, look: Look, value: Inherited) -> None:
        super().__init__()
        self.look = look
        self.value = value
        self.way = InheritedWay(look)
        self._text = Label(str(value.priority), 11, 500)
        self._pill = QRectF()
        # Its pill is pressed, not a pipe that passes below.
        self.setZValue(ABOVE)

    def set_curve(self, start: QPointF, end: QPointF, part: float) -> None:
        self.prepareGeometryChange()
        self.way.set_curve(start, end)
        self._pill = pill_area(self.way.path().pointAtPercent(part), self._text, False)

    def pill(self) -> QRectF:
        return QRectF(self._pill)

    def boundingRect(self) -> QRectF:
        more_x, more_y = self._pill.width() * REACH, self._pill.height() * REACH
        return self._pill.adjusted(-more_x - 3, -more_y - 3, more_x + 3, more_y + 3)

    def shape(self) -> QPainterPath:
        path = QPainterPath()
        path.addRect(self.pill())
        return path

    def mousePressEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        # The situation that it belongs to stays selected.
        event.accept()

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        look = self.look
        if look.level in ("quarter", "tiny"):
            return
        box = self.pill()
        if look.level != "full":
            scale = max(1.0, LEAST / PIXELS / look.zoom)
            painter.translate(box.center())
            painter.scale(scale, scale)
            painter.translate(-box.center())
        pen = QPen(look["pipe"], 1)
        pen.setDashPattern([3, 2])
        painter.setPen(pen)
        painter.setBrush(look["canvas"])
        painter.drawRoundedRect(box, PILL / 2, PILL / 2)
        self._text.draw_middle(painter, box.center().x(), box.center().y() + 4, look["text2"])
