"""A robot that lives: its clock, its due times, what carries out its effects."""

from __future__ import annotations

import asyncio
import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Awaitable, Callable
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import Any

import pytest

import situ
from situ.blackboard.client import AsyncBoard, Link, Person, connect_async
from situ.blackboard.curve import KeysOf
from situ.blackboard.replies import Addresses
from situ.decide import inputs
from situ.decide.effects import AnyEffect, Begin, Map
from situ.decide.trace import TraceEvent, to_line
from situ.document.project import Project
from situ.document.ready import load_ready
from situ.engine.deciding import Setup
from situ.engine.live import Broker, Live
from situ.engine.performing import Performing
from situ.engine.script import Script
from situ.errors import Unreachable, UsageError
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate

DEADLINE = 20.0
ROOT = Path(__file__).parent.parent
LAB = ROOT / "blackboard" / "lab"
PROJECTS = [LAB, *sorted(p.parent for p in (ROOT.parent / "examples").glob("*/situ.toml"))]
SCENARIOS = [s for project in PROJECTS for s in sorted((project / "scenarios").glob("*.jsonl"))]


class Hasty:
    """Carries out every action at once and well, and tells so; also that a robot moved."""

    def __init__(
        self, submit: Callable[[inputs.AnyInput], None], tag: Callable[[str], Any]
    ) -> None:
        self.submit = submit
        self.tag = tag
        self.performed: list[AnyEffect] = []
        self.closed = False

    @property
    def screen_url(self) -> str | None:
        return "http://127.0.0.1:1/"

    async def start(self) -> None:
        self._loop = asyncio.get_running_loop()

    def open_door(self, addresses: Addresses, keys: KeysOf | None) -> None:
        pass

    def turn_to(self, project: Project) -> None:
        pass

    def perform(self, effect: AnyEffect) -> None:
        self.performed.append(effect)
        ids = effect.actions if isinstance(effect, Map) else ()
        if isinstance(effect, Begin):
            ids = (effect.id,)
        for action in ids:
            self._loop.call_soon(self.submit, inputs.Finish(id=action, result={"names": []}))
        self._loop.call_soon(self.submit, inputs.Set({"robot.pose": [1, 2, 3]}, "sim"))

    async def close(self) -> None:
        self.closed = True


def live(
    project: Project,
    performer: Callable[..., Performing] | None = None,
    broker: Callable[..., Broker] | None = None,
    **setup: Any,
) -> Live:
    return Live(project, Setup(**setup), performer, broker=broker)


def go(test: Callable[[], Awaitable[None]]) -> None:
    async def within() -> None:
        async with asyncio.timeout(DEADLINE):
            await test()

    asyncio.run(within())


def test_effects_are_carried_out_and_their_ends_are_inputs() -> None:
    made: list[Hasty] = []

    def performer(submit: Any, tag: Any) -> Hasty:
        made.append(Hasty(submit, tag))
        return made[0]

    async def test() -> None:
        robot = live(load_ready(LAB), performer=performer)
        addresses = await robot.start()
        assert addresses.http == "http://127.0.0.1:1/"
        async with (
            connect_async(addresses.requests) as board,
            board.watch("application/desk") as desk,
        ):
            await board.publish("go")
            states: list[str] = []
            # The service ends well, its ``done`` leads back: nobody else told so.
            while states[-2:] != ["2", "1"]:
                change = await desk.next(DEADLINE)
                assert change is not None
                states.append(change.value["state"])
            assert await board.get("robot.pose") == [1, 2, 3]
            assert made[0].tag("robot.pose") == [1, 2, 3]
            assert made[0].tag("user.name") == "Ann"
        await robot.stop()
        assert made[0].closed

    go(test)


class Post:
    """A broker that keeps what it is sent, and tells of one event when it begins."""

    def __init__(self, submit: Callable[[inputs.AnyInput], None]) -> None:
        self.sent: list[tuple[str, Any]] = []
        self.closed = False
        self.came = asyncio.Event()
        self._submit = submit

    def start(self) -> None:
        self._submit(inputs.Raise("go"))

    def send(self, topic: str, value: Any) -> None:
        self.sent.append((topic, value))
        self.came.set()

    async def close(self) -> None:
        self.closed = True


