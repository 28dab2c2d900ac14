"""Finding a project's problems without holding up the window."""

from __future__ import annotations

import logging
import threading

from PySide6.QtCore import QObject, Qt, Signal

from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.working import Work, WorkStrip

_log = logging.getLogger("situ.studio")

LARGE = 200
"""States and situations above which a check leaves the GUI's thread."""


def size(project: Project) -> int:
    """States and situations of a project."""
    every = (*project.applications.values(), *project.parts.values())
    states = sum(len(application.states) for application in every)
    return states + (len(project.spds.situations) if project.spds is not None else 0)


class Checker(QObject):
    """Checks what it was asked for last, one check at a time.

    ``found`` tells the project and its problems: before ``ask`` returns for a small project,
    later, from the loop, for a large one. What was asked for in between is dropped.
    """

    found = Signal(object, list)
    began = Signal()
    """A check goes on beside the window."""
    ended = Signal()
    """None does any more."""
    _done = Signal(object, list)

    def __init__(self, parent: QObject | None = None, large: int = LARGE) -> None:
        super().__init__(parent)
        self._large = large
        self._wanted: Project | None = None
        self._running = False
        self._done.connect(self._on_done, Qt.ConnectionType.QueuedConnection)

    def ask(self, project: Project) -> None:
        """Has ``project`` checked."""
        if size(project) <= self._large:
            self._wanted = None
            self.found.emit(project, check(project))
            return
        self._wanted = project
        if not self._running:
            self._start()

    def cancel(self) -> None:
        """Nobody is told of the check that goes on; it ends by itself."""
        self._wanted = None

    def _start(self) -> None:
        self._running = True
        self.began.emit()
        # Documents are values: what another thread reads does not change under it.
        threading.Thread(target=self._work, args=(self._wanted,), daemon=True).start()

    def _work(self, project: Project) -> None:
        problems: list[Problem] = []
        try:
            problems = check(project)
        except Exception:
            # A defect of one check must not end this thread unheard: ``_running`` would stay
            # true, and no further check would ever begin.
            _log.exception("a check failed")
        # The window may have been closed meanwhile: then there is nobody to tell.
        try:
            self._done.emit(project, problems)
        except RuntimeError:
            return

    def _on_done(self, project: Project, problems: list[Problem]) -> None:
        self._running = False
        if self._wanted is project:
            self._wanted = None
            self.found.emit(project, problems)
        elif self._wanted is not None:
            self._start()
            return
        self.ended.emit()


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
