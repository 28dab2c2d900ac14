"""What the searches of ``situ.document.analysis`` share: the project, its conditions as sets
of values, and what they have found so far.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from situ.document.analysis_data import Data, events
from situ.document.aside import NOTHING, Aside
from situ.document.condition import Condition
from situ.document.finding import Finding, Place
from situ.document.mend import change, of
from situ.document.place import Path, follow
from situ.document.problem import Change, Mend
from situ.document.project import Project
from situ.document.satisfy import Moment, Node

ALLOWANCE = 400_000
"""Looks at a literal, for all questions of one analysis: about half a second."""

LONGEST = 400
"""Characters of a message: it may quote what a designer wrote."""

NOWHERE: Path = ("",)
"""A path that leads to nothing."""


class Cancelled(Exception):
    """The analysis was cancelled by its caller."""


class Search:
    """One analysis of a project.

    toml: (code, message, table, key, value) of what is wrong in ``situ.toml``.
    """

    def __init__(self, project: Project, cancel: Callable[[], bool] | None = None) -> None:
        self.project = project
        self.data = Data(project)
        self.moment = Moment(_conditions(project), self.data.domain)
        self.found: dict[str, list[Finding]] = {}
        self.toml: list[tuple[str, str, str, str, str]] = []
        self._cancel = cancel
        self._left = ALLOWANCE
        self._undecided: set[tuple[str, Place]] = set()

    @property
    def whole(self) -> bool:
        """Whether all of a project is known: a single file says nothing of the others."""
        return self.project.toml is not None

    def go_on(self) -> None:
        """To be called now and then. Raises Cancelled."""
        if self._cancel is not None and self._cancel():
            raise Cancelled

    def possible(self, *nodes: Node) -> bool | None:
        """``Moment.possible``, out of one allowance for all questions."""
        if self._left <= 0:
            return None
        found = self.moment.possible(*nodes, budget=min(self._left, 20_000))
        self._left -= self.moment.spent
        return found

    def warn(
        self,
        file: str,
        code: str,
        message: str,
        aside: Aside = NOTHING,
        place: Place = (),
        mend: Mend | None = None,
    ) -> None:
        line = " ".join(message.split())
        line = line if len(line) <= LONGEST else line[: LONGEST - 1] + "…"
        finding = Finding(code, line, aside, place, "warning", mend)
        self.found.setdefault(file, []).append(finding)

    def undecided(self, file: str, what: str, aside: Aside, place: Place) -> None:
        """Tells, once for each place, that a search did not come to an end."""
        if (file, place) not in self._undecided:
            self._undecided.add((file, place))
            said = (
                f"It is not known {what}: finding out would have taken too long; make the "
                "conditions simpler, or try it out with situ simulate"
            )
            self.warn(file, "undecided", said, aside, place)

    # -- mends -------------------------------------------------------------------

    def path(self, file: str, place: Place) -> Path:
        """The path to something that a search has found; NOWHERE where two have one name, and
        the place means the other.
        """
        way = follow(of(self.project, file), place)
        return way[0] if way is not None else NOWHERE

    def mend(self, file: str, words: str, *changes: Change, safe: bool = False) -> Mend | None:
        """None where a change is NOWHERE."""
        if any(one.path[:1] == NOWHERE for one in changes):
            return None
        return Mend(file, words, changes, safe)

    def put(self, file: str, place: Place, field: str, value: Any) -> Change:
        """A change of one field of what stands at a place."""
        way = follow(of(self.project, file), place)
        if way is None:
            return Change(NOWHERE)
        return change(way[0], way[1][-1], field, value)


def _conditions(project: Project) -> Iterator[Condition]:
    for application in project.flows.values():
        for event, _ in events(application):
            if event.when is not None:
                yield event.when
    for situation in project.spds.situations if project.spds is not None else ():
        for condition in (situation.condition, situation.until):
            if condition is not None:
                yield condition
