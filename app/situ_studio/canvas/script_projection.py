"""A script as a picture: data, conditions, situations, modules and resources in five columns. Pure.

Where things stand is ours, not the file's (``script_layout``). The same document always gives the
same picture, but for cards that keep the place where they were.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TypeVar

from msgspec import Struct
from msgspec.structs import replace

from situ.document import words
from situ.document.condition import Condition
from situ.document.problem import Problem
from situ.document.spds import Observed, Situation, Spds
from situ_studio import kinds
from situ_studio.canvas.problem_marks import NONE, Mark
from situ_studio.canvas.script_faces import (
    IN,
    LEFT,
    LOW,
    OUT,
    PITCH,
    UNTIL,
    Inherited,
    ScriptLink,
    ScriptNode,
    ScriptPicture,
    uid,
)
from situ_studio.canvas.script_layout import Columns, Tier, tiers
from situ_studio.canvas.script_marks import marks_of
from situ_studio.canvas.script_rows import Shapes
from situ_studio.edits.edit import Place
from situ_studio.edits.notes import note_of
from situ_studio.wording.language import say, tr, translated


def picture(script: Spds, problems: Sequence[Problem] = ()) -> ScriptPicture:
    """Nodes and pipes of the whole script, the nodes in the order of reading."""
    return ScriptProjector().picture(script, problems)


def named(values: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Each name with what tells doubled ones apart."""
    seen: dict[str, int] = {}
    for name in values:
        count = seen[name] = seen.get(name, 0) + 1
        yield name, (name if count == 1 else f"{name}  {count}")


def keyed(script: Spds) -> list[tuple[Situation, str]]:
    """Every situation with what its node goes by."""
    names = named(situation.name for situation in script.situations)
    return [(s, key) for s, (_, key) in zip(script.situations, names, strict=True)]


def datum(tag: str, observed: Mapping[str, object]) -> str:
    """The observed tag that a test's name looks into, or the name itself."""
    parts = tag.split(".")
    for count in range(len(parts), 0, -1):
        head = ".".join(parts[:count])
        if head in observed:
            return head
    return tag


def modules(script: Spds) -> dict[str, tuple[str, ...] | None]:
    """Every module of the picture with its resources; None for one that only has priorities."""
    found: dict[str, tuple[str, ...] | None] = {m.name: m.resources for m in script.modules}
    for situation in script.situations:
        for entry in situation.entries:
            found.setdefault(entry.module, None)
    return found


def inherited(script: Spds, situation: Situation, key: str) -> list[Inherited]:
    """The priorities that a situation takes over, by module in the order of the file."""
    own = {e.module for e in situation.entries}
    return [
        Inherited(uid("situation", key), uid("module", m), p, situation.name, m)
        for m, p in script.priorities(situation).items()
        if m not in own
    ]


class ScriptProjector:
    """Makes pictures of one script after the other: what did not change is the same value, and
    stands where it stood."""

    def __init__(self) -> None:
        self.columns = Columns()
        self._shapes = Shapes()
        self._bands: dict[str, _Band] = {}
        self._around: object = None
        self._picture = ScriptPicture({}, {}, {})

    def picture(self, script: Spds, problems: Sequence[Problem] = ()) -> ScriptPicture:
        marks = marks_of(problems, script)
        self._shapes.begin()
        # What a situation's nodes and pipes depend on beside itself and its place.
        around = marks, [data.tag for data in script.observe]
        drawing = _Drawing(script, marks, self._shapes, self._picture)
        bands = drawing.bands(self._bands if around == self._around else {})
        drawing.add_data(self.columns)
        drawing.add_bands(bands)
        drawing.add_modules(self.columns)
        self._bands, self._around, self._picture = bands, around, drawing.made
        return drawing.made


class _Band(Struct):
    """What one situation at its place adds to a picture."""

    situation: Situation
    number: int
    top: float
    cards: dict[str, ScriptNode]
    links: dict[tuple[str, ...], ScriptLink]

    def add(self, node: ScriptNode) -> None:
        self.cards[node.uid] = node

    def link(self, made: ScriptLink) -> None:
        self.links.setdefault(made.id, made)

    def moved(self, number: int, top: float) -> _Band:
        """The same situation at another place."""
        if (number, top) == (self.number, self.top):
            return self
        down = top - self.top
        cards = {
            uid: replace(node, y=node.y + down, number=number if node.number else 0)
            for uid, node in self.cards.items()
        }
        return _Band(self.situation, number, top, cards, self.links)


