"""Where the problems of a script are shown in its matrix: at cells, situations and modules."""

from __future__ import annotations

from collections.abc import Sequence

from situ.document.problem import Problem
from situ.document.spds import Spds

OF_MODULE = "never-wins"
"""The problem of a module, wherever its first priority stands."""


class Marks:
    """What ``situ check`` tells of a script, by what it is about; equal where it tells the same."""

    def __init__(self, problems: Sequence[Problem], script: Spds | None) -> None:
        self._cells: dict[tuple[str, str], list[Problem]] = {}
        self._situations: dict[str, list[Problem]] = {}
        self._modules: dict[str, list[Problem]] = {}
        entries = {
            (situation.name, str(at)): entry.module
            for situation in (script.situations if script is not None else ())
            for at, entry in enumerate(situation.entries)
        }
        for problem in problems:
            place = problem.place
            module = entries.get((place[1], place[3])) if place[2:3] == ("entry",) else None
            if module is not None:
                found = self._cells.setdefault((place[1], module), [])
                if problem.code == OF_MODULE:
                    found = self._modules.setdefault(module, [])
            elif place[:1] == ("situation",):
                found = self._situations.setdefault(place[1], [])
            elif place[:1] == ("module",):
                found = self._modules.setdefault(place[1], [])
            else:
                continue
            found.append(problem)
        self._said = [(p.code, p.place, p.message) for p in problems]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Marks) and self._said == other._said

    def __hash__(self) -> int:
        return hash(tuple(self._said))

    def cell(self, situation: str, module: str) -> str:
        """The icon at a cell; empty where there is nothing to tell."""
        return _worst(self._cells.get((situation, module), ()))

    def situation(self, name: str) -> str:
        return _worst(self._situations.get(name, ()))

    def told_of_cell(self, situation: str, module: str) -> list[str]:
        return [p.message for p in self._cells.get((situation, module), ())]

    def told_of_situation(self, name: str) -> list[str]:
        return [p.message for p in self._situations.get(name, ())]

    def told_of_module(self, name: str) -> list[str]:
        return [p.message for p in self._modules.get(name, ())]


def _worst(problems: Sequence[Problem]) -> str:
    if not problems:
        return ""
    return "error" if any(p.severity == "error" for p in problems) else "warning"
