"""The versions of its project that were deployed to a robot, in its state folder.

::

    versions/current          which one runs; replaced whole
    versions/deployed.jsonl   what happened to them, a line each
    versions/N/version.json   who sent it, when, what is in it
    versions/N/project/       its files, as ``situ export`` makes them
    versions/staging/         what is on its way

Version 0 is the project that ``situ run`` was given. A version is never changed;
``robot.local.toml`` and ``[robot]`` are the robot's own, whichever version runs
(docs/deploying.md).
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import os
import shutil
import time
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from situ.blackboard.protocol import Sent
from situ.blackboard.replies import Turn
from situ.document.check import merge, structure
from situ.document.folder import LOCAL_FILE, PROJECT_FILE, load, media_of, sources, write
from situ.document.project import Project
from situ.errors import ProjectError, Refused, SituError, UsageError

FOLDER = "versions"
SLICE = 700_000
"""Bytes of a file that are read at once."""
KEPT = 10
"""Versions that are kept; the oldest go."""
TURNS = 200
"""Lines of the history that are told."""

_log = logging.getLogger("situ.run")


class Version(Struct, frozen=True):
    """One that was deployed. main: the file that the project is read from. time: UNIX seconds."""

    main: str
    who: str
    time: float
    files: dict[str, Sent]


class Current(Struct, frozen=True):
    """Which version runs.

    given: what lay in the project's own folder when it was chosen. former: the version that is
    gone back to, while this one is in its first minute. starts: how often a core has begun in
    that time.
    """

    version: int = 0
    given: str = ""
    former: int | None = None
    starts: int = 0


class Versions:
    """Those of one robot. state: its folder; given: the project that ``situ run`` was given.

    ``current`` is what was last chosen. Where reading or writing raises OSError the files are as
    they were before.
    """

    def __init__(self, state: Path, given: Project) -> None:
        self.folder = state / FOLDER
        self.given = given
        # As it was read, whatever is done to it while it runs.
        self._texts = _texts(given)
        self.current = self._read()

    @property
    def staging(self) -> Path:
        return self.folder / "staging"

    def project(self, number: int) -> Project:
        """Raises ProjectError with the first of its errors, UsageError where it is not there."""
        if number == 0:
            return self.given
        return self.load(self.folder / str(number) / "project", self._version(number).main, number)

    def load(self, folder: Path, main: str, number: int | None = None) -> Project:
        """The project in ``folder``, with what is the robot's own laid over it; as ``project``."""
        local = Path(self.given.root) / LOCAL_FILE
        if self.given.toml is not None and local.is_file():
            shutil.copyfile(local, folder / LOCAL_FILE)
        else:
            (folder / LOCAL_FILE).unlink(missing_ok=True)
        project, problems = load(folder if main == PROJECT_FILE else folder / main)
        if project is not None:
            problems = merge(problems, structure(project))
        inside = f"{folder}/"
        errors = [str(p).removeprefix(inside) for p in problems if p.severity == "error"]
        if project is None or errors:
            which = "the project" if number is None else f"version {number}"
            raise ProjectError("\n".join(errors or [f"{which} can not be read"]))
        given = self.given
        return replace(
            project, endpoint=given.endpoint, adapter=given.adapter, announce=given.announce
        )

    def texts(self, project: Project) -> dict[str, str]:
        """What a robot that does not have its files reads the project from."""
        return dict(self._texts) if project.root == self.given.root else _texts(project)

    def files(self, number: int) -> tuple[str, dict[str, Sent]]:
        """The main file and all files of a version; none of version 0. Raises UsageError."""
        if number == 0:
            return "", {}
        version = self._version(number)
        return version.main, version.files

    def read(self, number: int, path: str, offset: int) -> bytes:
        """At most ``SLICE`` bytes of a file. Raises Refused where the version has none."""
        if not self.has(number) or path not in self.files(number)[1] or offset < 0:
            raise Refused(f"version {number} has no file {path}")
        try:
            with open(self.folder / str(number) / "project" / path, "rb") as file:
                file.seek(offset)
                return file.read(SLICE)
        except OSError as error:
            raise Refused(f"{path}: {error.strerror or error}") from None

    def has(self, number: int) -> bool:
        return number == 0 or (self.folder / str(number) / "version.json").is_file()

    def numbers(self) -> list[int]:
        """Of all that are kept, the oldest first."""
        with contextlib.suppress(OSError):
            return sorted(int(one.name) for one in self.folder.iterdir() if one.name.isdecimal())
        return []

    def next(self) -> int:
        """A number that no version ever had."""
        told = [turn.version for turn in self.turns()]
        return max((0, *self.numbers(), *told)) + 1

    def contents(self) -> dict[str, Path]:
        """SHA-256 to a file of the newest version that has this content."""
        found: dict[str, Path] = {}
        for number in self.numbers():
            with contextlib.suppress(SituError):
                home = self.folder / str(number) / "project"
                for path, sent in self._version(number).files.items():
                    found[sent.sha256] = home / path
        return {digest: file for digest, file in found.items() if file.is_file()}

    def add(self, number: int, staged: Path, version: Version) -> None:
        """Makes of what was staged, and is whole, a version."""
        new = self.folder / f"{number}.new"
        shutil.rmtree(new, ignore_errors=True)
        new.mkdir(mode=0o700)
        write(new / "version.json", msgspec.json.encode(version))
        os.rename(staged, new / "project")
        _sync(new)
        os.rename(new, self.folder / str(number))
        _sync(self.folder)

    def forget_old(self, kept: Collection[int]) -> None:
        """Removes the oldest beyond ``KEPT``, but for these."""
        for number in self.numbers()[:-KEPT]:
            if number not in kept:
                shutil.rmtree(self.folder / str(number), ignore_errors=True)

    def choose(self, current: Current) -> None:
        """From here on, whatever happens, this is what runs. Raises UsageError."""
        self.current = current
        self.folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        write(self.folder / "current", msgspec.json.encode(current))

    def tidy(self) -> None:
        """Removes what was on its way when a process died."""
        shutil.rmtree(self.staging, ignore_errors=True)
        for half in self.folder.glob("*.new"):
            shutil.rmtree(half, ignore_errors=True)

    # -- history -----------------------------------------------------------------

    def note(self, turn: Turn) -> None:
        """Writes down what happened. Raises OSError."""
        self.folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        line = msgspec.json.encode(turn) + b"\n"
        file = self.folder / "deployed.jsonl"
        with open(file, "ab", buffering=0) as out:
            # Where a line was torn the next one begins anew.
            if out.tell() and file.read_bytes()[-1:] != b"\n":
                line = b"\n" + line
            out.write(line)
            os.fsync(out.fileno())

    def turns(self) -> list[Turn]:
        """What happened, the oldest first; not more than the last ``TURNS``."""
        try:
            lines = (self.folder / "deployed.jsonl").read_bytes().splitlines()
        except OSError:
            return []
        found = []
        for line in lines[-TURNS:]:
            with contextlib.suppress(msgspec.MsgspecError):
                found.append(msgspec.json.decode(line, type=Turn))
        return found

    # ----------------------------------------------------------------------------

    def _read(self) -> Current:
        try:
            data = (self.folder / "current").read_bytes()
            return msgspec.json.decode(data, type=Current)
        except (OSError, msgspec.MsgspecError):
            return Current()

    def _version(self, number: int) -> Version:
        try:
            data = (self.folder / str(number) / "version.json").read_bytes()
            return msgspec.json.decode(data, type=Version)
        except (OSError, msgspec.MsgspecError):
            raise UsageError(
                f"the robot has no version {number}: situ history tells which it has"
            ) from None


