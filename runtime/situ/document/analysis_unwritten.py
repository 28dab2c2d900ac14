"""Data that nobody writes, and modules that nobody provides.

What is claimed, for a whole project: a name that is tested, shown, spoken or sent is *unwritten*
where nothing in the project writes its tag, or a tag that begins it: no action, component,
result, setting, ``[tags]``, ``[mqtt]``, no module by what it provides, not the runtime. ``clear``
is no writer: what was never there stays missing. Whether the state that writes is ever reached
is not asked.

Without module information nobody knows what modules write: what a script observes then counts as
written, and a script's own tests are not judged. Where a document could not be read, nothing is
said.
"""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches

from situ.document import words
from situ.document.analysis_data import BOARD, Use, placed_actions, tested, uses
from situ.document.analysis_search import Search
from situ.document.finding import Place
from situ.document.mend import of, written
from situ.document.modules import Module, Modules
from situ.document.place import follow
from situ.document.problem import Change, Mend
from situ.document.project import Project
from situ.document.rbd import Application, Service
from situ.document.spds import Declaration, Observed, Spds

MOST = 300
"""Names among which one that is nearly right is looked for."""


def search_unwritten(search: Search) -> None:
    """Tells of data that nobody writes and of modules that nobody provides."""
    project = search.project
    if not search.whole or not is_read(project):
        return
    for file, application in project.flows.items():
        search.go_on()
        _data(search, file, uses(application))
        if search.data.asks_modules:
            _services(search, file, application)
    if project.modules is not None and project.modules_file is not None:
        if project.spds is not None and project.spds_file is not None:
            _data(search, project.spds_file, _looked_at(project.spds))
        _required(search, project.modules_file, project.modules)


def is_read(project: Project) -> bool:
    """Whether all documents that are named could be read; of applications, the parts."""
    return (
        (project.spds_file is None or project.spds is not None)
        and (project.modules_file is None or project.modules is not None)
        and all(
            state.flow is None or project.flow(state.flow) is not None
            for application in project.flows.values()
            for state in application.states
        )
    )


def _looked_at(script: Spds) -> Iterator[Use]:
    for observed in script.observe:
        yield observed.tag, observed.aside, ("data", observed.tag)
    for situation in script.situations:
        for word, condition in (("condition", situation.condition), ("until", situation.until)):
            if condition is not None:
                for test, place in tested(condition, ("situation", situation.name, word)):
                    yield test.tag, test.aside, place


def _data(search: Search, file: str, used: Iterator[Use]) -> None:
    """Each name is told once a file, where it is used first."""
    data, knows = search.data, search.project.modules is not None
    found: dict[str, list[Use]] = {}
    for use in used:
        name = use[0]
        if name in found:
            found[name].append(use)
        elif not data.is_written(name) and (knows or not data.is_observed(name)):
            found[name] = [use]
    for name, several in found.items():
        _, aside, place = several[0]
        near = _near(name, search.data.written)
        more = f" (used {len(several)} times here)" if len(several) > 1 else ""
        if near is not None:
            do = f"did you mean {words.quoted(near)}?"
            mend = _other_name(search, file, place, name, near)
        else:
            do = (
                "correct the name, write it by an action, a component or [tags], or say in the "
                "module information who provides it"
            )
            mend = _observe(search, name)
            if mend is not None:
                do += ", or observe it in the script"
        message = f"Nobody writes {words.quoted(name)}{more}, so it never has a value: {do}"
        search.warn(file, "unwritten-data", message, aside, place, mend)


def _near(name: str, known: set[str]) -> str | None:
    """The name that was probably meant; among very many it is not looked for."""
    if len(known) > MOST:
        return None
    found = get_close_matches(name, sorted(known), n=1, cutoff=0.8)
    return found[0] if found else None


