"""Whom each resident may call from the robot. The staff are not called but come, as to any call."""

from __future__ import annotations

import re

from msgspec import Struct

from ward_records.errors import Unfit
from ward_records.names import as_kana, must_be_a_name
from ward_records.store import Store

GROUPS = ("family", "friends")

_SCHEMA = """
CREATE TABLE IF NOT EXISTS contact (
  id INTEGER PRIMARY KEY, resident INTEGER NOT NULL REFERENCES resident (id),
  kind TEXT NOT NULL, name TEXT NOT NULL, address TEXT NOT NULL, kana TEXT NOT NULL DEFAULT ''
);
"""


class Contact(Struct, frozen=True):
    """address: what the robot's video program calls. kana: how the name is said, where it is
    known."""

    id: int
    name: str
    address: str
    kana: str = ""


class Contacts:
    """Those of all residents of a store, in its file."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._db = store.db
        self._db.executescript(_SCHEMA)
        store.add_column("contact", "kana")

    def of(self, resident: int, group: str) -> list[Contact]:
        """In the order in which they were added. Raises Unknown."""
        self._store.resident(resident)
        rows = self._db.execute(
            "SELECT id, name, address, kana FROM contact "
            "WHERE resident = ? AND kind = ? ORDER BY id",
            (resident, group),
        )
        return [Contact(*row) for row in rows]

    def add(self, resident: int, group: str, name: str, address: str, kana: str = "") -> None:
        """Raises Unknown, and Unfit where it is no name, nothing tells how one in kanji is said, it
        is no group, or nothing to call."""
        self._store.resident(resident)
        kana = as_kana(kana)
        must_be_a_name(name, kana)
        # As an argument of a program it must not look like an option, nor hold what no one sees.
        if not (re.fullmatch(r"[A-Za-z0-9+]\S{0,199}", address) and address.isprintable()):
            raise Unfit("an address has no blanks and begins with a letter, a digit or +")
        if group not in GROUPS:
            raise Unfit("family or friends")
        with self._db:
            self._db.execute(
                "INSERT INTO contact (resident, kind, name, address, kana) VALUES (?, ?, ?, ?, ?)",
                (resident, group, name, address, kana),
            )

    def part_from(self, resident: int) -> None:
        """Who moves out calls nobody from here. In the transaction of the caller."""
        self._db.execute("DELETE FROM contact WHERE resident = ?", (resident,))

    def remove(self, resident: int, contact: int) -> None:
        """One who is not there is removed already."""
        with self._db:
            self._db.execute(
                "DELETE FROM contact WHERE id = ? AND resident = ?", (contact, resident)
            )
