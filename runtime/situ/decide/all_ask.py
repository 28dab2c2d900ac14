"""Who holds what when modules ask for all that they may ask for (formats.md, *SPDS*).

The question that a designer has of a list of priorities; the answer is the priority
management's own.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec import Struct

from situ.decide.priorities import Request, granted


class Holding(Struct, frozen=True):
    """Who holds a resource. rivals: who else would, if another of equal priority had asked first;
    where there are any, nothing but the order of asking decides.
    """

    module: str | None
    rivals: tuple[str, ...] = ()


def who_holds(
    asking: Mapping[str, Iterable[str]], priorities: Mapping[str, int]
) -> dict[str, Holding]:
    """Every resource that somebody asks for, and who holds it; None: nobody.

    asking: module to the resources that it asks for, all of them or none, in the order in which
    they ask; nobody holds anything before.
    """
    requests = {
        module: Request(tuple(resources), (), order)
        for order, (module, resources) in enumerate(asking.items())
    }
    found = granted(requests, {}, priorities)
    others: dict[str, set[str]] = {}
    for module in _refused_by_equals(requests, found, priorities):
        first = {**requests, module: Request(requests[module].resources, (), -1)}
        then = granted(first, {}, priorities)
        for resource in found.keys() | then.keys():
            if found.get(resource) != then.get(resource):
                others.setdefault(resource, set()).add(then.get(resource, module))
    every = dict.fromkeys(r for request in requests.values() for r in request.resources)
    return {r: Holding(found.get(r), tuple(sorted(others.get(r, ())))) for r in every}


def _refused_by_equals(
    requests: Mapping[str, Request], found: Mapping[str, str], priorities: Mapping[str, int]
) -> Iterable[str]:
    """Modules that got nothing because one of their own priority had asked before them."""
    for module, request in requests.items():
        mine = priorities.get(module)
        holders = {found.get(resource) for resource in request.resources} - {None}
        if mine is None or module in holders:
            continue
        if any(holder is not None and priorities[holder] == mine for holder in holders):
            yield module
