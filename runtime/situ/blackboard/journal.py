"""Durable tags: what an acknowledged ``set`` of them survives (formats.md, ``[durable]``).

``durable.db`` in the state folder is SQLite in WAL mode, one row a tag: its value as JSON (null:
deleted), version and writer. A commit is on its way to the disk when it is acknowledged: it
survives the death of the process, and with ``sync`` the loss of power too. All commits are made
in a thread of their own, which is started by the first; a tag that is not durable costs one look
into a dict.
"""

from __future__ import annotations

import contextlib
import logging
import os
import sqlite3
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import msgspec

from situ.decide.board import Entry
from situ.decide.effects import Changed
from situ.decide.world import untraced
from situ.document import names
from situ.document.project import Project
from situ.errors import UsageError

FILE = "durable.db"
RESERVE = 1_000_000
"""Bytes that must be free for a durable tag to be set; the last ones are left to the system."""
FORMAT = 1
PROJECT = "project"
"""Who has written ``[tags]``; they stand in the project and are not kept."""

Restored = dict[str, tuple[Any, int, str]]
"""Tag to (value, version, writer), as ``inputs.Start`` has it."""
Done = Callable[[str | None], None]
"""Is told, from the thread, that a commit was made, or in words why not."""
_Row = tuple[str, str, int, str]

_log = logging.getLogger("situ.durable")


