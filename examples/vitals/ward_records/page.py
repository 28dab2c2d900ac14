"""The nurse's page as HTML: large, plain, without a script. All that is shown is escaped."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import datetime
from html import escape
from pathlib import Path

from ward_records.curves import LINES, MOST, curve, is_outside
from ward_records.forms import Entry, stood
from ward_records.language import say, spoken
from ward_records.names import needs_kana
from ward_records.store import LIMITS, Call, Reading, Resident

HIDDEN = "•••"
STYLE = (Path(__file__).parent / "page.css").read_text(encoding="utf-8")

LABELS = {
    "systolic_low": "Systolic, lower limit, mmHg",
    "systolic_high": "Systolic, upper limit, mmHg",
    "diastolic_low": "Diastolic, lower limit, mmHg",
    "diastolic_high": "Diastolic, upper limit, mmHg",
    "oxygen_low": "Oxygen, lower limit, %",
    "glucose_low": "Glucose, lower limit, mmol/L",
    "glucose_high": "Glucose, upper limit, mmol/L",
}
_KINDS = {
    "pressure": "Blood pressure",
    "oxygen": "Blood oxygen",
    "glucose": "Blood glucose",
    "game": "Brain game",
}
_LAST = ("Measured last", "When")
_MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
_LISTED = 30
"""Readings of one resident; all of them are in the table to take away."""


def entrance(wrong: str = "") -> str:
    """For whoever has no token yet."""
    told = f'<p class="wrong" role="alert">{say(wrong)}</p>' if wrong else ""
    form = (
        f'<form method="get" action="/"><label for="token">{say("Your token")}</label>'
        '<input id="token" name="token" type="password" autocomplete="off" required autofocus>'
        f"<button>{say('Open')}</button></form>"
    )
    return framed("Ward", f"<h1>{say('Ward')}</h1>{told}{form}")


def ward(
    residents: Sequence[Resident],
    latest: Mapping[int, Sequence[Reading]],
    calls: Sequence[Call],
    watched: str,
    open_: bool,
    moved_out: bool = False,
) -> str:
    """Calls, then residents with what was measured last. open_: what is private is shown.

    watched: links to what the robot sees now. moved_out: of some who have, readings were kept.
    """
    rows = "".join(_resident_row(one, latest[one.id], open_) for one in residents)
    body = (
        f"<h1>{say('Ward')}</h1>{_note(open_)}{watched}"
        f"<h2>{say('Calls')}</h2>{_calls(calls, open_)}"
        f'<p><a href="/today">{say("Medicine, and what is told today")}</a></p>'
        f"<h2>{say('Residents')}</h2>{table('residents', ('Room', 'Name', *_LAST), rows)}"
        f"{_managed(moved_out) if open_ else ''}"
    )
    return framed("Ward", body, refresh=10)


def resident(
    one: Resident, readings: Sequence[Reading], forms: str, open_: bool, limits: Entry
) -> str:
    """One resident. forms: those beside that of the limits; limits: those that were not taken."""
    name = escape(one.name) if open_ else HIDDEN
    rows = "".join(
        f"<tr><td>{when(each.at)}</td><td>{say(_KINDS[each.kind])}</td>"
        f"{_value(one, each, open_)}</tr>"
        for each in readings[:_LISTED]
    )
    measured = (
        table("readings", ("When", "What", "Measured"), rows)
        if readings
        else f"<p>{say('Nothing has been measured yet.')}</p>"
    )
    body = (
        f'<p><a href="/">{say("Ward")}</a></p><h1>{name}</h1>'
        f"<p>{say('Room {0}').format(one.room if open_ else HIDDEN)}</p>"
        f"{_note(open_)}{_places() if open_ else ''}"
        f"<h2>{say('Measured')}</h2>{_curves(one, readings) if open_ else ''}"
        f"{measured}"
    )
    return framed("Resident", body + (_taken_away(one) + _limits(one, limits) + forms) * open_)


def _places() -> str:
    """Where on this long page something is; a form, when sent, comes back to its own."""
    places = {
        "limits": "Limits",
        "medicine": "Medicine",
        "contacts": "Whom they may call",
        "person": "Resident",
    }
    links = "".join(f'<a href="#{place}">{say(label)}</a> ' for place, label in places.items())
    return f'<p class="links">{links}</p>'


def _curves(one: Resident, readings: Sequence[Reading]) -> str:
    found = []
    for kind in LINES:
        those = [each for each in readings if each.kind == kind][:MOST]
        if those:
            span = f"{when(those[-1].at)}{when(those[0].at)}"
            found.append(curve(kind, say(_KINDS[kind]), those, one.limits, span))
    return f'<div class="curves">{"".join(found)}</div>'


def _taken_away(one: Resident) -> str:
    href = f"/residents/{one.id}/readings.csv"
    return f'<p><a href="{href}" download>{say("Readings as a table (CSV)")}</a></p>'


def _managed(moved_out: bool) -> str:
    left = f' <a href="/moved-out">{say("Who has moved out")}</a>' if moved_out else ""
    return (
        f'<p class="links"><a href="/residents">{say("Add a resident")}</a> '
        f'<a href="/readings.csv" download>{say("All readings as a table (CSV)")}</a>{left}</p>'
    )


def table(name: str, heads: Sequence[str], rows: str) -> str:
    """heads: as ``say`` knows them, empty ones too. It is scrolled where it is too wide."""
    told = "".join(f"<th>{say(head) if head else ''}</th>" for head in heads)
    return (
        f'<div class="wide"><table id="{name}"><thead><tr>{told}</tr></thead>'
        f"<tbody>{rows}</tbody></table></div>"
    )


def removal(href: str, what: str) -> str:
    """In a row of a table: leads to where it is asked once more. what: as HTML."""
    return (
        f'<a class="quiet" href="{href}" aria-label="{say("Remove")}: {what}">{say("Remove")}</a>'
    )


def asked(back: tuple[str, str], title: str, what: str, more: str, action: str) -> str:
    """A page that asks whether something is to be removed. back: label and address of the page
    that it came from; more: of it, in a line."""
    label, href = escape(back[0]), back[1]
    body = (
        f'<p><a href="{href}">{label}</a></p>'
        f"<h1>{say('Remove {0}?').format(escape(what))}</h1><p>{escape(more)}</p>"
        f'<form method="post" action="{action}">'
        f'<button class="alarm">{say("Remove")}</button></form>'
        f'<p><a href="{href}">{say("No, go back")}</a></p>'
    )
    return framed(title, body)


def kana_field(field: str, name: str, kana: str) -> str:
    """How a name is said: asked for where names are Japanese, or this one is. The browser asks for
    nothing: whether it is needed is known by the name that is sent, not by the one that stood here.
    """
    if not (kana or needs_kana(name) or spoken() == "ja"):
        return ""
    return (
        f'<label for="{field}">{say("How the name is said, in kana")}</label>'
        f'<input id="{field}" name="{field}" maxlength="80" autocomplete="off" '
        f'value="{escape(kana)}">'
    )


def written(limits: Mapping[str, float]) -> dict[str, str]:
    """As they stand in their form."""
    return {name: f"{limits[name]:g}" for name in LIMITS}


def _limits(one: Resident, entry: Entry) -> str:
    stands = written(one.limits)
    fields = "".join(
        f'<label for="{name}">{say(LABELS[name])}</label>'
        f'<input id="{name}" name="{name}" inputmode="decimal" required '
        f'value="{escape(entry.given.get(name, value))}">{stood(name, value)}'
        for name, value in stands.items()
    )
    return (
        f'<h2 id="limits">{say("Limits")}</h2>'
        f"<p>{say('Outside of these the robot measures again, and then calls you.')}</p>"
        f'{entry.told}<form method="post" action="/residents/{one.id}#limits">{fields}'
        f"<button>{say('Save')}</button></form>"
    )


def _calls(calls: Sequence[Call], open_: bool) -> str:
    if not calls:
        return f'<p id="quiet">{say("Nobody has called.")}</p>'
    return f'<ul id="calls">{"".join(_call(one, open_) for one in calls)}</ul>'


def _call(one: Call, open_: bool) -> str:
    why, room = (escape(say(one.why)), escape(say(one.room))) if open_ else (HIDDEN, HIDDEN)
    where = say("room {0}").format(room) if room.isdigit() else room
    said = f"<strong>{where}</strong>: {why}, {when(one.at)}"
    if one.left and open_:
        left = say("who lived there has moved out: this goes once you have seen it")
        said += f"<br><small>{left}</small>"
    if one.seen is not None:
        return f'<li class="seen">{said} · {say("seen")} {when(one.seen)}</li>'
    button = (
        f'<form method="post" action="/calls/{one.id}"><button>{say("I am going")}</button></form>'
        if open_
        else ""
    )
    return f'<li class="open"><span>{said}</span>{button}</li>'


def _resident_row(one: Resident, last: Sequence[Reading], open_: bool) -> str:
    room, name = (str(one.room), escape(one.name)) if open_ else (HIDDEN, HIDDEN)
    measured = _value(one, last[0], open_) if last else "<td>–</td>"
    since = when(last[0].at) if last else "–"
    link = f'<a href="/residents/{one.id}">{name}</a>'
    return f"<tr><td>{room}</td><td>{link}</td>{measured}<td>{since}</td></tr>"


def _value(one: Resident, reading: Reading, open_: bool) -> str:
    if not open_:
        return f"<td>{HIDDEN}</td>"
    value = reading.measured
    if reading.kind == "pressure":
        pressure = f"{value['systolic']:g} / {value['diastolic']:g}"
        shown = f"{pressure}, {say('pulse')} {value['pulse']:g}"
    elif reading.kind == "oxygen":
        shown = f"{value['oxygen']:g} %, {say('pulse')} {value['pulse']:g}"
    elif reading.kind == "game":
        shown = say("{0} of 5").format(f"{value['score']:g}")
    else:
        shown = f"{value['glucose']:g} mmol/L"
    if any(is_outside(name, each, one.limits) for name, each in value.items()):
        return f'<td class="outside">{shown} <small>{say("outside of the limits")}</small></td>'
    return f"<td>{shown}</td>"


def _note(open_: bool) -> str:
    said = say("With this token private data are not shown.")
    return "" if open_ else f"<p class='note'>{said}</p>"


def when(at: datetime) -> str:
    local = at.astimezone()
    # In words: by numbers, the month comes first for some and last for others.
    shown = f"{local.day} {_MONTHS[local.month - 1]} {local:%H:%M}"
    if spoken() == "ja":
        shown = f"{local.month}月{local.day}日 {local:%H:%M}"
    return f'<time datetime="{at.isoformat()}">{shown}</time>'


def framed(title: str, body: str, refresh: int = 0) -> str:
    """A whole page. refresh: seconds after which the browser asks for it again; 0: never."""
    again = f'<meta http-equiv="refresh" content="{refresh}">' if refresh else ""
    return (
        f'<!doctype html><html lang="{spoken()}"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<meta name="color-scheme" content="light dark">{again}<title>{say(title)}</title>'
        '<link rel="icon" href="data:,"><link rel="stylesheet" href="/page.css"></head>'
        f"<body><main>{body}</main></body></html>"
    )
