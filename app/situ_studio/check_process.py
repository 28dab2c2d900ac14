"""Finding problems in a process of its own: projects come in, the problems of the last go out.

Started as ``python -m situ_studio.check_process`` by ``Checker``.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable

from situ.document.analysis import Cancelled
from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.answering import answer


def main() -> None:
    answer(_problems)


def _problems(project: Project, is_late: Callable[[], bool]) -> list[Problem]:
    """Raises Cancelled where another project is on its way."""
    try:
        return check(project, cancel=is_late)
    except Cancelled:
        raise
    except Exception:
        # A defect of one check ends no other: the editor hears of it through its log.
        traceback.print_exc()
        return []


if __name__ == "__main__":
    main()
