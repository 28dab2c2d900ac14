"""Finding a project's problems without holding up the window."""

from __future__ import annotations

import logging
import threading

from PySide6.QtCore import QObject, Qt, Signal

from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project

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

    def _start(self) -> None:
        self._running = True
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
