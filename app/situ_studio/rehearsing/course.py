"""One run of a rehearsal: the robot in virtual time, what was done to it, and what it did.

No Qt, no clock: whoever holds it says how far it shall go.
"""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from situ.decide import inputs
from situ.decide.deployment import Deployment
from situ.decide.expected import Expectation
from situ.decide.screens import Shown
from situ.decide.step import SECOND, microseconds
from situ.decide.trace import TraceEvent, to_fields
from situ.document.project import Project
from situ.document.spoken import estimate
from situ.document.values import is_number
from situ.rehearse.clock import Hidden
from situ.rehearse.scenario import WRITER
from situ.rehearse.simulate import Rehearsal
from situ_studio.live.clock_seen import is_clock
from situ_studio.live.log import TraceLog
from situ_studio.live.moment import TraceFields
from situ_studio.wording.language import tr

MILLISECOND = SECOND // 1000
USUAL = 2 * SECOND
"""What an action takes that ends by itself; a speech takes as long as it is said."""
VOLUMES, RATES = (0, 200), (25, 250)
"""Percent between which a robot's voice can be chosen."""
BY_ITSELF = ("speech", "sound", "robot")
"""Actions that end by themselves, for nobody has an opinion how they went."""
LASTING = (*BY_ITSELF, "movie", "service", "launch")
"""Actions that end some time after they began."""


class Done(Struct, frozen=True):
    """What somebody, or the world, did at ``at`` µs."""

    at: int
    does: inputs.AnyInput


class Pending(Struct, frozen=True):
    """An action that has begun and not ended. began: when, µs; until: when it ends by itself, or
    None.
    """

    application: str
    action: str
    name: str | None
    text: str | None
    began: int
    until: int | None

    def finish(self, ok: bool = True, result: Any = None) -> inputs.Finish:
        """The input that ends it, well or badly. result: what a service answers."""
        if ok:
            return inputs.Finish(self.action, self.name, self.application, result=result)
        error = tr("it failed in the rehearsal")
        return inputs.Finish(self.action, self.name, self.application, ok=False, error=error)


class Speaking(Struct, frozen=True):
    """What the robot says now. language: as ``en-GB``; volume, rate: percent of normal.

    began, until: µs; None where nobody knows, for a module has it said.
    """

    text: str
    language: str
    volume: float = 100
    rate: float = 100
    began: int | None = None
    until: int | None = None


class Version(Struct, frozen=True):
    """What a robot can run. files: its texts by their paths, as in ``inputs.Deploy``.

    The project must have no errors.
    """

    project: Project
    files: dict[str, str]


