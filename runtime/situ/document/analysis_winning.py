"""Who can be granted something: resources shared out from the highest priority down."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator

Asks = tuple[frozenset[str], frozenset[str]]
"""What a request needs, and what it takes beside that where it is free."""

MOST = 20_000
"""Ways to share out resources that are looked at, for one question."""


class Asker:
    """A module of the script. asks: the requests it makes, None for any part of ``resources``."""

    def __init__(self, resources: frozenset[str], asks: frozenset[Asks] | None) -> None:
        self.resources = resources
        self.asks = asks


class Spent(Exception):
    """Too many ways were looked at."""


def can_win(priorities: dict[str, int], askers: dict[str, Asker], name: str) -> bool:
    """Whether a module can be granted something with these priorities."""
    if name not in priorities or name not in askers:
        return False
    mine = priorities[name]
    above: dict[int, list[Asker]] = {}
    for module, priority in priorities.items():
        if priority > mine and module in askers:
            above.setdefault(priority, []).append(askers[module])
    # Who may ask for any part may as well ask for nothing: it matters only where it can keep an
    # application from what that asks for.
    lowest = min((p for p, several in above.items() if not _is_free(several)), default=math.inf)
    taken: set[frozenset[str]] = {frozenset()}
    for priority in sorted(above, reverse=True):
        if priority >= lowest:
            taken = _after(taken, above[priority])
    return any(_granted(askers[name], one) for one in taken)


def _granted(asker: Asker, taken: frozenset[str]) -> bool:
    if asker.asks is None:
        return bool(asker.resources - taken)
    return any(not needs & taken and bool(needs or takes - taken) for needs, takes in asker.asks)


def _is_free(several: list[Asker]) -> bool:
    """Whether each may ask for any part of its resources, and for none."""
    return all(one.asks is None for one in several)


def _after(taken: set[frozenset[str]], several: list[Asker]) -> set[frozenset[str]]:
    """What can be taken after modules of one priority asked, in any order."""
    if _is_free(several):
        for resource in frozenset[str]().union(*(one.resources for one in several)):
            taken = taken | {one | {resource} for one in taken}
            if len(taken) > MOST:
                raise Spent
        return taken
    several = _telling(several)
    everyone = frozenset(range(len(several)))
    reached = {(one, everyone) for one in taken}
    waiting = list(reached)
    while waiting:
        held, left = waiting.pop()
        for at in left:
            for more in _may_take(several[at], held):
                new = (held | more, left - {at})
                if new not in reached:
                    reached.add(new)
                    waiting.append(new)
                    if len(reached) > MOST:
                        raise Spent
    return {held for held, left in reached if not left}


def _telling(several: list[Asker]) -> list[Asker]:
    """Without those that change nothing: of modules with the same resources no more than these can
    take something each.
    """
    found: list[Asker] = []
    count: Counter[frozenset[str]] = Counter()
    for one in several:
        if one.asks is None:
            count[one.resources] += 1
        if one.asks is not None or count[one.resources] <= len(one.resources):
            found.append(one)
    return found


def _may_take(asker: Asker, taken: frozenset[str]) -> Iterator[frozenset[str]]:
    """What a module can be granted when its turn comes."""
    if asker.asks is None:
        yield from _parts(asker.resources - taken)
        return
    for needs, takes in asker.asks:
        yield needs | (takes - taken) if not needs & taken else frozenset()


def _parts(resources: Iterable[str]) -> Iterator[frozenset[str]]:
    several = sorted(resources)
    if len(several) > 12:
        raise Spent
    for bits in range(1 << len(several)):
        yield frozenset(one for at, one in enumerate(several) if bits >> at & 1)
