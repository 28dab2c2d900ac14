"""``situ.testing``: a module author's own tests, without sockets and without waiting."""

from __future__ import annotations

import asyncio
import threading
from pathlib import Path
from typing import Any

import pytest

import situ.testing
from situ.blackboard.client import AsyncBoard, Board
from situ.errors import BlackboardError, Refused, UsageError
from situ.testing.robot import Robot

LAB = Path(__file__).parent.parent / "blackboard" / "lab"


def nod(board: Board) -> None:
    for said in board.watch("speech.acceptable"):
        if said.value:
            with board.authority("head") as head:
                if head.wait(1.0):
                    for pitch in (-12, 0):
                        head.command({"pitch": pitch}, valid=0.4)
                        head.wait_lost(0.25)


async def nod_async(board: AsyncBoard) -> None:
    async for said in board.watch("speech.acceptable"):
        if said.value:
            async with board.authority("head") as head:
                if await head.wait(1.0):
                    for pitch in (-12, 0):
                        await head.command({"pitch": pitch}, valid=0.4)
                        await head.wait_lost(0.25)


def started(robot: Robot, form: str) -> Robot:
    if form == "blocking":
        robot.start(nod, robot.connect(module="nod", resources=["head"]))
    else:
        robot.start(nod_async, robot.connect_async(module="nod", resources=["head"]))
    return robot


FORMS = pytest.mark.parametrize("form", ["blocking", "asyncio"])


@FORMS
def test_a_module_is_run_and_time_moves_when_the_test_says_so(form: str) -> None:
    with situ.testing.robot(modules={"nod": ["head"]}) as robot:
        started(robot, form).set("speech.acceptable", True)
        assert robot.holder("head") == "nod"
        assert (robot.command("head"), robot.now) == ({"pitch": -12}, 0)
        robot.pass_time(0.24)
        assert robot.command("head") == {"pitch": -12}
        robot.pass_time(0.02)
        assert robot.command("head") == {"pitch": 0}
        robot.until(lambda: robot.holder("head") is None, within=1.0)
        assert robot.now == 0.5
        assert robot.command("head") is None


@FORMS
def test_twice_the_same_gives_the_same_trace(form: str) -> None:
    def play() -> list[dict[str, Any]]:
        with situ.testing.robot(LAB) as robot:
            started(robot, form).set("person.calling", True)
            robot.set("speech.acceptable", True)
            robot.pass_time(2.0)
            robot.publish("go")
            robot.pass_time(10.0)
            return robot.trace

    assert play() == play()


@FORMS
def test_the_trace_ends_where_the_robot_is_closed(form: str) -> None:
    with situ.testing.robot(LAB) as robot:
        started(robot, form).set({"person.calling": True, "speech.acceptable": True})
        robot.pass_time(0.1)
        assert robot.holder("head") == "nod"
        known, now = list(robot.trace), robot.now
    assert (robot.trace, robot.now) == (known, now)


@FORMS
def test_a_lost_module_gives_up_authority_and_is_itself_again(form: str) -> None:
    with situ.testing.robot(modules={"nod": ["head"], "chase": ["head"]}) as robot:
        chase = robot.connect(module="chase", resources=["head"])
        with chase.authority("head"):
            started(robot, form).set("speech.acceptable", True)
            assert robot.holder("head") == "nod"
            robot.lose("nod")
            assert robot.holder("head") == "chase"
            assert robot.events(kind="lost") == [robot.events(kind="lost", module="nod")[0]]
            robot.regain("nod")
            robot.set("speech.acceptable", True)
            assert robot.holder("head") == "nod"
            assert robot.command("head") == {"pitch": -12}


@FORMS
def test_after_a_restart_of_the_robot_modules_go_on(form: str) -> None:
    with situ.testing.robot(modules={"nod": ["head"]}) as robot:
        started(robot, form).restart()
        robot.set("speech.acceptable", True)
        assert robot.command("head") == {"pitch": -12}
        assert [event["module"] for event in robot.events(kind="connected")] == ["nod", "nod"]


@FORMS
def test_what_a_module_raises_the_test_is_told(form: str) -> None:
    def fail(board: Board) -> None:
        board.set("Not A Tag", 1)

    async def fail_async(board: AsyncBoard) -> None:
        await board.set("Not A Tag", 1)

    with situ.testing.robot(modules={"nod": []}) as robot:
        program = fail if form == "blocking" else fail_async
        connect = robot.connect if form == "blocking" else robot.connect_async
        board = connect(module="nod")
        with pytest.raises(Refused):
            robot.start(program, board)


def test_a_project_is_run_as_it_is() -> None:
    with situ.testing.robot(LAB, auto_finish=1.0) as robot:
        assert (robot.situation, robot.value("user.name")) == ("calm", "Ann")
        robot.set({"person.calling": True})
        assert robot.situation == "called"
        robot.publish("go")
        assert robot.value("application/desk")["state"] == "2"
        robot.pass_time(5.0)
        assert robot.situation == "calm"
        assert robot.events(kind="action", action="service")[0]["name"] == "ask"


