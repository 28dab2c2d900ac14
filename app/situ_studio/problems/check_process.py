"""Finding problems in a process of its own: projects come in, the problems of the last go out.

Started as ``python -m situ_studio.problems.check_process`` by ``Checker``.
"""

from __future__ import annotations

from collections.abc import Callable

from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.processes.answering import answer


def main() -> None:
    answer(_problems)


def _problems(project: Project, is_late: Callable[[], bool]) -> list[Problem]:
    """Raises Cancelled where another project is on its way; a defect of a check ends the process,
    and what was found before stays: the next project starts another.
    """
    return check(project, cancel=is_late)


if __name__ == "__main__":
    main()
