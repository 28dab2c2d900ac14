"""What a script's picture is made of: nodes, lines of conditions, pipes; their measures. Pure."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from situ_studio.canvas.problem_marks import NONE, Mark, Sign
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr, translated

Kind = Literal["data", "condition", "situation", "module", "resource"]
Line = Literal["name", "extends", "times", "detail", ""]

LEFT: dict[str, float] = {
    "data": 16,
    "condition": 214,
    "situation": 420,
    "module": 690,
    "resource": 858,
}
WIDTH: dict[str, float] = {
    "data": 166,
    "condition": 176,
    "situation": 162,
    "module": 126,
    "resource": 100,
}
TOP = 44.0
TALL, LOW = 52.0, 44.0
PITCH = 72.0
"""From one row of situations to the next."""
LINE = 18.0
STRIP = 32.0
INDENT = 12.0
OUT, IN, UNTIL = "out", "in", "until"


def titles() -> dict[str, str]:
    """What stands above each column, in the user's language."""
    return {
        "data": tr("Data"),
        "condition": tr("Conditions"),
        "situation": tr("Situations, first that holds"),
        "module": tr("Modules"),
        "resource": tr("Resources"),
    }


class Row(Struct, frozen=True):
    """A line of a condition: a test, or what a group asks of the lines that stand further in.

    path: positions from the condition inwards, as in a place: ``0/1``. group: all, any, none;
    "" for a test. tag: what the test looks at.
    """

    path: str
    text: str
    depth: int = 0
    group: str = ""
    tag: str = ""

    @property
    def tail(self) -> tuple[str, ...]:
        """The end of its place."""
        return tuple(self.path.split("/"))


class ScriptNode(Struct, frozen=True):
    """What one node shows.

    rows: a condition's tests and groups. joint: what joins them, with the place of that group in
    ``joined`` (() where it is not written). until: whether a condition ends its situation.
    extends, times: lines of a situation. number: its precedence. wrong, note: what is wrong with
    it, and what somebody wrote about it, told where the mouse rests on it and to those who hear it.
    """

    uid: str
    place: Place
    kind: Kind
    name: str
    x: float
    y: float
    height: float = TALL
    detail: str = ""
    extends: str = ""
    times: str = ""
    rows: tuple[Row, ...] = ()
    joint: str = ""
    joined: Place = ()
    until: bool = False
    number: int = 0
    wrong: Mark = NONE
    note: str = ""

    @property
    def mark(self) -> Sign:
        """The worst that is wrong with it."""
        return self.wrong.sign

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
            return tuple(row.path for row in self.rows)
        return (IN, UNTIL) if self.kind == "situation" else (IN,)

    @property
    def outputs(self) -> tuple[str, ...]:
        return () if self.kind == "resource" else (OUT,)

    def called(self) -> str:
        """The node in words that tell it from every other."""
        if self.kind != "condition":
            return self.name
        if self.until:
            return tr("What ends {0}").format(self.name)
        return tr("Condition of {0}").format(self.name)

    def lines(self) -> tuple[str, ...]:
        """What stands below the name, or for a condition all of it."""
        if self.kind == "condition":
            return tuple(f"{'  ' * row.depth}{row.text}" for row in self.rows)
        return tuple(line for line in (self.detail, self.extends, self.times) if line)

    def hint(self, name: str = "") -> str:
        """What the node has no room for: long names, all tests."""
        if name:
            return tr("Drag to where it leads")
        if self.kind == "condition":
            every = (self.called(), *self._tests(), *self._noted(), *self.wrong.told())
            return "\n".join(every)
        return "\n".join((self.called(), *self.lines(), *self._noted(), *self.wrong.told()))

    def _tests(self) -> tuple[str, ...]:
        return tuple(f"{row.tag} {row.text}".strip() for row in self.rows)

    def _noted(self) -> tuple[str, ...]:
        return (tr("Note: {0}").format(self.note),) if self.note else ()

    def spoken(self) -> str:
        """The node for those who hear it."""
        what = _called()[self.kind]
        number = [tr("number {0}").format(self.number)] if self.number else []
        joint = [translated(f"{self.joint} of these")] if self.joint else []
        wrong = {"": "", "warning": tr("with a warning"), "error": tr("with an error")}[self.mark]
        # Whoever hears it sees no pipe that comes from the data.
        lines = self._tests() if self.kind == "condition" else self.lines()
        every = (what, *number, *joint, *lines, wrong, *self.wrong.told(), *self._noted())
        return "; ".join(part for part in every if part)

    def port(self, name: str) -> tuple[float, float]:
        """A port's centre, from the corner."""
        if name == OUT:
            return self.width, self.height / 2
        if self.kind == "condition":
            index = next((i for i, row in enumerate(self.rows) if row.path == name), 0)
            return 0.0, self.line_at(index)
        if name == UNTIL:
            return 0.0, self.height - 10
        return 0.0, self.height / 2

    def line_at(self, index: int) -> float:
        """The middle of a condition's line, below the top."""
        return self.height / 2 + LINE * (index - (len(self.rows) - 1) / 2)

    def row_at(self, y: float) -> Row | None:
        """The line at a height below the top."""
        every = enumerate(self.rows)
        return next((row for i, row in every if abs(self.line_at(i) - y) <= LINE / 2), None)

    def stack(self) -> tuple[tuple[Line, float], ...]:
        """The lines of any other node, each with its middle below the top."""
        lines: list[Line] = ["name"]
        lines += ["detail"] if self.detail else []
        lines += ["extends"] if self.extends else []
        lines += ["times"] if self.times else []
        pitch = 17.0 if len(lines) < 3 else 16.0
        first = self.height / 2 - pitch * (len(lines) - 1) / 2
        return tuple((line, first + pitch * i) for i, line in enumerate(lines))

    def line_of(self, y: float) -> Line:
        """Which of these lines is at a height below the top; "" for none."""
        return next((line for line, at in self.stack() if abs(at - y) <= 8.5), "")


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
    wrong: Mark = NONE

    @property
    def mark(self) -> Sign:
        return self.wrong.sign

    @property
    def id(self) -> tuple[str, str, str, str]:
        return self.source, self.exit, self.target, self.entry


class ScriptPicture(Struct):
    """cards, in the order of reading; links by id; uids: which node a place is."""

    cards: dict[str, ScriptNode]
    links: dict[tuple[str, ...], ScriptLink]
    uids: dict[Place, str]


class Inherited(Struct, frozen=True):
    """A priority that a situation takes over from another."""

    source: str
    target: str
    priority: int
    situation: str
    module: str


def uid(kind: str, name: str) -> str:
    return f"{kind} {name}"


def _called() -> dict[str, str]:
    return {
        "data": tr("data"),
        "condition": tr("condition"),
        "situation": tr("situation"),
        "module": tr("module"),
        "resource": tr("resource"),
    }
