"""The headings of a script's columns: at the upper edge of the drawing, wherever it is scrolled."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from situ_studio.canvas.script_faces import LEFT, WIDTH, titles
from situ_studio.canvas.style import Label, Look

HIGH = 32
BASELINE = 21.0
LEAST = 40.0
"""A column that is narrower on the screen has no heading."""


class Headings(QWidget):
    """Lies over the drawing; what lies under it is pressed as if it were not there."""

    def __init__(self, viewer: Any, look: Look, parent: QWidget) -> None:
        super().__init__(parent)
        self._viewer = viewer
        self._look = look
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFixedHeight(HIGH)

    def areas(self) -> dict[str, QRect]:
        """Where the heading of each column is written, in px of this widget."""
        found = {}
        left, zoom = self._viewer.seen().left(), self._look.zoom
        columns = list(LEFT)
        for kind, after in zip(columns, [*columns[1:], None], strict=True):
            start = (LEFT[kind] - left) * zoom
            end = LEFT[after] if after is not None else LEFT[kind] + WIDTH[kind] + 60
            room = (end - LEFT[kind] - 8) * zoom
            if room >= LEAST:
                found[kind] = QRect(round(start), 0, round(room), HIGH)
        return found

    def paintEvent(self, event: QPaintEvent) -> None:
        look = self._look
        painter = QPainter(self)
        painter.fillRect(self.rect(), look.faint("canvas", 0.94))
        named = titles()
        for kind, area in self.areas().items():
            label = Label(named[kind], 12, 600, area.width())
            label.draw(painter, area.left(), BASELINE, look["text2"])
        painter.end()


def draw(painter: QPainter, look: Look) -> None:
    """The same on paper, above the columns."""
    for kind, title in titles().items():
        Label(title, 12, 600).draw(painter, LEFT[kind], 26, look["text2"])


EXTENT = QRectF(QPointF(16, 8), QPointF(LEFT["resource"] + WIDTH["resource"], 40))
"""What they take on paper."""
