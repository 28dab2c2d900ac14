"""What stands on a card: a breakpoint, and that the robot is paused or suspended there."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from situ_studio.canvas.live import LiveView
from situ_studio.canvas.style import Look, whole_label
from situ_studio.wording.language import tr

EDGE = 18.0
"""Px of the breakpoint's sign, which stands on the card's left edge."""


def breakpoint_sign(painter: QPainter, look: Look, y: float) -> None:
    """On the left edge of a card or node, its middle at y."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(look["card"])
    painter.drawEllipse(QPointF(0, y), EDGE / 2, EDGE / 2)
    look.icon(painter, "breakpoint", -EDGE / 2, y - EDGE / 2, EDGE, look["error"])


def paint(painter: QPainter, look: Look, live: LiveView, no: str) -> None:
    """no: the card's state."""
    if no in live.breakpoints:
        breakpoint_sign(painter, look, 56)
    if no in live.paused or no in live.suspended:
        # A suspended one has the sign alone: with its word it would lie over what is counted.
        words = whole_label(tr("paused"), 11, 600) if no in live.paused else None
        area = QRectF(12, -12, 22 if words is None else words.width + 26, 18)
        painter.setPen(QPen(look["warning"], 1.5))
        painter.setBrush(look["card"])
        painter.drawRoundedRect(area, 9, 9)
        look.icon(painter, "pause", 17, -9, 12, look["warning"])
        if words is not None:
            words.draw(painter, 31, 1, look["text"])
