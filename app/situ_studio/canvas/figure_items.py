"""Notes and frames on the canvas: painted at every level of detail, resized at their edges."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QTextLayout
from PySide6.QtWidgets import QGraphicsItem, QGraphicsSceneMouseEvent, QStyleOptionGraphicsItem
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas.figures import KINDS_OF, LEAST, USUAL, Figure
from situ_studio.canvas.ground import ZOOM_LEAST
from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.style import Label, Look, metrics, sized

EDGE = 6.0
"""Px on screen on either side of an edge at which it is taken hold of."""
TITLE = 28.0
"""The height of a frame's title, at which it is dragged."""
FAR_TITLE = 120.0
"""Px on screen that a frame's title may take where the frame itself is smaller."""
FOLD = 12.0
LINE = 1.35
"""From one line of a note to the next, in heights of its letters."""
UNDER = -2.0
"""Frames lie under pipes and cards."""
CURSORS = {
    "l": Qt.CursorShape.SizeHorCursor,
    "r": Qt.CursorShape.SizeHorCursor,
    "t": Qt.CursorShape.SizeVerCursor,
    "b": Qt.CursorShape.SizeVerCursor,
    "lt": Qt.CursorShape.SizeFDiagCursor,
    "rb": Qt.CursorShape.SizeFDiagCursor,
    "rt": Qt.CursorShape.SizeBDiagCursor,
    "lb": Qt.CursorShape.SizeBDiagCursor,
}


class FigureItem(NodeFace):
    """What notes and frames have in common. wanted: the area that a hand drags it to, in the
    scene; None while none does."""

    face: Figure

    def __init__(self, name: str = "figure", parent: QGraphicsItem | None = None) -> None:
        super().__init__(name, parent)
        self.wanted: QRectF | None = None
        self._grip: tuple[str, QPointF, QRectF] | None = None

    def show_face(self, face: Figure) -> None:
        self.wanted = None
        super().show_face(face)

    def forget_wanted(self) -> None:
        """What was dragged does not count."""
        if self.wanted is not None:
            self.prepareGeometryChange()
            self.wanted = None
            self.update()

    def room(self, face: Figure) -> QRectF:
        return QRectF(-12, -12, face.width + 24, face.height + 24)

    def boundingRect(self) -> QRectF:
        return self.area().adjusted(-12, -12, 12, 12) if self.wanted is not None else self._rect

    def area(self) -> QRectF:
        """What it takes now, from its corner."""
        if self.wanted is not None:
            return self.wanted.translated(-self.pos())
        return QRectF(0, 0, self.face.width, self.face.height)

    def ink(self, look: Look) -> tuple[QColor, QColor]:
        """The colour of lines and titles, and that of the ground."""
        color = self.face.color.casefold()
        kind = KINDS_OF.get(color) if color else USUAL[self.face.kind]
        if kind is not None:
            return look[kind], look[f"{kind}_soft"]
        own = QColor(color) if QColor.isValidColorName(color) else look["state"]
        soft = QColor(own)
        soft.setAlphaF(0.14)
        return own, soft

    # -- edges ------------------------------------------------------------------------

    def edges_at(self, spot: QPointF) -> str:
        """Which edges a press at ``spot`` takes hold of, as ``lt`` for the upper left corner."""
        zoom = self.look.zoom if self.look is not None else 1.0
        near, area = EDGE / max(zoom, 0.01), self.area()
        across = "l" if abs(spot.x() - area.left()) <= near else ""
        across = "r" if abs(spot.x() - area.right()) <= near else across
        down = "t" if abs(spot.y() - area.top()) <= near else ""
        down = "b" if abs(spot.y() - area.bottom()) <= near else down
        return across + down

    def hoverMoveEvent(self, event: Any) -> None:
        edges = self.edges_at(event.pos())
        self.setCursor(CURSORS.get(edges, Qt.CursorShape.ArrowCursor))

    def hoverLeaveEvent(self, event: Any) -> None:
        self.unsetCursor()
        super().hoverLeaveEvent(event)

    def mousePressEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        viewer = self.viewer()
        edges = self.edges_at(event.pos())
        plain = event.modifiers() == Qt.KeyboardModifier.NoModifier
        if edges and plain and viewer is not None and not viewer.takes_press():
            self._grip = edges, event.scenePos(), self.area().translated(self.pos())
            if not self.isSelected():
                self.scene().clearSelection()
                self.setSelected(True)
            event.accept()
            return
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        if self._grip is None:
            super().mouseMoveEvent(event)
            return
        edges, begun, area = self._grip
        way = event.scenePos() - begun
        least_width, least_height = LEAST[self.face.kind]
        wanted = QRectF(area)
        if "l" in edges:
            wanted.setLeft(min(area.left() + way.x(), area.right() - least_width))
        if "r" in edges:
            wanted.setRight(max(area.right() + way.x(), area.left() + least_width))
        if "t" in edges:
            wanted.setTop(min(area.top() + way.y(), area.bottom() - least_height))
        if "b" in edges:
            wanted.setBottom(max(area.bottom() + way.y(), area.top() + least_height))
        self.prepareGeometryChange()
        self.wanted = wanted
        viewer = self.viewer()
        if viewer is not None:
            viewer.touched.add(self.uid)
        self.update()

    def mouseReleaseEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        if self._grip is None:
            super().mouseReleaseEvent(event)
            return
        self._grip = None
        event.accept()

    def itemChange(self, change: QGraphicsItem.GraphicsItemChange, value: Any) -> Any:
        if change == QGraphicsItem.GraphicsItemChange.ItemSceneChange:
            self._grip = None
        return super().itemChange(change, value)

    def _paint_ring(self, painter: QPainter, look: Look, area: QRectF, radius: float) -> None:
        """The ring of what is selected, and handles at the corners."""
        if not self.isSelected():
            return
        one = 1 / look.zoom
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(look.faint("accent", 0.22), 4 * one))
        painter.drawRoundedRect(area.adjusted(-3 * one, -3 * one, 3 * one, 3 * one), radius, radius)
        painter.setPen(QPen(look["accent"], 2 * one))
        painter.drawRoundedRect(area, radius, radius)
        painter.setBrush(look["card"])
        painter.setPen(QPen(look["accent"], 1.5 * one))
        side = 7 * one
        for corner in (area.topLeft(), area.topRight(), area.bottomLeft(), area.bottomRight()):
            painter.drawRect(QRectF(corner.x() - side / 2, corner.y() - side / 2, side, side))


