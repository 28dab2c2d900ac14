"""A robot with wheels and perhaps a head in a world of Bullet: a floor, and gravity.

Metres, degrees and seconds. Only ``tick`` lets time pass.
"""

from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from msgspec import Struct

from situ.engine.robots.motion import GAZE_SPEED, turn_to
from situ.engine.robots.steering import Limits, Pose
from situ.errors import UsageError

TICK = 1 / 60
"""Seconds between two commands to the wheels."""
STEPS = 4
"""Steps of the physics in a tick."""


class Model(Struct, frozen=True):
    """A robot of ``pybullet_data``.

    stands: x, y, z of its base, m, and how it is turned to look along x, deg. left, right:
    joints of the wheels. rolls: 1 or -1, which way round is ahead. half_track: from the
    middle to the wheels. friction: of the wheels; grip: the part of it along each of their
    axes, little along the axle, or it could not turn on the spot. force: of each wheel, Nm.
    fastest: of a command in m/s. quickening, braking: m/s per s. head: its joint;
    widest: how far it turns, deg.
    """

    name: str
    urdf: str
    stands: tuple[float, float, float, float]
    left: tuple[str, ...]
    right: tuple[str, ...]
    rolls: int
    radius: float
    half_track: float
    grip: tuple[float, float, float]
    friction: float
    force: float
    fastest: float
    quickening: float
    braking: float
    limits: Limits
    head: str | None = None
    widest: float = 0.0


HUSKY = Model(
    name="the husky",
    urdf="husky/husky.urdf",
    stands=(0.0, 0.0, 0.0, 0.0),
    left=("front_left_wheel", "rear_left_wheel"),
    right=("front_right_wheel", "rear_right_wheel"),
    rolls=1,
    radius=0.17775,
    half_track=0.2854,
    grip=(1.0, 0.05, 1.0),
    friction=2.0,
    force=30.0,
    fastest=0.8,
    quickening=1.0,
    braking=6.0,
    limits=Limits(speed=0.5, turn=60.0, slowing=0.5, turn_slowing=90.0),
)
# Its head is a continuous joint, which Bullet stops by limits that are not meant for it.
R2D2 = Model(
    name="R2D2",
    urdf="r2d2.urdf",
    stands=(0.0, 0.0, 0.471, -90.0),
    left=("left_front_wheel_joint", "left_back_wheel_joint"),
    right=("right_front_wheel_joint", "right_back_wheel_joint"),
    rolls=-1,
    radius=0.035,
    half_track=0.22,
    grip=(1.0, 1.0, 0.2),
    friction=2.0,
    force=30.0,
    fastest=0.4,
    quickening=0.6,
    braking=2.5,
    limits=Limits(speed=0.3, turn=60.0, slowing=0.3, turn_slowing=90.0),
    head="head_swivel",
    widest=120.0,
)


