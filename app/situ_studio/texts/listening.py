"""Hearing how a text sounds: by espeak-ng, where this machine has it."""

from __future__ import annotations

import shutil

from PySide6.QtCore import QObject, QProcess, Signal

from situ.document import names

WORDS_A_MINUTE = 175
"""What espeak-ng says at its normal rate."""


class Listening(QObject):
    """Says one text at a time; another, or the same again, ends it.

    program: what speaks, as ``-v LANGUAGE --stdin``, with ``-a`` and ``-s`` where it shall be
    louder or faster than usual; None looks for espeak-ng on this machine.
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
        """Says a text as it is written; ends it where it is being said."""
        again = self.going and self._text == text
        self.end()
        if not again:
            # What stands for a value is said as a pause.
            self._begin(" … ".join(part for part, _ in names.split(text)), language)
            self._text = text

    def say(self, text: str, language: str, volume: float = 100, rate: float = 100) -> None:
        """Says a text that is filled in, in place of what is being said. volume, rate: percent."""
        self.end()
        loud = ("-a", str(round(volume))) if volume != 100 else ()
        fast = ("-s", str(round(WORDS_A_MINUTE * rate / 100))) if rate != 100 else ()
        self._begin(text, language, *loud, *fast)

    def end(self) -> None:
        """Silent at once."""
        process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.waitForFinished()
            process.deleteLater()
            self.changed.emit()

    def _begin(self, spoken: str, language: str, *options: str) -> None:
        assert self._program is not None
        self._text = ""
        process = self._process = QProcess(self)
        process.finished.connect(self._on_end)
        process.errorOccurred.connect(self._on_error)
        voice = language.replace("_", "-").lower()
        process.start(self._program, ["-v", voice, *options, "--stdin"])
        # "[[" would begin phoneme names, which nobody who writes a text means.
        process.write(spoken.replace("[[", "[ [").encode())
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
