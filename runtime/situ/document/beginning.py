"""A project to start from: a template of ``resources/templates``, under a name of its own.

A template is a whole project that is called ``newproject``, in its files and in their names.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
import unicodedata
from pathlib import Path

from situ.document.folder import load
from situ.errors import UsageError

PLACEHOLDER = "newproject"

_NAME = re.compile(r"[a-z][a-z0-9_-]*")


def project_name(title: str) -> str:
    """A project's name for what a person typed: ``robot-nurse-2`` for ``Robot nurse 2``.

    What they typed itself where nothing in it fits into a name.
    """
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode().lower()
    made = re.sub(r"[^a-z0-9_]+", "-", plain).strip("-_")
    made = re.sub(r"^[^a-z]+", "", made)
    return made or title


def begin(template: Path, target: Path, name: str) -> None:
    """Makes the folder ``target`` from a template; its application is called ``name``.

    All of it, or nothing. Raises UsageError where the name is none or is that of a module of the
    template, where the folder holds anything, and where it can not be made.
    """
    if not _NAME.fullmatch(name):
        raise UsageError(
            f"{name!r} is no name for a project: use small letters, digits, - and _, a letter first"
        )
    if name in _modules(template):
        raise UsageError(f"{name} is a module of this template: give the project another name")
    try:
        if os.path.lexists(target) and (not target.is_dir() or any(target.iterdir())):
            raise UsageError(f"{target}: is there already and not empty; name a new folder")
        parent = target.absolute().parent
        parent.mkdir(parents=True, exist_ok=True)
        whole = Path(tempfile.mkdtemp(prefix=".new.", dir=parent))
        try:
            _copy(template, whole, name)
            target.mkdir(exist_ok=True)
            # The folder itself stays: somebody may be working in it.
            for entry in whole.iterdir():
                entry.rename(target / entry.name)
        finally:
            shutil.rmtree(whole)
    except OSError as error:
        raise UsageError(f"{target}: can not be made: {error.strerror or error}") from error


def _copy(template: Path, target: Path, name: str) -> None:
    for file in sorted(one for one in template.rglob("*") if one.is_file()):
        place = target / str(file.relative_to(template)).replace(PLACEHOLDER, name)
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(file.read_bytes().replace(PLACEHOLDER.encode(), name.encode()))


def _modules(template: Path) -> set[str]:
    project, _ = load(template)
    declared = [] if project is None else [project.spds, project.modules]
    return {one.name for part in declared if part is not None for one in part.modules}
