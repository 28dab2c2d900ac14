"""One run of a rehearsal: the robot in virtual time, what was done to it, and what it did.

No Qt, no clock: whoever holds it says how far it shall go.
"""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from situ.decide import inputs
from situ.decide.expected import Expectation
from situ.decide.screens import Shown
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent, to_fields
from situ.document.project import Project
from situ.rehearse.simulate import Rehearsal
from situ_studio.live.log import TraceLog
from situ_studio.live.moment import TraceFields

MILLISECOND = SECOND // 1000
LETTER = 60 * MILLISECOND
"""What it takes to say a letter."""
LEAST = 2 * SECOND
"""What every other action takes that ends by itself, and the shortest speech."""
BY_ITSELF = ("speech", "sound", "robot")
"""Actions that end by themselves, for nobody has an opinion how they went."""
LASTING = (*BY_ITSELF, "movie", "service", "launch")
"""Actions that end some time after they began."""


class Done(Struct, frozen=True):
    """What somebody, or the world, did at ``at`` µs."""

    at: int
    does: inputs.AnyInput


class Pending(Struct, frozen=True):
    """An action that has begun and not ended. until: when it ends by itself, µs, or None."""

    application: str
    action: str
    name: str | None
    text: str | None
    until: int | None

    def finish(self, ok: bool = True, result: Any = None) -> inputs.Finish:
        """The input that ends it, well or badly. result: what a service answers."""
        if ok:
            return inputs.Finish(self.action, self.name, self.application, result=result)
        error = "it failed in the rehearsal"
        return inputs.Finish(self.action, self.name, self.application, ok=False, error=error)


class Course:
    """``log`` is what the robot did, ``done`` what was done to it, each in order.

    The project must have no errors. The same ``done`` gives the same ``log``.
    """

    def __init__(self, project: Project) -> None:
        self.project = project
        self.log = TraceLog()
        self.done: list[Done] = []
        self.pending: list[Pending] = []
        self._came: list[TraceFields] = []
        self._now = 0
        self._rehearsal = Rehearsal(project, self._tell)

    @property
    def now(self) -> int:
        """µs since the start."""
        return self._now

    @property
    def due(self) -> int | None:
        """When something happens next if nobody does anything, µs; None: never."""
        ends = [one.until for one in self.pending if one.until is not None]
        due = self._rehearsal.robot.due()
        return min([*ends, due] if due is not None else ends, default=None)

    def advance(self, to: int) -> None:
        """Goes on to ``to`` (µs), through all that happens until then."""
        # One after the other: what falls due may begin what ends before the next.
        while (due := self.due) is not None and due <= to:
            self._now = max(due, self._now)
            ending = self._ending()
            if ending is not None and ending.until is not None and ending.until <= due:
                self._do(ending.finish(), self._now)
                if ending in self.pending:
                    self.pending.remove(ending)
            else:
                self._rehearsal.advance(self._now)
        self._now = max(to, self._now)
        self._rehearsal.advance(self._now)

    def give(self, given: inputs.AnyInput) -> None:
        """Something is done now."""
        self._do(given, self._now)

    def take(self) -> list[TraceFields]:
        """The events since this was asked last; they are in ``log`` from then on."""
        came, self._came = self._came, []
        return self.log.add(came)

    # -- what it is like -------------------------------------------------------------

    @property
    def expected(self) -> dict[str, Expectation]:
        """What each application expects now."""
        return self._rehearsal.robot.expected()

    @property
    def modules(self) -> dict[str, bool]:
        """Every module, whether it is there."""
        return self._rehearsal.robot.modules()

    def look(self, tag: str) -> object:
        """The value of a tag now, None where it has none."""
        return self._rehearsal.robot.board.look(tag)

    def screen(self) -> tuple[tuple[Shown, ...], str | None]:
        """What is on the robot's screen now, and what lies behind it."""
        value = self.look("robot/screen")
        if not isinstance(value, dict):
            return (), None
        return tuple(value["components"]), value.get("background")

    # -- how it goes on --------------------------------------------------------------

    def _ending(self) -> Pending | None:
        """What ends by itself next."""
        own = [one for one in self.pending if one.until is not None]
        return min(own, key=lambda one: one.until or 0, default=None)

    def _do(self, given: inputs.AnyInput, at: int) -> None:
        self._rehearsal.give(given, at)
        self._now = at
        self.done.append(Done(at, given))

    def _tell(self, events: list[TraceEvent]) -> None:
        for fields in map(to_fields, events):
            self._came.append(fields)
            if fields["kind"] == "action" and fields["action"] in LASTING:
                self._begin(fields)
            elif fields["kind"] in ("finished", "cancelled"):
                self._end(fields)

    def _begin(self, fields: TraceFields) -> None:
        text, action = fields.get("text"), fields["action"]
        until = None
        if action in BY_ITSELF:
            takes = max(LETTER * len(text or ""), LEAST)
            until = round(fields["t"] * SECOND) // MILLISECOND * MILLISECOND + takes
        self.pending.append(Pending(fields["application"], action, fields["name"], text, until))

    def _end(self, fields: TraceFields) -> None:
        key = (fields["application"], fields["action"], fields["name"])
        for place, one in enumerate(self.pending):
            if (one.application, one.action, one.name) == key:
                del self.pending[place]
                return
