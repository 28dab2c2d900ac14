"""All problems of one kind mended at once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from situ.document.check import check
from situ.document.mend import every
from situ.document.problem import Problem
from situ.document.project import Project

ROUNDS = 20
"""How often is looked again: one mend can take the place of another, which then finds a new one."""


def alike(problems: Iterable[Problem], code: str) -> list[Problem]:
    """Those of one kind that have a mend."""
    return [one for one in problems if one.code == code and one.mend is not None]


def mend_alike(
    project: Project, problems: Sequence[Problem], code: str
) -> tuple[Project, list[Problem]]:
    """The project without the problems of one kind that have a mend, and what ``check`` then finds.

    problems: what ``check`` found in ``project``. Both are given back as they were where mending
    would take none away, or bring another error.
    """
    rounds, left = planned(project, problems, code)
    return carried_out(project, rounds), left


def planned(
    project: Project, problems: Sequence[Problem], code: str
) -> tuple[list[list[Problem]], list[Problem]]:
    """In which rounds ``mend_alike`` mends what, and what ``check`` finds after them.

    Looking for them takes as many checks as there are rounds; carrying them out takes none.
    """
    found, rounds = list(problems), []
    for _ in range(ROUNDS):
        wanted = alike(found, code)
        after, done = every(project, wanted)
        if not done:
            break
        now = check(after)
        fewer = len(_of(now, code)) < len(_of(found, code))
        if not fewer or _others(now, code) - _others(found, code):
            break
        rounds.append(wanted)
        project, found = after, now
    return rounds, found


def carried_out(project: Project, rounds: Iterable[Iterable[Problem]]) -> Project:
    """The very project for which these rounds were planned, after them."""
    for wanted in rounds:
        project, _ = every(project, wanted)
    return project


def _of(problems: Iterable[Problem], code: str) -> list[Problem]:
    return [one for one in problems if one.code == code]


def _others(problems: Iterable[Problem], code: str) -> set[tuple[str, ...]]:
    """The errors of other kinds, by what stays the same when lines move."""
    return {
        (p.file, p.code, *p.place) for p in problems if p.severity == "error" and p.code != code
    }
