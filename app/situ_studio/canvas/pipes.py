"""Pipes: routed, labelled and folded as mockups/tokens.md says."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPainterPathStroker, QPen, Qt
from PySide6.QtWidgets import QGraphicsItem, QGraphicsPathItem, QStyleOptionGraphicsItem
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas import untaken
from situ_studio.canvas.chips import STUB, arrow, chip_width, paint_chip
from situ_studio.canvas.library import PipeItem
from situ_studio.canvas.live import LiveView, strength
from situ_studio.canvas.picture import Card
from situ_studio.canvas.pipe_labels import PipeLabel
from situ_studio.canvas.problem_marks import Sign
from situ_studio.canvas.routes import Point, Route
from situ_studio.canvas.style import Look
from situ_studio.wording.language import tr

CORNER = 8.0
UNDER, SIGNED, ABOVE = -1.0, -0.75, -0.5
"""Pipes lie under the cards; those with a sign above the others, the selection's above these."""
SIGN = 16.0
"""How large the sign of a problem is."""
PALE = 0.85
"""Of what nobody went along."""
HIT = 12.0
"""How wide a pipe is for the mouse."""


def rounded(points: tuple[Point, ...], shorten: float = 0.0) -> QPainterPath:
    """The line through ``points`` with rounded corners, its end ``shorten`` early."""
    path = QPainterPath(QPointF(*points[0]))
    for index in range(1, len(points) - 1):
        (ax, ay), (bx, by), (cx, cy) = points[index - 1], points[index], points[index + 1]
        before = abs(bx - ax) + abs(by - ay)
        after = abs(cx - bx) + abs(cy - by)
        if index == len(points) - 2:
            after = max(0.0, after - shorten) * 2
        if index == 1:
            before *= 2
        radius = min(CORNER, before / 2, after / 2)
        path.lineTo(bx - _sign(bx - ax) * radius, by - _sign(by - ay) * radius)
        path.quadTo(bx, by, bx + _sign(cx - bx) * radius, by + _sign(cy - by) * radius)
    (ax, ay), (bx, by) = points[-2], points[-1]
    path.lineTo(bx - _sign(bx - ax) * shorten, by - _sign(by - ay) * shorten)
    return path


def _sign(value: float) -> int:
    return (value > 0) - (value < 0)


def _long(stretch: tuple[Point, Point]) -> float:
    """How long, one across before one down."""
    (ax, ay), (bx, by) = stretch
    return 2 * abs(bx - ax) + abs(by - ay)


def _from_segment(spot: QPointF, a: Point, b: Point) -> float:
    """From a spot to a horizontal or vertical."""
    across = max(min(a[0], b[0]) - spot.x(), spot.x() - max(a[0], b[0]), 0.0)
    down = max(min(a[1], b[1]) - spot.y(), spot.y() - max(a[1], b[1]), 0.0)
    return across + down


