"""What a trace tells of each thing over all of its time: lanes for a time axis.

A lane is two columns of the same length, times in order; a value holds until the next.
"""

from __future__ import annotations

import sys
from array import array
from bisect import bisect_right
from collections.abc import Callable
from typing import Any, NamedTuple

from msgspec import Struct, field

NAN = float("nan")


class Lane(Struct):
    """Names over time: a state, a situation, who holds a resource; None is nothing or nobody."""

    t: array[float] = field(default_factory=lambda: array("d"))
    value: list[str | None] = field(default_factory=list)

    def add(self, t: float, value: str | None) -> None:
        while self.t and self.t[-1] > t:
            # It stood there, and the trace tells only now what was before.
            del self.t[-1], self.value[-1]
        self.t.append(t)
        # Few names, however many events.
        self.value.append(value if value is None else sys.intern(value))

    def at(self, t: float) -> str | None:
        """What holds at ``t``; None before the first."""
        index = bisect_right(self.t, t)
        return self.value[index - 1] if index else None

    def ends(self, t: float, last: float) -> float:
        """Until when holds what holds at ``t``: until ``last`` where nothing came after."""
        index = bisect_right(self.t, t)
        return self.t[index] if index < len(self.t) else last

    def forget(self, before: float) -> None:
        """Drops what ended before that."""
        index = max(0, bisect_right(self.t, before) - 1)
        del self.t[:index]
        del self.value[:index]


class Series(Struct):
    """Numbers over time; true and false are 1 and 0, a value that is deleted or none is NaN.

    truth: the first was true or false. gone: how many were dropped.
    """

    t: array[float] = field(default_factory=lambda: array("d"))
    y: array[float] = field(default_factory=lambda: array("d"))
    truth: bool = False
    gone: int = 0

    def add(self, t: float, y: float) -> None:
        self.t.append(t)
        self.y.append(y)

    def at(self, t: float) -> float:
        """What holds at ``t``; NaN before the first."""
        index = bisect_right(self.t, t)
        return self.y[index - 1] if index else NAN

    def forget(self, before: float) -> None:
        """Drops what ended before that."""
        index = max(0, bisect_right(self.t, before) - 1)
        self.gone += index
        del self.t[:index]
        del self.y[:index]


class Deployed(NamedTuple):
    """From then on another version of the project ran."""

    t: float
    seq: int
    version: int


class Lanes(Struct):
    """All of a trace. states: of an application. data: of a tag whose values are numbers.

    deployed: every version that took over, also before the first event that is kept.
    """

    situation: Lane = field(default_factory=Lane)
    states: dict[str, Lane] = field(default_factory=dict)
    holders: dict[str, Lane] = field(default_factory=dict)
    data: dict[str, Series] = field(default_factory=dict)
    deployed: list[Deployed] = field(default_factory=list)
    start: float = 0.0
    end: float = 0.0

    def stand(self, tag: str, value: Any, writer: str | None, t: float) -> None:
        """What stands on the blackboard since ``t``: begins a lane that no event has begun."""
        lane: Lane | None = None
        if tag.startswith("application/") and isinstance(value, dict):
            lane = _lane(self.states, tag.removeprefix("application/"))
            name = value["state"]
        elif tag == "situation" and isinstance(value, dict):
            lane, name = self.situation, value["name"]
        elif tag.startswith("robot/") and value is not None and writer is not None:
            lane, name = _lane(self.holders, tag.removeprefix("robot/")), writer
        if lane is not None and not lane.t:
            lane.add(t, name)

    def forget(self, before: float) -> None:
        """Drops what ended before that, of everything."""
        self.start = before
        self.situation.forget(before)
        for lane in (*self.states.values(), *self.holders.values()):
            lane.forget(before)
        for series in self.data.values():
            series.forget(before)


def _data(lanes: Lanes, event: dict[str, Any]) -> None:
    value, series = event["value"], lanes.data.get(event["tag"])
    if isinstance(value, int | float):
        if series is None:
            series = lanes.data[event["tag"]] = Series(truth=isinstance(value, bool))
        try:
            y = float(value)
        except OverflowError:
            # An integer that no floating point number is near: it can not be drawn.
            y = NAN
        series.add(event["t"], y)
    elif series is not None:
        series.add(event["t"], NAN)


def _enter(lanes: Lanes, event: dict[str, Any]) -> None:
    _lane(lanes.states, event["application"]).add(event["t"], event["state"])


def _situation(lanes: Lanes, event: dict[str, Any]) -> None:
    lanes.situation.add(event["t"], event["to"])


def _authority(lanes: Lanes, event: dict[str, Any]) -> None:
    _lane(lanes.holders, event["resource"]).add(event["t"], event["to"])


def _deployed(lanes: Lanes, event: dict[str, Any]) -> None:
    lanes.deployed.append(Deployed(event["t"], event["seq"], event["version"]))


def _lane(lanes: dict[str, Lane], name: str) -> Lane:
    lane = lanes.get(name)
    if lane is None:
        lane = lanes[name] = Lane()
    return lane


TAKE: dict[str, Callable[[Lanes, dict[str, Any]], None]] = {
    "data": _data,
    "enter": _enter,
    "situation": _situation,
    "authority": _authority,
    "deployed": _deployed,
}
"""What a trace event of each kind adds; one of any other kind adds nothing."""
