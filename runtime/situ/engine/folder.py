"""The folder in which a robot keeps its state, for one core at a time (architecture, *On disk*)."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path

from situ.document.project import Project
from situ.errors import UsageError

LOCK = "lock"


class StateFolder:
    """The folder, made where there is none; ``path`` is this process's alone until ``close``.

    The system gives it free when the process dies, however it does. Raises UsageError where
    another core has it, or where nothing can be written there.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            path.mkdir(parents=True, exist_ok=True, mode=0o700)
            self._lock = os.open(path / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        except OSError as error:
            raise UsageError(
                f"{path}: the robot's state can not be kept there ({error.strerror}); "
                "give another folder with --state"
            ) from None
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            os.close(self._lock)
            raise UsageError(
                f"{path}: another situ run keeps its state there; end it, "
                "or give another folder with --state"
            ) from None

    def close(self) -> None:
        os.close(self._lock)


def state_folder(given: Path | None, project: Project) -> Path:
    """Where a robot that runs the project keeps its state: as given, else as its system says."""
    if given is not None:
        return given
    if os.environ.get("STATE_DIRECTORY"):
        return Path(os.environ["STATE_DIRECTORY"].split(":")[0])
    home = os.environ.get("XDG_STATE_HOME")
    base = Path(home) if home else Path.home() / ".local" / "state"
    return base / "situ" / project.name
