"""A robot as a process of its own, killed and started again on the same addresses.

What is random is seeded, so that what failed can be done again: ``SITU_SEED``. How much is
done: a little in ``make check``, much with ``SITU_SOAK=1`` (``make soak``), with the figures
on standard output.
"""

from __future__ import annotations

import json
import os
import queue
import random
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

DEADLINE = 30.0
SOAK = bool(os.environ.get("SITU_SOAK"))
PROJECT = Path(__file__).parent / "ward"


class Runtime:
    """``situ run`` of one project with one state folder; ``start`` it, ``kill`` it, ``start``…

    From the first start on it keeps its addresses. supervised: whether what dies is started again.
    """

    def __init__(self, project: Path, state: Path) -> None:
        self.supervised = False
        self.project = project
        self.state = state
        self.endpoint = "tcp://127.0.0.1:0"
        self.log = state.with_suffix(".log")
        self._addresses: list[str] = ["--endpoint", self.endpoint]
        self._process: subprocess.Popen[str] | None = None
        self._reader: threading.Thread | None = None

    def start(self, *options: str) -> float:
        """Returns when it is ready; the seconds that took."""
        began = time.monotonic()
        with open(self.log, "ab") as log:
            self._process = subprocess.Popen(
                [
                    *(sys.executable, "-m", "situ", "run", str(self.project), "--json"),
                    *(() if self.supervised else ("--no-restart",)),
                    *("--state", str(self.state), *self._addresses, *options),
                ],
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
            )
        said: queue.Queue[str] = queue.Queue()
        out = self._process.stdout
        assert out is not None
        self._reader = threading.Thread(target=lambda: said.put(out.readline()))
        self._reader.start()
        line = said.get(timeout=DEADLINE)
        assert line, self.log.read_text("utf-8")
        ready = json.loads(line)
        self.endpoint = ready["requests"]
        self._addresses = ["--endpoint", self.endpoint, "--notify", ready["notifications"]]
        if ready["http"] is not None:
            self._addresses += ["--http", ready["http"].partition("//")[2].partition("/")[0]]
        return time.monotonic() - began

    def start_in_vain(self) -> tuple[int, str]:
        """Where it can not start: its exit status, and what it says."""
        done = subprocess.run(
            [
                *(sys.executable, "-m", "situ", "run", str(self.project)),
                *("--state", str(self.state), "--endpoint", "tcp://127.0.0.1:0"),
            ],
            capture_output=True,
            text=True,
            timeout=DEADLINE,
        )
        return done.returncode, done.stderr

    def kill_part(self, service: str) -> None:
        """kill -9 of the process that carries this out; for one that runs ``--apart``."""
        assert self._process is not None
        pid = self._process.pid
        found = []
        for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split():
            words = Path(f"/proc/{child}/cmdline").read_bytes().decode().split("\0")
            # One that has just died, or is just being started, has none yet or no longer.
            if "--services" in words and words[words.index("--services") + 1] == service:
                found.append(int(child))
        (one,) = found
        os.kill(one, signal.SIGKILL)

    def kill(self) -> None:
        """kill -9."""
        self._end(signal.SIGKILL)

    def stop(self) -> int:
        """SIGTERM; the exit status."""
        return self._end(signal.SIGTERM)

    @property
    def memory(self) -> float:
        """Megabytes that it has in memory now."""
        return self._status("VmRSS:")

    @property
    def peak(self) -> float:
        """The most megabytes that it has had in memory until now."""
        return self._status("VmHWM:")

    @property
    def running(self) -> bool:
        return self._process is not None

    def _status(self, line: str) -> float:
        assert self._process is not None
        status = Path(f"/proc/{self._process.pid}/status").read_text("utf-8")
        return int(status.partition(line)[2].split()[0]) / 1024

    def _end(self, number: signal.Signals) -> int:
        assert self._process is not None
        assert self._reader is not None
        self._process.send_signal(number)
        status = self._process.wait(DEADLINE)
        self._reader.join()
        assert self._process.stdout is not None
        self._process.stdout.close()
        self._process = None
        return status


@pytest.fixture
def runtime(tmp_path: Path) -> Iterator[Runtime]:
    """Not yet started; its project is a copy of ``ward``."""
    made = Runtime(shutil.copytree(PROJECT, tmp_path / "ward"), tmp_path / "state")
    yield made
    if made.running:
        made.kill()


@pytest.fixture(scope="module")
def make_runtime(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[Path], Runtime]]:
    """Makes one of a project, for all tests of a file; not yet started."""
    made: list[Runtime] = []

    def make(project: Path) -> Runtime:
        made.append(Runtime(project, tmp_path_factory.mktemp("robot") / "state"))
        return made[-1]

    yield make
    for one in made:
        if one.running:
            one.kill()


@pytest.fixture
def chance() -> random.Random:
    """Where a test chooses, it chooses by this."""
    return random.Random(int(os.environ.get("SITU_SEED", "1")))


@pytest.fixture
def soaking() -> bool:
    """Whether figures are asserted: nothing else runs."""
    return SOAK


@pytest.fixture
def often() -> Callable[[int, int], int]:
    """How often: in ``make check``, in ``make soak``."""
    return lambda checked, soaked: soaked if SOAK else checked
