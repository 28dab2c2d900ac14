"""Services in processes of their own: the same robot as in one, and what a killed one leaves."""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import queue
import random
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import pytest

import situ
from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.calls import Person
from situ.blackboard.link import Link
from situ.document.ready import load_ready
from situ.engine.perform import Performer
from situ.engine.robots import Surroundings
from situ.engine.services import ServicesApart
from situ.errors import Unreachable

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
ROOT = Path(__file__).parent.parent
SCENARIOS = ROOT.parent / "examples" / "reception" / "scenarios"


@contextlib.contextmanager
def run(project: Path, state: Path, *options: str) -> Iterator[subprocess.Popen[str]]:
    """One process of a robot; killed in the end where it still runs."""
    command = ("-m", "situ", "run", str(project), "--json", "--no-restart", "--state", str(state))
    with subprocess.Popen(
        [sys.executable, *command, *options], stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            yield process
        finally:
            process.kill()


def ready(process: subprocess.Popen[str]) -> dict[str, Any]:
    assert process.stdout is not None
    said: dict[str, Any] = json.loads(process.stdout.readline())
    return said


def played(file: Path) -> list[dict[str, Any]]:
    """A trace without what differs from run to run."""
    events = [json.loads(line) for line in file.read_bytes().splitlines()]
    for event in events:
        del event["time"]
    return events


def test_the_trace_is_the_same_together_and_apart(tmp_path: Path) -> None:
    scenario = min(SCENARIOS.glob("*.jsonl"))
    project = scenario.parent.parent
    play = ("--endpoint", "tcp://127.0.0.1:0", "--script", str(scenario), "--speed", "1000")
    together, apart = tmp_path / "together.jsonl", tmp_path / "apart.jsonl"
    with run(project, tmp_path / "a", *play, "--trace", str(together)) as whole:
        ready(whole)
        assert whole.wait(DEADLINE) == 0
    options = ("--services", "core", "--clients", "1", "--trace", str(apart))
    with run(project, tmp_path / "b", *play, *options) as core:
        at = ("--endpoint", ready(core)["requests"], "--http", "127.0.0.1:0")
        with run(project, tmp_path / "c", "--services", "engine,robot,screen", *at) as services:
            assert ready(services)["http"].startswith("http://127.0.0.1:")
            assert core.wait(DEADLINE) == 0
            services.send_signal(signal.SIGTERM)
            assert services.wait(DEADLINE) == 0
    assert played(apart) == played(together)
    assert played(apart)


class Head:
    """A robot that only remembers what it was told; ``until`` waits for it."""

    resources = frozenset({"head"})

    def __init__(self, around: Surroundings) -> None:
        self.applied: list[Any] = []
        self._some = asyncio.Event()

    def apply(self, resource: str, value: Any) -> None:
        self.applied.append(value)
        self._some.set()

    async def until(self, ready: Callable[[list[Any]], bool]) -> None:
        async with asyncio.timeout(DEADLINE):
            while not ready(self.applied):
                self._some.clear()
                await self._some.wait()

    async def start(self) -> None:
        pass

    async def close(self) -> None:
        pass


def test_a_robot_stops_when_its_core_is_killed_and_goes_on_with_the_next(
    runtime: Runtime, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    """The lease of a core that says nothing ends; what it had commanded comes with its return."""
    runtime.start("--services", "core", "--no-restart")
    project = load_ready(runtime.project)
    made: list[Head] = []

    def adapter(around: Surroundings) -> Head:
        made.append(Head(around))
        return made[0]

    async def test() -> None:
        link = Link(runtime.endpoint, Person(role="service", services=("robot",)))
        apart = ServicesApart(
            AsyncBoard(link, DEADLINE),
            ("robot",),
            lambda submit, tag: Performer(
                project, submit, tag=tag, services=("robot",), adapter=adapter
            ),
        )
        await apart.start()
        try:
            await drive(made[0])
        finally:
            await apart.stop()

    async def drive(head: Head) -> None:
        with (
            situ.connect(runtime.endpoint, "nod", ["head"], timeout=DEADLINE) as board,
            board.authority("head") as authority,
        ):
            assert await asyncio.to_thread(authority.wait, DEADLINE)
            authority.command({"yaw": 20})
            await head.until(lambda applied: applied[-1:] == [{"yaw": 20}])
            await asyncio.to_thread(runtime.kill)
            await head.until(lambda applied: applied[-1] is None)
            await asyncio.to_thread(runtime.start, "--services", "core", "--no-restart")
            await head.until(lambda applied: applied[-1] == {"yaw": 20})
        await head.until(lambda applied: applied[-1] is None)

    caplog.set_level(logging.ERROR, "situ.run")
    asyncio.run(test())
    runtime.stop()


DESK = """<application name="desk" start="1">
  <state no="1"><expectedevents><event name="go" next="2"/></expectedevents></state>
  <state no="2">
    <backgroundactions>
      <service name="ask" url="{url}" done="asked"/>
      <service name="order" method="POST" url="{url}" failed="unsure"/>
    </backgroundactions>
    <expectedevents><event name="asked" next="1"/></expectedevents>
  </state>
</application>"""


class Slow(BaseHTTPRequestHandler):
    """Answers each question from the third on; ``asked`` has all methods."""

    asked: ClassVar[queue.Queue[str]] = queue.Queue()
    count: ClassVar[int] = 0
    over: ClassVar[threading.Event] = threading.Event()

    def do_GET(self) -> None:
        Slow.count += 1
        patient = Slow.count > 2
        Slow.asked.put(self.command)
        if not patient:
            Slow.over.wait(DEADLINE)
        self.send_response(200)
        self.end_headers()
        with contextlib.suppress(OSError):
            self.wfile.write(b"7")

    do_POST = do_GET

    def log_message(self, *_: Any) -> None:
        pass


@pytest.fixture
def slow(tmp_path: Path) -> Iterator[Path]:
    """A project that asks and orders at a service which does not answer the first time."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), Slow)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    folder = tmp_path / "desk"
    folder.mkdir()
    (folder / "situ.toml").write_text('[project]\nname = "x"\napplications = ["d.rbd.xml"]\n')
    url = f"http://127.0.0.1:{server.server_port}/"
    (folder / "d.rbd.xml").write_text(DESK.replace("{url}", url))
    yield folder
    Slow.over.set()
    server.shutdown()
    thread.join()
    server.server_close()


def test_what_a_killed_engine_asked_is_asked_again_and_what_it_ordered_fails(
    slow: Path, tmp_path: Path
) -> None:
    """The core goes on meanwhile; it never waits for a service."""
    options = ("--endpoint", "tcp://127.0.0.1:0", "--services", "core")
    with run(slow, tmp_path / "core", *options) as core:
        endpoint = ready(core)["requests"]
        engine = ("--services", "engine", "--endpoint", endpoint)
        with (
            situ.connect(endpoint, timeout=DEADLINE) as board,
            board.watch("service/*") as answers,
        ):
            with run(slow, tmp_path / "a", *engine) as first:
                ready(first)
                board.publish("go")
                assert {Slow.asked.get(timeout=DEADLINE) for _ in range(2)} == {"GET", "POST"}
                first.kill()
            order = answers.next(DEADLINE)
            assert order is not None
            assert (order.tag, order.value["ok"]) == ("service/order", False)
            assert "the service engine was lost while order was under way" in order.value["error"]
            with run(slow, tmp_path / "a", *engine) as second:
                ready(second)
                assert Slow.asked.get(timeout=DEADLINE) == "GET"
                answer = answers.next(DEADLINE)
                assert answer is not None
                assert (answer.tag, answer.value["ok"]) == ("service/ask", True)
                second.send_signal(signal.SIGTERM)
                assert second.wait(DEADLINE) == 0
        core.send_signal(signal.SIGTERM)
        assert core.wait(DEADLINE) == 0


def test_every_part_of_a_robot_may_be_killed_and_the_robot_goes_on(
    runtime: Runtime, chance: random.Random, often: Callable[[int, int], int]
) -> None:
    services = chance.sample(["screen", "robot", "engine"], often(1, 3))
    killed = [*services, "core"]
    runtime.supervised = True
    runtime.start("--apart")
    events: queue.Queue[dict[str, Any]] = queue.Queue()
    with (
        situ.connect(runtime.endpoint, timeout=DEADLINE) as board,
        board.watch("application/round") as states,
    ):
        version = _waits(states, 0)
        board.trace(since=1, callback=events.put)
        for round_, service in enumerate(killed, start=1):
            runtime.kill_part(service)
            _raise(board, "go")
            # Its state is left again when its time is over; what was before may be summed up.
            version = _waits(states, version)
            assert board.get("rounds") == round_
        last = board.get("rounds")
        seqs: list[int] = []
        while True:
            event = events.get(timeout=DEADLINE)
            seqs.append(event["seq"])
            if event["kind"] == "data" and (event["tag"], event["value"]) == ("rounds", last):
                break
    assert seqs == list(range(1, len(seqs) + 1))
    assert runtime.stop() == 0
    assert runtime.log.read_text("utf-8").count("was killed by signal 9; it is started") == len(
        killed
    )


def _waits(states: Any, after: int) -> int:
    """Returns when the application waits, at a version above that; the version."""
    while True:
        state = states.next(DEADLINE)
        assert state is not None
        if state.value["state"] == "1" and state.version > after:
            return int(state.version)


def _raise(board: situ.Board, event: str) -> None:
    """Whether it was raised is not known where the core was killed meanwhile; then it was not."""
    with contextlib.suppress(Unreachable):
        board.publish(event)
        return
    board.publish(event)
