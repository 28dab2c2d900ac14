"""What is being sent to a robot: files in pieces, each checked before and after it has come.

Nothing that comes over the wire is ever unpacked or followed: a bundle is paths with sizes, then
bytes. What is wrong with it raises ``Refused``, in one line for who sends it.
"""

from __future__ import annotations

import errno
import hashlib
import os
import re
import shutil
import unicodedata
from collections.abc import Mapping
from pathlib import Path

from msgspec import Struct

from situ.blackboard.protocol import Sent
from situ.document.export import deployable
from situ.document.folder import LOCAL_FILE
from situ.document.project import Project
from situ.errors import Refused

FILES = 10_000
TOTAL = 512_000_000
"""Bytes of a whole bundle."""
LONGEST = 200
"""Characters of a path."""
ROOM = 64_000_000
"""Bytes that must be left on the disk for what the robot keeps besides."""

_APPENDING = os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC
_CONTROL = re.compile(r'[\x00-\x1f\x7f\\:*?"<>|]')
_DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)


class _Coming(Struct):
    """A file of which so much has come."""

    sent: Sent
    size: int
    digest: hashlib._Hash


class Staging:
    """A bundle on its way into ``folder``, which is made anew.

    has: SHA-256 to where a file of this content lies already, in the same file system and never
    written again; it need not be sent. ``wanted`` are the paths that must be. Nothing but
    ``complete`` and what follows it takes longer with more files: a robot waits for the rest.
    """

    def __init__(self, folder: Path, files: Mapping[str, Sent], has: Mapping[str, Path]) -> None:
        check(files)
        self.folder = folder
        self.files = files
        self.wanted: list[str] = []
        self._here = {path: has[one.sha256] for path, one in files.items() if one.sha256 in has}
        self._coming: dict[str, _Coming] = {}
        for path, sent in files.items():
            if path not in self._here:
                self._coming[path] = _Coming(sent, 0, hashlib.sha256())
                self.wanted.append(path)
        shutil.rmtree(folder, ignore_errors=True)
        try:
            folder.mkdir(parents=True, mode=0o700)
            total = sum(sent.size for sent in files.values())
            free = shutil.disk_usage(folder).free
            if free < total + ROOM:
                raise Refused(
                    f"the robot's disk has {_mb(free)} left, this takes {_mb(total)} and "
                    f"{_mb(ROOM)} must stay: make room there; what runs goes on"
                )
        except OSError as error:
            raise self._no(error) from None
        except Refused:
            self.drop()
            raise

    def piece(self, path: str, offset: int, data: bytes) -> None:
        """The next piece of a file; one that has come already is passed over."""
        coming = self._coming.get(path)
        if coming is None:
            raise Refused(f"{path}: no such file was announced, or it is here already")
        if offset + len(data) == coming.size and offset < coming.size:
            return
        if offset != coming.size:
            raise Refused(f"{path}: the next piece begins at {coming.size}, not at {offset}")
        if coming.size + len(data) > coming.sent.size:
            raise Refused(f"{path}: more than the {coming.sent.size} bytes that were announced")
        try:
            file = os.open(self._place(path), _APPENDING, 0o600)
            try:
                left = data
                while left:
                    left = left[os.write(file, left) :]
            finally:
                os.close(file)
        except OSError as error:
            self.drop()
            raise self._no(error) from None
        coming.size += len(data)
        coming.digest.update(data)
        if coming.size == coming.sent.size and coming.digest.hexdigest() != coming.sent.sha256:
            self.drop()
            raise Refused(f"{path}: other bytes came than were announced: send all of it again")

    def check_whole(self) -> None:
        """Raises Refused where something has not come."""
        missing = [path for path, one in self._coming.items() if one.size < one.sent.size]
        if missing:
            raise Refused(f"{missing[0]}: it has not come whole: send the rest of it first")

    def complete(self) -> None:
        """Puts what the robot has already beside what has come. Raises Refused."""
        try:
            for path, here in self._here.items():
                os.link(here, self._place(path), follow_symlinks=False)
            for path, one in self._coming.items():
                if one.sent.size == 0:
                    self._place(path).touch(mode=0o600)
        except FileNotFoundError:
            self.drop()
            raise Refused(f"{path}: the robot no longer has it: send all of it again") from None
        except OSError as error:
            raise self._no(error) from None

    def fill(self, project: Project) -> dict[str, Sent]:
        """Puts what else belongs to the project beside what has come; what that is."""
        found = {}
        for path in deployable(project):
            if path in self.files:
                continue
            # As it lies there: nothing of it has changed.
            data = Path(project.root, path).read_bytes()
            self._place(path).write_bytes(data)
            found[path] = Sent(len(data), hashlib.sha256(data).hexdigest())
        check({**self.files, **found})
        return found

    def keep(self) -> None:
        """The disk has all of it when this returns. Raises OSError."""
        for place in (*self.folder.rglob("*"), self.folder):
            file = os.open(place, os.O_RDONLY | os.O_NOFOLLOW)
            try:
                os.fsync(file)
            finally:
                os.close(file)

    def drop(self) -> None:
        self._coming.clear()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _place(self, path: str) -> Path:
        """Where a file goes; the folders around it are there."""
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        return file

    def _no(self, error: OSError) -> Refused:
        self.drop()
        return Refused(not_kept(error))


