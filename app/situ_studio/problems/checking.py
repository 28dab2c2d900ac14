"""Finding a project's problems without holding up the window."""

from __future__ import annotations

import logging
from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal

from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.processes.worker import Worker, module
from situ_studio.processes.working import Work, WorkStrip

_log = logging.getLogger("situ.studio")

LARGE = 60
"""States and situations above which a check leaves the window's process: about 8 ms of work."""

COMMAND = module("situ_studio.problems.check_process")


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
        self._wanted: Project | None = None
        self._worker = Worker(command, self)
        self._worker.answered.connect(self._on_answer)
        self._worker.said.connect(lambda said: _log.error("a check failed: %s", said))
        self._worker.gone.connect(self._on_gone)

    def ask(self, project: Project) -> None:
        """Has ``project`` checked."""
        if size(project) <= self._large:
            self.cancel()
            self.found.emit(project, check(project))
            return
        waiting, self._wanted = self._wanted is not None, project
        self._worker.ask(project)
        if not waiting:
            self.began.emit()

    def cancel(self) -> None:
        """Nobody is told of the check that goes on."""
        if self._wanted is not None:
            self._worker.drop()
            self._give_up()

    def _give_up(self) -> None:
        self._wanted = None
        self.ended.emit()

    def _on_answer(self, problems: list[Problem]) -> None:
        project = self._wanted
        if project is not None:
            self._give_up()
            self.found.emit(project, problems)

    def _on_gone(self) -> None:
        """The next question starts another."""
        _log.error("the process that looks for problems has ended: problems stay as they were")
        self.cancel()


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
