"""Hearing how a text sounds: by espeak-ng, where this machine has it."""

from __future__ import annotations

import shutil

from PySide6.QtCore import QObject, QProcess, Signal

from situ.document import names


class Listening(QObject):
    """Says one text at a time; another, or the same again, ends it.

    program: what speaks, as ``-v LANGUAGE --stdin``; None looks for espeak-ng on this machine.
    """

    changed = Signal()
    """It began or ended."""
    failed = Signal(str)

    def __init__(self, parent: QObject, program: str | None = None) -> None:
        super().__init__(parent)
        self._program = program or shutil.which("espeak-ng")
        self._text = ""
        self._process: QProcess | None = None

    @property
    def can(self) -> bool:
        """Whether there is a voice."""
        return self._program is not None

    @property
    def going(self) -> bool:
        return self._process is not None

    def toggle(self, text: str, language: str) -> None:
        """Says a text; ends it where it is being said."""
        again = self.going and self._text == text
        self.end()
        if not again:
            self._begin(text, language)

    def end(self) -> None:
        """Silent at once."""
        process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.waitForFinished()
            process.deleteLater()
            self.changed.emit()

    def _begin(self, text: str, language: str) -> None:
        assert self._program is not None
        self._text = text
        # What stands for a value is said as a pause.
        spoken = " … ".join(part for part, _ in names.split(text))
        process = self._process = QProcess(self)
        process.finished.connect(self._on_end)
        process.errorOccurred.connect(self._on_error)
        process.start(self._program, ["-v", language.replace("_", "-").lower(), "--stdin"])
        process.write(spoken.encode())
        process.closeWriteChannel()
        self.changed.emit()

    def _on_end(self, status: int) -> None:
        process = self._process
        if process is None or process is not self.sender():
            return
        why = bytes(process.readAllStandardError().data()).decode(errors="replace").strip()
        self._process = None
        process.deleteLater()
        if status != 0:
            self._tell(why)
        self.changed.emit()

    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart and self._process is not None:
            self._process.deleteLater()
            self._process = None
            self._tell("")
            self.changed.emit()

    def _tell(self, why: str) -> None:
        words = self.tr("This text can not be heard here")
        line = why.splitlines()[-1] if why else ""
        self.failed.emit(f"{words}: {line}" if line else f"{words}.")
