"""The projects that recordings hold, for the names of states: read beside the window."""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence
from weakref import WeakKeyDictionary

from PySide6.QtCore import QObject, Signal

from situ.document.project import Project
from situ.rehearse.recorded import Document, Heading, loaded
from situ_studio.live.log import TraceLog
from situ_studio.live.recordings import Recording
from situ_studio.processes.worker import Worker, module

COMMAND = module("situ_studio.live.comparing_process")
PROJECT = "situ.toml"

_log = logging.getLogger("situ.studio")


class RecordedProjects(QObject):
    """One recording after another, each once: it is remembered as long as somebody has its log."""

    read = Signal(object, object)
    """A ``TraceLog`` and the ``Project`` that ran, or None where it can not be read."""

    def __init__(self, parent: QObject, command: Sequence[str] = COMMAND) -> None:
        super().__init__(parent)
        self._known: WeakKeyDictionary[TraceLog, Project | None] = WeakKeyDictionary()
        self._waiting: list[Recording] = []
        self._worker = Worker(command, self)
        self._worker.answered.connect(self._on_answered)
        self._worker.said.connect(lambda said: _log.error("Reading a project failed: %s", said))
        self._worker.gone.connect(lambda: self._on_answered(None))

    def of(self, recording: Recording) -> Project | None:
        """What ran; None where that is not known, or not yet: ``read`` tells it then."""
        if recording.log in self._known:
            return self._known[recording.log]
        if all(one.log is not recording.log for one in self._waiting):
            self._waiting.append(recording)
            if len(self._waiting) == 1:
                self._ask()
        return None

    def end(self) -> None:
        """What is not read yet nobody wants any more."""
        self._waiting.clear()
        self._worker.end()

    def _ask(self) -> None:
        if self._waiting:
            self._worker.ask(self._waiting[0].files)
        else:
            self._worker.end()

    def _on_answered(self, project: Project | None) -> None:
        log = self._waiting.pop(0).log
        self._known[log] = project
        self._ask()
        self.read.emit(log, project)


def project_in(files: Mapping[str, str]) -> Project | None:
    """The project that these are, path to text; None where it can not be read."""
    if PROJECT not in files:
        return None
    documents = [Document(path, text.encode()) for path, text in files.items()]
    return loaded(Heading(file=PROJECT), documents)
