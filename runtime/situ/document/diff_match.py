"""By what a comparison recognises the members of a list: number, name, or content."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Mapping, Sequence
from typing import Any

from msgspec.structs import replace

from situ.document import rbd, spds
from situ.document.codec import Document
from situ.document.pairing import Key, pair


def renamed(before: Document, after: Document) -> Mapping[str | None, str | None]:
    """Numbers of states, or names of situations, that are others now: old to new."""
    if isinstance(before, rbd.Application) and isinstance(after, rbd.Application):
        states = pair(before.states, after.states, passes("states", before.states, after.states))
        pairs = ((before.states[b].no, after.states[a].no) for b, a in states.both)
    elif isinstance(before, spds.Spds) and isinstance(after, spds.Spds):
        old, new = before.situations, after.situations
        situations = pair(old, new, passes("situations", old, new))
        pairs = ((old[b].name, new[a].name) for b, a in situations.both)
    else:
        return {}
    return {old_name: new_name for old_name, new_name in pairs if old_name != new_name}


def passes(field: str, old: Sequence[Any], new: Sequence[Any]) -> list[Key[Any]]:
    """The passes of ``pair`` for the members that ``field`` holds, the surest first."""
    if field == "states":
        return _states(old, new)
    ways: list[Key[Any]] = [lambda i, v: (i, v), lambda _, v: v]
    ways += [_by(key) for key in _KEYS.get(field, ())]
    if len(old) == len(new) and field != "situations":
        # Nothing came or went: what is left over was edited where it stands.
        ways.append(lambda i, v: (i, type(v)))
    return ways


def _by(key: Callable[[Any], Hashable | None]) -> Key[Any]:
    return lambda _, value: key(value)


def _states(old: Sequence[rbd.State], new: Sequence[rbd.State]) -> list[Key[rbd.State]]:
    """Number and name, number and content, content, name, number alone. A state that runs a
    part is never one that does not.
    """
    single = _once(old) & _once(new)
    return [
        lambda _, v: (v.no, v.name, v.flow is None) if v.name else None,
        lambda _, v: (v.no, skeleton(v)),
        lambda _, v: (v.name, content(v)) if v.name else None,
        lambda _, v: content(v),
        lambda _, v: (v.name, v.flow is None) if v.name in single else None,
        lambda _, v: (v.no, v.flow is None),
    ]


def _once(states: Sequence[rbd.State]) -> set[str]:
    """Names that only one state has."""
    counted = Counter(state.name for state in states)
    return {name for name, times in counted.items() if name and times == 1}


def skeleton(state: rbd.State) -> rbd.State:
    """A state's content: without its number and name, and without where it leads, which
    changes when other states are renumbered.
    """
    timeout = state.timeout
    return replace(
        state,
        no="",
        name="",
        timeout=None if timeout is None else replace(timeout, next=None),
        events=tuple(replace(event, next=None) for event in state.events),
    )


def content(state: rbd.State) -> rbd.State | None:
    """Its ``skeleton``; None where it has none to be known by."""
    found = skeleton(state)
    return None if found == _EMPTY else found


_EMPTY = rbd.State(no="")

_OWN = {
    rbd.Robot: "resource", rbd.Service: "name", rbd.Message: "topic", rbd.Launch: "program",
    rbd.Sound: "src", rbd.Set: "tag", rbd.Add: "tag", rbd.Append: "tag", rbd.Take: "tag",
    rbd.Clear: "tag",
}  # fmt: skip
"""The field by which one action of a kind is told from others."""


def _own(action: rbd.Action) -> Hashable | None:
    field = _OWN.get(type(action))
    return None if field is None else (type(action), getattr(action, field))


def _plain(action: rbd.Action) -> Hashable | None:
    return None if type(action) in _OWN else action.element


def _named(field: str) -> Callable[[Any], Hashable | None]:
    return lambda value: getattr(value, field) or None


def _unnamed_content(event: rbd.Event) -> Hashable | None:
    found = replace(event, name=None)
    return None if found == rbd.Event() else found


def _situation_content(situation: spds.Situation) -> Hashable | None:
    if situation.condition is None and not situation.entries:
        return None
    return replace(situation, name="")


_KEYS: dict[str, list[Callable[[Any], Hashable | None]]] = {
    "components": [
        lambda v: (type(v), v.id),
        lambda v: replace(v, id=""),
    ],
    "actions": [_own, _plain],
    "events": [
        lambda v: (v.name, v.next, v.when),
        lambda v: (v.name, v.next),
        lambda v: (v.name, v.when),
        lambda v: v.name,
        _unnamed_content,
    ],
    "params": [_named("name")],
    "results": [_named("tag")],
    "observe": [_named("tag")],
    "modules": [_named("name")],
    "situations": [_named("name"), _situation_content],
    "entries": [_named("module")],
    "requires": [lambda v: (v.data, v.module)],
    "provides": [_named("data")],
}
