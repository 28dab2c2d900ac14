"""The modules of the conversation, each its own process, on a live robot (seed 000, Fig. 5)."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

import situ
from situ.blackboard.client import Board

CONVERSATION = Path(__file__).resolve().parents[2] / "examples" / "conversation"
RUNTIME = Path(situ.__file__).resolve().parents[1]
DEADLINE = 20.0
MODULES = {"chase-face", "nod", "gaze-sound", "face-caller", "transfer"}


@contextmanager
def program(*command: str) -> Iterator[subprocess.Popen[str]]:
    paths = [str(RUNTIME), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    running = subprocess.Popen(
        [sys.executable, *command], env=environment, stdout=subprocess.PIPE, text=True
    )
    try:
        yield running
    finally:
        running.terminate()
        running.communicate(timeout=DEADLINE)


@contextmanager
def robot(project: Path, state: Path) -> Iterator[str]:
    """A live robot with that project; its endpoint."""
    free = "tcp://127.0.0.1:0"
    command = ("-m", "situ", "run", str(project), "--json", "--no-restart", "--endpoint", free)
    with program(*command, "--state", str(state)) as running:
        assert running.stdout is not None
        yield json.loads(running.stdout.readline())["requests"]


class Trace:
    """What the robot does from its start on, looked through once."""

    def __init__(self, board: Board) -> None:
        self._events = board.trace(since=1)

    def find(self, **fields: Any) -> dict[str, Any]:
        """The next event with these fields."""
        end = time.monotonic() + DEADLINE
        while (left := end - time.monotonic()) > 0:
            event = self._events.next(left)
            if event is not None and fields.items() <= event.items():
                return event
        raise AssertionError(f"no event {fields}")


def authority(to: str | None, before: str | None, resource: str = "head") -> dict[str, Any]:
    return {"kind": "authority", "resource": resource, "from": before, "to": to}


def test_attention_goes_from_module_to_module_as_in_the_figure(tmp_path: Path) -> None:
    with (
        robot(CONVERSATION, tmp_path) as endpoint,
        program(str(CONVERSATION / "modules" / "start_all.py"), endpoint),
        situ.connect(endpoint) as board,
    ):
        trace = Trace(board)
        connected: set[str] = set()
        while connected != MODULES:
            connected.add(trace.find(kind="connected")["module"])
        # (A) the face of the speaker
        board.set({"face.visible": True, "face.direction": 12})
        trace.find(kind="mapping", module="chase-face", value={"yaw": 12, "pitch": 0})
        # (B) a nod
        board.set("speech.acceptable", True)
        trace.find(kind="situation", to="accepted")
        trace.find(**authority("nod", "chase-face"))
        trace.find(kind="mapping", module="nod", value={"pitch": -12})
        trace.find(**authority("chase-face", "nod"))
        # (C) a slap
        board.set("sound.slap", 40)
        trace.find(**authority("gaze-sound", "chase-face"))
        trace.find(kind="mapping", module="gaze-sound", value={"yaw": 40, "pitch": 0})
        trace.find(**authority("chase-face", "gaze-sound"))
        # (D) somebody else calls
        board.set({"person.calling": True, "person.direction": -20})
        asking: set[str] = set()
        while not asking.issuperset({"face-caller", "transfer"}):
            asking.add(trace.find(kind="acquire")["module"])
        # (E) and waves: handed over in the step of the wave, the conversation breaks off
        board.set("hand.waving", True)
        invited = trace.find(kind="situation", to="invited")
        assert trace.find(**authority("transfer", None, "base"))["t"] == invited["t"]
        assert trace.find(**authority("transfer", "face-caller"))["t"] == invited["t"]
        trace.find(kind="suspend", application="converse")
        trace.find(kind="mapping", module="transfer", value={"turn": -45.0})
        trace.find(kind="data", tag="transfer.phase", value="moving")
        trace.find(kind="mapping", module="transfer", value={"vx": 0.4})


@pytest.fixture
def with_stranger(tmp_path: Path) -> Path:
    """A copy of the example with the three places of its README filled in."""
    project = tmp_path / "conversation"
    shutil.copytree(CONVERSATION, project)
    (block,) = re.findall(r"```xml\n(.*?)```", (project / "README.md").read_text(), re.DOTALL)
    observed, declared, situation = block.strip().split("\n\n")
    file = project / "conversation.spds.xml"
    script = file.read_text()
    for place, added in (
        ("  </observe>", observed),
        ("  </modules>", declared),
        ('  <situation name="sound"', situation),
    ):
        assert script.count(place) == 1
        script = script.replace(place, f"{added}\n{place}")
    file.write_text(script)
    return project


def test_a_module_written_later_joins_without_touching_the_others(
    with_stranger: Path, tmp_path: Path
) -> None:
    modules = with_stranger / "modules"
    with (
        robot(with_stranger, tmp_path / "state") as endpoint,
        program(str(modules / "chase_face.py"), endpoint),
        program(str(modules / "greet_stranger.py"), endpoint),
        situ.connect(endpoint) as board,
    ):
        trace = Trace(board)
        trace.find(kind="connected")
        trace.find(kind="connected")
        board.set({"face.visible": True, "face.direction": 5})
        trace.find(kind="situation", to="stranger")
        trace.find(**authority("greet-stranger", "converse", "speech"))
        trace.find(kind="suspend", application="converse")
        trace.find(kind="mapping", module="greet-stranger", value={"text": "Hello! Have we met?"})
        trace.find(kind="situation", to="conversation")
        trace.find(**authority("converse", "greet-stranger", "speech"))
        trace.find(kind="resume", application="converse")
