"""A script as a picture: data, conditions, situations, modules and resources in five columns. Pure.

Where things stand is ours, not the file's: situations in precedence from top to
bottom, everything else near what it belongs to, in the measures of
mockups/script-light.png. The same document always gives the same picture.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Literal

from msgspec import Struct

from situ.document import words
from situ.document.condition import Condition, Group, Test
from situ.document.problem import Problem
from situ.document.spds import Observed, Situation, Spds
from situ_studio import kinds
from situ_studio.edit import Place
from situ_studio.language import say, tr, translated

Kind = Literal["data", "condition", "situation", "module", "resource"]
Mark = Literal["", "warning", "error"]

LEFT: dict[str, float] = {
    "data": 16,
    "condition": 218,
    "situation": 426,
    "module": 698,
    "resource": 870,
}
WIDTH: dict[str, float] = {
    "data": 166,
    "condition": 180,
    "situation": 160,
    "module": 124,
    "resource": 100,
}
TITLES: dict[str, str] = {
    "data": "Data",
    "condition": "Conditions",
    "situation": "Situations, first that holds",
    "module": "Modules",
    "resource": "Resources",
}
TOP = 44.0
TALL, LOW = 52.0, 44.0
PITCH = 72.0
LINE = 18.0
OUT, IN = "out", "in"


class ScriptNode(Struct, frozen=True):
    """What one node shows. lines: a condition's tests; number: a situation's precedence."""

    uid: str
    place: Place
    kind: Kind
    name: str
    x: float
    y: float
    height: float = TALL
    detail: str = ""
    lines: tuple[str, ...] = ()
    joint: str = ""
    number: int = 0
    mark: Mark = ""

    @property
    def width(self) -> float:
        return WIDTH[self.kind]

    @property
    def no(self) -> str:
        return self.name

    @property
    def many(self) -> bool:
        return True

    @property
    def inputs(self) -> tuple[str, ...]:
        if self.kind == "data":
            return ()
        if self.kind == "condition":
            return tuple(str(i) for i in range(len(self.lines)))
        return (IN,)

    @property
    def outputs(self) -> tuple[str, ...]:
        return () if self.kind == "resource" else (OUT,)

    def hint(self, name: str = "") -> str:
        """What the node has no room for: long names, all tests."""
        if name:
            return "Drag to where it leads"
        return "\n".join((self.name, *self.lines) if self.lines else (self.name, self.detail))

    def spoken(self) -> str:
        """The node for those who hear it."""
        parts = [self.kind, *([f"number {self.number}"] if self.number else []), self.detail]
        return "; ".join(part for part in (*parts, *self.lines) if part)

    def port(self, name: str) -> tuple[float, float]:
        """A port's centre, from the corner."""
        if name == OUT:
            return self.width, self.height / 2
        if self.kind == "condition":
            return 0.0, self.line_at(int(name))
        return 0.0, self.height / 2

    def line_at(self, index: int) -> float:
        """The middle of a condition's line, below the top."""
        return self.height / 2 + LINE * (index - (len(self.lines) - 1) / 2)


class ScriptLink(Struct, frozen=True):
    """A pipe. priority: of a module in a situation, None where the entry takes it away.

    place: what it stands for in the document, () where it follows from others.
    """

    source: str
    exit: str
    target: str
    entry: str
    kind: Literal["observes", "holds", "priority", "uses"]
    place: Place = ()
    priority: int | None = None
    none: bool = False
    mark: Mark = ""

    @property
    def id(self) -> tuple[str, str, str, str]:
        return self.source, self.exit, self.target, self.entry


class ScriptPicture(Struct):
    cards: dict[str, ScriptNode]
    links: dict[tuple[str, ...], ScriptLink]
    uids: dict[Place, str]
    height: float


class Inherited(Struct, frozen=True):
    """A priority that a situation takes over from another."""

    source: str
    target: str
    priority: int
    situation: str
    module: str


def uid(kind: str, name: str) -> str:
    return f"{kind} {name}"


def tests(condition: Condition | None) -> list[tuple[Test, tuple[str, ...]]]:
    """Every test with the rest of its place below the condition."""
    found: list[tuple[Test, tuple[str, ...]]] = []

    def walk(children: Sequence[Test | Group], where: tuple[str, ...]) -> None:
        for index, child in enumerate(children):
            here = (*where, str(index))
            if isinstance(child, Test):
                found.append((child, here))
            else:
                walk(child.children, here)

    if condition is not None:
        walk(condition.children, ())
    return found


def joint(condition: Condition | None) -> str:
    """``all``, ``any``, ``none``: what joins the tests; ``mixed`` for groups among tests."""
    if condition is None or len(condition.children) == 0:
        return ""
    if len(condition.children) == 1:
        only = condition.children[0]
        return only.kind if isinstance(only, Group) else ""
    if any(isinstance(c, Group) for c in condition.children):
        return "mixed"
    return "all"


