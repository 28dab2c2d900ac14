"""Who holds what when modules ask for all that they may ask for (formats.md, *SPDS*).

The question that a designer has of a list of priorities; the answer is the priority
management's own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from msgspec import Struct

from situ.decide.priorities import Request, granted


class Holding(Struct, frozen=True):
    """Who holds a resource. rivals: who else would, if another of equal priority had asked first;
    where there are any, nothing but the order of asking decides.
    """

    module: str | None
    rivals: tuple[str, ...] = ()


class Requests:
    """What modules ask for: each all of its resources or none, in the order given; nobody holds
    anything before.
    """

    def __init__(self, asking: Mapping[str, Iterable[str]]) -> None:
        self.by_module = {
            module: Request(tuple(resources), (), order)
            for order, (module, resources) in enumerate(asking.items())
        }
        self.resources = tuple(
            dict.fromkeys(r for one in self.by_module.values() for r in one.resources)
        )


def who_holds(requests: Requests, priorities: Mapping[str, int]) -> dict[str, Holding]:
    """Every resource that somebody asks for, and who holds it; None: nobody."""
    every = requests.by_module
    found = granted(every, {}, priorities)
    others: dict[str, set[str]] = {}
    for module in _refused_by_equals(every, found, priorities):
        first = {**every, module: Request(every[module].resources, (), -1)}
        then = granted(first, {}, priorities)
        for resource in found.keys() | then.keys():
            if found.get(resource) != then.get(resource):
                others.setdefault(resource, set()).add(then.get(resource, module))
    return {
        resource: Holding(found.get(resource), tuple(sorted(others.get(resource, ()))))
        for resource in requests.resources
    }


def _refused_by_equals(
    requests: Mapping[str, Request], found: Mapping[str, str], priorities: Mapping[str, int]
) -> Iterable[str]:
    """Modules that got nothing because one of their own priority had asked before them."""
    many = Counter(priorities.values())
    for module, request in requests.items():
        mine = priorities.get(module)
        if mine is None or many[mine] == 1:
            continue
        holders = {found.get(resource) for resource in request.resources} - {None}
        if module in holders:
            continue
        if any(holder is not None and priorities[holder] == mine for holder in holders):
            yield module
