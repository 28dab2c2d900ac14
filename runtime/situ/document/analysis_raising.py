"""What lets a module hold authority that never could: a priority high enough, and no higher.

Each is offered only where the same question that found the module is then answered otherwise;
where no other module loses all that it could win; and where no two tie by it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from msgspec.structs import replace

from situ.document import words
from situ.document.analysis_search import Search
from situ.document.analysis_winning import Asker, Spent, can_win
from situ.document.datatypes import shown
from situ.document.mend import change, put_in, take_out
from situ.document.place import Path
from situ.document.problem import Mend
from situ.document.spds import Entry, Situation, Spds

Priorities = dict[str, int]
"""Module to priority, in one situation."""

NAMED = 3
"""Modules that a mend names at most."""


class Raising:
    """The priorities that one module of a script could have instead."""

    def __init__(
        self, script: Spds, current: list[Situation], askers: dict[str, Asker], name: str
    ) -> None:
        self.script = script
        self.name = name
        self._askers = askers
        known = {id(situation) for situation in current}
        self._current = [
            at for at, situation in enumerate(script.situations) if id(situation) in known
        ]
        every = script.every_priorities()
        self._now = {at: every[at] for at in self._current}

    def raised(self, at: int, entry: int) -> tuple[int, list[str]] | None:
        """The lowest priority at which the module wins by that entry of the situation at ``at``,
        and those that stand just below it then.
        """
        now = self.script.situations[at].entries[entry].priority
        assert now is not None
        touched = self._touched(at, entry)
        above = {p for one in touched for p in self._others(one) if p > now}
        for priority in self._free(touched, sorted(p + 1 for p in above)):
            if self._wins(touched, priority):
                below = {
                    module
                    for one in touched
                    for module, p in self._now[one].items()
                    if p == priority - 1
                }
                may = self._leaves_others(touched, priority)
                return (priority, sorted(below)) if may else None
        return None

    def given(self) -> int | None:
        """The lowest priority with which the module wins in the last situation, to which it is
        given there; not below 1 where it need not be.
        """
        at = len(self.script.situations) - 1
        touched = self._touched(at, None)
        others = sorted({p for one in touched for p in self._others(one)})
        lowest = min([1, *(p - 1 for p in others)])
        several = (lowest, *(p + 1 for p in others))
        free = self._free(touched, several)
        return next((p for p in free if self._wins(touched, p)), None)

    def with_priority(self, at: int, entry: int | None, priority: int) -> Spds:
        """The script with another priority there; entry None: in an entry of its own."""
        situation = self.script.situations[at]
        entries = list(situation.entries)
        if entry is None:
            entries.append(Entry(self.name, priority))
        else:
            entries[entry] = replace(entries[entry], priority=priority)
        situations = list(self.script.situations)
        situations[at] = replace(situation, entries=tuple(entries))
        return replace(self.script, situations=tuple(situations))

    def _touched(self, at: int, entry: int | None) -> list[int]:
        """The situations that can be current in which the module has its priority from there."""
        unlike = max((p for one in self._now.values() for p in one.values()), default=0) + 1
        every = self.with_priority(at, entry, unlike).every_priorities()
        return [one for one in self._current if every[one].get(self.name) == unlike]

    def _others(self, at: int) -> Iterator[int]:
        return (p for module, p in self._now[at].items() if module != self.name)

    def _free(self, touched: list[int], several: Iterable[int]) -> Iterator[int]:
        """Those of several priorities that nobody has."""
        taken = {p for one in touched for p in self._others(one)}
        return (p for p in several if p not in taken)

    def _after(self, touched: list[int], priority: int) -> dict[int, Priorities]:
        new = {one: {**self._now[one], self.name: priority} for one in touched}
        return {**self._now, **new}

    def _wins(self, touched: list[int], priority: int) -> bool:
        after = self._after(touched, priority)
        return any(self._can_win(after[one], self.name) for one in touched)

    def _leaves_others(self, touched: list[int], priority: int) -> bool:
        """Whether everybody still wins who does now. Who may ask for nothing hinders nobody."""
        if self._askers[self.name].asks is None:
            return True
        after = self._after(touched, priority)
        return all(
            any(self._can_win(one, other) for one in after.values())
            for other in self._askers
            if any(self._can_win(one, other) for one in self._now.values())
        )

    def _can_win(self, priorities: Priorities, name: str) -> bool:
        """Whether it is known that a module can."""
        try:
            return can_win(priorities, self._askers, name)
        except Spent:
            return False


def raised(search: Search, file: str, raising: Raising) -> Mend | None:
    """To raise the first priority of the module that can be raised so that it wins."""
    script = raising.script
    for at, entry in _entries(script, raising.name):
        held = script.situations[at].entries[entry]
        search.go_on()
        found = raising.raised(at, entry) if held.priority is not None else None
        if found is not None:
            priority, below = found
            named = [shown(one) for one in below]
            if len(named) > NAMED:
                named = [*named[: NAMED - 1], f"{len(named) - NAMED + 1} more"]
            where = shown(script.situations[at].name)
            said = f"Raise it to {priority} in {where}, above {words.listed(named)}"
            path: Path = ("situations", at, "entries", entry)
            return search.mend(file, said, change(path, held, "priority", priority))
    return None


def given(search: Search, file: str, raising: Raising) -> Mend | None:
    """To give a module without any priority one in the last situation, which is current when
    nothing else is. None where it is taken away somewhere by hand.
    """
    script = raising.script
    if not script.situations or any(True for _ in _entries(script, raising.name)):
        return None
    priority = raising.given()
    if priority is None:
        return None
    last = script.situations[-1]
    said = f"Give it the priority {priority} in {shown(last.name)}"
    path: Path = ("situations", len(script.situations) - 1, "entries", len(last.entries))
    return search.mend(file, said, put_in(path, Entry(raising.name, priority)))


def taken_away(search: Search, file: str, script: Spds, name: str) -> Mend | None:
    """To take every priority of a module out."""
    found = list(_entries(script, name))
    # From the end of each situation, so that the positions of what stands before stay.
    changes = (
        take_out(("situations", at, "entries", entry), script.situations[at].entries[entry])
        for at, entry in reversed(found)
    )
    said = "Take its priority out" if len(found) == 1 else "Take its priorities out"
    return search.mend(file, said, *changes)


def _entries(script: Spds, name: str) -> Iterator[tuple[int, int]]:
    """Where a module stands: the positions of situations and of their entries."""
    for at, situation in enumerate(script.situations):
        for entry, held in enumerate(situation.entries):
            if held.module == name:
                yield at, entry
