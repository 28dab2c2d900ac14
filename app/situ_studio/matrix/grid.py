"""What the matrix of a script shows, without Qt: priorities, ties, and who holds what.

The laws are not ours: what a situation takes over is ``Spds.priorities``'s, ties are those that
``situ check`` tells, and who holds what when all ask is the decide core's own rule.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from msgspec import Struct

from situ.decide.all_ask import Holding, Requests, who_holds
from situ.document.analysis_modules import tied
from situ.document.check_application import used_resources
from situ.document.project import Project
from situ.document.spds import Situation, Spds

Asking = Mapping[str, tuple[str, ...]]
"""Module to the resources that it may ask for."""


class Cell(Struct, frozen=True):
    """A module in a situation.

    priority: the one that counts, None for none. own: the situation says so itself, ``none``
    included; taken: what it takes over, or would without its own, and source from which one.
    rivals: modules of the same priority that can ask for the same.
    """

    priority: int | None = None
    own: bool = False
    taken: int | None = None
    source: str = ""
    rivals: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """As it is shown, typed and copied."""
        if self.priority is not None:
            return str(self.priority)
        return "none" if self.own else ""


EMPTY = Cell()


class Asked:
    """What all modules ask for, as it is and as sets; the same object while nothing changes."""

    def __init__(self, by_module: Asking) -> None:
        self.by_module = by_module
        self.requests = Requests(by_module)
        self.sets = {module: frozenset(several) for module, several in by_module.items()}


class Line:
    """One situation: its cells and holders, worked out when they are first looked at.

    chain: the situation and those from which it takes over, in order. counts: what its modules'
    priorities are, taken: what they would be without its own.
    """

    def __init__(
        self,
        chain: tuple[Situation, ...],
        counts: Mapping[str, int],
        taken: Mapping[str, int],
        asked: Asked,
    ) -> None:
        self.situation = chain[0]
        self.chain = chain
        self.asked = asked
        self._counts, self._taken = counts, taken

    @cached_property
    def cells(self) -> dict[str, Cell]:
        """By module; those that are not in it are empty."""
        counts, taken = self._counts, self._taken
        rivals: dict[str, list[str]] = {}
        for one, other in tied(counts, self.asked.sets):
            rivals.setdefault(one, []).append(other)
            rivals.setdefault(other, []).append(one)
        own = {entry.module for entry in self.situation.entries}
        sources: dict[str, str] = {}
        for above in self.chain[:0:-1]:
            sources.update((entry.module, above.name) for entry in above.entries)
        return {
            module: Cell(
                priority=counts.get(module),
                own=module in own,
                taken=taken.get(module),
                source=sources.get(module, "") if module in taken else "",
                rivals=tuple(rivals.get(module, ())),
            )
            for module in dict.fromkeys((*counts, *own))
        }

    @cached_property
    def holdings(self) -> dict[str, Holding]:
        """Who holds each resource when all ask."""
        return who_holds(self.asked.requests, self._counts)

    def cell(self, module: str) -> Cell:
        return self.cells.get(module, EMPTY)


class Grid:
    """The rows and columns of a script; a new one takes over the lines that did not change."""

    def __init__(self, script: Spds, asking: Asking, before: Grid | None = None) -> None:
        self.script = script
        same = before is not None and before.asked.by_module == asking
        self.asked: Asked = before.asked if before is not None and same else Asked(asking)
        self.modules = tuple(asking)
        self.resources = self.asked.requests.resources
        named: dict[str, Situation] = {}
        for situation in script.situations:
            named.setdefault(situation.name, situation)
        kept = {one.situation.name: one for one in before.lines} if before is not None else {}
        self._counts = {
            id(situation): priorities
            for situation, priorities in zip(
                script.situations, script.every_priorities(), strict=True
            )
        }
        self.lines: tuple[Line, ...] = tuple(self._line(s, named, kept) for s in script.situations)

    def _line(
        self, situation: Situation, named: Mapping[str, Situation], kept: Mapping[str, Line]
    ) -> Line:
        chain = [situation]
        while (above := named.get(chain[-1].extends or "")) is not None:
            if any(above is one for one in chain):
                break
            chain.append(above)
        old = kept.get(situation.name)
        if (
            old is not None
            and old.asked is self.asked
            and len(old.chain) == len(chain)
            and all(one is other for one, other in zip(old.chain, chain, strict=True))
        ):
            return old
        taken = self._counts[id(chain[1])] if len(chain) > 1 else {}
        return Line(tuple(chain), self._counts[id(situation)], taken, self.asked)

    def row(self, name: str) -> int:
        """The row of a situation; -1 where there is none of that name."""
        return next((at for at, one in enumerate(self.lines) if one.situation.name == name), -1)


def asking(project: Project | None, script: Spds) -> dict[str, tuple[str, ...]]:
    """The columns of a script, each with what it may ask for: the modules that it declares, those
    that the module information declares with resources, and whatever has a priority.

    An application asks for what its states use.
    """
    found = {module.name: module.resources for module in script.modules}
    known = project.modules.modules if project is not None and project.modules is not None else ()
    elsewhere = {module.name: module.resources for module in known}
    found |= {m: r for m, r in elsewhere.items() if r and m not in found}
    for situation in script.situations:
        for entry in situation.entries:
            found.setdefault(entry.module, elsewhere.get(entry.module, ()))
    for application in project.applications.values() if project is not None else ():
        if project is not None and application.name in found:
            used = used_resources(project, application)
            declared = found[application.name]
            found[application.name] = tuple(r for r in declared if r in used) or declared
    return found