class FrameItem(FigureItem):
    """A frame: only its title and its edges are hit, what lies in it is as free as elsewhere."""

    def __init__(self, name: str = "frame", parent: QGraphicsItem | None = None) -> None:
        super().__init__(name, parent)
        self.setZValue(UNDER)

    def boundingRect(self) -> QRectF:
        # With the title, which stands above where the zoom is small.
        wide = max(0.0, FAR_TITLE / ZOOM_LEAST - self._rect.width())
        return super().boundingRect().adjusted(0, -16 / ZOOM_LEAST, wide, 0)

    def shape(self) -> QPainterPath:
        zoom = self.look.zoom if self.look is not None else 1.0
        near, area = EDGE / max(zoom, 0.01), self.area()
        title = min(area.height(), max(TITLE, 18 / max(zoom, 0.01)))
        path = QPainterPath()
        path.setFillRule(Qt.FillRule.OddEvenFill)
        path.addRect(area.adjusted(-near, -near, near, near))
        inner = QRectF(
            area.left() + near,
            area.top() + title,
            area.width() - 2 * near,
            area.height() - title - near,
        )
        if inner.isValid():
            path.addRect(inner)
        return path

    def itemChange(self, change: QGraphicsItem.GraphicsItemChange, value: Any) -> Any:
        found = super().itemChange(change, value)
        if change == QGraphicsItem.GraphicsItemChange.ItemSelectedHasChanged:
            self.setZValue(UNDER)
        return found

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        look = self.look
        assert look is not None
        area, one = self.area(), 1 / look.zoom
        line, ground = self.ink(look)
        painter.setBrush(ground)
        edge = QColor(line)
        edge.setAlphaF(0.45)
        painter.setPen(QPen(edge, one))
        radius = 12.0 if look.level in ("full", "half") else 4 * one
        painter.drawRoundedRect(area, radius, radius)
        self._paint_ring(painter, look, area, radius)
        if not self.face.text:
            return
        # Never smaller than 11 px on the screen.
        pixels = max(13, int(11.5 * one))
        painter.setFont(sized(pixels, 600))
        painter.setPen(line)
        height = max(24.0, pixels * 1.2)
        if look.level in ("full", "half"):
            room = QRectF(area.left() + 12, area.top() + 2, max(0.0, area.width() - 24), height)
        else:
            # Cards fill the frame: the title stands above it, and may be wider.
            wide = max(area.width(), FAR_TITLE * one)
            room = QRectF(area.left(), area.top() - height, wide, height)
        said = painter.fontMetrics().elidedText(
            self.face.text, Qt.TextElideMode.ElideRight, int(room.width())
        )
        flags = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        painter.drawText(room, flags, said)


