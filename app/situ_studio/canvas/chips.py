"""The chips in which pipes without a way end, and the heads of their arrows."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, Qt

from situ_studio.canvas.style import Look, whole_label

STUB = 15.0
"""The line and arrow before a chip."""


def chip_width(text: str, icon: bool = False) -> float:
    return 18.0 if icon else max(18.0, 6.6 + 6.5 * len(text))


def paint_chip(
    painter: QPainter, look: Look, x: float, y: float, text: str, color: str, icon: str = ""
) -> None:
    """The short arrow that leaves an exit at x, y, and the chip that it ends in."""
    red = color == "error"
    painter.setPen(QPen(look[color if red or color == "accent" else "pipe"], 1.6))
    painter.drawLine(QPointF(x + 4, y), QPointF(x + 10, y))
    arrow(painter, look[color if red or color == "accent" else "pipe"], x + STUB, y)
    width = chip_width(text, bool(icon))
    painter.setPen(QPen(look["error"] if red else look["line_strong"], 1))
    painter.setBrush(look["error_soft"] if red else look["panel"])
    painter.drawRoundedRect(QRectF(x + STUB, y - 8, width, 16), 4, 4)
    if icon:
        look.icon(painter, icon, x + STUB + 3, y - 6, 12, look["text2"])
        return
    ink = look["error"] if red else look["accent"] if color == "accent" else look["text2"]
    whole_label(text, 11, 600).draw_middle(painter, x + STUB + width / 2, y + 4, ink)


def arrow(
    painter: QPainter, color: QColor, x: float, y: float, upwards: bool = False, scale: float = 1.0
) -> None:
    """An arrow head 7 × 8 with its point at x, y, to the right or upwards."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(color)
    painter.drawPath(_head(upwards, scale).translated(x, y))


@lru_cache(maxsize=8)
def _head(upwards: bool, scale: float) -> QPainterPath:
    long, half = 7 * scale, 4 * scale
    path = QPainterPath(QPointF(0, 0))
    if upwards:
        path.lineTo(-half, long)
        path.lineTo(half, long)
    else:
        path.lineTo(-long, -half)
        path.lineTo(-long, half)
    path.closeSubpath()
    return path
