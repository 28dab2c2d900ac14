"""A script as a picture: data, conditions, situations, modules and resources in five columns. Pure.

Where things stand is ours, not the file's (``script_layout``). The same document always gives the
same picture.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from situ.document import words
from situ.document.condition import Condition
from situ.document.problem import Problem
from situ.document.spds import Entry, Observed, Situation, Spds
from situ_studio import kinds, places
from situ_studio.canvas.problem_marks import NONE, Mark
from situ_studio.canvas.script_faces import (
    IN,
    LEFT,
    LOW,
    OUT,
    PITCH,
    TOP,
    UNTIL,
    Inherited,
    ScriptLink,
    ScriptNode,
    ScriptPicture,
    uid,
)
from situ_studio.canvas.script_gestures import note_of
from situ_studio.canvas.script_layout import Tier, spread, tiers
from situ_studio.canvas.script_rows import Shapes
from situ_studio.edit import Place
from situ_studio.language import say, tr, translated

LAST = 1e6
"""Below all others."""


def picture(
    script: Spds, problems: Sequence[Problem] = (), shapes: Shapes | None = None
) -> ScriptPicture:
    """Nodes and pipes of the whole script, the nodes in the order of reading.

    shapes: what is known of the conditions of the value before.
    """
    shapes = shapes if shapes is not None else Shapes()
    shapes.begin()
    return _Drawing(script, _marks(problems, script), shapes).picture()


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


class _Drawing:
    """One script while it becomes a picture."""

    def __init__(self, script: Spds, marks: Mapping[Place, Mark], shapes: Shapes) -> None:
        self._script = script
        self._shapes = shapes
        self._marks = marks
        self._observed = {o.tag: o for o in script.observe}
        self._cards: dict[str, ScriptNode] = {}
        self._links: dict[tuple[str, ...], ScriptLink] = {}
        self._uids: dict[Place, str] = {}
        self._used_by: dict[str, list[float]] = {}
        self._asked_by: dict[str, list[float]] = {}

    def picture(self) -> ScriptPicture:
        every = list(
            zip(keyed(self._script), tiers(self._script.situations, self._shapes), strict=True)
        )
        for (situation, _), tier in every:
            first, second = (self._shapes.of(c) for c in (situation.condition, situation.until))
            for index, (test, _) in enumerate((*first.tests, *second.tests)):
                at = tier.top + index
                self._used_by.setdefault(datum(test.tag, self._observed), []).append(at)
            for entry in situation.entries:
                self._asked_by.setdefault(entry.module, []).append(tier.situation[0])
        self._add_data()
        for number, ((situation, key), tier) in enumerate(every, start=1):
            self._add_condition(situation.condition, situation, key, tier)
            self._add_condition(situation.until, situation, key, tier, until=True)
            self._add_situation(situation, key, number, tier)
        self._add_modules()
        for situation, key in keyed(self._script):
            self._add_priorities(situation, key)
        return ScriptPicture(self._cards, self._links, self._uids)

    def _add(self, node: ScriptNode) -> None:
        self._cards[node.uid] = node
        self._uids.setdefault(node.place, node.uid)

    def _link(self, made: ScriptLink) -> None:
        self._links.setdefault(made.id, made)

    # -- from left to right --------------------------------------------------------------

    def _add_data(self) -> None:
        # Every tag: observed ones in the file's order, then those only used.
        every = dict.fromkeys([*self._observed, *self._used_by])
        wanted = [(tag, _mean(self._used_by.get(tag, ()), LAST)) for tag in every]
        # In rows, so that most pipes are straight.
        tops = spread([(tag, y) for tag, y in wanted if y < LAST], PITCH, in_rows=True)
        below = max(tops.values(), default=TOP - PITCH) + PITCH
        for tag, y in wanted:
            if y >= LAST:
                tops[tag] = below
                below += PITCH
        for tag in sorted(every, key=lambda tag: tops[tag]):
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
        condition: Condition | None,
        situation: Situation,
        key: str,
        tier: Tier,
        until: bool = False,
    ) -> None:
        shape = self._shapes.of(condition)
        if condition is None or not shape.rows:
            return
        word = "until" if until else "condition"
        place: Place = ("situation", situation.name, word)
        top, height = tier.until if until else tier.condition
        self._add(
            ScriptNode(
                uid=uid(word, key),
                place=place,
                kind="condition",
                name=situation.name,
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
        self._link(ScriptLink(uid(word, key), OUT, goal, UNTIL if until else IN, "holds"))
        for test, rest in shape.tests:
            source = uid("data", datum(test.tag, self._observed))
            entry = "/".join(rest)
            where = (*place, *rest)
            self._link(ScriptLink(source, OUT, uid(word, key), entry, "observes", where))

    def _add_situation(self, situation: Situation, key: str, number: int, tier: Tier) -> None:
        place: Place = ("situation", situation.name)
        extends = tr("extends {0}").format(situation.extends) if situation.extends else ""
        always = situation.condition is None or not situation.condition.children
        top, height = tier.situation
        self._add(
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
                number=number,
                wrong=self._marks.get(place, NONE),
                note=note_of(situation),
            )
        )

    def _add_modules(self) -> None:
        every = modules(self._script)
        last = max((y for ys in self._asked_by.values() for y in ys), default=TOP)
        wanted = [(m, _mean(self._asked_by.get(m, ()), last)) for m in every]
        tops = spread(wanted, 60)
        needed: dict[str, list[float]] = {}
        for name, top in tops.items():
            for resource in every[name] or ():
                needed.setdefault(resource, []).append(top)
        for name in sorted(every, key=lambda name: tops[name]):
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
                    note=next((note_of(m) for m in self._script.modules if m.name == name), ""),
                )
            )
        for name, top in spread([(r, _mean(ys, TOP)) for r, ys in needed.items()], 56).items():
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
                self._link(ScriptLink(source, OUT, goal, IN, "uses", place))

    def _add_priorities(self, situation: Situation, key: str) -> None:
        for number, entry in enumerate(situation.entries):
            where = ("situation", situation.name, "entry", str(number))
            self._link(
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


def _mean(values: Sequence[float], otherwise: float) -> float:
    return sum(values) / len(values) if values else otherwise


def _marks(problems: Iterable[Problem], script: Spds) -> dict[Place, Mark]:
    """Marks by place: of nodes, and of entries for their pills, of a tie both."""
    marks: dict[Place, Mark] = {}
    for problem in sorted(problems, key=lambda one: one.severity):
        place = problem.place
        if place[:1] == ("situation",) and len(place) > 3 and place[2] == "entry":
            root = place[:4]
        elif place[:1] == ("situation",) and len(place) > 2 and place[2] in ("condition", "until"):
            root = place[:3]
        else:
            root = place[:2]
        roots = [root] if root else []
        if problem.code == "tie":
            roots += _tied_with(script, place)
        for one in roots:
            before = marks.get(one, NONE)
            if problem.message not in before.messages:
                messages = (*before.messages, problem.message)
                marks[one] = Mark(before.sign or problem.severity, messages)
    return marks


def _tied_with(script: Spds, place: Place) -> list[Place]:
    """The other entries of a tie: those of the same priority in the situation, which can use
    something that the first can use."""
    situation = script.situation(place[1])
    mine = places.get(script, place[:4]) if len(place) > 3 else None
    if situation is None or not isinstance(mine, Entry):
        return []
    uses = {m.name: set(m.resources) for m in script.modules}
    nothing: set[str] = set()
    return [
        ("situation", place[1], "entry", str(number))
        for number, entry in enumerate(situation.entries)
        if entry.module != mine.module
        and entry.priority == mine.priority
        # What a module declares elsewhere is not known here.
        and (
            not {mine.module, entry.module} <= uses.keys()
            or uses.get(mine.module, nothing) & uses.get(entry.module, nothing)
        )
    ]
