"""Modules that a script does not name yet: of the project's files, and of a robot that runs.

Modules disclose themselves (seed 000, 4.2), in ``modules.xml`` or when they connect.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from situ.document.check_application import to_declare
from situ.document.modules import Module, Modules, Provides, Requires
from situ.document.project import Project
from situ.document.spds import DATA_TYPES, Declaration, Entry, Observed, Spds
from situ_studio.edits.edit import Document
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ.blackboard.replies import ModuleState


class Known(Struct, frozen=True):
    """A module that could act.

    application: it is one of the project's. present: it is connected to the robot now.
    """

    module: Module
    application: bool = False
    present: bool = False


def known(project: Project, told: Iterable[ModuleState] = ()) -> dict[str, Known]:
    """Every module by name: those of ``modules.xml``, the project's applications, and what a robot
    told. What a file says counts before what the module says of itself.
    """
    found: dict[str, Known] = {}
    if project.modules is not None:
        found = {m.name: Known(m) for m in project.modules.modules}
    for application in project.applications.values():
        resources = to_declare(project, application)
        found[application.name] = Known(Module(application.name, resources), application=True)
    for one in told:
        if one.application:
            continue
        before = found.get(one.name)
        module = before.module if before is not None else _disclosed(one)
        found[one.name] = Known(module, present=one.present)
    return found


def _disclosed(told: ModuleState) -> Module:
    return Module(
        told.name,
        tuple(told.resources),
        told.description,
        tuple(Requires(need.data, need.module) for need in told.requires),
        tuple(
            Provides(o.data, next((t for t in DATA_TYPES if t == o.type), None), o.unit)
            for o in told.provides
        ),
    )


def added(
    project: Project, script: Spds, file: str, one: Known, situation: str | None = None
) -> tuple[dict[str, Document], str]:
    """The documents with that module in the script, by file, and the name of the step.

    It is declared with its resources, and what it provides is observed. With ``situation`` it gets
    a priority there, below all others, for a newcomer shall take nothing from them. Its information
    is written to ``modules.xml``, where the project has one that does not know it. Nothing is
    changed where it is there already.
    """
    module = one.module
    after = script
    if all(m.name != module.name for m in script.modules):
        declared = Declaration(module.name, module.resources)
        after = replace(after, modules=(*after.modules, declared))
    tags = {o.tag for o in script.observe}
    new = [Observed(p.data, p.type, p.unit) for p in module.provides if p.data not in tags]
    if new:
        after = replace(after, observe=(*after.observe, *new))
    if situation is not None:
        after = _with_priority(after, situation, module.name)
    changed: dict[str, Document] = {}
    if after is not script:
        changed[file] = after
    information = project.modules
    if (
        information is not None
        and project.modules_file is not None
        and not one.application
        and all(m.name != module.name for m in information.modules)
    ):
        every = (*information.modules, module)
        changed[project.modules_file] = Modules(every, information.aside)
    return changed, tr("Add {0} to the script").format(module.name)


def _with_priority(script: Spds, name: str, module: str) -> Spds:
    situation = script.situation(name)
    if situation is None or any(e.module == module for e in situation.entries):
        return script
    lowest = min(script.priorities(situation).values(), default=20)
    entry = Entry(module, (lowest - 1) // 10 * 10)
    entries = (*situation.entries, entry)
    situations = tuple(
        replace(s, entries=entries) if s is situation else s for s in script.situations
    )
    return replace(script, situations=situations)