class RoutedPipe(PipeItem):
    """One transition. ``link`` is what it stands for; ``set_route`` gives it its way."""

    _input_port: Any
    _output_port: Any

    def __init__(self, look: Look) -> None:
        # Not PipeItem's: it would make a child item for the arrow.
        QGraphicsPathItem.__init__(self)
        self._input_port = None
        self._output_port = None
        self._color = (0, 0, 0, 255)
        self._style = 0
        self._active = self._highlight = False
        self.look = look
        self.link: Any = None
        self.route = Route()
        self.hovered = False
        self._label: PipeLabel | None = None
        self._shown: tuple[Any, ...] = ()
        self._rect = QRectF()
        self._hit: QPainterPath | None = None
        self._way: QPainterPath | None = None
        self._gap: QPainterPath | None = None
        self._chip = ""
        self._wrong: tuple[Sign, Any] | None = None
        # Without a way it lies in the drawing's corner: Qt would paint it there at each frame.
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemHasNoContents, True)
        self.setZValue(UNDER)
        self.setAcceptHoverEvents(True)
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemIsSelectable, True)
        self.setCacheMode(QGraphicsItem.CacheMode.NoCache)

    # -- what the graph calls ------------------------------------------------------

    def set_route(self, route: Route, said: str, pill: bool, chip: str) -> None:
        """said: the label's words. chip: the target's number, for a folded pipe."""
        if (route, said, pill, chip) == self._shown:
            return
        self.prepareGeometryChange()
        self._shown = route, said, pill, chip
        self.route, self._chip = route, chip
        self._label = PipeLabel(route, said, pill) if route.label is not None else None
        self._hit = self._way = self._gap = None
        if route.folded:
            x, y = self.output_port.centre().toTuple()
            area = QRectF(x, y - 10, STUB + chip_width(chip) + SIGN + 6, 20)
        elif len(route.points) < 2:
            area = QRectF()
        else:
            xs, ys = [p[0] for p in route.points], [p[1] for p in route.points]
            left, top = min(xs) - SIGN, min(ys) - SIGN
            area = QRectF(left, top, max(xs) + SIGN - left, max(ys) + SIGN - top)
            if self._label is not None:
                area = area.united(self._label.reach().adjusted(-2 * SIGN, -SIGN, 2, SIGN))
            reach = untaken.REACH - SIGN
            area.adjust(-reach, -reach, reach, reach)
        self._rect = area
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemHasNoContents, area.isEmpty())
        self.refresh()

    def path(self) -> QPainterPath:
        """The line, made when it is first painted or hit."""
        if self._way is None:
            points = self.route.points
            self._way = QPainterPath()
            if len(points) > 1:
                self._way = rounded(points, 5.0 if self.route.trunk is None else 0.0)
        return self._way

    def _gapped(self) -> QPainterPath:
        """The line as it is painted round its name, which stands on whatever lies there."""
        if self._gap is None:
            assert self._label is not None
            self._gap = QPainterPath()
            for part in self._label.leave_free(self.route.points):
                ends = part[-1] == self.route.points[-1] and self.route.trunk is None
                self._gap.addPath(rounded(part, 5.0 if ends else 0.0))
        return self._gap

    def shape(self) -> QPainterPath:
        if self.route.folded and self.look.level != "full":
            # Chips are not shown where cards are small.
            return QPainterPath()
        if self._hit is None:
            self._hit = self._make_shape()
        area = self.sign_area()
        if area.isEmpty():
            return self._hit
        # At each zoom it is elsewhere, or as large as another.
        both = QPainterPath(self._hit)
        both.addRect(area)
        return both

    def _make_shape(self) -> QPainterPath:
        route, hit = self.route, QPainterPath()
        if route.folded:
            if route.trunk is None:
                x, y = self.output_port.centre().toTuple()
                hit.addRect(QRectF(x + 5, y - 8, STUB - 4 + chip_width(self._chip), 16))
            return hit
        if len(route.points) < 2:
            return hit
        stroker = QPainterPathStroker()
        stroker.setWidth(HIT)
        stroker.setCapStyle(Qt.PenCapStyle.FlatCap)
        hit = stroker.createStroke(self.path())
        if self._label is not None:
            hit.addRect(self._label.area)
        return hit

    def _is_signed(self) -> bool:
        """Whether something is wrong with the transitions drawn here and no other pipe tells it."""
        return self.wrong() is not None and self.route.trunk is None

    def sign_area(self) -> QRectF:
        """Where the sign is of what is wrong with the transitions drawn here, in the scene: before
        their name, else in the middle of the longest stretch, or behind the chip; empty where
        nothing is wrong, for a pipe that joins another, and in small drawings, which leave it.
        """
        route, side = self.route, SIGN * max(1.0, 0.8 / self.look.zoom)
        if not self._is_signed() or self.look.level in ("quarter", "tiny"):
            return QRectF()
        if route.folded:
            x, y = self.output_port.centre().toTuple()
            centre = QPointF(x + STUB + chip_width(self._chip) + SIGN / 2 + 2, y)
        elif self._label is not None and self._label.is_shown(self.look):
            area = self._label.area
            centre = QPointF(area.left() - side / 2, area.center().y())
        elif len(route.points) > 1:
            (ax, ay), (bx, by) = max(pairwise(route.points), key=_long)
            centre = QPointF((ax + bx) / 2, (ay + by) / 2)
        else:
            return QRectF()
        return QRectF(centre.x() - side / 2, centre.y() - side / 2, side, side)

    def wrong(self) -> Any:
        """Of the transitions drawn here the link of the one with the worst problem; None where
        there is none.
        """
        if self._wrong is None:
            signs: dict[Sign, Any] = {}
            for pipe in (self, *self._siblings()) if self._output_port is not None else ():
                source = pipe.output_port.node.face
                if isinstance(source, Card) and pipe.link is not None:
                    leaving = source.exit(pipe.link.exit)
                    if leaving is not None:
                        signs.setdefault(leaving.mark.sign, pipe.link)
            worst: Sign = "error" if "error" in signs else "warning"
            self._wrong = worst, signs.get(worst)
        return self._wrong[1]

    def update_sign(self) -> None:
        """What is wrong with the transition may be other than before."""
        self._wrong = None
        self.refresh()

    def untaken_area(self) -> QRectF:
        """Where it stands on the line that nobody went along it, in the scene; else empty."""
        route = self.route
        if route.folded or route.trunk is not None or len(route.points) < 2 or self._count() != 0:
            return QRectF()
        if self._label is not None:
            return self._label.area
        (ax, ay), (bx, by) = max(pairwise(route.points), key=_long)
        return QRectF((ax + bx) / 2 - 13, (ay + by) / 2 - 8, 26, 16)

    def untaken_at_exit(self) -> QPointF | None:
        """Where it stands beside the exit, from there to the right, in the scene: behind the chip
        of a folded one, and where the line is another exit's too that was taken; else None.
        """
        if self._own_count() != 0 or self.look.level != "full":
            return None
        x, y = self.output_port.centre().toTuple()
        if self.route.folded:
            chip = STUB + chip_width(self._chip) + 2
            return QPointF(x + chip + (0 if self.sign_area().isEmpty() else SIGN), y)
        return QPointF(x + 16, y) if self._count() else None

    def label_area(self) -> QRectF | None:
        """Where the label is painted at 100 %, in the scene; None without one."""
        return self._label.area if self._label is not None else None

    def distance(self, spot: QPointF) -> float:
        """How far a spot is from the line, 0 on its label or chip: who is meant of several."""
        points = self.route.points
        on_label = self._label is not None and self._label.area.contains(spot)
        if on_label or self.sign_area().contains(spot):
            return 0.0
        return min((_from_segment(spot, a, b) for a, b in pairwise(points)), default=0.0)

    def refresh(self) -> None:
        """Painted anew, above the others where it belongs to the selection."""
        rest = SIGNED if self._is_signed() else UNDER
        self.setZValue(ABOVE if self.selected() or self.hovered else rest)
        self.update()

    def selected(self) -> bool:
        if self.isSelected():
            return True
        if self._input_port is None or self._output_port is None:
            return False
        return bool(self._input_port.node.isSelected() or self._output_port.node.isSelected())

    # -- painting -------------------------------------------------------------------

    def boundingRect(self) -> QRectF:
        return self._rect

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        look = self.look
        self._paint_way(painter)
        if isinstance(look.live, LiveView):
            zero = self.untaken_area()
            # A label has its count already.
            if not zero.isEmpty() and zero != self.label_area():
                untaken.paint_sign(painter, look, zero.center().x(), zero.center().y())
        if self.wrong() is not None:
            self._paint_sign(painter)

    def _paint_sign(self, painter: QPainter) -> None:
        look, area = self.look, self.sign_area()
        if area.isEmpty() or self._wrong is None or (self.route.folded and look.level != "full"):
            return
        token, side = self._wrong[0], area.width()
        painter.setPen(QPen(look[token], max(1.0, 1 / look.zoom)))
        painter.setBrush(look["panel"])
        painter.drawEllipse(area)
        x, y = area.topLeft().toTuple()
        look.icon(painter, token, x + side * 0.14, y + side * 0.12, side * 0.72, look[token])

    def _paint_way(self, painter: QPainter) -> None:
        look, route = self.look, self.route
        selected = self.selected()
        strong = selected or self.hovered
        color = look["accent"] if strong else look["pipe"]
        if route.folded:
            if route.trunk is None and look.level == "full":
                x, y = self.output_port.centre().toTuple()
                paint_chip(painter, look, x, y, self._chip, "accent" if strong else "pipe")
            elif route.trunk is not None and look.level == "full":
                self._paint_folded_join(painter, color)
            return
        if len(route.points) < 2:
            return
        # Small drawings keep lines and arrows that can be seen.
        width = max(2.0 if selected else 1.6, 1.2 / look.zoom)
        taken, count = self._taken(), self._count()
        named = self._label is not None and count is None and look.level == "full"
        path = self._gapped() if named else self.path()
        painter.setBrush(Qt.BrushStyle.NoBrush)
        # Whether nobody came along the line that is drawn here.
        never = (count if route.trunk is None else self._own_count()) == 0
        if never and not strong:
            color = look.faint("pipe", PALE)
        pen = untaken.pen(look, color, width, path.length()) if never else QPen(color, width)
        if not never and self.link is not None and self.link.exit == "timeout":
            unit = max(1.0, 1 / look.zoom) / width
            pen.setDashPattern([4 * unit, 3 * unit])
        painter.setPen(pen)
        painter.drawPath(path)
        if taken:
            color = look["live"]
            painter.setOpacity(taken)
            painter.setPen(QPen(look.faint("live", 0.22), 7))
            painter.drawPath(path)
            painter.setPen(QPen(color, max(2.75, width)))
            painter.drawPath(path)
        if route.trunk is None:
            (ax, ay), (bx, by) = route.points[-2], route.points[-1]
            upwards = ax == bx and by < ay
            if never:
                untaken.paint_tip(painter, look, color, QPointF(bx, by), upwards)
            else:
                arrow(painter, color, bx, by, upwards, 1.0 if look.level == "full" else 1.5)
        if route.joint is not None:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(color)
            painter.drawEllipse(QPointF(*route.joint), 3.25, 3.25)
        painter.setOpacity(1.0)
        if self._label is None:
            return
        if count is not None:
            self._label.paint_count(painter, look, count, bool(taken))
        else:
            ink = color if strong or taken else look["text2"]
            self._label.paint(painter, look, ink, selected, self.hovered)

    def _paint_folded_join(self, painter: QPainter, color: QColor) -> None:
        """To the chip of the exit above that leads to the same card."""
        x, y = self.output_port.centre().toTuple()
        other = next((p for p in self._siblings() if p.route.trunk is None), None)
        painter.setPen(QPen(color, 1.6))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if other is None:
            return
        height = other.output_port.centre().y()
        side = 8 if height < y else -8
        middle = x + STUB + chip_width(self._chip) / 2
        points = ((x + 4, y), (middle, y), (middle, height + side))
        painter.drawPath(rounded(points))

    def _siblings(self) -> list[RoutedPipe]:
        return [
            p
            for spot in self.output_port.node.outputs
            for p in spot.connected_pipes
            if p is not self and p.input_port is self.input_port
        ]

    def _taken(self) -> float:
        live, link = self.look.live, self.link
        if not isinstance(live, LiveView) or link is None:
            return 0.0
        for rank, taken in enumerate(live.taken):
            if taken.state == link.source and taken.exit == link.exit:
                return strength(rank, taken.age)
        return 0.0

    def _own_count(self) -> int | None:
        """How often this exit's own way was taken; None where nobody has counted."""
        live, link = self.look.live, self.link
        if not isinstance(live, LiveView) or link is None:
            return None
        return live.transitions.get((link.source, link.exit))

    def _count(self) -> int | None:
        """How often; None where nobody has counted: 0 is what somebody looks for."""
        live, link = self.look.live, self.link
        if not isinstance(live, LiveView) or link is None:
            return None
        every = [link, *(p.link for p in self._siblings() if p.link is not None)]
        known = [live.transitions.get((one.source, one.exit)) for one in every]
        found = [count for count in known if count is not None]
        return sum(found) if found else None

    # -- what NodeGraphQt calls ------------------------------------------------------

    def itemChange(self, change: QGraphicsItem.GraphicsItemChange, value: Any) -> Any:
        if change == QGraphicsItem.GraphicsItemChange.ItemSelectedHasChanged:
            self.refresh()
        return QGraphicsItem.itemChange(self, change, value)

    def hoverEnterEvent(self, event: Any) -> None:
        self.hovered = True
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setToolTip(self._hint())
        self.refresh()

    def hoverLeaveEvent(self, event: Any) -> None:
        self.hovered = False
        self.unsetCursor()
        self.refresh()

    def _hint(self) -> str:
        """The whole of what the pipe stands for."""
        source, target = self._output_port.node.face, self._input_port.node.face
        goal = tr("leads to {0}").format(target.hint().splitlines()[0])
        lines = [source.hint(self._output_port.name), goal]
        wrong = self.wrong()
        if wrong is not None and wrong is not self.link:
            lines.append(source.hint(wrong.exit))
        if self.route.folded:
            lines.append(tr("Click to go there, Alt and click to draw the way"))
        return "\n".join(lines)

    def draw_path(self, start_port: Any, end_port: Any = None, cursor_pos: Any = None) -> None:
        """Routes come from the router, all together."""

    def port_from_pos(self, pos: Any, reverse: bool = False) -> Any:
        """A pipe that is dragged away hangs on its exit: the end with the arrow moves."""
        return self._output_port if reverse else self._input_port

    def activate(self) -> None:
        return

    def highlight(self) -> None:
        return

    def reset(self) -> None:
        return

    def delete(self) -> None:
        viewer = self.viewer()
        for port in (self._input_port, self._output_port):
            if port is not None:
                if self in port.connected_pipes:
                    port.remove_pipe(self)
                if viewer is not None and port.node is not None:
                    viewer.touched.add(port.node.uid)
        if viewer is not None:
            viewer.bury(self)
            viewer.release_pipe(self)
