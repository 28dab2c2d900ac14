"""A course leads where it should, on a base that does exactly what it is told."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.engine.robots.steering import (
    ALIGNED,
    NEAR,
    PATIENCE,
    Course,
    End,
    Legs,
    Limits,
    Pose,
    Straight,
    Velocity,
    to_place,
    turn_by,
)

LIMITS = Limits(speed=0.5, turn=60.0, slowing=0.5, turn_slowing=90.0)
PART = 1 / 60

metres = st.floats(-3, 3)
degrees = st.floats(-720, 720)
poses = st.tuples(metres, metres, degrees)


def follow(course: Course, pose: Pose, seconds: float = 120.0) -> tuple[Pose, End | None]:
    """Where a base comes that has neither mass nor slip, and how it ends."""
    for count in range(round(seconds / PART)):
        twist = course.steer(pose, count * PART)
        if isinstance(twist, End):
            return pose, twist
        ahead, turn = twist
        assert abs(ahead) <= LIMITS.speed
        x, y, heading = pose
        middle = math.radians(heading + turn * PART / 2)
        pose = (
            x + ahead * PART * math.cos(middle),
            y + ahead * PART * math.sin(middle),
            heading + turn * PART,
        )
    return pose, None


@given(poses, poses)
@settings(max_examples=15)
def test_it_comes_to_every_place_from_everywhere(start: Pose, place: Pose) -> None:
    (x, y, heading), end = follow(to_place(LIMITS, start, place), start)
    assert end is End.DONE
    assert math.dist((x, y), place[:2]) < 2 * NEAR
    assert abs((heading - place[2] + 180) % 360 - 180) < 2 * ALIGNED


@given(poses, st.floats(-2, 2), degrees)
@settings(max_examples=15)
def test_it_drives_and_turns_by_as_much_as_it_is_told(
    start: Pose, distance: float, angle: float
) -> None:
    (x, y, _), end = follow(Legs(LIMITS, Straight(*start, distance)), start)
    assert end is End.DONE
    assert math.dist((x, y), start[:2]) == pytest.approx(abs(distance), abs=NEAR)
    (_, _, heading), end = follow(turn_by(LIMITS, start, angle), start)
    assert end is End.DONE
    assert heading - start[2] == pytest.approx(angle, abs=2 * ALIGNED)


def test_a_velocity_goes_on_and_keeps_its_direction() -> None:
    assert follow(Velocity(0.5, 0.0, 90.0), (0.0, 0.0, 92.0), 10.0)[0] == (
        pytest.approx((0.0, 5.0, 90.0), abs=0.02)
    )
    course = Velocity(0.5, 30.0, 0.0)
    assert course.steer((0.0, 0.0, 30.0), 1.0) == (0.5, 30.0)
    # However far it lags behind, it turns only a little faster to keep up.
    assert course.steer((0.0, 0.0, 0.0), 100.0) == (0.5, 40.0)


def test_what_comes_no_nearer_is_blocked_and_not_before_its_time() -> None:
    course = to_place(LIMITS, (0.0, 0.0, 0.0), (3.0, 0.0, 0.0))
    here = (0.0, 0.0, 0.0)
    assert course.steer(here, 0.0) != End.BLOCKED
    assert course.steer(here, PATIENCE - 0.01) != End.BLOCKED
    assert course.steer((0.02, 0.0, 0.0), PATIENCE) != End.BLOCKED
    assert course.steer((0.02, 0.0, 0.0), 2 * PATIENCE) is End.BLOCKED


def test_what_is_there_already_is_done_at_once() -> None:
    here = (1.0, 1.0, 45.0)
    assert to_place(LIMITS, here, (1.0, 1.0, 405.0)).steer(here, 0.0) is End.DONE


def test_a_place_that_was_driven_past_by_far_is_turned_round_for() -> None:
    course = to_place(LIMITS, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    assert course.steer((1.5, 0.0, 0.0), 1.0) == (0.0, -LIMITS.turn)
    # Beside it by no more than a hand's breadth, it is there.
    assert course.steer((1.05, 0.0, 0.0), 2.0) is End.DONE
