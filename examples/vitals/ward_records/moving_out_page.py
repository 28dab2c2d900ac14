"""Who moves out, and who has, as HTML."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ward_records.language import say
from ward_records.moving_out import Former
from ward_records.page import framed, table, when
from ward_records.store import Resident

_GONE = (
    "The robot then knows this person no more: nobody logs in with their PIN, and whoever is "
    "logged in is logged out. Medicine, messages and contacts are taken away, and a round that "
    "is under way passes by."
)


def confirm(one: Resident, readings: int) -> str:
    """Asks once more. readings: how many there are of them."""
    name = escape(one.name)
    asked = say("Remove {0}, room {1}?").format(name, one.room)
    choice = _choice(one.id, readings) if readings else _no_choice()
    body = (
        f'<p><a href="/residents/{one.id}">{name}</a></p><h1>{asked}</h1><p>{say(_GONE)}</p>'
        f'<form method="post" action="/residents/{one.id}/remove">{choice}'
        f'<button class="alarm">{say("Remove {0}").format(name)}</button></form>'
        f'<p><a href="/residents/{one.id}">{say("No, go back")}</a></p>'
    )
    return framed("Remove this resident", body)


def _choice(number: int, readings: int) -> str:
    # None of them is chosen beforehand: either can be wrong for ever.
    keep = say("Keep them, with name and room, until you take them away.")
    erase = say("Take them away now, for ever.")
    saved = f'<a href="/residents/{number}/readings.csv" download>'
    return (
        f"<fieldset><legend>{say('What was measured: {0} readings').format(readings)}</legend>"
        '<label class="tick"><input type="radio" name="readings" value="keep" required> '
        f'{keep}</label><label class="tick"><input type="radio" name="readings" value="erase"> '
        f"{erase}</label><p>{saved}{say('Readings as a table (CSV)')}</a></p></fieldset>"
    )


def _no_choice() -> str:
    return (
        f"<p>{say('Nothing has been measured yet.')}</p>"
        '<input type="hidden" name="readings" value="erase">'
    )


def former(those: Sequence[Former]) -> str:
    """Who has moved out with readings kept."""
    rows = "".join(_row(one) for one in those)
    heads = ("Name", "Room", "Moved out", "", "")
    listed = table("moved-out", heads, rows) if rows else f"<p>{say('Of nobody.')}</p>"
    body = (
        f'<p><a href="/">{say("Ward")}</a></p><h1>{say("Who has moved out")}</h1>'
        f"<p>{say('Of these the readings were kept.')}</p>{listed}"
    )
    return framed("Who has moved out", body)


def _row(one: Former) -> str:
    saved = f'<a href="/residents/{one.id}/readings.csv" download>{say("Table (CSV)")}</a>'
    erase = f'<a href="/moved-out/{one.id}">{say("Take them away")}</a>'
    return (
        f"<tr><td>{escape(one.name)}</td><td>{one.room}</td><td>{when(one.at)}</td>"
        f"<td>{saved}</td><td>{erase}</td></tr>"
    )


def confirm_erasing(one: Former) -> str:
    name = escape(one.name)
    body = (
        f'<p><a href="/moved-out">{say("Who has moved out")}</a></p>'
        f"<h1>{say('Take away what was measured of {0}?').format(name)}</h1>"
        f"<p>{say('Name and room go with it. Nobody gets it back.')}</p>"
        f'<form method="post" action="/moved-out/{one.id}">'
        f'<button class="alarm">{say("Take it away for ever")}</button></form>'
        f'<p><a href="/moved-out">{say("No, go back")}</a></p>'
    )
    return framed("Who has moved out", body)
