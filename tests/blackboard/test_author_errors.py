"""What goes wrong in a module author's hands is told in one line that says how to mend it."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Iterator
from typing import Any

import pytest

import situ.testing
from situ.blackboard.client import AsyncBoard, Board
from situ.errors import BlackboardError, Refused


@pytest.fixture
def robot() -> Iterator[situ.testing.Robot]:
    with situ.testing.robot(modules={"nod": ["head", "arm"]}) as made:
        yield made


@pytest.fixture
def board(robot: situ.testing.Robot) -> Board:
    return robot.connect(module="nod", resources=["head", "arm"])


class Array:
    """As numpy's."""

    def __init__(self, *values: float) -> None:
        self.values = values

    def tolist(self) -> list[float]:
        return list(self.values)


@pytest.mark.parametrize(
    "value",
    [math.nan, {"deep": [math.inf]}, (None, -math.inf), Array(1.0, math.nan)],
    ids=["nan", "inside", "tuple", "array"],
)
def test_what_is_no_number_is_refused_and_deletes_nothing(board: Board, value: Any) -> None:
    board.set("sensor", 1.0)
    with pytest.raises(BlackboardError, match="NaN and infinity are none; set None"):
        board.set("sensor", value)
    assert board.get("sensor") == 1.0


def test_null_and_arrays_are_values(board: Board) -> None:
    board.set({"pose": Array(1.0, 2.5), "more": {"array": Array(3.0), "none": None}})
    assert board.get("pose") == [1.0, 2.5]
    assert board.get("more") == {"array": [3.0], "none": None}
    board.set("pose", None)
    assert board.get("pose") is None


def test_other_things_are_no_values(board: Board) -> None:
    with pytest.raises(BlackboardError, match=r"no JSON value: builtins\.object is unsupported"):
        board.set("thing", object())


def test_resources_may_be_a_string_as_in_xml(robot: situ.testing.Robot) -> None:
    with robot.connect("nod", "head arm") as board, board.authority("head", "arm") as both:
        assert both.held


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda board: board.authority(), "say which resources"),
        (lambda board: board.authority("head").command(1), "only within: with board.authority"),
        (lambda board: board.authority("head").wait(1.0), "only within: with board.authority"),
    ],
)
def test_authority_that_was_not_asked_for_says_so(
    board: Board, wrong: Callable[[Board], Any], words: str
) -> None:
    with pytest.raises(BlackboardError, match=words):
        wrong(board)


def test_after_its_with_authority_commands_nothing(robot: situ.testing.Robot, board: Board) -> None:
    with board.authority("head") as head:
        head.command(1)
    with pytest.raises(BlackboardError, match="only within"):
        head.command(2)
    assert robot.command("head") is None


def test_a_command_for_one_of_several_says_for_which(board: Board) -> None:
    with board.authority("head", "arm") as both:
        with pytest.raises(BlackboardError, match="say which resource the command is for: head, a"):
            both.command(1)
        with pytest.raises(Refused, match="a command is good for a number of seconds above 0"):
            both.command(1, valid=0, resource="arm")


def test_a_loop_that_need_not_wait_leaves_others_their_turn(robot: situ.testing.Robot) -> None:
    async def go(board: AsyncBoard) -> None:
        async with board, board.authority("head") as head:

            async def busy() -> None:
                while True:
                    await head.wait(1.0)

            task = asyncio.create_task(busy())
            await asyncio.sleep(0)
            task.cancel()
            with pytest.raises(asyncio.CancelledError):
                await task

    robot.run(go(robot.connect_async(module="nod", resources=["head"])))


def test_in_asyncio_it_is_the_same(robot: situ.testing.Robot) -> None:
    async def go(board: AsyncBoard) -> None:
        async with board:
            with pytest.raises(BlackboardError, match="say which resources"):
                board.authority()
            head = board.authority("head")
            with pytest.raises(BlackboardError, match="only within"):
                await head.command(1)
            with pytest.raises(BlackboardError, match="NaN and infinity"):
                await board.set("sensor", math.nan)
            async with head:
                await head.command(1)
                assert robot.command("head") == 1

    robot.run(go(robot.connect_async(module="nod", resources=["head"])))
