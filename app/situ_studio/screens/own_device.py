"""The question for a screen of one's own."""

from __future__ import annotations

from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QWidget,
)

from situ_studio.panels.stepped import Stepped, SteppedDecimal
from situ_studio.screens.devices import LARGEST, SMALLEST, Device, own


class OwnDevice(QDialog):
    """Asks for a screen's sides in px and its diagonal in inches."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Own size"))
        form = QFormLayout(self)
        form.setContentsMargins(24, 20, 24, 20)
        form.setSpacing(12)
        self.wide, self.high = Stepped(), Stepped()
        for side, value in ((self.wide, device.wide), (self.high, device.high)):
            side.setRange(SMALLEST, LARGEST)
            side.setSuffix(self.tr(" px"))
            side.setValue(value)
        self.inches = SteppedDecimal()
        self.inches.setRange(2.0, 120.0)
        self.inches.setDecimals(1)
        self.inches.setSuffix(self.tr(" inches"))
        self.inches.setValue(device.inches)
        form.addRow(self.tr("Width"), self.wide)
        form.addRow(self.tr("Height"), self.high)
        form.addRow(self.tr("Diagonal"), self.inches)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.button(QDialogButtonBox.StandardButton.Ok).setDefault(True)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)

    @property
    def device(self) -> Device:
        return own(self.inches.value(), self.wide.value(), self.high.value())


def ask_device(device: Device, parent: QWidget) -> Device | None:
    """The screen that a person describes, beginning with ``device``; None where they leave it."""
    dialog = OwnDevice(device, parent)
    try:
        return dialog.device if dialog.exec() else None
    finally:
        dialog.deleteLater()
