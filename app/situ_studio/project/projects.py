"""Projects that the studio makes: new ones from templates, and copies of the examples."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path

from situ.document.beginning import ENGLISH, begin, languages
from situ.document.project import Project
from situ.errors import UsageError
from situ.resources import example, template
from situ_studio.wording.language import tr


def new_project(parent: Path, name: str, kind: str = "empty", language: str = ENGLISH) -> Path:
    """Makes the folder ``name`` in ``parent`` from the template ``kind``, written in ``language``,
    or in English where the template has no texts in it.

    Raises UsageError where the name is none, the folder holds anything, or can not be made.
    """
    target = parent / name
    source = template(kind)
    begin(source, target, name, language if language in languages(source) else ENGLISH)
    return target


def copy_example(name: str, parent: Path) -> Path:
    """Copies an example into ``parent``, under a name that is free there; its folder.

    Raises UsageError where there is no such example, or it can not be copied.
    """
    return _copied(example(name), _free(parent / name))


def copy_project(project: Project, texts: Mapping[str, bytes], parent: Path) -> Path:
    """Copies the folder of a project into ``parent``, under a name that is free there; its folder.

    texts: the files beside its documents, for where its folder is gone. Raises UsageError where
    it can not be copied.
    """
    source = Path(project.root).resolve()
    target = _free(parent / source.name)
    if target.is_relative_to(source):
        raise UsageError(tr("{0} is inside the project itself: name another folder").format(target))
    if project.toml is not None and source.is_dir():
        return _copied(source, target)
    try:
        target.mkdir(parents=True)
        for file, data in texts.items():
            (target / file).parent.mkdir(exist_ok=True)
            (target / file).write_bytes(data)
    except OSError as error:
        raise UsageError(f"{target}: can not be made: {error.strerror or error}") from error
    return target


def _free(target: Path) -> Path:
    name, number = target.name, 2
    while target.exists():
        target, number = target.with_name(f"{name}-{number}"), number + 1
    return target


def _copied(source: Path, target: Path) -> Path:
    try:
        shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__", ".*"))
        for file in (target, *target.rglob("*")):
            # A copy of what can only be read is there to be changed.
            file.chmod(file.stat().st_mode | 0o200)
    except (OSError, shutil.Error) as error:
        raise UsageError(f"{target}: can not be made: {error}") from error
    return target
