"""Asks Why not? beside the window where the trace is long, at once where it is short."""

from __future__ import annotations

import logging
from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal

from situ_studio.live.why_not import Question, answered
from situ_studio.processes.worker import Worker, module

AT_ONCE = 400
"""Events of which an answer takes less than a person notices."""
COMMAND = module("situ_studio.live.why_not_process")

_log = logging.getLogger("situ.studio")


class AskingWhyNot(QObject):
    """``answered`` tells the answer to the last question, or in one line why there is none."""

    answered = Signal(object)
    gone = Signal()
    """The process has ended, and there is no answer."""

    def __init__(
        self, parent: QObject, at_once: int = AT_ONCE, command: Sequence[str] = COMMAND
    ) -> None:
        super().__init__(parent)
        self._at_once = at_once
        self._worker = Worker(command, self)
        self._worker.answered.connect(self.answered)
        self._worker.said.connect(lambda said: _log.error("Why not? failed: %s", said))
        self._worker.gone.connect(self.gone)

    def ask(self, question: Question) -> None:
        """In place of what was asked before."""
        self._worker.drop()
        if len(question.events) <= self._at_once:
            self.answered.emit(answered(question))
        else:
            self._worker.ask(question)

    def drop(self) -> None:
        """Nobody wants to know any more."""
        self._worker.drop()
