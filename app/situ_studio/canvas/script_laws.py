"""What may not be drawn: a gesture that would break a law of scripts is refused, with a sentence.

The laws are those of ``situ check`` (formats.md, *SPDS*), judged of the script by itself. What is
wrong already, in a file that somebody wrote by hand, hinders nothing.
"""

from __future__ import annotations

from collections import Counter

from situ.document.check_script import check_script
from situ.document.finding import Findings
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.spds import Spds
from situ_studio.wording.language import said, tr

_ELSEWHERE = ("undeclared-module", "contradiction", "no-situation")
"""What depends on other files of the project, and what every script begins with."""


class Laws:
    """Judges edits of one script after the other; each value is judged once."""

    def __init__(self) -> None:
        self._judged: tuple[Spds, Counter[tuple[str, str]]] | None = None

    def breach(self, before: Spds, after: Spds) -> str:
        """Why an edit is not done; "" where it may be."""
        if self._judged is None or self._judged[0] is not before:
            self._judged = before, Counter(map(_key, _errors(before)))
        errors = _errors(after)
        new = Counter(map(_key, errors)) - self._judged[1]
        if new:
            return _sentence(next(one for one in errors if _key(one) in new), after)
        self._judged = after, Counter(map(_key, errors))
        return ""


class _NoFiles:
    """No file at all: problems get no lines."""

    def read(self, file: str) -> bytes | None:
        return None

    def inside(self, file: str) -> bool:
        return True

    def has(self, file: str) -> bool:
        return True


def _errors(script: Spds) -> list[Problem]:
    found = Findings("", "")
    check_script(found, script, Project(root="", name="", spds=script))
    every = found.problems(_NoFiles())
    return [p for p in every if p.severity == "error" and p.code not in _ELSEWHERE]


def _key(problem: Problem) -> tuple[str, str]:
    # Not by place: what stands further on moves when something goes.
    return problem.code, problem.message


def _sentence(problem: Problem, after: Spds) -> str:
    name = problem.place[1] if len(problem.place) > 1 else ""
    match problem.code:
        case "last-situation":
            told = tr("{0} would be the last, and the last must always hold: first add one below")
        case "circular-extends":
            told = tr("The situations would take over from each other in a circle")
        case "dwell-with-until":
            told = tr("{0} can either stay so long at least, or have an until or an end: not both")
        case _:
            return said(problem.message)
    return told.format(name)
