"""What lets a module hold authority that never could: a priority high enough, and no higher.

Each is offered only where the same question that found the module is then answered otherwise;
where no other module loses all that it could win; and where no two tie by it.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator
from functools import cached_property

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
    """The priorities that modules of a script could have instead; what all of them need is worked
    out once.
    """

    def __init__(self, script: Spds, current: list[Situation], askers: dict[str, Asker]) -> None:
        self.script = script
        self._askers = askers
        self._known = {id(situation) for situation in current}

    @cached_property
    def _now(self) -> dict[int, Priorities]:
        """By its position, what a situation that can be current gives."""
        every = enumerate(self.script.every_priorities())
        return {at: one for at, one in every if id(self.script.situations[at]) in self._known}

    def raised(self, name: str, at: int, entry: int) -> tuple[int, list[str], bool] | None:
        """The lowest priority at which a module wins by that entry of the situation at ``at``,
        those that stand just below it then, and whether everybody else still wins.
        """
        entries = self.script.situations[at].entries
        now = entries[entry].priority
        # Of two of one situation, which is an error, the last one counts.
        counts = all(one.module != name for one in entries[entry + 1 :])
        touched = self._touched(name, at) if counts else []
        above = {p for one in touched for p in self._others(name, one) if now is None or p > now}
        several = self._free(name, touched, sorted(p + 1 for p in above))
        # The fewer stand above it, the more it can be granted.
        first = bisect_left(several, True, key=lambda p: self._wins(name, touched, p))
        if first == len(several):
            return None
        priority = several[first]
        below = {
            module for one in touched for module, p in self._now[one].items() if p == priority - 1
        }
        return priority, sorted(below), self._leaves_others(name, touched, priority)

    def given(self, name: str) -> int | None:
        """The lowest priority with which a module wins in the last situation, to which it is given
        there; not below 1 where it need not be. It has none anywhere.
        """
        touched = self._touched(name, len(self.script.situations) - 1)
        others = sorted({p for one in touched for p in self._others(name, one)})
        lowest = min([1, *(p - 1 for p in others)])
        several = self._free(name, touched, (lowest, *(p + 1 for p in others)))
        first = bisect_left(several, True, key=lambda p: self._wins(name, touched, p))
        return several[first] if first < len(several) else None

    def _touched(self, name: str, at: int) -> list[int]:
        """The situations that can be current and take what they say of a module from that one."""
        return [one for one in self._now if self._source(name, one, at) == at]

    def _source(self, name: str, at: int, wanted: int) -> int | None:
        """Which situation says what one gives a module: itself, or what it extends; ``wanted``
        where none says anything and that one is among them.
        """
        seen: list[int] = []
        while at not in seen:
            seen.append(at)
            situation = self.script.situations[at]
            if any(entry.module == name for entry in situation.entries):
                return at
            following = self._positions.get(situation.extends or "")
            if following is None:
                break
            at = following
        return wanted if wanted in seen else None

    @cached_property
    def _positions(self) -> dict[str, int]:
        found: dict[str, int] = {}
        for at, situation in enumerate(self.script.situations):
            found.setdefault(situation.name, at)
        return found

    def _others(self, name: str, at: int) -> Iterator[int]:
        return (p for module, p in self._now[at].items() if module != name)

    def _free(self, name: str, touched: list[int], several: Iterable[int]) -> list[int]:
        """Those of several priorities that nobody has."""
        taken = {p for one in touched for p in self._others(name, one)}
        return [p for p in several if p not in taken]

    def _wins(self, name: str, touched: list[int], priority: int) -> bool:
        return any(self._can_win({**self._now[one], name: priority}, name) for one in touched)

    def _leaves_others(self, name: str, touched: list[int], priority: int) -> bool:
        """Whether everybody still wins who does now. Who may ask for nothing hinders nobody."""
        if self._askers[name].asks is None:
            return True
        after = {**self._now, **{one: {**self._now[one], name: priority} for one in touched}}
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


def raised(search: Search, file: str, raising: Raising, name: str) -> Mend | None:
    """To raise the first priority of a module that can be raised so that it wins."""
    script = raising.script
    for at, entry in _entries(script, name):
        held = script.situations[at].entries[entry]
        search.go_on()
        found = raising.raised(name, at, entry) if held.priority is not None else None
        if found is not None:
            priority, below, may = found
            named = [shown(one) for one in below]
            if len(named) > NAMED:
                named = [*named[: NAMED - 1], f"{len(named) - NAMED + 1} more"]
            where = shown(script.situations[at].name)
            said = f"Raise it to {priority} in {where}, above {words.listed(named)}"
            path: Path = ("situations", at, "entries", entry)
            made = change(path, held, "priority", priority)
            return search.mend(file, said, made) if may else None
    return None


def given(search: Search, file: str, raising: Raising, name: str) -> Mend | None:
    """To give a module without any priority one in the last situation, which is current when
    nothing else is. None where it is taken away somewhere by hand.
    """
    script = raising.script
    if not script.situations or any(True for _ in _entries(script, name)):
        return None
    priority = raising.given(name)
    if priority is None:
        return None
    last = script.situations[-1]
    said = f"Give it the priority {priority} in {shown(last.name)}"
    path: Path = ("situations", len(script.situations) - 1, "entries", len(last.entries))
    return search.mend(file, said, put_in(path, Entry(name, priority)))


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
