"""A module that answers what applications ask: ``board.serve`` and ``board.requests``."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import situ.testing
from situ.blackboard import topics
from situ.blackboard.client import AsyncBoard, Board, ServiceRequest
from situ.errors import Refused
from situ.testing.robot import Robot

APPLICATION = """<application name="desk" start="1">
  <always><expectedevents><event name="back" next="1"/></expectedevents></always>
  <state no="1"><expectedevents><event name="go" next="2"/></expectedevents></state>
  <state no="2">
    <backgroundactions>
      <service name="pressure" url="board:cuff/measure" done="measured" failed="nothing">
        <param name="arm">left</param><result tag="bp.systolic" path="systolic"/>
      </service>
    </backgroundactions>
    <expectedevents>
      <event name="measured" next="3"/><event name="nothing" next="4"/>
    </expectedevents>
  </state>
  <state no="3"/><state no="4"/>
</application>"""


@pytest.fixture
def robot(tmp_path: Path) -> Iterator[Robot]:
    """Measures when it is told to go: state 3 is well, 4 badly."""
    (tmp_path / "situ.toml").write_text('[project]\nname = "x"\napplications = ["desk.rbd.xml"]\n')
    (tmp_path / "desk.rbd.xml").write_text(APPLICATION)
    with situ.testing.robot(tmp_path) as made:
        yield made


def state(robot: Robot) -> Any:
    return robot.value("application/desk.state")


def error(robot: Robot) -> Any:
    return robot.value("service/pressure.error")


def measure(params: dict[str, Any]) -> dict[str, Any]:
    if params != {"arm": "left"}:
        raise ValueError(f"no such arm: {params}")
    return {"systolic": 120}


def serve(board: Board, function: Any = measure) -> None:
    board.serve("measure", function)


async def serve_async(board: AsyncBoard) -> None:
    async def function(params: dict[str, Any]) -> dict[str, Any]:
        return measure(params)

    await board.serve("measure", function)


@pytest.mark.parametrize("form", ["blocking", "asyncio"])
def test_a_module_serves_a_request_by_a_function(robot: Robot, form: str) -> None:
    if form == "blocking":
        robot.start(serve, robot.connect("cuff"))
    else:
        robot.start(serve_async, robot.connect_async("cuff"))
    for _ in range(2):
        robot.publish("go")
        assert (state(robot), robot.value("bp.systolic")) == ("3", 120)
        robot.publish("back")


@pytest.mark.parametrize("form", ["blocking", "asyncio"])
def test_what_the_function_raises_is_the_error_and_it_serves_on(
    robot: Robot, form: str, caplog: pytest.LogCaptureFixture
) -> None:
    given: list[Any] = [ValueError("the cuff is not on"), {"systolic": 118}]

    def take(params: dict[str, Any]) -> Any:
        if isinstance(result := given.pop(0), Exception):
            raise result
        return result

    async def take_async(params: dict[str, Any]) -> Any:
        return take(params)

    async def serving(board: AsyncBoard) -> None:
        await board.serve("measure", take_async)

    if form == "blocking":
        robot.start(serve, robot.connect("cuff"), take)
    else:
        robot.start(serving, robot.connect_async("cuff"))
    robot.publish("go")
    assert (state(robot), error(robot)) == ("4", "cuff: the cuff is not on")
    assert "the cuff is not on" in caplog.text
    robot.publish("back")
    robot.publish("go")
    assert (state(robot), robot.value("bp.systolic")) == ("3", 118)


def test_requests_are_taken_and_answered_when_the_module_likes(robot: Robot) -> None:
    board = robot.connect("cuff")
    with board.requests("measure", "calibrate") as requests:
        robot.publish("go")
        request = requests.next(1.0)
        assert request is not None
        assert (request.request, request.params, request.application) == (
            "measure",
            {"arm": "left"},
            "desk",
        )
        robot.pass_time(20.0)
        assert state(robot) == "2"
        request.answer({"systolic": 121})
        request.fail("too late")
        robot.pass_time(0)
        assert (state(robot), robot.value("bp.systolic")) == ("3", 121)
        assert requests.next(0.5) is None


def test_a_request_can_call_back(robot: Robot) -> None:
    board = robot.connect("cuff")
    board.requests("measure", callback=lambda request: request.answer({"systolic": 119}))
    robot.publish("go")
    assert (state(robot), robot.value("bp.systolic")) == ("3", 119)


def test_a_state_that_is_left_takes_its_request_back(robot: Robot) -> None:
    board = robot.connect("cuff")
    with board.requests("measure") as requests:
        robot.publish("go")
        robot.publish("back")
        # Nobody has taken it yet, so nobody hears of it.
        assert requests.next(0.5) is None
        robot.publish("go")
        request = requests.next(0.5)
        assert request is not None
        assert not request.cancelled
        robot.publish("back")
        robot.pass_time(0)
        assert is_cancelled(request)
        request.answer({"systolic": 1})
        robot.pass_time(0.5)
        assert robot.value("bp.systolic") is None


def is_cancelled(request: ServiceRequest) -> bool:
    return request.cancelled


def test_in_asyncio_what_is_taken_back_is_cancelled(robot: Robot) -> None:
    told: list[str] = []

    async def never(params: dict[str, Any]) -> None:
        told.append("begun")
        try:
            await asyncio.Event().wait()
        finally:
            told.append("ended")

    async def serving(board: AsyncBoard) -> None:
        await board.serve("measure", never)

    robot.start(serving, robot.connect_async("cuff"))
    robot.publish("go")
    robot.pass_time(0)
    assert told == ["begun"]
    robot.publish("back")
    robot.pass_time(0)
    assert told == ["begun", "ended"]


def test_a_value_that_is_no_json_fails_the_request(robot: Robot) -> None:
    robot.start(serve, robot.connect("cuff"), lambda params: object())
    robot.publish("go")
    assert state(robot) == "4"
    assert "no JSON value" in error(robot)


def test_an_answer_given_while_the_connection_is_away_is_given_later(robot: Robot) -> None:
    board = robot.connect("cuff")
    with board.requests("measure") as requests:
        robot.publish("go")
        request = requests.next(0.5)
        assert request is not None
        line: Any = board._driver.line
        line.lose()
        request.answer({"systolic": 122})
        # Shorter than a lease: the session goes on.
        robot.pass_time(0.3)
        assert state(robot) == "2"
        robot.regain("cuff")
        robot.pass_time(1.5)
        assert (state(robot), robot.value("bp.systolic")) == ("3", 122)


def test_a_lost_notice_is_made_good_by_a_heartbeat(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    board = robot.connect("cuff")
    with board.requests("measure") as requests:
        dialog = board._dialog
        hear = dialog.hear
        monkeypatch.setattr(
            dialog, "hear", lambda frame, now: frame.startswith(b"q:") or hear(frame, now)
        )
        robot.publish("go")
        assert requests.next(0) is None
        assert requests.next(0.5) is not None


def test_no_answer_of_a_run_before_reaches_the_next(robot: Robot) -> None:
    board = robot.connect("cuff")
    with board.requests("measure") as requests:
        robot.publish("go")
        before = requests.next(0.5)
        assert before is not None
        robot.restart()
        robot.pass_time(2.0)
        assert is_cancelled(before)
        robot.publish("go")
        after = requests.next(0.5)
        assert after is not None
        before.answer({"systolic": 1})
        robot.pass_time(0.5)
        assert state(robot) == "2"
        after.answer({"systolic": 2})
        robot.pass_time(0)
        assert robot.value("bp.systolic") == 2


def test_two_parts_of_a_module_serve_different_requests(robot: Robot) -> None:
    board = robot.connect("cuff")
    with board.requests("calibrate") as other, board.requests("measure") as requests:
        robot.publish("go")
        request = requests.next(0.5)
        assert request is not None
        assert other.next(0) is None
        other.close()
        robot.pass_time(0.5)
        assert state(robot) == "2"
        request.answer({"systolic": 123})
        robot.pass_time(0)
        assert state(robot) == "3"


def test_who_serves_no_longer_fails_what_is_asked(robot: Robot) -> None:
    board = robot.connect("cuff")
    with board.requests("measure"):
        robot.publish("go")
        robot.pass_time(0)
    robot.pass_time(0.5)
    assert (state(robot), error(robot)) == ("4", "cuff has no request measure; it has none")


def test_only_a_module_is_asked(robot: Robot) -> None:
    async def ask() -> None:
        async with robot.connect_async() as board:
            await board.requests("measure").next()

    with pytest.raises(Refused, match="only a module is asked"):
        robot.connect().requests("measure")
    with pytest.raises(Refused, match="only a module is asked"):
        robot.run(ask())


@pytest.mark.parametrize(
    ("begin", "why"),
    [
        (lambda board: board.requests("measure", callback=print), "only a module is asked"),
        (lambda board: board.perform(None, print), "only a service"),
    ],
    ids=["requests", "perform"],
)
def test_entering_what_is_refused_says_why(
    robot: Robot, begin: Callable[[AsyncBoard], Any], why: str
) -> None:
    async def enter() -> None:
        async with robot.connect_async() as board, begin(board):
            pass

    with pytest.raises(Refused, match=why):
        robot.run(enter())


def test_what_is_asked_of_others_is_not_heard(robot: Robot) -> None:
    board = robot.connect("nod")
    with board.requests("measure") as requests:
        robot.connect("cuff")
        robot.publish("go")
        assert requests.next(0.5) is None
    assert topics.asked("nod") == b"q:nod\n"
