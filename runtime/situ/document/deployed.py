"""A project that is deployed: read from its texts and checked, without its folder.

The same texts give the same answer wherever they are read: on the robot that takes them, in its
replay, in a core that comes back. Media stay outside and count as there.
"""

from __future__ import annotations

from collections.abc import Mapping

from situ.document import folder
from situ.document.check import merge, structure
from situ.document.problem import Problem
from situ.document.project import Project


def read(texts: Mapping[str, str], root: str = ".") -> tuple[Project | None, list[Problem]]:
    """The project in these texts (``folder.load_texts``), None where there is none, and its
    problems, those of ``check.structure`` included. Without an error among them it can be run.
    """
    project, problems = folder.load_texts(texts, root)
    if project is None:
        return None, problems
    return project, merge(problems, structure(project, _Texts(texts, project)))


class _Texts:
    """Its documents are the texts; whatever else the project names is there."""

    def __init__(self, texts: Mapping[str, str], project: Project) -> None:
        self._texts = texts
        states = (state for one in project.flows.values() for state in one.states)
        self._parts = {state.flow for state in states}

    def read(self, file: str) -> bytes | None:
        text = self._texts.get(file)
        return None if text is None else text.encode(errors="replace")

    def inside(self, file: str) -> bool:
        return folder.stays_inside(file)

    def has(self, file: str) -> bool:
        return file in self._texts or file not in self._parts
