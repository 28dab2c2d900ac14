"""What is wrong in a script (formats.md, *SPDS*) and in module information."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from difflib import get_close_matches
from typing import Any

from msgspec import Struct

from situ.document import names
from situ.document.check_application import another, to_declare
from situ.document.check_values import check_values
from situ.document.condition import Condition, Group, Test
from situ.document.datatypes import shown
from situ.document.finding import Findings, Place
from situ.document.mend import change, put_in, take_out
from situ.document.modules import Modules, Provides
from situ.document.place import Path
from situ.document.problem import Mend
from situ.document.project import Project
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds

DEFAULT = "otherwise"
"""The name of a situation that a mend adds, which holds where no other does."""

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
                said = (
                    "What a module requires is either data or a module: give it exactly one of "
                    "the two"
                )
                found.error("bad-requires", said, one.aside, (*place, "requires", str(index)))


def _declarations(found: Findings, script: Spds, project: Project) -> None:
    seen: dict[str, Declaration] = {}
    for at, declared in enumerate(script.modules):
        place = ("module", declared.name)
        path: Path = ("modules", at)
        first = seen.setdefault(declared.name, declared)
        if first is not declared:
            said = f"{shown(declared.name)} is declared twice: take one out"
            mend = _again(found, path, first, declared)
            found.error("double-module", said, declared.aside, place, mend)
        known = project.module(declared.name)
        if known is not None and set(known.resources) != set(declared.resources):
            said = (
                f"{shown(declared.name)} has the resources {_listed(declared.resources)} here "
                f"and {_listed(known.resources)} in {project.modules_file}: make them the same"
            )
            mend = Mend(
                found.file,
                f"Say here what {project.modules_file} says",
                (change(path, declared, "resources", known.resources),),
            )
            found.error("contradiction", said, declared.aside, place, mend)


def _again(found: Findings, path: Path, first: Struct, again: Struct) -> Mend:
    """To take out what stands there again; surely, where it says nothing else."""
    return Mend(found.file, "Take this one out", (take_out(path, again),), safe=first == again)


def _listed(resources: tuple[str, ...]) -> str:
    return shown(" ".join(resources)) if resources else "none"


def _situations(found: Findings, script: Spds) -> None:
    if not script.situations:
        said = "The script has no situation: add one"
        found.error("no-situation", said, script.aside, mend=_default(found, script, 0))
        return
    known = {situation.name for situation in script.situations}
    seen: set[str] = set()
    for at, situation in enumerate(script.situations):
        _situation(found, script, situation, ("situations", at), known, seen)
        seen.add(situation.name)
    _last(found, script, script.situations[-1])


def _situation(
    found: Findings,
    script: Spds,
    situation: Situation,
    path: Path,
    known: set[str],
    seen: set[str],
) -> None:
    def error(code: str, said: str, mend: str, field: str, to: Any) -> None:
        made = Mend(found.file, mend, (change(path, situation, field, to),))
        found.error(code, said, situation.aside, ("situation", situation.name), made)

    if situation.name in seen:
        said = f"There are two situations {shown(situation.name)}: give one another name"
        free = another(situation.name, known)
        error("double-situation", said, f"Call it {shown(free)}", "name", free)
    extends = situation.extends
    if extends is not None and extends not in known:
        said = (
            f"This situation extends {shown(extends)}, which does not exist: name one that there "
            "is, or take extends out"
        )
        near = get_close_matches(extends[:40], sorted(known - {situation.name}), n=1)
        words = f"Extend {shown(near[0])}" if near else "Take extends out"
        error("unknown-situation", said, words, "extends", near[0] if near else None)
    elif extends is not None and _circular(script, situation):
        said = (
            f"{shown(situation.name)} extends itself by way of {shown(extends)}: take one of the "
            "extends out"
        )
        error("circular-extends", said, "Take extends out here", "extends", None)
    if situation.dwell is not None and (situation.until or situation.limit is not None):
        said = "dwell cannot stand together with until or limit: take one of them out"
        error("dwell-with-until", said, "Take dwell out", "dwell", None)


def _last(found: Findings, script: Spds, last: Situation) -> None:
    """What must always hold, so that there is always a situation."""
    size = len(script.situations)
    place = ("situation", last.name)
    if last.condition is not None:
        said = (
            "The last situation must always hold, so that there is one: take its condition "
            "out, or add a situation without one below it"
        )
        at = (*place, "condition")
        mend = _default(found, script, size)
        found.error("last-situation", said, last.condition.aside, at, mend)
    elif last.until is not None or last.limit is not None:
        said = "The last situation must always hold: take its until and limit out"
        changes = (change(("situations", size - 1), last, one, None) for one in ("until", "limit"))
        mend = Mend(found.file, "Let it always hold", tuple(changes))
        found.error("last-situation", said, last.aside, place, mend)


def _default(found: Findings, script: Spds, at: int) -> Mend:
    """To add a situation that always holds."""
    known = {situation.name for situation in script.situations}
    name = DEFAULT if DEFAULT not in known else another(DEFAULT, known)
    added = put_in(("situations", at), Situation(name))
    return Mend(found.file, f"Add the situation {shown(name)}, which always holds", (added,))


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
    for at, situation in enumerate(script.situations):
        seen: dict[str, Entry] = {}
        for index, entry in enumerate(situation.entries):
            place = ("situation", situation.name, "entry", str(index))
            path: Path = ("situations", at, "entries", index)
            first = seen.setdefault(entry.module, entry)
            if first is not entry:
                said = f"{shown(entry.module)} has two priorities in this situation: take one out"
                mend = _again(found, path, first, entry)
                found.error("double-module", said, entry.aside, place, mend)
            if entry.module not in declared and not unread:
                said = (
                    f"No module {shown(entry.module)} is declared: add it to the modules here "
                    "with its resources, or to the module information"
                )
                found.error(
                    "undeclared-module",
                    said,
                    entry.aside,
                    place,
                    declare(found, script, project, entry.module),
                )


def declare(found: Findings, script: Spds, project: Project, name: str) -> Mend | None:
    """To declare an application with what it uses; nobody knows what other modules use."""
    application = next((a for a in project.applications.values() if a.name == name), None)
    if application is None:
        return None
    used = to_declare(project, application)
    added = put_in(("modules", len(script.modules)), Declaration(name, used))
    return Mend(found.file, f"Declare {shown(name)} with {_listed(used)}", (added,))


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
    observed: dict[str, Observed] = {}
    for at, data in enumerate(script.observe):
        place: Place = ("data", data.tag)
        path: Path = ("observe", at)
        first = observed.setdefault(data.tag, data)
        if first is not data:
            said = f"{shown(data.tag)} is observed twice: take one out"
            found.error("double-data", said, data.aside, place, _again(found, path, first, data))
        known = provided.get(data.tag)
        for word in ("type", "unit"):
            ours, theirs = getattr(data, word), getattr(known, word, None)
            if ours is not None and theirs is not None and ours != theirs:
                said = (
                    f"{shown(data.tag)} has the {word} {shown(ours)} here and {shown(theirs)} "
                    f"in {project.modules_file}: make them the same"
                )
                mend = Mend(
                    found.file,
                    f"Say here what {project.modules_file} says",
                    (change(path, data, word, theirs),),
                )
                found.error("contradiction", said, data.aside, place, mend)
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
                said = f"{shown(test.tag)} is used but not observed: add it to the data observed"
                offered = _observe(found, script, test.tag, provided)
                found.warning("unobserved-tag", said, test.aside, place, offered)


def _observe(
    found: Findings, script: Spds, name: str, provided: dict[str, Provides]
) -> Mend | None:
    """To observe the tag that a name begins with; surely, where some module provides it."""
    words = name.split(".")
    starts = [".".join(words[:size]) for size in range(len(words), 0, -1)]
    known = next((provided[one] for one in starts if one in provided), None)
    tag = known.data if known is not None else next((t for t in starts if names.is_tag(t)), None)
    if tag is None:
        return None
    data = Observed(tag, known.type, known.unit) if known is not None else Observed(tag)
    added = put_in(("observe", len(script.observe)), data)
    return Mend(found.file, f"Observe {shown(tag)}", (added,), safe=known is not None)


def _is_observed(name: str, observed: Collection[str]) -> bool:
    if names.is_reserved(name) or name.partition(".")[0] in _KEPT:
        return True
    words = name.split(".")
    return any(".".join(words[:count]) in observed for count in range(len(words), 0, -1))
