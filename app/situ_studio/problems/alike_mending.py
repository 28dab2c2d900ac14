"""How all problems of one kind are mended, found without holding up the window."""

from __future__ import annotations

import logging
from collections.abc import Sequence

from msgspec import Struct
from PySide6.QtCore import QObject, Signal

from situ.document.check import check
from situ.document.mend_alike import alike, planned
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.problems.checking import LARGE, size
from situ_studio.processes.worker import Worker, module

COMMAND = module("situ_studio.problems.mend_process")

_log = logging.getLogger("situ.studio")


class Wanted(Struct, frozen=True):
    """All problems of one kind in a project."""

    project: Project
    code: str


class Plan(Struct, frozen=True):
    """What is mended, round after round, for ``mend_alike.carried_out``; how many problems go by
    it, and how many that have a mend are left.
    """

    rounds: tuple[tuple[Problem, ...], ...]
    gone: int
    left: int


def plan(wanted: Wanted) -> Plan:
    """As many checks as there are rounds, and one."""
    before = check(wanted.project)
    rounds, after = planned(wanted.project, before, wanted.code)
    counts = [sum(one.code == wanted.code for one in found) for found in (before, after)]
    left = len(alike(after, wanted.code))
    return Plan(tuple(map(tuple, rounds)), counts[0] - counts[1], left)


class AlikeMending(QObject):
    """``planned`` tells what was asked for and its plan: before ``ask`` returns for a small
    project, later, from the loop, for a large one, for which another process plans.
    """

    planned = Signal(object, object)
    began = Signal()
    """Another process is at it."""
    ended = Signal()
    """None is any more."""
    gone = Signal()
    """It has ended early, and there is no plan."""

    def __init__(
        self, parent: QObject, large: int = LARGE, command: Sequence[str] = COMMAND
    ) -> None:
        super().__init__(parent)
        self._large = large
        self._wanted: Wanted | None = None
        self._worker = Worker(command, self)
        self._worker.answered.connect(self._on_answer)
        self._worker.said.connect(lambda said: _log.error("mending failed: %s", said))
        self._worker.gone.connect(self._on_gone)

    def ask(self, wanted: Wanted) -> None:
        """In place of what was asked before."""
        self.cancel()
        if size(wanted.project) <= self._large:
            self.planned.emit(wanted, plan(wanted))
            return
        self._wanted = wanted
        self.began.emit()
        self._worker.ask(wanted)

    def cancel(self) -> None:
        """Nothing is planned any more, and nobody is told."""
        # It is rare that many are mended at once: the process does not wait for another.
        self._worker.end()
        self._end()

    def _end(self) -> None:
        if self._wanted is not None:
            self._wanted = None
            self.ended.emit()

    def _on_answer(self, found: Plan) -> None:
        wanted = self._wanted
        self.cancel()
        if wanted is not None:
            self.planned.emit(wanted, found)

    def _on_gone(self) -> None:
        self._end()
        self.gone.emit()
