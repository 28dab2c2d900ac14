"""A place of one version of a document in another version of it. No Qt."""

from __future__ import annotations

from typing import Any

from situ.document.condition import Condition, Group
from situ.document.rbd import Action
from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place

BY_POSITION = frozenset(
    {"event", "action", "entry", "say", "param", "result", "requires", "provides"}
)
"""Words whose members have no name of their own."""


def counterpart(document: Document, place: Place, other: Document) -> Place | None:
    """Where ``other`` has what stands at ``place`` of ``document``; None where it has none.

    What has a name goes by it. Of what has none, it is what is the very same, else what is like it:
    the event of that name, the action of that kind, as many of them standing before it.
    """
    here: Any = document
    there: Any = other
    found: Place = ()
    rest = place
    while rest:
        members = list(places.members(here))
        way = next((way for way, _ in members if rest[: len(way)] == way), None)
        if way is None:
            # Said by a name that no member stands under, as a resource.
            said = (*found, *rest)
            unseen = places.get(document, place) is None
            return said if unseen or places.get(other, said) is not None else None
        met = _met(here, way, there)
        if met is None:
            return None
        here = dict(members)[way]
        there = dict(places.members(there))[met]
        found, rest = (*found, *met), rest[len(way) :]
    return found


def _met(here: Any, way: Place, there: Any) -> Place | None:
    """The member of ``there`` that the member of ``here`` is in another version."""
    if not isinstance(here, (Condition, Group)) and way[0] not in BY_POSITION:
        return way if any(one == way for one, _ in places.members(there)) else None
    mine, theirs = _row(here, way), _row(there, way)
    value = dict(mine)[way]
    for kind in (_itself, _kind):
        wanted = [one for one, member in mine if kind(member) == kind(value)]
        able = [one for one, member in theirs if kind(member) == kind(value)]
        nth = wanted.index(way)
        if nth < len(able):
            return able[nth]
    return None


def _row(holder: Any, way: Place) -> list[tuple[Place, Any]]:
    return [(one, member) for one, member in places.members(holder) if one[:-1] == way[:-1]]


def _itself(member: Any) -> Any:
    return member


def _kind(member: Any) -> Any:
    if isinstance(member, Action):
        return member.element
    for named in ("name", "tag", "module", "data"):
        if hasattr(member, named):
            return type(member), getattr(member, named)
    return type(member)
