"""Drawings that are too large for the window to wait: another process draws or prints them."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from msgspec import Struct
from PySide6.QtCore import QObject, Signal

from situ_studio.edits.edit import Document
from situ_studio.export.chosen_printer import ChosenPrinter
from situ_studio.processes.worker import Worker, module
from situ_studio.wording.language import said

COMMAND = module("situ_studio.export.export_process")


class Drawing(Struct, frozen=True):
    """What shall be drawn into the file ``out``, whose format knows a ``title`` perhaps."""

    document: Document
    out: str
    title: str


class Printing(Struct, frozen=True):
    """What shall be printed, with ``title`` and the day ``at`` at the foot of each page."""

    document: Document
    title: str
    at: datetime
    printer: ChosenPrinter

    @property
    def out(self) -> str:
        """The file that is printed into, else the printer."""
        return self.printer.file or self.printer.name

    @property
    def begun(self) -> str:
        """The file as it is while it is not whole; "" where there is none."""
        return self.printer.file and f"{self.printer.file}.part"


class LargeExport(QObject):
    """One drawing at a time; what was begun before is given up."""

    written = Signal(object)
    """The Drawing or Printing that is done."""
    refused = Signal(str)
    """There is none: why, in one line."""

    def __init__(self, parent: QObject, command: Sequence[str] = COMMAND) -> None:
        super().__init__(parent)
        self._wanted: Drawing | Printing | None = None
        self._said = ""
        self._worker = Worker(command, self)
        self._worker.answered.connect(self._on_answer)
        self._worker.said.connect(self._on_said)
        self._worker.gone.connect(self._on_gone)

    @property
    def wanted(self) -> Drawing | Printing | None:
        """What is drawn or printed now."""
        return self._wanted

    def start(self, wanted: Drawing | Printing) -> None:
        """Draws or prints this document as it is now."""
        self.cancel()
        self._wanted, self._said = wanted, ""
        self._worker.ask(wanted)

    def cancel(self) -> None:
        """Nothing more is written or printed, and nobody is told."""
        self._worker.end()
        self._end()

    def _end(self) -> Drawing | Printing | None:
        """What was wanted; a file that was printed in part is gone."""
        wanted, self._wanted = self._wanted, None
        if isinstance(wanted, Printing) and wanted.begun:
            Path(wanted.begun).unlink(missing_ok=True)
        return wanted

    def _on_answer(self, refused: str) -> None:
        # Large drawings are rare: the process does not wait for another.
        self._worker.end()
        if refused:
            self._refuse(refused)
        else:
            self.written.emit(self._end())

    def _on_said(self, told: str) -> None:
        self._said = (told.splitlines() or [self._said])[-1]

    def _on_gone(self) -> None:
        self._refuse(self._said or self.tr("its process ended early"))

    def _refuse(self, why: str) -> None:
        wanted = self._end()
        assert wanted is not None
        printed = isinstance(wanted, Printing)
        words = (
            self.tr("{0} can not be printed: {1}")
            if printed
            else self.tr("{0} can not be drawn: {1}")
        )
        self.refused.emit(words.format(wanted.out, said(why)))
