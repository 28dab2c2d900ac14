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
    """What a recovery file holds: the unsaved documents of one project, as their files' text.

    gone: files that were taken away, and lie in the folder until the project is saved, with what
    ``FolderWatch.was`` says of them.
    """

    root: str
    at: datetime
    files: dict[str, str]
    gone: dict[str, bytes] = {}


class Wanted(msgspec.Struct, frozen=True):
    """What shall be kept in ``file``. values: the unsaved documents, by their files. gone: as in
    ``Kept``.
    """

    file: Path
    root: str
    at: datetime
    values: dict[str, Written]
    gone: dict[str, bytes]

    def is_like(self, other: Wanted) -> bool:
        """Whether the very same documents are kept in both."""
        return (
            self.gone == other.gone
            and self.values.keys() == other.values.keys()
            and all(value is other.values[file] for file, value in self.values.items())
        )


def write(wanted: Wanted) -> None:
    """Writes the file: the old one stays until the new one is there whole. Raises UsageError."""
    kept = Kept(wanted.root, wanted.at, _texts(wanted.values), wanted.gone)
    folder.write(wanted.file, msgspec.json.encode(kept))


def _texts(values: Mapping[str, Written]) -> dict[str, str]:
    return {file: edit.write(value).decode() for file, value in values.items()}


def read(file: Path) -> Kept | None:
    """What was kept in ``file``; None where that can not be read."""
    try:
        return msgspec.json.decode(file.read_bytes(), type=Kept)
    except (OSError, msgspec.MsgspecError):
        return None
