"""Residents, readings and calls in one SQLite file.

Nothing here knows of HTTP or of roles: who may see what is ``web.py``'s. Times are UTC, from the
clock that is given.
"""

from __future__ import annotations

import hashlib
import hmac
import json
import secrets
import sqlite3
from collections.abc import Callable, Mapping
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

from msgspec import Struct

from ward_records.errors import Locked, MovedOut, Unfit, Unknown, WrongPin
from ward_records.names import as_kana, must_be_a_name

TRIES, PAUSE = 5, timedelta(minutes=5)
"""So many wrong PINs in a room, and none is looked at for so long."""

KINDS: dict[str, dict[str, tuple[float, float]]] = {
    "pressure": {"systolic": (40, 300), "diastolic": (20, 200), "pulse": (20, 250)},
    "oxygen": {"oxygen": (40, 100), "pulse": (20, 250)},
    "glucose": {"glucose": (0.5, 40)},
    "game": {"score": (0, 5)},
}
"""What is measured, and between which values anybody can live: all else is a fault of a device.
A game is its score: who knows less from week to week is to be looked at."""

LIMITS: dict[str, float] = {
    "systolic_low": 100,
    "systolic_high": 150,
    "diastolic_low": 55,
    "diastolic_high": 95,
    "oxygen_low": 92,
    "glucose_low": 4.0,
    "glucose_high": 12.0,
}
"""Between these nobody is told, for whom the nurse has not set others. In mmHg, %, mmol/L."""

URGENT = ("fall", "help", "help at night")
"""Why somebody calls who can not wait."""

_SCHEMA = """
CREATE TABLE IF NOT EXISTS resident (
  id INTEGER PRIMARY KEY, room INTEGER NOT NULL, name TEXT NOT NULL,
  salt BLOB NOT NULL, pin BLOB NOT NULL, limits TEXT NOT NULL, kana TEXT NOT NULL DEFAULT ''
);
CREATE TABLE IF NOT EXISTS wrong_pin (room INTEGER NOT NULL, at TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS reading (
  id INTEGER PRIMARY KEY, resident INTEGER NOT NULL REFERENCES resident (id),
  at TEXT NOT NULL, kind TEXT NOT NULL, measured TEXT NOT NULL
);
CREATE INDEX IF NOT EXISTS reading_of ON reading (resident, kind, at);
CREATE TABLE IF NOT EXISTS call (
  id INTEGER PRIMARY KEY, at TEXT NOT NULL, why TEXT NOT NULL, room TEXT NOT NULL, seen TEXT
);
CREATE TABLE IF NOT EXISTS moved_out (
  resident INTEGER PRIMARY KEY REFERENCES resident (id), at TEXT NOT NULL, kept INTEGER NOT NULL
);
CREATE TABLE IF NOT EXISTS call_left (call INTEGER PRIMARY KEY REFERENCES call (id));
CREATE VIEW IF NOT EXISTS lives_here AS
  SELECT * FROM resident WHERE id NOT IN (SELECT resident FROM moved_out);
"""


class Resident(Struct, frozen=True):
    """limits: as ``LIMITS``, the person's own. kana: how the name is said, where it is known."""

    id: int
    name: str
    room: int
    limits: dict[str, float]
    kana: str = ""


class Reading(Struct, frozen=True):
    """measured: name to value, as in ``KINDS``."""

    resident: int
    at: datetime
    kind: str
    measured: dict[str, float]


class Call(Struct, frozen=True):
    """seen: when a nurse said that she goes; None: nobody yet. left: of who has moved out since."""

    id: int
    at: datetime
    why: str
    room: str
    seen: datetime | None
    left: bool = False


