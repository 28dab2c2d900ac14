"""A script for a project that has none: what happens then is what happened before."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from situ.document.beside import Toml
from situ.document.check_application import to_declare
from situ.document.check_script import DEFAULT
from situ.document.folder import PROJECT_FILE
from situ.document.project import Project
from situ.document.spds import Declaration, Entry, Situation, Spds
from situ.document.toml_writing import put
from situ_studio.edits.edit import Written

END = ".spds.xml"
USUAL = 1
"""The priority of an application where there is no script (formats.md, *SPDS*)."""


def can_begin(project: Project) -> bool:
    """Whether there is no script yet, and a project file that can name one."""
    return project.toml is not None and project.spds_file is None


def taken(root: Path, files: Iterable[str]) -> frozenset[str]:
    """Names that no new file may have: of what lies in the project's folder, and of ``files``, of
    which some are not saved yet.
    """
    there = root.iterdir() if root.is_dir() else ()
    return frozenset(files) | {file.name for file in there}


def begun(project: Project, toml: Toml, there: frozenset[str]) -> dict[str, Written]:
    """The files that change, each with what is in it then: the script first, and ``situ.toml``.

    Every application is a module of the script, declared as ``to_declare`` says, and has in its
    one situation the priority that it had without a script. there: as ``taken`` gives it.
    """
    name = re.sub(r"[^a-z0-9-]+", "-", project.name.lower()).strip("-") or "script"
    file, number = f"{name}{END}", 2
    while file in there:
        file, number = f"{name}-{number}{END}", number + 1
    every = {a.name: a for a in project.applications.values()}
    modules = tuple(
        Declaration(name, to_declare(project, one))
        for name, one in every.items()
        if project.modules is None or all(m.name != name for m in project.modules.modules)
    )
    entries = tuple(Entry(name, USUAL) for name in every)
    script = Spds(project.name, modules=modules, situations=(Situation(DEFAULT, entries=entries),))
    return {file: script, PROJECT_FILE: put(toml, "project", "spds", file)}
