"""Every program of docs/modules.md, against ``situ run examples/conversation``."""

from __future__ import annotations

import json
import os
import queue
import re
import runpy
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.live_trace import DEADLINE, find

import situ
import situ.testing

ROOT = Path(__file__).parent.parent
PAGE = (ROOT / "docs" / "modules.md").read_text("utf-8")
PROGRAMS = dict(re.findall(r"```python\n# (\w+\.py)\n(.*?)```", PAGE, re.DOTALL))


class Robot:
    """``situ run examples/conversation``, and the page's programs, which find it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        free = ("--endpoint", "tcp://127.0.0.1:0", "--state", str(folder / "state"))
        self.process = subprocess.Popen(
            [sys.executable, "-m", "situ", "run", "examples/conversation", "--json", *free],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self.process.stdout is not None
        said: queue.Queue[str] = queue.Queue()
        reader = threading.Thread(target=lambda: said.put(out.readline()))
        out = self.process.stdout
        reader.start()
        self.endpoint: str = json.loads(said.get(timeout=DEADLINE))["requests"]
        reader.join()
        for name, text in PROGRAMS.items():
            for call in ("situ.connect(", "situ.connect_async("):
                text = text.replace(call, f'{call}"{self.endpoint}", ')
            (folder / name).write_text(text.replace(", )", ")"))

    def start(self, name: str) -> subprocess.Popen[str]:
        pipe = subprocess.PIPE
        command = [sys.executable, str(self.folder / name)]
        return subprocess.Popen(
            command, stdin=pipe, stdout=pipe, stderr=pipe, text=True, env=dict(os.environ)
        )

    def run(self, name: str, said: str = "") -> str:
        """What a program that ends by itself prints."""
        with self.start(name) as program:
            out, err = program.communicate(said, timeout=DEADLINE)
        assert (program.returncode, err) == (0, "")
        return out


@pytest.fixture(scope="module")
def robot(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Robot]:
    running = Robot(tmp_path_factory.mktemp("page"))
    yield running
    running.process.terminate()
    running.process.communicate(timeout=DEADLINE)


@pytest.fixture
def board(robot: Robot) -> Iterator[situ.Board]:
    with situ.connect(robot.endpoint, timeout=DEADLINE) as connected:
        yield connected


def test_every_program_of_the_page_is_run_here() -> None:
    assert PAGE.count("```python") == len(PROGRAMS)
    tests = Path(__file__).read_text("utf-8")
    for name in PROGRAMS:
        assert f'"{name}"' in tests, name


def test_a_module_takes_part_in_few_lines() -> None:
    lines = [line for line in PROGRAMS["nod.py"].splitlines() if line]
    assert len(lines) <= 15


def test_a_look_at_the_robot(robot: Robot) -> None:
    assert robot.run("look.py") == "conversation 12\n"


@pytest.mark.parametrize("name", ["nod.py", "nod_async.py"])
def test_the_module_nods(robot: Robot, board: situ.Board, name: str) -> None:
    with board.trace() as events, robot.start(name) as module:
        find(events, kind="connected", module="nod")
        board.set("speech.acceptable", True)
        for pitch in (-12, 0):
            find(events, kind="mapping", module="nod", value={"pitch": pitch})
        find(events, kind="authority", **{"from": "nod"})
        # Ctrl-C.
        module.send_signal(signal.SIGINT)
        assert module.communicate(timeout=DEADLINE) == ("", "")
        assert module.returncode == 0
        find(events, kind="lost", module="nod")


def test_the_tests_of_the_page_pass(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    monkeypatch.syspath_prepend(str(robot.folder))
    monkeypatch.delitem(sys.modules, "nod", raising=False)
    tests: list[Callable[[], None]] = [
        test
        for name, test in runpy.run_path(str(robot.folder / "test_nod.py")).items()
        if name.startswith("test_")
    ]
    assert len(tests) == 3
    for test in tests:
        test()
    monkeypatch.delitem(sys.modules, "nod")


def test_a_module_tells_what_it_needs(robot: Robot, board: situ.Board) -> None:
    assert "clock for thermometer\n" in robot.run("thermometer.py")
    assert board.get("room.temperature") == 21.5


ASKING = """<application name="desk" start="0">
  <state no="0"><timeout next="1">1</timeout></state>
  <state no="1">
    <backgroundactions>
      <service name="pressure" url="board:cuff/measure" done="ok" failed="no">
        <param name="arm">{arm}</param><result tag="bp" path="systolic"/>
      </service>
    </backgroundactions>
    <expectedevents><event name="ok" next="2"/><event name="no" next="3"/></expectedevents>
  </state>
  <state no="2"/><state no="3"/>
</application>"""


@pytest.mark.parametrize(("arm", "state", "value"), [("left", "2", 120), ("tail", "3", None)])
def test_a_module_answers_what_applications_ask(
    robot: Robot, tmp_path: Path, arm: str, state: str, value: int | None
) -> None:
    asking = tmp_path / "desk.rbd.xml"
    asking.write_text(ASKING.replace("{arm}", arm))
    cuff = runpy.run_path(str(robot.folder / "cuff.py"))["cuff"]
    with situ.testing.robot(asking) as desk:
        desk.start(cuff, desk.connect(module="cuff"))
        desk.pass_time(1.5)
        assert desk.value("application/desk.state") == state
        assert desk.value("bp") == value


def test_values_are_set_and_got(robot: Robot, board: situ.Board) -> None:
    room, version, refused = robot.run("values.py").splitlines()
    assert (room, version) == ("7", "1")
    assert refused.endswith("get it and try again")
    assert board.get("turn") is None


def test_a_stream_follows_the_face(robot: Robot, board: situ.Board) -> None:
    with board.trace() as events, robot.start("follow.py") as module:
        for yaw in (20, -20):
            board.set("face.direction", yaw)
            find(events, kind="mapping", module="chase-face", value={"yaw": yaw, "pitch": 0})
        module.kill()
        find(events, kind="mapping", resource="head", value=None)


def test_a_callback_counts(robot: Robot, board: situ.Board) -> None:
    assert robot.run("callback.py") == "slaps: 1\n"


def test_what_is_heard_is_told(robot: Robot, board: situ.Board) -> None:
    assert robot.run("recogniser.py", "good morning\n") == ""
    assert board.get("heard.text") == "good morning"
    assert board.get("speech.acceptable") is False