class Store:
    """The records in ``file``; in memory where there is none. To be used from one thread."""

    def __init__(self, file: Path | None, now: Callable[[], datetime]) -> None:
        if file is not None:
            # Nobody else on this machine reads what stands in it.
            file.touch(mode=0o600, exist_ok=True)
        self._db = sqlite3.connect(str(file) if file is not None else ":memory:")
        self._db.execute("PRAGMA foreign_keys = ON")
        # What is taken away is not to be read in the file afterwards.
        self._db.execute("PRAGMA secure_delete = ON")
        self._db.executescript(_SCHEMA)
        self.add_column("resident", "kana")
        self._now = now

    @property
    def db(self) -> sqlite3.Connection:
        """For what else is kept of the residents, in the same file."""
        return self._db

    def add_column(self, table: str, column: str) -> None:
        """Of texts, where a file of an earlier version does not have it."""
        if column not in {row[1] for row in self._db.execute(f"PRAGMA table_info({table})")}:
            self._db.execute(f"ALTER TABLE {table} ADD COLUMN {column} TEXT NOT NULL DEFAULT ''")

    def close(self) -> None:
        self._db.close()

    # -- residents ---------------------------------------------------------------

    def add(self, room: int, name: str, pin: str, kana: str = "") -> Resident:
        """A new resident, with the usual limits. Raises Unfit where there is no name, nothing tells
        how one in kanji is said, the PIN is not four digits, or somebody in the room has it."""
        kana = as_kana(kana)
        must_be_a_name(name, kana)
        self._must_be_free(room, pin)
        salt = secrets.token_bytes(16)
        with self._db:
            made = self._db.execute(
                "INSERT INTO resident (room, name, kana, salt, pin, limits) "
                "VALUES (?, ?, ?, ?, ?, '{}')",
                (room, name, kana, salt, _hashed(pin, salt)),
            )
        assert made.lastrowid is not None
        return self.resident(made.lastrowid)

    def change(self, number: int, room: int, name: str, pin: str | None, kana: str = "") -> None:
        """Another name, room or PIN (None: as it is). Raises Unknown, and Unfit as ``add``; where
        somebody lives in the new room a new PIN is needed: nobody knows whether the old ones are
        the same, for no file holds them."""
        here, kana = self.resident(number), as_kana(kana)
        must_be_a_name(name, kana)
        if pin is not None:
            self._must_be_free(room, pin, but=number)
        elif room != here.room and any(one.room == room for one in self.residents()):
            raise Unfit("somebody lives in room {0}: give a new PIN, too", room)
        with self._db:
            self._db.execute(
                "UPDATE resident SET room = ?, name = ?, kana = ? WHERE id = ?",
                (room, name, kana, number),
            )
            if pin is not None:
                salt = secrets.token_bytes(16)
                self._db.execute(
                    "UPDATE resident SET salt = ?, pin = ? WHERE id = ?",
                    (salt, _hashed(pin, salt), number),
                )

    def _must_be_free(self, room: int, pin: str, but: int | None = None) -> None:
        if not (len(pin) == 4 and pin.isascii() and pin.isdigit()):
            raise Unfit("a PIN is four digits")
        if self._who(room, pin) not in (None, but):
            raise Unfit("somebody in this room has this PIN already")

    def residents(self) -> list[Resident]:
        """By room."""
        rows = self._db.execute(
            "SELECT id, name, room, limits, kana FROM lives_here ORDER BY room, id"
        )
        return [_resident(row) for row in rows]

    def resident(self, number: int) -> Resident:
        """Raises Unknown, and MovedOut."""
        rows = self._db.execute(
            "SELECT id, name, room, limits, kana FROM lives_here WHERE id = ?", (number,)
        )
        row = rows.fetchone()
        if row is None:
            raise self._nobody(number)
        return _resident(row)

    def _nobody(self, number: int) -> Unknown:
        lived = self._db.execute("SELECT 1 FROM moved_out WHERE resident = ?", (number,))
        if lived.fetchone() is not None:
            return MovedOut(f"resident {number} has moved out")
        return Unknown(f"there is no resident {number}")

    def login(self, room: int, pin: str) -> Resident:
        """Whose room and PIN these are. Raises WrongPin; Locked after ``TRIES`` of them."""
        since = (self._now() - PAUSE).isoformat()
        with self._db:
            # Later than now: the clock was set back, and the room would be locked until then.
            self._db.execute("DELETE FROM wrong_pin WHERE at <= ? OR at > ?", (since, self.time()))
        wrong = "SELECT count(*) FROM wrong_pin WHERE room = ?"
        if self._db.execute(wrong, (room,)).fetchone()[0] >= TRIES:
            raise Locked("too many wrong PINs: it is looked at again in some minutes")
        found = self._who(room, pin)
        with self._db:
            if found is None:
                self._db.execute("INSERT INTO wrong_pin VALUES (?, ?)", (room, self.time()))
            elif self._lives_alone(room):
                # Else who tries the neighbour's could go on for ever with an own one in between.
                self._db.execute("DELETE FROM wrong_pin WHERE room = ?", (room,))
        if found is None:
            raise WrongPin("this room and this PIN do not go together")
        return self.resident(found)

    def pin_mark(self, number: int) -> str:
        """Another one for each PIN that was ever given, which tells nothing of the PIN."""
        row = self._db.execute("SELECT salt FROM lives_here WHERE id = ?", (number,)).fetchone()
        if row is None:
            raise self._nobody(number)
        return hashlib.sha256(row[0]).hexdigest()[:16]

    def set_limits(self, number: int, limits: Mapping[str, float]) -> None:
        """The person's own. Raises Unknown, and Unfit where they are none."""
        self.resident(number)
        if set(limits) != set(LIMITS):
            raise Unfit(f"the limits are {', '.join(LIMITS)}")
        for which, (least, most) in (one for kind in KINDS.values() for one in kind.items()):
            low, high = limits.get(f"{which}_low", least), limits.get(f"{which}_high", most)
            if not least <= low < high <= most:
                said = "{0}: the lower limit below the upper, {1} to {2}"
                raise Unfit(said, which, f"{least:g}", f"{most:g}")
        with self._db:
            self._db.execute(
                "UPDATE resident SET limits = ? WHERE id = ?", (json.dumps(dict(limits)), number)
            )

    def _who(self, room: int, pin: str) -> int | None:
        rows = self._db.execute("SELECT id, salt, pin FROM lives_here WHERE room = ?", (room,))
        # All are looked at, however early one fits: how long it takes tells nothing.
        fits = [number for number, salt, kept in rows if _same(_hashed(pin, salt), kept)]
        return fits[0] if fits else None

    def _lives_alone(self, room: int) -> bool:
        lives = self._db.execute("SELECT count(*) FROM lives_here WHERE room = ?", (room,))
        return bool(lives.fetchone()[0] == 1)

    # -- what the robot tells ----------------------------------------------------

    def keep(self, told: Mapping[str, Any]) -> None:
        """A reading ``{"kind", "user", …}`` or a call ``{"kind": "call", "why", "room"}``,
        with its ``user``, too, where it is known who calls.

        Numbers may be texts that read as numbers. Raises Unfit, Unknown; MovedOut where all that
        was measured of them was taken away.
        """
        kind = told.get("kind")
        if kind == "call":
            self._keep_call(told)
            return
        wanted = KINDS.get(kind) if isinstance(kind, str) else None
        if wanted is None:
            raise Unfit(f"the kind must be call or one of {', '.join(KINDS)}")
        measured = {}
        for name, (low, high) in wanted.items():
            value = number_in(told.get(name))
            if value is None or not low <= value <= high:
                raise Unfit(f"{name} must be a number from {low:g} to {high:g}")
            measured[name] = value
        who = number_in(told.get("user"))
        if who is None or not who.is_integer():
            raise Unfit("user must be the id that login gave")
        self.must_be_kept(int(who))
        with self._db:
            self._db.execute(
                "INSERT INTO reading (resident, at, kind, measured) VALUES (?, ?, ?, ?)",
                (int(who), self.time(), kind, json.dumps(measured)),
            )

    def must_be_kept(self, number: int) -> None:
        """Of who moved out with all readings kept, what the robot still had is kept too. Raises
        Unknown and MovedOut."""
        kept = "SELECT 1 FROM moved_out WHERE resident = ? AND kept"
        if self._db.execute(kept, (number,)).fetchone() is None:
            self.resident(number)

    def _keep_call(self, told: Mapping[str, Any]) -> None:
        why, room = (str(told.get(name) or "").strip()[:200] for name in ("why", "room"))
        if not why:
            raise Unfit("a call needs why")
        # From wherever it comes: a call is never refused for what its sensor did not say.
        room = room or "place not known"
        with self._db:
            made = self._db.execute(
                "INSERT INTO call (at, why, room) VALUES (?, ?, ?)", (self.time(), why, room)
            )
            # The robot had it still when they moved out.
            self._db.execute(
                "INSERT INTO call_left SELECT ? FROM moved_out WHERE resident = ?",
                (made.lastrowid, number_in(told.get("user"))),
            )

    # -- what the nurse reads ----------------------------------------------------

    def readings(self, number: int | None = None) -> list[Reading]:
        """Of one resident or of all; the newest first."""
        rows = self._db.execute(
            "SELECT resident, at, kind, measured FROM reading WHERE ?1 IS NULL OR resident = ?1 "
            "ORDER BY at DESC, id DESC",
            (number,),
        )
        return [_reading(*row) for row in rows]

    def readings_of_each_kind(self, number: int, most: int) -> list[Reading]:
        """The last ones of each kind, of one resident; the newest first."""
        rows = self._db.execute(
            "SELECT resident, at, kind, measured FROM (SELECT *, row_number() OVER "
            "(PARTITION BY kind ORDER BY at DESC, id DESC) AS place FROM reading "
            "WHERE resident = ?) WHERE place <= ? ORDER BY at DESC, id DESC",
            (number, most),
        )
        return [_reading(*row) for row in rows]

    def calls(self, most: int = 50) -> list[Call]:
        """Those that nobody has seen first, of these who may lie on the floor; then the newest."""
        rows = self._db.execute(
            "SELECT id, at, why, room, seen, id IN (SELECT call FROM call_left) FROM call "
            "ORDER BY seen IS NOT NULL, seen IS NULL AND why NOT IN (?, ?, ?), at DESC, id DESC "
            "LIMIT ?",
            (*URGENT, most),
        )
        return [
            Call(number, _at(at), why, room, _at(seen) if seen is not None else None, bool(left))
            for number, at, why, room, seen, left in rows
        ]

    def see(self, call: int) -> None:
        """A nurse goes there; seen once is seen. Of who has moved out since it then goes."""
        with self._db:
            if self._db.execute("DELETE FROM call_left WHERE call = ?", (call,)).rowcount:
                self._db.execute("DELETE FROM call WHERE id = ?", (call,))
            self._db.execute(
                "UPDATE call SET seen = ? WHERE id = ? AND seen IS NULL", (self.time(), call)
            )

    def part_from_calls(self, room: int) -> None:
        """Those from a room where nobody lives any more are taken away, but one that nobody has
        seen: it is still gone to, and goes when it is seen. In the transaction of the caller."""
        if any(one.room == room for one in self.residents()):
            return
        self._db.execute("DELETE FROM call WHERE room = ? AND seen IS NOT NULL", (str(room),))
        self._db.execute(
            "INSERT OR IGNORE INTO call_left SELECT id FROM call WHERE room = ?", (str(room),)
        )

    def time(self) -> str:
        """Now, as it is written down."""
        return self._now().isoformat()


def number_in(value: Any) -> float | None:
    """A number, or a text that reads as one; None: anything else."""
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        return None
    try:
        number = float(value)
    except (ValueError, OverflowError):
        return None
    return number if abs(number) < 1e12 else None


def _resident(row: tuple[int, str, int, str, str]) -> Resident:
    number, name, room, limits, kana = row
    return Resident(number, name, room, LIMITS | json.loads(limits), kana)


def _reading(resident: int, at: str, kind: str, measured: str) -> Reading:
    return Reading(resident, _at(at), kind, json.loads(measured))


def _at(text: str) -> datetime:
    return datetime.fromisoformat(text)


def _hashed(pin: str, salt: bytes) -> bytes:
    # Four digits are soon tried out by who has the file: the file's mode is what keeps them.
    return hashlib.scrypt(pin.encode(), salt=salt, n=2**12, r=8, p=1)


def _same(one: bytes, other: bytes) -> bool:
    return hmac.compare_digest(one, other)
