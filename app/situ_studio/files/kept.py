"""The files in which unsaved changes are kept: what they hold, and how they are written."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from pathlib import Path

import msgspec

from situ.document import folder
from situ_studio.edits import edit
from situ_studio.edits.edit import Written


class Kept(msgspec.Struct, frozen=True):
    """What a recovery file holds: the unsaved documents of one project, as their files' text; None
    of one that was taken away, and lies in the folder until the project is saved.
    """

    root: str
    at: datetime
    files: dict[str, str | None]


class Wanted(msgspec.Struct, frozen=True):
    """What shall be kept in ``file``. values: the unsaved documents, by their files; None of one
    that was taken away.
    """

    file: Path
    root: str
    at: datetime
    values: dict[str, Written | None]


def write(wanted: Wanted) -> None:
    """Writes the file: the old one stays until the new one is there whole. Raises UsageError."""
    kept = Kept(wanted.root, wanted.at, _texts(wanted.values))
    folder.write(wanted.file, msgspec.json.encode(kept))


def _texts(values: Mapping[str, Written | None]) -> dict[str, str | None]:
    return {
        file: edit.write(value).decode() if value is not None else None
        for file, value in values.items()
    }


def read(file: Path) -> Kept | None:
    """What was kept in ``file``; None where that can not be read."""
    try:
        return msgspec.json.decode(file.read_bytes(), type=Kept)
    except (OSError, msgspec.MsgspecError):
        return None
