"""Another process of the studio's own, for work that would hold up the window.

A thread would not do: Python's lock would give it half of the window's time.
"""

from __future__ import annotations

import pickle
import sys
from collections.abc import Iterator, Sequence
from typing import Any

from PySide6.QtCore import QObject, QProcess, QTimer, Signal

from situ_studio.processes.sending import Frames, Sending


def module(name: str) -> tuple[str, ...]:
    """The command that runs a module of the studio; it answers by ``answering.answer``."""
    return sys.executable, "-m", name


class Worker(QObject):
    """Is asked for something, and answers from the loop; only the last question is told of.

    The process is started with the first question, and anew where it has gone.
    """

    answered = Signal(object)
    """The answer to the last question."""
    said = Signal(str)
    """What the process told of a fault of its own."""
    gone = Signal()
    """It has ended though nobody asked it to, and gives no answer."""

    def __init__(self, command: Sequence[str], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._command = tuple(command)
        self._number = 0
        self._sending = Sending()
        self._frames: Iterator[bytes] = iter(())
        self._came = Frames()
        self._busy = False
        # Not children: a process that is destroyed while it runs would end on its own time.
        self._processes: list[QProcess] = []
        processes = self._processes
        self.destroyed.connect(lambda: _end(*processes))
        self._turn = QTimer(self)
        self._turn.setInterval(0)
        self._turn.timeout.connect(self._send)

    @property
    def is_busy(self) -> bool:
        """Whether an answer is waited for."""
        return self._busy

    def ask(self, value: Any) -> None:
        """Asks for ``value``, in place of what was asked before."""
        self._number += 1
        self._busy = True
        if not self._processes:
            self._start()
        self._frames = self._sending.pack(value, self._number)
        self._turn.start()

    def drop(self) -> None:
        """Nobody is told of the answer."""
        self._number += 1
        self._busy = False
        self._turn.stop()

    def end(self) -> None:
        """Ends the process at once, whatever it does."""
        self.drop()
        for process in self._processes:
            process.blockSignals(True)
            _end(process)
            process.deleteLater()
        self._processes.clear()

    def _start(self) -> None:
        self._sending, self._came = Sending(), Frames()
        process = QProcess()
        self._processes.append(process)
        process.readyReadStandardOutput.connect(self._read)
        process.readyReadStandardError.connect(self._tell)
        process.finished.connect(self._on_gone)
        process.errorOccurred.connect(self._on_error)
        process.start(self._command[0], self._command[1:])

    def _send(self) -> None:
        """One frame; the window has its turn before the next."""
        message = next(self._frames, None)
        if message is None or not self._processes:
            self._turn.stop()
        else:
            self._processes[0].write(message)

    def _read(self) -> None:
        for message in self._came.take(bytes(self._processes[0].readAllStandardOutput().data())):
            number, found = pickle.loads(message)
            if number == self._number and self._busy:
                self._busy = False
                self.answered.emit(found)

    def _tell(self) -> None:
        said = bytes(self._processes[0].readAllStandardError().data())
        self.said.emit(said.decode(errors="replace").strip())

    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self._on_gone()

    def _on_gone(self) -> None:
        self._processes.pop().deleteLater()
        self.drop()
        self.gone.emit()


def _end(*processes: QProcess) -> None:
    for process in processes:
        process.kill()
        process.waitForFinished()