class _Drawing:
    """One script while it becomes a picture. before: the picture of the script before."""

    def __init__(
        self, script: Spds, marks: Mapping[Place, Mark], shapes: Shapes, before: ScriptPicture
    ) -> None:
        self.made = ScriptPicture({}, {}, {})
        self._script = script
        self._shapes = shapes
        self._marks = marks
        self._before = before
        self._tiers = tiers(script.situations, shapes)
        self._observed = {o.tag: o for o in script.observe}
        self._declared = {m.name: m for m in reversed(script.modules)}

    def bands(self, before: Mapping[str, _Band]) -> dict[str, _Band]:
        """By what the situations' nodes go by; those of before that are still right."""
        made: dict[str, _Band] = {}
        every = zip(keyed(self._script), self._tiers, strict=True)
        for number, ((situation, key), tier) in enumerate(every, start=1):
            band = before.get(key)
            if band is not None and band.situation is situation:
                band = band.moved(number, tier.top)
            else:
                band = _Band(situation, number, tier.top, {}, {})
                self._add_condition(band, situation.condition, key, tier)
                self._add_condition(band, situation.until, key, tier, until=True)
                self._add_situation(band, key, tier)
                self._add_priorities(band, key)
                for name, node in band.cards.items():
                    band.cards[name] = _same(self._before.cards.get(name), node)
                for id, link in band.links.items():
                    band.links[id] = _same(self._before.links.get(id), link)
            made[key] = band
        return made

    def add_bands(self, bands: Mapping[str, _Band]) -> None:
        made = self.made
        for band in bands.values():
            made.cards.update(band.cards)
            made.links.update(band.links)
            for node in band.cards.values():
                made.uids.setdefault(node.place, node.uid)

    def _add(self, node: ScriptNode) -> None:
        self.made.cards[node.uid] = _same(self._before.cards.get(node.uid), node)
        self.made.uids.setdefault(node.place, node.uid)

    # -- from left to right --------------------------------------------------------------

    @cached_property
    def _used_by(self) -> dict[str, list[float]]:
        """Data to the heights at which something looks at it."""
        found: dict[str, list[float]] = {tag: [] for tag in self._observed}
        for situation, tier in zip(self._script.situations, self._tiers, strict=True):
            first, second = (self._shapes.of(c) for c in (situation.condition, situation.until))
            for index, (test, _) in enumerate((*first.tests, *second.tests)):
                found.setdefault(datum(test.tag, self._observed), []).append(tier.top + index)
        return found

    @cached_property
    def _asked_by(self) -> dict[str, list[float]]:
        """Modules to the heights of the situations that give them a priority."""
        found: dict[str, list[float]] = {}
        for situation, tier in zip(self._script.situations, self._tiers, strict=True):
            for entry in situation.entries:
                found.setdefault(entry.module, []).append(tier.situation[0])
        return found

    def add_data(self, columns: Columns) -> None:
        # Every tag: observed ones in the file's order, then those only used.
        every, wanted = list(self._used_by), self._used_by.get
        # In rows, so that most pipes are straight.
        tops = columns.place("data", every, lambda tag: _mean(wanted(tag)), PITCH, in_rows=True)
        for tag in sorted(every, key=tops.__getitem__):
            place: Place = ("data", tag)
            self._add(
                ScriptNode(
                    uid=uid("data", tag),
                    place=place,
                    kind="data",
                    name=tag,
                    x=LEFT["data"],
                    y=tops[tag],
                    detail=_type(self._observed.get(tag)),
                    wrong=self._marks.get(place, NONE),
                    note=note_of(self._observed[tag]) if tag in self._observed else "",
                )
            )

    def _add_condition(
        self,
        band: _Band,
        condition: Condition | None,
        key: str,
        tier: Tier,
        until: bool = False,
    ) -> None:
        shape = self._shapes.of(condition)
        if condition is None or not shape.rows:
            return
        word = "until" if until else "condition"
        place: Place = ("situation", band.situation.name, word)
        top, height = tier.until if until else tier.condition
        band.add(
            ScriptNode(
                uid=uid(word, key),
                place=place,
                kind="condition",
                name=band.situation.name,
                x=LEFT["condition"],
                y=top,
                height=height,
                rows=shape.rows,
                joint=shape.joint,
                joined=(*place, "0") if shape.whole else (),
                until=until,
                wrong=self._marks.get(place, NONE),
                note=note_of(condition),
            )
        )
        goal = uid("situation", key)
        band.link(ScriptLink(uid(word, key), OUT, goal, UNTIL if until else IN, "holds"))
        for test, rest in shape.tests:
            source = uid("data", datum(test.tag, self._observed))
            entry = "/".join(rest)
            where = (*place, *rest)
            band.link(ScriptLink(source, OUT, uid(word, key), entry, "observes", where))

    def _add_situation(self, band: _Band, key: str, tier: Tier) -> None:
        situation = band.situation
        place: Place = ("situation", situation.name)
        extends = tr("extends {0}").format(situation.extends) if situation.extends else ""
        always = situation.condition is None or not situation.condition.children
        top, height = tier.situation
        band.add(
            ScriptNode(
                uid=uid("situation", key),
                place=place,
                kind="situation",
                name=situation.name,
                x=LEFT["situation"],
                y=top,
                height=height,
                extends=extends or (tr("always") if always else ""),
                times=_times(situation),
                number=band.number,
                wrong=self._marks.get(place, NONE),
                note=note_of(situation),
            )
        )

    def _add_priorities(self, band: _Band, key: str) -> None:
        for number, entry in enumerate(band.situation.entries):
            where = ("situation", band.situation.name, "entry", str(number))
            band.link(
                ScriptLink(
                    uid("situation", key),
                    OUT,
                    uid("module", entry.module),
                    IN,
                    "priority",
                    place=where,
                    priority=entry.priority,
                    none=entry.priority is None,
                    wrong=self._marks.get(where, NONE),
                )
            )

    def add_modules(self, columns: Columns) -> None:
        """With what they use."""
        every = modules(self._script)
        tops = columns.place("module", list(every), lambda m: _mean(self._asked_by.get(m)), 60)
        needed: dict[str, list[float]] = {}
        for name, top in tops.items():
            for resource in every[name] or ():
                needed.setdefault(resource, []).append(top)
        for name in sorted(every, key=tops.__getitem__):
            place: Place = ("module", name)
            self._add(
                ScriptNode(
                    uid=uid("module", name),
                    place=place,
                    kind="module",
                    name=name,
                    x=LEFT["module"],
                    y=tops[name],
                    height=LOW,
                    detail="" if every[name] is not None else tr("not declared"),
                    wrong=self._marks.get(place, NONE),
                    note=note_of(self._declared[name]) if name in self._declared else "",
                )
            )
        tops = columns.place("resource", list(needed), lambda r: _mean(needed[r]), 56)
        for name, top in tops.items():
            self._add(
                ScriptNode(
                    uid=uid("resource", name),
                    place=("resource", name),
                    kind="resource",
                    name=name,
                    x=LEFT["resource"],
                    y=top,
                    height=LOW,
                )
            )
        for name, resources in every.items():
            for resource in dict.fromkeys(resources or ()):
                place = ("module", name, "resource", resource)
                source, goal = uid("module", name), uid("resource", resource)
                made = ScriptLink(source, OUT, goal, IN, "uses", place)
                self.made.links[made.id] = _same(self._before.links.get(made.id), made)


Value = TypeVar("Value")


def _same(before: Value | None, now: Value) -> Value:
    """The very value of before where it is equal, so that it is not shown anew."""
    return before if before is not None and before == now else now


def _type(known: Observed | None) -> str:
    if known is None:
        return tr("not observed")
    named_type = dict(kinds.TYPES).get(known.type or "")
    return known.unit or (translated(named_type) if named_type else tr("any value"))


def _times(situation: Situation) -> str:
    told = []
    if situation.dwell is not None:
        told.append(tr("stays {0} at least").format(words.seconds(situation.dwell, say)))
    if situation.limit is not None:
        told.append(tr("ends after {0}").format(words.seconds(situation.limit, say)))
    return ", ".join(told)


def _mean(values: Sequence[float] | None) -> float | None:
    return sum(values) / len(values) if values else None
