"""What the canvases show of a moment: pure functions of document and trace."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from msgspec.structs import replace

from situ.document.project import Project
from situ.document.rbd import AGAIN, BACK, Application, State
from situ.rehearse.ways import states
from situ_studio.canvas.live import LiveScript, LiveView, Taken
from situ_studio.live.moment import ApplicationMoment, Moment

TIMEOUT = "timeout"

Runs = Mapping[str, Sequence[tuple[str, str]]]
"""File to (application, what stands before the numbers of its states there: ``5/``, or nothing)."""


def runs_of(project: Project) -> Runs:
    """Where each application runs, and each part: in every state that holds it."""
    found: dict[str, dict[tuple[str, str], None]] = {}
    for application in project.applications.values():
        for frame in states(project, application.name):
            found.setdefault(frame.file, {})[application.name, frame.before] = None
    return {file: tuple(every) for file, every in found.items()}


def live_view(application: Application, moment: ApplicationMoment, t: float) -> LiveView:
    """How an application's graph glows at ``t`` (seconds of the trace).

    Transitions of a document that is not the robot's are left out where they fit nothing.
    """
    # In one go: an application of 500 states is drawn many times a second.
    known = {state.no: state for state in reversed(application.states)}
    counted: dict[tuple[str, str], int] = {}
    gave_up: Counter[str] = Counter()
    for (source, to, event, timeout), count in moment.crossed.items():
        if timeout:
            gave_up[source] += count
        way = exit_of(known.get(source), to, event, timeout)
        if way is not None:
            counted[source, way] = counted.get((source, way), 0) + count
    latest = []
    for crossed in reversed(moment.taken):
        way = exit_of(known.get(crossed.source), crossed.to, crossed.event, crossed.timeout)
        if way is not None:
            latest.append(Taken(crossed.source, way, t - crossed.t))
    view = LiveView(
        counts=moment.entered,
        times=moment.spent,
        gave_up=gave_up,
        taken=tuple(latest),
        transitions=counted,
        breakpoints=frozenset(map(_broken_at, moment.breakpoints)),
    )
    if moment.state is None:
        return view
    # Inside a part (``5/q``) it is the state that holds the part that glows here.
    active = moment.state.partition("/")[0]
    here = frozenset({active})
    lasts = t - moment.begun.get(active, moment.since)
    return replace(
        view,
        active=here,
        suspended=here if moment.suspended else frozenset(),
        entered={active: lasts},
        times={**moment.spent, active: moment.spent.get(active, 0.0) + lasts},
        paused=here if moment.paused else frozenset(),
    )


def live_part(
    part: Application, moment: Moment, runs: Iterable[tuple[str, str]], t: float
) -> LiveView:
    """How a part's graph glows: what it was run by counts together."""
    every = [
        live_view(part, inside(moment.applications[name], before), t)
        for name, before in runs
        if name in moment.applications
    ]
    counts, gave_up, ways = Counter[str](), Counter[str](), Counter[tuple[str, str]]()
    entered: dict[str, float] = {}
    times: dict[str, float] = {}
    for one in every:
        counts.update(one.counts)
        gave_up.update(one.gave_up)
        ways.update(one.transitions)
        for no, seconds in one.times.items():
            times[no] = times.get(no, 0.0) + seconds
        for no, seconds in one.entered.items():
            entered[no] = max(seconds, entered.get(no, 0.0))
    return LiveView(
        active=frozenset[str]().union(*(one.active for one in every)),
        suspended=frozenset[str]().union(*(one.suspended for one in every)),
        entered=entered,
        counts=counts,
        times=times,
        gave_up=gave_up,
        taken=tuple(sorted((way for one in every for way in one.taken), key=lambda way: way.age)),
        transitions=ways,
        breakpoints=frozenset[str]().union(*(one.breakpoints for one in every)),
        paused=frozenset[str]().union(*(one.paused for one in every)),
    )


def inside(moment: ApplicationMoment, before: str) -> ApplicationMoment:
    """What of an application was in the part behind ``before`` (``5/``), as that calls it."""

    def own(path: str | None) -> str | None:
        return path[len(before) :] if path is not None and path.startswith(before) else None

    def its(values: Mapping[str, Any]) -> dict[str, Any]:
        return {path[len(before) :]: v for path, v in values.items() if path.startswith(before)}

    crossed = {
        (source[len(before) :], own(to) or to, event, timeout): count
        for (source, to, event, timeout), count in moment.crossed.items()
        if source.startswith(before)
    }
    return replace(
        moment,
        state=own(moment.state),
        entered=its(moment.entered),
        begun=its(moment.begun),
        spent=its(moment.spent),
        crossed=crossed,
        taken=[
            replace(way, source=way.source[len(before) :], to=own(way.to) or way.to)
            for way in moment.taken
            if way.source.startswith(before)
        ],
        breakpoints=tuple(
            {**one, **{key: own(one.get(key)) for key in _PATHS}}
            for one in moment.breakpoints
            if any(own(one.get(key)) is not None for key in _PATHS)
        ),
    )


_PATHS = ("state", "from", "to")


def _broken_at(breakpoint: Mapping[str, Any]) -> str:
    """The card that shows it: of a transition that which it leaves, or else comes to."""
    path = breakpoint.get("state") or breakpoint.get("from") or breakpoint.get("to") or ""
    return str(path).partition("/")[0]


def exit_of(state: State | None, to: str, event: str | None, timeout: bool) -> str | None:
    """Which exit of the state was taken: an event's position, ``timeout``, or None (``always``, or
    of another document). Of several of that name first the one that names where it went.
    """
    if state is None:
        return None
    if timeout:
        return TIMEOUT if state.timeout is not None else None
    for goals in ((to,), (AGAIN,) if to == state.no else (), (BACK,)):
        for position, way in enumerate(state.events):
            if way.name == event and way.next in goals:
                return str(position)
    return None


def live_script(moment: Moment) -> LiveScript:
    """How a script's graph glows."""
    return LiveScript(
        situation=moment.situation,
        holds=frozenset(moment.holding),
        authority={resource: holder for resource, (holder, _) in moment.holders.items()},
        asking=moment.asking,
        values={tag: entry.value for tag, entry in moment.board.items()},
        breakpoints=frozenset(
            one["situation"] for one in moment.breakpoints if one.get("situation") is not None
        ),
    )