def test_a_board_may_be_driven_by_hand_and_its_waits_pass_time() -> None:
    with (
        situ.testing.robot(modules={"chase": ["head"]}) as robot,
        robot.connect(module="chase", resources=["head"]) as board,
        board.watch("face.*") as face,
        board.authority("head") as head,
    ):
        robot.set("face.direction", 12)
        change = face.next(1.0)
        assert change is not None
        assert (change.value, robot.now) == (12, 0)
        assert face.next(1.0) is None
        assert robot.now == 1.0
        assert head.wait(1.0)
        head.command({"yaw": 12}, valid=0.5)
        assert robot.command("head") == {"yaw": 12}
        robot.pass_time(0.5)
        assert robot.command("head") is None


def test_callbacks_are_called_before_the_test_goes_on() -> None:
    with situ.testing.robot() as robot:
        board = robot.connect()
        seen: list[Any] = []

        def on_change(change: Any) -> None:
            seen.append(change.value)
            if change.value == 1:
                board.set("face.count", 2)
            if change.value == 3:
                raise ValueError("a callback that fails")

        board.watch("face.count", on_change)
        robot.set("face.count", 1)
        assert seen == [1, 2]
        with pytest.raises(ValueError, match="a callback that fails"):
            robot.set("face.count", 3)


def test_a_test_may_await() -> None:
    with situ.testing.robot(modules={"nod": ["head"]}) as robot:

        async def test() -> float:
            async with (
                robot.connect_async(module="nod", resources=["head"]) as board,
                board.watch("face.*") as face,
            ):
                task = asyncio.create_task(face.next(30.0))
                await asyncio.sleep(20.0)
                robot.set("face.direction", 3)
                change = await task
                assert change is not None
                with pytest.raises(BlackboardError, match=r"await asyncio\.sleep"):
                    robot.pass_time(1.0)
                return float(change.value)

        assert robot.run(test()) == 3.0
        assert robot.now == 20.0


def test_ten_minutes_of_the_robot_take_none_of_ours() -> None:
    with situ.testing.robot(modules={"nod": ["head"]}) as robot:
        started(robot, "blocking")
        robot.pass_time(600.0)
        assert robot.now == 600.0


def test_what_does_not_come_about_is_told() -> None:
    with situ.testing.robot() as robot:
        with pytest.raises(AssertionError, match="within 2 s"):
            robot.until(lambda: False, within=2.0)
        assert robot.now == 2.0
        with pytest.raises(Refused):
            robot.set("robot/head", 1)
        with pytest.raises(BlackboardError, match="no module nod was connected"):
            robot.lose("nod")


def test_a_wait_without_an_end_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("situ.testing.shared_time.FOREVER", 3.0)
    with situ.testing.robot() as robot, pytest.raises(BlackboardError, match="say how long"):
        robot.connect().watch("face.*").next()


def test_a_name_that_is_taken_is_refused_as_in_earnest() -> None:
    with situ.testing.robot(modules={"nod": []}) as robot, robot.connect(module="nod"):
        with pytest.raises(Refused, match="a module nod is connected already"):
            robot.connect(module="nod")
        assert robot.now >= 1.0


def test_modules_and_a_project_are_not_given_together() -> None:
    with pytest.raises(UsageError, match="not both"):
        situ.testing.robot(LAB, modules={"nod": []})


def test_modules_that_never_end_by_themselves_end_with_the_test() -> None:
    def spin(board: Board) -> None:
        with board.authority("head") as head, board.watch("face.*") as face:
            while True:
                face.next(0.1)
                head.command({"yaw": 1}, valid=0.2)

    async def spin_async(board: AsyncBoard) -> None:
        async with board.authority("head") as head, board.watch("face.*") as face:
            while True:
                await face.next(0.1)
                await head.command({"yaw": 1}, valid=0.2)

    before = threading.active_count()
    with situ.testing.robot(modules={"nod": ["head"], "chase": ["head"]}) as robot:
        robot.start(spin, robot.connect(module="nod", resources=["head"]))
        robot.start(spin_async, robot.connect_async(module="chase", resources=["head"]))
        robot.pass_time(1.0)
        assert threading.active_count() == before + 2
    assert threading.active_count() == before


def test_things_say_who_they_are() -> None:
    with situ.testing.robot(modules={"nod": ["head"]}) as robot:
        board = robot.connect(module="nod", resources=["head"])
        assert repr(robot) == "<Robot test at 0 s>"
        assert repr(board) == "<Board a robot in memory, module nod, connected>"
        assert repr(board.watch("face.*")) == "<Following <Watch face.*, 0 to be taken>>"
        with board.authority("head") as head:
            assert repr(head) == "<Authority over head, held>"
        assert repr(head) == "<Authority over head, not held>"
        board.close()
        assert repr(board) == "<Board a robot in memory, closed>"


def test_what_was_missed_of_a_robot_that_began_anew_is_counted_from_its_start() -> None:
    with (
        situ.testing.robot(modules={"nod": []}) as robot,
        robot.connect(module="nod") as board,
        board.watch("face.count") as counts,
    ):
        for count in range(5):
            robot.set("face.count", count)
        assert [change.version for _ in range(5) if (change := counts.next(0.0))] == [1, 2, 3, 4, 5]
        robot.lose("nod")
        robot.restart()
        robot.set("face.count", 7)
        robot.set("face.count", 8)
        robot.regain("nod")
        change = counts.next(0.0)
        assert change is not None
        assert (change.value, change.version, change.missed) == (8, 2, 1)
