"""Forms for who lives in the ward, as HTML."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

from ward_records.language import say
from ward_records.page import framed
from ward_records.store import Resident


def add(given: Mapping[str, str], wrong: str = "") -> str:
    """For somebody new. wrong: what is wrong with what was ``given``."""
    body = (
        f'<p><a href="/">{say("Ward")}</a></p><h1>{say("Add a resident")}</h1>'
        f'{_wrong(wrong)}<form method="post" action="/residents">'
        f"{_fields(given, say('PIN, four digits'), True)}"
        f"<button>{say('Add')}</button></form>"
    )
    return framed("Add a resident", body)


def change(one: Resident, given: Mapping[str, str], wrong: str = "") -> str:
    """For one who is there."""
    stands = {"name": one.name, "room": str(one.room), **given}
    return (
        f"<h2>{say('Resident')}</h2>{_wrong(wrong)}"
        f'<form method="post" action="/residents/{one.id}/person">'
        f"{_fields(stands, say('New PIN; empty: as it is'), False)}"
        f"<button>{say('Save resident')}</button></form>"
    )


def _wrong(wrong: str) -> str:
    if not wrong:
        return ""
    return f'<p class="wrong" role="alert">{say("Not saved: {0}").format(escape(wrong))}</p>'


def _fields(given: Mapping[str, str], pin: str, needed: bool) -> str:
    # A PIN that was given does not come back into the page.
    return (
        f'<label for="name">{say("Name")}</label>'
        f'<input id="name" name="name" maxlength="80" autocomplete="off" required '
        f'value="{escape(given.get("name", ""))}">'
        f'<label for="room">{say("Room")}</label>'
        f'<input id="room" name="room" inputmode="numeric" autocomplete="off" required '
        f'value="{escape(given.get("room", ""))}">'
        f'<label for="pin">{pin}</label>'
        f'<input id="pin" name="pin" inputmode="numeric" autocomplete="off" maxlength="4"'
        f"{' required' if needed else ''}>"
    )