def _other_name(search: Search, file: str, place: Place, name: str, near: str) -> Mend | None:
    """The name that was meant, wherever what stands at the place has the other."""
    way = follow(of(search.project, file), place)
    if way is None:
        return None
    value, changes = way[1][-1], []
    for field in value.__struct_fields__:
        held = getattr(value, field)
        if not isinstance(held, str) or field in ("id", "name", "no"):
            continue
        text = held.replace(f"{{{name}}}", f"{{{near}}}")
        if held == name and field in ("tag", "items", "source"):
            text = near
        if text != held:
            changes.append(search.put(file, place, field, text))
    said = f"Read {words.quoted(near)} instead"
    return search.mend(file, said, *changes) if changes else None


def _observe(search: Search, name: str) -> Mend | None:
    """Without module information, what modules write can be observed."""
    script, file = search.project.spds, search.project.spds_file
    if script is None or file is None or search.project.modules is not None or "/" in name:
        return None
    change = Change(("observe", len(script.observe)), "insert", written(Observed(name)))
    return search.mend(file, f"Observe {words.quoted(name)}: a module writes it", change)


# -- modules ---------------------------------------------------------------------


def _known(project: Project) -> set[str]:
    return {*project.declared(), *(one.name for one in project.applications.values())}


def _declare(search: Search, name: str) -> Mend | None:
    """A module that asks for no resource: in the module information, else in the script.

    What it moves is not known; for a service to be answered it need not move anything.
    """
    project, said = search.project, f"Declare {words.quoted(name)}"
    if project.modules is not None and project.modules_file is not None:
        at = ("modules", len(project.modules.modules))
        made = Change(at, "insert", written(Module(name)))
        return search.mend(project.modules_file, said, made)
    if project.spds is not None and project.spds_file is not None:
        at = ("modules", len(project.spds.modules))
        made = Change(at, "insert", written(Declaration(name)))
        return search.mend(project.spds_file, said, made)
    return None


def _services(search: Search, file: str, application: Application) -> None:
    known = _known(search.project)
    for action, place in placed_actions(application):
        if not isinstance(action, Service) or not action.url.lower().startswith(BOARD):
            continue
        name, _, request = action.url[len(BOARD) :].partition("/")
        if not name or "{" in name or name in known:
            continue
        near = _near(name, known)
        do, mend = "declare it in the module information", _declare(search, name)
        if search.project.modules is None:
            do = "declare it in the script, or in the module information"
        if near is not None:
            do = f"did you mean {words.quoted(near)}?"
            change = search.put(file, place, "url", f"{action.url[: len(BOARD)]}{near}/{request}")
            mend = search.mend(file, f"Ask {words.quoted(near)} instead", change)
        message = f"No module {words.quoted(name)} is declared, so this service always fails: {do}"
        search.warn(file, "unprovided-module", message, action.aside, place, mend)


def _required(search: Search, file: str, modules: Modules) -> None:
    known, data = _known(search.project), search.data
    for module in modules.modules:
        for index, one in enumerate(module.requires):
            place = ("module", module.name, "requires", str(index))
            who = words.quoted(module.name)
            mend: Mend | None = None
            if one.data is not None and not data.is_written(one.data):
                near = _near(one.data, data.written)
                do = "let the module that writes it provide it"
                if near is not None:
                    do = f"did you mean {words.quoted(near)}?"
                    change = search.put(file, place, "data", near)
                    mend = search.mend(file, f"Require {words.quoted(near)} instead", change)
                message = f"{who} requires {words.quoted(one.data)}, which nobody writes: {do}"
                search.warn(file, "unwritten-data", message, one.aside, place, mend)
            elif one.module is not None and one.module not in known:
                near = _near(one.module, known)
                do = "declare it here"
                if near is not None:
                    do = f"did you mean {words.quoted(near)}?"
                    change = search.put(file, place, "module", near)
                    mend = search.mend(file, f"Require {words.quoted(near)} instead", change)
                message = (
                    f"{who} requires the module {words.quoted(one.module)}, "
                    f"which nobody declares: {do}"
                )
                search.warn(file, "unprovided-module", message, one.aside, place, mend)
