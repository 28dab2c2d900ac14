"""What the drawing of an application shows: cards with exits, and links between them. No Qt.

All values: a card compares equal while nothing on it changed, so the graph rebuilds only what is
different (canvas.md, the seam, 6). ``projection.py`` makes them of a document.
Lengths are scene units (px at 100 %), measures are those of mockups/tokens.md.
"""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from situ.document import rbd
from situ_studio.canvas.problem_marks import NONE, Mark, Sign
from situ_studio.edits.edit import Place
from situ_studio.edits.words import state_called
from situ_studio.wording.language import tr

WIDTH = 176.0
HEADER = 28.0
LINE = 22.0
FIRST = 63.0
"""Where the first port and the input lie, below the card's top."""
PITCH = 18.0
COLUMN, ROW = 230.0, 228.0

ALWAYS = "always"
"""The place and, with a blank that no number has, the uid of what is part of every state."""
NEW = "new"
"""The exit from which a new event is drawn."""
TIMEOUT = "timeout"
ENTRY = "in"

Kind = Literal["state", "start", "end", "part", "always"]


class Exit(Struct, frozen=True):
    """One output port: an expected event or the timeout.

    id: the event's position in the state, or ``timeout``.
    short: where it leads without a pipe: ``#back``, ``#again`` or a number that no state has.
    seconds: of a timeout. mark: what is wrong with it.
    """

    id: str
    label: str
    phrase: str = ""
    guard: str = ""
    next: str | None = None
    short: str = ""
    missing: bool = False
    seconds: float = 0.0
    mark: Mark = NONE

    @property
    def timeout(self) -> bool:
        return self.id == TIMEOUT

    def called(self) -> str:
        """The exit for those who hear it."""
        return tr("after {0}").format(self.label) if self.timeout else self.label

    def leads(self, called: str) -> str:
        """Where it leads, for those who hear it. called: the state there."""
        if self.next is None:
            return tr("stays")
        if self.next == rbd.AGAIN:
            return tr("begins the same state anew")
        if self.next == rbd.BACK:
            return tr("leads back")
        return tr("leads to {0}").format(called)

    def spoken(self) -> str:
        """In few words: they are heard with its card again and again."""
        wrong = {"error": tr("with an error"), "warning": tr("with a warning")}
        told = f"{self.called()} {self.leads(self.next or '')}"
        return f"{told}, {wrong[self.mark.sign]}" if self.mark.sign else told


class Card(Struct, frozen=True):
    """All that one card shows. ``uid`` is ours and lasts as long as the state has its number."""

    uid: str
    place: Place
    kind: Kind
    no: str
    name: str
    x: float
    y: float
    line: str = ""
    line_icon: str = ""
    icons: tuple[str, ...] = ()
    screen: rbd.Screen | None = None
    exits: tuple[Exit, ...] = ()
    chips: tuple[str, ...] = ()
    mark: Sign = ""
    wrong: Mark = NONE
    """``mark``, and the words for it."""

    @property
    def height(self) -> float:
        return 62 + PITCH * max(3, len(self.exits))

    @property
    def width(self) -> float:
        return WIDTH

    @property
    def many(self) -> bool:
        return False

    @property
    def inputs(self) -> tuple[str, ...]:
        return () if self.kind == "always" else (ENTRY,)

    @property
    def outputs(self) -> tuple[str, ...]:
        return (*(e.id for e in self.exits), NEW)

    def port(self, name: str) -> tuple[float, float]:
        """A port's centre, from the card's corner."""
        if name == ENTRY:
            return 0.0, FIRST
        if name == NEW:
            return WIDTH, min(FIRST + PITCH * len(self.exits), self.height)
        index = next(i for i, e in enumerate(self.exits) if e.id == name)
        return WIDTH, FIRST + PITCH * index

    def hint(self, name: str = "") -> str:
        """The whole of what the card, or one exit's row, has room for only in part."""
        if name == NEW:
            return tr("Drag to where a new event leads")
        leaving = self.exit(name)
        if leaving is None:
            called = state_called(self.no, self.name) if self.no else self.name
            said = (called, self.line, *self.wrong.told())
            return "\n".join(part for part in said if part)
        parts = [leaving.label]
        if leaving.phrase:
            parts.append(f"“{leaving.phrase}”")
        if leaving.guard:
            parts.append(tr("if {0}").format(leaving.guard))
        if leaving.missing:
            parts.append(tr("leads to state {0}, which does not exist").format(leaving.next))
        elif leaving.next is None:
            parts.append(tr("stays in the state"))
        parts += leaving.mark.told()
        return "\n".join(parts)

    def spoken(self) -> str:
        """The card for those who hear it: what it is and says, what is wrong, where exits lead."""
        kinds = {"start": tr("start"), "end": tr("end"), "part": tr("part")}
        wrong = {"error": tr("has an error"), "warning": tr("has a warning")}.get(self.mark, "")
        ways = (exit.spoken() for exit in self.exits)
        every = (kinds.get(self.kind, ""), wrong, *self.wrong.told(), self.line, *ways)
        return "; ".join(part for part in every if part)

    def exit(self, name: str) -> Exit | None:
        return next((e for e in self.exits if e.id == name), None)


class Link(Struct, frozen=True):
    """A pipe from an exit to a card's input."""

    source: str
    exit: str
    target: str
    label: str = ""
    guard: str = ""

    @property
    def id(self) -> tuple[str, str, str]:
        return self.source, self.exit, self.target

    @property
    def entry(self) -> str:
        return ENTRY


class Picture(Struct):
    """cards: uid to card, in document order. links: by id."""

    cards: dict[str, Card]
    links: dict[tuple[str, ...], Link]
    uids: dict[Place, str]
    """A card's place to its uid (the first one's, where a faulty file has two)."""


def place_of(uid: str, exit: str | None, card: Card) -> Place:
    """The place of an exit, or of its card."""
    if exit is None or exit == NEW:
        return card.place
    return (*card.place, TIMEOUT) if exit == TIMEOUT else (*card.place, "event", exit)


def exit_of(place: Place) -> str | None:
    """The exit that a place names, the reverse of ``place_of``."""
    tail = place[1:] if place[:1] == (ALWAYS,) else place[2:]
    if tail[:1] == (TIMEOUT,):
        return TIMEOUT
    return tail[1] if len(tail) > 1 and tail[0] == "event" else None
