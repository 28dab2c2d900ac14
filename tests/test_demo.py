"""The whole loop in processes of its own, and that nothing of it outlives its end."""

from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

import pytest

from situ import cli

DEADLINE = 30.0
STOPPING = 10.0
"""Seconds after which what still runs counts as left behind; 3 on a machine that is not busy."""
MARK = "SITU_TEST_DEMO"

Found = TypeVar("Found")

QUICK = """
import sys
from situ import cli, cli_demo
cli_demo.HEADLESS_SECONDS = 2
if "--play" in sys.argv:
    cli_demo._scenario = lambda project: project / "scenarios" / "lost.jsonl"
sys.exit(cli.main(["demo", *sys.argv[1:]]))
"""


class Demo:
    """A running demonstration; ``family`` are its processes, known by a mark they inherit."""

    def __init__(self, folder: Path, *arguments: str, window: bool = False) -> None:
        self.mark = uuid.uuid4().hex
        display = {"DISPLAY": ":situ", "SITU_HEADLESS": "0"} if window else {"SITU_HEADLESS": "1"}
        self.process = subprocess.Popen(
            [sys.executable, "-c", QUICK, *arguments],
            cwd=folder,
            env={**os.environ, **display, "QT_QPA_PLATFORM": "offscreen", MARK: self.mark},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def family(self) -> dict[int, str]:
        """Pid to command line of every process of it that runs."""
        found = {}
        wanted = f"{MARK}={self.mark}".encode()
        for process in Path("/proc").glob("[0-9]*"):
            with suppress(OSError):
                if wanted in (process / "environ").read_bytes().split(b"\0"):
                    line = (process / "cmdline").read_bytes().replace(b"\0", b" ").decode()
                    found[int(process.name)] = line
        return found

    def until_told(self, words: str) -> str:
        """Reads standard error up to the line with ``words``."""
        assert self.process.stderr is not None
        for line in self.process.stderr:
            if words in line:
                return line
        raise AssertionError(f"it ended without saying {words!r}")

    def member(self, words: str) -> int:
        """The process with ``words`` in its command line, once it is there."""
        return self.until(
            lambda: next((pid for pid, line in self.family().items() if words in line), None),
            f"a process with {words!r}",
        )

    def until(self, there: Callable[[], Found | None], what: str) -> Found:
        """What ``there`` finds, once it does; looks again at most every 50 ms."""
        deadline = time.monotonic() + DEADLINE
        while time.monotonic() < deadline:
            if found := there():
                return found
            # Its end would be the only news.
            assert gone({self.process.pid}, 0.05), f"it ended without {what}"
        raise AssertionError(f"no sign of {what}")

    def close(self) -> None:
        for pid in self.family():
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        self.process.communicate()


def gone(pids: set[int], within: float) -> set[int]:
    """Those that still run when the time is over; a process that ended makes its pidfd readable."""
    deadline = time.monotonic() + within
    left = set()
    for pid in pids:
        try:
            descriptor = os.pidfd_open(pid)
        except ProcessLookupError:
            continue
        with os.fdopen(descriptor) as ended:
            if not select.select([ended], [], [], max(0.0, deadline - time.monotonic()))[0]:
                left.add(pid)
    return left


def catches(pid: int, number: signal.Signals) -> bool:
    """Whether the process has a handler of its own for the signal."""
    status = Path(f"/proc/{pid}/status").read_text()
    (caught,) = (line for line in status.splitlines() if line.startswith("SigCgt:"))
    return bool(int(caught.split()[1], 16) >> (number - 1) & 1)


@pytest.fixture
def demo(tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Demo]:
    arguments, window = request.param
    running = Demo(tmp_path, *arguments, window=window)
    yield running
    running.close()


@pytest.mark.parametrize(
    ("demo", "application"),
    [((["reception"], False), "reception"), ((["conversation"], False), "converse")],
    indirect=["demo"],
)
def test_without_a_display_it_plays_prints_and_leaves_a_picture(
    demo: Demo, application: str, tmp_path: Path
) -> None:
    out, told = demo.process.communicate(timeout=DEADLINE)
    assert demo.process.returncode == 0, told
    trace = [json.loads(line) for line in out.splitlines()]
    assert [event["seq"] for event in trace] == list(range(1, len(trace) + 1))
    assert [e for e in trace if e["kind"] == "transition" and e["application"] == application]
    assert (tmp_path / "demo.png").read_bytes().startswith(b"\x89PNG")
    assert "demo.png" in told
    assert demo.family() == {}


@pytest.mark.parametrize("demo", [(["reception"], True)], indirect=True)
def test_a_closed_window_ends_all(demo: Demo) -> None:
    address = demo.until_told("touch its screen").split()[-1]
    assert address.startswith("http://127.0.0.1:")
    editor = demo.member("situ_studio")
    family = set(demo.family())
    demo.until(lambda: catches(editor, signal.SIGTERM), "the window's loop")
    os.kill(editor, signal.SIGTERM)  # as the window's own close: Qt's loop ends
    assert gone(family, STOPPING) == set()
    assert demo.process.wait() == 0


@pytest.mark.parametrize("demo", [(["conversation"], True)], indirect=True)
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_nothing_outlives_a_demonstration_that_is_stopped(
    demo: Demo, number: signal.Signals
) -> None:
    demo.member("situ_studio")
    demo.member("nod.py")
    assert len(demo.family()) > 4
    demo.process.send_signal(number)
    assert gone({demo.process.pid}, STOPPING) == set()
    # Whom it started last may be seen only now.
    assert gone(set(demo.family()), STOPPING) == set()
    assert demo.family() == {}


@pytest.mark.parametrize("demo", [(["conversation", "--play"], True)], indirect=True)
def test_the_end_of_a_played_scenario_ends_all(demo: Demo) -> None:
    demo.until_told("playing")
    family = set(demo.family())
    assert demo.process.wait(DEADLINE) == 0
    assert gone(family, STOPPING) == set()
    assert demo.family() == {}


def test_an_unknown_example_is_told_in_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["demo", "no-such-example"]) == 2
    told = capsys.readouterr().err
    assert "conversation" in told
    assert len(told.splitlines()) == 1
