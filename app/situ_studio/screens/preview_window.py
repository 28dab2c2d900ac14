"""The screen as a person sees it: without marks, as large as the robot's, or as fits."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QDialog, QVBoxLayout, QWidget

from situ_studio.panels.preview import ScreenPreview
from situ_studio.screens.devices import Device
from situ_studio.screens.measures import measures
from situ_studio.theme import Theme

SHARE = 0.94
"""Of the desk's room, at most."""


class PreviewWindow(QDialog):
    """A click, Esc or Enter closes it."""

    def __init__(self, theme: Theme, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Preview, {0}").format(device.words))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.screen_ = ScreenPreview(theme)
        self.screen_.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.screen_.clicked.connect(self.accept)
        self.screen_.show_device(QSize(device.wide, device.high))
        # What lies on a screen that is very high does not fill it.
        column.addStretch(1)
        column.addWidget(self.screen_)
        column.addStretch(1)
        ground = measures().colour("ground").name()
        self.setStyleSheet(f"PreviewWindow {{ background: {ground}; }}")
        self.setFixedSize(fitting(QSize(device.wide, device.high), self._room()))

    def _room(self) -> QSize:
        return self.screen().availableSize() * SHARE

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self.accept()
        else:
            super().keyPressEvent(event)


def fitting(size: QSize, room: QSize) -> QSize:
    """That size, or the largest of its shape that there is room for."""
    scale = min(1.0, room.width() / size.width(), room.height() / size.height())
    return QSize(round(size.width() * scale), round(size.height() * scale))
