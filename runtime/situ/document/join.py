"""What two people made of one document, joined where they do not collide."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

from msgspec import Struct
from msgspec.structs import replace

from situ.document import codec
from situ.document.aside import EDITOR, Aside
from situ.document.catalogue import Catalogue
from situ.document.codec import Document
from situ.document.diff_words import ORDER_COUNTS

_KEYS = {
    "states": "no",
    "components": "id",
    "events": "name",
    "situations": "name",
    "entries": "module",
    "observe": "tag",
    "modules": "name",
    "params": "name",
    "translations": "key",
}
"""By what the members of a list are the same ones, where it is theirs alone."""
_SPOTS = {f"{{{EDITOR}}}x", f"{{{EDITOR}}}y"}


def join(base: Document, mine: Document, theirs: Document) -> Document | None:
    """What became of ``base`` with the changes of ``mine`` and those of ``theirs``; None where
    both changed the same thing, each to another.

    All three are of one kind. A card that both moved stands where ``mine`` has it; comments,
    notes and foreign data are joined as everything else. A result can be written and read
    without errors of its own; whether it fits together with the rest is for ``check`` to say.
    """
    try:
        found = _joined(base, mine, theirs, "")
    except _Collision:
        return None
    read, problems = codec.read(codec.write(found), "")
    return None if any(p.severity == "error" for p in problems) else read


def join_texts(base: Catalogue, mine: Catalogue, theirs: Catalogue) -> Catalogue | None:
    """As ``join``, of two people's translations into one language."""
    try:
        return cast(Catalogue, _joined(base, mine, theirs, ""))
    except _Collision:
        return None


class _Collision(Exception):
    """Both changed the same thing."""


def _joined(base: Any, mine: Any, theirs: Any, field: str) -> Any:
    if _same(mine, theirs) or _same(theirs, base):
        return mine
    if _same(mine, base):
        return theirs
    if isinstance(base, Aside):
        return _aside(base, mine, theirs)
    if isinstance(base, Struct) and type(base) is type(mine) is type(theirs):
        every = base.__struct_fields__
        return replace(
            mine,
            **{
                f: _joined(getattr(base, f), getattr(mine, f), getattr(theirs, f), f) for f in every
            },
        )
    if isinstance(base, tuple) and isinstance(mine, tuple) and isinstance(theirs, tuple):
        return _many(base, mine, theirs, field)
    raise _Collision


def _same(one: Any, other: Any) -> bool:
    """Whether both would be written alike: what ``Aside`` holds counts, but for the place."""
    if one is other:
        return True
    if type(one) is not type(other):
        return False
    if isinstance(one, Struct):
        every = (f for f in one.__struct_fields__ if (type(one), f) != (Aside, "index"))
        return all(_same(getattr(one, f), getattr(other, f)) for f in every)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    return cast(bool, one == other)


def _aside(base: Aside, mine: Aside, theirs: Aside) -> Aside:
    old, own, other = (dict(one.attributes) for one in (base, mine, theirs))
    attributes = {}
    for key in dict.fromkeys((*own, *other)):
        first, then = own.get(key), other.get(key)
        if key in _SPOTS and first is not None:
            value = first if first != old.get(key) or then is None else then
        else:
            value = _joined(old.get(key), first, then, "")
        if value is not None:
            attributes[key] = value
    names = dict.fromkeys(name for one in (mine, theirs) for name, _ in one.parts)
    parts = {n: _joined(base.part(n), mine.part(n), theirs.part(n), "") for n in names}
    return replace(
        mine,
        before=_joined(base.before, mine.before, theirs.before, ""),
        inside=_joined(base.inside, mine.inside, theirs.inside, ""),
        after=_joined(base.after, mine.after, theirs.after, ""),
        attributes=tuple(attributes.items()),
        parts=tuple(parts.items()),
    )


def _many(
    base: tuple[Any, ...], mine: tuple[Any, ...], theirs: tuple[Any, ...], field: str
) -> tuple[Any, ...]:
    key = _KEYS.get(field)
    if key is not None and all(_told_apart(one, key) for one in (base, mine, theirs)):
        return _named(base, mine, theirs, key, field)
    if len(base) == len(mine) == len(theirs):
        return tuple(_joined(b, m, t, "") for b, m, t in zip(base, mine, theirs, strict=True))
    raise _Collision


def _told_apart(every: Sequence[Any], key: str) -> bool:
    names = [getattr(one, key) for one in every]
    return None not in names and len(set(names)) == len(names)


def _named(
    base: tuple[Any, ...], mine: tuple[Any, ...], theirs: tuple[Any, ...], key: str, field: str
) -> tuple[Any, ...]:
    old, own, other = ({getattr(v, key): v for v in every} for every in (base, mine, theirs))
    found = {}
    for name in dict.fromkeys((*old, *own, *other)):
        if name in own and name in other:
            # What both added is the same thing, or a collision.
            found[name] = _joined(old.get(name), own[name], other[name], "")
        elif name not in old:
            found[name] = own.get(name, other.get(name))
        elif name not in own and name not in other:
            continue
        elif not _same(old[name], own.get(name, other.get(name))):
            # Changed by the one, taken away by the other.
            raise _Collision
    return tuple(found[name] for name in _order([*old], [*own], [*other], [*found], field))


def _order(
    old: list[str], own: list[str], other: list[str], kept: list[str], field: str
) -> list[str]:
    """The names of ``kept`` in the order that one of both made of ``old``, what the other added
    behind what it stood behind there."""
    stayed = [name for name in old if name in kept]
    if [name for name in own if name in stayed] == stayed:
        spine, added = other, own
    elif [name for name in other if name in stayed] == stayed:
        spine, added = own, other
    else:
        raise _Collision
    found = [name for name in spine if name in kept]
    for index, name in enumerate(added):
        if name in found or name not in kept:
            continue
        before = next((n for n in reversed(added[:index]) if n in found), None)
        at = found.index(before) + 1 if before is not None else 0
        if ORDER_COUNTS.get(field, False) and at < len(found) and found[at] not in old:
            # Nobody said which of both goes first.
            raise _Collision
        found.insert(at, name)
    return found
