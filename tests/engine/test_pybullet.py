"""Robots in the physics of Bullet: they drive, stop, arrive and get stuck as bodies do."""

from __future__ import annotations

import asyncio
import importlib.util
import json
import logging
import math
import os
import subprocess
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

import situ
from situ.decide.inputs import Acquire, AnyInput, Command, Connected, Set, Start
from situ.decide.robot import Robot
from situ.document.project import Project
from situ.document.ready import load_ready
from situ.engine.perform import Performer
from situ.engine.robots import Surroundings, find
from situ.engine.robots.bullet import TICK
from situ.engine.robots.pybullet import PyBulletRobot, husky, r2d2
from situ.errors import UsageError

ERRAND = Path(__file__).parent / "errand"
PLACES = {"lobby": (2.0, 1.5, 90.0), "behind": (-1.0, -1.0, 180.0)}
BOTH = pytest.mark.parametrize("model", [husky, r2d2])
HUSKY = pytest.mark.parametrize("model", [husky])
R2D2 = pytest.mark.parametrize("model", [r2d2])
DEADLINE = 40.0


@pytest.fixture
def pybullet() -> None:
    """pybullet is there; skips where it is not, and fails in CI where there is a wheel for it."""
    if importlib.util.find_spec("pybullet") is None:
        if os.environ.get("CI") == "true" and sys.version_info[:2] == (3, 11):
            pytest.fail("pybullet is not installed: make .venv/.pybullet")
        pytest.skip("pybullet is not installed: pip install -e '.[pybullet]'")


Model = Callable[[Surroundings], PyBulletRobot]


class Moves:
    """A robot by itself: how its motions ended, by the clock, and what it reported."""

    def __init__(self, model: Model, clock: Any, reports: bool) -> None:
        self.clock = clock
        self.ended: list[tuple[str, bool, str | None]] = []
        self.reported: list[dict[str, Any]] = []
        self.robot = model(
            Surroundings(
                Project(root="", name="test", places=PLACES),
                clock,
                lambda *ended: self.ended.append(ended),
                self.reported.append if reports else None,
                logging.getLogger("test"),
            )
        )

    def command(self, resource: str, command: str, **params: Any) -> None:
        self.robot.apply(resource, {"command": command, "params": params})

    def distance(self, place: str) -> float:
        x, y, _ = PLACES[place]
        return math.dist(self.robot.pose[:2], (x, y))


@pytest.fixture
def moves(hand_clock: Any, pybullet: None) -> Callable[..., None]:
    def run(model: Model, test: Callable[[Moves], Awaitable[None]], reports: bool = False) -> None:
        async def within() -> None:
            made = Moves(model, hand_clock, reports)
            await made.robot.start()
            try:
                await test(made)
            finally:
                await made.robot.close()

        asyncio.run(within())

    return run


# -- by itself -----------------------------------------------------------------


@BOTH
def test_it_goes_to_a_place_and_tells_so_when_it_is_there(model: Model, moves: Any) -> None:
    async def test(moves: Moves) -> None:
        moves.command("base", "goto", place="behind")
        while not moves.ended:
            assert moves.clock.waiting, "it stands, and has not told"
            await moves.clock.advance(TICK)
        assert moves.ended == [("base", True, None)]
        assert moves.distance("behind") < 0.15
        await moves.clock.advance(5)
        assert moves.distance("behind") < 0.15
        assert abs(moves.robot.pose[2]) > 177
        assert moves.ended == [("base", True, None)]

    moves(model, test)


@BOTH
def test_it_drives_and_turns_by_as_much_as_it_is_told(model: Model, moves: Any) -> None:
    async def test(moves: Moves) -> None:
        moves.command("base", "drive", distance=-0.5)
        await moves.clock.advance(10)
        assert moves.robot.pose == pytest.approx((-0.5, 0.0, 0.0), abs=0.03)
        moves.command("base", "turn", angle=450)
        await moves.clock.advance(15)
        assert moves.robot.pose[2] == pytest.approx(90.0, abs=2.5)
        moves.robot.apply("base", {"vx": 0.3})
        await moves.clock.advance(4)
        assert moves.robot.pose[1] == pytest.approx(1.2, abs=0.2)
        moves.robot.apply("base", {"turn": -45, "vy": 0})
        await moves.clock.advance(2)
        assert moves.robot.pose[2] == pytest.approx(0.0, abs=10)
        assert moves.ended == [("base", True, None)] * 2

    moves(model, test)


