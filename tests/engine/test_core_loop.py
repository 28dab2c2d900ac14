"""The core alone: the same robot without asyncio, and without what carries out effects."""

from __future__ import annotations

import contextlib
import json
import os
import re
import select
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest

import situ
from situ.document.ready import load_ready
from situ.engine.deciding import Deciding, Setup
from situ.engine.waking import Waking

DEADLINE = 20.0
LAB = Path(__file__).parent.parent / "blackboard" / "lab"
WARD = Path(__file__).parent.parent / "faults" / "ward"

SMALL = """
import atexit, sys
from situ.cli import main
heavy = "asyncio", "aiohttp", "httpx", "concurrent.futures", "situ.document.analysis"
atexit.register(lambda: print([name for name in heavy if name in sys.modules]))
sys.exit(main(sys.argv[1:]))
"""


def test_it_serves_keeps_and_ends_without_what_a_core_does_not_need(tmp_path: Path) -> None:
    trace = tmp_path / "trace.jsonl"
    options = ("--services", "core", "--no-restart", "--json", "--trace", str(trace))
    where = ("--endpoint", "tcp://127.0.0.1:0", "--state", str(tmp_path / "state"))
    with subprocess.Popen(
        [sys.executable, "-c", SMALL, "run", str(WARD), *options, *where],
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            assert process.stdout is not None
            ready = json.loads(process.stdout.readline())
            assert ready["http"] is None
            with (
                situ.connect(ready["requests"], timeout=DEADLINE) as board,
                board.watch("rounds") as rounds,
                board.watch("application/round") as states,
            ):
                # Durable: the acknowledgement comes from another thread.
                assert board.set("pill.a", "08:00") == {"pill.a": 1}
                first = rounds.next(DEADLINE)
                board.publish("go")
                second = rounds.next(DEADLINE)
                assert first is not None
                assert second is not None
                assert (first.value, second.value) == (0, 1)
                # What falls due by itself is done: the state is left after a while.
                seen: list[str] = []
                while seen[-2:] != ["2", "1"]:
                    state = states.next(DEADLINE)
                    assert state is not None
                    seen.append(state.value["state"])
            process.send_signal(signal.SIGTERM)
            assert process.wait(DEADLINE) == 0
            assert process.stdout.read() == "[]\n"
        finally:
            process.kill()
    seqs = [json.loads(line)["seq"] for line in trace.read_bytes().splitlines()]
    assert seqs == list(range(1, len(seqs) + 1))


def test_a_trace_that_nobody_reads_any_more_ends_it(tmp_path: Path) -> None:
    command = ("-m", "situ", "run", str(LAB), "--services", "core", "--no-restart")
    where = ("--endpoint", "tcp://127.0.0.1:0", "--state", str(tmp_path), "--trace", "-")
    with subprocess.Popen(
        [sys.executable, *command, *where], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        endpoint = re.search(rb"tcp://\S+", process.stderr.readline())
        assert endpoint is not None
        # Ended by the line of the trace that this writes, it may not get to the answer.
        with (
            contextlib.suppress(situ.errors.Unreachable),
            situ.connect(endpoint[0].decode(), timeout=DEADLINE) as board,
        ):
            board.set("x", 1)
        assert process.wait(DEADLINE) == 128 + signal.SIGPIPE


class Time:
    """Both clocks, moved by hand."""

    def __init__(self) -> None:
        self.now = 1000.0

    def clock(self) -> float:
        return self.now

    def wall(self) -> float:
        return 1_767_323_045.0 + self.now


def test_it_tells_when_it_is_to_be_called_next() -> None:
    time = Time()
    deciding = Deciding(
        load_ready(LAB),
        Setup(endpoint="inproc://requests", notify="inproc://notices", wall=time.wall),
        time.clock,
        lambda call: None,
    )
    deciding.start(deciding.bind())
    try:
        minute = deciding.look("clock.time")
        due = deciding.turn()
        assert due is not None
        assert 0 < due - time.now <= 60.1
        time.now = due
        following = deciding.turn()
        assert deciding.look("clock.time") != minute
        assert following is not None
        assert 59 < following - time.now <= 60.1
    finally:
        deciding.end(forget=True)
        deciding.close()


RESTLESS = """<application name="restless" start="1">
  <state no="1" name="here"><timeout next="2">0.001</timeout></state>
  <state no="2" name="there"><timeout next="1">0.001</timeout></state>
</application>
"""


class Passing(Time):
    """A clock on a slow machine: whenever it is looked at, more time has passed than the robot
    lets pass between two of its steps."""

    def clock(self) -> float:
        self.now += 0.002
        return self.now


def test_a_robot_that_never_keeps_up_with_its_timeouts_lets_others_have_their_turn(
    tmp_path: Path,
) -> None:
    (tmp_path / "restless.rbd.xml").write_text(RESTLESS, "utf-8")
    time = Passing()
    deciding = Deciding(
        load_ready(tmp_path / "restless.rbd.xml"),
        Setup(endpoint="inproc://requests", notify="inproc://notices", wall=time.wall),
        time.clock,
        lambda call: None,
    )
    deciding.start(deciding.bind())
    try:
        before = deciding.moment
        due = deciding.turn()
        assert deciding.moment > before
        assert due is not None
        assert due <= time.now
    finally:
        deciding.end(forget=True)
        deciding.close()


@pytest.fixture
def waking() -> Waking:
    return Waking(signal.SIGUSR1)


def test_a_wait_ends_with_a_call_from_another_thread_and_with_a_signal(waking: Waking) -> None:
    done: list[str] = []
    with waking:
        thread = threading.Thread(target=lambda: waking.soon(lambda: done.append("called")))
        thread.start()
        assert select.select([waking.fileno()], [], [], DEADLINE)[0]
        thread.join()
        waking.take()
        assert done == ["called"]
        os.kill(os.getpid(), signal.SIGUSR1)
        assert select.select([waking.fileno()], [], [], DEADLINE)[0]
        waking.take()
        assert waking.came == [signal.SIGUSR1]
        assert not select.select([waking.fileno()], [], [], 0)[0]
