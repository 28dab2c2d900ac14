"""Which component lies over which: the order in the document, back to front. No Qt."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal

from msgspec.structs import replace

from situ.document import rbd

Way = Literal["front", "forward", "backward", "back"]


def reordered(screen: rbd.Screen, ids: Collection[str], way: Way) -> rbd.Screen:
    """The screen with these components before or behind others; the very same where nothing goes.

    ``front`` and ``back``: all others; ``forward`` and ``backward``: the next one, each. Among
    themselves they stay in their order.
    """
    every = list(screen.components)
    if way in ("front", "back"):
        chosen = [c for c in every if c.id in ids]
        rest = [c for c in every if c.id not in ids]
        every = [*rest, *chosen] if way == "front" else [*chosen, *rest]
    else:
        if way == "forward":
            every.reverse()
        for at in range(1, len(every)):
            if every[at].id in ids and every[at - 1].id not in ids:
                every[at - 1], every[at] = every[at], every[at - 1]
        if way == "forward":
            every.reverse()
    if all(new is old for new, old in zip(every, screen.components, strict=True)):
        return screen
    return replace(screen, components=tuple(every))
