"""Motion is a pure function of time, and never faster than the robot."""

from __future__ import annotations

import math

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from situ.engine.robots.motion import (
    DRIVE_SPEED,
    GAZE_SPEED,
    TURN_SPEED,
    Drift,
    Path,
    drive_to,
    path,
    sweep,
    turn_to,
)

metres = st.floats(-20, 20)
degrees = st.floats(-360, 360)
poses = st.tuples(metres, metres, degrees)


@given(poses, poses, st.floats(0, 1), st.floats(0.001, 0.5))
@example((0.0, 0.0, 0.0), (0.0, 0.001, 0.0625), 0.0, 0.001)
def test_a_drive_ends_at_its_place_and_never_exceeds_its_speeds(
    start: tuple[float, float, float],
    place: tuple[float, float, float],
    share: float,
    later: float,
) -> None:
    drive = drive_to(start, place)
    assert drive.at(0) == start
    x, y, heading = drive.at(drive.duration)
    assert math.hypot(x - place[0], y - place[1]) < 0.002
    assert abs(turn_to(heading, place[2]) - heading) < 1e-6
    t = drive.duration * share
    before, after = drive.at(t), drive.at(t + later)
    assert math.dist(before[:2], after[:2]) <= DRIVE_SPEED * later + 1e-6
    assert abs(after[2] - before[2]) <= TURN_SPEED * later + 1e-6


def test_a_drive_turns_drives_and_turns_at_its_speeds() -> None:
    drive = drive_to((0.0, 0.0, 0.0), (0.0, 2.0, 180.0))
    assert drive.duration == pytest.approx(90 / 60 + 2 / 0.5 + 90 / 60)
    assert drive.at(0.75) == pytest.approx((0.0, 0.0, 45.0))
    assert drive.at(1.5 + 2.0) == pytest.approx((0.0, 1.0, 90.0))
    assert drive.at(99) == pytest.approx((0.0, 2.0, 180.0))


def test_where_it_is_already_a_drive_takes_no_time() -> None:
    assert drive_to((1.0, 2.0, 90.0), (1.0, 2.0, 450.0)).duration == 0


@given(st.floats(-720, 720), st.floats(-720, 720))
def test_a_turn_takes_the_shorter_way(heading: float, wanted: float) -> None:
    goal = turn_to(heading, wanted)
    assert abs(goal - heading) <= 180 + 1e-6
    assert math.isclose(math.cos(math.radians(goal - wanted)), 1, abs_tol=1e-6)


def test_constant_velocity_drives_straight_or_along_an_arc() -> None:
    straight = Drift((0.0, 0.0, 90.0), vx=0.5, vy=0.1)
    assert straight.at(2) == pytest.approx((-0.2, 1.0, 90.0))
    # Half a circle to the left: 0.5 m/s at 90 deg/s has a radius of 1 / pi metres.
    arc = Drift((0.0, 0.0, 0.0), vx=0.5, turn=90.0)
    assert arc.at(2) == pytest.approx((0.0, 2 / math.pi, 180.0), abs=1e-9)
    assert Drift((0.0, 0.0, 0.0), turn=-30.0).at(2) == pytest.approx((0.0, 0.0, -60.0))


@settings(max_examples=30)
@given(metres, metres, st.floats(-1, 1), st.floats(-1, 1), st.floats(-90, 90), st.floats(0, 9))
def test_an_arc_is_what_many_small_straight_moves_add_up_to(
    x: float, y: float, vx: float, vy: float, turn: float, t: float
) -> None:
    drift = Drift((x, y, 30.0), vx, vy, turn)
    steps = 400
    for step in range(steps):
        angle = math.radians(30.0 + turn * t * (step + 0.5) / steps)
        x += (vx * math.cos(angle) - vy * math.sin(angle)) * t / steps
        y += (vx * math.sin(angle) + vy * math.cos(angle)) * t / steps
    assert drift.at(t)[:2] == pytest.approx((x, y), abs=5e-3)


def test_a_gaze_moves_both_angles_together_at_its_speed() -> None:
    gaze = sweep((0.0, 0.0), (60.0, 10.0), (60.0, 0.0))
    assert gaze.duration == pytest.approx((60 + 10) / GAZE_SPEED)
    assert gaze.at(0.25) == pytest.approx((30.0, 5.0))


def test_legs_that_take_no_time_are_left_out() -> None:
    assert path((1.0,), ((1.0,), 0.0)) == Path((0.0,), ((1.0,),))
