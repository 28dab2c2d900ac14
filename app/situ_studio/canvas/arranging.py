"""The automatic layout of a large drawing: in a process, with a time limit, cancelled by a key."""

from __future__ import annotations

import sys
from collections.abc import Sequence

import msgspec
from PySide6.QtCore import QObject, QProcess, QTimer, Signal

from situ_studio.canvas.layout import Shape
from situ_studio.wording.language import tr

COMMAND = (sys.executable, "-m", "situ_studio.canvas.layout_process")
LIMIT = 20.0
"""Seconds after which a layout is given up."""

Places = dict[str, tuple[float, float]]


class Arranging(QObject):
    """One layout at a time. command: what is run; it reads a shape and writes places."""

    done = Signal(object)
    """The places of all cards, by uid."""
    refused = Signal(str)
    """There are none: why, in one line. Nobody is told of what was cancelled."""
    ended = Signal()
    """Nothing runs any more, whichever way it ended."""

    def __init__(
        self, parent: QObject, command: Sequence[str] = COMMAND, limit: float = LIMIT
    ) -> None:
        super().__init__(parent)
        self._command = tuple(command)
        # Not children: a process that is destroyed while it runs would end on its own time.
        self._running: list[QProcess] = []
        self._last: QProcess | None = None
        running = self._running
        self.destroyed.connect(lambda: _end(*running))
        self._limit = QTimer(self)
        self._limit.setSingleShot(True)
        self._limit.setInterval(round(1000 * limit))
        self._limit.timeout.connect(self._on_limit)

    @property
    def is_running(self) -> bool:
        return bool(self._running)

    def start(self, shape: Shape) -> None:
        """Begins; what ran before is cancelled."""
        self.cancel()
        process = QProcess()
        self._running.append(process)
        process.finished.connect(self._on_finished)
        process.errorOccurred.connect(self._on_error)
        self._limit.start()
        process.start(self._command[0], self._command[1:])
        if self.is_running:
            process.write(msgspec.json.encode(shape))
            process.closeWriteChannel()

    def cancel(self) -> None:
        """Ends it; the drawing stays as it is."""
        if self._running:
            # Kept: it may be telling that it ended, right now.
            process = self._last = self._running.pop()
            self._limit.stop()
            process.finished.disconnect(self._on_finished)
            process.errorOccurred.disconnect(self._on_error)
            _end(process)
            self.ended.emit()

    def _on_limit(self) -> None:
        seconds = round(self._limit.interval() / 1000)
        self.cancel()
        words = tr(
            "The layout took longer than {0} s and was given up: all cards stay where they are"
        )
        self.refused.emit(words.format(seconds))

    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self._fail(tr("it could not be started"))

    def _on_finished(self, status: int, how: QProcess.ExitStatus) -> None:
        process = self._running[-1]
        if status != 0 or how != QProcess.ExitStatus.NormalExit:
            said = bytes(process.readAllStandardError().data()).decode(errors="replace")
            self._fail((said.strip().splitlines() or [tr("its process ended early")])[-1])
            return
        try:
            places = msgspec.json.decode(process.readAllStandardOutput().data(), type=Places)
        except msgspec.DecodeError as error:
            self._fail(str(error))
            return
        self.cancel()
        self.done.emit(places)

    def _fail(self, why: str) -> None:
        self.cancel()
        words = tr("The layout failed ({0}): all cards stay where they are")
        self.refused.emit(words.format(why))


def _end(*processes: QProcess) -> None:
    for process in processes:
        if process.state() != QProcess.ProcessState.NotRunning:
            process.kill()
            process.waitForFinished()
