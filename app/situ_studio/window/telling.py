"""What whoever does not see the window is told of what happens in it: steps, and problems."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document.problem import Problem
from situ_studio.problems import problem_rows
from situ_studio.wording.language import count, said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class TellingSide(QObject):
    """Each step by its name when it is done, taken back or done again; each new problem."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        tell, session = window.status.announcements.tell, window.session
        self._known: tuple[Path, frozenset[tuple[str, ...]]] | None = None
        if session.project is not None:
            # Another window had it before.
            self._known = session.root, frozenset(map(_key, session.problems))
        session.stepped.connect(tell)
        session.stepped_back.connect(self._on_stepped_back)
        session.problems_changed.connect(self._on_problems)

    def _on_stepped_back(self, name: str) -> None:
        self._window.status.announcements.tell(self.tr("Taken back: {0}").format(name))

    def _on_problems(self) -> None:
        window, session = self._window, self._window.session
        problems, known = session.problems, self._known
        now = frozenset(map(_key, problems))
        self._known = session.root, now
        tell = window.status.announcements.tell
        if known is None or known[0] != session.root:
            # The project has just been opened, and none of them is new.
            if problems:
                tell(self._counted(problems))
            return
        before = known[1]
        new = [problem for problem in problems if _key(problem) not in before]
        if new:
            # What can not work is told before what is probably not meant.
            problem = min(new, key=lambda one: one.severity != "error")
            where = problem_rows.where(session, problem, window.current_file)
            kind = self.tr("Error") if problem.severity == "error" else self.tr("Warning")
            told = f"{kind}, {where}: {said(problem.message)}"
            if len(new) > 1:
                told = self.tr("{0}, and {1} more").format(told.rstrip("."), len(new) - 1)
            tell(told)
        elif before and not problems:
            tell(self.tr("No problems."))
        elif len(now) < len(before):
            tell(self.tr("Still {0}").format(self._counted(problems)))

    def _counted(self, problems: Sequence[Problem]) -> str:
        errors = sum(problem.severity == "error" for problem in problems)
        warnings = len(problems) - errors
        words = [
            count(errors, self.tr("{0} error"), self.tr("{0} errors")) if errors else "",
            count(warnings, self.tr("{0} warning"), self.tr("{0} warnings")) if warnings else "",
        ]
        return ", ".join(word for word in words if word)


def _key(problem: Problem) -> tuple[str, ...]:
    """Its message may have the name of a state, which does not make it another problem."""
    return (problem.file, problem.code, *problem.place)
