"""An application's stays in its states, and what became of the events that came to it there."""

from __future__ import annotations

from msgspec import Struct, field

from situ.document.project import Project
from situ.document.rbd import BACK
from situ.rehearse.past import Judged, Past
from situ.rehearse.reason import Reason
from situ.rehearse.recording import Fields, Recording
from situ.rehearse.ways import Way
from situ.rehearse.why_held import why_suspended


class Tried(Struct, frozen=True):
    """A way that was looked at: whether it could be taken, and its guard as it was then."""

    way: Way
    passed: bool
    guard: tuple[Judged, ...] = ()


class Attempt(Struct, frozen=True):
    """An event that came. tried: the ways looked at, in order; suspended: since when, and
    blocked: by what.
    """

    event: Fields
    tried: tuple[Tried, ...]
    suspended: Fields | None
    blocked: tuple[Reason, ...] = ()

    @property
    def taken(self) -> Way | None:
        """What it was taken for."""
        last = self.tried[-1] if self.tried else None
        return last.way if last is not None and last.passed else None


class Stay(Struct):
    """A stay in an innermost state, from ``entered`` to the transition ``left``, or where a deploy
    let the application start again to what it entered then.

    unnamed: its unnamed events as they were in the end. suspended: in the end, by that
    event. resumed: the last resume in it. back: where ``#back`` went, by way.
    """

    application: str
    state: str
    entered: Fields
    left: Fields | None = None
    attempts: list[Attempt] = field(default_factory=list)
    unnamed: list[Tried] = field(default_factory=list)
    suspended: Fields | None = None
    resumed: Fields | None = None
    backs: dict[str, str | None] = field(default_factory=dict)
    events: list[Fields] = field(default_factory=list)

    def is_in(self, state: str) -> bool:
        """Whether it is one in that state, or in the part that it holds."""
        return f"{self.state}/".startswith(f"{state}/")

    def at(self, t: float) -> bool:
        """Whether some of it was at the moment ``t``."""
        return self.entered["t"] <= t and (self.left is None or self.left["t"] >= t)


def stays(
    project: Project, recording: Recording, application: str, until: float
) -> tuple[list[Stay], Past]:
    """The stays of an application up to and at ``until`` seconds, and the robot as it was then."""
    past = Past(project, recording.whole)
    found: list[Stay] = []
    for step in recording.steps:
        if step.t > until:
            break
        for hidden in step.before:
            past.keep(hidden)
        for event in step.events:
            if event.get("application") == application:
                _look(past, found, event)
            past.take(event)
        for hidden in step.after:
            past.keep(hidden)
    past.pass_time(until)
    if found and found[-1].left is None:
        _close(past, found[-1])
    return found, past


def _look(past: Past, found: list[Stay], event: Fields) -> None:
    """An event of the application, seen just before the past takes it."""
    name, kind = event["application"], event["kind"]
    if kind == "enter":
        if found and found[-1].left is None:
            if event["state"].startswith(f"{found[-1].state}/"):
                found.pop()  # it holds the part that is entered with it
            else:
                found[-1].left = event  # another version was deployed that lacks it
        found.append(Stay(name, event["state"], event))
        return
    if not found:
        return
    here = found[-1]
    here.events.append(event)
    if kind == "event":
        past.pass_time(event["t"])
        suspended = past.applications[name].suspended
        tried = () if suspended is not None else tuple(past.tried(name, event["name"]))
        looked = tuple(Tried(way, passed, _guard(past, way)) for way, passed in tried)
        blocked = () if suspended is None else why_suspended(past, name, suspended)
        here.attempts.append(Attempt(event, looked, suspended, blocked))
    elif kind == "exit":
        past.pass_time(event["t"])
        _close(past, here)
    elif kind == "transition":
        here.left = event
    elif kind == "resume":
        here.resumed = event


def _close(past: Past, here: Stay) -> None:
    name = here.application
    now = past.applications[name]
    here.suspended = now.suspended
    for way in past.ways(name):
        if way.next == BACK:
            here.backs[way.before] = past.back(name, way)
        if way.event is not None and way.event.name is None:
            here.unnamed.append(Tried(way, past.passes(way, name), _guard(past, way)))


def _guard(past: Past, way: Way) -> tuple[Judged, ...]:
    when = way.event.when if way.event is not None else None
    return () if when is None else tuple(past.judge(child) for child in when.children)