class Bullet:
    """One robot in a world of its own. Raises UsageError where pybullet is not installed.

    physics, world, body: for those who put more into it: the pybullet module, its
    ``physicsClientId`` and the robot's id. time: seconds that have passed in it.
    """

    def __init__(self, model: Model) -> None:
        with _silence():
            try:
                import pybullet
                import pybullet_data
            except ImportError as error:
                raise UsageError(
                    "the robot adapter pybullet needs pybullet, which there is for Python 3.11: "
                    f"pip install 'situ[pybullet]' ({error})"
                ) from error
            self.physics: Any = pybullet
            self.world: int = pybullet.connect(pybullet.DIRECT)
            data = pybullet_data.getDataPath()
            x, y, z, turned = model.stands
            turn = pybullet.getQuaternionFromEuler([0.0, 0.0, math.radians(turned)])
            pybullet.loadURDF(f"{data}/plane.urdf", physicsClientId=self.world)
            self.body: int = pybullet.loadURDF(
                f"{data}/{model.urdf}", [x, y, z], turn, physicsClientId=self.world
            )
        pybullet.setGravity(0.0, 0.0, -9.81, physicsClientId=self.world)
        pybullet.setTimeStep(TICK / STEPS, physicsClientId=self.world)
        self._model = model
        self._ahead = 0.0
        self._ticks = 0
        joints = self._joints()
        self._left = [joints.pop(name) for name in model.left]
        self._right = [joints.pop(name) for name in model.right]
        self._head = None if model.head is None else joints.pop(model.head)
        for wheel in (*self._left, *self._right):
            self._change(wheel, lateralFriction=model.friction, anisotropicFriction=model.grip)
        if self._head is not None:
            self._change(self._head, jointLowerLimit=-math.pi, jointUpperLimit=math.pi)
        for joint in joints.values():
            self._motor(joint, pybullet.VELOCITY_CONTROL, targetVelocity=0.0, force=50.0)
        self.pose: Pose = (0.0, 0.0, 0.0)
        self.yaw = 0.0
        self.still = True
        self._look()

    @property
    def time(self) -> float:
        return self._ticks * TICK

    def tick(self, ahead: float, round_: float, yaw: float) -> None:
        """Lets ``TICK`` seconds pass, in which wheels and head move towards what is wanted."""
        model, physics = self._model, self.physics
        change = (model.quickening if abs(ahead) > abs(self._ahead) else model.braking) * TICK
        self._ahead += min(max(ahead - self._ahead, -change), change)
        aside = math.radians(round_) * model.half_track
        for wheels, speed in (
            (self._left, self._ahead - aside),
            (self._right, self._ahead + aside),
        ):
            velocity = model.rolls * speed / model.radius
            for wheel in wheels:
                self._motor(
                    wheel, physics.VELOCITY_CONTROL, targetVelocity=velocity, force=model.force
                )
        if self._head is not None:
            self._motor(
                self._head, physics.POSITION_CONTROL, targetPosition=math.radians(yaw),
                maxVelocity=math.radians(1.5 * GAZE_SPEED), force=100.0,
            )  # fmt: skip
        for _ in range(STEPS):
            physics.stepSimulation(physicsClientId=self.world)
        self._ticks += 1
        self._look()

    def close(self) -> None:
        self.physics.disconnect(physicsClientId=self.world)

    def _look(self) -> None:
        """Where everything is now."""
        physics, world = self.physics, self.world
        (x, y, _), turn = physics.getBasePositionAndOrientation(self.body, physicsClientId=world)
        (vx, vy, _), (_, _, spin) = physics.getBaseVelocity(self.body, physicsClientId=world)
        heading = math.degrees(physics.getEulerFromQuaternion(turn)[2]) - self._model.stands[3]
        self.pose = x, y, turn_to(self.pose[2], heading)
        rate = 0.0
        if self._head is not None:
            angle, rate, *_ = physics.getJointState(self.body, self._head, physicsClientId=world)
            self.yaw = math.degrees(angle)
        self.still = math.hypot(vx, vy) < 0.002 and max(abs(spin), abs(rate)) < 0.005

    def _joints(self) -> dict[str, int]:
        """The joints that move, by name."""
        physics, world = self.physics, self.world
        infos = [
            physics.getJointInfo(self.body, joint, physicsClientId=world)
            for joint in range(physics.getNumJoints(self.body, physicsClientId=world))
        ]
        return {info[1].decode(): info[0] for info in infos if info[2] != physics.JOINT_FIXED}

    def _change(self, link: int, **dynamics: Any) -> None:
        self.physics.changeDynamics(self.body, link, physicsClientId=self.world, **dynamics)

    def _motor(self, joint: int, mode: int, **wanted: Any) -> None:
        self.physics.setJointMotorControl2(
            self.body, joint, mode, physicsClientId=self.world, **wanted
        )


@contextmanager
def _silence() -> Iterator[None]:
    """Keeps what Bullet prints out of the standard output, which may be a trace's."""
    flush = ctypes.CDLL(None).fflush
    flush(None)
    kept = os.dup(1), os.dup(2)
    nothing = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nothing, 1)
        os.dup2(nothing, 2)
        yield
    finally:
        flush(None)
        for number, before in enumerate(kept, 1):
            os.dup2(before, number)
            os.close(before)
        os.close(nothing)
