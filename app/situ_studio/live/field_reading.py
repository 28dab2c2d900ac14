"""Recordings from the field counted beside the window, however large they are."""

from __future__ import annotations

import logging
from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal

from situ_studio.live.field import Asked, Field
from situ_studio.processes.worker import Worker, module

COMMAND = module("situ_studio.live.field_process")

_log = logging.getLogger("situ.studio")


class FieldReading(QObject):
    """Counts one choice of recordings at a time; what was begun before is given up."""

    counted = Signal(object)
    """A ``Field``."""
    went_on = Signal(float)
    """How much of them is read, from 0 to 1."""
    gone = Signal()
    """The process has ended, and nothing is known."""

    def __init__(self, parent: QObject, command: Sequence[str] = COMMAND) -> None:
        super().__init__(parent)
        self._worker = Worker(command, self)
        self._worker.answered.connect(self._on_answered)
        self._worker.said.connect(lambda said: _log.error("Counting failed: %s", said))
        self._worker.gone.connect(self.gone)

    @property
    def is_counting(self) -> bool:
        """Whether ``counted`` is still to come."""
        return self._worker.is_busy

    def start(self, asked: Asked) -> None:
        """Begins; ``counted`` comes from the loop."""
        self._worker.ask(asked)

    def cancel(self) -> None:
        """Nobody is told of what was begun, and the process ends."""
        self._worker.end()

    def _on_answered(self, found: float | Field) -> None:
        if isinstance(found, Field):
            self._worker.end()
            self.counted.emit(found)
        else:
            self.went_on.emit(found)
            self._worker.ask(None)
