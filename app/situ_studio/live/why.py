"""Why a thing is as it is: the event that made it so, and what that hangs on, back to the input.

``Thing`` is what is asked about. ``latest`` finds its event, ``trail`` what led to it; both go
through the log block by block and rest between two, for a log may have a million events. No Qt.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator
from typing import Literal

from msgspec import Struct

from situ.document.project import Project
from situ.rehearse.ways import frames
from situ_studio.live.lanes import Lane
from situ_studio.live.log import BLOCK, TraceLog
from situ_studio.live.moment import TraceFields

ThingKind = Literal[
    "event", "tag", "held", "resource", "module", "situation", "condition",
    "application", "halt", "state", "transition",
]  # fmt: skip
"""``resource`` is what it does, ``held`` who holds it; ``halt``: an application stands still."""


class Thing(Struct, frozen=True):
    """Something that a person asks about.

    name: of it; the seq of an event, the number of a state as its own file has it, the event of a
    transition. file: of a state or a transition. state: that a transition leads from; "": any.
    timeout: the transition is that of the timeout.
    """

    kind: ThingKind
    name: str
    file: str = ""
    state: str = ""
    timeout: bool = False


Fits = Callable[[TraceFields], bool]


def latest(log: TraceLog, project: Project, thing: Thing, t: float) -> Iterator[int | None]:
    """Yields None after each block that it has looked through, last the place of the event; ends
    without one where there is none up to ``t``.
    """
    if thing.kind == "event":
        place = log.place(int(thing.name))
        if place is not None:
            yield place
        return
    then = _when(log, project, thing, t)
    if then is not None:
        yield from _back(log, _fits(project, thing), then)


def _back(log: TraceLog, fits: Fits, t: float) -> Iterator[int | None]:
    run = log.lanes
    for place in range(log.count(t) - 1, -1, -1):
        if log.lanes is not run:
            # The robot was started again meanwhile: nothing of what was is kept.
            return
        if fits(log[place]):
            yield place
            return
        if place % BLOCK == 0:
            yield None


def _when(log: TraceLog, project: Project, thing: Thing, t: float) -> float | None:
    """From when on to look backwards; None: it never was so."""
    lanes = log.lanes
    match thing.kind:
        case "situation":
            return _last(lanes.situation, t, lambda name: name == thing.name)
        case "held":
            lane = lanes.holders.get(thing.name)
            return None if lane is None else _last(lane, t, lambda holder: True)
        case "module":
            held = (
                _last(lane, t, lambda holder: holder == thing.name)
                for lane in lanes.holders.values()
            )
            return t if any(then is not None for then in held) else None
        case "tag":
            moment = log.at(t)
            entry = moment.board.get(thing.name)
            return entry.t if entry is not None else moment.gone.get(thing.name)
        case "application":
            states = lanes.states.get(thing.name)
            return None if states is None else _last(states, t, lambda state: True)
        case "state":
            found = [
                then
                for application, lane in lanes.states.items()
                if (then := _begun(project, application, lane, thing, t)) is not None
            ]
            return max(found, default=None)
        case _:
            return t


def _last(lane: Lane, t: float, fits: Callable[[str | None], bool]) -> float | None:
    """When a value that fits was last taken on."""
    for index in range(bisect_right(lane.t, t) - 1, -1, -1):
        if fits(lane.value[index]):
            return lane.t[index]
    return None


def _begun(
    project: Project, application: str, lane: Lane, thing: Thing, t: float
) -> float | None:  # fmt: skip
    """When the state was last entered: of one that runs a part, from outside of the part."""
    index = bisect_right(lane.t, t) - 1
    while index >= 0 and not is_in(project, application, lane.value[index], thing):
        index -= 1
    if index < 0:
        return None
    while (
        index
        and _is_part(project, application, lane.value[index], thing)
        and is_in(project, application, lane.value[index - 1], thing)
    ):
        index -= 1
    return lane.t[index]


def is_in(project: Project, application: str, state: str | None, thing: Thing) -> bool:
    """Whether an application in ``state`` is in the one that is asked about, or in its part."""
    return state is not None and any(
        frame.file == thing.file and frame.state.no == thing.name
        for frame in frames(project, application, state)
    )


def _is_part(project: Project, application: str, state: str | None, thing: Thing) -> bool:
    active = frames(project, application, state) if state is not None else []
    return bool(active) and active[-1].file != thing.file


def _fits(project: Project, thing: Thing) -> Fits:
    name = thing.name

    def transition(event: TraceFields) -> bool:
        if event["kind"] != "transition" or bool(event.get("timeout")) != thing.timeout:
            return False
        if not thing.timeout and (event["event"] or "") != name:
            return False
        return any(
            frame.file == thing.file and thing.state in ("", frame.state.no)
            for frame in frames(project, event["application"], event["from"])
        )

    def state(event: TraceFields) -> bool:
        return event["kind"] == "enter" and is_in(
            project, event["application"], event["state"], thing
        )

    def module(event: TraceFields) -> bool:
        if event["kind"] == "mapping" and event["value"] is not None:
            return bool(event["module"] == name)
        return bool(event["kind"] == "authority" and event["to"] == name)

    every: dict[ThingKind, Fits] = {
        "tag": lambda e: e["kind"] == "data" and e["tag"] == name,
        "held": lambda e: e["kind"] == "authority" and e["resource"] == name,
        "resource": lambda e: e["kind"] == "mapping" and e["resource"] == name
        and e["value"] is not None,
        "module": module,
        "situation": lambda e: e["kind"] == "situation" and e["to"] == name,
        "condition": lambda e: e["kind"] == "condition" and e["situation"] == name,
        "application": lambda e: e["kind"] == "enter" and e["application"] == name,
        "halt": lambda e: e["kind"] in ("suspend", "paused") and e["application"] == name,
        "state": state,
        "transition": transition,
    }  # fmt: skip
    return every[thing.kind]


def trail(log: TraceLog, place: int) -> list[int]:
    """The places of an event and of all that it hangs on, the first first.

    Those are its causes; of what a module does by itself, how it came to hold the resource; and
    of that the situation that gave it the priority.
    """
    found: set[int] = set()
    waiting = [place]
    while waiting:
        here = waiting.pop()
        if here not in found:
            found.add(here)
            waiting += _before(log, here)
    return sorted(found)


def _before(log: TraceLog, place: int) -> Iterator[int]:
    event = log[place]
    if event["cause"] is not None and event["cause"] < event["seq"]:
        cause = log.place(event["cause"])
        if cause is not None:
            yield cause
    elif event["kind"] == "mapping" and event["module"] is not None:
        lane = log.lanes.holders.get(event["resource"])
        if lane is not None:
            yield from _at(log, lane, place, "authority", event["resource"])
    if event["kind"] == "authority" and event["to"] is not None:
        yield from _at(log, log.lanes.situation, place, "situation", None)


def _at(
    log: TraceLog, lane: Lane, place: int, kind: str, resource: str | None
) -> Iterator[int]:  # fmt: skip
    """The last event of a lane before ``place``: by the lane's times, without searching."""
    for index in range(bisect_right(lane.t, log.time(place)) - 1, -1, -1):
        first, behind = log.earlier(lane.t[index]), log.count(lane.t[index])
        for near in range(min(behind, place) - 1, first - 1, -1):
            event = log[near]
            if event["kind"] == kind and resource in (None, event.get("resource")):
                yield near
                return
