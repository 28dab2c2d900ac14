"""What is wrong in a script (formats.md, *SPDS*) and in module information."""

from __future__ import annotations

from collections.abc import Iterator

from situ.document import names
from situ.document.aside import Aside
from situ.document.check_values import check_values
from situ.document.condition import Condition, Group, Test
from situ.document.datatypes import shown
from situ.document.finding import Findings, Place
from situ.document.modules import Modules
from situ.document.project import Project
from situ.document.spds import Situation, Spds

_KEPT = ("clock", "situation", "listen")
"""Tags that the runtime keeps beside those under reserved roots; nobody need observe them."""


def check_script(found: Findings, script: Spds, project: Project) -> None:
    """Tells what is wrong in a script, and where it and the module information contradict."""
    check_values(found, script)
    _declarations(found, script, project)
    _situations(found, script)
    _entries(found, script, project)
    _observed(found, script, project)


def check_modules(found: Findings, modules: Modules) -> None:
    """Tells what is wrong in module information."""
    check_values(found, modules)
    seen: set[str] = set()
    for module in modules.modules:
        place = ("module", module.name)
        if module.name in seen:
            said = f"There are two modules {shown(module.name)}: give one of them another name"
            found.error("double-module", said, module.aside, place)
        seen.add(module.name)
        for index, one in enumerate(module.requires):
            if (one.data is None) == (one.module is None):
                said = "<requires> names either data or a module: give it exactly one of the two"
                found.error("bad-requires", said, one.aside, (*place, "requires", str(index)))


def _declarations(found: Findings, script: Spds, project: Project) -> None:
    seen: set[str] = set()
    for declared in script.modules:
        place = ("module", declared.name)
        if declared.name in seen:
            said = f"{shown(declared.name)} is declared twice: take one out"
            found.error("double-module", said, declared.aside, place)
        seen.add(declared.name)
        known = project.module(declared.name)
        if known is not None and set(known.resources) != set(declared.resources):
            said = (
                f"{shown(declared.name)} has the resources {_listed(declared.resources)} here "
                f"and {_listed(known.resources)} in {project.modules_file}: make them the same"
            )
            found.error("contradiction", said, declared.aside, place)


def _listed(resources: tuple[str, ...]) -> str:
    return shown(" ".join(resources))


def _situations(found: Findings, script: Spds) -> None:
    if not script.situations:
        said = "The script has no situation: add a <situation>"
        found.error("no-situation", said, script.aside)
    seen: set[str] = set()
    known = {situation.name for situation in script.situations}
    for situation in script.situations:
        place = ("situation", situation.name)
        aside = situation.aside
        if situation.name in seen:
            said = f"There are two situations {shown(situation.name)}: give one another name"
            found.error("double-situation", said, aside, place)
        seen.add(situation.name)
        if situation.extends is not None and situation.extends not in known:
            said = f"extends names no situation: {shown(situation.extends)}"
            found.error("unknown-situation", said, aside, place)
        elif _circular(script, situation):
            said = (
                f"{shown(situation.name)} extends itself by way of {shown(situation.extends or '')}"
            )
            found.error("circular-extends", said, aside, place)
        if situation.dwell is not None and (situation.until or situation.limit is not None):
            said = "dwell cannot stand together with until or limit: take one of them out"
            found.error("dwell-with-until", said, aside, place)
    if script.situations:
        last = script.situations[-1]
        place = ("situation", last.name)
        if last.condition is not None:
            said = (
                "The last situation must always hold, so that there is one: take its "
                "<condition> out, or add a situation without one below it"
            )
            found.error("last-situation", said, last.condition.aside, (*place, "condition"))
        if last.until is not None or last.limit is not None:
            said = "The last situation must always hold: take its until and limit out"
            found.error("last-situation", said, last.aside, place)


def _circular(script: Spds, situation: Situation) -> bool:
    """Whether following ``extends`` from a situation leads back to it."""
    seen: set[str] = set()
    name = situation.extends
    while name is not None and name not in seen:
        if name == situation.name:
            return True
        seen.add(name)
        extended = script.situation(name)
        name = extended.extends if extended is not None else None
    return False


def _entries(found: Findings, script: Spds, project: Project) -> None:
    declared = project.declared()
    unread = project.modules_file is not None and project.modules is None
    for situation in script.situations:
        seen: set[str] = set()
        for index, entry in enumerate(situation.entries):
            place = ("situation", situation.name, "entry", str(index))
            if entry.module in seen:
                said = f"{shown(entry.module)} has two priorities in this situation: take one out"
                found.error("double-module", said, entry.aside, place)
            seen.add(entry.module)
            if entry.module not in declared and not unread:
                said = (
                    f"No module {shown(entry.module)} is declared: add it to <modules> here "
                    "with its resources, or to the module information"
                )
                found.error("undeclared-module", said, entry.aside, place)


def _tests(condition: Condition | Group, place: Place) -> Iterator[tuple[Test, Place]]:
    for index, child in enumerate(condition.children):
        at = (*place, str(index))
        if isinstance(child, Test):
            yield child, at
        else:
            yield from _tests(child, at)


def _observed(found: Findings, script: Spds, project: Project) -> None:
    """Contradictions about data, and the tags that are used but not observed."""
    provided = {
        one.data: one
        for module in (project.modules.modules if project.modules else ())
        for one in module.provides
    }
    observed: dict[str, Aside] = {}
    for data in script.observe:
        place: Place = ("data", data.tag)
        if data.tag in observed:
            said = f"{shown(data.tag)} is observed twice: take one out"
            found.error("double-data", said, data.aside, place)
        observed[data.tag] = data.aside
        known = provided.get(data.tag)
        for word in ("type", "unit"):
            ours, theirs = getattr(data, word), getattr(known, word, None)
            if ours is not None and theirs is not None and ours != theirs:
                said = (
                    f"{shown(data.tag)} has the {word} {shown(ours)} here and {shown(theirs)} "
                    f"in {project.modules_file}: make them the same"
                )
                found.error("contradiction", said, data.aside, place)
    told: set[str] = set()
    for situation in script.situations:
        for word in ("condition", "until"):
            condition = getattr(situation, word)
            if condition is None:
                continue
            for test, place in _tests(condition, ("situation", situation.name, word)):
                if test.tag in told or _is_observed(test.tag, observed):
                    continue
                told.add(test.tag)
                said = f"{shown(test.tag)} is used but not observed: add it to <observe>"
                found.warning("unobserved-tag", said, test.aside, place)


def _is_observed(name: str, observed: dict[str, Aside]) -> bool:
    if names.is_reserved(name) or name.partition(".")[0] in _KEPT:
        return True
    words = name.split(".")
    return any(".".join(words[:count]) in observed for count in range(len(words), 0, -1))
