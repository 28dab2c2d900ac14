"""What the robot does by itself: medicine at three rounds a day, and what is told at which time.

Kept in the file of ``store.py``. Days and times of day are those of ``zone``, the ward's.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Mapping
from datetime import date, datetime, timedelta, tzinfo
from typing import Any

from msgspec import Struct

from ward_records.errors import MovedOut, Unfit
from ward_records.store import number_in

ROUNDS = ("morning", "noon", "evening")

OUTCOMES = {
    "medication": ("taken", "refused", "nobody", "no way"),
    "reminder": ("told", "later", "nobody"),
}
"""How a visit ended. ``no way``: the robot could not get there."""

LEAD, AGAIN, STALE = timedelta(minutes=10), timedelta(minutes=10), timedelta(minutes=30)
"""So long before it begins something is told; so long after ``later`` and ``nobody`` it is told
again; so long after its begin no more."""

TIMES = 3
"""So often somebody is looked for who is not there."""

KEPT = timedelta(days=7)
"""So long what nobody took is kept for who logs in."""

_SCHEMA = """
CREATE TABLE IF NOT EXISTS prescription (
  resident INTEGER NOT NULL REFERENCES resident (id), round TEXT NOT NULL, what TEXT NOT NULL,
  PRIMARY KEY (resident, round)
);
CREATE TABLE IF NOT EXISTS visit (
  resident INTEGER NOT NULL REFERENCES resident (id), round TEXT NOT NULL, day TEXT NOT NULL,
  at TEXT NOT NULL, outcome TEXT NOT NULL
);
CREATE TABLE IF NOT EXISTS reminder (
  id INTEGER PRIMARY KEY, resident INTEGER REFERENCES resident (id),
  day TEXT, begins TEXT NOT NULL, what TEXT NOT NULL
);
CREATE TABLE IF NOT EXISTS telling (
  reminder INTEGER NOT NULL REFERENCES reminder (id) ON DELETE CASCADE, day TEXT NOT NULL,
  at TEXT NOT NULL, outcome TEXT NOT NULL
);
"""


class Medicine(Struct, frozen=True):
    """For one resident at one round. outcome: of today's last visit; None: not visited yet."""

    resident: int
    room: int
    round: str
    what: str
    outcome: str | None


class Reminder(Struct, frozen=True):
    """Of today. resident, room: None where all may hear it. outcome: as in ``Medicine``."""

    id: int
    resident: int | None
    room: int | None
    begins: str
    what: str
    outcome: str | None


