"""Where the problems of an application are shown in its drawing: at cards and at their exits."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Literal

from msgspec import Struct

from situ.document.problem import Problem
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.wording.language import said

Sign = Literal["", "warning", "error"]

MOST = 4
"""Of so many problems a tip tells the words."""


class Mark(Struct, frozen=True):
    """The worst that there is at a card or exit, and what is told of it there."""

    sign: Sign = ""
    messages: tuple[str, ...] = ()

    def told(self) -> list[str]:
        """A line each, in the user's language."""
        more = len(self.messages) - MOST
        return [said(one) for one in self.messages[:MOST]] + ["…"] * (more > 0)


NONE = Mark()
Marks = Mapping[Place, Mark]


def marks_of(problems: Iterable[Problem]) -> Marks:
    """By place: a card has the sign of the worst in it, and the words of what no exit tells."""
    marks: dict[Place, Mark] = {}
    for problem in sorted(problems, key=lambda one: one.severity):
        root = places.root(problem.place)
        exit = _exit(problem.place[len(root) :])
        messages = () if exit else (problem.message,)
        marks[root] = _with(marks.get(root, NONE), problem, messages)
        if exit:
            place = (*root, *exit)
            marks[place] = _with(marks.get(place, NONE), problem, (problem.message,))
    return marks


def _with(mark: Mark, problem: Problem, messages: tuple[str, ...]) -> Mark:
    return Mark(mark.sign or problem.severity, (*mark.messages, *messages))


def _exit(inner: Place) -> Place:
    """The exit that a place in a state is about; () for none."""
    if inner[:1] == ("timeout",):
        return inner[:1]
    return inner[:2] if inner[:1] == ("event",) and len(inner) > 1 else ()


def changed(before: Marks, now: Marks) -> frozenset[Place]:
    """The cards of which something is marked in another way."""
    if before == now:
        return frozenset()
    places_ = {*before, *now}
    return frozenset(
        places.root(one) for one in places_ if before.get(one, NONE) != now.get(one, NONE)
    )