class NoteItem(FigureItem):
    """A note: a sheet of paper with its lower right corner turned up."""

    def __init__(self, name: str = "note", parent: QGraphicsItem | None = None) -> None:
        super().__init__(name, parent)
        self._laid: tuple[tuple[object, ...], list[Label]] | None = None

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        look = self.look
        assert look is not None
        area, one = self.area(), 1 / look.zoom
        line, ground = self.ink(look)
        if look.level == "tiny":
            edge = QColor(line)
            edge.setAlphaF(0.4)
            painter.fillRect(area, look["accent"] if self.isSelected() else edge)
            return
        edge = QColor(line)
        edge.setAlphaF(0.45)
        right, bottom = area.right(), area.bottom()
        sheet = QPainterPath(area.topLeft())
        sheet.lineTo(area.topRight())
        sheet.lineTo(right, bottom - FOLD)
        sheet.lineTo(right - FOLD, bottom)
        sheet.lineTo(area.left(), bottom)
        sheet.closeSubpath()
        painter.setPen(QPen(edge, one))
        painter.setBrush(ground)
        painter.drawPath(sheet)
        corner = QPainterPath(QPointF(right, bottom - FOLD))
        corner.lineTo(right - FOLD, bottom - FOLD)
        corner.lineTo(right - FOLD, bottom)
        painter.setBrush(look["card"])
        painter.drawPath(corner)
        self._paint_ring(painter, look, area, 2)
        if look.level == "quarter":
            return
        pixels = 12 if look.level == "full" else max(12, int(11 * one))
        room = area.adjusted(8, 6, -8, -5)
        key = (self.face, pixels, room.width(), room.height())
        if self._laid is None or self._laid[0] != key:
            said = broken(self.face.text, pixels, room.width(), room.height())
            self._laid = key, [Label(line, pixels, 400) for line in said]
        for index, label in enumerate(self._laid[1]):
            y = room.top() + pixels * (1.0 + LINE * index)
            label.draw(painter, room.left(), y, look["text"])


def broken(text: str, pixels: int, width: float, height: float) -> list[str]:
    """A text in lines no wider than ``width``, as many as ``height`` has room for; … for more."""
    measured = metrics(pixels, 400)
    lines: list[str] = []
    for paragraph in text.split("\n"):
        layout = QTextLayout(paragraph, sized(pixels, 400))
        layout.beginLayout()
        while (line := layout.createLine()).isValid():
            line.setLineWidth(max(1.0, width))
            begin = line.textStart()
            lines.append(paragraph[begin : begin + line.textLength()].rstrip())
        layout.endLayout()
    most = max(1, int((height + (LINE - 1.2) * pixels) / (LINE * pixels)))
    if len(lines) > most:
        rest = " ".join(lines[most - 1 : most + 1]) + "…"
        lines[most - 1 :] = [measured.elidedText(rest, Qt.TextElideMode.ElideRight, width)]
    return lines
