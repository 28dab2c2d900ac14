"""States as values: which do the same, where their ways lead, and what only a file has."""

from __future__ import annotations

from typing import Any, TypeVar

from msgspec import Struct
from msgspec.structs import replace

from situ.document.aside import NOTHING, Aside
from situ.document.rbd import AGAIN, BACK, State

Bare = TypeVar("Bare")


def merged(paths: list[str], states: list[State]) -> list[int]:
    """By state: the number of the first that does the same, whatever happens."""
    targets: list[list[int]] = []
    first: dict[Any, int] = {}
    blocks: list[int] = []
    for number, (path, state) in enumerate(zip(paths, states, strict=True)):
        found: list[int] = []
        local = retargeted(state, lambda to, f=found: _noted(to, f))
        targets.append(found)
        blocks.append(first.setdefault((path, local), number))
    while True:
        first = {}
        finer = [
            first.setdefault((block, tuple(blocks[to] for to in targets[number])), number)
            for number, block in enumerate(blocks)
        ]
        if len(set(finer)) == len(set(blocks)):
            return finer
        blocks = finer


def _noted(to: str, found: list[int]) -> str:
    if to in (AGAIN, BACK):
        return to
    found.append(int(to))
    return ""


def retargeted(state: State, name: Any) -> State:
    """The state with every ``next`` replaced by what ``name`` gives for it."""
    timeout = state.timeout
    if timeout is not None and timeout.next is not None:
        timeout = replace(timeout, next=name(timeout.next))
    events = tuple(
        event if event.next is None else replace(event, next=name(event.next))
        for event in state.events
    )
    return replace(state, timeout=timeout, events=events)


def bare(value: Bare) -> Bare:
    """A value without comments, foreign XML and places in a file."""
    if isinstance(value, tuple):
        return tuple(bare(one) for one in value)  # type: ignore[return-value]
    assert isinstance(value, Struct)
    held = {name: getattr(value, name) for name in value.__struct_fields__}
    return replace(
        value,
        **{
            name: NOTHING if isinstance(one, Aside) else bare(one)
            for name, one in held.items()
            if isinstance(one, (Struct, tuple))
        },
    )
