"""The bar over the designer: on which screen one looks, with which values, and the preview."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QSizePolicy, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice
from situ_studio.panels.tabs import Segments
from situ_studio.screens.devices import DEVICES, USUAL, Device
from situ_studio.widgets.icon_widgets import IconButton, ThemedButton

OWN = "own"
ROOMY = 560
"""Px of the bar in which a sample value has room."""


class DesignerBar(QFrame):
    """device_chosen is told with the device as it stands: lying or upright."""

    device_chosen = Signal(object)
    own_asked = Signal()
    """A person wants to describe a screen."""
    samples_asked = Signal()
    always_shown = Signal(bool)
    preview_asked = Signal()

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self.setFixedHeight(px(44))
        self._device = USUAL
        self._sample = ""
        line = QHBoxLayout(self)
        line.setContentsMargins(12, 0, 12, 0)
        line.setSpacing(8)
        self.devices = Choice(theme, self)
        self.devices.setAccessibleName(self.tr("Screen"))
        self.devices.setToolTip(self.tr("The screen on which you look at what you draw"))
        self.devices.setMinimumWidth(px(96))
        self.devices.setMaximumWidth(px(176))
        self.devices.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.devices.committed.connect(self._on_device)
        line.addWidget(self.devices, 4)
        self.ways = Segments(
            theme,
            (
                ("lying", "landscape", self.tr("Lying")),
                ("upright", "portrait", self.tr("Upright")),
            ),
            self.tr("How the screen stands"),
        )
        for name in ("lying", "upright"):
            button = self.ways.button(name)
            button.setToolTip(button.text())
            button.setText("")
        self.ways.chosen.connect(self._on_way)
        line.addWidget(self.ways)
        self.samples = ThemedButton(theme, "down", self.tr("Sample"), "", "text3", 12)
        self.samples.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
        self.samples.setToolTip(self.tr("The values that texts stand for while you draw"))
        self.samples.setMinimumWidth(px(88))
        self.samples.clicked.connect(self.samples_asked)
        line.addWidget(self.samples)
        self.always = IconButton(theme, "always", self.tr("Show what is in every state"), "text2")
        self.always.setProperty("role", "cell")
        self.always.setFixedSize(px(28), px(28))
        self.always.setCheckable(True)
        self.always.setChecked(True)
        self.always.toggled.connect(self.always_shown)
        line.addWidget(self.always)
        line.addStretch(1)
        self.preview = ThemedButton(theme, "play", self.tr("Preview"), "", "text2", 14)
        self.preview.setToolTip(self.tr("The screen as a person sees and uses it"))
        self.preview.clicked.connect(self.preview_asked)
        line.addWidget(self.preview)
        self.show_device(USUAL)

    def show_device(self, device: Device) -> None:
        """Shows which one is chosen."""
        self._device = device
        every = {one.key: one.upright(device.is_upright) for one in DEVICES}
        every.setdefault(device.key, device)
        own = self.tr("Own size…")
        choices = [(key, one.words) for key, one in every.items()]
        self.devices.offer((*choices, (f"{OWN}…", own)))
        self.devices.show_value(device.key)
        self.ways.show_choice("upright" if device.is_upright else "lying")

    def show_samples(self, words: str) -> None:
        """What stands behind *Sample*: ``user.name = Jack``; "" for none."""
        self._sample = words
        self._fit()
        self.samples.setAccessibleName(self.tr("Sample values: {0}").format(words or "–"))

    def _fit(self) -> None:
        """In a narrow bar the value is in the list only, and the preview's button is its sign."""
        roomy = self.width() >= px(ROOMY)
        words = self._sample if roomy else ""
        self.preview.setText(self.tr("Preview") if roomy else "")
        metrics = self.samples.fontMetrics()
        short = metrics.elidedText(words, Qt.TextElideMode.ElideRight, px(150))
        self.samples.setText(self.tr("Sample  {0}").format(short) if words else self.tr("Sample"))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _on_device(self, key: str) -> None:
        if key == f"{OWN}…":
            self.show_device(self._device)
            self.own_asked.emit()
            return
        found = next((one for one in DEVICES if one.key == key), self._device)
        self.show_device(found.upright(self._device.is_upright))
        self.device_chosen.emit(self._device)

    def _on_way(self, way: str) -> None:
        self.show_device(self._device.upright(way == "upright"))
        self.device_chosen.emit(self._device)