def test_an_applications_message_is_told_to_the_broker() -> None:
    made: list[Post] = []

    def broker(submit: Any) -> Post:
        made.append(Post(submit))
        return made[0]

    async def test() -> None:
        robot = live(load_ready(LAB), broker=broker)
        await robot.start()
        await made[0].came.wait()
        assert made[0].sent == [("desk/busy", {"user": "Ann"})]
        await robot.stop()
        assert made[0].closed

    go(test)


def test_what_falls_due_is_done_without_being_asked() -> None:
    async def test() -> None:
        robot = live(load_ready(LAB))
        addresses = await robot.start()
        async with connect_async(addresses.requests, "chase", ["head"]) as board:
            head = board.watch("robot/head")
            async with board.authority("head") as chasing:
                await chasing.wait(DEADLINE)
                await chasing.command({"yaw": 3}, valid=0.05)
                values: list[tuple[Any, int]] = []
                while len(values) < 2:
                    change = await head.next(DEADLINE)
                    assert change is not None
                    values.append((change.value, change.time))
        (first, began), (second, ended) = values
        assert (first, second) == ({"yaw": 3}, None)
        assert ended - began == 50_000
        await robot.stop()

    go(test)


def test_the_time_of_day_stands_on_the_board_from_the_start() -> None:
    traces: list[TraceEvent] = []

    async def test() -> None:
        robot = live(load_ready(LAB), heard=lambda events, moment: traces.extend(events))
        addresses = await robot.start()
        async with connect_async(addresses.requests) as board:
            told = await board.entries("clock.*")
        assert re.fullmatch(r"\d\d:\d\d", told["clock.time"].value)
        assert re.fullmatch(r"\d{4}-\d\d-\d\d", told["clock.date"].value)
        assert told["clock.weekday"].value.endswith("day")
        await robot.stop()

    go(test)
    assert b"clock." not in b"".join(map(to_line, traces))


def test_the_time_of_day_goes_on_with_each_minute() -> None:
    midnight = datetime(2026, 1, 3).timestamp()
    moment = [midnight - 0.01]

    async def test() -> None:
        robot = live(load_ready(LAB), wall=lambda: moment[0])
        addresses = await robot.start()
        async with connect_async(addresses.requests) as board:
            clock = board.watch("clock.*")
            told: dict[str, list[str]] = {}
            while told.get("clock.weekday") != ["friday", "saturday"]:
                change = await clock.next(DEADLINE)
                assert change is not None
                told.setdefault(change.tag, []).append(change.value)
                assert change.writer in ("project", "situ")
                if len(told) == 3:
                    moment[0] = midnight
        assert told["clock.time"] == ["23:59", "00:00"]
        assert told["clock.date"] == ["2026-01-02", "2026-01-03"]
        await robot.stop()

    go(test)


def test_clients_are_told_that_the_runtime_stops() -> None:
    async def test() -> None:
        robot = live(load_ready(LAB))
        addresses = await robot.start()
        async with connect_async(addresses.requests) as board:
            watch = board.watch("user.*")
            assert await watch.next(DEADLINE)
            gone = asyncio.Event()
            board.link.dialog.changed = gone.set
            await robot.stop()
            await gone.wait()
            assert not board.connected

    go(test)


def test_a_performer_that_can_not_start_leaves_nothing_bound() -> None:
    class Broken(Hasty):
        async def start(self) -> None:
            raise UsageError("no such adapter")

    async def test() -> None:
        robot = live(load_ready(LAB), performer=Broken)
        with pytest.raises(UsageError):
            await robot.start()

    go(test)


@pytest.mark.parametrize("path", SCENARIOS, ids=lambda p: f"{p.parent.parent.name}-{p.stem}")
def test_live_and_simulated_traces_are_the_same(path: Path) -> None:
    project = load_ready(path.parent.parent)
    lines = scenario.load(path)
    simulated: list[bytes] = []
    verdict = simulate(project, lines, 7, 2.5, lambda e: simulated.extend(map(to_line, e)))
    script = Script(lines, speed=1e6)
    lived: list[bytes] = []

    def heard(events: list[TraceEvent], moment: float) -> None:
        script.heard(events, moment)
        lived.extend(map(to_line, events))

    async def test() -> None:
        robot = live(project, performer=Hasty, scripted=True, seed=7, auto_finish=2.5, heard=heard)
        addresses = await robot.start()
        async with AsyncBoard(Link(addresses.requests, Person(role="scenario"))) as board:
            await script.play(robot, board)
        await robot.stop()

    go(test)
    assert lived == simulated
    assert script.verdict.failures == verdict.failures


