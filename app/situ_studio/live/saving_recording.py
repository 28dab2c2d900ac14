"""What a window has seen of a robot, written into a file (MCAP) while the window stays in use."""

from __future__ import annotations

import os
import time
from bisect import bisect_right
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer, Signal

from situ_studio.live.log import TraceLog
from situ_studio.live.moment import TraceFields
from situ_studio.live.recordings import SLICE
from situ_studio.processes.working import OneWork

if TYPE_CHECKING:
    from situ.rehearse.mcap_file import McapFile
    from situ.rehearse.recorded import Heading
    from situ_studio.window.main_window import MainWindow

PIECE = 100
"""Events between two looks at the clock."""
BEGUN = ".part"
"""What the name of a file ends with that is not whole yet."""


class SavingRecording(QObject):
    """One at a time: the trace as it was when that was asked for, and the robot's documents, as
    ``situ trace --record`` writes them. Of several versions that ran, those of the first; without
    inputs, so that it can be looked at and not be decided again.
    """

    ended = Signal()
    """It is saved, or will not be."""

    def __init__(self, window: MainWindow, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._work = OneWork(self._give_up)
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._go_on)
        self._file: McapFile | None = None
        self._path = Path()
        window.closed.connect(self.cancel)

    @property
    def can_save(self) -> bool:
        """Whether what is looked at is a robot, if only one that was lost."""
        robot = self._window.robot
        return robot.connected and robot.follower.viewing.log is robot.link.log

    def ask(self) -> None:
        """Asks where to, and begins."""
        project = self._window.robot.link.state.project or "robot"
        path = self._window.dialogs.recording_to(f"{project}.mcap")
        if path is not None:
            self.start(path)

    def start(self, path: Path) -> None:
        """Begins, in place of what was begun before; ``path`` is there once it is whole."""
        # The writer, and what reads documents as a project: nobody needs it to draw.
        from situ.rehearse.mcap_file import McapFile

        self.cancel()
        log = self._window.robot.link.log
        self._path, self._lanes = path, log.lanes
        self._next, self._end, self._gone = 0, len(log), log.gone
        heading, documents = self._headed()
        try:
            flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0)
            # Private values are in it.
            self._file = McapFile(os.open(self._begun, flags, 0o600), heading, documents)
        except OSError as error:
            self._refuse(error)
            return
        self._work.begin(self._window.status.work, self.tr("Writing {0}").format(path.name))
        self._slices.start()

    def cancel(self, *_: object) -> None:
        """Nothing of what was begun is kept."""
        self._give_up()
        self._work.end()
        self.ended.emit()

    @property
    def _begun(self) -> Path:
        return self._path.with_name(self._path.name + BEGUN)

    def _headed(self) -> tuple[Heading, dict[str, str]]:
        """What ran first, as far as the robot told it."""
        from situ.rehearse.mcap_file import heading

        link = self._window.robot.link
        seq, documents = link.known[0] if link.known else (0, {})
        head = heading(link.state.project, documents, link.situ or "", masked=link.looks_only)
        turns = link.log.lanes.deployed
        ran = bisect_right(turns, seq, key=lambda one: one.seq)
        deployed = turns[ran - 1].version if ran else 0
        return replace(head, deployed=deployed), {} if head.masked else documents

    def _go_on(self) -> None:
        log = self._window.robot.link.log
        if log.lanes is not self._lanes:
            self.cancel()
            self._window.dialogs.tell(self.tr("The robot has begun anew: nothing was saved."))
            return
        end = time.perf_counter() + SLICE
        try:
            while not self._write(log):
                if time.perf_counter() >= end:
                    self._work.tell(self._next / self._end)
                    return
            self._finish()
        except OSError as error:
            self.cancel()
            self._refuse(error)

    def _write(self, log: TraceLog) -> bool:
        """Some events; whether these were the last."""
        # The oldest may be forgotten meanwhile, and all others go down.
        gone = log.gone - self._gone
        first, last = max(self._next - gone, 0), max(self._end - gone, 0)
        for event in log[first : min(first + PIECE, last)]:
            self._add(event)
        self._next = first + PIECE + gone
        return first + PIECE >= last

    def _add(self, event: TraceFields) -> None:
        from situ.rehearse.recorded import TRACE

        assert self._file is not None
        moment, written = float(event["t"]), event.get("time")
        if isinstance(written, str):
            with suppress(ValueError):
                moment = datetime.fromisoformat(written).timestamp()
        self._file.add(TRACE, moment, msgspec.json.encode(event))

    def _finish(self) -> None:
        assert self._file is not None
        self._slices.stop()
        self._file.finish()
        self._file = None
        os.replace(self._begun, self._path)
        self._work.end()
        told = self.tr("{0} is saved: {1} events.")
        self._window.say(told.format(self._path.name, f"{self._end:,}"))
        self.ended.emit()

    def _give_up(self) -> None:
        self._slices.stop()
        if self._file is not None:
            self._file.give_up()
            self._file = None
            with suppress(OSError):
                self._begun.unlink()

    def _refuse(self, error: OSError) -> None:
        self._window.dialogs.tell(f"{self._path}: {error.strerror or error}")
