"""A core with its sessions driven by hand, and the same as a process of its own."""

from __future__ import annotations

import json
import os
import queue
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import msgspec
import pytest

from situ.blackboard import notices, wire
from situ.blackboard.backlog import Backlog
from situ.blackboard.core import Core, Durability, Outgoing
from situ.blackboard.replies import Addresses
from situ.blackboard.session import Sessions
from situ.decide.robot import Robot
from situ.document.project import Project
from situ.document.ready import load_ready

DEADLINE = 20.0
LAB = Path(__file__).parent / "lab"


@pytest.fixture(scope="session")
def lab() -> Project:
    return load_ready(LAB)


class Hand:
    """A core with sessions; time is told in seconds, messages are plain objects."""

    def __init__(
        self,
        project: Project,
        scripted: bool = False,
        keep: int = 1000,
        durability: Durability | None = None,
        begin: bool = True,
    ) -> None:
        self.now = 0
        self.robot = Robot(project)
        self.core = Core(
            self.robot,
            project,
            epoch=1_767_323_045.0,
            files={"situ.toml": "…"},
            backlog=Backlog(keep),
            durability=durability,
        )
        addresses = Addresses("tcp://127.0.0.1:1", "tcp://127.0.0.1:2")
        self.sessions = Sessions(self.core, addresses, scripted=scripted)
        if begin:
            self.sessions.start()
        self.notices: list[bytes] = []
        self.effects: list[Any] = []
        self._numbers = 0
        self._take()

    def at(self, seconds: float) -> Hand:
        """Moves time there, doing what falls due."""
        self.now = round(seconds * 1_000_000)
        while (due := self.sessions.due()) is not None and due <= self.now:
            self.sessions.advance(due)
        self.sessions.advance(self.now)
        self._take()
        return self

    def raw(self, peer: str, body: bytes) -> bytes:
        """The reply's body to a request's."""
        self.sessions.receive(peer, body, self.now)
        ((to, reply),) = self._take().replies
        assert to == peer
        return bytes(reply)

    def ask(self, peer: str, do: str, **fields: Any) -> dict[str, Any]:
        self._numbers += 1
        body = msgspec.json.encode({"do": do, "id": self._numbers, **fields})
        reply: dict[str, Any] = msgspec.json.decode(self.raw(peer, body))
        assert reply["id"] == self._numbers
        return reply

    def hello(self, peer: str, **fields: Any) -> dict[str, Any]:
        """A greeting: as a module of the peer's name, unless there is another role."""
        if "role" not in fields:
            fields.setdefault("module", peer)
        return self.ask(peer, "hello", version=1, **fields)

    def heard(self) -> list[notices.AnyNotice]:
        """The notices since the last call."""
        notices, self.notices = self.notices, []
        return [wire.read_notice(frame) for frame in notices]

    def changes(self) -> list[tuple[str, Any, int]]:
        """Tag, value and version of the changes among them."""
        found = [one for one in self.heard() if isinstance(one, notices.Change)]
        return [(one.tag, one.value, one.version) for one in found]

    def _take(self) -> Outgoing:
        out = self.sessions.take()
        self.notices += out.notices
        self.effects += out.effects
        return out


@pytest.fixture(scope="session")
def ward_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The lab with something private."""
    folder = shutil.copytree(LAB, tmp_path_factory.mktemp("ward") / "lab")
    with (folder / "situ.toml").open("a") as text:
        text.write('[privacy]\nprivate = ["user.**", "private.*"]\n')
    return folder


@pytest.fixture(scope="session")
def ward(ward_folder: Path) -> Project:
    return load_ready(ward_folder)


@pytest.fixture
def hand(lab: Project) -> Hand:
    return Hand(lab)


@pytest.fixture
def make_hand(lab: Project) -> Callable[..., Hand]:
    return lambda project=lab, **options: Hand(project, **options)


class Running:
    """``situ run`` as a process; ``endpoint`` is where it is asked."""

    def __init__(self, folder: Path, arguments: list[str], project: Path = LAB) -> None:
        self.arguments = arguments
        self.process = subprocess.Popen(
            [
                sys.executable,
                "-m",
                "situ",
                "run",
                str(project),
                "--json",
                "--no-restart",
                *arguments,
            ],
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "XDG_STATE_HOME": str(folder)},
        )
        said: queue.Queue[str] = queue.Queue()
        assert self.process.stdout is not None
        out = self.process.stdout
        self._reader = threading.Thread(target=lambda: said.put(out.readline()))
        self._reader.start()
        try:
            ready = json.loads(said.get(timeout=DEADLINE))
        except (queue.Empty, ValueError):
            # Nobody else knows of it yet, so nobody else would end it.
            self.kill()
            raise
        self.endpoint: str = ready["requests"]
        self.notifications: str = ready["notifications"]
        self.http: str | None = ready["http"]

    def kill(self) -> None:
        """kill -9, as when the robot's computer loses power."""
        self.process.kill()
        self._gone()

    def stop(self) -> int:
        """SIGTERM; the exit status. It has 3 s to end."""
        self.process.send_signal(signal.SIGTERM)
        return self._gone()

    def _gone(self) -> int:
        status = self.process.wait(DEADLINE)
        self._reader.join()
        assert self.process.stdout is not None
        self.process.stdout.close()
        return status


@pytest.fixture
def run_lab(tmp_path: Path) -> Iterator[Callable[..., Running]]:
    """Starts ``situ run``; on free ports unless arguments say other ones."""
    started: list[Running] = []

    def start(*arguments: str, project: Path = LAB) -> Running:
        given = list(arguments) or ["--endpoint", "tcp://127.0.0.1:0"]
        started.append(Running(tmp_path, given, project))
        return started[-1]

    yield start
    for running in started:
        if running.process.poll() is None:
            running.kill()


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """One ``situ run`` for all tests of a file that only talk to it."""
    robot = Running(tmp_path_factory.mktemp("state"), ["--endpoint", "tcp://127.0.0.1:0"])
    yield robot
    assert robot.stop() == 0
