"""A core that was killed goes on: its last snapshot, and a journal of what happened since.

``core/snapshot`` and ``core/journal`` in the state folder (docs/architecture.md, *How the core
comes back*). What has happened is handed to the system before anything of it leaves the core,
without waiting for the disk: it survives the death of the process, not that of the machine, so
it counts only in the boot in which it was written. Durable tags survive both.

The journal is frames (``situ.engine.frames``). The first names the snapshot that it follows, each
other one is what one turn of the loop brought about, whole or not at all. ``core/trace`` has the
trace events up to the snapshot, for those who begin to look later.
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import os
import secrets
from pathlib import Path

import msgspec
from msgspec import Struct

import situ
from situ.blackboard.backlog import Backlog, Line
from situ.blackboard.history import AnySessionEvent, Past, SessionsState
from situ.decide.inputs import AnyInput
from situ.decide.robot import Robot
from situ.document.project import Project
from situ.engine import frames
from situ.engine.kept_trace import KeptTrace

FOLDER = "core"
INPUTS = 10_000
"""What happened since the last snapshot, at the most: a new one is made then. So many are done
again in about a tenth of a second."""
AGAIN = 200
"""After how many inputs it is tried again where nothing could be written."""
BYTES = 4_000_000
"""The same for what the journal takes; more only where the snapshot itself is as large."""

_log = logging.getLogger("situ.run")


class Kept(Struct):
    """A snapshot. began: when the robot's moment was 0, by the system's monotonic clock.

    identity: of the project and of situ itself. boot: of the machine. version: of the project
    (``situ.engine.versions``).
    """

    identity: str
    boot: str
    mark: str
    began: float
    seq: int
    robot: bytes
    sessions: SessionsState
    version: int = 0


class Recovery:
    """Snapshot and journal in ``folder``, which must be this process's alone.

    found: what a core of this project and this boot left behind, with what happened since;
    None where there is none, or where it ended well. A journal that breaks off ends there.
    What can not be written is told in the log, and then nothing is left behind: a core that
    comes back never knows less than what it has acknowledged.
    """

    def __init__(self, folder: Path, project: Project, *, boot: str | None = None) -> None:
        # It may be a link to a folder in memory, which a start of the machine has emptied.
        self._folder = (folder / FOLDER).resolve()
        self._identity = identity(project)
        self._boot = _boot() if boot is None else boot
        self._journal: int | None = None
        self._count = self._size = 0
        self._limit = BYTES
        self._failing = False
        self._trace = KeptTrace(self._folder)
        self.found: tuple[Kept, list[Past]] | None = None
        if self._boot:
            self.found = self._load()

    def trace(self, kept: Kept) -> list[Line]:
        """The trace events up to the snapshot that was found, without a gap; perhaps not all."""
        return self._trace.load(kept.sessions.runtime, kept.seq)

    @property
    def wanted(self) -> bool:
        """Whether it is time for a new snapshot."""
        inputs = AGAIN if self._failing else INPUTS
        return self._count >= inputs or self._size >= self._limit

    def append(self, past: list[Past]) -> None:
        """Writes down what happened; returns when the system has it."""
        self._count += len(past)
        if self._journal is None:
            return
        try:
            self._size += frames.append(self._journal, _encode_past(past))
        except _CAN_NOT as error:
            self._fail(error)

    def turn_to(self, project: Project) -> None:
        """Another version runs: the next snapshot is of a robot that runs this."""
        self._identity = identity(project)

    def snapshot(
        self, began: float, robot: Robot, sessions: SessionsState, backlog: Backlog
    ) -> None:
        """Begins anew from here; the old one stands until the new one is whole.

        To be called when all that has happened is written down.
        """
        self._count = self._size = 0
        if not self._boot:
            return
        mark = secrets.token_hex(8)
        try:
            self._folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            self._trace.follow(sessions.runtime, backlog)
            state = robot.snapshot()
            kept = Kept(
                self._identity,
                self._boot,
                mark,
                began,
                robot.seq,
                state,
                sessions,
                robot.version,
            )
            body = msgspec.msgpack.encode(kept)
            journal = frames.create(self._folder / "journal.new", mark.encode())
            if self._journal is not None:
                os.close(self._journal)
            self._journal = journal
            os.close(frames.create(self._folder / "snapshot.new", body))
            # Between the two the old journal stands beside the new snapshot, and is passed over.
            os.replace(self._folder / "snapshot.new", self._folder / "snapshot")
            os.replace(self._folder / "journal.new", self._folder / "journal")
        except _CAN_NOT as error:
            self._fail(error)
            return
        self._limit = max(BYTES, 2 * len(body))
        if self._failing:
            _log.warning("%s: what happens is written down again", self._folder)
        self._failing = False

    def forget(self) -> None:
        """Leaves nothing behind: the next start begins anew."""
        self.found = None
        if self._journal is not None:
            os.close(self._journal)
            self._journal = None
        self._trace.forget()
        for name in ("snapshot", "journal", "snapshot.new", "journal.new"):
            with contextlib.suppress(OSError):
                (self._folder / name).unlink(missing_ok=True)

    def set_aside(self, why: Exception) -> None:
        """What was found can not be gone on from; it is kept for whoever wants to look."""
        self.found = None
        for name in ("snapshot", "journal"):
            file = self._folder / name
            with contextlib.suppress(OSError):
                file.replace(file.with_name(f"{name}.broken"))
        _log.error(
            "%s can not be gone on from (%s: %s); it is set aside, the robot starts anew",
            self._folder / "snapshot",
            type(why).__name__,
            why,
        )

    def _fail(self, error: Exception) -> None:
        if not self._failing:
            what = getattr(error, "strerror", None) or error
            _log.error("%s: %s; if the core dies now, the robot starts anew", self._folder, what)
        self._failing = True
        self.forget()

    def _load(self) -> tuple[Kept, list[Past]] | None:
        try:
            snapshot = (self._folder / "snapshot").read_bytes()
            journal = (self._folder / "journal").read_bytes()
        except FileNotFoundError:
            return None
        except OSError as error:
            self.set_aside(error)
            return None
        try:
            found = list(frames.read(snapshot))
            if not found:
                raise ValueError("it is damaged")
            kept = msgspec.msgpack.decode(found[0][0], type=Kept)
        except (ValueError, msgspec.MsgspecError) as error:
            self.set_aside(error)
            return None
        if (kept.identity, kept.boot) != (self._identity, self._boot):
            return None
        return kept, self._past(journal, kept.mark)

    def _past(self, journal: bytes, mark: str) -> list[Past]:
        turns = frames.read(journal)
        first = next(turns, None)
        if first is None or first[0] != mark.encode():
            return []
        past: list[Past] = []
        end = first[1]
        for body, behind in turns:
            try:
                past += _decode_past(body)
            except msgspec.MsgspecError:
                break
            end = behind
        if end < len(journal):
            _log.warning("%s breaks off; what follows is left out", self._folder / "journal")
        return past


def version_left(folder: Path, *, boot: str | None = None) -> int | None:
    """The version of the project that a core in this boot left behind; None: it left nothing."""
    try:
        found = list(frames.read((folder / FOLDER / "snapshot").read_bytes()))
        left = msgspec.msgpack.decode(found[0][0], type=_Left) if found else None
    except (OSError, ValueError, msgspec.MsgspecError):
        return None
    here = _boot() if boot is None else boot
    return left.version if left is not None and here and left.boot == here else None


class _Left(Struct):
    """The part of ``Kept`` that tells what to read."""

    boot: str
    version: int = 0


def identity(project: Project) -> str:
    """The same for the same project, wherever it lies, and the same situ."""
    value = msgspec.json.encode(msgspec.structs.replace(project, root=""))
    return hashlib.sha256(situ.__version__.encode() + b"\n" + value).hexdigest()


def _boot() -> str:
    """Another one after each start of the machine; empty where the system has none."""
    try:
        return Path("/proc/sys/kernel/random/boot_id").read_text("ascii").strip()
    except OSError:
        return ""


_CAN_NOT = (OSError, TypeError, ValueError, OverflowError, msgspec.MsgspecError)
"""A disk that does not take it, a value that has no bytes."""
# JSON, as the values are: it holds integers of any size.
_encode_past = msgspec.json.Encoder().encode
_decode_past = msgspec.json.Decoder(list[tuple[int, AnyInput | AnySessionEvent | None]]).decode
