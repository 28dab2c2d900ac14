"""Nodes of a script: a strip in the kind's colour, a name, a detail; measures of tokens.md."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, Qt
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas import counted, operated, untaken
from situ_studio.canvas.live import LiveScript
from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.script_faces import INDENT, LINE, OUT, STRIP, ScriptNode
from situ_studio.canvas.style import Label, Look
from situ_studio.wording.language import tr

RADIUS = 8.0
EAR = 13.0
WORD = STRIP - 1
"""The room of a word in the strip: three letters of Japanese."""
SMALLEST = 11.0
"""Px on the screen of a name in a small drawing (tokens.md, *Level of detail*)."""


class ScriptItem(NodeFace):
    """One node of any of the five kinds. Only situations are dragged, up and down."""

    face: ScriptNode

    def __init__(self, name: str = "node", parent: QGraphicsItem | None = None) -> None:
        super().__init__(name, parent)
        self._laid: tuple[object, ...] | None = None
        self._texts: dict[str, Label] = {}
        self._short_pixels = 13
        self.chosen_rows: frozenset[str] = frozenset()
        """Lines of a condition that are selected, by their paths."""

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
        half = round(look.zoom, 3) if look.level == "half" else 0.0
        key = (id(node), look.version, detail, half)
        if self._laid == key:
            return
        self._laid = key
        room = node.width - STRIP - 16
        name_room = room - (26 if node.number or node.mark else 0)
        self._texts = {
            "name": Label(node.name, 13, 600, name_room),
            "detail": Label(detail, 11, 400, room),
            "extends": Label(node.extends, 11, 400, room),
            "times": Label(node.times, 11, 400, room - 15),
            "number": Label(str(node.number), 11, 600),
            "joint": Label(joint_word(node.joint), 11, 600, WORD),
            "until": Label(tr("until"), 11, 600, WORD),
        }
        if half:
            # As large on the screen as can be read, and nothing else.
            pixels = self._short_pixels = round(max(13.0, SMALLEST / half))
            self._texts["short"] = Label(self._short(), pixels, 600, node.width - STRIP - 14)
        for row in node.rows:
            inner = room + 4 - INDENT * row.depth
            weight = 600 if row.group else 500
            self._texts[f"row {row.path}"] = Label(row.text, 12, weight, inner)

    def _short(self) -> str:
        """What a node says where it is small."""
        node = self.face
        if node.kind != "condition":
            return node.name
        tests = [row for row in node.rows if not row.group]
        return tests[0].text if len(tests) == 1 else tr("{0} tests").format(len(tests))

    def _detail(self, look: Look) -> str:
        node, live = self.face, look.live
        if isinstance(live, LiveScript):
            if node.kind == "data" and node.name in live.values:
                return said(live.values[node.name])
            if node.kind == "resource":
                return live.authority.get(node.name) or tr("nobody")
            if node.kind == "module" and node.name in live.asking:
                return tr("asks for {0}").format(" ".join(live.asking[node.name]))
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
                return node.name in live.holds and not node.until
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
        if look.level in ("quarter", "tiny"):
            area = QRectF(0, 0, node.width, node.height)
            painter.fillRect(area, look["live"] if self._lit(look) else look[node.kind])
        elif widget is None or isinstance(look.live, LiveScript):
            # A picture for print keeps its lines; what a robot does to a node is another each time.
            self._paint_near(painter)
        else:
            state = (
                look.version,
                self.isSelected(),
                self.isUnderMouse(),
                self.hovered,
                self.chosen_rows,
            )
            look.pictures.paint(painter, self.uid, node, state, self._rect, self._paint_near)

    def _paint_near(self, painter: QPainter) -> None:
        look, node = self.look, self.face
        assert look is not None
        area = QRectF(0, 0, node.width, node.height)
        lit = self._lit(look)
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
        self._paint_strip(painter, look, kind_color)
        live = look.live
        stops = live.breakpoints if isinstance(live, LiveScript) else ()
        if node.kind == "situation" and node.name in stops:
            operated.breakpoint_sign(painter, look, node.height / 2)
        if node.kind == "situation" and isinstance(live, LiveScript):
            if live.counts.get(node.name) == 0:
                untaken.paint_card(painter, look, area, RADIUS)
            counted.paint_situation(painter, look, live, node.name, node.width - 10)
        if look.level == "half":
            label = self._texts["short"]
            label.draw(painter, 38, node.height / 2 + 0.36 * self._short_pixels, look["text"])
        elif node.kind == "condition":
            self._paint_rows(painter, look)
        else:
            self._paint_lines(painter, look, detail=self._detail(look))
        if node.number and look.level == "full":
            box = QRectF(node.width - 26, 8, 18, 16)
            box.moveTop(node.stack()[0][1] - 8)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(look["live"] if lit else look["situation_soft"])
            painter.drawRoundedRect(box, 4, 4)
            ink = look["card"] if lit else look["situation"]
            self._texts["number"].draw_middle(painter, box.center().x(), box.center().y() + 4, ink)
        if node.note and look.level == "full":
            painter.fillPath(_ear(node.width), look["text3"])
        if node.mark:
            x = node.width - (46 if node.number else 22)
            look.icon(painter, node.mark, x, 6, 16, look[node.mark])
        if node.outputs and (self.isSelected() or (self.isUnderMouse() and not look.on_paper)):
            x, y = node.port(OUT)
            hovered = self.hovered == OUT
            painter.setPen(QPen(look["accent"], 1.5))
            painter.setBrush(look["accent"] if hovered else look["card"])
            painter.drawEllipse(QPointF(x, y), 4.25, 4.25)

    def _paint_strip(self, painter: QPainter, look: Look, color: QColor) -> None:
        """The icon in the strip; a condition's has above it that it ends, below it what joins."""
        node = self.face
        words = [text for text, there in (("until", node.until), ("joint", node.joint)) if there]
        up = 8.5 * ("joint" in words) - 8.5 * ("until" in words)
        middle = node.height / 2 - up
        look.icon(painter, node.kind, 7, middle - 9, 18, color)
        if "until" in words:
            self._texts["until"].draw_middle(painter, STRIP / 2, middle - 12, color)
        if "joint" in words:
            self._texts["joint"].draw_middle(painter, STRIP / 2, middle + 22, color)

    def _paint_rows(self, painter: QPainter, look: Look) -> None:
        node = self.face
        for index, row in enumerate(node.rows):
            at = node.line_at(index)
            if row.path in self.chosen_rows:
                box = QRectF(STRIP + 3, at - LINE / 2 + 0.5, node.width - STRIP - 6, LINE - 1)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(look["accent_soft"])
                painter.drawRoundedRect(box, 4, 4)
            x = 39 + INDENT * row.depth
            if row.depth:
                painter.setPen(QPen(look["condition"], 1))
                edge = x - INDENT / 2 - 1
                painter.drawLine(QPointF(edge, at - LINE / 2 + 1), QPointF(edge, at + LINE / 2 - 1))
            ink = look["condition"] if row.group else look["text"]
            self._texts[f"row {row.path}"].draw(painter, x, at + 4, ink)

    def _paint_lines(self, painter: QPainter, look: Look, detail: str) -> None:
        node = self.face
        stack = node.stack()
        if detail and not node.detail:
            # What the robot says of it has a line where the node itself has none.
            stack = (("name", node.height / 2 - 8.5), ("detail", node.height / 2 + 8.5))
        for line, at in stack:
            if line == "name":
                self._texts["name"].draw(painter, 40, at + 4.5, look["text"])
            elif line == "times":
                look.icon(painter, "timeout", 39, at - 6, 12, look["text2"])
                self._texts["times"].draw(painter, 55, at + 4, look["text2"])
            elif line:
                self._texts[line].draw(painter, 40, at + 4, look["text2"])


def joint_word(joint: str) -> str:
    """What joins the lines of a condition, in one word."""
    words = {"all": tr("all"), "any": tr("any"), "none": tr("none")}
    return words.get(joint, "")


def said(value: Any) -> str:
    """A value on the blackboard in a few letters."""
    match value:
        case None:
            return tr("nothing")
        case True | False:
            return tr("yes") if value else tr("no")
        case float():
            return f"{value:.3g}"
        case list():
            return tr("{0} in a list").format(len(value))
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


def _ear(width: float) -> QPainterPath:
    """The marked corner at the top right of a node with a note, as in a spreadsheet's cell."""
    path = QPainterPath(QPointF(width - EAR, 0))
    path.lineTo(width - RADIUS, 0)
    path.arcTo(QRectF(width - 2 * RADIUS, 0, 2 * RADIUS, 2 * RADIUS), 90, -90)
    path.lineTo(width, EAR)
    path.closeSubpath()
    return path
