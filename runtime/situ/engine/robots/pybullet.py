"""Robots in the physics of Bullet: wheels on a floor, with mass, friction and braking.

``pybullet-r2d2`` (``pybullet`` for short) has a base and a head, ``pybullet-husky`` a base.
``base`` takes {vx} in m/s and {turn} in deg/s, and the commands ``goto`` (place), ``drive``
(metres) and ``turn`` (degrees); ``head`` takes {yaw} in degrees, and ``look`` (yaw),
``centre``, ``shake`` and ``follow``, which goes on until it is stopped. Neither drives
sideways, and the head does not nod.

The extra ``pybullet`` installs what it needs. It runs without a window, in the event loop:
a few steps of the physics at a time, as the clock says, and none while everything stands.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from situ.engine.clock import Handle
from situ.engine.robots import Surroundings
from situ.engine.robots.bullet import HUSKY, R2D2, TICK, Bullet, Model
from situ.engine.robots.motion import Hold, Motion, Round, sweep
from situ.engine.robots.reports import EVERY, Reports
from situ.engine.robots.steering import (
    Course,
    End,
    Legs,
    Straight,
    Velocity,
    to_place,
    turn_by,
)
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

BEHIND = 0.25
"""Seconds of physics done in one go at most; time that was slept through is left out."""
PATIENCE = 2.0
"""Seconds after which a head that is not where it should be is blocked."""


class PyBulletRobot:
    """One model on an empty floor, at the origin, looking along x.

    ``pose`` and ``yaw`` are where it is; ``bullet`` is the world it is in, from ``start`` to
    ``close``.
    """

    def __init__(self, around: Surroundings, model: Model) -> None:
        self.resources = frozenset({"base"} if model.head is None else {"base", "head"})
        self._clock = around.clock
        self._finished = around.finished
        self._reports = None if around.report is None else Reports(around.report)
        self._places = around.project.places
        self._model = model
        self._next: Handle | None = None
        self._begun = 0.0
        self._ticks = 0
        self._course: tuple[float, Course] | None = None
        self._motion: tuple[float, Motion] = (0.0, Hold((0.0,)))
        self._gesture = False
        self._told = 0.0

    @property
    def pose(self) -> tuple[float, float, float]:
        """x and y in metres, heading in degrees from -180 up to 180."""
        x, y, heading = self.bullet.pose
        return x, y, (heading + 180.0) % 360.0 - 180.0

    @property
    def yaw(self) -> float:
        """Where the head looks, in degrees from straight ahead; 0 where there is none."""
        return self.bullet.yaw

    async def start(self) -> None:
        """Loads the model. Raises UsageError where pybullet is not installed."""
        self.bullet = Bullet(self._model)

    async def close(self) -> None:
        if self._next is not None:
            self._next.cancel()
            self._next = None
        self.bullet.close()

    def apply(self, resource: str, value: Any) -> None:
        """Begins anew from how the resource is now; None and nonsense stop it."""
        try:
            self._take(resource, value)
        except NotUnderstood as error:
            self._take(resource, None)
            self._finished(resource, False, str(error))
        if self._next is None:
            self._begun, self._ticks = self._clock.time(), 0
            self._wait()

    # -- what a value means ----------------------------------------------------

    def _take(self, resource: str, value: Any) -> None:
        whose = f"{self._model.name}'s {resource}"
        said = None if value is None else fields(value, whose)
        now = self.bullet.time
        if resource == "base":
            course = None if said is None else self._base(whose, said)
            self._course = None if course is None else (now, course)
        else:
            motion = Hold((self.yaw,)) if said is None else self._head(whose, said)
            self._motion = (now, motion)
            self._gesture = command(value) is not None

    def _base(self, whose: str, value: dict[str, Any]) -> Course:
        here, limits = self.bullet.pose, self._model.limits
        name = command(value)
        if name is None:
            only(value, whose, "vx", "vy", "turn")
            if number(value, "vy", 0.0) != 0.0:
                raise NotUnderstood(f"{whose} can not drive sideways: leave out vy, or make it 0")
            ahead = number(value, "vx", 0.0, self._model.fastest)
            return Velocity(ahead, number(value, "turn", 0.0, limits.turn), here[2])
        given = params(value)
        commands: dict[str, Callable[[], Course]] = {
            "goto": lambda: to_place(limits, here, place(self._places, given)),
            "drive": lambda: Legs(limits, Straight(*here, number(given, "distance"))),
            "turn": lambda: turn_by(limits, here, number(given, "angle")),
        }
        return chosen(whose, name, commands)

    def _head(self, whose: str, value: dict[str, Any]) -> Motion:
        here = (self.yaw,)
        name = command(value)
        if name is None:
            only(value, whose, "yaw", "pitch")
            return sweep(here, (self._to(whose, value),))
        given = params(value)
        side, other = self._turned(20.0), self._turned(-20.0)
        commands: dict[str, Callable[[], Motion]] = {
            "look": lambda: sweep(here, (self._to(whose, given),)),
            "centre": lambda: sweep(here, (0.0,)),
            "shake": lambda: sweep(here, side, other, side, here),
            "follow": lambda: Round(
                sweep(here, self._turned(12.0), self._turned(-12.0), here), 0.0
            ),
        }
        return chosen(whose, name, commands)

    def _to(self, whose: str, of: dict[str, Any]) -> float:
        if number(of, "pitch", 0.0) != 0.0:
            raise NotUnderstood(f"{whose} can not pitch: leave out pitch, or make it 0")
        return number(of, "yaw", self.yaw, self._model.widest)

    def _turned(self, by: float) -> tuple[float]:
        widest = self._model.widest
        return (min(max(self.yaw + by, -widest), widest),)

    # -- time --------------------------------------------------------------------

    def _wait(self) -> None:
        self._next = self._clock.call_at(self._begun + (self._ticks + 1) * TICK, self._ring)

    def _ring(self) -> None:
        """Does the ticks that are due. Ended first, told then: who is told may apply at once."""
        self._next = None
        due = int((self._clock.time() - self._begun) / TICK + 1e-6)
        most = round(BEHIND / TICK)
        if due - self._ticks > most:
            self._begun += (due - self._ticks - most) * TICK
            due = self._ticks + most
        ended: list[tuple[str, bool, str | None]] = []
        moves = True
        while moves and self._ticks < due:
            self._ticks += 1
            moves = self._tick(ended)
        if moves:
            self._wait()
        if self._reports is not None and (not moves or self.bullet.time - self._told >= EVERY):
            self._tell(self._reports)
        for resource, ok, error in ended:
            self._finished(resource, ok, error)

    def _tick(self, ended: list[tuple[str, bool, str | None]]) -> bool:
        """Steers, and lets a tick of time pass; whether anything still moves."""
        now = self.bullet.time
        twist = (0.0, 0.0)
        if self._course is not None:
            begun, course = self._course
            steered = course.steer(self.bullet.pose, now - begun)
            if isinstance(steered, End):
                self._course = None
                blocked = f"{self._model.name}'s base is blocked"
                ended.append(("base", *_outcome(steered is End.DONE, blocked)))
            else:
                twist = steered
        begun, motion = self._motion
        (wanted,) = motion.at(now - begun)
        over = now - begun - motion.duration
        there = over >= 0 and abs(self.yaw - wanted) < 1.0
        if self._gesture and (there or over > PATIENCE):
            self._gesture = False
            ended.append(("head", *_outcome(there, f"{self._model.name}'s head is blocked")))
        self.bullet.tick(*twist, wanted)
        return self._course is not None or over < 0 or self._gesture or not self.bullet.still

    # -- where it is, on the blackboard ------------------------------------------

    def _tell(self, reports: Reports) -> None:
        self._told = self.bullet.time
        names = ("pose.x", "pose.y", "pose.heading", "pose.yaw")
        numbers = (*self.pose, self.yaw) if self._model.head is not None else self.pose
        reports.tell(dict(zip(names, numbers, strict=False)))


def husky(around: Surroundings) -> PyBulletRobot:
    """A Husky: four wheels, 50 kg, a base only."""
    return PyBulletRobot(around, HUSKY)


def r2d2(around: Surroundings) -> PyBulletRobot:
    """R2D2: four small wheels under two legs, and a head that turns."""
    return PyBulletRobot(around, R2D2)


def _outcome(ok: bool, error: str) -> tuple[bool, str | None]:
    return ok, None if ok else error
