"""The robot's screen in the middle of the designer: to scale, in a frame, on a dotted ground."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QMouseEvent, QPainter, QPaintEvent, QPixmap, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.measures import measures
from situ_studio.screens.painting import layer
from situ_studio.screens.rulers import WIDE, Ruler
from situ_studio.screens.sheet import Sheet

AROUND, ABOVE = 24, 36
"""Px of ground beside and below the frame, and above it, where the names stand."""
MOST = 1.5
"""Px of the window for one of the device."""
RIM = 0.017
"""The frame's width beside the screen's."""
STEP = 16
"""Px between two dots of the ground."""
BEZEL = "#2B313C"
"""The frame of the device, the same in both themes but for the line round it."""


class DeviceGround(QWidget):
    """Holds the sheet: as large as there is room, at most ``MOST`` of the device's own px."""

    laid_out = Signal()
    """The screen lies elsewhere, or is larger or smaller."""
    pressed = Signal()
    """The ground beside the device was clicked."""

    def __init__(self, theme: Theme, sheet: Sheet, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._sheet = sheet
        self._device = USUAL
        self._dots: QPixmap | None = None
        self.lit = QRect()
        """Where the device shows something, in px of the ground."""
        sheet.setParent(self)
        self.rulers = Ruler("x", theme, self), Ruler("y", theme, self)
        self.setMinimumSize(px(200), px(160))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._zoom = QLabel(self)
        self._zoom.setProperty("role", "hint")
        self._zoom.setToolTip(self.tr("How large the screen is drawn here"))

    @property
    def zoom(self) -> float:
        """Px of the window for one of the device."""
        return self._sheet.width() / self._device.wide

    @property
    def room(self) -> QRect:
        """What the rulers leave."""
        return self.rect().adjusted(px(WIDE), px(WIDE), 0, 0)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for ruler in self.rulers:
            ruler.set_theme(theme)
        self._dots = None
        self.update()

    def show_device(self, device: Device) -> None:
        self._device = device
        self._lay_out()

    def _lay_out(self) -> None:
        device, room = self._device, self.room.adjusted(AROUND, px(ABOVE), -AROUND, -AROUND)
        scale = min(
            room.width() / (device.wide * (1 + 2 * RIM)),
            room.height() / (device.high + 2 * RIM * device.wide),
            MOST,
        )
        wide = max(80, int(device.wide * scale))
        self.lit = QRect(0, 0, wide, wide * device.high // device.wide)
        self.lit.moveCenter(room.center())
        # What lies on a screen that is very high does not fill it.
        shared = layer(QSize(device.wide, device.high))
        high = int(wide * shared.height() / shared.width())
        self._sheet.setFixedSize(wide, high)
        self._sheet.move(self.lit.x(), self.lit.y() + (self.lit.height() - high) // 2)
        self._zoom.setText(self.tr("{0} %").format(round(self.zoom * 100)))
        self._zoom.adjustSize()
        self._zoom.move(self.width() - self._zoom.width() - 12, self.height() - 20)
        above, beside = self.rulers
        above.setGeometry(self.room.left(), 0, self.room.width(), px(WIDE))
        beside.setGeometry(0, self.room.top(), px(WIDE), self.room.height())
        above.show_screen(self._sheet.x() - above.x(), wide)
        beside.show_screen(self._sheet.y() - beside.y(), high)
        self.laid_out.emit()
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._lay_out()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.pressed.emit()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self._theme.color("canvas"))
        painter.fillRect(self.rect(), QBrush(self._dotted()))
        painter.fillRect(0, 0, px(WIDE), px(WIDE), self._theme.color("card"))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        lit = QRectF(self.lit)
        rim = max(7, round(lit.width() * RIM))
        frame = lit.adjusted(-rim, -rim, rim, rim)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("shadow"))
        painter.drawRoundedRect(frame.translated(0, 3), rim + 2, rim + 2)
        painter.setPen(self._theme.color("line_strong"))
        painter.setBrush(BEZEL)
        painter.drawRoundedRect(frame, rim + 2, rim + 2)
        if lit.height() > self._sheet.height() + 2:
            painter.fillRect(lit, measures().colour("ground"))
        painter.end()

    def _dotted(self) -> QPixmap:
        if self._dots is None:
            ratio = self.devicePixelRatioF()
            self._dots = QPixmap(round(STEP * ratio), round(STEP * ratio))
            self._dots.setDevicePixelRatio(ratio)
            self._dots.fill(Qt.GlobalColor.transparent)
            painter = QPainter(self._dots)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self._theme.color("dots"))
            painter.drawEllipse(QPointF(STEP / 2, STEP / 2), 0.9, 0.9)
            painter.end()
        return self._dots
