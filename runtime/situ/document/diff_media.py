"""Which images, movies and sounds of two projects differ."""

from __future__ import annotations

import filecmp
import os
from pathlib import Path

from situ.document.change import Change, Kind
from situ.document.folder import media_of
from situ.document.project import Project
from situ.errors import UsageError


def compare_media(before: Project, after: Project) -> list[Change]:
    """Files of the two media folders that came, went, or have other content.

    Reads the files where the projects lie; a single document has none. UsageError
    where one cannot be read.
    """
    if before.toml is None or after.toml is None:
        return []
    old, new = _files(before), _files(after)
    changes = []
    for name in sorted(old.keys() | new.keys()):
        if name not in new:
            changes.append(_change(name, before, "gone", "gone"))
        elif name not in old:
            changes.append(_change(name, after, "added", "new"))
        elif not _same(old[name], new[name]):
            changes.append(_change(name, after, "has other content", "changed"))
    return changes


def _change(name: str, project: Project, what: str, kind: Kind) -> Change:
    file = f"{project.media}/{name}"
    return Change(file=file, place=(), text=f"media {name} {what}", kind=kind)


def _files(project: Project) -> dict[str, Path]:
    folder = media_of(project)
    if folder is None:
        return {}
    found = {}
    for where, _, names in os.walk(folder):
        for name in names:
            path = Path(where, name)
            found[path.relative_to(folder).as_posix()] = path
    return found


def _same(old: Path, new: Path) -> bool:
    try:
        return filecmp.cmp(old, new, shallow=False)
    except OSError as error:
        raise UsageError(f"{error.filename or new}: cannot be read: {error.strerror}") from error
