"""How far what is seen of a robot is behind it, and whether its clock goes as ours. No Qt."""

from __future__ import annotations

from msgspec import Struct

APART = 2.0
"""Seconds that two clocks on walls may differ without a word."""


class Delay(Struct, frozen=True):
    """behind: seconds from an event at the robot to here. apart: how far the robot's clock on the
    wall is behind ours, negative where it is ahead; 0 where it goes as ours."""

    behind: float
    apart: float = 0.0


class Delays:
    """Of one session: what differs from event to event is delay, what stays is the clocks.

    Between two clocks on walls a delay can not be told from clocks that differ; by those that never
    go back it is how much later an event came than the quickest.
    """

    def __init__(self) -> None:
        self._quickest: float | None = None

    def take(self, t: float, came: float, written: float, now: float) -> Delay:
        """An event: its t at the robot and when it came, by clocks that never go back; what the
        clocks on the walls said there and say here. All in seconds."""
        way = came - t
        self._quickest = way if self._quickest is None else min(self._quickest, way)
        late, apart = way - self._quickest, now - written
        if -APART < apart - late < APART:
            return Delay(max(apart, 0.0))
        return Delay(late, apart - late)
