"""What every test gets: no display, no settings of the person who runs it, nothing left running."""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from situ import cli
from situ.system_libraries import PATH

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

PATIENCE = 2.0
"""Seconds that a thread gets to end after the test that started it."""


def pytest_configure(config: pytest.Config) -> None:
    """Puts settings, state and sockets of this run into a folder of its own."""
    home = Path(tempfile.mkdtemp(prefix="situ-tests-"))
    config.add_cleanup(lambda: shutil.rmtree(home, ignore_errors=True))
    for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"):
        folder = home / name.lower()
        folder.mkdir(mode=0o700)
        os.environ[name] = str(folder)
    # A slow machine is no fault of what is tested.
    checks = [HealthCheck.too_slow]
    settings.register_profile("any-machine", deadline=None, suppress_health_check=checks)
    settings.load_profile("any-machine")


@pytest.fixture(autouse=True)
def nothing_left_running() -> Iterator[None]:
    """A test that leaves a thread or a process running fails; those of wider fixtures may stay."""
    threads, processes = set(threading.enumerate()), _children()
    yield
    deadline = time.monotonic() + PATIENCE
    left = [thread for thread in threading.enumerate() if thread not in threads]
    # Threads that Qt started show up as dummies, and never go; nor does pyzmq's own.
    left = [thread for thread in left if type(thread).__name__ not in _STAYING]
    for thread in left:
        thread.join(max(0.0, deadline - time.monotonic()))
    alive = [f"thread {thread.name}" for thread in left if thread.is_alive()]
    alive += [f"process {pid}: {line}" for pid, line in (_children() - processes)]
    assert not alive, f"left running: {', '.join(alive)}"


_STAYING = ("_DummyThread", "GarbageCollectorThread")


def _children() -> set[tuple[int, str]]:
    """This process's children that still run, with their command lines."""
    found = set()
    for listed in Path("/proc/self/task").glob("*/children"):
        pids: list[int] = []
        with contextlib.suppress(OSError):  # the thread ended just now
            pids = [int(pid) for pid in listed.read_text().split()]
        for pid in pids:
            with contextlib.suppress(OSError):  # it ended just now
                line = Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode()
                if line:  # one that ended and was not waited for yet has none
                    found.add((pid, line.strip()))
    return found


@pytest.fixture(scope="session")
def chromium() -> str:
    """The path of Debian's chromium; skips where there is none, and fails in CI."""
    return _program("chromium")


@pytest.fixture(scope="session")
def espeak() -> str:
    """The path of espeak-ng; skips where there is none, and fails in CI."""
    return _program("espeak-ng")


@pytest.fixture(scope="session")
def mosquitto() -> str:
    """The path of mosquitto, an MQTT broker; skips where there is none, and fails in CI."""
    return _program("mosquitto")


def _program(name: str) -> str:
    path = shutil.which(name, path=PATH)
    if path is None:
        missing = f"{name} is not installed: sudo apt-get install {name}"
        if os.environ.get("CI") == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    return path


@pytest.fixture
def replay(capfdbinary: pytest.CaptureFixture[bytes]) -> Callable[..., tuple[int, bytes, str]]:
    """Runs ``situ replay``: its exit status, output, and what it tells."""

    def run(*arguments: str | Path) -> tuple[int, bytes, str]:
        capfdbinary.readouterr()
        status = cli.main(["replay", *map(str, arguments)])
        out, err = capfdbinary.readouterr()
        return status, out, err.decode()

    return run
