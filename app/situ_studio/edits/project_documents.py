"""The documents of a project by their files, and the project with one more, other or less."""

from __future__ import annotations

from msgspec.structs import replace

from situ.document.modules import Modules
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.edits.edit import Document


def files(project: Project) -> list[str]:
    """The files of all documents: applications in their order, their parts, script, modules."""
    found = [*project.applications, *project.parts]
    if project.spds_file is not None and project.spds is not None:
        found.append(project.spds_file)
    if project.modules_file is not None and project.modules is not None:
        found.append(project.modules_file)
    return found


def document(project: Project, file: str) -> Document | None:
    """The document of a file; None for a file that the project does not have."""
    if file in project.applications:
        return project.applications[file]
    if file in project.parts:
        return project.parts[file]
    if file == project.spds_file:
        return project.spds
    return project.modules if file == project.modules_file else None


def exchanged(project: Project, file: str, document: Document) -> Project:
    """The project with another document in a file that it has."""
    if isinstance(document, Application):
        kind = "parts" if file in project.parts else "applications"
        return replace(project, **{kind: {**getattr(project, kind), file: document}})
    if isinstance(document, Spds):
        return replace(project, spds=document)
    return replace(project, modules=document)


def added(project: Project, file: str, document: Document) -> Project:
    """The project with a file more: a script becomes its script, module information its own, an
    application a part of it.
    """
    if isinstance(document, Spds):
        return replace(project, spds=document, spds_file=file)
    if isinstance(document, Modules):
        return replace(project, modules=document, modules_file=file)
    return replace(project, parts={**project.parts, file: document})


def without(project: Project, file: str) -> Project:
    """The project without the script, module information, application or part of that file."""
    if file == project.spds_file:
        return replace(project, spds=None, spds_file=None)
    if file == project.modules_file:
        return replace(project, modules=None, modules_file=None)
    for kind in ("applications", "parts"):
        left = {f: a for f, a in getattr(project, kind).items() if f != file}
        project = replace(project, **{kind: left})
    return project
