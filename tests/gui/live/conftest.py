"""A robot to connect to: ``situ run`` in a process of its own; and what dialogs stand over."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QEventLoop, QTimer, SignalInstance
from PySide6.QtWidgets import QApplication, QWidget

DEADLINE = 60_000
LATER = 50
"""Milliseconds."""
ANYWHERE = "tcp://127.0.0.1:0"
SITU = ("-m", "situ")


class Running:
    """One ``situ run``; ``endpoint`` is where its clients ask.

    program: what is run in place of ``situ``.
    """

    def __init__(
        self,
        project: Path,
        state: Path,
        endpoint: str = ANYWHERE,
        program: Sequence[str] = SITU,
    ) -> None:
        self.project, self.state = project, state
        command = [sys.executable, *program, "run", str(project), "--endpoint", endpoint]
        command.append("--no-restart")
        command += [
            "--notify",
            "tcp://127.0.0.1:0",
            "--http",
            "127.0.0.1:0",
            "--state",
            str(state),
            "--json",
        ]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout is not None
        self.endpoint: str = json.loads(self.process.stdout.readline())["requests"]

    def kill(self) -> None:
        self.process.kill()
        self._reap()

    def stop(self) -> None:
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        self._reap()

    def _reap(self) -> None:
        self.process.wait(10)
        assert self.process.stdout is not None
        self.process.stdout.close()


@pytest.fixture
def robot(tmp_path: Path) -> Iterator[Callable[..., Running]]:
    """``robot(project, endpoint=…)``: a running robot with that project. state: its folder."""
    every: list[Running] = []

    def start(
        project: Path, endpoint: str = ANYWHERE, state: str = "state", program: Sequence[str] = SITU
    ) -> Running:
        every.append(Running(project, tmp_path / state, endpoint, program))
        return every[-1]

    yield start
    for one in every:
        if one.process.returncode is None:
            one.stop()


@pytest.fixture
def over(qt: QApplication) -> Iterator[QWidget]:
    """What dialogs stand over."""
    made = QWidget()
    yield made
    made.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def until() -> Callable[[SignalInstance, Callable[[], bool]], None]:
    """``until(signal, true)``: waits, judging at each coming of the signal and a little later, for
    what it sets off may be done when no other one comes; fails at a deadline.
    """

    def wait(told: SignalInstance, true: Callable[[], bool]) -> None:
        if true():
            return
        loop = QEventLoop()
        over: list[bool] = []
        deadline, later = QTimer(), QTimer()
        deadline.setSingleShot(True)

        def late() -> None:
            over.append(True)
            loop.quit()

        deadline.timeout.connect(late)

        def judge(*_: object) -> None:
            if true():
                loop.quit()

        told.connect(judge)
        later.timeout.connect(judge)
        deadline.start(DEADLINE)
        later.start(LATER)
        loop.exec()
        deadline.stop()
        later.stop()
        told.disconnect(judge)
        assert not over, f"never came true after {told}"

    return wait
