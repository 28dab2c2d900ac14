"""A state's screen in small, as the robot shows it."""

from __future__ import annotations

from operator import is_not
from pathlib import Path

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from situ.document import rbd
from situ_studio.looks.theme import Theme
from situ_studio.screens.painted import Painted
from situ_studio.screens.painting import DEVICE, layer
from situ_studio.screens.shown import Content, Values, content


class ScreenPreview(QWidget):
    """The screen of the selected state, as wide as the panel, in the shape of the device."""

    clicked = Signal()

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._screen: rbd.Screen | None = None
        self._above: tuple[rbd.Component, ...] = ()
        self._media: Path | None = None
        self._values: Values | None = None
        self._painted = Painted()
        self._made: tuple[tuple[object, ...], Content] | None = None
        self._device = DEVICE
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAccessibleName(self.tr("Picture of the screen"))

    def show_screen(
        self,
        theme: Theme,
        screen: rbd.Screen | None,
        above: tuple[rbd.Component, ...],
        media: Path | None,
        values: Values | None = None,
    ) -> None:
        """values: what references are filled in with; without, texts are as they are written."""
        self._theme, self._screen, self._above, self._media = theme, screen, above, media
        self._values = values
        self.update()

    def show_device(self, device: QSize) -> None:
        """Shows it as on a screen of that size in px."""
        self._device = device
        self.setFixedHeight(self._height(self.width()))
        self.updateGeometry()
        self.update()

    @property
    def device(self) -> QSize:
        """The size of the robot's screen, px."""
        return self._device

    def _height(self, width: int) -> int:
        size = layer(self._device)
        return int(width * size.height() / size.width())

    @property
    def components(self) -> tuple[rbd.Component, ...]:
        """Those of the screen and those that Always adds, back to front."""
        return (*(self._screen.components if self._screen is not None else ()), *self._above)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.setFixedHeight(self._height(event.size().width()))

    def sizeHint(self) -> QSize:
        return QSize(240, self._height(240))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self.rect().contains(event.position().toPoint()):
            self.clicked.emit()

    def paint_screen(self, painter: QPainter, rect: QRectF, screen: rbd.Screen) -> None:
        """Paints a screen as this one is shown."""
        self._painted.paint(painter, rect, self.content_of(screen), self._media, self._device)

    def content_of(self, screen: rbd.Screen) -> Content:
        """What a screen shows beside what Always adds, with the values that are shown.

        Made once while all of them are the very same: most frames show what the one before did.
        """
        of = (screen, self._above, self._values)
        if self._made is None or any(map(is_not, self._made[0], of)):
            self._made = of, content(screen, self._above, self._values)
        return self._made[1]

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        if self._screen is not None:
            self.paint_screen(painter, rect, self._screen)
            painter.setBrush(Qt.BrushStyle.NoBrush)
        else:
            painter.setBrush(self._theme.color("field"))
        painter.setPen(self._theme.color("line_strong"))
        painter.drawRoundedRect(rect, 4, 4)
        if self._screen is None:
            painter.setPen(self._theme.color("text3"))
            wrapped = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(rect.adjusted(8, 8, -8, -8), int(wrapped), self.nothing())
        painter.end()

    def nothing(self) -> str:
        """What stands in place of a screen where there is none."""
        return self.tr("keeps what was shown before")
