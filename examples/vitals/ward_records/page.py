"""The nurse's page as HTML: large, plain, without a script. All that is shown is escaped."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import datetime
from html import escape
from pathlib import Path

from ward_records.store import LIMITS, Call, Reading, Resident

HIDDEN = "•••"
STYLE = (Path(__file__).parent / "page.css").read_text(encoding="utf-8")

_LABELS = {
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


def entrance(wrong: str = "") -> str:
    """For whoever has no token yet."""
    told = f'<p class="wrong" role="alert">{escape(wrong)}</p>' if wrong else ""
    form = (
        '<form method="get" action="/"><label for="token">Your token</label>'
        '<input id="token" name="token" type="password" autocomplete="off" required autofocus>'
        "<button>Open</button></form>"
    )
    return framed("Ward", f"<h1>Ward</h1>{told}{form}")


def ward(
    residents: Sequence[Resident],
    latest: Mapping[int, Sequence[Reading]],
    calls: Sequence[Call],
    watched: str,
    open_: bool,
) -> str:
    """Calls, then residents with what was measured last. open_: what is private is shown.

    watched: links to what the robot sees now.
    """
    rows = "".join(_resident_row(one, latest[one.id], open_) for one in residents)
    body = (
        f"<h1>Ward</h1>{_note(open_)}{watched}<h2>Calls</h2>{_calls(calls, open_)}"
        '<p><a href="/today">Medicine, and what is told today</a></p><h2>Residents</h2>'
        '<table id="residents"><thead><tr><th>Room</th><th>Name</th><th>Measured last</th>'
        f"<th>When</th></tr></thead><tbody>{rows}</tbody></table>"
    )
    return framed("Ward", body, refresh=10)


def resident(
    one: Resident, readings: Sequence[Reading], medicine: str, open_: bool, wrong: str
) -> str:
    """One resident. medicine: a form; wrong: what is wrong with the limits that were just given."""
    name = escape(one.name) if open_ else HIDDEN
    rows = "".join(
        f"<tr><td>{_when(each.at)}</td><td>{_KINDS[each.kind]}</td>{_value(one, each, open_)}</tr>"
        for each in readings
    )
    measured = (
        '<table id="readings"><thead><tr><th>When</th><th>What</th><th>Measured</th></tr></thead>'
        f"<tbody>{rows}</tbody></table>"
        if readings
        else "<p>Nothing has been measured yet.</p>"
    )
    body = (
        f'<p><a href="/">Ward</a></p><h1>{name}</h1><p>Room {one.room if open_ else HIDDEN}</p>'
        f"{_note(open_)}<h2>Measured</h2>{measured}"
    )
    return framed("Resident", body + (_limits(one, wrong) + medicine if open_ else ""))


def _limits(one: Resident, wrong: str) -> str:
    told = f'<p class="wrong" role="alert">Not saved: {escape(wrong)}</p>' if wrong else ""
    fields = "".join(
        f'<label for="{name}">{_LABELS[name]}</label>'
        f'<input id="{name}" name="{name}" inputmode="decimal" required '
        f'value="{one.limits[name]:g}">'
        for name in LIMITS
    )
    return (
        f"<h2>Limits</h2><p>Outside of these the robot measures again, and then calls you.</p>"
        f'{told}<form method="post" action="/residents/{one.id}">{fields}'
        "<button>Save</button></form>"
    )


def _calls(calls: Sequence[Call], open_: bool) -> str:
    if not calls:
        return '<p id="quiet">Nobody has called.</p>'
    return f'<ul id="calls">{"".join(_call(one, open_) for one in calls)}</ul>'


def _call(one: Call, open_: bool) -> str:
    why, room = (escape(one.why), escape(one.room)) if open_ else (HIDDEN, HIDDEN)
    where = f"room {room}" if room.isdigit() else room
    said = f"<strong>{where}</strong>: {why}, {_when(one.at)}"
    if one.seen is not None:
        return f'<li class="seen">{said} · seen {_when(one.seen)}</li>'
    button = (
        f'<form method="post" action="/calls/{one.id}"><button>I am going</button></form>'
        if open_
        else ""
    )
    return f'<li class="open"><span>{said}</span>{button}</li>'


def _resident_row(one: Resident, last: Sequence[Reading], open_: bool) -> str:
    room, name = (str(one.room), escape(one.name)) if open_ else (HIDDEN, HIDDEN)
    measured = _value(one, last[0], open_) if last else "<td>–</td>"
    when = _when(last[0].at) if last else "–"
    link = f'<a href="/residents/{one.id}">{name}</a>'
    return f"<tr><td>{room}</td><td>{link}</td>{measured}<td>{when}</td></tr>"


def _value(one: Resident, reading: Reading, open_: bool) -> str:
    if not open_:
        return f"<td>{HIDDEN}</td>"
    value = reading.measured
    if reading.kind == "pressure":
        shown = f"{value['systolic']:g} / {value['diastolic']:g}, pulse {value['pulse']:g}"
    elif reading.kind == "oxygen":
        shown = f"{value['oxygen']:g} %, pulse {value['pulse']:g}"
    elif reading.kind == "game":
        shown = f"{value['score']:g} of 5"
    else:
        shown = f"{value['glucose']:g} mmol/L"
    if _is_outside(one, reading):
        return f'<td class="outside">{shown} <small>outside of the limits</small></td>'
    return f"<td>{shown}</td>"


def _is_outside(one: Resident, reading: Reading) -> bool:
    limits = one.limits
    return any(
        not limits.get(f"{name}_low", value) <= value <= limits.get(f"{name}_high", value)
        for name, value in reading.measured.items()
    )


def _note(open_: bool) -> str:
    return "" if open_ else "<p class='note'>With this token private data are not shown.</p>"


def _when(at: datetime) -> str:
    local = at.astimezone()
    return f'<time datetime="{at.isoformat()}">{local:%d.%m. %H:%M}</time>'


def framed(title: str, body: str, refresh: int = 0) -> str:
    """A whole page. refresh: seconds after which the browser asks for it again; 0: never."""
    again = f'<meta http-equiv="refresh" content="{refresh}">' if refresh else ""
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<meta name="color-scheme" content="light dark">{again}<title>{title}</title>'
        '<link rel="icon" href="data:,"><link rel="stylesheet" href="/page.css"></head>'
        f"<body><main>{body}</main></body></html>"
    )