def run_lab(*arguments: str, state: Path) -> list[str]:
    return [
        *(sys.executable, "-m", "situ", "run", str(LAB), "--no-restart"),
        *("--state", str(state)),
        *("--endpoint", "tcp://127.0.0.1:0", *arguments),
    ]


def test_a_script_runs_with_everything_real_and_ends_with_its_verdict(tmp_path: Path) -> None:
    script = LAB / "scenarios" / "call.jsonl"
    trace = tmp_path / "trace.jsonl"
    command = run_lab("--script", str(script), "--speed", "1000", state=tmp_path)
    done = subprocess.run(
        [*command, "--trace", str(trace)], capture_output=True, text=True, timeout=DEADLINE
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert re.match(r"situ run: lab ready at tcp://127.0.0.1:\d+ screen http://", done.stdout)
    simulated: list[bytes] = []
    simulate(
        load_ready(LAB), scenario.load(script), tell=lambda e: simulated.extend(map(to_line, e))
    )
    timeless = [
        re.sub(rb',"time":"[^"]*"}$', b"}", line) + b"\n"
        for line in trace.read_bytes().splitlines()
    ]
    assert timeless == simulated


def test_an_expectation_that_fails_is_told_and_is_status_1(tmp_path: Path) -> None:
    script = tmp_path / "fails.jsonl"
    script.write_text('{"at":1,"event":"go"}\n{"at":1,"expect":{"kind":"enter","state":"9"}}\n')
    command = run_lab("--script", str(script), "--speed", "1000", "--trace", "-", state=tmp_path)
    done = subprocess.run(command, capture_output=True, text=True, timeout=DEADLINE)
    assert done.returncode == 1
    assert "line 2, at 1 s: expected" in done.stderr
    assert [json.loads(line)["seq"] for line in done.stdout.splitlines()][:3] == [1, 2, 3]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs a disk that is full")
def test_a_disk_that_is_full_ends_the_trace_and_not_the_robot(tmp_path: Path) -> None:
    script = LAB / "scenarios" / "call.jsonl"
    command = run_lab("--script", str(script), "--speed", "1000", state=tmp_path)
    done = subprocess.run(
        [*command, "--trace", "/dev/full"], capture_output=True, text=True, timeout=DEADLINE
    )
    assert done.returncode == 1
    (line,) = [line for line in done.stderr.splitlines() if "/dev/full" in line]
    assert "No space left on device; the trace ends here" in line
    assert "expected" not in done.stderr


def test_a_run_whose_trace_nobody_reads_any_more_ends(tmp_path: Path) -> None:
    with subprocess.Popen(
        run_lab("--trace", "-", state=tmp_path), stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert json.loads(process.stdout.readline())["seq"] == 1
        process.stdout.close()
        endpoint = re.search(rb"tcp://\S+", process.stderr.readline())
        assert endpoint is not None
        # It may end before it has answered: that is what the set is for.
        with suppress(Unreachable), situ.connect(endpoint[0].decode()) as board:
            board.set("x", 1)
        assert process.wait(DEADLINE) == 128 + signal.SIGPIPE
        assert b"Traceback" not in process.stderr.read()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
@pytest.mark.parametrize("script", [(), ("--script", str(LAB / "scenarios" / "call.jsonl"))])
def test_a_signal_ends_it(number: signal.Signals, script: tuple[str, ...], tmp_path: Path) -> None:
    with subprocess.Popen(
        run_lab("--json", *script, state=tmp_path),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=os.environ,
    ) as process:
        assert process.stdout is not None
        ready = json.loads(process.stdout.readline())
        assert ready["project"] == "lab"
        process.send_signal(number)
        _, error = process.communicate(timeout=DEADLINE)
        assert process.returncode == (1 if script else 0)
        assert (b"stopped before its end" in error) == bool(script)
