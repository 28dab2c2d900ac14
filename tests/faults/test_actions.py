"""What an action needs does not work: its ``failed``, a warning in the trace, and the state machine
goes on (quality, *Faults*); and what works, over one real ``situ run``."""

from __future__ import annotations

import json
import os
import queue
import select
import socket
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import situ
from situ.blackboard.client import Board

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
PATIENCE = 0.3
PROJECT = """[project]
name = "desk"
applications = ["desk.rbd.xml"]
"""
APPLICATION = """<application name="desk" start="idle">
  <always><expectedevents><event name="home" next="idle"/></expectedevents></always>
  <state no="idle"><expectedevents>
    <event name="service" next="1"/><event name="module" next="2"/>
    <event name="speech" next="3"/><event name="launch" next="4"/><event name="absent" next="5"/>
    <event name="cuff" next="6"/><event name="file" next="7"/>
  </expectedevents></state>
  <state no="1"><backgroundactions>
    <service name="silent" url="http://127.0.0.1:1/" failed="bad"/>
  </backgroundactions><expectedevents><event name="bad" next="bad"/></expectedevents></state>
  <state no="2"><backgroundactions>
    <service name="silent" url="board:silent/answer" failed="bad"/>
  </backgroundactions><expectedevents><event name="bad" next="bad"/></expectedevents></state>
  <state no="3"><backgroundactions><speech failed="bad">No</speech></backgroundactions>
  <expectedevents><event name="bad" next="bad"/></expectedevents></state>
  <state no="4"><backgroundactions><launch program="xterm" failed="bad"/></backgroundactions>
  <expectedevents><event name="bad" next="bad"/></expectedevents></state>
  <state no="5"><backgroundactions>
    <service name="nobody" url="board:nobody/answer" failed="bad"/>
  </backgroundactions><expectedevents><event name="bad" next="bad"/></expectedevents></state>
  <state no="6"><backgroundactions>
    <service name="cuff" url="board:cuff/measure" done="good">
      <param name="arm">left</param><result tag="bp" path="systolic"/>
    </service>
  </backgroundactions><expectedevents><event name="good" next="good"/></expectedevents></state>
  <state no="7"><backgroundactions>
    <service name="quiz" url="media:quiz.json" done="good"><result tag="quiz" path="0.q"/></service>
  </backgroundactions><expectedevents><event name="good" next="good"/></expectedevents></state>
  <state no="bad"/><state no="good"/>
</application>"""


def desk(folder: Path) -> Path:
    """The project, with its media."""
    (folder / "situ.toml").write_text(PROJECT + 'media = "media"\n', "utf-8")
    (folder / "desk.rbd.xml").write_text(APPLICATION, "utf-8")
    (folder / "media").mkdir()
    (folder / "media" / "quiz.json").write_text('[{"q": "Who?"}]', "utf-8")
    return folder


@pytest.fixture(scope="module")
def robot(make_runtime: Callable[[Path], Runtime], tmp_path_factory: Any) -> Iterator[Runtime]:
    """A robot that can be heard, without an engine to speak; a web service that is silent."""
    folder = desk(tmp_path_factory.mktemp("desk"))
    with socket.create_server(("127.0.0.1", 0)) as silent:
        port = silent.getsockname()[1]
        written = folder / "desk.rbd.xml"
        written.write_text(APPLICATION.replace(":1/", f":{port}/"), "utf-8")
        made = make_runtime(folder)
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("PATH", str(folder / "none"))
            patch.setenv("PULSE_SERVER", "/nowhere")
            made.start("--patience", str(PATIENCE))
        yield made


@pytest.fixture
def board(robot: Runtime) -> Iterator[Board]:
    with situ.connect(robot.endpoint, timeout=DEADLINE) as connected:
        yield connected


def end(board: Board, event: str) -> tuple[str, list[dict[str, Any]]]:
    """The state that the event led to in the end, and the trace of it; then all goes on."""
    with board.trace() as events:
        board.publish(event)
        seen: list[dict[str, Any]] = []
        while not seen or seen[-1]["kind"] != "enter" or seen[-1]["state"] not in ("bad", "good"):
            one = events.next(DEADLINE)
            assert one is not None, seen
            seen.append(one)
        state = seen[-1]["state"]
        board.publish("home")
        while seen[-1]["kind"] != "enter" or seen[-1]["state"] != "idle":
            one = events.next(DEADLINE)
            assert one is not None, seen
            seen.append(one)
    return state, seen


