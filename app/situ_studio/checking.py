"""Finding a project's problems without holding up the window."""

from __future__ import annotations

import logging
import pickle
import sys
from collections.abc import Iterator, Sequence

from PySide6.QtCore import QObject, QProcess, QTimer, Signal

from situ.document.check import check
from situ.document.project import Project
from situ_studio.sending import Frames, Sending
from situ_studio.working import Work, WorkStrip

_log = logging.getLogger("situ.studio")

LARGE = 60
"""States and situations above which a check leaves the window's process: about 8 ms of work."""

COMMAND = (sys.executable, "-m", "situ_studio.check_process")


def size(project: Project) -> int:
    """States and situations of a project."""
    every = (*project.applications.values(), *project.parts.values())
    states = sum(len(application.states) for application in every)
    return states + (len(project.spds.situations) if project.spds is not None else 0)


class Checker(QObject):
    """Checks what it was asked for last, one check at a time.

    ``found`` tells the project and its problems: before ``ask`` returns for a small project, later,
    from the loop, for a large one, which another process checks: Python's lock would give a thread
    beside the window half of its time. What was asked for in between is dropped.
    """

    found = Signal(object, list)
    began = Signal()
    """A check goes on beside the window."""
    ended = Signal()
    """None does any more."""

    def __init__(
        self,
        parent: QObject | None = None,
        large: int = LARGE,
        command: Sequence[str] = COMMAND,
    ) -> None:
        super().__init__(parent)
        self._large = large
        self._command = tuple(command)
        self._wanted: Project | None = None
        self._number = 0
        self._sending = Sending()
        self._frames: Iterator[bytes] = iter(())
        self._came = Frames()
        # Not children: a process that is destroyed while it runs would end on its own time.
        self._processes: list[QProcess] = []
        processes = self._processes
        self.destroyed.connect(lambda: _end(*processes))
        self._turn = QTimer(self)
        self._turn.setInterval(0)
        self._turn.timeout.connect(self._send)

    def ask(self, project: Project) -> None:
        """Has ``project`` checked."""
        if size(project) <= self._large:
            self.cancel()
            self.found.emit(project, check(project))
            return
        waiting, self._wanted = self._wanted is not None, project
        self._number += 1
        if not self._processes:
            self._start()
        self._frames = self._sending.pack(project, self._number)
        self._turn.start()
        if not waiting:
            self.began.emit()

    def cancel(self) -> None:
        """Nobody is told of the check that goes on."""
        if self._wanted is not None:
            self._give_up()

    def _give_up(self) -> None:
        self._wanted = None
        self._turn.stop()
        self.ended.emit()

    def _start(self) -> None:
        self._sending, self._came = Sending(), Frames()
        process = QProcess()
        self._processes.append(process)
        process.readyReadStandardOutput.connect(self._read)
        process.readyReadStandardError.connect(self._log_error)
        process.finished.connect(self._on_gone)
        process.errorOccurred.connect(self._on_error)
        process.start(self._command[0], self._command[1:])

    def _send(self) -> None:
        """One frame; the window has its turn before the next."""
        message = next(self._frames, None)
        if message is None or not self._processes:
            self._turn.stop()
        else:
            self._processes[0].write(message)

    def _read(self) -> None:
        for message in self._came.take(bytes(self._processes[0].readAllStandardOutput().data())):
            number, problems = pickle.loads(message)
            project = self._wanted
            if number == self._number and project is not None:
                self._give_up()
                self.found.emit(project, problems)

    def _log_error(self) -> None:
        said = bytes(self._processes[0].readAllStandardError().data())
        _log.error("a check failed: %s", said.decode(errors="replace").strip())

    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self._on_gone()

    def _on_gone(self) -> None:
        """The process has ended though nobody asked it to; the next question starts another."""
        _log.error("the process that looks for problems has ended: problems stay as they were")
        process = self._processes.pop()
        process.deleteLater()
        self.cancel()


def _end(*processes: QProcess) -> None:
    for process in processes:
        process.kill()
        process.waitForFinished(1000)


class CheckWork(QObject):
    """Shows in a window's strip that a check goes on; cancelled, the problems stay as they were."""

    def __init__(self, checker: Checker, strip: WorkStrip) -> None:
        super().__init__(strip)
        self._checker, self._strip = checker, strip
        self._work: Work | None = None
        checker.began.connect(self._on_began)
        checker.ended.connect(self._on_ended)

    def _on_began(self) -> None:
        if self._work is None:
            self._work = self._strip.begin(self.tr("Looking for problems"), self._cancelled)

    def _cancelled(self) -> None:
        self._work = None
        self._checker.cancel()

    def _on_ended(self) -> None:
        if self._work is not None:
            self._work.end()
            self._work = None
