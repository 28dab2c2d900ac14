"""Pictures of drawings that are too large for the window to wait: another process draws them."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct
from PySide6.QtCore import QObject, Signal

from situ_studio.edit import Document
from situ_studio.worker import Worker, module

COMMAND = module("situ_studio.export_process")


class Drawing(Struct, frozen=True):
    """What shall be drawn into the file ``out``, whose format knows a ``title`` perhaps."""

    document: Document
    out: str
    title: str


class LargeExport(QObject):
    """One picture at a time; what was begun before is given up."""

    written = Signal(str)
    """The file that is there now."""
    refused = Signal(str)
    """There is none: why, in one line."""

    def __init__(self, parent: QObject, command: Sequence[str] = COMMAND) -> None:
        super().__init__(parent)
        self._out = ""
        self._said = ""
        self._worker = Worker(command, self)
        self._worker.answered.connect(self._on_answer)
        self._worker.said.connect(self._on_said)
        self._worker.gone.connect(self._on_gone)

    def start(self, drawing: Drawing) -> None:
        """Draws this document as it is now."""
        self.cancel()
        self._out, self._said = drawing.out, ""
        self._worker.ask(drawing)

    def cancel(self) -> None:
        """Nothing more is written, and nobody is told."""
        self._worker.end()

    def _on_answer(self, refused: str) -> None:
        # Large drawings are rare: the process does not wait for another.
        self._worker.end()
        if refused:
            self._refuse(refused)
        else:
            self.written.emit(self._out)

    def _on_said(self, said: str) -> None:
        self._said = (said.splitlines() or [self._said])[-1]

    def _on_gone(self) -> None:
        self._refuse(self._said or self.tr("its process ended early"))

    def _refuse(self, why: str) -> None:
        self.refused.emit(self.tr("{0} can not be drawn: {1}").format(self._out, why))
