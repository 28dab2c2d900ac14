"""A project's folder as it was last seen here, and what other programs do to it meanwhile."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path

from PySide6.QtCore import QFileSystemWatcher, QObject, Signal

from situ.errors import UsageError


class FolderWatch(QObject):
    """Remembers what documents were when they were last read or written.

    A file counts as changed where its bytes are other ones, whatever its times say.
    """

    changed = Signal(str)
    """That document may be another on disk."""
    settings_changed = Signal()
    """What the project consists of may be another: its ``situ.toml``, a file beside it."""
    gone = Signal()
    """The folder is not there any more: renamed, removed, or its drive is away."""

    back = Signal()
    """The folder is there again."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.root = Path()
        self._was_gone = False
        self._files: list[str] = []
        self._beside: dict[str, bytes] = {}
        self._seen: dict[str, bytes] = {}
        self._watcher = QFileSystemWatcher(self)
        self._watcher.fileChanged.connect(self._on_path)
        self._watcher.directoryChanged.connect(self._on_path)

    def begin(self, root: Path, files: Iterable[str], beside: Iterable[str]) -> None:
        """Sees the documents ``files`` as they are now. beside: what is read with them."""
        self.root = root
        self._files = list(files)
        self._beside = {file: self.digest(file) for file in beside}
        self._seen = {file: self.digest(file) for file in self._files} | self._beside
        self.watch()

    def attend(self, files: Iterable[str], beside: Iterable[str]) -> None:
        """The project consists of these now; what was seen of a document before is still known."""
        self._files = list(files)
        self._beside = {file: self.digest(file) for file in beside}
        self._seen = self._beside | self._seen
        self.watch()

    def move(self, root: Path) -> None:
        """The same files lie in another folder; what is other there than it was seen is told."""
        self.root = root
        self.look()

    @property
    def is_gone(self) -> bool:
        return not self.root.is_dir()

    def read(self, file: str) -> bytes:
        """Raises UsageError where it can not be read."""
        try:
            return (self.root / file).read_bytes()
        except OSError as error:
            raise UsageError(f"{file}: cannot be read: {error.strerror or error}") from error

    def see(self, file: str) -> None:
        """What the file holds now is known here."""
        self._seen[file] = self.digest(file)
        if file in self._beside:
            self._beside[file] = self._seen[file]
        elif file not in self._files:
            self._files.append(file)
            self.watch()

    def see_new(self, file: str) -> None:
        """A document that was made here begins; it may have been here before."""
        if file not in self._seen:
            self.see(file)
        elif file not in self._files:
            self._files.append(file)
            self.watch()

    def leave(self, file: str) -> None:
        """What becomes of that document on disk is told no more; what it was is still known."""
        if file in self._files:
            self._files.remove(file)

    def forget(self, file: str) -> None:
        """The file is not there any more, by our own hand."""
        self.leave(file)
        self._seen.pop(file, None)

    def was(self, file: str) -> bytes:
        """As ``digest``, of the file as it was last seen here."""
        return self._seen.get(file, b"")

    def is_other(self, file: str) -> bool:
        """Whether the file holds something that was never seen here."""
        return self.digest(file) != self._seen.get(file)

    def is_missing(self, file: str) -> bool:
        return not (self.root / file).is_file()

    def look(self) -> None:
        """Tells everything that is not as it was seen."""
        if self.is_gone:
            self._was_gone = True
            self.gone.emit()
            return
        self.watch()
        if self._was_gone:
            self._was_gone = False
            self.back.emit()
        beside = {file: self.digest(file) for file in self._beside}
        if beside != self._beside:
            self._beside = beside
            self.settings_changed.emit()
        for file in list(self._files):
            if self.is_other(file):
                self.changed.emit(file)

    def watch(self) -> None:
        """A file that was exchanged as a whole, as we save, has dropped out of the watcher."""
        paths = (self.root / file for file in (*self._files, *self._beside))
        # That a folder itself was renamed is heard in the one above it only.
        folders = (self.root, self.root.absolute().parent)
        wanted = {str(path) for path in (*paths, *folders) if path.exists()}
        watched = {*self._watcher.files(), *self._watcher.directories()}
        if unwanted := watched - wanted:
            self._watcher.removePaths(sorted(unwanted))
        if new := wanted - watched:
            self._watcher.addPaths(sorted(new))

    def _on_path(self, path: str) -> None:
        above = str(self.root.absolute().parent)
        # Whatever it was, its neighbours may have changed with it, as in a checkout.
        if path != above or self.is_gone != self._was_gone:
            self.look()

    def digest(self, file: str) -> bytes:
        """Tells what the file holds now from all else that it could hold."""
        try:
            return hashlib.sha256((self.root / file).read_bytes()).digest()
        except OSError:
            return b""
