"""Steering of a base with wheels on two sides: how fast ahead, and how fast round.

A ``Course`` looks at where the base is and says what it should do next; it knows no wheel
and no clock. Metres, degrees and seconds; headings grow counter-clockwise, 0 along x, and
are counted on past a full turn.
"""

from __future__ import annotations

import math
from enum import Enum
from typing import Protocol

from msgspec import Struct

from situ.engine.robots.motion import turn_to

Pose = tuple[float, float, float]
Twist = tuple[float, float]
"""Ahead in m/s, round in deg/s."""

NEAR = 0.02
"""Metres from a place within which the base is there."""
PASSED = 0.1
"""Metres beside a place that are near enough where the base has driven past."""
ALIGNED = 1.0
"""Degrees from a heading within which it is that way."""
PATIENCE = 3.0
"""Seconds without coming nearer after which the way is blocked."""

_AHEAD, _ROUND = 0.01, 1.0
"""Metres or degrees nearer that count as coming nearer."""
_CORRECTION = 2.0
"""deg/s for each degree that the base drives aside of where it should."""


class Limits(Struct, frozen=True):
    """How fast a robot is on its own ways, m/s and deg/s, and how hard it slows down, per s."""

    speed: float
    turn: float
    slowing: float
    turn_slowing: float


class Leg(Protocol):
    """A part of a course."""

    def left(self, pose: Pose) -> tuple[float, float]:
        """What is left of it, and what counts as coming nearer; nothing left: it is done."""
        ...

    def twist(self, pose: Pose, limits: Limits) -> Twist: ...


class Face(Struct, frozen=True):
    """Turns on the spot until the heading is ``heading``."""

    heading: float

    def left(self, pose: Pose) -> tuple[float, float]:
        error = abs(self.heading - pose[2])
        return (0.0 if error < ALIGNED else error), _ROUND

    def twist(self, pose: Pose, limits: Limits) -> Twist:
        error = self.heading - pose[2]
        return 0.0, math.copysign(_slowed(abs(error), limits.turn, limits.turn_slowing, 4.0), error)


class Straight(Struct, frozen=True):
    """Drives along ``heading`` from (x, y) for ``distance`` metres; a negative one backwards."""

    x: float
    y: float
    heading: float
    distance: float

    def _ahead(self, pose: Pose) -> float:
        """Metres still to drive; negative where it has to go back."""
        angle = math.radians(self.heading)
        driven = (pose[0] - self.x) * math.cos(angle) + (pose[1] - self.y) * math.sin(angle)
        return self.distance - driven

    def left(self, pose: Pose) -> tuple[float, float]:
        ahead = self._ahead(pose) * math.copysign(1.0, self.distance)
        return (0.0 if ahead < NEAR / 2 else ahead), _AHEAD

    def twist(self, pose: Pose, limits: Limits) -> Twist:
        ahead = self._ahead(pose)
        speed = math.copysign(_slowed(abs(ahead), limits.speed, limits.slowing, 0.03), ahead)
        return speed, _CORRECTION * (self.heading - pose[2])


class Reach(Struct, frozen=True):
    """Drives to (x, y), correcting its way there."""

    x: float
    y: float

    def _way(self, pose: Pose) -> tuple[float, float]:
        """Metres to the place, and degrees that it lies aside."""
        dx, dy = self.x - pose[0], self.y - pose[1]
        towards = turn_to(pose[2], math.degrees(math.atan2(dy, dx)))
        return math.hypot(dx, dy), towards - pose[2]

    def left(self, pose: Pose) -> tuple[float, float]:
        distance, aside = self._way(pose)
        # What it has passed so near, it does not turn round for.
        passed = distance < PASSED and abs(aside) >= 90.0
        return (0.0 if distance < NEAR or passed else distance), _AHEAD

    def twist(self, pose: Pose, limits: Limits) -> Twist:
        distance, aside = self._way(pose)
        if distance < PASSED:
            # The direction of the place says nothing any more.
            return _slowed(distance, limits.speed, limits.slowing, 0.03), 0.0
        correction = min(max(_CORRECTION * aside, -limits.turn), limits.turn)
        if abs(aside) > 45.0:
            return 0.0, correction
        return _slowed(distance, limits.speed, limits.slowing, 0.03), correction


class Course(Protocol):
    """What a base does until it is given another.

    steer(pose, t): the twist for now, t seconds after the course began; an ``End`` where
    there is nothing more to do.
    """

    def steer(self, pose: Pose, t: float) -> Twist | End: ...


class End(Enum):
    """How a course came to its end."""

    DONE = "done"
    BLOCKED = "blocked"


class Velocity:
    """Goes on at ``ahead`` m/s and ``round`` deg/s, from heading ``begun`` on; never ends."""

    def __init__(self, ahead: float, round_: float, begun: float) -> None:
        self._ahead = ahead
        self._round = round_
        self._begun = begun

    def steer(self, pose: Pose, t: float) -> Twist | End:
        wanted = self._begun + self._round * t
        # It stays behind where it can not turn as fast, and does not make up for it later.
        aside = min(max(wanted - pose[2], -5.0), 5.0)
        return self._ahead, self._round + _CORRECTION * aside


class Legs:
    """One leg after the other; blocked where one comes no nearer for ``PATIENCE`` seconds."""

    def __init__(self, limits: Limits, *legs: Leg) -> None:
        self._limits = limits
        self._legs = list(legs)
        self._best = math.inf
        self._since = 0.0

    def steer(self, pose: Pose, t: float) -> Twist | End:
        while self._legs:
            left, nearer = self._legs[0].left(pose)
            if left <= 0.0:
                del self._legs[0]
                self._best, self._since = math.inf, t
                continue
            if left <= self._best - nearer:
                self._best, self._since = left, t
            elif t - self._since >= PATIENCE:
                return End.BLOCKED
            return self._legs[0].twist(pose, self._limits)
        return End.DONE


def to_place(limits: Limits, here: Pose, place: Pose) -> Legs:
    """Turns towards the place, drives there, and turns as the place says."""
    x, y, heading = here
    goal_x, goal_y, goal_heading = place
    legs: list[Leg] = []
    if math.hypot(goal_x - x, goal_y - y) >= NEAR:
        heading = turn_to(heading, math.degrees(math.atan2(goal_y - y, goal_x - x)))
        legs += [Face(heading), Reach(goal_x, goal_y)]
    return Legs(limits, *legs, Face(turn_to(heading, goal_heading)))


def turn_by(limits: Limits, here: Pose, angle: float) -> Legs:
    """Turns on the spot by so many degrees, full turns too."""
    return Legs(limits, Face(here[2] + angle))


def _slowed(left: float, fastest: float, slowing: float, slowest: float) -> float:
    """As fast as it may be to stand after ``left``; at least ``slowest``, so that it gets there."""
    return max(slowest, min(fastest, math.sqrt(2.0 * slowing * left)))
