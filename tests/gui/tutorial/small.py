"""Pictures of the window that are small and can be read: few colours, but some of each hue.

By how often a colour is used alone, the few dots of a sign would become grey.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from PySide6.QtGui import QColor, QImage
from tests.gui import likeness

GROUNDS, GREYS, SHADES = 12, 16, 7
"""Colours that most of a picture has, those without a hue, and those of each hue."""
HUE = 45
"""Degrees of one."""
FAINT = 28
"""Steps of 255 between the most and the least of red, green and blue: below there is no hue."""


def keep(picture: QImage, file: Path) -> None:
    """Writes it as a PNG with a palette."""
    likeness.keep(picture.convertToFormat(QImage.Format.Format_RGB32), file, _palette)


def _palette(counted: Counter[int]) -> list[int]:
    """What most of it has; then of each hue, of colours that are alike the most used one."""
    hues: dict[int | None, dict[int, list[int]]] = {}
    for colour, times in counted.most_common():
        near = hues.setdefault(_hue(QColor(colour)), {})
        near.setdefault(colour & 0xF0F0F0, [colour, 0])[1] += times
    found = [colour for colour, _ in counted.most_common(GROUNDS)]
    for hue, near in hues.items():
        best = sorted(near.values(), key=lambda one: -one[1])
        found += [colour for colour, _ in best[: GREYS if hue is None else SHADES]]
    return list(dict.fromkeys(found))


def _hue(colour: QColor) -> int | None:
    parts = (colour.red(), colour.green(), colour.blue())
    return None if max(parts) - min(parts) < FAINT else colour.hslHue() // HUE
