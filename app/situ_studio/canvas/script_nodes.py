"""Nodes of a script: a strip in the kind's colour, a name, a detail; measures of tokens.md."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPainterPath, QPen, Qt
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas.live import LiveScript
from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.script_projection import OUT, ScriptNode
from situ_studio.canvas.style import Label, Look

STRIP = 32.0
RADIUS = 8.0


class ScriptItem(NodeFace):
    """One node of any of the five kinds. Only situations can be dragged, up and down."""

    face: ScriptNode

    def __init__(self, name: str = "node", parent: QGraphicsItem | None = None) -> None:
        super().__init__(name, parent)
        self._laid: tuple[object, ...] | None = None
        self._texts: dict[str, Label] = {}

    def show_face(self, face: ScriptNode) -> None:
        super().show_face(face)
        movable = face.kind == "situation"
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemIsMovable, movable)

    def prepare(self) -> None:
        self._laid = None

    def itemChange(self, change: QGraphicsItem.GraphicsItemChange, value: Any) -> Any:
        if change == QGraphicsItem.GraphicsItemChange.ItemPositionChange and self.face is not None:
            # Columns are fixed.
            return QPointF(self.face.x, value.y())
        return super().itemChange(change, value)

    def _lay_out(self, look: Look) -> None:
        node = self.face
        detail = self._detail(look)
        key = (id(node), look.version, detail)
        if self._laid == key:
            return
        self._laid = key
        room = node.width - STRIP - 16
        name_room = room - (26 if node.number or node.mark else 0)
        self._texts = {
            "name": Label(node.name, 13, 600, name_room),
            "detail": Label(detail, 11, 400, room),
            "number": Label(str(node.number), 11, 600),
            "joint": Label(node.joint, 11, 600),
        }
        for index, line in enumerate(node.lines):
            self._texts[f"line {index}"] = Label(line, 12, 500, room)

    def _detail(self, look: Look) -> str:
        node, live = self.face, look.live
        if isinstance(live, LiveScript):
            if node.kind == "data" and node.name in live.values:
                return said(live.values[node.name])
            if node.kind == "resource":
                return live.authority.get(node.name) or "nobody"
            if node.kind == "module" and node.name in live.asking:
                return f"asks for {' '.join(live.asking[node.name])}"
        return node.detail

    def _lit(self, look: Look) -> bool:
        """Whether the robot is at it: current, holding, held."""
        node, live = self.face, look.live
        if not isinstance(live, LiveScript):
            return False
        match node.kind:
            case "situation":
                return live.situation == node.name
            case "condition":
                return node.name in live.holds
            case "module":
                return node.name in live.authority.values()
            case "resource":
                return bool(live.authority.get(node.name))
        return False

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        look, node = self.look, self.face
        assert look is not None
        area = QRectF(0, 0, node.width, node.height)
        lit = self._lit(look)
        if look.level in ("quarter", "tiny"):
            painter.fillRect(area, look["live"] if lit else look[node.kind])
            return
        self._lay_out(look)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if lit and node.kind == "situation":
            for out, width, opacity in ((14, 8, 0.07), (8.5, 6, 0.16), (4, 4, 0.34)):
                painter.setPen(QPen(look.faint("live", opacity), width))
                painter.drawRoundedRect(area.adjusted(-out, -out, out, out), 8 + out, 8 + out)
        if self.isSelected():
            painter.setPen(QPen(look.faint("accent", 0.22), 4))
            painter.drawRoundedRect(area.adjusted(-3, -3, 3, 3), 11, 11)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(look["shadow"])
        painter.drawRoundedRect(area.translated(0, 1.5), RADIUS, RADIUS)
        painter.setBrush(look["card"])
        painter.drawRoundedRect(area, RADIUS, RADIUS)
        painter.fillPath(_strip(node.height), look["live_soft" if lit else f"{node.kind}_soft"])
        color = (
            look["live"] if lit else look["accent"] if self.isSelected() else look["card_border"]
        )
        wide = 2.5 if lit and node.kind == "situation" else 2 if self.isSelected() or lit else 1
        painter.setPen(QPen(color, wide))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(area, RADIUS, RADIUS)
        kind_color = look["live"] if lit else look[node.kind]
        middle = node.height / 2
        if node.joint:
            look.icon(painter, node.kind, 7, middle - 17, 18, kind_color)
            self._texts["joint"].draw_middle(painter, STRIP / 2, middle + 16, kind_color)
        else:
            look.icon(painter, node.kind, 7, middle - 9, 18, kind_color)
        if node.lines:
            for index in range(len(node.lines)):
                self._texts[f"line {index}"].draw(
                    painter, 40, node.line_at(index) + 4, look["text"]
                )
        else:
            detail = self._texts["detail"]
            two = detail.width > 0
            up = 9 if node.height < 50 else 8
            self._texts["name"].draw(
                painter, 40, middle + (4.5 if not two else 4.5 - up), look["text"]
            )
            if two:
                detail.draw(painter, 40, middle + (13 if node.height >= 50 else 12), look["text2"])
        if node.number:
            box = QRectF(node.width - 26, 8, 18, 16)
            if not self._texts["detail"].width:
                box.moveTop(middle - 8)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(look["live"] if lit else look["situation_soft"])
            painter.drawRoundedRect(box, 4, 4)
            ink = look["card"] if lit else look["situation"]
            self._texts["number"].draw_middle(painter, box.center().x(), box.center().y() + 4, ink)
        if node.mark:
            x = node.width - (46 if node.number else 24)
            look.icon(painter, node.mark, x, 8, 16, look[node.mark])
        if node.outputs and (self.isSelected() or (self.isUnderMouse() and not look.on_paper)):
            x, y = node.port(OUT)
            hovered = self.hovered == OUT
            painter.setPen(QPen(look["accent"], 1.5))
            painter.setBrush(look["accent"] if hovered else look["card"])
            painter.drawEllipse(QPointF(x, y), 4.25, 4.25)


def said(value: Any) -> str:
    """A value on the blackboard in a few letters."""
    match value:
        case None:
            return "nothing"
        case True | False:
            return "yes" if value else "no"
        case float():
            return f"{value:.3g}"
        case list():
            return f"{len(value)} in a list"
        case dict():
            return ", ".join(f"{k} {said(v)}" for k, v in value.items())
    return str(value)


def _strip(height: float) -> QPainterPath:
    """The strip at a node's left edge; not by a clip, which SVG pictures do not get."""
    path = QPainterPath(QPointF(STRIP, 0))
    path.lineTo(RADIUS, 0)
    path.arcTo(QRectF(0, 0, 2 * RADIUS, 2 * RADIUS), 90, 90)
    path.lineTo(0, height - RADIUS)
    path.arcTo(QRectF(0, height - 2 * RADIUS, 2 * RADIUS, 2 * RADIUS), 180, 90)
    path.lineTo(STRIP, height)
    path.closeSubpath()
    return path
