"""Bookmarks: moments of a run with a name, kept in a file beside its recording."""

from __future__ import annotations

from pathlib import Path

import msgspec
from msgspec import Struct
from PySide6.QtCore import QObject, Signal

from situ.document import folder
from situ.errors import UsageError
from situ_studio.wording.language import tr

ENDING = ".bookmarks.json"


class Bookmark(Struct, frozen=True, order=True):
    """t: seconds of the trace."""

    t: float
    name: str


def beside(recording: Path) -> Path:
    """The file with a recording's bookmarks."""
    return recording.with_name(recording.name + ENDING)


class Bookmarks(QObject):
    """Those of one run, in order of time. Without a file they last as long as it is looked at."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.every: list[Bookmark] = []
        self._file: Path | None = None

    def open(self, file: Path | None) -> None:
        """Another run's; there need be no file yet.

        Raises UsageError where it can not be read; then it stays as it is, whatever is added.
        """
        self.every, self._file = [], None
        try:
            if file is not None and file.exists():
                self.every = sorted(msgspec.json.decode(file.read_bytes(), type=list[Bookmark]))
            self._file = file
        except (OSError, msgspec.MsgspecError) as error:
            raise UsageError(tr("{0}: no bookmarks can be read: {1}").format(file, error)) from None
        finally:
            self.changed.emit()

    def take(self, other: Bookmarks) -> None:
        """Those of the same run, as another one has them."""
        self.every, self._file = list(other.every), other._file
        self.changed.emit()

    def add(self, t: float, name: str) -> None:
        """In place of one at the same moment. Raises UsageError where it can not be kept."""
        self._set([*(mark for mark in self.every if mark.t != t), Bookmark(t, name)])

    def remove(self, mark: Bookmark) -> None:
        """Raises UsageError where that can not be kept."""
        self._set([one for one in self.every if one != mark])

    def after(self, t: float) -> Bookmark | None:
        return next((mark for mark in self.every if mark.t > t), None)

    def before(self, t: float) -> Bookmark | None:
        return next((mark for mark in reversed(self.every) if mark.t < t), None)

    def at(self, t: float) -> Bookmark | None:
        return next((mark for mark in self.every if mark.t == t), None)

    def _set(self, every: list[Bookmark]) -> None:
        self.every = sorted(every)
        self.changed.emit()
        if self._file is not None:
            folder.write(self._file, msgspec.json.format(msgspec.json.encode(self.every)))