def named(values: Iterable[str]) -> Iterable[tuple[str, str]]:
    """Each name with what tells doubled ones apart."""
    seen: dict[str, int] = {}
    for name in values:
        count = seen[name] = seen.get(name, 0) + 1
        yield name, (name if count == 1 else f"{name}  {count}")


def tags(script: Spds) -> list[tuple[str, Observed | None]]:
    """Every tag of the picture: observed ones in the file's order, then those only used."""
    observed = {o.tag: o for o in script.observe}
    used: dict[str, None] = {}
    for situation in script.situations:
        for condition in (situation.condition, situation.until):
            for test, _ in tests(condition):
                used.setdefault(test.tag)
    # A test may look into a tag: the datum is the longest observed beginning.
    every = dict.fromkeys([*observed, *(datum(t, observed) for t in used)])
    return [(tag, observed.get(tag)) for tag in every]


def datum(tag: str, observed: Mapping[str, object]) -> str:
    """The observed tag that a test's name looks into, or the name itself."""
    parts = tag.split(".")
    for count in range(len(parts), 0, -1):
        head = ".".join(parts[:count])
        if head in observed:
            return head
    return tag


def modules(script: Spds) -> list[tuple[str, tuple[str, ...] | None]]:
    """Every module of the picture with its resources; None for one that only has priorities."""
    found: dict[str, tuple[str, ...] | None] = {m.name: m.resources for m in script.modules}
    for situation in script.situations:
        for entry in situation.entries:
            found.setdefault(entry.module, None)
    return list(found.items())


def picture(script: Spds, problems: Sequence[Problem] = ()) -> ScriptPicture:
    """Nodes and pipes of the whole script."""
    marks = _marks(problems)
    cards: dict[str, ScriptNode] = {}
    links: dict[tuple[str, ...], ScriptLink] = {}
    uids: dict[Place, str] = {}

    def add(node: ScriptNode) -> None:
        cards[node.uid] = node
        uids.setdefault(node.place, node.uid)

    def link(made: ScriptLink) -> None:
        links.setdefault(made.id, made)

    rows = _rows(script)
    used_by: dict[str, list[float]] = {}
    asked_by: dict[str, list[float]] = {}
    observed = {o.tag: o for o in script.observe}
    for number, (situation, (_, key)) in enumerate(
        zip(script.situations, named(s.name for s in script.situations), strict=True), start=1
    ):
        y, room = rows[number - 1]
        for index, (test, _) in enumerate((*tests(situation.condition), *tests(situation.until))):
            used_by.setdefault(datum(test.tag, observed), []).append(y + index)
        for entry in situation.entries:
            asked_by.setdefault(entry.module, []).append(y)
        place: Place = ("situation", situation.name)
        detail = tr("extends {0}").format(situation.extends) if situation.extends else ""
        if situation.condition is None or not situation.condition.children:
            detail = detail or tr("always")
        top = y + (room - 20 - TALL) / 2
        add(
            ScriptNode(
                uid=uid("situation", key),
                place=place,
                kind="situation",
                name=situation.name,
                x=LEFT["situation"],
                y=top,
                detail=detail,
                number=number,
                mark=marks.get(place, ""),
            )
        )
        lines = _lines(situation)
        if lines:
            where = (*place, "condition")
            add(
                ScriptNode(
                    uid=uid("condition", key),
                    place=where,
                    kind="condition",
                    name=situation.name,
                    x=LEFT["condition"],
                    y=y,
                    height=room - 20,
                    lines=lines,
                    joint=joint(situation.condition),
                    mark=marks.get(where, ""),
                )
            )
            link(
                ScriptLink(uid("condition", key), OUT, uid("situation", key), IN, "holds", place=())
            )
    _add_data(script, used_by, marks, add)
    _add_modules(script, asked_by, marks, add)
    _add_links(script, observed, marks, cards, link)
    bottom = max((c.y + c.height for c in cards.values()), default=TOP)
    return ScriptPicture(cards, links, uids, bottom)


def _rows(script: Spds) -> list[tuple[float, float]]:
    """Top and height of each situation's row, the gap below it included."""
    rows = []
    y = TOP
    for situation in script.situations:
        count = len(_lines(situation))
        room = max(PITCH, TALL + 20 + LINE * max(0, count - 2))
        rows.append((y, room))
        y += room
    return rows


def _lines(situation: Situation) -> tuple[str, ...]:
    lines = [words.predicate(test, say) for test, _ in tests(situation.condition)]
    lines += [
        tr("until {0}").format(words.predicate(test, say)) for test, _ in tests(situation.until)
    ]
    return tuple(lines)


def _mean(values: Sequence[float], otherwise: float) -> float:
    return sum(values) / len(values) if values else otherwise


def _spread(wanted: Sequence[tuple[str, float]], pitch: float) -> dict[str, float]:
    """Tops near what is wanted, in that order, at least ``pitch`` apart."""
    order = sorted(enumerate(wanted), key=lambda i: (i[1][1], i[0]))
    tops: dict[str, float] = {}
    at = TOP
    for _, (name, top) in order:
        at = max(at, top)
        tops[name] = at
        at += pitch
    return tops


