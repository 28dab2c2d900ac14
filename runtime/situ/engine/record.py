"""Recordings of a running robot: MCAP files, each to be looked at and decided again by itself.

``situ.rehearse.recorded`` says what is in them. A recording costs the robot little and never stops
it: what can not be written ends the recording, with a line in the log.
"""

from __future__ import annotations

import itertools
import logging
import math
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import msgspec
from msgspec import Struct
from msgspec.structs import replace

import situ
from situ.blackboard.backlog import stamped
from situ.decide.inputs import AnyInput
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent
from situ.document.project import Project
from situ.errors import UsageError

if TYPE_CHECKING:
    from situ.rehearse.mcap_file import McapFile
    from situ.rehearse.recorded import Heading

FLUSH = 1.0
"""Seconds after which what was recorded is handed to the system."""
MANY = 64
"""Messages that are put into the file at once, so that no step waits for many."""

RING = "ring"
SPAN = 300.0
"""Seconds that a file of the ring lasts at the most."""
SIZE = 4_000_000
"""Bytes that it grows at the most, what heads it not counted."""
FILES = 16
"""Files of the ring; the oldest goes when there is one more."""
RING_BYTES = 64_000_000
"""The same for what all of them take."""

_log = logging.getLogger("situ.run")


class Snapshots(Protocol):
    """The part of ``situ.decide.robot.Robot`` that a recording needs."""

    def snapshot(self) -> bytes: ...


class Run(Struct, frozen=True):
    """What is recorded. project: as it runs; version: as which it was deployed."""

    runtime: str
    project: Project
    version: int = 0

    def heading(self, documents: Iterable[str]) -> Heading:
        from situ.rehearse.mcap_file import main_file
        from situ.rehearse.recorded import Heading

        project = self.project
        return Heading(
            self.runtime,
            situ.__version__,
            project.name,
            main_file(documents),
            project.tags,
            project.private,
            deployed=self.version,
        )


class Recorder:
    """Writes every step, from ``begin`` on, into the first of ``files`` that can be made, then,
    where it is to be divided, into the next ones, each with the robot's state before it. What can
    not be written ends the recording; one that is divided is tried again a file's time later.

    What was taken is in the system's hands ``FLUSH`` seconds later; so ``tend`` must be called
    when it says, by a clock in seconds that is not the robot's.

    documents: path to text of the project's files.
    """

    def __init__(self, files: Files, documents: Mapping[str, str]) -> None:
        self.torn: OSError | None = None
        self._files = files
        self._documents = documents
        self._run: Run | None = None
        # What runs now, where that is another version than at the beginning of the file.
        self._next: tuple[Run, Mapping[str, str]] | None = None
        self._robot: Snapshots
        self._state: bytes | None = None
        self._waiting: list[tuple[str, float, bytes]] = []
        self._file: McapFile | None = None
        self._flush_at: float | None = None
        self._since = 0.0
        self._us = 0
        self._again = math.inf
        self._divides = False
        self._wanted = False

    def begin(
        self, run: Run, robot: Snapshots, moment: float, *, state: bytes | None = None
    ) -> None:
        """From here on. moment: UNIX time. state: the snapshot of a robot that has run before;
        None: ``Start`` comes first."""
        self._run, self._robot = run, robot
        self._waiting = [] if state is None else [("/snapshot", moment, state)]
        self._wanted = True

    def turn_to(self, project: Project, version: int, documents: Mapping[str, str]) -> None:
        """Another version runs, from the step on that is taken next: the next file begins with
        these, and where there may be several it begins after that step, for what is private may
        be another."""
        if self._run is not None:
            if self._files.span < math.inf:
                self._divides, self._flush_at = True, -math.inf
            self._next = replace(self._run, project=project, version=version), documents

    def step(
        self, us: int, given: AnyInput | None, events: list[TraceEvent], moment: float
    ) -> None:
        """One step that was taken. us: the robot's time; moment: UNIX time."""
        if not self._wanted:
            if us >= self._again:
                # From here on: the robot's state has this step in it.
                self._again = math.inf
                self._head()
                self._wanted = True
            return
        self._us = us
        body = _encode({"us": us, "t": us / SECOND, "given": given})
        self._waiting.append(("/inputs", moment, body))
        self._waiting += [("/trace", moment, stamped(event, moment)) for event in events]

    def tend(self, now: float) -> float | None:
        """Writes what is to be written by ``now``; when to call it again, None: after a step."""
        if not self._waiting and self._flush_at is None:
            return None
        if self._flush_at is None:
            # What heads a file goes at once: a robot that is killed soon has begun, too.
            self._flush_at = now if self._file is None else now + FLUSH
        try:
            if now >= self._flush_at:
                self._flush(now)
            elif len(self._waiting) >= MANY:
                self._put(now)
        except OSError as error:
            self._tear(error)
        return self._flush_at

    def flush(self, now: float) -> None:
        """Hands over what was taken, before what else tells of it is forgotten."""
        if self._file is None:
            return
        try:
            self._flush(now)
        except OSError as error:
            self._tear(error)

    def close(self) -> None:
        """Ends the file."""
        try:
            self._put(self._since)
            if self._file is not None:
                self._file.finish()
        except OSError as error:
            self._tear(error)
        self._wanted = False
        self._file = None

    def _flush(self, now: float) -> None:
        self._flush_at = None
        self._put(now)
        if self._file is None:
            return
        self._file.flush()
        old = now - self._since >= self._files.span
        if old or self._divides or self._file.grown >= self._files.size:
            self._file.finish()
            self._file = None
            self._head()

    def _head(self) -> None:
        """What the next file begins with: the robot as it is now, and what it runs."""
        self._state = self._robot.snapshot()
        self._divides = False
        if self._next is not None:
            (self._run, self._documents), self._next = self._next, None

    def _put(self, now: float) -> None:
        if not self._waiting:
            return
        assert self._run is not None
        if self._file is None:
            from situ.rehearse.mcap_file import McapFile

            self._file = McapFile(
                self._files.open(), self._run.heading(self._documents), self._documents
            )
            self._since = now
            if self._state is not None:
                self._file.add("/snapshot", self._waiting[0][1], self._state)
        for topic, moment, body in self._waiting:
            self._file.add(topic, moment, body)
        self._waiting.clear()

    def _tear(self, error: OSError) -> None:
        self.torn = error
        self._waiting.clear()
        self._flush_at = None
        if self._file is not None:
            self._file.give_up()
        self._file = None
        self._wanted = False
        self._again = self._us + self._files.span * SECOND
        _log.error("%s: %s; the recording ends here", self._files.name, error.strerror or error)


