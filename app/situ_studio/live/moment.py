"""What the robot was like at a moment of its trace (architecture, idea 3).

No Qt, no clock: time is the trace's own ``t``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
from msgspec import Struct, field
from msgspec.structs import replace

TraceFields = dict[str, Any]
"""A trace event as it stands in a trace: ``kind``, ``seq``, ``t``, ``cause`` and its own fields."""

BREAKPOINTS, PAUSED = "debugger.breakpoints", "debugger.paused"
"""Tags at which the runtime tells of its debugger."""
RECENT = 32
"""Transitions kept for the canvas to fade; older ones only count."""


class Taken(Struct, frozen=True):
    """A transition: from a state, by an event (None: unnamed, or a timeout), at ``t`` seconds."""

    source: str
    to: str
    event: str | None
    timeout: bool
    t: float


class ApplicationMoment(Struct):
    """One application: where it is, since when, how often each state was entered.

    begun: since when it is in each state that it is in, those around a part too. spent: seconds in
    each state that it has left. crossed: (from, to, event, timeout) to how often. paused: by an
    operator or at a breakpoint, ``stopped`` is that one's number. breakpoints: those that stand on
    it, as the tag ``debugger.breakpoints`` has them. suspended_told, paused_told: when the trace
    said last whether it is; None where it never did.
    """

    state: str | None = None
    since: float = 0.0
    suspended: bool = False
    suspended_told: float | None = None
    missing: tuple[str, ...] = ()
    entered: dict[str, int] = field(default_factory=dict)
    begun: dict[str, float] = field(default_factory=dict)
    spent: dict[str, float] = field(default_factory=dict)
    taken: list[Taken] = field(default_factory=list)
    crossed: dict[tuple[str, str, str | None, bool], int] = field(default_factory=dict)
    paused: bool = False
    paused_told: float | None = None
    stopped: int | None = None
    breakpoints: tuple[dict[str, Any], ...] = ()


class Entry(Struct, frozen=True):
    """A value of the blackboard. t: when it was last set; writer None: not known."""

    value: Any
    writer: str | None
    t: float


class Moment(Struct):
    """All that a trace tells of the robot up to ``t``.

    holding: situations whose condition holds. asking: module to the resources of its request.
    holders: resource to (module, since). robot: what stands at ``robot/``. gone: tags that were
    deleted, and when.
    """

    t: float = 0.0
    applications: dict[str, ApplicationMoment] = field(default_factory=dict)
    situation: str | None = None
    situation_since: float = 0.0
    holding: set[str] = field(default_factory=set)
    asking: dict[str, tuple[str, ...]] = field(default_factory=dict)
    holders: dict[str, tuple[str, float]] = field(default_factory=dict)
    robot: dict[str, Any] = field(default_factory=dict)
    board: dict[str, Entry] = field(default_factory=dict)
    connected: set[str] = field(default_factory=set)
    gone: dict[str, float] = field(default_factory=dict)

    def take(self, event: TraceFields) -> None:
        """Goes on by one event."""
        self.t = event["t"]
        accept = ACCEPT.get(event["kind"])
        if accept is not None:
            accept(self, event)

    def copy(self) -> Moment:
        """The same; what is taken after does not change the other."""
        applications = {
            name: replace(
                one,
                entered={**one.entered},
                begun={**one.begun},
                spent={**one.spent},
                crossed={**one.crossed},
            )
            for name, one in self.applications.items()
        }
        return replace(
            self,
            applications=applications,
            holding={*self.holding},
            asking={**self.asking},
            holders={**self.holders},
            robot={**self.robot},
            board={**self.board},
            connected={*self.connected},
            gone={**self.gone},
        )

    def stand(self, tag: str, value: Any, writer: str | None, t: float) -> None:
        """What stands on the blackboard since ``t``; what the trace told later counts more."""
        known = self.board.get(tag)
        if value is None or self.gone.get(tag, t) > t or (known is not None and known.t > t):
            return
        self.board[tag] = Entry(value, writer, t)
        if tag == BREAKPOINTS:
            self.put_breakpoints()
        elif tag.startswith("robot/"):
            resource = tag.removeprefix("robot/")
            if resource not in self.robot:
                self.robot[resource] = value
                if writer is not None:
                    self.holders.setdefault(resource, (writer, t))
        elif not isinstance(value, dict):
            return
        elif tag == PAUSED:
            for name, stopped in value.items():
                one = self.application(name)
                if one.paused_told is None or one.paused_told <= t:
                    one.paused, one.stopped = True, stopped
        elif tag.startswith("application/"):
            self._stand_application(self.application(tag.removeprefix("application/")), value, t)
        elif tag == "situation" and self.situation_since <= t and value["name"] != self.situation:
            self.situation, self.situation_since = value["name"], t

    @staticmethod
    def _stand_application(one: ApplicationMoment, value: dict[str, Any], t: float) -> None:
        # Events between what was known and now may be lost: the robot forgets the oldest.
        if one.state is None or (one.since < t and one.state != value["state"]):
            one.state, one.since = value["state"], t
            one.begun = {value["state"]: t}
        if one.suspended_told is None or one.suspended_told <= t:
            one.suspended = value["suspended"]

    @property
    def breakpoints(self) -> tuple[dict[str, Any], ...]:
        """All of them, those on situations too."""
        entry = self.board.get(BREAKPOINTS)
        return tuple(entry.value) if entry is not None else ()

    def put_breakpoints(self) -> None:
        """Each application has its own."""
        for one in self.applications.values():
            one.breakpoints = ()
        for each in self.breakpoints:
            if (name := each.get("application")) is not None:
                self.application(name).breakpoints += (each,)

    def application(self, name: str) -> ApplicationMoment:
        return self.applications.setdefault(name, ApplicationMoment())


_Ways = dict[str, list[tuple[tuple[str, str, str | None, bool], int]]]
"""``crossed`` of each application: JSON has no keys but texts."""


def packed(moment: Moment) -> bytes:
    """A moment to be kept: a tenth of it or less."""
    bare = {name: replace(one, crossed={}) for name, one in moment.applications.items()}
    ways = {name: [*one.crossed.items()] for name, one in moment.applications.items()}
    return msgspec.json.encode((replace(moment, applications=bare), ways))


def unpacked(data: bytes) -> Moment:
    """What was packed."""
    moment, ways = _decode(data)
    for name, one in moment.applications.items():
        one.crossed = dict(ways[name])
    return moment


_decode = msgspec.json.Decoder(tuple[Moment, _Ways]).decode


def _data(now: Moment, event: TraceFields) -> None:
    if event["value"] is None:
        now.board.pop(event["tag"], None)
        now.gone[event["tag"]] = event["t"]
    else:
        now.board[event["tag"]] = Entry(event["value"], event["writer"], event["t"])
    if event["tag"] == BREAKPOINTS:
        now.put_breakpoints()


def _condition(now: Moment, event: TraceFields) -> None:
    (now.holding.add if event["holds"] else now.holding.discard)(event["situation"])


def _situation(now: Moment, event: TraceFields) -> None:
    now.situation, now.situation_since = event["to"], event["t"]


def _acquire(now: Moment, event: TraceFields) -> None:
    now.asking[event["module"]] = (*event["resources"], *event.get("optional", ()))


def _abandon(now: Moment, event: TraceFields) -> None:
    kept = tuple(r for r in now.asking.get(event["module"], ()) if r not in event["resources"])
    now.asking[event["module"]] = kept
    if not kept:
        del now.asking[event["module"]]


def _lost(now: Moment, event: TraceFields) -> None:
    now.asking.pop(event["module"], None)
    now.connected.discard(event["module"])


def _connected(now: Moment, event: TraceFields) -> None:
    now.connected.add(event["module"])


def _authority(now: Moment, event: TraceFields) -> None:
    if event["to"] is None:
        now.holders.pop(event["resource"], None)
    else:
        now.holders[event["resource"]] = (event["to"], event["t"])


def _mapping(now: Moment, event: TraceFields) -> None:
    now.robot[event["resource"]] = event["value"]


def _enter(now: Moment, event: TraceFields) -> None:
    application = now.application(event["application"])
    application.state, application.since = event["state"], event["t"]
    application.begun[event["state"]] = event["t"]
    application.entered[event["state"]] = application.entered.get(event["state"], 0) + 1


def _exit(now: Moment, event: TraceFields) -> None:
    application = now.application(event["application"])
    left = event["state"]
    since = application.begun.pop(left, application.since)
    application.spent[left] = application.spent.get(left, 0.0) + event["t"] - since


def _transition(now: Moment, event: TraceFields) -> None:
    application = now.application(event["application"])
    timeout = bool(event.get("timeout"))
    taken = Taken(event["from"], event["to"], event["event"], timeout, event["t"])
    application.taken = [*application.taken[1 - RECENT :], taken]
    key = (taken.source, taken.to, taken.event, timeout)
    application.crossed[key] = application.crossed.get(key, 0) + 1


def _suspend(now: Moment, event: TraceFields) -> None:
    application = now.application(event["application"])
    application.suspended, application.missing = True, tuple(event["missing"])
    application.suspended_told = event["t"]


def _resume(now: Moment, event: TraceFields) -> None:
    application = now.application(event["application"])
    application.suspended, application.missing = False, ()
    application.suspended_told = event["t"]


def _paused(now: Moment, event: TraceFields) -> None:
    application = now.application(event["application"])
    application.paused, application.stopped = True, event["breakpoint"]
    application.paused_told = event["t"]


def _resumed(now: Moment, event: TraceFields) -> None:
    application = now.application(event["application"])
    application.paused, application.stopped = False, None
    application.paused_told = event["t"]


ACCEPT: dict[str, Callable[[Moment, TraceFields], None]] = {
    "data": _data,
    "condition": _condition,
    "situation": _situation,
    "acquire": _acquire,
    "abandon": _abandon,
    "lost": _lost,
    "connected": _connected,
    "authority": _authority,
    "mapping": _mapping,
    "enter": _enter,
    "exit": _exit,
    "transition": _transition,
    "suspend": _suspend,
    "resume": _resume,
    "paused": _paused,
    "resumed": _resumed,
}
"""What an event of each kind changes; one of any other kind changes only the time."""
