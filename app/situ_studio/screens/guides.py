"""Guides that a person has put across the screens of an application. Pure, no Qt.

They stand in its file as ``ed:guides="x12.5 y80"`` of the root element: x of upright ones, y of
lying ones, in percent of the robot's screen, rounded to a tenth, each once and in order. So they
are the same on all its screens, ride along with the document (``situ.document.aside``), and
neither the runtime nor an export knows of them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Literal, NamedTuple

from msgspec.structs import replace

from situ.document.rbd import Application

GUIDES = "guides"
"""The attribute's name."""

Axis = Literal["x", "y"]


class Guide(NamedTuple):
    """One of them: x where it is upright, y where it lies."""

    axis: Axis
    at: float


Guides = tuple[Guide, ...]


def of(application: Application) -> Guides:
    """Every guide of an application, in order; what is written as none is left out."""
    written = application.aside.attribute(GUIDES) or ""
    found = (_read(word) for word in written.split())
    return _sorted(one for one in found if one is not None)


def put(application: Application, guides: Iterable[Guide]) -> Application:
    """The application with these guides; the very same where it has them."""
    wanted = _sorted(guides)
    if wanted == of(application):
        return application
    written = " ".join(f"{one.axis}{one.at:g}" for one in wanted) or None
    return replace(application, aside=application.aside.with_attribute(GUIDES, written))


def at(axis: Axis, value: float) -> Guide:
    """A guide there: on the screen, at a tenth of a percent."""
    return Guide(axis, round(min(max(value, 0.0), 100.0), 1) + 0.0)


def free(guides: Guides, axis: Axis) -> Guide:
    """A new guide in the middle, or beside those that stand there."""
    for far in range(51):
        for value in (50.0 + far, 50.0 - far):
            if Guide(axis, value) not in guides:
                return Guide(axis, value)
    return Guide(axis, 50.0)


def _read(word: str) -> Guide | None:
    try:
        value = float(word[1:])
    except ValueError:
        return None
    if not math.isfinite(value) or not 0 <= value <= 100:
        return None
    if word[0] == "x":
        return at("x", value)
    return at("y", value) if word[0] == "y" else None


def _sorted(guides: Iterable[Guide]) -> Guides:
    return tuple(sorted({at(*one) for one in guides}))
