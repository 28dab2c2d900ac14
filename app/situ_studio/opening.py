"""Reading a large project beside the window, which stays as it is until the project is there."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal

from situ.document import folder
from situ.document.problem import Problem
from situ.document.project import Project
from situ.errors import SituError
from situ_studio.language import tr

if TYPE_CHECKING:
    from situ_studio.window import MainWindow

LARGE = 500_000
"""Bytes of documents from which on a project is read in a thread."""

NAME = "reading a project"
"""What the threads that read are called."""

Found = tuple[Project | None, list[Problem]]


def is_large(path: Path) -> bool:
    """Whether reading the project there would hold up the window."""
    root = path if path.is_dir() else path.parent
    try:
        return sum(file.stat().st_size for file in root.glob("**/*.xml")) > LARGE
    except OSError:
        return False


class Opening(QObject):
    """Reads one project at a time; what was begun before is given up."""

    read = Signal(object)
    """What ``folder.load`` gives."""
    refused = Signal(str)
    """There is none: why, in one line."""
    _done = Signal(int, object)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._turn = 0
        self._done.connect(self._on_done, Qt.ConnectionType.QueuedConnection)

    def start(self, path: Path) -> None:
        self._turn += 1
        work = threading.Thread(target=self._work, args=(self._turn, path), name=NAME, daemon=True)
        work.start()

    def cancel(self) -> None:
        """Nobody is told of what was begun: its thread ends by itself, and is not heard."""
        self._turn += 1

    def _work(self, turn: int, path: Path) -> None:
        found: Found | Exception
        try:
            found = folder.load(path)
        except Exception as error:
            # Whatever it is, the window's thread hears of it: there the fault is raised and told.
            found = error
        # The window may have been closed meanwhile: then there is nobody to tell.
        try:
            self._done.emit(turn, found)
        except RuntimeError:
            return

    def _on_done(self, turn: int, found: Found | Exception) -> None:
        if turn != self._turn:
            return
        if isinstance(found, SituError):
            self.refused.emit(str(found))
        elif isinstance(found, Exception):
            self.refused.emit("")
            raise found
        else:
            self.read.emit(found)


class Reading(QObject):
    """A project that is read beside a window and opened there; its strip shows it, with *Cancel*.

    refused: gets the window, and why it can not be opened, in one line; "" where a fault was told
    already.
    """

    def __init__(
        self, window: MainWindow, path: Path, refused: Callable[[MainWindow, str], object]
    ) -> None:
        super().__init__(window)
        self._path, self._refused = path, refused
        self._opening = Opening(self)
        self._opening.read.connect(self._on_read)
        self._opening.refused.connect(self._on_refused)
        self._show_in(window)
        self._opening.start(path)

    def move_to(self, window: MainWindow) -> None:
        """Goes on for a window that stands in place of the one before."""
        self._work.ended.disconnect(self.deleteLater)
        self._work.end()
        self.setParent(window)
        self._show_in(window)

    def _show_in(self, window: MainWindow) -> None:
        self._window = window
        words = tr("Reading {0}").format(self._path.name)
        self._work = window.status.work.begin(words, self._opening.cancel)
        self._work.ended.connect(self.deleteLater)

    def _on_read(self, found: Found) -> None:
        self._work.end()
        # Somebody may have gone on with the one that is still open.
        if not self._window.may_leave():
            return
        try:
            self._window.take_project(found, self._path)
        except (SituError, OSError) as error:
            self._refused(self._window, str(error))

    def _on_refused(self, why: str) -> None:
        self._work.end()
        self._refused(self._window, why)
