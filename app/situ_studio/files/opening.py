"""Reading a large project beside the window, which stays as it is until the project is there."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from queue import SimpleQueue
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from situ.document import folder
from situ.document.problem import Problem
from situ.document.project import Project
from situ.errors import SituError
from situ_studio.wording.language import said, tr

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

LARGE = 500_000
"""Bytes of documents from which on a project is read in a thread."""

NAME = "reading a project"
"""What the threads that read are called."""
LOOKS = 20
"""Milliseconds between two looks at whether a project has been read."""

Found = tuple[Project | None, list[Problem]]


def is_large(path: Path) -> bool:
    """Whether reading the project there would hold up the window."""
    root = path if path.is_dir() else path.parent
    try:
        return sum(file.stat().st_size for file in root.glob("**/*.xml")) > LARGE
    except OSError:
        return False


class Opening(QObject):
    """Reads one project at a time; what was begun before is given up.

    The thread knows of nothing of Qt: a signal emitted there while its window is being closed
    would crash.
    """

    read = Signal(object)
    """What ``folder.load`` gives."""
    refused = Signal(str)
    """There is none: why, in one line."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._came: SimpleQueue[Found | Exception] = SimpleQueue()
        self._looks = QTimer(self, interval=LOOKS)
        self._looks.timeout.connect(self._look)

    def start(self, path: Path) -> None:
        # What another thread still reads comes into a queue that nobody looks into any more.
        self._came = SimpleQueue()
        threading.Thread(target=_read, args=(path, self._came), name=NAME, daemon=True).start()
        self._looks.start()

    def cancel(self) -> None:
        """Nobody is told of what was begun: its thread ends by itself, and is not heard."""
        self._looks.stop()

    def _look(self) -> None:
        if self._came.empty():
            return
        self._looks.stop()
        found = self._came.get()
        if isinstance(found, SituError):
            self.refused.emit(said(str(found)))
        elif isinstance(found, Exception):
            self.refused.emit("")
            raise found
        else:
            self.read.emit(found)


def _read(path: Path, came: SimpleQueue[Found | Exception]) -> None:
    found: Found | Exception
    try:
        found = folder.load(path)
    except Exception as error:
        # Whatever it is, the window's thread hears of it: there the fault is raised and told.
        found = error
    came.put(found)


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
            self._refused(self._window, said(str(error)))

    def _on_refused(self, why: str) -> None:
        self._work.end()
        self._refused(self._window, why)
