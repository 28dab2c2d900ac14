"""Whom a resident may call, as HTML, to be changed by the nurse."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape

from ward_records.contacts import Contact
from ward_records.forms import Entry
from ward_records.language import say
from ward_records.page import asked, kana_field, removal, table
from ward_records.store import Resident

_GROUPS = {"family": "Family", "friends": "Friends"}


def form(resident: int, contacts: Mapping[str, Sequence[Contact]], entry: Entry) -> str:
    """contacts: by group. entry: one that was not taken."""
    rows = "".join(_row(resident, group, one) for group, those in contacts.items() for one in those)
    given = entry.given
    chosen = given.get("group")
    groups = "".join(
        f'<option value="{group}"{" selected" if group == chosen else ""}>{say(label)}</option>'
        for group, label in _GROUPS.items()
    )
    listed = table("contacts", ("Name", "Group", "Address", ""), rows) if rows else ""
    return (
        f'<h2 id="contacts">{say("Whom they may call")}</h2>{listed}{entry.told}'
        f'<form method="post" action="/residents/{resident}/contacts#contacts">'
        f'<label for="contact">{say("Name")}</label>'
        '<input id="contact" name="contact" maxlength="80" autocomplete="off" required '
        f'value="{escape(given.get("contact", ""))}">'
        f"{kana_field('contact-kana', given.get('contact', ''), given.get('contact-kana', ''))}"
        f'<label for="group">{say("Group")}</label>'
        f'<select id="group" name="group">{groups}</select>'
        f'<label for="address">{say("Address of the video program")}</label>'
        '<input id="address" name="address" maxlength="200" autocomplete="off" required '
        f'value="{escape(given.get("address", ""))}">'
        f"<button>{say('Add contact')}</button></form>"
    )


def remove(resident: Resident, one: Contact) -> str:
    """Asks once more."""
    back = (resident.name, f"/residents/{resident.id}#contacts")
    more = f"{one.name}, {one.address}"
    return asked(back, "Resident", one.name, more, f"{_removed(resident.id, one)}#contacts")


def _removed(resident: int, one: Contact) -> str:
    return f"/residents/{resident}/contacts/{one.id}/remove"


def _row(resident: int, group: str, one: Contact) -> str:
    remove = removal(_removed(resident, one), escape(one.name))
    return (
        f"<tr><td>{escape(one.name)}</td><td>{say(_GROUPS[group])}</td>"
        f'<td class="address">{escape(one.address)}</td><td>{remove}</td></tr>'
    )
