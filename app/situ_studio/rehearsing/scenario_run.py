"""All scenarios of a project are played, one a turn of the window's loop: it stays in use."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from msgspec import Struct
from PySide6.QtCore import QObject, QTimer, Signal

from situ.document.project import Project
from situ.rehearse.coverage import Coverage
from situ.rehearse.recording import Recording
from situ.rehearse.suite import Played, play_file


class Ran(Struct, frozen=True):
    """One scenario, and what the robot did in it; None where it can not be read."""

    path: Path
    played: Played
    recording: Recording | None


class ScenarioRun(QObject):
    """Plays these files once, in order; the project must have no errors.

    unsaved: of files that hold something else than they shall, what that is.
    """

    went = Signal(float)
    """How much is done, from 0 to 1; one more is in ``ran``."""
    ended = Signal()
    """All are, or it was cancelled."""

    def __init__(
        self, project: Project, files: list[Path], unsaved: Mapping[Path, bytes], parent: QObject
    ) -> None:
        super().__init__(parent)
        self.project = project
        self.files = files
        self._unsaved = unsaved
        self.ran: list[Ran] = []
        self.coverage = Coverage(project)
        """What those of ``ran`` came through."""
        self._names = [one.name for one in project.applications.values()]
        self._turns = QTimer(self)
        self._turns.setInterval(0)
        self._turns.timeout.connect(self._play)
        self._turns.start()

    def cancel(self) -> None:
        """What has been played stays."""
        if self._turns.isActive():
            self._turns.stop()
            self.ended.emit()

    def _play(self) -> None:
        path = self.files[len(self.ran)]
        unsaved = self._unsaved.get(path)
        recording, played = play_file(self.project, path, self._names, unsaved=unsaved)
        if recording is not None:
            self.coverage.add(recording)
        self.ran.append(Ran(path, played, recording))
        self.went.emit(len(self.ran) / len(self.files))
        if len(self.ran) == len(self.files):
            self.cancel()
