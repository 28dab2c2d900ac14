"""A robot whose every step is recorded, driven by hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from situ.blackboard.backlog import stamped
from situ.decide import inputs
from situ.decide.robot import Robot
from situ.decide.step import SECOND
from situ.document.folder import sources
from situ.document.ready import load_ready
from situ.engine.record import OneFile, Recorder, RingFiles, Run
from situ.rehearse import recorded
from situ.rehearse.recorded import Line

ROOT = Path(__file__).resolve().parents[2]
LAB = ROOT / "tests" / "blackboard" / "lab"
Replay = Callable[..., tuple[int, bytes, str]]
"""``situ replay`` as a person types it: its status, output and what it tells (``replay``)."""


class Recorded:
    """A robot with a recorder, driven by hand; its clock is the robot's."""

    def __init__(self, path: Path, recorder: Recorder, *, state: bytes | None = None) -> None:
        self.project = load_ready(path)
        self.robot = Robot(self.project, files=sources(self.project))
        self.recorder = recorder
        self.trace = b""
        if state is not None:
            self.robot.restore(state)
        run = Run("rrrr", self.project)
        recorder.begin(run, self.robot, 0.0, state=state)
        if state is None:
            self.step(inputs.Start(seed=7), 0)

    def step(self, given: inputs.AnyInput | None, us: int) -> None:
        events, _ = self.robot.step(given, us)
        self.recorder.step(us, given, events, 1_700_000_000 + us / SECOND)
        self.trace += b"".join(stamped(e, 1_700_000_000 + us / SECOND) + b"\n" for e in events)
        self.recorder.tend(us / SECOND)

    def at(self, us: int, given: inputs.AnyInput | None = None) -> None:
        """What falls due by then, and the input."""
        while (due := self.robot.due()) is not None and due <= us:
            self.step(None, due)
        if given is not None:
            self.step(given, us)


def recorder(file: Path, project: Path = LAB, *, goes_on: bool = False) -> Recorder:
    return Recorder(OneFile(file, goes_on=goes_on), sources(load_ready(project)))


def ring(folder: Path) -> Recorder:
    return Recorder(RingFiles(folder), sources(load_ready(LAB)))


def lines(file: Path) -> bytes:
    return b"".join(p.text + b"\n" for p in recorded.read(file) if isinstance(p, Line))
