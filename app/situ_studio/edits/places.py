"""Places: the way from a document to one of its parts, and back with a change.

A place is what a selection and a ``Problem`` name, from the outside in:
``("state", "5", "event", "0")``, ``("state", "5", "screen", "continue")``,
``("situation", "sound", "entry", "1")``, ``("note", "0")``. States, situations, modules, data and
screen components go by their name, everything else by its position.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, TypeVar, cast

from msgspec import Struct
from msgspec.structs import replace

from situ.document import condition, drawing, modules, rbd, spds
from situ_studio.edits.edit import Document, Place

D = TypeVar("D", bound=Document)

# A word after a value of that type: the attribute, and the attribute that names
# its members (None: by position, "": the attribute is no sequence).
_WORDS: dict[tuple[type, str], tuple[str, str | None]] = {
    (rbd.Application, "always"): ("always", ""),
    (rbd.Application, "state"): ("states", "no"),
    (rbd.State, "timeout"): ("timeout", ""),
    (rbd.State, "screen"): ("screen", ""),
    (rbd.State, "action"): ("actions", None),
    (rbd.State, "event"): ("events", None),
    (rbd.Always, "timeout"): ("timeout", ""),
    (rbd.Always, "screen"): ("screen", ""),
    (rbd.Always, "event"): ("events", None),
    (rbd.Event, "when"): ("when", ""),
    (rbd.Event, "say"): ("says", None),
    (rbd.Event, "action"): ("actions", None),
    (spds.Spds, "data"): ("observe", "tag"),
    (spds.Spds, "module"): ("modules", "name"),
    (spds.Spds, "situation"): ("situations", "name"),
    (spds.Situation, "condition"): ("condition", ""),
    (spds.Situation, "until"): ("until", ""),
    (spds.Situation, "entry"): ("entries", None),
    (spds.Situation, "module"): ("entries", "module"),
    (modules.Modules, "module"): ("modules", "name"),
    (modules.Module, "requires"): ("requires", None),
    (modules.Module, "provides"): ("provides", None),
}
DRAWN: dict[str, type] = {"note": drawing.Note, "frame": drawing.Frame}
"""What is drawn beside the cards; the second word of its place counts those of its kind."""
# Values whose members follow without a word.
_MEMBERS: dict[type, tuple[str, str | None]] = {
    rbd.Screen: ("components", "id"),
    condition.Condition: ("children", None),
    condition.Group: ("children", None),
}
# What actions hold where they can.
_LISTS = {"param": "params", "result": "results"}


class _Link(Struct, frozen=True):
    """One link of the way: ``holder.attribute``, or its member at ``index``.

    named: the place names the member, and does not count.
    """

    holder: Any
    attribute: str
    index: int | None
    named: bool = False


def _way(document: Document, place: Place) -> tuple[list[_Link], Any] | None:
    links: list[_Link] = []
    value: Any = document
    rest = place
    while rest:
        members = _MEMBERS.get(type(value))
        if members is not None:
            attribute, key = members
            name, rest = rest[0], rest[1:]
        else:
            found = _WORDS.get((type(value), rest[0]))
            if found is None and isinstance(value, rbd.Action) and len(rest) > 1:
                word = _LISTS.get(rest[0])
                found = (word, None) if word and hasattr(value, word) else None
            if found is None:
                return None
            attribute, key = found
            if key == "":
                links.append(_Link(value, attribute, None))
                value = getattr(value, attribute)
                rest = rest[1:]
                if value is None:
                    return None
                continue
            if len(rest) < 2:
                return None
            name, rest = rest[1], rest[2:]
        every = getattr(value, attribute)
        if key is None:
            index = int(name) if name.isdigit() and int(name) < len(every) else -1
        else:
            index = next((i for i, m in enumerate(every) if getattr(m, key) == name), -1)
        if index < 0:
            return None
        links.append(_Link(value, attribute, index, key is not None))
        value = every[index]
    return links, value


def _drawn(document: Document, place: Place) -> tuple[int, drawing.Drawn] | None:
    """A note or frame that ``place`` names: its index among all that is drawn, and itself."""
    if len(place) != 2 or place[0] not in DRAWN or not isinstance(document, rbd.Application):
        return None
    every = enumerate(drawing.drawn(document))
    found = [(i, one) for i, one in every if isinstance(one, DRAWN[place[0]])]
    return found[int(place[1])] if place[1].isdigit() and int(place[1]) < len(found) else None


def members(value: Any) -> Iterator[tuple[Place, Any]]:
    """What stands directly in a value, each with the words of a place that lead there."""
    kind = type(value)
    if kind not in _KNOWN:
        _KNOWN[kind] = _inside(kind)
    for attribute, word, key in _KNOWN[kind]:
        held = getattr(value, attribute)
        if key == "":
            if held is not None:
                yield (word,), held
            continue
        for index, member in enumerate(held):
            name = str(index) if key is None else getattr(member, key)
            yield ((word, name) if word else (name,)), member


_KNOWN: dict[type, tuple[tuple[str, str, str | None], ...]] = {}
"""What ``_inside`` found: the tables do not change."""


def _inside(kind: type) -> tuple[tuple[str, str, str | None], ...]:
    """Attribute, word and key of everything that values of a type hold, in the table's order."""
    found: dict[str, tuple[str, str, str | None]] = {}
    for (holder, word), (attribute, key) in _WORDS.items():
        if holder is kind:
            found.setdefault(attribute, (attribute, word, key))
    if kind in _MEMBERS:
        attribute, key = _MEMBERS[kind]
        found[attribute] = (attribute, "", key)
    for word, attribute in _LISTS.items():
        if issubclass(kind, rbd.Action) and attribute in kind.__struct_fields__:
            found[attribute] = (attribute, word, None)
    return tuple(found.values())


