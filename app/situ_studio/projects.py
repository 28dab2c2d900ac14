"""Projects that the studio makes: new ones from templates, and copies of the examples."""

from __future__ import annotations

import shutil
from pathlib import Path

from situ.document.beginning import begin
from situ.errors import UsageError
from situ.resources import example, template


def new_project(parent: Path, name: str, kind: str = "empty") -> Path:
    """Makes the folder ``name`` in ``parent`` from the template ``kind``.

    Raises UsageError where the name is none, the folder holds anything, or can not be made.
    """
    target = parent / name
    begin(template(kind), target, name)
    return target


def copy_example(name: str, parent: Path) -> Path:
    """Copies an example into ``parent``, under a name that is free there; its folder.

    Raises UsageError where there is no such example, or it can not be copied.
    """
    source = example(name)
    target, number = parent / name, 2
    while target.exists():
        target, number = parent / f"{name}-{number}", number + 1
    try:
        shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__", ".*"))
    except (OSError, shutil.Error) as error:
        raise UsageError(f"{target}: can not be made: {error}") from error
    return target
