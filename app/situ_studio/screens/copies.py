"""Copies of components, within a screen and from one to another. No Qt."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from msgspec.structs import replace

from situ.document import codec, rbd
from situ_studio.screens import placing

BESIDE = 3.0
"""How far a copy lies from what it would cover exactly, percent of the screen."""


def chosen(screen: rbd.Screen, ids: Collection[str]) -> tuple[rbd.Component, ...]:
    """These components, back to front."""
    return tuple(c for c in screen.components if c.id in ids)


def written(components: Sequence[rbd.Component]) -> bytes:
    """Components as a file has them: in the screen of an application's only state."""
    state = rbd.State(no="1", screen=rbd.Screen(components=tuple(components)))
    return codec.write(rbd.Application(name="components", states=(state,)))


def read(data: bytes) -> tuple[rbd.Component, ...]:
    """What ``written`` wrote; nothing where it is anything else."""
    document, problems = codec.read(data, "clipboard") if data.strip() else (None, [])
    if not isinstance(document, rbd.Application) or any(p.severity == "error" for p in problems):
        return ()
    found = [state.screen.components for state in document.states if state.screen is not None]
    return found[0] if len(document.states) == len(found) == 1 else ()


def pasted(
    screen: rbd.Screen | None, components: Sequence[rbd.Component]
) -> tuple[rbd.Screen, tuple[str, ...]]:
    """The screen with copies of these before all others, and their ids.

    An id that is taken gets the next free number. They lie where the originals do, on the screen
    in any case; where they would cover components of the same kind exactly, a little below and to
    the right.
    """
    screen = screen or rbd.Screen()
    taken = {c.id for c in screen.components}
    there = {(c.element, placing.box_of(c)) for c in screen.components}
    boxes = {str(at): placing.inside(placing.box_of(c)) for at, c in enumerate(components)}
    for _ in screen.components:
        if not any((c.element, boxes[str(at)]) in there for at, c in enumerate(components)):
            break
        beside = placing.moved(boxes, BESIDE, BESIDE)
        if beside == boxes:
            # In the lower right corner; there is room at the other end.
            beside = placing.moved(boxes, -100.0, -100.0)
        boxes = beside
    made: list[rbd.Component] = []
    for at, component in enumerate(components):
        id = free_id(component.id, taken)
        taken.add(id)
        made.append(replace(component, id=id, **boxes[str(at)]._asdict()))
    every = (*screen.components, *made)
    return replace(screen, components=every), tuple(c.id for c in made)


def free_id(id: str, taken: Collection[str]) -> str:
    """``id``, or the same word with the first number that is free: ``yes``, ``yes2``, ``yes3``."""
    if id not in taken:
        return id
    word = re.sub(r"\d+$", "", id) or id
    number = 2
    while f"{word}{number}" in taken:
        number += 1
    return f"{word}{number}"
