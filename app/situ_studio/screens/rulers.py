"""The rulers of the screen designer: percent of the robot's screen, above it and beside it."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPolygonF
from PySide6.QtWidgets import QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme, font
from situ_studio.screens.guides import Guide

WIDE = 18
"""Px of a ruler's breadth."""
LETTERS = 9
CLOSE = 5.0
"""Px that two lines of a ruler are apart at least."""


class Ruler(QWidget):
    """One of them. axis: whose percent it shows; guides are drawn out of the other one."""

    def __init__(self, axis: str, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self.axis = axis
        self._theme = theme
        self._start, self._length = 0.0, 1.0
        self._guides: tuple[Guide, ...] = ()
        across = axis == "x"
        self.setAccessibleName(self.tr("Ruler above") if across else self.tr("Ruler at the left"))
        self.setToolTip(
            self.tr("Drag from here down: a guide across the screen")
            if across
            else self.tr("Drag from here to the right: a guide down the screen")
        )
        split = Qt.CursorShape.SplitVCursor if across else Qt.CursorShape.SplitHCursor
        self.setCursor(split)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def show_screen(self, start: float, length: float) -> None:
        """The screen begins so many px from the ruler's beginning, and is so long."""
        self._start, self._length = start, length
        self.update()

    def show_guides(self, guides: tuple[Guide, ...]) -> None:
        own = tuple(one for one in guides if one.axis == self.axis)
        # Told at every edit, and while a guide of the other axis is dragged.
        if own != self._guides:
            self._guides = own
            self.update()

    def place(self, percent: float) -> float:
        """Px from its beginning at which a percent of the screen stands."""
        return self._start + self._length * percent / 100

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, theme = QPainter(self), self._theme
        painter.fillRect(self.rect(), theme.color("card"))
        across = self.axis == "x"
        room = QRectF(self.rect())
        on_screen = self._along(self._start, 0, self._length, px(WIDE))
        painter.fillRect(on_screen, theme.color("canvas"))
        painter.setPen(theme.color("line_strong"))
        edge = room.bottomLeft() if across else room.topRight()
        painter.drawLine(QLineF(edge, room.bottomRight()).translated(-0.5, -0.5))
        step = next(s for s in (1, 2, 5, 10, 20, 50) if self._length * s / 100 >= CLOSE or s == 50)
        painter.setFont(font(LETTERS))
        for percent in range(0, 101, step):
            whole = percent % 10 == 0
            long = px(WIDE) if percent % 50 == 0 else px(7) if whole else px(4)
            painter.setPen(theme.color("text3" if whole else "line_strong"))
            painter.drawRect(self._along(self.place(percent), px(WIDE) - long, 0, long))
            if percent % 50 == 0:
                self._write(painter, percent)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.color("guides"))
        for one in self._guides:
            spot, end = self.place(one.at), float(px(WIDE))
            corners = ((spot - 4, end - 7), (spot + 4, end - 7), (spot, end))
            points = [QPointF(a, b) if across else QPointF(b, a) for a, b in corners]
            painter.drawPolygon(QPolygonF(points))
        painter.end()

    def _along(self, start: float, down: float, length: float, high: float) -> QRectF:
        """A box of the ruler above, or the same one turned for the ruler at the left."""
        if self.axis == "x":
            return QRectF(start, down, length, high)
        return QRectF(down, start, high, length)

    def _write(self, painter: QPainter, percent: int) -> None:
        painter.setPen(self._theme.color("text2"))
        words = str(percent)
        if self.axis == "x":
            painter.drawText(QPointF(self.place(percent) + 3, px(10)), words)
            return
        # From below to above, as on any ruler that stands.
        painter.save()
        wide = painter.fontMetrics().horizontalAdvance(words)
        painter.translate(px(10), self.place(percent) + 3 + wide)
        painter.rotate(-90)
        painter.drawText(QPointF(0, 0), words)
        painter.restore()