class Course:
    """``log`` is what the robot did, ``done`` what was done to it, each in order.

    The project must have no errors. The same ``done`` gives the same ``log``. files: its texts,
    where another version shall be taken in.
    """

    def __init__(self, project: Project, files: dict[str, str] | None = None) -> None:
        self._versions = [Version(project, files or {})]
        self._before: list[int] = []
        self.failed: str | None = None
        """Why the version that was taken in last is not run any more; None: it is, or waits."""
        self.log = TraceLog()
        self.done: list[Done] = []
        self.pending: list[Pending] = []
        self._came: list[TraceFields] = []
        self._now = 0
        self._fresh: list[TraceFields] = []
        self._running = 0
        self._rehearsal = Rehearsal(project, self._tell, files=files)
        self._follow()

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
                self._follow()
        self._now = max(to, self._now)
        self._rehearsal.advance(self._now)

    def give(self, given: inputs.AnyInput) -> None:
        """Something is done now."""
        self._do(given, self._now)

    def take(self) -> list[TraceFields]:
        """The events since this was asked last; they are in ``log`` from then on."""
        came, self._came = self._came, []
        return self.log.add(came)

    # -- other versions ------------------------------------------------------------------

    @property
    def project(self) -> Project:
        """What the robot runs now."""
        return self._versions[self._rehearsal.robot.version].project

    def version(self, number: int) -> Project:
        """That of a number, of those that ran; 0 is what it began with."""
        return self._versions[number].project

    @property
    def deployment(self) -> Deployment:
        """Which version runs, and what another waits for."""
        return self._rehearsal.robot.deployment()

    @property
    def awaited(self) -> Project | None:
        """What waits to be run."""
        pending = self.deployment.pending
        return None if pending is None else self._versions[pending].project

    @property
    def can_return(self) -> bool:
        """Whether something else ran before."""
        return bool(self._before)

    def take_in(self, version: Version, at_once: bool = False) -> None:
        """The robot goes on with another version, by the rules of a deploy: at the next moment at
        which no action runs, or ``at_once``.
        """
        number = len(self._versions)
        self._versions.append(version)
        self._deploy(number, force_after=0.0 if at_once else None)

    def hurry(self) -> None:
        """What waits is run at once; what runs now is broken off."""
        pending = self.deployment.pending
        if pending is not None:
            self._deploy(pending, force_after=0.0)

    def go_back(self) -> None:
        """What ran before runs again, at once."""
        if self._before:
            self._deploy(self._before[-1], returning=True)

    def _deploy(
        self, number: int, force_after: float | None = None, returning: bool = False
    ) -> None:
        self.failed = None
        version = self._versions[number]
        # It is known here; where media lie, its texts would not tell.
        self._rehearsal.robot.prepare(number, version.project)
        self.give(inputs.Deploy(number, version.files, WRITER, force_after, returning))

    def _turn(self, fields: TraceFields, errors: dict[int, TraceFields]) -> None:
        """Another version runs. errors: those just before, by their seq."""
        number = fields["version"]
        if number in self._before:
            del self._before[self._before.index(number) :]
            if fields["writer"] != WRITER:
                # It says that it returns because of what failed.
                returned = errors[fields["cause"]]
                self.failed = errors.get(returned["cause"], returned)["message"]
        else:
            self._before.append(self._running)
        self._running = number

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

    @property
    def speaking(self) -> Speaking | None:
        """What the robot says now; None: nothing, or a sound."""
        value = self.look("robot/speech")
        text = value.get("text") if isinstance(value, dict) else value
        if not isinstance(text, str) or not text:
            return None
        said = value.get("lang") if isinstance(value, dict) else None
        language = said or self.look("language")
        own = (one for one in self.pending if (one.action, one.text) == ("speech", text))
        pending = next(own, None)
        return Speaking(
            text,
            language if isinstance(language, str) else "en",
            self._percent("speech.volume", *VOLUMES),
            self._percent("speech.rate", *RATES),
            None if pending is None else pending.began,
            None if pending is None else pending.until,
        )

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
        if isinstance(given, inputs.Set):
            tags = ((tag, value) for tag, value in given.tags.items() if is_clock(tag))
            self.log.keep_clock(Hidden(at / SECOND, *one, given.writer) for one in tags)
        self.done.append(Done(at, given))
        self._follow()

    def _tell(self, events: list[TraceEvent]) -> None:
        self._fresh += map(to_fields, events)

    def _follow(self) -> None:
        """What the robot has begun and ended since."""
        came, self._fresh = self._fresh, []
        self._came += came
        errors: dict[int, TraceFields] = {}
        for fields in came:
            if fields["kind"] == "action" and fields["action"] in LASTING:
                self._begin(fields)
            elif fields["kind"] in ("finished", "cancelled"):
                self._end(fields)
            elif fields["kind"] == "error":
                errors[fields["seq"]] = fields
            elif fields["kind"] == "deployed":
                self._turn(fields, errors)

    def _begin(self, fields: TraceFields) -> None:
        text, action = fields.get("text"), fields["action"]
        began = microseconds(fields["t"])
        until = None
        if action in BY_ITSELF:
            takes = USUAL
            if action == "speech":
                said = estimate(text or "", self._percent("speech.rate", *RATES))
                takes = round(said * 1000) * MILLISECOND
            until = began // MILLISECOND * MILLISECOND + takes
        name = fields["name"]
        self.pending.append(Pending(fields["application"], action, name, text, began, until))

    def _percent(self, tag: str, least: float, most: float) -> float:
        value: Any = self.look(tag)
        return min(max(float(value), least), most) if is_number(value) else 100.0

    def _end(self, fields: TraceFields) -> None:
        key = (fields["application"], fields["action"], fields["name"])
        for place, one in enumerate(self.pending):
            if (one.application, one.action, one.name) == key:
                del self.pending[place]
                return
