"""The measures and colours of the robot's page, from the table that it reads itself."""

from __future__ import annotations

import re
from functools import lru_cache

from PySide6.QtGui import QColor

from situ.document.colours import luminance
from situ.resources import resource
from situ_studio.screens.css_colours import css_colour

_ENTRY = re.compile(r"--([a-z-]+):\s*([^;]+);")


class Measures:
    """What resources/screen/measures.css says. KeyError for a name that is not in it."""

    def __init__(self, text: str) -> None:
        said = dict(_ENTRY.findall(text))
        self._numbers = {n: float(v) for n, v in said.items() if v[0] not in "#r"}
        self._colours = {n: v for n, v in said.items() if v[0] in "#r"}

    def __getitem__(self, name: str) -> float:
        return self._numbers[name]

    def colour(self, name: str) -> QColor:
        found = css_colour(self._colours[name])
        assert found is not None
        return found

    def least(self, name: str, unit: float) -> float:
        """px of a measure in units, no less than its own ``-least``."""
        return max(self[f"{name}-least"], self[name] * unit)


@lru_cache(maxsize=1)
def measures() -> Measures:
    """The table."""
    return Measures(resource("screen", "measures.css").read_text("utf-8"))


def is_light(colour: QColor | None) -> bool:
    """Whether dark letters are easier to read on this than white ones (colours.js)."""
    if colour is None or colour.alphaF() < 0.5:
        return True
    return luminance((colour.red(), colour.green(), colour.blue())) > measures()["light"]
