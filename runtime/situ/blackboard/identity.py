"""Who somebody is to a robot with keys."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

KeyRole = Literal["viewer", "module", "operator", "service"]
ROBOT = "robot"
"""Whose key the core's own is."""


class Identity(Struct, frozen=True):
    """Whose key it is. role: the most that he may be; everybody may be a viewer.

    write: patterns of tags that a module may set.
    """

    name: str
    role: KeyRole
    write: tuple[str, ...] = ()
