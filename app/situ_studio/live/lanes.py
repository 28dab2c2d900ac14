"""What a trace tells of each thing over all of its time: lanes for a time axis.

A lane is two columns of the same length, times in order; a value holds until the next.
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from typing import Any

from msgspec import Struct, field


class Lane(Struct):
    """Names over time: a state, a situation, who holds a resource; None is nothing or nobody."""

    t: array[float] = field(default_factory=lambda: array("d"))
    value: list[str | None] = field(default_factory=list)

    def add(self, t: float, value: str | None) -> None:
        self.t.append(t)
        self.value.append(value)

    def at(self, t: float) -> str | None:
        """What holds at ``t``; None before the first."""
        index = bisect_right(self.t, t)
        return self.value[index - 1] if index else None

    def forget(self, before: float) -> None:
        """Drops what ended before that."""
        index = max(0, bisect_right(self.t, before) - 1)
        del self.t[:index]
        del self.value[:index]


class Series(Struct):
    """Numbers over time; true and false are 1 and 0, a value that is deleted or none is NaN."""

    t: array[float] = field(default_factory=lambda: array("d"))
    y: array[float] = field(default_factory=lambda: array("d"))

    def add(self, t: float, y: float) -> None:
        self.t.append(t)
        self.y.append(y)

    def forget(self, before: float) -> None:
        """Drops what ended before that."""
        index = max(0, bisect_right(self.t, before) - 1)
        del self.t[:index]
        del self.y[:index]


NAN = float("nan")


class Lanes(Struct):
    """All of a trace. states: of an application. data: of a tag whose values are numbers."""

    situation: Lane = field(default_factory=Lane)
    states: dict[str, Lane] = field(default_factory=dict)
    holders: dict[str, Lane] = field(default_factory=dict)
    data: dict[str, Series] = field(default_factory=dict)
    start: float = 0.0
    end: float = 0.0

    def take(self, event: dict[str, Any]) -> None:
        """Goes on by one trace event."""
        kind, t = event["kind"], event["t"]
        self.end = t
        if kind == "data":
            value = event["value"]
            if isinstance(value, int | float):
                series = self.data.get(event["tag"])
                if series is None:
                    series = self.data[event["tag"]] = Series()
                series.add(t, float(value))
            elif event["tag"] in self.data:
                self.data[event["tag"]].add(t, NAN)
        elif kind == "enter":
            self._lane(self.states, event["application"]).add(t, event["state"])
        elif kind == "situation":
            self.situation.add(t, event["to"])
        elif kind == "authority":
            self._lane(self.holders, event["resource"]).add(t, event["to"])

    def forget(self, before: float) -> None:
        """Drops what ended before that, of everything."""
        self.start = before
        self.situation.forget(before)
        for lane in (*self.states.values(), *self.holders.values()):
            lane.forget(before)
        for series in self.data.values():
            series.forget(before)

    def _lane(self, lanes: dict[str, Lane], name: str) -> Lane:
        lane = lanes.get(name)
        if lane is None:
            lane = lanes[name] = Lane()
        return lane
