"""The robot's screen in the middle of the designer: to scale, in a frame, on a dotted ground."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QBrush, QMouseEvent, QPainter, QPaintEvent, QPixmap, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.sheet import Sheet
from situ_studio.theme import Theme

AROUND, ABOVE = 24, 36
"""Px of ground beside and below the frame, and above it, where the names stand."""
MOST = 1.5
"""Px of the window for one of the device."""
STEP = 16
"""Px between two dots of the ground."""
BEZEL = "#2B313C"
"""The frame of the device, the same in both themes but for the line round it."""


class DeviceGround(QWidget):
    """Holds the sheet: as large as there is room, at most ``MOST`` of the device's own px."""

    pressed = Signal()
    """The ground beside the device was clicked."""
    zoomed = Signal(float)
    """The sheet is of another size: px of the window for one of the device."""

    def __init__(self, theme: Theme, sheet: Sheet, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._sheet = sheet
        self._device = USUAL
        self._dots: QPixmap | None = None
        sheet.setParent(self)
        self.setMinimumSize(200, 160)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._zoom = QLabel(self)
        self._zoom.setProperty("role", "hint")
        self._zoom.setToolTip(self.tr("How large the screen is drawn here"))

    @property
    def zoom(self) -> float:
        """Px of the window for one of the device."""
        return self._sheet.width() / self._device.wide

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self._dots = None
        self.update()

    def show_device(self, device: Device) -> None:
        self._device = device
        self._lay_out()

    def _bezel(self, wide: float) -> int:
        return max(7, round(wide * 0.017))

    def _lay_out(self) -> None:
        room_wide, room_high = self.width() - 2 * AROUND, self.height() - AROUND - ABOVE
        # The frame takes its share of the room too.
        scale = min(room_wide / self._device.wide, room_high / self._device.high) * 0.962
        wide = max(80, round(self._device.wide * min(scale, MOST)))
        high = wide * self._device.high // self._device.wide
        left = (self.width() - wide) // 2
        top = ABOVE + max(0, (room_high - high) // 2)
        self._sheet.setGeometry(QRect(left, top, wide, high))
        self._zoom.setText(self.tr("{0} %").format(round(self.zoom * 100)))
        self._zoom.adjustSize()
        self._zoom.move(self.width() - self._zoom.width() - 12, self.height() - 20)
        self.zoomed.emit(self.zoom)
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
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        sheet = QRectF(self._sheet.geometry())
        rim = self._bezel(sheet.width())
        frame = sheet.adjusted(-rim, -rim, rim, rim)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("shadow"))
        painter.drawRoundedRect(frame.translated(0, 3), rim + 2, rim + 2)
        painter.setPen(self._theme.color("line_strong"))
        painter.setBrush(BEZEL)
        painter.drawRoundedRect(frame, rim + 2, rim + 2)
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
