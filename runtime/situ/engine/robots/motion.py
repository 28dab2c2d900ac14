"""Motion as pure functions of time: where a base or head is, t seconds after it began.

Metres, degrees and seconds; headings grow counter-clockwise, 0 along x.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from typing import Protocol

from msgspec import Struct

DRIVE_SPEED = 0.5
TURN_SPEED = 60.0
GAZE_SPEED = 120.0


class Motion(Protocol):
    """duration: seconds until it ends by itself; infinite for one that does not."""

    @property
    def duration(self) -> float: ...

    def at(self, t: float) -> tuple[float, ...]:
        """The values t seconds after it began; those at the end for any later t."""
        ...


class Hold(Struct, frozen=True):
    """Stays where it is."""

    values: tuple[float, ...]

    @property
    def duration(self) -> float:
        return 0.0

    def at(self, t: float) -> tuple[float, ...]:
        return self.values


class Path(Struct, frozen=True):
    """Straight from point to point, each reached at its time; the first time is 0."""

    times: tuple[float, ...]
    points: tuple[tuple[float, ...], ...]

    @property
    def duration(self) -> float:
        return self.times[-1]

    def at(self, t: float) -> tuple[float, ...]:
        if t >= self.times[-1]:
            return self.points[-1]
        after = max(1, bisect_right(self.times, t))
        begun, ends = self.times[after - 1], self.times[after]
        part = max(0.0, (t - begun) / (ends - begun))
        return tuple(
            a + (b - a) * part
            for a, b in zip(self.points[after - 1], self.points[after], strict=True)
        )


class Round(Struct, frozen=True):
    """The same path over and over, from its second point on; never ends."""

    path: Path
    begin: float

    @property
    def duration(self) -> float:
        return math.inf

    def at(self, t: float) -> tuple[float, ...]:
        if t > self.path.duration:
            t = self.begin + (t - self.begin) % (self.path.duration - self.begin)
        return self.path.at(t)


class Drift(Struct, frozen=True):
    """A base (x, y, heading) at constant velocity.

    vx ahead and vy to the left in m/s, turn in deg/s.
    """

    start: tuple[float, ...]
    vx: float = 0.0
    vy: float = 0.0
    turn: float = 0.0

    @property
    def duration(self) -> float:
        return math.inf

    def at(self, t: float) -> tuple[float, ...]:
        x, y, heading = self.start
        # The chord of the arc: it points half the turn aside, and is the shorter for it.
        half = math.radians(self.turn) * t / 2
        chord = t * (math.sin(half) / half if abs(half) > 1e-9 else 1.0)
        middle = math.radians(heading) + half
        along, across = chord * math.cos(middle), -chord * math.sin(middle)
        return (
            x + self.vx * along + self.vy * across,
            y - self.vx * across + self.vy * along,
            heading + self.turn * t,
        )


def path(start: tuple[float, ...], *legs: tuple[tuple[float, ...], float]) -> Path:
    """A path of legs (point, seconds); those that take no time are left out."""
    times, points = [0.0], [start]
    for point, seconds in legs:
        if seconds > 0:
            times.append(times[-1] + seconds)
            points.append(point)
    return Path(tuple(times), tuple(points))


def turn_to(heading: float, wanted: float) -> float:
    """``wanted`` as the nearest equal angle: less than half a turn away from ``heading``."""
    return heading + (wanted - heading + 180.0) % 360.0 - 180.0


def drive_to(start: tuple[float, ...], place: tuple[float, float, float]) -> Path:
    """Turns towards the place, drives there straight, and turns as the place says. For a
    millimetre it does not drive."""
    x, y, heading = start
    goal_x, goal_y, goal_heading = place
    distance = math.hypot(goal_x - x, goal_y - y)
    legs = []
    if distance > 0.001:
        towards = turn_to(heading, math.degrees(math.atan2(goal_y - y, goal_x - x)))
        legs.append(((x, y, towards), abs(towards - heading) / TURN_SPEED))
        legs.append(((goal_x, goal_y, towards), distance / DRIVE_SPEED))
        x, y, heading = goal_x, goal_y, towards
    last = turn_to(heading, goal_heading)
    legs.append(((x, y, last), abs(last - heading) / TURN_SPEED))
    return path(start, *legs)


def sweep(start: tuple[float, ...], *targets: tuple[float, ...]) -> Path:
    """A gaze (yaw, pitch) over the targets, both angles together, at ``GAZE_SPEED``."""
    legs, last = [], start
    for target in targets:
        farthest = max(abs(b - a) for a, b in zip(last, target, strict=True))
        legs.append((target, farthest / GAZE_SPEED))
        last = target
    return path(start, *legs)
