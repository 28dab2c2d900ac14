"""A project that can be run: read, checked, without errors."""

from __future__ import annotations

from pathlib import Path

from situ.document.check import merge, structure
from situ.document.folder import load
from situ.document.project import Project
from situ.errors import ProjectError


def load_ready(path: str | Path) -> Project:
    """The project at ``path``. Raises ProjectError with the first of its errors where it has
    any, and UsageError where it can not be read.
    """
    project, problems = load(path)
    if project is not None:
        problems = merge(problems, structure(project))
    errors = [str(p) for p in problems if p.severity == "error"]
    if project is None or errors:
        first = errors[0] if errors else f"{path}: not a project that can be read"
        more = f" (and {len(errors) - 1} more: situ check {path})" if len(errors) > 1 else ""
        raise ProjectError(first + more)
    return project
