"""The time axis: which part of the time is seen, and where on the screen each moment is. No Qt."""

from __future__ import annotations

import math
from collections.abc import Iterator

USUAL = 30.0
"""Seconds that are seen at first."""
LEAST, MOST = 0.01, 366 * 24 * 3600.0
"""Seconds that can be seen at once."""
STEPS = (
    *(0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0),
    *(60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0, 7200.0, 14400.0, 43200.0, 86400.0),
)
"""Seconds between two marks, as clocks are read."""


class TimeAxis:
    """start: the moment at the left edge. seen: seconds from edge to edge. width: px."""

    def __init__(self) -> None:
        self.start = 0.0
        self.seen = USUAL
        self.width = 1.0

    @property
    def end(self) -> float:
        """The moment at the right edge."""
        return self.start + self.seen

    @property
    def pixel(self) -> float:
        """Seconds in a px."""
        return self.seen / self.width

    def x(self, t: float) -> float:
        """Px from the left edge; below 0 or above ``width`` where it is not seen."""
        return (t - self.start) / self.seen * self.width

    def sees(self, t: float) -> bool:
        """Whether that moment is on the screen, the edges included."""
        return -0.5 <= self.x(t) <= self.width + 0.5

    def t(self, x: float) -> float:
        """The moment that many px from the left edge."""
        return self.start + x * self.pixel

    def zoom(self, factor: float, about: float) -> None:
        """Sees ``factor`` times as much; the moment ``about`` stays where it is on the screen."""
        seen = min(max(self.seen * factor, LEAST), MOST)
        self.start = about - (about - self.start) * seen / self.seen
        self.seen = seen

    def pan(self, px: float) -> None:
        """Moves what is seen: to the right where ``px`` is above 0."""
        self.start -= px * self.pixel

    def show(self, t: float) -> None:
        """Moves until ``t`` is seen, in the middle; stays where it is seen already."""
        if not self.start <= t <= self.end:
            self.start = t - self.seen / 2

    def end_at(self, t: float, first: float = -math.inf) -> None:
        """Lets the right edge be at ``t``, on a whole px: what stands is drawn the same each time,
        and does not tremble. It never goes back by less than a second: the end of a robot that
        goes on is reckoned, and may have been reckoned too late. Of a run that has not lasted so
        long the left edge is at its ``first`` moment: there is nothing before.
        """
        if t - first <= self.seen:
            self.start = first
            return
        end = math.ceil(t / self.pixel) * self.pixel
        if not 0.0 <= self.end - end < 1.0 or self.end - t > self.seen / 4:
            self.start = end - self.seen

    def marks(self, apart: float, origin: float = 0.0) -> Iterator[float]:
        """The moments to be written at the edge, ``apart`` px from one another at least.

        origin: a moment at which the clock on the wall stood at 0.
        """
        least = apart * self.pixel
        step = next((step for step in STEPS if step >= least), None)
        if step is None:
            step = math.ceil(least / STEPS[-1]) * STEPS[-1]
        number = math.ceil((self.start - origin) / step)
        while (t := origin + number * step) <= self.end:
            yield t
            number += 1