@BOTH
@pytest.mark.parametrize("value", [{"vx": 9}, {"vx": -9}, {"turn": 999}, {"vx": 0.3, "turn": 40}])
def test_null_stops_it_within_a_fifth_of_a_second_and_it_holds(
    model: Model, value: dict[str, float], moves: Any
) -> None:
    async def test(moves: Moves) -> None:
        moves.robot.apply("base", value)
        await moves.clock.advance(3)
        moves.robot.apply("base", None)
        await moves.clock.advance(0.2)
        stopped = moves.robot.pose
        await moves.clock.advance(60)
        assert math.dist(moves.robot.pose[:2], stopped[:2]) < 0.01
        assert moves.robot.pose[2] == pytest.approx(stopped[2], abs=0.5)
        assert moves.ended == []

    moves(model, test)


@BOTH
def test_nothing_is_reckoned_while_everything_stands(model: Model, moves: Any) -> None:
    async def test(moves: Moves) -> None:
        assert moves.clock.waiting == []
        moves.command("base", "drive", distance=0.1)
        assert moves.clock.waiting == pytest.approx([TICK])
        await moves.clock.advance(10)
        assert moves.clock.waiting == []
        begun = moves.robot.bullet.time
        await moves.clock.advance(3600)
        assert moves.robot.bullet.time == begun

    moves(model, test)


@HUSKY
def test_time_that_was_slept_through_is_left_out(model: Model, moves: Any) -> None:
    async def test(moves: Moves) -> None:
        moves.robot.apply("base", {"vx": 0.5})
        moves.clock.now += 1000
        await moves.clock.advance(0)
        assert moves.robot.bullet.time == pytest.approx(0.25)
        await moves.clock.advance(1)
        assert moves.robot.bullet.time == pytest.approx(1.25)

    moves(model, test)


@HUSKY
def test_what_stands_in_the_way_makes_the_command_fail(model: Model, moves: Any) -> None:
    async def test(moves: Moves) -> None:
        bullet = moves.robot.bullet
        wall = bullet.physics.createCollisionShape(
            bullet.physics.GEOM_BOX, halfExtents=[0.1, 2.0, 1.0], physicsClientId=bullet.world
        )
        bullet.physics.createMultiBody(
            0, wall, basePosition=[1.5, 0.0, 0.0], physicsClientId=bullet.world
        )
        moves.command("base", "drive", distance=3)
        await moves.clock.advance(20)
        assert moves.ended == [("base", False, "the husky's base is blocked")]
        assert 0.3 < moves.robot.pose[0] < 1.4
        assert moves.clock.waiting == []

    moves(model, test)


@R2D2
def test_the_head_turns_while_the_base_drives(model: Model, moves: Any) -> None:
    async def test(moves: Moves) -> None:
        moves.robot.apply("base", {"vx": 0.3})
        moves.command("head", "look", yaw=300, pitch=0)
        await moves.clock.advance(0.5)
        assert 30 < moves.robot.yaw < 60
        await moves.clock.advance(1)
        assert moves.robot.yaw == pytest.approx(120, abs=1)
        assert moves.ended == [("head", True, None)]
        moves.robot.apply("head", {"yaw": -30})
        await moves.clock.advance(2)
        assert moves.robot.yaw == pytest.approx(-30, abs=1)
        moves.command("head", "centre")
        await moves.clock.advance(0.1)
        moves.robot.apply("head", None)
        held = moves.robot.yaw
        await moves.clock.advance(3)
        assert -30 < moves.robot.yaw < -5
        assert moves.robot.yaw == pytest.approx(held, abs=1)
        assert moves.robot.pose[0] > 1
        assert moves.ended == [("head", True, None)]

    moves(model, test)


@R2D2
def test_gestures_end_where_they_began_and_following_never_ends(model: Model, moves: Any) -> None:
    async def test(moves: Moves) -> None:
        moves.command("head", "shake")
        widest = 0.0
        while not moves.ended:
            await moves.clock.advance(0.1)
            widest = max(widest, abs(moves.robot.yaw))
        assert widest > 15
        assert moves.robot.yaw == pytest.approx(0, abs=1)
        moves.command("head", "follow")
        await moves.clock.advance(5)
        assert len(moves.ended) == 1
        assert moves.clock.waiting

    moves(model, test)