def _texts(project: Project) -> dict[str, str]:
    found = sources(project)
    with contextlib.suppress(FileNotFoundError):
        if project.toml is not None:
            found[LOCAL_FILE] = (Path(project.root) / LOCAL_FILE).read_text("utf-8")
    return found


def main_file(project: Project) -> str:
    """The file that the project is read from."""
    if project.toml is not None:
        return project.toml
    return next(iter((*project.applications, project.spds_file, project.modules_file))) or ""


def fingerprint(project: Project) -> str:
    """Another one where the project's own folder was changed: its texts, its media's sizes."""
    found: Mapping[str, object] = {}
    with contextlib.suppress(OSError):
        found = sources(project)
    media = []
    folder = media_of(project)
    for where, _, names in os.walk(folder or os.devnull):
        for name in names:
            file = Path(where, name)
            with contextlib.suppress(OSError):
                media.append((file.relative_to(str(folder)).as_posix(), file.stat().st_size))
    return hashlib.sha256(msgspec.json.encode([found, sorted(media)])).hexdigest()


def before(turns: list[Turn], running: int) -> int | None:
    """The version that ran before: going back takes what came after off, as undo does."""
    stack = [0]
    for turn in turns:
        if turn.did in ("rolled back", "returned") and turn.version in stack:
            del stack[stack.index(turn.version) + 1 :]
        elif turn.did == "given":
            stack = [0]
        elif turn.did != "refused":
            stack.append(turn.version)
    if running in stack:
        del stack[len(stack) - 1 - stack[::-1].index(running) :]
    return stack[-1] if stack else None


def version_to_run(versions: Versions, left: int | None, *, anew: bool = False) -> tuple[int, bool]:
    """The version that a core which starts runs, and whether it may go on from what the one
    before it left behind, which ran the version ``left`` (None: it left nothing).

    What was deployed runs again, unless the project's own folder was changed since, or it is to
    begin ``anew`` with that. A version whose process dies in its first minute, and again when it
    goes on, is left for the one before it. Never raises.
    """
    versions.tidy()
    current = versions.current
    given = fingerprint(versions.given)
    if current.version and (anew or given != current.given):
        why = "as it was asked for" if anew else "it was changed since"
        _log.warning(
            "%s runs as it lies in %s, not version %d, which was deployed: %s",
            *(versions.given.name, versions.given.root, current.version, why),
        )
        _keep(versions, Current(0, given), "given", why)
        return 0, not left
    number, goes_on = current.version, True
    if current.former is not None and (left is None or current.starts):
        why = f"version {number} failed: the robot's process died in its first minute"
        _log.error("%s; back to version %d", why, current.former)
        _keep(versions, Current(current.former, current.given), "returned", why)
        number, goes_on = current.former, False
    elif current.former is not None:
        _keep(versions, replace(current, starts=current.starts + 1))
    if goes_on and left is not None and versions.has(left):
        number = left
    return number, goes_on


def _keep(versions: Versions, current: Current, did: Any = None, why: str = "") -> None:
    try:
        versions.choose(current)
        if did is not None:
            versions.note(Turn(time.time(), current.version, "situ", did, why))
    except (SituError, OSError) as error:
        _log.error("which version runs could not be kept: %s", error)


def _sync(folder: Path) -> None:
    file = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(file)
    finally:
        os.close(file)
