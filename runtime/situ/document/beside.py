"""The files of a project beside its documents, as values: ``situ.toml``, ``robot.local.toml`` and
``texts/LANG.po`` (formats.md, *A project*). What they say of the project is settled from here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath

from msgspec import Struct
from msgspec.structs import replace

from situ.document import catalogue
from situ.document.catalogue import Catalogue
from situ.document.change import Change
from situ.document.diff_project import compare_projects
from situ.document.folder import LOCAL_FILE, PROJECT_FILE, TEXTS_FOLDER, called, resolve, settings
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.projectfile import ProjectFile
from situ.document.rbd import Application


class Toml(Struct, frozen=True):
    """``situ.toml`` or ``robot.local.toml``, letter for letter: comments count too."""

    text: str


Beside = Toml | Catalogue


def texts_file(language: str) -> str:
    """The file with a language's texts."""
    return f"{TEXTS_FOLDER}/{language}.po"


def language_of(file: str) -> str | None:
    """The language of a file of texts; None where it is none."""
    path = PurePosixPath(file)
    return path.stem if str(path.parent) == TEXTS_FOLDER and path.suffix == ".po" else None


def is_beside(file: str) -> bool:
    """Whether a path in a project is one of these files."""
    return file in (PROJECT_FILE, LOCAL_FILE) or language_of(file) is not None


def files(project: Project) -> list[str]:
    """The files that say what a project consists of, whether they are there or not; a single
    document has none.
    """
    if project.toml is None:
        return []
    return [PROJECT_FILE, LOCAL_FILE, *map(texts_file, project.languages)]


def read(data: bytes, file: str) -> tuple[Beside | None, list[Problem]]:
    """The value of a file; None, and why, where it can not be read at all."""
    if language_of(file) is not None:
        return catalogue.read(data, file)
    found = ProjectFile(data, file, local=PurePosixPath(file).name == LOCAL_FILE)
    return (Toml(data.decode()), []) if found.tables is not None else (None, found.problems)


def write(value: Beside) -> bytes:
    """The bytes of its file."""
    return value.text.encode() if isinstance(value, Toml) else catalogue.write(value)


def settled(project: Project, values: Mapping[str, Beside]) -> Project:
    """The project with what these files, by their paths, say of it; its documents stay.

    Applications take the order in which ``situ.toml`` names them.
    """
    toml, local = values.get(PROJECT_FILE), values.get(LOCAL_FILE)
    if isinstance(toml, Toml):
        found = _file(project, PROJECT_FILE, toml)
        laid_over = _file(project, LOCAL_FILE, local) if isinstance(local, Toml) else None
        order = [f for f in found.get("project", "applications") or () if f in project.applications]
        project = replace(
            project,
            applications={
                file: project.applications[file]
                for file in dict.fromkeys((*order, *project.applications))
            },
            media=_inside(project, found.get("project", "media")),
            scenarios=_inside(project, found.get("project", "scenarios")),
            **settings(project.root, found, laid_over),
        )
    texts, readings = {}, {}
    for language in project.languages:
        value = values.get(texts_file(language))
        if isinstance(value, Catalogue):
            texts[language] = value.used
            if words := value.readings:
                readings[language] = words
    return replace(project, texts=texts, readings=readings)


def problems(project: Project, file: str, value: Beside) -> list[Problem]:
    """What is wrong in a file by itself, and of the applications that it names."""
    if not isinstance(value, Toml):
        return []
    found = _file(project, file, value)
    seen: set[str] = set()
    for named in found.get("project", "applications") or ():
        if named in seen:
            found.twice(named)
        elif named not in project.applications:
            found.missing("applications", named)
        seen.add(named)
    return found.problems


def grouped(
    project: Project, value: Toml, known: Mapping[str, Application]
) -> tuple[Project, dict[str, Application]]:
    """The project with the applications that ``situ.toml`` names, of its own flows and of others
    that are ``known``; and those that it has no more.

    One that is named no more stays as a part where a flow leads to it.
    """
    every = {**known, **project.flows}
    found = {file: every[file] for file in applications(value) if file in every}
    parts = {file: one for file, one in project.parts.items() if file not in found}
    gone = {file: one for file, one in project.applications.items() if file not in found}
    waiting = [*found.values(), *parts.values()]
    while waiting:
        for state in waiting.pop().states:
            if state.flow in gone:
                parts[state.flow] = gone.pop(state.flow)
                waiting.append(parts[state.flow])
    return replace(project, applications=found, parts=parts), gone


def compare(project: Project, file: str, before: Beside, after: Beside) -> list[Change]:
    """What changed in one file of a project, in words."""
    # What a robot's own file lays over is the same in both.
    under: dict[str, Beside] = {PROJECT_FILE: Toml("")} if file == LOCAL_FILE else {}
    first, then = (settled(project, {**under, file: value}) for value in (before, after))
    found = compare_projects(first, then)
    if found or before == after:
        return found
    said = "comments or layout" if isinstance(after, Toml) else "notes, or what is not used"
    return [Change(file=file, place=(), text=said, behaviour=False)]


def applications(value: Toml) -> Sequence[str]:
    """The applications that ``situ.toml`` names, in their order, each once or more."""
    return ProjectFile(value.text.encode(), PROJECT_FILE).get("project", "applications") or ()


def _inside(project: Project, path: str | None) -> str | None:
    return path if path is not None and resolve(project.root, path) is not None else None


def _file(project: Project, file: str, value: Toml) -> ProjectFile:
    return ProjectFile(value.text.encode(), called(project.root, file), local=file == LOCAL_FILE)
