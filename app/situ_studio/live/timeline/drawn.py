"""What of a lane can be seen: never more than the screen has px for, whatever the lane's length.

No Qt. Time is the trace's own.
"""

from __future__ import annotations

from array import array
from bisect import bisect_left, bisect_right
from collections.abc import Sequence

from msgspec import Struct

from situ_studio.live.lanes import NAN, Lane, Series

CHUNK = 64
"""Numbers whose least and most are kept."""


class Block(Struct, frozen=True):
    """One value from ``start`` to ``end``; many: so many values, too short to be told apart."""

    start: float
    end: float
    value: str | None
    many: int = 1


def blocks(lane: Lane, start: float, end: float, least: float) -> list[Block]:
    """What the lane has from ``start`` to ``end``, seamlessly; what is shorter than ``least``
    seconds is put together with its neighbours. The last goes on to ``end``.
    """
    times, count = lane.t, len(lane.t)
    index = max(0, bisect_right(times, start) - 1)
    found: list[Block] = []
    while index < count and times[index] < end:
        begins = times[index]
        ends = times[index + 1] if index + 1 < count else end
        if ends - begins >= least or index + 1 == count:
            found.append(Block(begins, min(ends, end), lane.value[index]))
            index += 1
            continue
        # To the last that begins so soon; at least one further, for this one is shorter.
        after = bisect_left(times, begins + least, index + 1) - 1
        many = after - index
        if found and found[-1].many > 1:
            many += found[-1].many
            begins = found.pop().start
        elif many == 1:
            found.append(Block(begins, times[after], lane.value[index]))
            index = after
            continue
        found.append(Block(begins, times[after], None, many))
        index = after
    return found


class Strokes(Struct, frozen=True):
    """A series as it is drawn: for each px in which something is, its moment, the value that it
    begins with, the least and the most in it, and the one that it ends with. NaN: none.
    """

    t: list[float]
    first: list[float]
    low: list[float]
    high: list[float]
    last: list[float]

    @property
    def range(self) -> tuple[float, float] | None:
        """The least and the most of all; None where there is no number."""
        low = [value for value in self.low if value == value]
        high = [value for value in self.high if value == value]
        return (min(low), max(high)) if low else None


class Extremes:
    """Least and most of each ``CHUNK`` numbers of one series, gathered as it grows."""

    def __init__(self, series: Series) -> None:
        self.series = series
        self._begun = -(-series.gone // CHUNK)
        self._low: array[float] = array("d")
        self._high: array[float] = array("d")

    def strokes(self, start: float, end: float, pixel: float) -> Strokes:
        """What is to be drawn from ``start`` to ``end``, for px of so many seconds."""
        series = self.series
        self._gather()
        times, y = series.t, series.y
        index = max(0, bisect_right(times, start) - 1)
        made = Strokes([], [], [], [], [])
        while index < len(times) and times[index] < end:
            t = times[index]
            after = bisect_left(times, t + pixel, index + 1)
            low, high = self._between(index, after) if after - index > 1 else (y[index], y[index])
            made.t.append(t)
            made.first.append(y[index])
            made.low.append(low)
            made.high.append(high)
            made.last.append(y[after - 1])
            index = after
        return made

    def _gather(self) -> None:
        gone, y = self.series.gone, self.series.y
        first = -(-gone // CHUNK)
        if first > self._begun:
            del self._low[: first - self._begun]
            del self._high[: first - self._begun]
            self._begun = first
        while (begin := (self._begun + len(self._low)) * CHUNK - gone) + CHUNK <= len(y):
            low, high = _extremes(y[begin : begin + CHUNK])
            self._low.append(low)
            self._high.append(high)

    def _between(self, index: int, after: int) -> tuple[float, float]:
        gone, y = self.series.gone, self.series.y
        first = -(-(index + gone) // CHUNK)
        last = (after + gone) // CHUNK
        if first >= last:
            return _extremes(y[index:after])
        ends = (y[index : first * CHUNK - gone], y[last * CHUNK - gone : after])
        a, b = first - self._begun, last - self._begun
        low, _ = _extremes([*map(_low, ends), *self._low[a:b]])
        _, high = _extremes([*map(_high, ends), *self._high[a:b]])
        return low, high


def _low(values: Sequence[float]) -> float:
    return _extremes(values)[0]


def _high(values: Sequence[float]) -> float:
    return _extremes(values)[1]


def _extremes(values: Sequence[float]) -> tuple[float, float]:
    """Least and most; NaN counts only where there is nothing else."""
    total = sum(values)
    if total != total:
        values = [value for value in values if value == value]
    return (min(values), max(values)) if values else (NAN, NAN)
