"""What all items of one canvas share: the theme, zoom, level of detail, live view.

One ``Look`` belongs to one canvas and is handed to its items; nothing here is global.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

from PySide6.QtCore import QPointF, QRectF, QSizeF
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QStaticText, Qt

from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.canvas.pictures import Pictures
from situ_studio.looks import icons
from situ_studio.looks.theme import Theme, face

Level = Literal["full", "half", "quarter", "tiny"]

FULL, HALF = 0.75, 0.4
"""The zooms from which cards show everything, and picture and name."""


def level(zoom: float) -> Level:
    """The level of detail at a zoom (mockups/tokens.md, *Level of detail*)."""
    if zoom >= FULL:
        return "full"
    if zoom >= HALF:
        return "half"
    return "quarter" if zoom >= 0.15 else "tiny"


@lru_cache(maxsize=64)
def sized(pixels: int, weight: int, squeezed: bool = False) -> QFont:
    made = face(pixels, weight)
    if squeezed:
        made.setStretch(94)
    return made


@lru_cache(maxsize=64)
def metrics(pixels: int, weight: int, squeezed: bool = False) -> QFontMetricsF:
    return QFontMetricsF(sized(pixels, weight, squeezed))


class Label:
    """A text laid out once: fitted to a width, squeezed a little before it is cut with …

    cut_at: where it is cut; names of states are told apart by their ends.
    """

    __slots__ = ("_ascent", "_font", "_text", "cut", "width")

    def __init__(
        self,
        text: str,
        pixels: int,
        weight: int,
        room: float = 1e6,
        cut_at: Qt.TextElideMode = Qt.TextElideMode.ElideRight,
    ) -> None:
        text = " ".join(text.split())
        wide = metrics(pixels, weight)
        squeezed = False
        self.cut = False
        self.width = wide.horizontalAdvance(text)
        if self.width > room:
            narrow = metrics(pixels, weight, True)
            squeezed = True
            self.width = narrow.horizontalAdvance(text)
            if self.width > room:
                self.cut = True
                text = narrow.elidedText(text, cut_at, room)
                self.width = narrow.horizontalAdvance(text)
        self._font = sized(pixels, weight, squeezed)
        self._ascent = metrics(pixels, weight, squeezed).ascent()
        self._text = QStaticText(text)
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setPerformanceHint(QStaticText.PerformanceHint.AggressiveCaching)

    def draw(self, painter: QPainter, x: float, baseline: float, color: QColor) -> None:
        """From x to the right."""
        painter.setFont(self._font)
        painter.setPen(color)
        painter.drawStaticText(QPointF(x, baseline - self._ascent), self._text)

    def draw_right(self, painter: QPainter, x: float, baseline: float, color: QColor) -> None:
        """Ending at x."""
        self.draw(painter, x - self.width, baseline, color)

    def draw_middle(self, painter: QPainter, x: float, baseline: float, color: QColor) -> None:
        """Centred at x."""
        self.draw(painter, x - self.width / 2, baseline, color)


@lru_cache(maxsize=512)
def whole_label(text: str, pixels: int, weight: int) -> Label:
    """A whole label, laid out once for all that show it: chips, counts and times."""
    return Label(text, pixels, weight)


class Look:
    """The state of one canvas that its items paint by."""

    def __init__(self, theme: Theme) -> None:
        self.zoom = 1.0
        self.level: Level = "full"
        self.pictures = Pictures()
        # Routes are still being looked for: straight lines until then.
        self.unrouted = False
        # Printed or written to a file, where nothing may be made of px.
        self.on_paper = False
        self.live: LiveView | LiveScript | None = None
        self.theme = theme
        self.colors: dict[str, QColor] = {}
        self.version = 0
        self.set_theme(theme)

    def set_theme(self, theme: Theme) -> None:
        self.theme = theme
        self.colors = {
            name: QColor(getattr(theme, name)) for name in theme.__struct_fields__ if name != "name"
        }
        # Boxes of the smallest level of detail: between line and text.
        self.colors["far"] = QColor("#AEB7C6" if theme.name == "light" else "#4A5465")
        self.version += 1

    def set_zoom(self, zoom: float) -> bool:
        """Whether the level of detail is another one now."""
        self.zoom = zoom
        before, self.level = self.level, level(zoom)
        return before != self.level

    def __getitem__(self, token: str) -> QColor:
        return self.colors[token]

    def faint(self, token: str, opacity: float) -> QColor:
        color = QColor(self.colors[token])
        color.setAlphaF(opacity)
        return color

    def icon(
        self, painter: QPainter, name: str, x: float, y: float, size: float, color: QColor
    ) -> None:
        """An icon with its corner at x, y, on whole px of the screen: sharp at any zoom."""
        to_screen = painter.deviceTransform()
        zoom = to_screen.m11()
        pixels = max(1, round(size * zoom))
        if pixels > 128 or self.on_paper:
            icons.paint(painter, name, QRectF(x, y, size, size), color)
            return
        at_x, at_y = zoom * x + to_screen.dx(), zoom * y + to_screen.dy()
        corner = QPointF(x + (round(at_x) - at_x) / zoom, y + (round(at_y) - at_y) / zoom)
        picture = icons.pixmap(name, color, pixels, 1.0)
        side = pixels / zoom
        painter.drawPixmap(QRectF(corner, QSizeF(side, side)), picture, QRectF(picture.rect()))
