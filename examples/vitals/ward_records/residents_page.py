"""Forms for who lives in the ward, as HTML."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

from ward_records.forms import Entry, stood
from ward_records.language import say
from ward_records.page import framed, kana_field
from ward_records.store import Resident

LABELS = {
    "name": "Name",
    "kana": "How the name is said, in kana",
    "room": "Room",
    "pin": "New PIN; empty: as it is",
}


def add(entry: Entry) -> str:
    """For somebody new. entry: one that was not taken."""
    body = (
        f'<p><a href="/">{say("Ward")}</a></p><h1>{say("Add a resident")}</h1>'
        f'{entry.told}<form method="post" action="/residents">'
        f"{_fields(entry.given, say('PIN, four digits'), True)}"
        f"<button>{say('Add')}</button></form>"
    )
    return framed("Add a resident", body)


def written(one: Resident) -> dict[str, str]:
    """As it stands in its form; the PIN never does."""
    return {"name": one.name, "kana": one.kana, "room": str(one.room)}


def change(one: Resident, pin_mark: str, entry: Entry) -> str:
    """For one who is there. pin_mark: that of ``Store``. entry: one that was not taken."""
    stands = written(one)
    before = "".join(stood(name, value) for name, value in {**stands, "pin": pin_mark}.items())
    return (
        f'<h2 id="person">{say("Resident")}</h2>{entry.told}'
        f'<form method="post" action="/residents/{one.id}/person#person">'
        f"{_fields({**stands, **entry.given}, say(LABELS['pin']), False)}{before}"
        f"<button>{say('Save resident')}</button></form>"
        f'<p><a href="/residents/{one.id}/remove">{say("Remove this resident")}</a></p>'
    )


def _fields(given: Mapping[str, str], pin: str, needed: bool) -> str:
    # A PIN that was given does not come back into the page.
    return (
        f'<label for="name">{say("Name")}</label>'
        f'<input id="name" name="name" maxlength="80" autocomplete="off" required '
        f'value="{escape(given.get("name", ""))}">'
        f"{kana_field('kana', given.get('name', ''), given.get('kana', ''))}"
        f'<label for="room">{say("Room")}</label>'
        f'<input id="room" name="room" inputmode="numeric" autocomplete="off" required '
        f'value="{escape(given.get("room", ""))}">'
        f'<label for="pin">{pin}</label>'
        f'<input id="pin" name="pin" inputmode="numeric" autocomplete="off" maxlength="4"'
        f"{' required' if needed else ''}>"
    )
