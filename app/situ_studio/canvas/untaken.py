"""What nobody came through, where somebody has counted: dotted and pale, with 0× on it, so that it
is told from what was, whatever colours are seen.
"""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPen, Qt

from situ_studio.canvas.style import Look, whole_label

DOTS = (1.6, 4.4)
"""A dot and a gap, in px: a timeout's dashes are longer than their gaps."""
WASH = 0.25
"""How much of the ground is seen through a card."""
HIGH = 16.0
REACH = 20.0
"""Px round its middle that a sign takes at most."""


def pen(look: Look, color: QColor, width: float, long: float = 0.0) -> QPen:
    """For a line that was never taken. long: its length; the dots are counted from its end, so
    that they fall together where several lead to the same place, and do not fill the gaps.
    """
    made = QPen(color, width)
    unit = max(1.0, 1 / look.zoom) / width
    pattern = [part * unit for part in DOTS]
    made.setDashPattern(pattern)
    made.setDashOffset(-(long / width) % sum(pattern))
    return made


def paint_sign(painter: QPainter, look: Look, x: float, y: float) -> None:
    """``0×`` with its middle there; small drawings leave it."""
    if look.level in ("quarter", "tiny"):
        return
    scale = 1.0 if look.level == "full" else 1.5
    text = whole_label("0×", round(11 * scale), 600)
    wide, high = text.width + 8 * scale, HIGH * scale
    painter.setPen(QPen(look["line_strong"], 1))
    painter.setBrush(look["panel"])
    painter.drawRoundedRect(QRectF(x - wide / 2, y - high / 2, wide, high), high / 2, high / 2)
    text.draw_middle(painter, x, y + 4 * scale, look["text2"])


def paint_at_exit(painter: QPainter, look: Look, x: float, y: float) -> None:
    """``0×`` from there to the right: where rows are near each other, and cards."""
    text = whole_label("0×", 10, 600)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(look["canvas"])
    painter.drawRoundedRect(QRectF(x, y - 6, text.width + 2, 12), 3, 3)
    text.draw(painter, x + 1, y + 3.5, look["text2"])


def paint_card(painter: QPainter, look: Look, area: QRectF, radius: float) -> None:
    """Over a card, or over a situation."""
    width = max(1.6, 1.2 / look.zoom)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(look.faint("canvas", WASH))
    painter.drawRoundedRect(area.adjusted(-1, -1, 1, 1), radius, radius)
    # The card's own edge would show between the dots.
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(look["canvas"], 2 * width))
    painter.drawRoundedRect(area, radius, radius)
    painter.setPen(pen(look, look["text3"], width))
    painter.drawRoundedRect(area, radius, radius)


def paint_tip(painter: QPainter, look: Look, color: QColor, end: QPointF, upwards: bool) -> None:
    """An arrow's head that is only an outline."""
    long, half = 7.0, 4.0
    if upwards:
        one, other = QPointF(-half, long), QPointF(half, long)
    else:
        one, other = QPointF(-long, -half), QPointF(-long, half)
    painter.setPen(QPen(color, max(1.2, 1 / look.zoom)))
    painter.setBrush(look["canvas"])
    painter.drawPolygon([end, end + one, end + other])
