"""Recorded runs (MCAP) read into a trace log, a slice at a time: the window stays in use."""

from __future__ import annotations

import gc
import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import IO

from msgspec import Struct
from PySide6.QtCore import QObject, QTimer, Signal

from situ.decide.inputs import Deploy
from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse import recorded
from situ.rehearse.clock import Given
from situ_studio.live.log import TraceLog
from situ_studio.wording.language import said, tr

SLICE = 0.012
"""Seconds of reading at a time."""
PIECE = 500
"""Pieces of the file between two looks at the clock."""


class Recording(Struct, frozen=True):
    """A recorded run. files: the project's documents as they ran at its beginning, path to text;
    none where private values are masked. versions: those of all that ran later, by their numbers.
    ran: the project that ran, where it was played here.
    torn: the file ends without its end, for the robot still runs or was killed; damaged: with bytes
    that no recorder wrote. goes_on: another run follows in the file, which is not read.
    """

    path: Path
    project: str
    masked: bool
    files: dict[str, str]
    log: TraceLog
    torn: bool = False
    damaged: bool = False
    goes_on: bool = False
    versions: dict[int, dict[str, str]] = {}
    ran: Project | None = None

    def notice(self) -> str:
        """What of the run is not seen, in words; "" where all is."""
        name, found = self.path.name, []
        if self.log.gone:
            told = tr("{0} has more events than are kept: the first {1} are not shown.")
            found.append(told.format(name, f"{self.log.gone:,}"))
        if self.goes_on:
            told = tr("{0} holds another run behind this one, which is not shown.")
            found.append(told.format(name))
        if self.damaged:
            found.append(tr("{0} is damaged: what comes behind that is not shown.").format(name))
        elif self.torn:
            told = tr("{0} ends without its end: the robot was still running, or was killed.")
            found.append(told.format(name))
        if not len(self.log):
            found.append(tr("Nothing that a robot did is in it."))
        return " ".join(found)


class ReadingRecording(QObject):
    """Reads one file at a time; what was begun before is given up."""

    read = Signal(object)
    """A ``Recording``."""
    refused = Signal(str)
    """There is none: why, in one line."""
    went_on = Signal(float)
    """How much of the file is read, from 0 to 1."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.path: Path | None = None
        """What is being read."""
        self._pieces: Iterator[recorded.Piece]
        self._file: IO[bytes] | None = None
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._go_on)
        self.cancel()

    def start(self, path: Path) -> None:
        """Begins; ``read`` or ``refused`` comes from the loop."""
        self.cancel()
        self.path = path
        try:
            self._file = path.open("rb")
            self._size = path.stat().st_size
        except OSError as error:
            self._refuse(f"{path}: {error.strerror or error}")
            return
        if not self._size:
            self._refuse(tr("{0} is empty: the robot has written nothing into it.").format(path))
            return
        self._pieces = recorded.pieces(self._file, str(path))
        self._slices.start()

    def cancel(self) -> None:
        """Nobody is told of what was begun, and none of it is kept."""
        self._slices.stop()
        if self._file is not None:
            self._file.close()
            self._file = None
        self.path = None
        self._pieces = iter(())
        self._heading = recorded.Heading()
        self._files: dict[str, str] = {}
        self._versions: dict[int, dict[str, str]] = {}
        self._clock = Given()
        self._log = TraceLog()
        self._torn = self._damaged = self._goes_on = False

    def _go_on(self) -> None:
        end = time.perf_counter() + SLICE
        try:
            with _no_collection():
                while time.perf_counter() < end:
                    if not self._take(list(islice(self._pieces, PIECE))):
                        self._finish()
                        return
        except (UsageError, OSError, ValueError) as error:
            self._refuse(said(str(error)))
            return
        assert self._file is not None
        self.went_on.emit(min(self._file.tell() / self._size, 1.0))

    def _take(self, pieces: list[recorded.Piece]) -> bool:
        """False where there is nothing more."""
        try:
            lines = (piece.text for piece in pieces if type(piece) is recorded.Line)
            self._goes_on = not self._log.add_lines(lines)
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            # A file that other programs wrote may hold whatever; what is taken from it is looked
            # at nowhere else.
            raise UsageError(self._no_event(error)) from None
        for piece in pieces:
            if isinstance(piece, recorded.Heading):
                self._heading = piece
                self._clock.take(piece)
            elif isinstance(piece, recorded.Document):
                self._files[piece.path] = piece.data.decode(errors="replace")
            elif isinstance(piece, recorded.Torn):
                self._torn, self._damaged = True, piece.damaged
            elif not isinstance(piece, recorded.Line):
                self._take_given(piece)
        return bool(pieces) and not self._goes_on

    def _take_given(self, piece: recorded.Taken | recorded.Snapshot) -> None:
        """What no trace tells."""
        if isinstance(piece, recorded.Taken) and isinstance(piece.given, Deploy):
            self._versions[piece.given.version] = piece.given.files
        if written := self._clock.take(piece):
            self._log.keep_clock(written)

    def _no_event(self, error: Exception) -> str:
        number = len(self._log) + self._log.gone + 1
        if isinstance(error, KeyError):
            said = self.tr("{0}: event {1} lacks “{2}”; give what situ run --record wrote")
            return said.format(self.path, number, error.args[0])
        said = self.tr("{0}: event {1} is none of a robot's; give what situ run --record wrote")
        return said.format(self.path, number)

    def _finish(self) -> None:
        heading = self._heading
        assert self.path is not None
        read = Recording(
            self.path,
            heading.project,
            heading.masked,
            self._files,
            self._log,
            self._torn,
            self._damaged,
            self._goes_on,
            {heading.deployed: self._files, **self._versions},
        )
        self.cancel()
        self.read.emit(read)

    def _refuse(self, why: str) -> None:
        self.cancel()
        self.refused.emit(why)


@contextmanager
def _no_collection() -> Iterator[None]:
    """Python looks for circles meanwhile in none of what comes: it has none."""
    collecting = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collecting:
            gc.enable()
