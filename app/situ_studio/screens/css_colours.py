"""Colours as a browser reads them: Qt reads #rrggbbaa otherwise, and no functions."""

from __future__ import annotations

import re
from functools import lru_cache

from PySide6.QtGui import QColor

from situ.document.colours import colour

_HEX = re.compile(
    r"#(?:([0-9a-f])([0-9a-f])([0-9a-f])([0-9a-f])|([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2}))"
)
_CALL = re.compile(r"(rgb|hsl)a?\(\s*([^()]*)\)")


@lru_cache(maxsize=1024)
def css_colour(text: str | None) -> QColor | None:
    """A colour of a designer; None where there is none, or what no browser takes for one.

    Known are names, ``transparent``, hexadecimal ones, ``rgb()`` and ``hsl()``.
    """
    text = (text or "").strip().lower()
    plain = colour(text)
    if plain is not None:
        return QColor(*plain)
    if text == "transparent":
        return QColor(0, 0, 0, 0)
    if (found := _HEX.fullmatch(text)) is not None:
        digits = [one * 2 if len(one) == 1 else one for one in found.groups() if one is not None]
        return QColor(*(int(one, 16) for one in digits))
    called = _CALL.fullmatch(text)
    if called is None:
        return None
    try:
        return _called(called[1], re.split(r"[\s,/]+", called[2].strip()))
    except (ValueError, IndexError):
        return None


def _called(name: str, given: list[str]) -> QColor | None:
    if len(given) not in (3, 4):
        return None
    alpha = min(max(_share(given[3], 1), 0.0), 1.0) if len(given) == 4 else 1.0
    if name == "rgb":
        made = QColor.fromRgbF(*(min(max(_share(one, 255), 0.0), 1.0) for one in given[:3]))
    else:
        hue = float(given[0].removesuffix("deg")) % 360 / 360
        made = QColor.fromHslF(hue, *(min(max(_share(one, 100), 0.0), 1.0) for one in given[1:3]))
    made.setAlphaF(alpha)
    return made


def _share(text: str, whole: float) -> float:
    return float(text[:-1]) / 100 if text.endswith("%") else float(text) / whole
