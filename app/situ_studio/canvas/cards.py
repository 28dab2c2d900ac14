"""State cards, painted as mockups/tokens.md measures them, at four levels of detail."""

from __future__ import annotations

from itertools import pairwise

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, Qt
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas import counted, operated, thumbnails, untaken
from situ_studio.canvas.card_texts import PICTURE, before_name, full_texts, large_texts
from situ_studio.canvas.chips import paint_chip
from situ_studio.canvas.live import LiveView
from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.picture import HEADER, NEW, PITCH, TIMEOUT, Card, Exit
from situ_studio.canvas.style import Label, Look

RADIUS = 8.0
LARGE_PICTURE = QRectF(12, 46, 92, 58)
LOWER_PICTURE = QRectF(12, 64, 70, 44)
"""Where the name takes two lines."""


class CardItem(NodeFace):
    """The card of a state or of ``always``."""

    face: Card

    def __init__(self, name: str = "state", parent: QGraphicsItem | None = None) -> None:
        super().__init__(name, parent)
        self._laid: tuple[object, ...] | None = None
        self._texts: dict[str, Label] = {}
        self._large: tuple[int, Label, Label, Label | None] | None = None
        self._icons: tuple[str, ...] = ()
        self._picture: tuple[thumbnails.Mark, ...] | None = None

    def room(self, face: Card) -> QRectF:
        return QRectF(-18, -18, face.width + 88, face.height + 36)

    def prepare(self) -> None:
        self._laid = None
        self._large = None
        self._picture = None

    def _lay_out(self) -> None:
        card, look = self.face, self.look
        assert look is not None
        key = (id(card), look.version)
        if self._laid != key:
            self._laid = key
            self._texts, self._icons = full_texts(card)

    # -- painting -------------------------------------------------------------------

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: Widget | None = None
    ) -> None:
        look = self.look
        assert look is not None
        level = look.level
        if level == "tiny":
            self._paint_tiny(painter, look)
            self._paint_untaken(painter, look)
        elif level == "quarter":
            self._paint_quarter(painter, look)
            self._paint_untaken(painter, look)
        elif widget is None or self._live(look):
            # A picture for print keeps its lines; where the robot is, it is so for a moment only.
            self._paint_near(painter)
            self._paint_deeds(painter, look)
        else:
            state = (
                look.version,
                level,
                look.live is None,
                self.isSelected(),
                self.isUnderMouse(),
                self.hovered,
                self.row,
            )
            look.pictures.paint(painter, self.uid, self.face, state, self._rect, self._paint_near)
            # Another each moment, while the card below stays as it is.
            self._paint_deeds(painter, look)

    def _paint_near(self, painter: QPainter) -> None:
        look = self.look
        assert look is not None
        if look.level == "half":
            self._paint_half(painter, look)
        else:
            self._paint_full(painter, look)

    def _paint_deeds(self, painter: QPainter, look: Look) -> None:
        """What a robot has done here, and an operator."""
        if isinstance(look.live, LiveView):
            self._paint_untaken(painter, look)
            counted.paint(painter, look, look.live, self.face.no, self.face.width - 10)
            operated.paint(painter, look, look.live, self.face.no)

    def _paint_untaken(self, painter: QPainter, look: Look) -> None:
        if isinstance(look.live, LiveView) and look.live.counts.get(self.face.no) == 0:
            area = QRectF(0, 0, self.face.width, self.face.height)
            untaken.paint_card(painter, look, area, RADIUS)
            if look.level == "full":
                self._paint_chips(painter, look)
        if look.level == "full":
            # Here, not with the pipes: none of them may lie on it.
            for spot in self.outputs:
                for at in (pipe.untaken_at_exit() for pipe in spot.connected_pipes):
                    if at is not None:
                        here = self.mapFromScene(at)
                        untaken.paint_at_exit(painter, look, here.x(), here.y())

    def _live(self, look: Look) -> bool:
        return isinstance(look.live, LiveView) and self.face.no in look.live.active

    def _border(self, look: Look) -> QColor:
        if self._live(look):
            return look["live"]
        if self.isSelected():
            return look["accent"]
        kind = self.face.kind
        if kind in ("start", "part"):
            return look[kind]
        return look["state"] if kind == "end" else look["card_border"]

    def _paint_tiny(self, painter: QPainter, look: Look) -> None:
        card = self.face
        area = QRectF(0, 0, card.width, card.height)
        if self._live(look):
            ring = 6 / look.zoom
            painter.fillRect(area.adjusted(-ring, -ring, ring, ring), look.faint("live", 0.45))
            painter.fillRect(area, look["live"])
        elif self.isSelected():
            painter.fillRect(area, look["accent"])
        else:
            kind = card.kind
            painter.fillRect(area, look[kind] if kind in ("start", "part") else look["far"])

    def _paint_quarter(self, painter: QPainter, look: Look) -> None:
        card = self.face
        area = QRectF(0, 0, card.width, card.height)
        self._paint_rings(painter, look, area, 1 / look.zoom)
        painter.setBrush(look["card"])
        painter.setPen(QPen(self._border(look), (2.0 if self.isSelected() else 1.0) / look.zoom))
        painter.drawRoundedRect(area, 10, 10)
        pixels = int(13 / look.zoom)
        if self._large is None or self._large[0] != pixels:
            text = Label(card.no or "∗", pixels, 600, card.width - 12)
            self._large = pixels, text, text, None
        self._large[1].draw_middle(
            painter, card.width / 2, card.height / 2 + pixels * 0.36, look["state"]
        )
        if card.mark:
            size = 16 / look.zoom
            look.icon(
                painter, card.mark, card.width - size * 0.8, -size * 0.2, size, look[card.mark]
            )

    def _paint_half(self, painter: QPainter, look: Look) -> None:
        card = self.face
        area = QRectF(0, 0, card.width, card.height)
        self._paint_rings(painter, look, area, 1.0)
        if card.kind == "part":
            self._paint_back(painter, look, area)
        painter.setBrush(look["card"])
        painter.setPen(QPen(self._border(look), 2.5 if self.isSelected() else 2))
        painter.drawRoundedRect(area, RADIUS, RADIUS)
        pixels = max(15, min(28, int(11.5 / look.zoom)))
        if self._large is None or self._large[0] != pixels:
            self._large = pixels, *large_texts(card, pixels)
        _, number, first, second = self._large
        left = 10.0
        if card.no:
            chip = max(30.0, number.width + 12)
            self._paint_number(painter, look, QRectF(10, 9, chip, 26), 5)
            number.draw_middle(painter, 10 + chip / 2, 22 + pixels * 0.32, self._number_ink(look))
            left += chip + 10
        first.draw(painter, left, 22 + pixels * 0.36, look["text"])
        if second is not None:
            second.draw(painter, 12, 22 + pixels * 1.42, look["text"])
        if card.mark:
            look.icon(painter, card.mark, card.width - 32, 11, 22, look[card.mark])
        self._paint_picture(painter, look, LARGE_PICTURE if second is None else LOWER_PICTURE)
        painter.setPen(Qt.PenStyle.NoPen)
        for leaving in card.exits:
            x, y = card.port(leaving.id)
            painter.setBrush(self._port_color(look, leaving))
            if leaving.timeout:
                painter.drawRoundedRect(QRectF(x - 5, y - 5, 10, 10), 2, 2)
            else:
                painter.drawEllipse(QPointF(x, y), 5, 5)
        self._paint_bar(painter, look)

    def _paint_full(self, painter: QPainter, look: Look) -> None:
        self._lay_out()
        card, texts = self.face, self._texts
        area = QRectF(0, 0, card.width, card.height)
        selected = self.isSelected()
        active = self._live(look)
        self._paint_rings(painter, look, area, 1.0)
        if card.kind == "part":
            self._paint_back(painter, look, area)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(look["shadow"])
        painter.drawRoundedRect(area.translated(0, 2), RADIUS, RADIUS)
        painter.setBrush(look["card"])
        painter.drawRoundedRect(area, RADIUS, RADIUS)
        soft = "live_soft" if active else f"{card.kind}_soft"
        if active or card.kind in ("start", "part", "always", "end"):
            if card.kind in ("always", "end") and not active:
                soft = "state_soft"
            painter.fillPath(_header(card.width), look[soft])
        painter.setPen(QPen(look["line"], 1))
        painter.drawLine(QPointF(1, HEADER), QPointF(card.width - 1, HEADER))
        painter.setPen(QPen(self._border(look), 2.5 if active else 2 if selected else 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(area, RADIUS, RADIUS)
        if card.kind == "end":
            painter.setPen(QPen(self._border(look), 1))
            painter.drawRoundedRect(area.adjusted(3, 3, -3, -3), RADIUS - 3, RADIUS - 3)
        left = 30.0
        if card.no:
            number = texts["no"]
            chip = max(20.0, number.width + 8)
            self._paint_number(painter, look, QRectF(8, 6, chip, 16), 4)
            number.draw_middle(painter, 8 + chip / 2, 18, self._number_ink(look))
            left = 8 + chip + 8
        else:
            look.icon(painter, "always", 9, 6, 16, look["state"])
        texts["name"].draw(painter, left, 19, look["text"])
        right = card.width - 8
        if card.kind in ("start", "end", "part"):
            right -= 16
            color = look[card.kind] if card.kind != "end" else look["state"]
            look.icon(painter, card.kind, right, 6, 16, color)
            right -= 4
        if card.mark:
            look.icon(painter, card.mark, right - 16, 6, 16, look[card.mark])
        if card.line:
            look.icon(painter, card.line_icon, 8, 33, 13, look["text3"])
            texts["line"].draw(painter, 26, 44, look["text2"])
        self._paint_picture(painter, look, PICTURE)
        for index, icon in enumerate(self._icons):
            look.icon(painter, icon, 8 + 19 * index, 92, 14, look["text2"])
        for leaving in card.exits:
            self._paint_exit(painter, look, leaving)
        self._paint_new(painter, look)
        self._paint_chips(painter, look)
        self._paint_bar(painter, look)

    def _paint_number(self, painter: QPainter, look: Look, area: QRectF, radius: float) -> None:
        kind = self.face.kind
        painter.setPen(Qt.PenStyle.NoPen)
        if self._live(look):
            painter.setBrush(look["live"])
        elif kind in ("start", "part"):
            painter.setBrush(look[kind])
        else:
            painter.setBrush(look["state_soft"] if kind != "end" else look["card"])
        painter.drawRoundedRect(area, radius, radius)

    def _number_ink(self, look: Look) -> QColor:
        if self._live(look) or self.face.kind in ("start", "part"):
            return look["card"]
        return look["state"]

    def _paint_rings(self, painter: QPainter, look: Look, area: QRectF, unit: float) -> None:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if self._live(look):
            for far, wide, opacity in ((14.0, 8, 0.07), (8.5, 6, 0.16), (4.0, 4, 0.34)):
                out, width = far * unit, wide * unit
                painter.setPen(QPen(look.faint("live", opacity), width))
                painter.drawRoundedRect(
                    area.adjusted(-out, -out, out, out), RADIUS + out, RADIUS + out
                )
        if self.isSelected():
            out = 3 * unit
            painter.setPen(QPen(look.faint("accent", 0.22), 4 * unit))
            painter.drawRoundedRect(area.adjusted(-out, -out, out, out), RADIUS + out, RADIUS + out)

    def _paint_back(self, painter: QPainter, look: Look, area: QRectF) -> None:
        """A part's second outline."""
        painter.setPen(QPen(look["part"], 1))
        painter.setBrush(look["card"])
        painter.drawRoundedRect(area.translated(5, -5), RADIUS, RADIUS)

    def _paint_picture(self, painter: QPainter, look: Look, area: QRectF) -> None:
        card = self.face
        if card.screen is not None:
            if self._picture is None:
                self._picture = thumbnails.marks(card.screen)
            thumbnails.paint(painter, self._picture, area, look)
        elif card.kind == "part":
            painter.setPen(QPen(look["line_strong"], 1))
            painter.setBrush(look["field"])
            painter.drawRoundedRect(area, 3, 3)
            painter.setPen(QPen(look["part"], 1))
            painter.setBrush(look["card"])
            unit = area.width() / 48
            boxes = [(6, 12), (19, 17), (32, 10)]
            for (ax, ay), (bx, by) in pairwise(boxes):
                painter.drawLine(
                    QPointF(area.left() + (ax + 10) * unit, area.top() + (ay + 3) * unit),
                    QPointF(area.left() + bx * unit, area.top() + (by + 3) * unit),
                )
            for x, y in boxes:
                painter.drawRoundedRect(
                    QRectF(area.left() + x * unit, area.top() + y * unit, 10 * unit, 7 * unit), 2, 2
                )

    def _port_color(self, look: Look, leaving: Exit) -> QColor:
        if leaving.missing:
            return look["error"]
        if leaving.guard:
            return look["condition"]
        return look["pipe"]

    def _paint_exit(self, painter: QPainter, look: Look, leaving: Exit) -> None:
        card = self.face
        x, y = card.port(leaving.id)
        label = self._texts[f"exit {leaving.id}"]
        left = x - 12 - label.width
        if self.row == leaving.id:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(look["accent_soft"])
            painter.drawRoundedRect(
                QRectF(
                    left - 4 - before_name(leaving), y - 9, x - left - 2 + before_name(leaving), 18
                ),
                4,
                4,
            )
        ink = look["text"]
        if leaving.missing:
            ink = look["error"]
        elif leaving.timeout or leaving.next is None:
            ink = look["text2"]
        label.draw(painter, left, y + 4, ink)
        if leaving.timeout:
            look.icon(painter, TIMEOUT, left - 15, y - 6, 12, look["text3"])
        elif leaving.guard:
            look.icon(painter, "guard", left - 15, y - 6.5, 13, look["condition"])
        sign = leaving.mark.sign
        if sign:
            look.icon(painter, sign, left - before_name(leaving), y - 7, 13, look[sign])
        phrase = self._texts.get(f"phrase {leaving.id}")
        if phrase is not None:
            phrase.draw_right(painter, left - 6 - before_name(leaving), y + 4, look["text3"])
        color = self._port_color(look, leaving)
        hovered = self.hovered == leaving.id
        if self.isSelected() and not leaving.missing and not leaving.guard:
            color = look["accent"]
        painter.setPen(QPen(look["accent"] if hovered else color, 2 if hovered else 1.5))
        painter.setBrush(look["accent_soft"] if hovered else look["card"])
        if leaving.timeout:
            painter.drawRoundedRect(QRectF(x - 4, y - 4, 8, 8), 2, 2)
        elif leaving.next is None:
            # Internal: nothing leaves, so the port is only an outline that is open.
            painter.drawEllipse(QPointF(x, y), 3, 3)
        else:
            painter.drawEllipse(QPointF(x, y), 4.25, 4.25)
        if leaving.short:
            icon = {"#back": "undo", "#again": "repeat"}.get(leaving.short, "")
            paint_chip(
                painter, look, x, y, leaving.short, "error" if leaving.missing else "pipe", icon
            )

    def _paint_new(self, painter: QPainter, look: Look) -> None:
        """The exit of the next new event, where somebody could want it."""
        wanted = self.isSelected() or (self.isUnderMouse() and not look.on_paper)
        if not wanted or look.live is not None:
            return
        x, y = self.face.port(NEW)
        hovered = self.hovered == NEW
        painter.setPen(QPen(look["accent"], 1.5))
        painter.setBrush(look["accent"] if hovered else look["card"])
        painter.drawEllipse(QPointF(x, y), 6, 6)
        painter.setPen(QPen(look["on_accent"] if hovered else look["accent"], 1.5))
        painter.drawLine(QPointF(x - 3, y), QPointF(x + 3, y))
        painter.drawLine(QPointF(x, y - 3), QPointF(x, y + 3))

    def _paint_chips(self, painter: QPainter, look: Look) -> None:
        """What ``always`` adds, hanging on the lower edge."""
        at = 9.0
        for index in range(len(self.face.chips)):
            label = self._texts.get(f"chip {index}")
            if label is None:
                break
            area = QRectF(at, self.face.height - 6, label.width + 10, 13)
            painter.setPen(QPen(look["line_strong"], 1))
            painter.setBrush(look["panel"])
            painter.drawRoundedRect(area, 4, 4)
            label.draw(painter, at + 5, self.face.height + 4, look["text3"])
            at += area.width() + 4

    def _paint_bar(self, painter: QPainter, look: Look) -> None:
        """Live: how much of the timeout has passed."""
        live, card = look.live, self.face
        if not isinstance(live, LiveView) or card.no not in live.active:
            return
        leaving = card.exit(TIMEOUT)
        if leaving is None or not leaving.seconds:
            return
        part = min(1.0, live.entered.get(card.no, 0.0) / leaving.seconds)
        area = QRectF(8, card.height - 8, card.width - 16, 4)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(look["line"])
        painter.drawRoundedRect(area, 2, 2)
        painter.setBrush(look["live"])
        painter.drawRoundedRect(QRectF(8, card.height - 8, area.width() * part, 4), 2, 2)

    # -- what is hit ------------------------------------------------------------------

    def part_at(self, spot: QPointF) -> str:
        """``name``, ``exit <id>``, ``picture`` or ``body``."""
        if spot.y() < HEADER:
            return "name"
        for leaving in self.face.exits:
            _, y = self.face.port(leaving.id)
            if abs(spot.y() - y) < PITCH / 2 and spot.x() > PICTURE.right() + 2:
                return f"exit {leaving.id}"
        return "picture" if PICTURE.contains(spot) else "body"

    def picture_area(self) -> QRectF:
        """Where the small picture of the screen is painted now; empty where there is none."""
        level = self.look.level if self.look is not None else ""
        if self.face.screen is None or level not in ("full", "half"):
            return QRectF()
        if level == "full":
            return PICTURE
        one_line = self._large is None or self._large[3] is None
        return LARGE_PICTURE if one_line else LOWER_PICTURE


def _header(width: float) -> QPainterPath:
    """A card's coloured header; not by a clip, which SVG pictures do not get."""
    path = QPainterPath(QPointF(0, HEADER))
    path.lineTo(0, RADIUS)
    path.arcTo(QRectF(0, 0, 2 * RADIUS, 2 * RADIUS), 180, -90)
    path.lineTo(width - RADIUS, 0)
    path.arcTo(QRectF(width - 2 * RADIUS, 0, 2 * RADIUS, 2 * RADIUS), 90, -90)
    path.lineTo(width, HEADER)
    path.closeSubpath()
    return path
