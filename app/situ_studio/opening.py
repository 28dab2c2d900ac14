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


def read_into(window: MainWindow, path: Path, refused: Callable[[str], object]) -> None:
    """Reads a project beside ``window`` and opens it there; its strip shows it, with *Cancel*.

    refused: gets why it can not be opened, in one line; "" where a fault was told already.
    """
    opening = Opening(window)
    work = window.status.work.begin(tr("Reading {0}").format(path.name), opening.cancel)
    work.ended.connect(opening.deleteLater)

    def on_read(found: Found) -> None:
        work.end()
        # Somebody may have gone on with the one that is still open.
        if not window.may_leave():
            return
        try:
            window.take_project(found, path)
        except (SituError, OSError) as error:
            refused(str(error))

    def on_refused(why: str) -> None:
        work.end()
        refused(why)

    opening.read.connect(on_read)
    opening.refused.connect(on_refused)
    opening.start(path)