def not_kept(error: OSError) -> str:
    """What an operator is told where the robot's disk does not take a version."""
    full = error.errno in (errno.ENOSPC, errno.EDQUOT)
    mend = "make room on its disk" if full else "it must be able to write in its state folder"
    return f"the robot can not keep it ({error.strerror or error}): {mend}; what runs goes on"


def check(files: Mapping[str, Sent]) -> None:
    """Raises Refused where a bundle of these files may not come at all."""
    if not files:
        raise Refused("there is no file in it")
    if len(files) > FILES:
        raise Refused(f"{len(files)} files are too many: at most {FILES} are taken")
    total = 0
    seen: dict[str, str] = {}
    folders: set[str] = set()
    for path, sent in files.items():
        if why := _wrong(path):
            raise Refused(f"{path[:LONGEST]!r}: {why}")
        if sent.size < 0 or not re.fullmatch(r"[0-9a-f]{64}", sent.sha256):
            raise Refused(f"{path}: needs a size in bytes and the SHA-256 of its content")
        total += sent.size
        name = _folded(path)
        if name in seen:
            raise Refused(f"{path}: is the same name as {seen[name]} on some systems: rename one")
        seen[name] = path
        parts = name.split("/")
        folders.update("/".join(parts[:end]) for end in range(1, len(parts)))
    if total > TOTAL:
        raise Refused(f"{_mb(total)} are too much: at most {_mb(TOTAL)} are taken")
    for name in folders:
        if name in seen:
            raise Refused(f"{seen[name]}: is a file and a folder at once")


def _wrong(path: str) -> str:
    """Why a path can be none of a project; empty where it can."""
    if not path or len(path) > LONGEST:
        return f"a path has 1 to {LONGEST} characters"
    if path.startswith("/") or any(part in ("", ".", "..") for part in path.split("/")):
        return "leads out of the project: its files lie inside its folder"
    if _CONTROL.search(path) or not path.isprintable():
        return "has characters that no path of a project may have"
    if any(_DEVICE.fullmatch(part) or part != part.strip() for part in path.split("/")):
        return "is the name of a device, or begins or ends with a space"
    if path == LOCAL_FILE:
        return "belongs to the robot: it stays as it is there"
    return ""


def _folded(path: str) -> str:
    return unicodedata.normalize("NFC", path).casefold()


def _mb(size: int) -> str:
    return f"{size / 1_000_000:,.0f} MB"
