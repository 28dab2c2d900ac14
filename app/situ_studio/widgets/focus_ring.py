"""What shows where the keyboard is, on what paints itself."""

from __future__ import annotations

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import QWidget

from situ_studio.looks.theme import Theme

WIDE, ROUND = 2.0, 5.0
"""Px, as the style sheet has them of buttons and fields."""


def paint_ring(widget: QWidget) -> None:
    """Within its edge, while it is painted."""
    painter = QPainter(widget)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(widget.palette().highlight().color(), WIDE))
    half = WIDE / 2
    painter.drawRoundedRect(QRectF(widget.rect()).adjusted(half, half, -half, -half), ROUND, ROUND)
    painter.end()


def paint_chosen(painter: QPainter, row: QRectF, theme: Theme) -> None:
    """The ground of the chosen row of a list."""
    painter.fillRect(row, theme.color("accent_soft"))
    paint_bar(painter, row, theme)


def paint_bar(painter: QPainter, row: QRectF, theme: Theme, wide: float = WIDE) -> None:
    """At its left: a pale ground alone is not seen by everybody."""
    painter.fillRect(QRectF(row.x(), row.y(), wide, row.height()), theme.color("accent"))