class Files(Protocol):
    """Where a recording goes. span, size: of one file, in seconds and bytes."""

    name: str
    span: float
    size: float

    def open(self) -> int:
        """A new file to write into. Raises OSError."""


class OneFile:
    """The file that the user named; made at once. Raises UsageError where it can not be.

    A robot that ``goes_on`` after it was killed leaves alone what it has recorded before: it takes
    ``NAME-2.mcap``, ``NAME-3.mcap``, …
    """

    span = size = math.inf

    def __init__(self, path: Path, *, goes_on: bool = False) -> None:
        self.name = str(path)
        names: Iterable[Path] = [path]
        if goes_on and path.exists():
            names = (path.with_stem(f"{path.stem}-{n}") for n in itertools.count(2))
        for name in names:
            try:
                flags = os.O_EXCL if goes_on else os.O_TRUNC
                self._file = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_CLOEXEC | flags, 0o600)
            except FileExistsError:
                continue
            except OSError as error:
                raise UsageError(f"{name}: {error.strerror or error}") from None
            self.name = str(name)
            return

    def open(self) -> int:
        return self._file


class RingFiles:
    """The last minutes of a robot: numbered files in a folder, of which the oldest go."""

    span, size = SPAN, float(SIZE)

    def __init__(self, folder: Path) -> None:
        self.name = str(folder)
        self._folder = folder

    def open(self) -> int:
        self._folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        found = self.found()
        number = int(found[-1].stem) + 1 if found else 1
        sizes = [file.stat().st_size for file in found]
        while found and (len(found) >= FILES or sum(sizes) > RING_BYTES - SIZE):
            found.pop(0).unlink(missing_ok=True)
            sizes.pop(0)
        file = self._folder / f"{number:08}.mcap"
        return os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)

    def found(self) -> list[Path]:
        """Those that there are, the oldest first."""
        return sorted(file for file in self._folder.glob("*.mcap") if file.stem.isdecimal())


_encode = msgspec.json.Encoder().encode