@pytest.mark.parametrize(
    ("event", "words"),
    [
        ("service", f"did not answer within {PATIENCE:g} s"),
        ("module", f"silent did not answer answer within {PATIENCE:g} s"),
        ("absent", "nobody is not connected"),
        ("speech", "espeak-ng"),
        ("launch", "xterm may not be started"),
    ],
)
def test_what_can_not_be_carried_out_fails_its_action_and_the_state_machine_goes_on(
    board: Board, robot: Runtime, event: str, words: str
) -> None:
    # A module that is connected and says nothing.
    with situ.connect(robot.endpoint, "silent", timeout=DEADLINE):
        state, seen = end(board, event)
    assert state == "bad"
    (finished,) = [one for one in seen if one["kind"] == "finished"]
    assert not finished["ok"]
    assert words in finished["error"]
    (warning,) = [one for one in seen if one["kind"] == "warning"]
    assert words in warning["message"]
    assert warning["cause"] == finished["seq"]


def test_a_module_answers_over_real_sockets(board: Board, robot: Runtime) -> None:
    with situ.connect(robot.endpoint, "cuff", timeout=DEADLINE) as cuff:
        asked: queue.Queue[Any] = queue.Queue()

        def take(request: Any) -> None:
            asked.put(request.params)
            request.answer({"systolic": 120})

        cuff.requests("measure", callback=take)
        assert end(board, "cuff")[0] == "good"
        assert asked.get(timeout=DEADLINE) == {"arm": "left"}
    assert board.get("bp") == 120


def test_a_file_of_the_project_is_read_by_a_real_robot(board: Board) -> None:
    assert end(board, "file")[0] == "good"
    assert board.get("quiz") == "Who?"


def test_a_module_answers_a_core_that_was_killed_meanwhile(
    make_runtime: Callable[[Path], Runtime], tmp_path: Path
) -> None:
    robot = make_runtime(desk(tmp_path))
    robot.start()
    with (
        situ.connect(robot.endpoint, "cuff", timeout=DEADLINE) as cuff,
        situ.connect(robot.endpoint, timeout=DEADLINE) as board,
        cuff.requests("measure") as requests,
        board.watch("application/desk") as where,
    ):
        board.publish("cuff")
        request = requests.next(DEADLINE)
        assert request is not None
        robot.kill()
        request.answer({"systolic": 121})
        robot.start()
        states: list[str] = []
        while states[-1:] != ["good"]:
            change = where.next(DEADLINE)
            assert change is not None, states
            states.append(change.value["state"])
        assert board.get("bp") == 121
        # It was asked once.
        assert requests.next(0) is None
    assert robot.stop() == 0


# -- programs ----------------------------------------------------------------

NAP = """import os, signal, sys
with open(sys.argv[1], "w") as told:
    told.write(str(os.getpid()))
signal.pause()
"""
NAPS = """<application name="desk" start="idle">
  <always><expectedevents>
    <event name="home" next="idle"/><event name="short" next="1"/><event name="kept" next="2"/>
  </expectedevents></always>
  <state no="idle"/>
  <state no="1"><backgroundactions><launch program="nap"/></backgroundactions></state>
  <state no="2"><backgroundactions><launch program="nap" keep="true"/></backgroundactions></state>
</application>"""


def started(pipe: Path) -> int:
    """The process id that a program writes when it has started, as a descriptor of it."""
    return os.pidfd_open(int(pipe.read_text("utf-8")))


def has_ended(process: int, within: float) -> bool:
    return bool(select.select([process], [], [], within)[0])


def test_a_program_ends_with_its_state_unless_kept_and_with_the_core_however_it_dies(
    make_runtime: Callable[[Path], Runtime], tmp_path: Path
) -> None:
    (tmp_path / "situ.toml").write_text(PROJECT, "utf-8")
    (tmp_path / "desk.rbd.xml").write_text(NAPS, "utf-8")
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    robot = make_runtime(tmp_path)
    robot.state.mkdir()
    command = json.dumps([sys.executable, "-c", NAP, str(pipe)])
    (robot.state / "launch.toml").write_text(f"nap = {command}\n", "utf-8")
    robot.start()
    with situ.connect(robot.endpoint, timeout=DEADLINE) as board:
        board.publish("short")
        short = started(pipe)
        board.publish("kept")
        kept = started(pipe)
        assert has_ended(short, DEADLINE)
        board.publish("home")
        assert board.get("application/desk")["state"] == "idle"
        assert not has_ended(kept, 0)
        robot.kill()
        assert has_ended(kept, DEADLINE)
    for process in (short, kept):
        os.close(process)
