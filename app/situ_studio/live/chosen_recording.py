"""The recording that a window reads: how far it is stands in the status bar, where to cancel it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from situ_studio.live.recordings import ReadingRecording
from situ_studio.processes.working import OneWork
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class ChosenRecording(QObject):
    """One at a time; why one can not be read is told by the window."""

    read = Signal(object)
    """A ``Recording``, all of it."""

    def __init__(self, window: MainWindow, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._work = OneWork(self._give_up)
        self._take(ReadingRecording())

    def start(self, path: Path) -> None:
        """Begins, in place of what was begun before."""
        self._tell(path)
        self._reading.start(path)

    def cancel(self) -> None:
        """Nobody is told of what was begun."""
        self._give_up()
        self._work.end()

    def move_to(self, other: ChosenRecording) -> None:
        """What is being read is read on for a window in place of this one."""
        here, there = self._reading, other._reading
        if here.path is None:
            return
        self._leave()
        other._leave()
        self._take(there)
        other._take(here)
        other._tell(here.path)

    def _take(self, reading: ReadingRecording) -> None:
        self._reading = reading
        reading.setParent(self)
        reading.read.connect(self._on_read)
        reading.refused.connect(self._on_refused)
        reading.went_on.connect(self._work.tell)

    def _leave(self) -> None:
        """Hears of it no more, however far it is."""
        reading = self._reading
        reading.read.disconnect(self._on_read)
        reading.refused.disconnect(self._on_refused)
        reading.went_on.disconnect(self._work.tell)
        self._work.end()

    def _tell(self, path: Path) -> None:
        words = self.tr("Reading {0}").format(path.name)
        self._work.begin(self._window.status.work, words)

    def _give_up(self) -> None:
        self._reading.cancel()

    def _on_read(self, recording: object) -> None:
        self._work.end()
        self.read.emit(recording)

    def _on_refused(self, why: str) -> None:
        self._work.end()
        self._window.dialogs.tell(said(why))
