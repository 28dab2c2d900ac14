"""One difference between two documents or projects, in plain words."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

Kind = Literal["changed", "new", "gone", "order", "moved", "drawing"]


class Change(Struct, frozen=True, kw_only=True):
    """What is different, and where.

    file: path in the project; empty for a document alone. place: the value it is about,
    from the outside in, as ``Problem.place`` names it: in the new document, for what is
    gone in the old one. text: one line, *state Take pills: timeout 30 → 60 s*.
    behaviour: whether the robot may act differently; False for what only people see in
    the editor. kind: ``moved`` is a position on the canvas, ``drawing`` notes, comments
    and colours, ``order`` another place among its like.
    """

    file: str
    place: tuple[str, ...]
    text: str
    behaviour: bool = True
    kind: Kind = "changed"