def _add_data(
    script: Spds,
    used_by: Mapping[str, Sequence[float]],
    marks: Mapping[Place, Mark],
    add: Callable[[ScriptNode], None],
) -> None:
    every = tags(script)
    wanted = [(tag, _mean(used_by.get(tag, ()), 1e6)) for tag, _ in every]
    # On the grid of rows, so that most pipes are straight.
    used = [(t, TOP + round((y - TOP) / PITCH) * PITCH) for t, y in wanted if y < 1e6]
    tops = _spread(used, PITCH)
    below = max(tops.values(), default=TOP - PITCH) + PITCH
    for tag, y in wanted:
        if y >= 1e6:
            tops[tag] = below
            below += PITCH
    for tag, known in every:
        place: Place = ("data", tag)
        detail = tr("not observed")
        if known is not None:
            type_ = dict(kinds.TYPES).get(known.type or "")
            detail = known.unit or (translated(type_) if type_ else tr("any value"))
        add(
            ScriptNode(
                uid=uid("data", tag),
                place=place,
                kind="data",
                name=tag,
                x=LEFT["data"],
                y=tops[tag],
                detail=detail,
                mark=marks.get(place, ""),
            )
        )


def _add_modules(
    script: Spds,
    asked_by: Mapping[str, Sequence[float]],
    marks: Mapping[Place, Mark],
    add: Callable[[ScriptNode], None],
) -> None:
    every = modules(script)
    last = max((y for ys in asked_by.values() for y in ys), default=TOP)
    tops = _spread([(m, _mean(asked_by.get(m, ()), last)) for m, _ in every], 60)
    needed: dict[str, list[float]] = {}
    for name, resources in every:
        place: Place = ("module", name)
        for resource in resources or ():
            needed.setdefault(resource, []).append(tops[name])
        add(
            ScriptNode(
                uid=uid("module", name),
                place=place,
                kind="module",
                name=name,
                x=LEFT["module"],
                y=tops[name],
                height=LOW,
                detail="" if resources is not None else tr("not declared"),
                mark=marks.get(place, ""),
            )
        )
    spots = _spread([(r, _mean(ys, TOP)) for r, ys in needed.items()], 56)
    for resource, top in spots.items():
        add(
            ScriptNode(
                uid=uid("resource", resource),
                place=("resource", resource),
                kind="resource",
                name=resource,
                x=LEFT["resource"],
                y=top,
                height=LOW,
            )
        )


def _add_links(
    script: Spds,
    observed: Mapping[str, Observed],
    marks: Mapping[Place, Mark],
    cards: Mapping[str, ScriptNode],
    link: Callable[[ScriptLink], None],
) -> None:
    for situation, (_, key) in zip(
        script.situations, named(s.name for s in script.situations), strict=True
    ):
        place: Place = ("situation", situation.name)
        index = 0
        for part in ("condition", "until"):
            for test, rest in tests(getattr(situation, part)):
                link(
                    ScriptLink(
                        uid("data", datum(test.tag, observed)),
                        OUT,
                        uid("condition", key),
                        str(index),
                        "observes",
                        place=(*place, part, *rest),
                    )
                )
                index += 1
        for number, entry in enumerate(situation.entries):
            where = (*place, "entry", str(number))
            link(
                ScriptLink(
                    uid("situation", key),
                    OUT,
                    uid("module", entry.module),
                    IN,
                    "priority",
                    place=where,
                    priority=entry.priority,
                    none=entry.priority is None,
                    mark=marks.get(where, ""),
                )
            )
    for name, resources in modules(script):
        for resource in dict.fromkeys(resources or ()):
            if uid("resource", resource) in cards:
                link(
                    ScriptLink(
                        uid("module", name),
                        OUT,
                        uid("resource", resource),
                        IN,
                        "uses",
                        place=("module", name, "resource", resource),
                    )
                )


def inherited(script: Spds, situation: Situation, key: str) -> list[Inherited]:
    """The priorities that a situation takes over, by module in the order of the file."""
    own = {e.module for e in situation.entries}
    return [
        Inherited(uid("situation", key), uid("module", m), p, situation.name, m)
        for m, p in script.priorities(situation).items()
        if m not in own
    ]


def _marks(problems: Iterable[Problem]) -> dict[Place, Mark]:
    """Marks by place: of nodes, and of entries for their pills."""
    marks: dict[Place, Mark] = {}
    for problem in problems:
        place = problem.place
        if place[:1] == ("situation",) and len(place) > 3 and place[2] == "entry":
            root = place[:4]
        elif place[:1] == ("situation",) and len(place) > 2 and place[2] in ("condition", "until"):
            root = (*place[:2], "condition")
        else:
            root = place[:2]
        if root and (problem.severity == "error" or root not in marks):
            marks[root] = problem.severity
    return marks