def get(document: Document, place: Place) -> Any:
    """The value at ``place``; None where there is none."""
    if place[:1] and place[0] in DRAWN:
        drawn = _drawn(document, place)
        return drawn[1] if drawn is not None else None
    found = _way(document, place)
    return found[1] if found is not None else None


def nearest(document: Document, place: Place) -> Place:
    """The longest beginning of ``place`` at which there is something."""
    while place and get(document, place) is None:
        place = place[:-1]
    return place


def put(document: D, place: Place, value: Any) -> D:
    """The document with the value at ``place`` exchanged; LookupError where there is none.

    ``None`` takes an optional value away (a timeout, a screen) and a member out of its sequence.
    Everything off the way keeps its identity.
    """
    drawn = _drawn(document, place)
    if drawn is not None:
        assert isinstance(document, rbd.Application)
        return cast(D, drawing.exchange(document, drawn[0], value))
    found = _way(document, place)
    if found is None:
        raise LookupError(f"there is nothing at {'/'.join(place)}")
    return cast(D, _put(found[0], value))


def _put(way: list[_Link], value: Any) -> Any:
    for link in reversed(way):
        if link.index is None:
            value = replace(link.holder, **{link.attribute: value})
        else:
            every = list(getattr(link.holder, link.attribute))
            every[link.index : link.index + 1] = [] if value is None else [value]
            value = replace(link.holder, **{link.attribute: tuple(every)})
    return value


def change(document: D, place: Place, **fields: Any) -> D:
    """The document with some fields of the value at ``place`` changed."""
    value = get(document, place)
    if value is None:
        raise LookupError(f"there is nothing at {'/'.join(place)}")
    return put(document, place, replace(value, **fields))


def move(document: D, place: Place, attribute: str, start: int, end: int) -> D:
    """The document with one member of a sequence at another position."""
    every = list(getattr(get(document, place), attribute))
    every.insert(end, every.pop(start))
    return change(document, place, **{attribute: tuple(every)})


def shift(document: D, place: Place, by: int) -> tuple[D, Place]:
    """The document with the member at ``place`` so many further on among its own, and its place
    then; the same where it stands at the end already, or is no member of a sequence.
    """
    found = _way(document, place)
    if found is None or not found[0]:
        return document, place
    *way, last = found[0]
    if last.index is None or not 0 <= last.index + by < len(getattr(last.holder, last.attribute)):
        return document, place
    every, to = list(getattr(last.holder, last.attribute)), last.index + by
    every.insert(to, every.pop(last.index))
    after = cast(D, _put(way, replace(last.holder, **{last.attribute: tuple(every)})))
    return after, place if last.named else (*place[:-1], str(to))


def root(place: Place) -> Place:
    """The card that a place belongs to: ``("state", "5")`` for an event of state 5."""
    return place[:1] if place[:1] == ("always",) else place[:2]


def is_component(place: Place) -> bool:
    """Whether it names a component of a state's screen, or of that of Always."""
    rest = place[len(root(place)) :]
    return len(rest) == 2 and rest[0] == "screen"
