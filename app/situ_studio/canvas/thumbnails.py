"""A screen drawn small, from its components: bars for texts, boxes for buttons and pictures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPen, QPolygonF, Qt

from situ.document import rbd
from situ_studio.canvas.style import Look


class Mark(NamedTuple):
    """One shape, in percent of the screen. shape: bar, box, frame, play, hill."""

    shape: str
    color: str
    x: float
    y: float
    width: float
    height: float


def marks(screen: rbd.Screen) -> tuple[Mark, ...]:
    """The shapes of a screen; at most 24, the first components count."""
    made: list[Mark] = []
    buttons = 0
    for part in screen.components[:12]:
        x, y = max(0.0, min(96.0, part.x)), max(0.0, min(94.0, part.y))
        width = max(4.0, min(part.width, 100 - x))
        height = max(6.0, min(part.height, 100 - y))
        match part:
            case rbd.Text(text=text):
                lines = 2 if len(text) > 24 and height >= 22 else 1
                step = height / lines
                for line in range(lines):
                    wide = width * (0.86 if line < lines - 1 else 0.62 if lines > 1 else 0.78)
                    inset = {"left": 0.0, "right": width - wide}.get(
                        part.align or "left", (width - wide) / 2
                    )
                    made.append(
                        Mark("bar", "text3", x + inset, y + step * (line + 0.5) - 5, wide, 10)
                    )
            case rbd.Button():
                color = "accent" if buttons == 0 else "line_strong"
                buttons += 1
                made.append(Mark("box", color, x, y, width, max(12.0, height)))
            case rbd.Input():
                made.append(Mark("frame", "text3", x, y, width, max(16.0, height)))
            case rbd.List():
                rows = max(2, min(4, int(height / 16)))
                step = height / rows
                for row in range(rows):
                    color = "accent" if row == 1 else "line_strong"
                    made.append(Mark("bar", color, x, y + step * row + 2, width * 0.84, step - 6))
                made.append(Mark("bar", "line_strong", x + width * 0.9, y + 2, width * 0.1, height))
            case rbd.Movie():
                made.append(Mark("play", "line_strong", x, y, width, height))
            case _:
                made.append(Mark("hill", "line_strong", x, y, width, height))
    return tuple(made[:24])


def paint(painter: QPainter, shapes: Sequence[Mark], area: QRectF, look: Look) -> None:
    """Draws a screen of these shapes into ``area``, its frame included."""
    painter.setPen(QPen(look["line_strong"], 1))
    painter.setBrush(look["field"])
    painter.drawRoundedRect(area, 3, 3)
    inner = area.adjusted(2, 2, -2, -2)
    across, down = inner.width() / 100, inner.height() / 100
    painter.setPen(Qt.PenStyle.NoPen)
    for mark in shapes:
        rect = QRectF(
            inner.left() + mark.x * across,
            inner.top() + mark.y * down,
            mark.width * across,
            max(2.0, mark.height * down),
        )
        color = look[mark.color]
        painter.setBrush(color)
        match mark.shape:
            case "frame":
                painter.setPen(QPen(color, 1))
                painter.setBrush(look["panel"])
                painter.drawRoundedRect(rect, 1.5, 1.5)
                painter.setPen(Qt.PenStyle.NoPen)
            case "play":
                painter.drawRoundedRect(rect, 1.5, 1.5)
                middle, size = rect.center(), min(rect.width(), rect.height()) * 0.24
                painter.setBrush(look["panel"])
                painter.drawPolygon(
                    QPolygonF(
                        [
                            QPointF(middle.x() - size * 0.8, middle.y() - size),
                            QPointF(middle.x() - size * 0.8, middle.y() + size),
                            QPointF(middle.x() + size, middle.y()),
                        ]
                    )
                )
            case "hill":
                painter.drawRoundedRect(rect, 1.5, 1.5)
                if rect.width() > 6 and rect.height() > 6:
                    painter.setBrush(look["field"])
                    painter.drawPolygon(
                        QPolygonF(
                            [
                                QPointF(rect.left() + 1, rect.bottom() - 1),
                                QPointF(
                                    rect.left() + rect.width() * 0.4,
                                    rect.top() + rect.height() * 0.4,
                                ),
                                QPointF(rect.right() - 1, rect.bottom() - 1),
                            ]
                        )
                    )
            case _:
                radius = min(1.5, rect.height() / 2)
                painter.drawRoundedRect(rect, radius, radius)
