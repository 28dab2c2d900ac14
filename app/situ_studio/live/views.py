"""What the canvases show of a moment: pure functions of document and trace."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from situ.document.rbd import AGAIN, BACK, Application
from situ_studio.canvas.live import LiveScript, LiveView, Taken
from situ_studio.live.moment import ApplicationMoment, Moment
from situ_studio.live.moment import Taken as Crossed

TIMEOUT = "timeout"


def live_view(application: Application, moment: ApplicationMoment, t: float) -> LiveView:
    """How an application's graph glows at ``t`` (seconds of the trace).

    Transitions of a document that is not the robot's are left out where they fit nothing.
    """
    if moment.state is None:
        return LiveView()
    counted: dict[tuple[str, str], int] = {}
    for (source, to, event, timeout), count in moment.crossed.items():
        way = exit_of(application, Crossed(source, to, event, timeout, t))
        if way is not None:
            counted[source, way] = counted.get((source, way), 0) + count
    latest = []
    for crossed in reversed(moment.taken):
        way = exit_of(application, crossed)
        if way is not None:
            latest.append(Taken(crossed.source, way, t - crossed.t))
    # Inside a part (``5/q``) it is the state that holds the part that glows here.
    active = moment.state.partition("/")[0]
    here = frozenset({active})
    return LiveView(
        active=here,
        suspended=here if moment.suspended else frozenset(),
        entered={active: t - moment.since},
        counts=moment.entered,
        times={
            **moment.spent,
            active: moment.spent.get(active, 0.0) + t - moment.since,
        },
        taken=tuple(latest),
        transitions=counted,
        breakpoints=frozenset(map(_broken_at, moment.breakpoints)),
        paused=here if moment.paused else frozenset(),
    )


def _broken_at(breakpoint: Mapping[str, Any]) -> str:
    """The card that shows it: of a transition that which it leaves, or else comes to."""
    path = breakpoint.get("state") or breakpoint.get("from") or breakpoint.get("to") or ""
    return str(path).partition("/")[0]


def exit_of(application: Application, crossed: Crossed) -> str | None:
    """Which exit of the state was taken: an event's position, ``timeout``, or None (``always``)."""
    state = application.state(crossed.source)
    if state is None:
        return None
    if crossed.timeout:
        return TIMEOUT if state.timeout is not None else None
    for position, event in enumerate(state.events):
        if event.name == crossed.event and event.next in (crossed.to, AGAIN, BACK):
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
