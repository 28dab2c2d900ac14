"""A project that can be run: read, checked, without errors."""

from __future__ import annotations

from pathlib import Path

from situ.document.check import check
from situ.document.folder import load
from situ.document.project import Project
from situ.errors import ProjectError


def load_ready(path: str | Path) -> Project:
    """The project at ``path``. Raises ProjectError with its errors, one a line, where it has
    any, and UsageError where it can not be read.
    """
    project, problems = load(path)
    if project is not None:
        problems = [*problems, *(p for p in check(project) if p not in problems)]
    errors = [str(p) for p in problems if p.severity == "error"]
    if project is None or errors:
        raise ProjectError("\n".join(errors) or f"{path}: not a project that can be read")
    return project
