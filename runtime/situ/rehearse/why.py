"""Why something happened, and why something did not.

``chain`` follows the causes of a trace back to the outside input; ``why_not`` finds what
stood in the way at a moment: the guard, the priority, the suspension or the input that
did not come, with the values then.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from msgspec.structs import replace

from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse.expect import fits
from situ.rehearse.past import Past
from situ.rehearse.reason import Answer, Reason
from situ.rehearse.recording import Fields, Recording
from situ.rehearse.stays import stays
from situ.rehearse.telling import moment
from situ.rehearse.ways import frames, leads_to, name_of_state, ways
from situ.rehearse.why_action import why_not_begun
from situ.rehearse.why_held import why_not_held, why_not_moved
from situ.rehearse.why_situation import why_not_current
from situ.rehearse.why_state import Stuck


def chain(events: Sequence[Fields], seq: int) -> list[Fields]:
    """The event ``seq`` and what caused it, the outside input or the start first.

    Where the trace begins later than a cause, the chain begins with the first that it has.
    UsageError where there is no such event.
    """
    by_seq = {event["seq"]: event for event in events}
    at = by_seq.get(seq)
    if at is None:
        last = max(by_seq, default=0)
        raise UsageError(f"there is no event {seq} in this trace; its last is {last}")
    found = [at]
    while at is not None and at["cause"] is not None and at["cause"] < at["seq"]:
        at = by_seq.get(at["cause"])
        if at is not None:
            found.append(at)
    return found[::-1]


def why_not(project: Project, recording: Recording, wanted: dict[str, Any], at: float) -> Answer:
    """Why no event with the fields ``wanted`` came at ``at`` seconds.

    ``wanted`` has a ``kind`` of ``KINDS`` and that kind's fields as in a trace; what
    is left out (the application, where there is one only) is found. What came of the moment
    counts. After the end of the recording the answer is of what it knows, and says where
    that ends. UsageError where it asks for what there is not.
    """
    kind = wanted.get("kind")
    answer = KINDS.get(kind) if isinstance(kind, str) else None
    if answer is None:
        raise UsageError(f"--not wants a “kind” of {', '.join(KINDS)}, not {kind}")
    events = recording.events
    happened = [e for e in events if e["t"] == at and fits(wanted, e)]
    if happened:
        return Answer(wanted=wanted, at=at, happened=happened[0])
    reasons = answer(_Question(project, recording, wanted, at))
    later = next((e for e in events if e["t"] > at and fits(wanted, e)), None)
    if later is not None:
        said = f"it did happen later, at {moment(later['t'])}"
        reasons = [*reasons, Reason(code="note", text=said, seq=later["seq"])]
    ends = recording.end if at > recording.end else None
    return Answer(wanted=wanted, at=at, reasons=tuple(reasons), ends=ends)


class _Question:
    """What is asked, and the robot as it was."""

    def __init__(
        self, project: Project, recording: Recording, wanted: dict[str, Any], at: float
    ) -> None:
        self.project = project
        self.recording = recording
        self.wanted = wanted
        self.at = at

    def field(self, *names: str) -> str:
        """A field that has to be there, under one of several names."""
        for name in names:
            value = self.wanted.get(name)
            if isinstance(value, str):
                return value
        raise UsageError(f"--not of kind {self.wanted['kind']} needs “{names[0]}”")

    def past(self, before: int | None = None) -> Past:
        past = Past(self.project, self.recording.whole)
        past.until(self.recording, self.at, before)
        return past

    def application(self) -> str:
        """The application meant: named, or the only one that has the state."""
        known = [one.name for one in self.project.applications.values()]
        named = self.wanted.get("application")
        if named is not None:
            if named not in known:
                raise UsageError(f"there is no application {named}, only {', '.join(known)}")
            return str(named)
        state = self.wanted.get("state", self.wanted.get("to"))
        able = [n for n in known if not isinstance(state, str) or frames(self.project, n, state)]
        if not able and len(known) == 1:
            raise UsageError(f"--not: {known[0]} has no state {state}")
        if len(able) != 1:
            which = ", ".join(able or known) or "none"
            raise UsageError(f"--not needs an “application” of {which}")
        return able[0]

    def stuck(self) -> tuple[Past, Stuck, str]:
        application = self.application()
        found, past = stays(self.project, self.recording, application, self.at)
        return past, Stuck(past, found, application, self.at), application


def _enter(asked: _Question) -> list[Reason]:
    state = asked.field("state")
    _, stuck, application = asked.stuck()
    here = [stay for stay in stuck.now() if stay.is_in(state)]
    if here:
        named, since = name_of_state(asked.project, application, state), here[-1].entered["t"]
        said = f"{application} was in {named} already, since {moment(since)}"
        return [Reason(code="already", text=said, seq=here[-1].entered["seq"])]
    return stuck.why_not_entered(state)


def _transition(asked: _Question) -> list[Reason]:
    to, source = asked.field("to"), asked.wanted.get("from")
    _, stuck, application = asked.stuck()
    inside = [stay for stay in stuck.now() if source is None or stay.is_in(source)]
    if isinstance(source, str) and not inside:
        return stuck.why_not_in(source)
    found = []
    for stay in inside:
        active = frames(asked.project, application, stay.state)
        levels = [frame.before for frame in active if source in (None, frame.no)]
        for way in ways(asked.project, application, stay.state):
            if way.before not in levels:
                continue
            name = None if way.event is None else way.event.name
            named = "event" not in asked.wanted or asked.wanted["event"] == name
            if named and leads_to(asked.project, application, way, stay.state, to):
                found += stuck.why_not_taken(stay, way)
    return found or stuck.why_not_entered(to)


def _situation(asked: _Question) -> list[Reason]:
    name, script = asked.field("to", "situation", "name"), asked.project.spds
    found = script.situation(name) if script is not None else None
    if script is None or found is None:
        known = ", ".join(s.name for s in script.situations) if script is not None else "none"
        raise UsageError(f"there is no situation {name}, only {known}")
    past = asked.past()
    if past.situation is not None and past.situation["to"] == name:
        said = f"{name} was current already, since {moment(past.situation['t'])}"
        return [Reason(code="already", text=said, seq=past.situation["seq"])]
    events = [event for event in asked.recording.events if event["t"] <= asked.at]
    return why_not_current(past, script, events, found)


def _authority(asked: _Question) -> list[Reason]:
    module, resource = asked.field("to", "module"), asked.field("resource")
    past = asked.past()
    found = why_not_held(past, module, resource)
    if found:
        return _while_it_asked(asked, past, module, resource, found)
    since = past.holders[resource]
    said = f"{module} held {resource} already, since {moment(since['t'])}"
    return [Reason(code="already", text=said, seq=since["seq"])]


def _mapping(asked: _Question) -> list[Reason]:
    past = asked.past()
    module, resource = asked.field("module"), asked.field("resource")
    return _while_it_asked(asked, past, module, resource, why_not_moved(past, module, resource))


def _while_it_asked(
    asked: _Question, past: Past, module: str, resource: str, found: list[Reason]
) -> list[Reason]:
    """Of a module that asked in vain and gave up: below that, what kept it from it until then."""
    in_vain = past.given_up.get((module, resource))
    if in_vain is None:
        return found
    ended = in_vain[1]["seq"]
    kept = tuple(why_not_held(asked.past(ended), module, resource))
    return [one if one.seq != ended else replace(one, below=kept) for one in found]


def _action(asked: _Question) -> list[Reason]:
    past, stuck, application = asked.stuck()
    return why_not_begun(past, stuck, application, asked.wanted)


def _event(asked: _Question) -> list[Reason]:
    name = asked.field("name")
    _, stuck, _ = asked.stuck()
    if not stuck.stays:
        return [stuck.not_started()]
    return [stuck.did_not_come(stuck.now()[-1], name)]


def _resume(asked: _Question) -> list[Reason]:
    _, stuck, application = asked.stuck()
    if not stuck.stays:
        return [stuck.not_started()]
    suspend = stuck.now()[-1].suspended
    if suspend is None:
        return [Reason(code="note", text=f"{application} was not suspended")]
    return [stuck.suspended(f"it could not go on, as {stuck.since(suspend)}", suspend)]


KINDS: dict[str, Callable[[_Question], list[Reason]]] = {
    "enter": _enter,
    "transition": _transition,
    "situation": _situation,
    "authority": _authority,
    "mapping": _mapping,
    "action": _action,
    "event": _event,
    "resume": _resume,
}
"""What can be asked for, by the kind of the trace event that did not come."""