@pytest.mark.parametrize(
    ("model", "resource", "value", "words"),
    [
        (husky, "base", {"vy": 0.1}, "the husky's base can not drive sideways"),
        (husky, "base", {"speed": 1}, "knows vx, vy, turn, not 'speed'"),
        (husky, "base", {"command": "goto", "params": {"place": "moon"}}, "no place 'moon'"),
        (r2d2, "base", "on", "R2D2's base takes an object, not 'on'"),
        (r2d2, "head", {"yaw": 1, "pitch": 5}, "R2D2's head can not pitch"),
        (r2d2, "head", {"command": "nod"}, "can not nod; it knows look, centre, shake, follow"),
    ],
)
def test_what_it_can_not_do_fails_in_plain_words_and_it_stops(
    model: Model, resource: str, value: Any, words: str, moves: Any
) -> None:
    async def test(moves: Moves) -> None:
        moves.robot.apply("base", {"vx": 0.3})
        if resource == "head":
            moves.robot.apply("head", {"yaw": 100})
        await moves.clock.advance(0.4)
        moves.robot.apply(resource, value)
        ((ended, ok, error),) = moves.ended
        assert (ended, ok) == (resource, False)
        assert words in str(error)
        await moves.clock.advance(0.2)
        stopped = {"base": moves.robot.pose[0], "head": moves.robot.yaw}
        await moves.clock.advance(1)
        now = {"base": moves.robot.pose[0], "head": moves.robot.yaw}
        assert now[resource] == pytest.approx(stopped[resource], abs=0.5 if now["head"] else 0.01)

    moves(model, test)


@R2D2
def test_it_reports_where_it_is_while_it_moves_and_at_last_when_it_stands(
    model: Model, moves: Any
) -> None:
    async def test(moves: Moves) -> None:
        moves.command("base", "drive", distance=1.0)
        moves.command("head", "look", yaw=30)
        await moves.clock.advance(60)
        tags: dict[str, float] = {}
        for report in moves.reported:
            tags.update(report)
        assert tags["pose.x"] == pytest.approx(moves.robot.pose[0], abs=0.006)
        assert tags["pose.yaw"] == pytest.approx(30, abs=1)
        assert 6 < len(moves.reported) < 12
        assert set(tags) <= {"pose.x", "pose.y", "pose.heading", "pose.yaw"}

    moves(model, test, reports=True)


def test_the_same_commands_at_the_same_times_give_the_same_motion(moves: Any) -> None:
    poses = []

    async def test(moves: Moves) -> None:
        moves.command("base", "goto", place="lobby")
        await moves.clock.advance(1.3)
        moves.robot.apply("base", None)
        await moves.clock.advance(1)
        poses.append(moves.robot.pose)

    moves(husky, test)
    moves(husky, test)
    assert poses[0] == poses[1]


