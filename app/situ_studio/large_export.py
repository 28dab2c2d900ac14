"""Pictures of drawings that are too large for the window to wait: another process draws them."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

from PySide6.QtCore import QObject, QProcess, QProcessEnvironment, Signal


class LargeExport(QObject):
    """One picture at a time; what was begun before is given up."""

    written = Signal(str)
    """The file that is there now."""
    refused = Signal(str)
    """There is none: why, in one line."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._out = ""
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        # Not children: a process that is destroyed while it runs would end on its own time.
        self._running: list[QProcess] = []
        running = self._running
        self.destroyed.connect(lambda: _end(*running))

    def start(self, files: Mapping[str, bytes], file: str, out: str) -> None:
        """Draws the document of ``file``, one of these as they are now, into ``out``."""
        self.cancel()
        self._out = out
        self._folder = tempfile.TemporaryDirectory(
            prefix="situ-export-", ignore_cleanup_errors=True
        )
        for path, data in files.items():
            made = Path(self._folder.name, path)
            made.parent.mkdir(parents=True, exist_ok=True)
            made.write_bytes(data)
        process = QProcess()
        environment = QProcessEnvironment.systemEnvironment()
        environment.insert("QT_QPA_PLATFORM", "offscreen")
        process.setProcessEnvironment(environment)
        process.finished.connect(self._on_finished)
        process.errorOccurred.connect(self._on_error)
        self._running.append(process)
        drawn = str(Path(self._folder.name, file))
        process.start(sys.executable, ["-m", "situ_studio", drawn, "--picture", out])

    def cancel(self) -> None:
        """Nothing more is written, and nobody is told."""
        while self._running:
            process = self._running.pop()
            process.finished.disconnect(self._on_finished)
            process.errorOccurred.disconnect(self._on_error)
            _end(process)
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None

    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self._refuse("")

    def _on_finished(self, status: int, how: QProcess.ExitStatus) -> None:
        process = self._running[-1]
        if status == 0 and how == QProcess.ExitStatus.NormalExit:
            self.cancel()
            self.written.emit(self._out)
            return
        said = bytes(process.readAllStandardError().data()).decode(errors="replace")
        self._refuse((said.strip().splitlines() or [""])[-1])

    def _refuse(self, why: str) -> None:
        self.cancel()
        words = self.tr("{0} can not be drawn: {1}")
        self.refused.emit(words.format(self._out, why or self.tr("its process ended early")))


def _end(*processes: QProcess) -> None:
    for process in processes:
        if process.state() != QProcess.ProcessState.NotRunning:
            process.kill()
            process.waitForFinished(1000)
