"""Why not?: what is asked of a selected place, and the answer of the runtime to it. No Qt.

The runtime folds a trace from its beginning. Of a long one the last ``MOST`` events are given, and
before them the robot as it was then: what was asked for as ``optional`` counts as needed there.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from msgspec import Struct

from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK, Action
from situ.errors import UsageError
from situ.rehearse.clock import Hidden, followed
from situ.rehearse.reason import Answer
from situ.rehearse.recording import Recording
from situ.rehearse.telling import kept_by_runtime
from situ.rehearse.ways import Way, frames, ways
from situ.rehearse.why import why_not
from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place
from situ_studio.live.log import TraceLog
from situ_studio.live.moment import Moment, TraceFields

Wanted = dict[str, Any]
"""The fields of an event that did not come, as ``situ.rehearse.why`` takes them."""
MOST = 20_000
"""Events that are looked through, about two seconds of another process."""


class Question(Struct, frozen=True):
    """events: up to ``at`` seconds. clock: the writes of ``clock.…`` that were seen by then."""

    project: Project
    events: tuple[TraceFields, ...]
    wanted: Wanted
    at: float
    clock: tuple[Hidden, ...] = ()


def answered(question: Question) -> Answer | str:
    """The answer, or in one line why there is none."""
    events = question.events
    recording = Recording.of(events, followed(events, question.clock))
    try:
        return why_not(question.project, recording, question.wanted, question.at)
    except UsageError as error:
        return str(error)


# -- the trace ------------------------------------------------------------------------


def events_until(log: TraceLog, t: float, most: int = MOST) -> tuple[TraceFields, ...]:
    """What happened up to ``t``: all of it, or what was then and the last ``most`` events."""
    count = log.count(t)
    first = max(count - most, 0)
    before = tuple(standing(log.after(first))) if first else ()
    return (*before, *(log[place] for place in range(first, count)))


def standing(moment: Moment) -> list[TraceFields]:
    """Events of seq 0 that make a robot what it was at a moment, in order of their times."""
    found = list(_standing(moment))
    return sorted(found, key=lambda event: float(event["t"]))


def _standing(moment: Moment) -> Iterator[TraceFields]:
    for tag, entry in moment.board.items():
        if not kept_by_runtime(tag):
            yield _event("data", entry.t, tag=tag, value=entry.value, writer=entry.writer)
    for situation in sorted(moment.holding):
        yield _event("condition", moment.situation_since, situation=situation, holds=True)
    if moment.situation is not None:
        since = moment.situation_since
        yield _event("situation", since, **{"from": None, "to": moment.situation})
    for module, wanted in moment.asking.items():
        yield _event("acquire", 0.0, module=module, resources=list(wanted))
    for resource, (holder, since) in moment.holders.items():
        yield _event("authority", since, resource=resource, **{"from": None, "to": holder})
    for resource, value in moment.robot.items():
        mover, _ = moment.holders.get(resource, (None, 0.0))
        yield _event("mapping", moment.t, resource=resource, module=mover, value=value)
    for name, one in moment.applications.items():
        if one.state is not None:
            yield _event("enter", one.since, application=name, state=one.state)
        if one.suspended:
            yield _event("suspend", moment.t, application=name, missing=list(one.missing))


def _event(kind: str, t: float, **fields: Any) -> TraceFields:
    return {"kind": kind, "seq": 0, "t": t, "cause": None, **fields}


# -- what is asked ----------------------------------------------------------------------


def wanted_at(
    project: Project, file: str, document: Document, place: Place, moment: Moment
) -> Wanted | None:
    """The event that a selected place stands for; None where it stands for none.

    Of a module that is the first of its resources that it does not hold; where it holds all, that
    it moves one. Of a resource, that its holder moves it.
    """
    if file in project.applications or file in project.parts:
        return _in_application(project, file, document, place, moment)
    if document is not project.spds:
        return None
    match place:
        case ("situation", name, "condition" | "until", *_) | ("situation", name):
            return {"kind": "situation", "to": name}
        case ("situation", _, "module", name, *_):
            return _of_module(project, name, moment)
        case ("situation", _, "entry", *_):
            entry = places.get(document, place[:4])
            return _of_module(project, entry.module, moment) if entry is not None else None
        case ("module", name, "resource", resource):
            return _of_resource(name, resource, moment)
        case ("module", name, *_):
            return _of_module(project, name, moment)
        case ("resource", resource) if resource in moment.holders:
            return _of_resource(moment.holders[resource][0], resource, moment)
    return None


def _of_module(project: Project, module: str, moment: Moment) -> Wanted | None:
    resources = project.resources(module) or moment.asking.get(module, ())
    lacking = [r for r in resources if moment.holders.get(r, (None, 0.0))[0] != module]
    every = lacking or list(resources)
    return _of_resource(module, every[0], moment) if every else None


def _of_resource(module: str, resource: str, moment: Moment) -> Wanted:
    """That it holds the resource; where it does, that it moves it."""
    if moment.holders.get(resource, (None, 0.0))[0] == module:
        return {"kind": "mapping", "module": module, "resource": resource}
    return {"kind": "authority", "to": module, "resource": resource}


def _in_application(
    project: Project, file: str, document: Document, place: Place, moment: Moment
) -> Wanted | None:
    if place[:1] == ("state",) and len(place) > 1:
        found = next(_numbers(project, file, place[1]), None)
    elif place[:1] == ("always",):
        # It is part of every state: what is meant is the one in which the robot is.
        found = next(_now_in(project, file, moment), None)
    else:
        return None
    if found is None:
        return None
    application, no = found
    inner = places.get(document, place)
    if isinstance(inner, Action) and place[2:3] == ("action",):
        wanted = {"kind": "action", "application": application, "state": no}
        return {**wanted, "action": inner.element}
    raises = getattr(inner, "event", None) if places.is_component(place) else None
    every = ways(project, application, no)
    for way in every:
        mine = way.file == file and place[: len(way.place)] == way.place
        if mine or (raises and way.event is not None and way.event.name == raises):
            return way_wanted(application, no, way)
    if place[:1] == ("always",):
        return None
    return {"kind": "enter", "application": application, "state": no}


def way_wanted(application: str, no: str, way: Way) -> Wanted:
    """The event that a way out of the state ``no`` stands for."""
    name = way.event.name if way.event is not None else None
    if way.to in (None, AGAIN, BACK) and name:
        return {"kind": "event", "application": application, "name": name}
    to = no if way.to in (None, AGAIN, BACK) else way.to
    wanted = {"kind": "transition", "application": application, "from": no, "to": to}
    return {**wanted, "event": name}


def _now_in(project: Project, file: str, moment: Moment) -> Iterator[tuple[str, str]]:
    """(application, full number) of the states in which something of a file runs now."""
    for name, one in moment.applications.items():
        if one.state is not None and any(
            frame.file == file for frame in frames(project, name, one.state)
        ):
            yield name, one.state


def _numbers(project: Project, file: str, no: str) -> Iterator[tuple[str, str]]:
    """(application, full number) of a state of a file; of a part's, wherever that runs."""
    if file in project.applications:
        yield project.applications[file].name, no
    for outer, document in project.flows.items():
        for state in document.states:
            if state.flow == file:
                for application, prefix in _numbers(project, outer, state.no):
                    full = f"{prefix}/{no}"
                    if frames(project, application, full):
                        yield application, full
