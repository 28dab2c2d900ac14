"""That a project is open here, as other Situ Studios on the machine see it."""

from __future__ import annotations

import hashlib
from pathlib import Path

from PySide6.QtCore import QLockFile


def key(root: Path) -> str:
    """What files about a project are called that do not lie in it."""
    return hashlib.sha256(str(root.resolve()).encode()).hexdigest()[:16]


def lock(file: Path) -> QLockFile:
    """The lock beside ``file``. It is stale when its process is gone, however long that runs."""
    made = QLockFile(f"{file}.lock")
    made.setStaleLockTime(0)
    return made


class Claim:
    """One window's; ``home``: a folder that all the user's studios share."""

    def __init__(self, home: Path) -> None:
        self._home = home
        self._lock: QLockFile | None = None

    def take(self, root: Path) -> bool:
        """Whether no other studio has the project open; what was claimed before is let go."""
        self.release()
        try:
            self._home.mkdir(parents=True, exist_ok=True)
        except OSError:
            return True
        wanted = lock(self._home / key(root))
        if wanted.tryLock(0):
            self._lock = wanted
            return True
        return wanted.error() != QLockFile.LockError.LockFailedError

    def release(self) -> None:
        if self._lock is not None:
            self._lock.unlock()
            self._lock = None
