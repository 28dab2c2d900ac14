"""The simulated robot: a base and a head that move with speed and distance.

It never just says that it arrived. ``base`` takes {vx, vy} in m/s and {turn} in
deg/s, and the commands ``goto`` (place), ``drive`` (metres) and ``turn`` (degrees);
``head`` takes {yaw, pitch} in degrees, and ``look`` (yaw, pitch), ``nod``, ``shake``,
``centre`` and ``follow``, which goes on until it is stopped.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from situ.engine.clock import Handle
from situ.engine.robots import Surroundings
from situ.engine.robots.motion import (
    DRIVE_SPEED,
    TURN_SPEED,
    Drift,
    Hold,
    Motion,
    Round,
    drive_to,
    path,
    sweep,
)
from situ.engine.robots.reports import EVERY, Reports
from situ.engine.robots.vocabulary import (
    NotUnderstood,
    chosen,
    command,
    fields,
    number,
    only,
    params,
    place,
)

FASTEST = 1.0
"""Metres a second that the base drives at most; a faster command is cut down."""
FASTEST_TURN = 120.0
YAW, PITCH = 120.0, 45.0
"""Degrees that the head turns and nods to either side."""

BASE, HEAD = "the simulated robot's base", "the simulated robot's head"

_REPORTED = {
    "base": ("pose.x", "pose.y", "pose.heading"),
    "head": ("pose.yaw", "pose.pitch"),
}


class SimulatedRobot:
    """One resource, one motion. ``pose`` and ``gaze`` are where it is now."""

    resources = frozenset(_REPORTED)

    def __init__(self, around: Surroundings) -> None:
        self._clock = around.clock
        self._finished = around.finished
        self._reports = None if around.report is None else Reports(around.report)
        self._places = around.project.places
        self._motions: dict[str, tuple[float, Motion]] = {
            "base": (0.0, Hold((0.0, 0.0, 0.0))),
            "head": (0.0, Hold((0.0, 0.0))),
        }
        self._ends: dict[str, Handle] = {}
        self._next_report: Handle | None = None

    @property
    def pose(self) -> tuple[float, float, float]:
        """x and y in metres, heading in degrees from -180 up to 180."""
        x, y, heading = self._where("base")
        return x, y, (heading + 180.0) % 360.0 - 180.0

    @property
    def gaze(self) -> tuple[float, float]:
        """yaw and pitch in degrees."""
        yaw, pitch = self._where("head")
        return yaw, pitch

    async def start(self) -> None:
        """Nothing to connect to."""

    async def close(self) -> None:
        for handle in (*self._ends.values(), self._next_report):
            if handle is not None:
                handle.cancel()
        self._ends.clear()
        self._next_report = None

    def apply(self, resource: str, value: Any) -> None:
        """Begins a motion from where the resource is now; None and nonsense stop it."""
        if (end := self._ends.pop(resource, None)) is not None:
            end.cancel()
        here = self._where(resource)
        try:
            motion = self._motion(resource, here, value)
        except NotUnderstood as error:
            motion = Hold(here)
            self._begin(resource, motion)
            self._finished(resource, False, str(error))
            return
        self._begin(resource, motion)
        if command(value) is not None and motion.duration < math.inf:
            end_at = self._clock.time() + motion.duration
            self._ends[resource] = self._clock.call_at(end_at, lambda: self._arrive(resource))

    def _begin(self, resource: str, motion: Motion) -> None:
        self._motions[resource] = (self._clock.time(), motion)
        if self._reports is not None and self._next_report is None:
            self._tell(self._reports)

    def _arrive(self, resource: str) -> None:
        self._ends.pop(resource, None)
        self._motions[resource] = (self._clock.time(), Hold(self._where(resource)))
        self._finished(resource, True, None)

    def _where(self, resource: str) -> tuple[float, ...]:
        begun, motion = self._motions[resource]
        return motion.at(self._clock.time() - begun)

    # -- what a value means ----------------------------------------------------

    def _motion(self, resource: str, here: tuple[float, ...], value: Any) -> Motion:
        if value is None:
            return Hold(here)
        said = fields(value, f"the simulated robot's {resource}")
        known = {"base": self._base, "head": self._head}[resource]
        return known(here, said)

    def _base(self, here: tuple[float, ...], value: dict[str, Any]) -> Motion:
        name = command(value)
        if name is None:
            turn = number(value, "turn", 0.0, FASTEST_TURN)
            vx, vy = number(value, "vx", 0.0), number(value, "vy", 0.0)
            # Cut down together, so that the direction stays.
            cut = min(1.0, FASTEST / max(math.hypot(vx, vy), 1e-9))
            only(value, BASE, "vx", "vy", "turn")
            return Drift(here, vx * cut, vy * cut, turn)
        given = params(value)
        commands: dict[str, Callable[[], Motion]] = {
            "goto": lambda: drive_to(here, place(self._places, given)),
            "drive": lambda: self._drive(here, number(given, "distance")),
            "turn": lambda: self._turn(here, number(given, "angle")),
        }
        return chosen(BASE, name, commands)

    def _head(self, here: tuple[float, ...], value: dict[str, Any]) -> Motion:
        yaw, pitch = here
        name = command(value)
        if name is None:
            only(value, HEAD, "yaw", "pitch")
            return sweep(here, _gaze(value, here))
        given = params(value)
        down, up = (yaw, max(-PITCH, pitch - 15.0)), (yaw, min(PITCH, pitch + 5.0))
        left, right = (min(YAW, yaw + 20.0), pitch), (max(-YAW, yaw - 20.0), pitch)
        commands: dict[str, Callable[[], Motion]] = {
            "look": lambda: sweep(here, _gaze(given, here)),
            "centre": lambda: sweep(here, (0.0, 0.0)),
            "nod": lambda: sweep(here, down, up, down, here),
            "shake": lambda: sweep(here, left, right, left, here),
            "follow": lambda: self._follow(here),
        }
        return chosen(HEAD, name, commands)

    @staticmethod
    def _drive(here: tuple[float, ...], distance: float) -> Motion:
        x, y, heading = here
        angle = math.radians(heading)
        goal = (x + distance * math.cos(angle), y + distance * math.sin(angle), heading)
        return path(here, (goal, abs(distance) / DRIVE_SPEED))

    @staticmethod
    def _turn(here: tuple[float, ...], angle: float) -> Motion:
        x, y, heading = here
        return path(here, ((x, y, heading + angle), abs(angle) / TURN_SPEED))

    @staticmethod
    def _follow(here: tuple[float, ...]) -> Motion:
        yaw, pitch = here
        around = sweep(here, (yaw + 12.0, pitch), (yaw - 12.0, pitch), (yaw, pitch))
        return Round(around, 0.0)

    # -- where it is, on the blackboard ------------------------------------------

    def _tell(self, reports: Reports) -> None:
        """Reports where it is, and again while anything moves."""
        self._next_report = None
        now = self._clock.time()
        moving = any(now - begun < motion.duration for begun, motion in self._motions.values())
        places = {"base": self.pose, "head": self.gaze}
        reports.tell(
            {
                tag: number
                for resource, names in _REPORTED.items()
                for tag, number in zip(names, places[resource], strict=True)
            }
        )
        if moving:
            self._next_report = self._clock.call_at(now + EVERY, lambda: self._tell(reports))


def _gaze(of: dict[str, Any], here: tuple[float, ...]) -> tuple[float, float]:
    return number(of, "yaw", here[0], YAW), number(of, "pitch", here[1], PITCH)
