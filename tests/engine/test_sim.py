"""The simulated robot moves with speed and distance; it never just says that it arrived."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest

from situ.decide.effects import Map
from situ.decide.inputs import Set
from situ.engine.robots import find
from situ.engine.robots.sim import SimulatedRobot
from situ.errors import UsageError


class Moves:
    """A performer with the simulated robot in it."""

    def __init__(self, side: Any, robot: SimulatedRobot) -> None:
        self.side = side
        self.robot = robot

    def apply(self, resource: str, value: Any, *actions: int) -> None:
        self.side.performer.perform(Map(resource, "m", value, actions))

    def command(self, resource: str, command: str, action: int = 1, **params: Any) -> None:
        self.apply(resource, {"command": command, "params": params}, action)

    async def outcome(self, action: int = 1) -> tuple[bool, str]:
        finish = await self.side.answers.finish(action)
        return finish.ok, str(finish.error)


def moves(situation: Any, scenario: Any, **options: Any) -> None:
    robots: list[SimulatedRobot] = []

    def make(around: Any) -> SimulatedRobot:
        robots.append(SimulatedRobot(around))
        return robots[0]

    async def run() -> None:
        options.setdefault("poses", False)
        async with situation.side(adapter=make, **options) as side:
            await scenario(Moves(side, robots[0]), side.clock)

    asyncio.run(run())


def test_goto_arrives_when_the_way_has_been_driven(situation: Any) -> None:
    situation.places["lobby"] = (0.0, 2.0, 90.0)

    async def scenario(moves: Moves, clock: Any) -> None:
        moves.command("base", "goto", place="lobby")
        await clock.advance(1.5 + 2.0)
        assert moves.robot.pose == pytest.approx((0.0, 1.0, 90.0))
        await clock.advance(1.9)
        assert moves.side.answers.inputs == []
        await clock.advance(0.2)
        assert await moves.outcome() == (True, "None")
        assert moves.robot.pose == pytest.approx((0.0, 2.0, 90.0))

    moves(situation, scenario)


def test_null_stops_and_holds_and_nothing_arrives(situation: Any) -> None:
    situation.places["lobby"] = (4.0, 0.0, 0.0)

    async def scenario(moves: Moves, clock: Any) -> None:
        moves.command("base", "goto", place="lobby")
        await clock.advance(2)
        moves.apply("base", None)
        await clock.advance(60)
        assert moves.robot.pose == pytest.approx((1.0, 0.0, 0.0))
        assert moves.side.answers.inputs == []
        # The next command begins where it stands.
        moves.command("base", "drive", 2, distance=-0.5)
        await clock.advance(1.01)
        assert moves.robot.pose == pytest.approx((0.5, 0.0, 0.0))
        assert (await moves.outcome(2))[0]

    moves(situation, scenario)


def test_velocities_of_a_module_move_it_until_they_change(situation: Any) -> None:
    async def scenario(moves: Moves, clock: Any) -> None:
        moves.apply("base", {"vx": 0.2})
        await clock.advance(5)
        moves.apply("base", {"turn": 45})
        await clock.advance(2)
        moves.apply("base", {"vx": 3, "vy": 4})
        await clock.advance(1)
        # Ahead is now 90 degrees; 5 m/s are cut down to 1.
        assert moves.robot.pose == pytest.approx((1.0 - 0.8, 0.6, 90.0))
        assert moves.side.answers.inputs == []

    moves(situation, scenario)


def test_the_head_looks_nods_and_shakes(situation: Any) -> None:
    async def scenario(moves: Moves, clock: Any) -> None:
        moves.apply("head", {"yaw": 60})
        await clock.advance(0.25)
        assert moves.robot.gaze == pytest.approx((30.0, 0.0))
        moves.command("head", "look", 1, yaw=-300, pitch=10)
        await clock.advance(150 / 120 - 0.01)
        assert moves.side.answers.inputs == []
        await clock.advance(0.02)
        assert (await moves.outcome(1))[0]
        assert moves.robot.gaze == pytest.approx((-120.0, 10.0))
        moves.command("head", "centre", 2)
        await clock.advance(1.01)
        assert (await moves.outcome(2))[0]
        lowest, widest = 0.0, 0.0
        for number, command in enumerate(("nod", "shake"), 3):
            moves.command("head", command, number)
            for _ in range(24):
                await clock.advance(0.05)
                yaw, pitch = moves.robot.gaze
                lowest, widest = min(lowest, pitch), max(widest, abs(yaw))
            assert (await moves.outcome(number))[0]
        assert lowest < -10
        assert widest > 15
        assert moves.robot.gaze == pytest.approx((0.0, 0.0))

    moves(situation, scenario)


def test_follow_goes_on_until_it_is_stopped(situation: Any) -> None:
    async def scenario(moves: Moves, clock: Any) -> None:
        moves.command("head", "follow")
        await clock.advance(1000)
        assert moves.side.answers.inputs == []
        moves.apply("head", None)
        gaze = moves.robot.gaze
        await clock.advance(10)
        assert moves.robot.gaze == gaze

    moves(situation, scenario)


@pytest.mark.parametrize(
    ("resource", "value", "words"),
    [
        ("base", {"command": "fly"}, "base can not fly; it knows goto, drive, turn"),
        ("head", {"command": "spin"}, "head can not spin"),
        ("base", {"command": "goto", "params": {"place": "moon"}}, "no place 'moon'"),
        ("base", {"command": "goto"}, "there are: lobby"),
        (
            "base",
            {"command": "drive", "params": {"distance": "far"}},
            "distance has to be a number",
        ),
        ("base", {"speed": 1}, "knows vx, vy, turn, not 'speed'"),
        ("head", {"yaw": True}, "yaw has to be a number"),
        ("head", [1, 2], "takes an object"),
        ("arm", {"command": "wave"}, "the robot sim has no arm; it has base, head"),
    ],
)
def test_what_it_can_not_do_fails_in_plain_words_and_it_stands(
    situation: Any, resource: str, value: Any, words: str
) -> None:
    situation.places["lobby"] = (1.0, 0.0, 0.0)

    async def scenario(moves: Moves, clock: Any) -> None:
        moves.apply("base", {"vx": 0.5})
        moves.apply(resource, value, 1)
        ok, error = await moves.outcome()
        assert not ok
        assert words in error
        if resource == "base":
            await clock.advance(9)
            assert moves.robot.pose == (0.0, 0.0, 0.0)

    moves(situation, scenario)


def test_it_reports_where_it_is_while_it_moves_and_not_while_it_stands(situation: Any) -> None:
    async def scenario(moves: Moves, clock: Any) -> None:
        moves.command("base", "drive", distance=1.0)
        await clock.advance(60)
        reports = [one for one in moves.side.answers.inputs if isinstance(one, Set)]
        # At first all: on the blackboard may stand where it was before it was started anew.
        others = {f"pose.{name}": 0.0 for name in ("y", "heading", "yaw", "pitch")}
        assert [one.tags for one in reports] == [
            {"pose.x": 0.25, **others},
            {"pose.x": 0.5},
            {"pose.x": 0.75},
            {"pose.x": 1.0},
        ]
        assert {one.writer for one in reports} == {"sim"}
        moves.apply("head", {"yaw": 30})
        moves.apply("base", None)
        await clock.advance(60)
        assert moves.side.answers.inputs[-1] == Set({"pose.yaw": 30.0}, "sim")

    moves(situation, scenario, poses=True)


def test_an_adapter_that_is_not_installed_is_named_with_those_that_are() -> None:
    assert find("sim") is SimulatedRobot
    with pytest.raises(UsageError, match=r"no robot adapter 'roomba'; installed: .*sim"):
        find("roomba")
