"""CURVE keys as files: a robot's with all whom it knows, and those of a module or a person.

docs/security.md has the layout. Secret keys lie in files that only their owner can read.
"""

from __future__ import annotations

import hashlib
import logging
import os
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import zmq
from msgspec import Struct

from situ.blackboard.announced import fingerprint
from situ.blackboard.curve import Curve, KeysOf
from situ.blackboard.identity import ROBOT, Identity, KeyRole
from situ.document import names
from situ.errors import UsageError

SECRET = "secret.toml"
KNOWN = "known"
ROBOTS = "robots"
_LENGTH = 40

_log = logging.getLogger("situ.keys")

T = TypeVar("T")


class KeyPair(Struct, frozen=True, forbid_unknown_fields=True):
    """``secret.toml``: whose it is, both keys in z85."""

    name: str
    public: str
    secret: str


class KnownKey(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """``known/NAME.toml``. door: the key belongs to a token of the WebSocket door.

    write: patterns of tags that a module may set beside what it provides.
    """

    public: str
    role: KeyRole
    write: tuple[str, ...] = ()
    door: bool = False


class RobotKey(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """``robots/NAME.toml``: a robot's public key, the addresses where it is asked, and the role
    that it has been told of this client."""

    public: str
    addresses: tuple[str, ...]
    role: KeyRole | None = None


class RobotKeys:
    """A robot's own keys and those that it knows, as they lie in a folder.

    ``refresh`` reads again what has changed there. Raises UsageError where there are no keys,
    where others can read the secret one, or where a file is none of these.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        own = _read(folder / SECRET, KeyPair, secret=True)
        self.public = own.public.encode()
        self.secret = own.secret.encode()
        self._seen = self._stamp()
        self._take(read_known(folder))

    def identity(self, public: str) -> Identity | None:
        """Whose public key (z85) it is; None: nobody's that is known."""
        return self._keys.get(public)

    def refresh(self) -> bool:
        """Takes what has been added, changed or removed; whether somebody's key is known no
        longer. While something there is wrong, all stays as it was, and the log says so."""
        stamp = self._stamp()
        if stamp == self._seen:
            return False
        self._seen = stamp
        before = self._keys
        try:
            self._take(read_known(self.folder))
        except UsageError as error:
            _log.error("%s; who is known stays as it was", error)
        return not before.keys() <= self._keys.keys()

    def own(self) -> Curve:
        """For clients in the robot's own processes."""
        return Curve(self.public, self.secret, self.public, ROBOT)

    def door(self, token: str) -> Curve | None:
        """The keys of whoever has this token of the WebSocket door; None: nobody has it."""
        public, secret = token_keys(token)
        if public.decode() not in self._tokens:
            return None
        return Curve(public, secret, self.public, self._keys[public.decode()].name)

    def _take(self, known: dict[str, KnownKey]) -> None:
        keys = {self.public.decode(): Identity(ROBOT, "service")}
        for name, entry in known.items():
            if entry.public in keys:
                other = keys[entry.public].name
                raise UsageError(
                    f"{self.folder / KNOWN}: {name} and {other} have the same key; remove one"
                )
            keys[entry.public] = Identity(name, entry.role, entry.write)
        self._keys = keys
        self._tokens = {entry.public for entry in known.values() if entry.door}

    def _stamp(self) -> tuple[tuple[str, int, int], ...]:
        try:
            with os.scandir(self.folder / KNOWN) as found:
                files = [(entry.name, entry.stat()) for entry in found]
        except OSError:
            return ()
        return tuple(sorted((name, one.st_mtime_ns, one.st_ino) for name, one in files))


# -- the robot's folder ------------------------------------------------------


def has_keys(folder: Path) -> bool:
    """Whether the robot lets in only whom it knows."""
    return (folder / SECRET).exists()


def new_robot(folder: Path) -> KeyPair:
    """Makes a robot's keys; raises UsageError where it has some already."""
    pair = new_pair(ROBOT)
    _make(folder)
    _make(folder / KNOWN)
    write_secret(folder, pair)
    return pair


def read_known(folder: Path) -> dict[str, KnownKey]:
    """Whom the robot knows, in the order of their names. Raises UsageError."""
    known = {}
    for file in sorted((folder / KNOWN).glob("*.toml")):
        entry = _read(file, KnownKey)
        problem = _wrong(file.stem, entry)
        if problem is not None:
            raise UsageError(f"{file}: {problem}")
        known[file.stem] = entry
    return known


def check_known(folder: Path, name: str, entry: KnownKey) -> None:
    """Raises UsageError where ``add_known`` would."""
    problem = _wrong(name, entry)
    if problem is None:
        before = read_known(folder)
        same = next((n for n, one in before.items() if one.public == entry.public), None)
        if same is not None:
            problem = f"{same} has this key already"
        elif name in before:
            problem = f"is known already; situ keys remove {name} first"
    if problem is not None:
        raise UsageError(f"{name}: {problem}")


def add_known(folder: Path, name: str, entry: KnownKey) -> None:
    """Raises UsageError where the name is taken or can be none, or something else is wrong."""
    check_known(folder, name, entry)
    _write(folder / KNOWN / f"{name}.toml", entry, 0o644, f"{name} is known already")


def remove_known(folder: Path, name: str) -> None:
    """Raises UsageError where nobody has this name."""
    known = read_known(folder)
    if name not in known:
        some = f"; known are {', '.join(known)}" if known else ""
        raise UsageError(f"{folder}: nobody there is named {name}{some}")
    (folder / KNOWN / f"{name}.toml").unlink()


def _wrong(name: str, entry: KnownKey) -> str | None:
    if name == ROBOT or not names.is_tag(f"module/{name}/x") or "/" in name:
        return "that can be nobody's name: use letters, digits, - and _, and not robot"
    if entry.write and entry.role != "module":
        return f"write is for modules, not for the role {entry.role}"
    for pattern in entry.write:
        if not names.is_pattern(pattern) or names.is_reserved(pattern):
            return f"write {pattern!r} is no pattern of tags that a module can be given"
    if len(entry.public) != _LENGTH or not _is_z85(entry.public):
        return f"public {entry.public!r} is no key: {_LENGTH} characters of z85"
    return None


def _is_z85(text: str) -> bool:
    return set(text) <= _Z85


_Z85 = frozenset(
    "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.-:+=^!/*?&<>()[]{}@%$#"
)


# -- a client's folder -------------------------------------------------------


def client_folder() -> Path:
    """Where a person's keys lie unless they are told to lie elsewhere."""
    if told := os.environ.get("SITU_KEYS"):
        return Path(told)
    home = os.environ.get("XDG_CONFIG_HOME")
    return (Path(home) if home else Path.home() / ".config") / "situ" / "keys"


def client_robots(folder: Path) -> dict[str, RobotKey]:
    """The robots whose public keys lie in a client's folder, by name. Raises UsageError."""
    return {file.stem: _read(file, RobotKey) for file in sorted((folder / ROBOTS).glob("*.toml"))}


def client_keys(
    endpoint: str, told: str | os.PathLike[str] | None = None, *, robot: str = ""
) -> Curve | None:
    """The keys for the robot at this address, or for the one whose public key has the fingerprint
    ``robot``, wherever it is.

    told: their folder; else that of ``client_folder`` is meant, if it holds this robot, and None
    where it does not. Raises UsageError where the folder that was told holds no keys, or several
    robots of which none has this address, and where none has that fingerprint.
    """
    meant = told is not None or bool(os.environ.get("SITU_KEYS"))
    folder = client_folder() if told is None else Path(told)
    if not meant and not (folder / SECRET).exists():
        if robot:
            raise _no_key(endpoint)
        return None
    robots = client_robots(folder)
    if robot:
        fitting = [one for one in robots.values() if fingerprint(one.public) == robot]
        if not fitting:
            raise _no_key(endpoint)
    else:
        fitting = [one for one in robots.values() if endpoint in one.addresses]
    if not fitting and not meant:
        return None
    if not fitting and len(robots) == 1:
        # The key, not the address, is what tells this robot from others.
        fitting = list(robots.values())
    if not fitting:
        known = ", ".join(address for one in robots.values() for address in one.addresses)
        raise UsageError(
            f"{folder / ROBOTS}: no robot there is asked at {endpoint}"
            + (f", only at {known}" if known else "; put the robot's public key there")
        )
    own = _read(folder / SECRET, KeyPair, secret=True)
    found = fitting[0]
    return Curve(
        own.public.encode(), own.secret.encode(), found.public.encode(), own.name, found.role
    )


def _no_key(endpoint: str) -> UsageError:
    return UsageError(
        f"{endpoint}: there is no key for this robot here; situ keys add makes one on the robot"
    )


def new_client(folder: Path, pair: KeyPair, robot: str, key: RobotKey) -> None:
    """A folder with a module's or a person's keys, and those of the robot of this name."""
    _make(folder)
    _make(folder / ROBOTS)
    write_secret(folder, pair)
    _write(folder / ROBOTS / f"{robot}.toml", key, 0o644, "this robot is there already")


# -- keys --------------------------------------------------------------------


def new_pair(name: str) -> KeyPair:
    public, secret = zmq.curve_keypair()
    return KeyPair(name, public.decode(), secret.decode())


def token_keys(token: str) -> tuple[bytes, bytes]:
    """Public and secret key of a token: the robot keeps the public one, never the token."""
    digest = hashlib.blake2b(token.encode("utf-8", "replace"), digest_size=32, person=b"situ door")
    secret = _z85(digest.digest())
    return zmq.curve_public(secret), secret


def door_to(robot: bytes) -> KeysOf:
    """For a door on another machine than the robot of this public key: it does not know who is
    known, and the robot lets in those of its visitors whom it knows."""

    def keys(token: str) -> Curve | None:
        return Curve(*token_keys(token), robot) if token else None

    return keys


def _z85(raw: bytes) -> bytes:
    from zmq.utils import z85

    return z85.encode(raw)


def write_secret(folder: Path, pair: KeyPair) -> None:
    """Only its owner can read it. Raises UsageError where there is one already."""
    _write(folder / SECRET, pair, 0o600, "there are keys already: remove them first, or keep them")


# -- files -------------------------------------------------------------------


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    except OSError as error:
        raise UsageError(f"{folder}: {error.strerror}") from None


def _write(file: Path, content: Struct, mode: int, taken: str) -> None:
    lines = [f"{name} = {_toml(value)}\n" for name, value in _fields(content)]
    try:
        with os.fdopen(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode), "w") as out:
            out.write("".join(lines))
    except FileExistsError:
        raise UsageError(f"{file}: {taken}") from None
    except OSError as error:
        raise UsageError(f"{file}: {error.strerror}") from None


def _fields(content: Struct) -> Iterable[tuple[str, Any]]:
    built: dict[str, Any] = msgspec.to_builtins(content)
    return built.items()


def _toml(value: Any) -> str:
    # Texts, lists of texts and booleans are in JSON what they are in TOML.
    return msgspec.json.encode(value).decode()


def _read(file: Path, kind: type[T], secret: bool = False) -> T:
    try:
        if secret and file.stat().st_mode & 0o077:
            raise UsageError(f"{file}: others can read this secret key; chmod 600 {file}")
        return msgspec.convert(tomllib.loads(file.read_text("utf-8")), kind)
    except FileNotFoundError:
        raise UsageError(f"{file}: there are no keys; situ keys new makes a robot's") from None
    except OSError as error:
        raise UsageError(f"{file}: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeError, msgspec.ValidationError) as error:
        raise UsageError(f"{file}: no file of keys: {error}") from None