class DurableTags:
    """The durable tags of one state folder, which must be this process's alone.

    A damaged or unreadable file is set aside under another name, told in the log. Raises
    UsageError where it can not be opened for another reason (a full disk, no right to write).

    durable: whether a tag is; patterns are looked at once for each tag. restored: what the
    file held. free: gives the bytes that are free where a path lies.
    """

    def __init__(
        self,
        folder: Path,
        patterns: Sequence[str],
        *,
        sync: bool = False,
        free: Callable[[Path], int] | None = None,
    ) -> None:
        self.durable = Durable(patterns)
        self._folder = folder
        self._free = free or _free
        self._db = _open(folder / FILE, sync)
        self.restored = self._read()
        self._unwritten: dict[str, _Row] = {}
        self._failing = False
        self._waiting: SimpleQueue[tuple[list[_Row], Done] | None] = SimpleQueue()
        self._thread: threading.Thread | None = None

    def refusal(self, tags: Iterable[str]) -> str | None:
        """Why these tags can not be set now, and what to do; None where they can."""
        tag = next((tag for tag in tags if self.durable[tag]), None)
        if tag is None or self._free(self._folder) >= RESERVE:
            return None
        return (
            f"{tag} is durable and can not be kept: the disk of {self._folder} is full; "
            "make room there and set it again"
        )

    def behind(self, entries: Mapping[str, Entry]) -> list[Changed]:
        """Durable tags of a core that went on, which the process before had set but not kept.

        Raises ValueError where the file knows of more than the core does.
        """
        kept = self.restored
        if any(tag not in entries or entries[tag].version < kept[tag][1] for tag in kept):
            raise ValueError("durable tags were set since")
        return [
            Changed(tag, entry.value, entry.version, entry.writer, entry.time)
            for tag, entry in entries.items()
            if self.durable[tag]
            and entry.writer != PROJECT
            and (tag not in kept or kept[tag][1] < entry.version)
        ]

    def keep(self, changes: Iterable[Changed], done: Done) -> None:
        """Commits them together; ``done`` is called when they are. What could not be
        committed goes with the next that can."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._work, name="situ-durable", daemon=True)
            self._thread.start()
        rows = [(c.tag, _encode(c.value).decode(), c.version, c.writer) for c in changes]
        self._waiting.put((rows, done))

    def close(self) -> None:
        """Returns when all that was to be kept is committed and told. Twice is no fault."""
        if self._thread is not None:
            self._waiting.put(None)
            self._thread.join()
            self._thread = None
        self._db.close()

    def _work(self) -> None:
        going = True
        while going:
            batches = []
            # What has come while the last commit was made goes into one.
            while (batch := self._waiting.get()) is not None:
                batches.append(batch)
                if self._waiting.empty():
                    break
            else:
                going = False
            if batches or self._unwritten:
                why = self._commit([row for rows, _ in batches for row in rows])
                for _, done in batches:
                    done(why)

    def _commit(self, rows: Iterable[_Row]) -> str | None:
        """None, or why it could not be done."""
        newest = self._unwritten | {row[0]: row for row in rows}
        try:
            self._db.execute("BEGIN IMMEDIATE")
            try:
                self._db.executemany("REPLACE INTO entries VALUES (?, ?, ?, ?)", newest.values())
                self._db.execute("COMMIT")
            except BaseException:
                if self._db.in_transaction:
                    self._db.execute("ROLLBACK")
                raise
        except sqlite3.Error as error:
            self._unwritten = newest
            if not self._failing:
                _log.error("%s: %s; durable tags are not kept", self._folder / FILE, error)
            self._failing = True
            return str(error)
        if self._failing:
            _log.warning("%s: durable tags are kept again", self._folder / FILE)
        self._failing, self._unwritten = False, {}
        return None

    def _read(self) -> Restored:
        found: Restored = {}
        for tag, value, version, writer in self._db.execute("SELECT * FROM entries ORDER BY tag"):
            if not (isinstance(tag, str) and names.is_tag(tag) and self.durable[tag]):
                continue
            try:
                found[tag] = msgspec.convert(
                    (msgspec.json.decode(value), version, writer), tuple[Any, int, str]
                )
            except (msgspec.MsgspecError, TypeError):
                _log.error("%s: %s can not be read; it is missing", self._folder / FILE, tag)
        return found


class Durable(dict[str, bool]):
    """Tag to whether one of the patterns fits it; what the runtime itself keeps never is."""

    def __init__(self, patterns: Sequence[str]) -> None:
        super().__init__()
        self._patterns = patterns

    def __missing__(self, tag: str) -> bool:
        fits = not untraced(tag) and any(names.matches(one, tag) for one in self._patterns)
        self[tag] = fits
        return fits


def _open(file: Path, sync: bool) -> sqlite3.Connection:
    try:
        return _opened(file, sync)
    except sqlite3.DatabaseError as error:
        if not _is_damaged(file, error):
            raise UsageError(
                f"{file}: {error}; make room there or end who has it open, "
                "or give another folder with --state"
            ) from None
        aside = _set_aside(file)
        _log.error("%s: %s; it is set aside as %s, durable tags begin anew", file, error, aside)
        return _opened(file, sync)


def patterns(project: Project) -> tuple[str, ...]:
    """What is durable in a project: what it says, and what its settings change."""
    return (*project.durable, *(setting.tag for setting in project.settings))


def _opened(file: Path, sync: bool) -> sqlite3.Connection:
    with contextlib.suppress(OSError):
        # SQLite would make it readable to all; what goes with it gets the same rights.
        os.close(os.open(file, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600))
    # Opened here, used by the thread alone afterwards.
    db = sqlite3.connect(file, isolation_level=None, check_same_thread=False, timeout=0.0)
    try:
        # Nobody else's, so no memory is shared in a file: a full disk can be read.
        db.execute("PRAGMA locking_mode = EXCLUSIVE")
        ((sound,),) = db.execute("PRAGMA quick_check(1)")
        if sound != "ok":
            raise sqlite3.DatabaseError(sound)
        db.execute("PRAGMA journal_mode = WAL")
        db.execute(f"PRAGMA synchronous = {'FULL' if sync else 'NORMAL'}")
        ((found,),) = db.execute("PRAGMA user_version")
        if found > FORMAT:
            raise UsageError(f"{file} was written by a newer situ: run that one, or move it away")
        if found < FORMAT:
            db.execute(
                "CREATE TABLE entries (tag TEXT PRIMARY KEY, value TEXT NOT NULL, "
                "version INTEGER NOT NULL, writer TEXT NOT NULL) WITHOUT ROWID"
            )
            db.execute(f"PRAGMA user_version = {FORMAT}")
        db.execute("SELECT tag, value, version, writer FROM entries LIMIT 1")
    except BaseException:
        db.close()
        raise
    return db


def _is_damaged(file: Path, error: sqlite3.DatabaseError) -> bool:
    # One that we found ourselves has no code.
    code = getattr(error, "sqlite_errorcode", sqlite3.SQLITE_CORRUPT) & 0xFF
    if code == sqlite3.SQLITE_IOERR:
        # It says the same of a disk that is full.
        return _free(file.parent) >= RESERVE
    return code in (
        sqlite3.SQLITE_CORRUPT,
        sqlite3.SQLITE_NOTADB,
        sqlite3.SQLITE_CANTOPEN,
        sqlite3.SQLITE_ERROR,
    )


def _set_aside(file: Path) -> Path:
    """Renames the file with what belongs to it; its new name. Raises UsageError."""
    number = 1
    while (aside := file.with_name(f"{file.name}.damaged-{number}")).exists():
        number += 1
    try:
        for end in ("", "-wal", "-shm"):
            part = file.with_name(file.name + end)
            if part.exists():
                part.rename(f"{aside}{end}")
    except OSError as error:
        raise UsageError(
            f"{file} can neither be read nor renamed ({error.strerror}): move it away"
        ) from None
    return aside


_encode = msgspec.json.Encoder().encode


def _free(folder: Path) -> int:
    found = os.statvfs(folder)
    return found.f_bavail * found.f_frsize
