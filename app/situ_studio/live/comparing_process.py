"""Two long runs put beside one another, or a recorded project read, in a process of its own.

Started as ``python -m situ_studio.live.comparing_process`` by ``Comparing`` and
``RecordedProjects``.
"""

from __future__ import annotations

from situ.document.project import Project
from situ.rehearse.comparing import Alike, alike
from situ.rehearse.deeds import Deeds
from situ_studio.live.comparing_projects import project_in
from situ_studio.processes.answering import answer


def answered(asked: tuple[Deeds, Deeds] | dict[str, str]) -> Alike | Project | None:
    """Of two runs where they part, of a project's files the project."""
    return project_in(asked) if isinstance(asked, dict) else alike(*asked)


def main() -> None:
    answer(lambda asked, _: answered(asked))


if __name__ == "__main__":
    main()
