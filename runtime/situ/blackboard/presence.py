"""Who is there: declared modules, connected ones, applications, and what is wanted.

Seed 000, 4.2; formats.md, *Module information*.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from situ.blackboard.protocol import Need, Offer
from situ.blackboard.replies import ModuleState, Wanted
from situ.document.modules import Module
from situ.document.project import Project

Disclosed = tuple[tuple[str, ...], str, tuple[Need, ...], tuple[Offer, ...]]
"""What a connected module said: resources, description, requires, provides."""


def modules(
    project: Project, connected: Mapping[str, Disclosed], holders: Mapping[str, str | None]
) -> tuple[ModuleState, ...]:
    """Every module known, sorted by name; what a module says itself goes before what files say."""
    declared = project.declared()
    applications = {application.name for application in project.applications.values()}
    found = []
    for name in sorted({*declared, *applications, *connected}):
        held = tuple(sorted(r for r, holder in holders.items() if holder == name))
        known = project.module(name)
        resources = declared.get(name, ())
        description, requires, provides = _from_files(known)
        if name in connected:
            said = connected[name]
            resources = resources or said[0]
            description = said[1] or description
            requires = said[2] or requires
            provides = said[3] or provides
        found.append(
            ModuleState(
                name=name,
                application=name in applications,
                declared=name in declared,
                present=name in applications or name in connected,
                resources=resources,
                holds=held,
                description=description,
                requires=requires,
                provides=provides,
            )
        )
    return tuple(found)


def _from_files(module: Module | None) -> tuple[str, tuple[Need, ...], tuple[Offer, ...]]:
    if module is None:
        return "", (), ()
    requires = tuple(Need(data=r.data, module=r.module) for r in module.requires)
    provides = tuple(Offer(data=p.data, type=p.type, unit=p.unit) for p in module.provides)
    return module.description, requires, provides


def wanted(states: tuple[ModuleState, ...], stands: Callable[[str], bool]) -> tuple[Wanted, ...]:
    """What modules require and nobody who is present provides, data first, sorted.

    stands: whether a tag stands on the board (set by hand, or by a module that
    disclosed nothing); what stands there is not wanted.
    """
    present = {state.name for state in states if state.present}
    provided = {offer.data for state in states if state.present for offer in state.provides}
    missing: dict[tuple[str | None, str | None], list[str]] = {}
    for state in states:
        for need in state.requires:
            absent = need.module is not None and need.module not in present
            unknown = need.data is not None and need.data not in provided and not stands(need.data)
            if absent or unknown:
                missing.setdefault((need.data, need.module), []).append(state.name)
    ordered = sorted(missing, key=lambda key: (key[0] is None, key[0] or key[1] or ""))
    return tuple(Wanted(data=d, module=m, by=tuple(missing[d, m])) for d, m in ordered)