class Day:
    """To be used from one thread, as the connection is."""

    def __init__(
        self, db: sqlite3.Connection, now: Callable[[], datetime], zone: tzinfo | None = None
    ) -> None:
        """zone: None is that of this machine."""
        self._db = db
        self._db.executescript(_SCHEMA)
        self._now = now
        self._zone = zone

    # -- what the nurse says -----------------------------------------------------

    def prescribe(self, resident: int, round_: str, what: str) -> None:
        """Nothing, where ``what`` is empty. Raises Unfit where there is no such round."""
        if round_ not in ROUNDS:
            raise Unfit(f"the round must be one of {', '.join(ROUNDS)}")
        what = what.strip()[:200]
        with self._db:
            if what:
                self._db.execute(
                    "INSERT OR REPLACE INTO prescription VALUES (?, ?, ?)", (resident, round_, what)
                )
            else:
                self._db.execute(
                    "DELETE FROM prescription WHERE resident = ? AND round = ?", (resident, round_)
                )

    def remind(self, begins: str, what: str, resident: int | None, daily: bool = False) -> None:
        """Today, or every day; for all to hear where there is no resident. Raises Unfit."""
        what = what.strip()[:200]
        if _time(begins) is None or not what:
            raise Unfit("a time as 15:30, and what there is then")
        day = None if daily else self._today()
        with self._db:
            self._db.execute(
                "INSERT INTO reminder (resident, day, begins, what) VALUES (?, ?, ?, ?)",
                (resident, day, begins, what),
            )

    def forget(self, reminder: int) -> None:
        with self._db:
            self._db.execute("DELETE FROM reminder WHERE id = ?", (reminder,))

    def part_from(self, resident: int, visits: bool) -> None:
        """Of who moves out nothing is to be given or told; visits: how those ended is taken away.
        In the transaction of the caller."""
        for table in ("prescription", "reminder", *(["visit"] if visits else [])):
            self._db.execute(f"DELETE FROM {table} WHERE resident = ?", (resident,))

    # -- what the robot asks, and tells ------------------------------------------

    def round(self, name: str) -> list[dict[str, Any]]:
        """Who is to be visited now, by room: who has not taken it today. Raises Unfit."""
        if name not in ROUNDS:
            raise Unfit(f"the round must be one of {', '.join(ROUNDS)}")
        return [
            {"id": one.resident, "room": one.room, "what": one.what, "round": name}
            for one in self.medicines()
            if one.round == name and one.outcome != "taken"
        ]

    def schedule(self) -> dict[str, list[dict[str, Any]]]:
        """What is still to be told today, each by ``at``, the time to tell it: ``notices`` for
        all, ``reminders`` for one."""
        now = self._now().astimezone(self._zone)
        # One day for all of it, though it be midnight by now.
        day = now.date().isoformat()
        found: dict[str, list[dict[str, Any]]] = {"notices": [], "reminders": []}
        for one in self._reminders(day):
            told = self._told(one.id, day)
            absent = sum(outcome == "nobody" for _, outcome in told)
            begins = now.replace(
                hour=int(one.begins[:2]), minute=int(one.begins[3:]), second=0, microsecond=0
            )
            if one.outcome == "told" or absent >= TIMES or now > begins + STALE:
                continue
            at = _no_earlier_day(begins, begins - LEAD)
            if told:
                at = _no_earlier_day(now, told[-1][0].astimezone(self._zone) + AGAIN)
            asked = {"reminder": one.id, "at": f"{at:%H:%M}", "begins": one.begins}
            if one.resident is None:
                found["notices"].append({**asked, "what": one.what})
            else:
                whom = {"id": one.resident, "room": one.room}
                found["reminders"].append({**asked, **whom, "what": one.what})
        for some in found.values():
            some.sort(key=lambda one: one["at"])
        return found

    def missed(self, resident: int) -> list[dict[str, Any]]:
        """What this one was to be told and nobody took: of today since it was time to tell it, and
        what was for one of the last days only. The latest day first, ``days`` ago."""
        now = self._now().astimezone(self._zone)
        today, time = now.date(), f"{now:%H:%M}"
        rows = self._db.execute(
            "SELECT m.id, coalesce(m.day, ?2), m.begins, m.what FROM reminder m "
            "WHERE m.resident = ?1 AND coalesce(m.day, ?2) BETWEEN ?3 AND ?2 AND NOT EXISTS "
            "(SELECT 1 FROM telling t WHERE t.reminder = m.id AND t.outcome = 'told' "
            "AND (m.day IS NOT NULL OR t.day = ?2)) ORDER BY 2 DESC, m.begins, m.id",
            (resident, today.isoformat(), (today - KEPT).isoformat()),
        )
        found = []
        for number, day, begins, what in rows:
            days = (today - date.fromisoformat(day)).days
            if days or time >= _told_from(begins):
                found.append({"reminder": number, "days": days, "begins": begins, "what": what})
        return found

    def keep(self, told: Mapping[str, Any]) -> None:
        """How a visit ended: ``{"kind": "medication", "user", "round", "outcome"}`` or
        ``{"kind": "reminder", "reminder", "outcome"}``. Raises Unfit; MovedOut as
        ``Store.keep``."""
        kind, outcome = str(told.get("kind")), told.get("outcome")
        if outcome not in OUTCOMES[kind]:
            raise Unfit(f"the outcome must be one of {', '.join(OUTCOMES[kind])}")
        number = number_in(told.get("user" if kind == "medication" else "reminder"))
        now = self._now()
        at, day = now.isoformat(), self._day(now)
        row: tuple[object, ...] = (number, day, at, outcome)
        table = "telling (reminder, day, at, outcome) VALUES (?, ?, ?, ?)"
        if kind == "medication":
            if told.get("round") not in ROUNDS:
                raise Unfit(f"the round must be one of {', '.join(ROUNDS)}")
            gone = "SELECT 1 FROM moved_out WHERE resident = ? AND NOT kept"
            if self._db.execute(gone, (number,)).fetchone() is not None:
                raise MovedOut("who had this number has moved out")
            row = (number, day, at, outcome, told["round"])
            table = "visit (resident, day, at, outcome, round) VALUES (?, ?, ?, ?, ?)"
        try:
            with self._db:
                self._db.execute(f"INSERT INTO {table}", row)
        except sqlite3.IntegrityError:
            raise Unfit("there is nobody and nothing of this number") from None

    # -- what the nurse reads ----------------------------------------------------

    def medicines(self, resident: int | None = None) -> list[Medicine]:
        """Of today, of one or all; by round, then by room."""
        rows = self._db.execute(
            "SELECT r.id, r.room, p.round, p.what, (SELECT v.outcome FROM visit v WHERE "
            "v.resident = r.id AND v.round = p.round AND v.day = ?1 ORDER BY v.rowid DESC LIMIT 1) "
            "FROM prescription p JOIN resident r ON r.id = p.resident "
            "WHERE ?2 IS NULL OR r.id = ?2 ORDER BY r.room, r.id",
            (self._today(), resident),
        )
        return sorted((Medicine(*row) for row in rows), key=lambda one: ROUNDS.index(one.round))

    def reminders(self) -> list[Reminder]:
        """Of today, by time."""
        return self._reminders(self._today())

    def _reminders(self, day: str) -> list[Reminder]:
        rows = self._db.execute(
            "SELECT m.id, m.resident, r.room, m.begins, m.what, (SELECT t.outcome FROM telling t "
            "WHERE t.reminder = m.id AND t.day = ?1 ORDER BY t.rowid DESC LIMIT 1) "
            "FROM reminder m LEFT JOIN resident r ON r.id = m.resident "
            "WHERE m.day IS NULL OR m.day = ?1 ORDER BY m.begins, m.id",
            (day,),
        )
        return [Reminder(*row) for row in rows]

    def _told(self, reminder: int, day: str) -> list[tuple[datetime, str]]:
        rows = self._db.execute(
            "SELECT at, outcome FROM telling WHERE reminder = ? AND day = ? ORDER BY rowid",
            (reminder, day),
        )
        return [(datetime.fromisoformat(at), outcome) for at, outcome in rows]

    def _today(self) -> str:
        return self._day(self._now())

    def _day(self, at: datetime) -> str:
        return at.astimezone(self._zone).date().isoformat()


def _no_earlier_day(day: datetime, at: datetime) -> datetime:
    """``at``, or the begin or the end of ``day`` where it is in another."""
    first = day.replace(hour=0, minute=0)
    return min(max(at, first), day.replace(hour=23, minute=59))


def _told_from(begins: str) -> str:
    """The time of day from which on it is told."""
    at = datetime.strptime(begins, "%H:%M")
    return f"{_no_earlier_day(at, at - LEAD):%H:%M}"


def _time(text: str) -> datetime | None:
    """A time of day written as 08:05."""
    try:
        made = datetime.strptime(text, "%H:%M")
    except ValueError:
        return None
    return made if len(text) == 5 else None
