"""Who moves out: nobody logs in with their PIN any more, and what was kept of them is taken away.

Their number stays, with nothing beside it: what the robot still has of it must never be taken for
somebody else's.
"""

from __future__ import annotations

from datetime import datetime

from msgspec import Struct

from ward_records.contacts import Contacts
from ward_records.day import Day
from ward_records.errors import MovedOut
from ward_records.store import Store


class Former(Struct, frozen=True):
    """Who lived here, and whose readings were kept."""

    id: int
    name: str
    room: int
    at: datetime


class MovingOut:
    """From one store, with what else is kept of its residents."""

    def __init__(self, store: Store, day: Day, contacts: Contacts) -> None:
        self._store = store
        self._day = day
        self._contacts = contacts
        self._db = store.db

    def remove(self, number: int, *, readings: bool) -> None:
        """readings: what was measured of them stays, with the name and the room; how their visits
        ended, too. Of all else nothing stays, nor of the calls from a room where nobody is left,
        once they are seen. Raises Unknown."""
        room = self._store.resident(number).room
        with self._db:
            self._db.execute(
                "INSERT INTO moved_out VALUES (?, ?, ?)",
                (number, self._store.time(), readings),
            )
            self._db.execute(
                "UPDATE resident SET salt = x'', pin = x'', limits = '{}', kana = '' WHERE id = ?",
                (number,),
            )
            self._day.part_from(number, visits=not readings)
            self._contacts.part_from(number)
            if not readings:
                self._take_away(number)
            self._store.part_from_calls(room)

    def take_away(self, number: int) -> None:
        """The readings of who has moved out already. Raises Unknown."""
        self.former(number)
        with self._db:
            self._day.part_from(number, visits=True)
            self._take_away(number)

    def _take_away(self, number: int) -> None:
        self._db.execute("DELETE FROM reading WHERE resident = ?", (number,))
        self._db.execute("UPDATE resident SET name = '', room = 0 WHERE id = ?", (number,))
        self._db.execute("UPDATE moved_out SET kept = 0 WHERE resident = ?", (number,))

    def all(self) -> list[Former]:
        """The last one first."""
        rows = self._db.execute(
            "SELECT r.id, r.name, r.room, m.at FROM moved_out m "
            "JOIN resident r ON r.id = m.resident WHERE m.kept ORDER BY m.at DESC, r.id DESC"
        )
        return [
            Former(number, name, room, datetime.fromisoformat(at))
            for number, name, room, at in rows
        ]

    def former(self, number: int) -> Former:
        """Raises MovedOut where nothing was kept of them, or they never lived here."""
        for one in self.all():
            if one.id == number:
                return one
        raise MovedOut(f"of resident {number} nothing is kept")
