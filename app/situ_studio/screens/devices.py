"""The screens on which a designer looks at what is drawn: their sizes in px and in millimetres."""

from __future__ import annotations

from math import hypot

from msgspec import Struct
from msgspec.structs import replace
from PySide6.QtCore import QSize

from situ.document import care_screen
from situ_studio.screens.painting import layer
from situ_studio.wording.language import tr

INCH = 25.4
"""Millimetres."""
SMALLEST, LARGEST = 240, 7680
"""Px that a side of an own size has."""


class Device(Struct, frozen=True):
    """A screen, seen lying. inches: its diagonal. wide, high: px."""

    key: str
    inches: float
    wide: int
    high: int

    @property
    def is_upright(self) -> bool:
        return self.high > self.wide

    @property
    def words(self) -> str:
        """``10 inch, 1280 × 800``."""
        size = f"{self.wide} × {self.high}"
        if self.key == "phone":
            return tr("Phone, {0}").format(size)
        return tr("{0} inch, {1}").format(f"{self.inches:.0f}", size)

    def turned(self) -> Device:
        """The same, the other way up."""
        return replace(self, wide=self.high, high=self.wide)

    def upright(self, upright: bool) -> Device:
        """The same, upright or lying."""
        return self if self.is_upright == upright else self.turned()

    @property
    def pixel(self) -> float:
        """Millimetres of one px."""
        return self.inches * INCH / hypot(self.wide, self.high)

    def millimetres(self, width: float, height: float) -> tuple[float, float]:
        """How large something is there that has so many percent of what components share."""
        if self == USUAL:
            # As the care lints have it, to the last digit.
            return width * care_screen.WIDE / 100, height * care_screen.HIGH / 100
        shared = layer(QSize(self.wide, self.high)) / 100 * self.pixel
        return width * shared.width(), height * shared.height()


DEVICES = (
    Device("ten", 10.1, 1280, 800),
    Device("seven", 7, 1024, 600),
    Device("thirteen", 13.3, 1920, 1080),
    Device("phone", 6.1, 844, 390),
)
"""The first one is what sizes are judged on (situ.document.care_screen)."""
USUAL = DEVICES[0]


def own(inches: float, wide: int, high: int) -> Device:
    """A screen that a person describes; each side between ``SMALLEST`` and ``LARGEST`` px."""
    wide, high = (min(max(side, SMALLEST), LARGEST) for side in (wide, high))
    return Device("own", min(max(inches, 2.0), 120.0), wide, high)
