"""Situated priority description script as a value (seed 000, 6.2; formats.md, *SPDS*)."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from situ.document.aside import NOTHING, Aside
from situ.document.condition import Condition

DataType = Literal["boolean", "number", "text", "list", "object"]
DATA_TYPES: tuple[DataType, ...] = ("boolean", "number", "text", "list", "object")


class Observed(Struct, frozen=True, gc=False):
    """``<observe><data tag type unit/></observe>``: a tag that situations look at."""

    tag: str
    type: DataType | None = None
    unit: str | None = None
    aside: Aside = NOTHING


class Declaration(Struct, frozen=True, gc=False):
    """``<modules><module name resources/></modules>``: resources the module may ask for."""

    name: str
    resources: tuple[str, ...] = ()
    aside: Aside = NOTHING


class Entry(Struct, frozen=True, gc=False):
    """A module's priority in a situation; None is ``priority="none"``: taken away."""

    module: str
    priority: int | None
    aside: Aside = NOTHING


class Situation(Struct, frozen=True, gc=False):
    """Holds while ``condition`` does; without one always. Times are seconds above 0."""

    name: str
    extends: str | None = None
    dwell: float | None = None
    limit: float | None = None
    condition: Condition | None = None
    until: Condition | None = None
    entries: tuple[Entry, ...] = ()
    aside: Aside = NOTHING


class Spds(Struct, frozen=True, gc=False):
    """One ``*.spds.xml``. Situations stand in precedence, the first that holds is current."""

    name: str
    observe: tuple[Observed, ...] = ()
    modules: tuple[Declaration, ...] = ()
    situations: tuple[Situation, ...] = ()
    aside: Aside = NOTHING

    def situation(self, name: str) -> Situation | None:
        return next((s for s in self.situations if s.name == name), None)

    def priorities(self, situation: Situation) -> dict[str, int]:
        """Module to priority in ``situation``, ``extends`` followed, ``none`` removed.

        A circle of ``extends`` (an error that ``check`` finds) is cut where it closes.
        """
        chain: list[Situation] = []
        at: Situation | None = situation
        while at is not None and at not in chain:
            chain.append(at)
            at = self.situation(at.extends) if at.extends is not None else None
        found: dict[str, int | None] = {}
        for one in reversed(chain):
            for entry in one.entries:
                found[entry.module] = entry.priority
        return {module: p for module, p in found.items() if p is not None}

    def every_priorities(self) -> list[dict[str, int]]:
        """``priorities`` of every situation, in their order; what several take over is worked out
        once.
        """
        named: dict[str, Situation] = {}
        for situation in self.situations:
            named.setdefault(situation.name, situation)
        known: dict[int, dict[str, int | None]] = {}
        found: list[dict[str, int]] = []
        for situation in self.situations:
            chain: list[Situation] = []
            at: Situation | None = situation
            while at is not None and id(at) not in known and len(chain) <= len(self.situations):
                chain.append(at)
                at = named.get(at.extends) if at.extends is not None else None
            if len(chain) > len(self.situations):
                # In a circle what a situation takes over hangs on where it is entered.
                found.append(self.priorities(situation))
                continue
            every = known[id(at)] if at is not None else {}
            for one in reversed(chain):
                every = {**every, **{entry.module: entry.priority for entry in one.entries}}
                known[id(one)] = every
            every = known[id(situation)]
            found.append({module: p for module, p in every.items() if p is not None})
        return found
