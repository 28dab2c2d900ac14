"""What is wrong with a project: every error of formats.md, and what a search finds.

Each problem has a stable code, its place in the file and in the document, words that say
what to do, and where a machine can do it, a mend. docs/problems.md has every code.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from itertools import takewhile

from situ.document import projectfile
from situ.document.accept import ACCEPT
from situ.document.check_application import check_application, to_declare, used_resources
from situ.document.check_script import check_modules, check_script
from situ.document.datatypes import shown
from situ.document.finding import Disk, Files, Findings
from situ.document.folder import called
from situ.document.mend import EDITOR_FIELD, change, of, put_in
from situ.document.modules import Module
from situ.document.place import Path, follow
from situ.document.problem import Change, Mend, Problem, Severity
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Declaration, Entry, Spds
from situ.document.texts_shown import setting_texts, shown_texts

UNUSED = "accept-unused"


def check(
    project: Project, files: Files | None = None, cancel: Callable[[], bool] | None = None
) -> list[Problem]:
    """The problems of a project, file by file: ``structure``, and what the searches of
    ``situ.document.analysis`` and ``situ.document.care`` find. Never raises, but for Cancelled
    where ``cancel``, asked now and then, becomes true.

    files: the project's folder; where it lies on disk unless given. Line and column
    are those of the file on disk, 0 for a value that is in no file yet.
    """
    # Here: who only runs a project never searches, and is up sooner.
    from situ.document.analysis import analyse
    from situ.document.care import search_care

    files = files if files is not None else Disk(project.root)
    found = _structure(project, files)
    search = analyse(project, cancel)
    search_care(search)
    for file, findings in search.found.items():
        found[file].add(findings)
    _unused_accepts(project, found)
    return _told(project, files, found, search.toml)


def structure(project: Project, files: Files | None = None) -> list[Problem]:
    """The problems that need no search: all errors, and warnings about single values.

    A project in which it finds no error can be run.
    """
    files = files if files is not None else Disk(project.root)
    return _told(project, files, _structure(project, files), [])


def _structure(project: Project, files: Files) -> dict[str, Findings]:
    found: dict[str, Findings] = {}

    def of(file: str) -> Findings:
        return found.setdefault(file, Findings(project.root, file))

    for file, application in project.flows.items():
        _application(of(file), application, project, files)
    if project.spds is not None and project.spds_file is not None:
        check_script(of(project.spds_file), project.spds, project)
    if project.modules is not None and project.modules_file is not None:
        check_modules(of(project.modules_file), project.modules)
    return found


def _unused_accepts(project: Project, found: dict[str, Findings]) -> None:
    """What ``ed:accept`` names and nothing silences any more. Not told where that may only be
    because something was not looked at: in single files, with errors, undecided.
    """
    if project.toml is None or any(one.has_errors for one in found.values()):
        return
    for file, findings in found.items():
        if findings.has("undecided"):
            continue
        for place, aside, unused, used in findings.accepts.unused():
            way = follow(of(project, file), place)
            assert way is not None  # nothing stands there twice where there is no error
            was = json.dumps(aside.attribute(ACCEPT), ensure_ascii=False)
            left = json.dumps(" ".join(used) or None, ensure_ascii=False)
            out = Change((*way[0], EDITOR_FIELD + ACCEPT), "set", left, was)
            mend = Mend(file, "Take out what is accepted in vain", (out,), safe=True)
            several = ", ".join(shown(code) for code in unused) or "nothing"
            said = (
                f"ed:accept names {several} here, but there is no such warning about this or "
                "anything in it: take that out"
            )
            findings.warning(UNUSED, said, aside, place, mend)
        for place, name, aside in findings.accepts.misplaced:
            said = (
                f"ed:accept has no effect on <{name}>: put it on the element that holds it, or on "
                "one inside it"
            )
            findings.warning(UNUSED, said, aside, place)


def _told(
    project: Project,
    files: Files,
    found: dict[str, Findings],
    settings: list[tuple[str, str, str, str, str]],
) -> list[Problem]:
    told = [problem for findings in found.values() for problem in findings.problems(files)]
    return [*told, *_project(project, files, settings)]


def merge(read: Iterable[Problem], checked: Iterable[Problem]) -> list[Problem]:
    """Both, without what ``check`` says about a place of which reading already spoke."""
    first = list(read)
    places = {(p.file, p.line, p.column) for p in first}
    second = [p for p in checked if (p.file, p.line, p.column) not in places or not p.line]
    if any(problem.severity == "error" for problem in first):
        # What could not be read may be what an accepted warning is about.
        second = [problem for problem in second if problem.code != UNUSED]
    return [*first, *second]


def _application(found: Findings, application: Application, project: Project, files: Files) -> None:
    check_application(found, application, project, files)
    _circles(found, application, project)
    _languages(found, application, project)
    if found.file not in project.applications:
        return
    for file in takewhile(lambda one: one != found.file, project.applications):
        if project.applications[file].name == application.name:
            said = f"{file} has the name {shown(application.name)} too: give one of them another"
            found.error("double-application", said, application.aside)
    _authority(found, application, project)


def _authority(found: Findings, application: Application, project: Project) -> None:
    """An application is a module: it needs a priority, and its resources declared."""
    script = project.spds
    if script is not None and not any(
        entry.module == application.name and entry.priority is not None
        for situation in script.situations
        for entry in situation.entries
    ):
        said = (
            f"{project.spds_file} gives {shown(application.name)} no priority in any situation: "
            "give it one"
        )
        mend = give_priority(project, script, application)
        found.error("application-without-priority", said, application.aside, mend=mend)
    declared = project.resources(application.name)
    if declared is None:
        # Without a priority there is an error already, and with one ``undeclared-module``.
        return
    for resource, aside in used_resources(project, application).items():
        if resource not in declared and resource:
            said = (
                f"{shown(application.name)} uses {shown(resource)} here but does not declare it: "
                "add it to the resources of its module"
            )
            at = application.aside if aside.index < 0 else aside
            mend = _give_resource(project, application, resource)
            found.error("undeclared-resource", said, at, mend=mend)


def give_priority(project: Project, script: Spds, application: Application) -> Mend | None:
    """To declare an application, and give it the lowest priority of the last situation."""
    if not script.situations:
        return None
    at = len(script.situations) - 1
    last = script.situations[at]
    changes = []
    if project.resources(application.name) is None:
        declared = Declaration(application.name, to_declare(project, application))
        changes.append(put_in(("modules", len(script.modules)), declared))
    lowest = min([1, *(value - 1 for value in script.priorities(last).values())])
    entries: Path = ("situations", at, "entries", len(last.entries))
    changes.append(put_in(entries, Entry(application.name, lowest)))
    words = f"Give it the priority {lowest} in {shown(last.name)}"
    return Mend(project.spds_file or "", words, tuple(changes))


def _give_resource(project: Project, application: Application, resource: str) -> Mend:
    """To declare one resource more where the application is declared, which it is."""
    every: list[tuple[str | None, int, Declaration | Module]] = [
        *(
            (project.spds_file, at, one)
            for at, one in enumerate(project.spds.modules if project.spds else ())
        ),
        *(
            (project.modules_file, at, one)
            for at, one in enumerate(project.modules.modules if project.modules else ())
        ),
    ]
    file, at, declared = next(found for found in every if found[2].name == application.name)
    more = (*declared.resources, resource)
    made = change(("modules", at), declared, "resources", more)
    return Mend(file or "", f"Give it {shown(resource)}", (made,))


def _circles(found: Findings, application: Application, project: Project) -> None:
    for state in application.states:
        if state.flow is None:
            continue
        way = _way_back(project, state.flow, found.file)
        if way is not None:
            said = (
                f"The part {shown(state.flow)} leads back to this file "
                f"({' → '.join((found.file, *way))}), and a part cannot hold itself: let it end, "
                "and lead on from its done event"
            )
            aside = state.aside.part("flow")
            found.error("circular-parts", said, aside, ("state", state.no))


def _way_back(project: Project, start: str, end: str) -> list[str] | None:
    """The shortest way from one file to another by the parts that they hold."""
    ways = {start: [start]}
    waiting = [start]
    for file in waiting:
        if file == end:
            return ways[file]
        part = project.flow(file)
        for state in part.states if part is not None else ():
            if state.flow is not None and state.flow not in ways:
                ways[state.flow] = [*ways[file], state.flow]
                waiting.append(state.flow)
    return None


def _languages(found: Findings, application: Application, project: Project) -> None:
    for language in project.languages[1:]:
        known = project.texts.get(language)
        if known is None:
            continue
        told: set[str] = set()
        for one in shown_texts(application):
            if one.text in known or one.text in told or not one.is_to_translate:
                continue
            told.add(one.text)
            found.warning("missing-text", _untranslated(one.text, language), one.aside, one.place)


def _untranslated(text: str, language: str) -> str:
    return (
        f"No text in {language} for {shown(text)}: it stays as it is written; "
        f"translate it in the texts (texts/{language}.po)"
    )


def _project(
    project: Project, files: Files, settings: list[tuple[str, str, str, str, str]]
) -> list[Problem]:
    """What is wrong in ``situ.toml``, but for what reading it has told; ``settings``: what a
    search has found (code, message, table, key, value).
    """
    if project.toml is None:
        return []
    told: list[tuple[Severity, str, str, Path]] = [
        ("warning", code, message, _listed(project, *where)) for code, message, *where in settings
    ]
    if len(project.applications) > 1 and project.spds_file is None:
        said = (
            "Several applications need a script that says which of them comes first: begin one, "
            "and name it in the project"
        )
        told.append(("error", "spds-needed", said, ("project", "applications")))
    for at, language in enumerate(project.languages):
        if at and language not in project.texts:
            said = (
                f"There are no texts in {language} yet (texts/{language}.po), so all stay as they "
                "are written: begin them, or take the language out"
            )
            told.append(("warning", "missing-texts", said, ("project", "languages", at)))
    told += _setting_texts(project)
    if not told:
        return []
    text = (files.read(project.toml) or b"").decode(errors="replace")
    file = called(project.root, project.toml)
    made = []
    for severity, code, message, path in told:
        line, column = projectfile.place(text, *_written_at(project, path))
        made.append(
            Problem(
                file=file,
                line=line,
                column=column,
                severity=severity,
                code=code,
                message=message,
                place=tuple(map(str, path)),
            )
        )
    return made


def _setting_texts(project: Project) -> Iterator[tuple[Severity, str, str, Path]]:
    for language in project.languages[1:]:
        known = project.texts.get(language)
        told: set[str] = set()
        for one in setting_texts(project.settings):
            if known is None or one.text in known or one.text in told:
                continue
            told.add(one.text)
            yield "warning", "missing-text", _untranslated(one.text, language), one.place


def _listed(project: Project, table: str, key: str, value: str) -> Path:
    """The path of a value that stands in a list."""
    every = project.languages if key == "languages" else ()
    return (table, key, every.index(value)) if value in every else (table, key)


def _written_at(project: Project, path: Path) -> tuple[str, str, str]:
    """The table, the key and the value that stand at a path."""
    match path:
        case (str(table), str(key), int(at)):
            return table, key, project.languages[at]
        case ("setting", str(number), "label"):
            return "setting", "label", _as_written(project.settings[int(number)].label)
        case ("setting", str(number), "choices", str(choice)):
            text = project.settings[int(number)].choices[int(choice)]
            return "setting", "choices", _as_written(text)
        case _:
            return str(path[0]), str(path[1]), ""


def _as_written(text: str) -> str:
    """A text between its quotes, so that it is not found inside of another one."""
    return json.dumps(text, ensure_ascii=False)