def test_without_pybullet_it_says_what_to_install(
    hand_clock: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pybullet", None)
    made = Moves(husky, hand_clock, reports=False)
    with pytest.raises(UsageError, match=r"pip install 'situ\[pybullet\]'"):
        asyncio.run(made.robot.start())


def test_it_is_found_by_its_names() -> None:
    assert find("pybullet") is find("pybullet-r2d2") is r2d2
    assert find("pybullet-husky") is husky


# -- with everything that decides ----------------------------------------------------


class Whole:
    """What decides and what carries out, on one clock that is moved by hand."""

    def __init__(self, model: Model, clock: Any) -> None:
        project = load_ready(ERRAND)
        self.clock = clock
        self._begun = clock.time()
        self.trace: list[Any] = []
        self.decides = Robot(project)

        def adapter(around: Surroundings) -> PyBulletRobot:
            self.body = model(around)
            return self.body

        self.performer = Performer(
            project, self.give, services=("robot",), clock=clock, adapter=adapter
        )

    def give(self, given: AnyInput | None) -> None:
        moment = round((self.clock.time() - self._begun) * 1e6)
        events, effects = self.decides.step(given, moment)
        self.trace += events
        for effect in effects:
            self.performer.perform(effect)

    async def advance(self, seconds: float) -> None:
        """Time passes; what falls due is done at its moment."""
        end = self.clock.time() + seconds
        while (due := self.decides.due()) is not None and self._begun + due / 1e6 <= end:
            await self.clock.advance(max(0.0, self._begun + due / 1e6 - self.clock.time()))
            self.give(None)
        await self.clock.advance(end - self.clock.time())

    @property
    def state(self) -> Any:
        return self.decides.board.look("application/errand.state")


@pytest.fixture
def errand(hand_clock: Any, pybullet: None) -> Callable[..., None]:
    def run(model: Model, test: Callable[[Whole], Awaitable[None]]) -> None:
        async def within() -> None:
            made = Whole(model, hand_clock)
            await made.performer.start()
            made.give(Start(everyone=False))
            made.give(Connected("chase", ("base",)))
            made.give(Acquire("chase", ("base",)))
            try:
                await test(made)
            finally:
                await made.performer.close()

        asyncio.run(within())

    return run


@HUSKY
def test_a_flow_drives_it_and_goes_on_when_it_has_arrived(model: Model, errand: Any) -> None:
    async def test(whole: Whole) -> None:
        while whole.state == "1":
            await whole.advance(0.1)
        assert whole.state == "2"
        assert math.dist(whole.body.pose[:2], (2.0, 1.0)) < 0.15
        # Bodies take their time: it can not have been there sooner.
        assert whole.body.bullet.time > math.dist((0, 0), (2.0, 1.0)) / 0.5

    errand(model, test)


@BOTH
def test_a_situation_with_a_higher_priority_stops_it_and_gives_the_way_back(
    model: Model, errand: Any
) -> None:
    async def test(whole: Whole) -> None:
        while math.dist(whole.body.pose[:2], (0.0, 0.0)) < 1.0:
            await whole.advance(0.1)
        whole.give(Set({"person.near": True}, "eyes"))
        await whole.advance(0.2)
        stopped = whole.body.pose
        await whole.advance(30)
        assert math.dist(whole.body.pose[:2], stopped[:2]) < 0.01
        assert whole.state == "1"
        whole.give(Set({"person.near": False}, "eyes"))
        await whole.advance(20)
        assert whole.state == "2"
        assert math.dist(whole.body.pose[:2], (2.0, 1.0)) < 0.15

    errand(model, test)


@BOTH
def test_the_command_of_a_module_that_hangs_runs_out_and_it_stops(
    model: Model, errand: Any
) -> None:
    async def test(whole: Whole) -> None:
        whole.give(Set({"chased": True}, "eyes"))
        await whole.advance(1)
        begun = whole.body.pose
        for _ in range(20):
            whole.give(Command("chase", "base", {"vx": 0.3}, 0.5))
            await whole.advance(0.2)
        # From here on it says nothing any more.
        driven = math.dist(whole.body.pose[:2], begun[:2])
        assert driven > 0.9
        await whole.advance(0.3 + 0.2)
        stopped = whole.body.pose
        assert math.dist(stopped[:2], begun[:2]) < driven + 0.3 * 0.5
        await whole.advance(10)
        assert math.dist(whole.body.pose[:2], stopped[:2]) < 0.01

    errand(model, test)


def test_a_run_with_everything_real_drives_and_stops(tmp_path: Path, pybullet: None) -> None:
    """More than a metre in its own time, over the sockets, in a process of its own."""
    command = [
        *(sys.executable, "-m", "situ", "run", str(ERRAND), "--state", str(tmp_path)),
        *("--adapter", "pybullet-husky", "--endpoint", "tcp://127.0.0.1:0", "--trace", "-"),
    ]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        ready = process.stderr.readline()
        assert b"errand ready at" in ready
        try:
            with situ.connect(ready.split()[5].decode()) as board:
                x = y = 0.0
                near = stopped = False
                for event in board.trace():
                    x, y = (
                        event["value"] if event.get("tag") == tag else before
                        for tag, before in (("pose.x", x), ("pose.y", y))
                    )
                    if not near and math.hypot(x, y) > 1.0:
                        board.set("person.near", near := True)
                    # It tells where it is once more when it has come to rest.
                    if stopped and event.get("tag") == "pose.x":
                        break
                    stopped = stopped or (near and event["kind"] == "mapping")
        finally:
            process.terminate()
        trace = [json.loads(line) for line in process.stdout.read().splitlines()]
        assert b"Traceback" not in process.stderr.read()
        assert process.wait(DEADLINE) == 0
    (datum,) = (event for event in trace if event.get("tag") == "person.near")
    (stop,) = (event for event in trace if event["kind"] == "mapping" and event["value"] is None)
    assert stop["t"] == datum["t"]
    assert {event["writer"] for event in trace if event.get("tag") == "pose.x"} == {
        "pybullet-husky"
    }
    poses = [event for event in trace if event.get("tag") == "pose.x"]
    before = [event["value"] for event in poses if event["seq"] < datum["seq"]]
    after = [event["value"] for event in poses if event["seq"] > datum["seq"]]
    assert 0 < after[-1] - before[-1] < 0.5
    assert not [event for event in trace if event.get("to") == "2"]
