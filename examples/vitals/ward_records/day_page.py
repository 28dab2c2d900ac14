"""What the nurse's page shows of ``day.py`` and ``watching.py``, as HTML."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ward_records.day import ROUNDS, Medicine, Reminder
from ward_records.page import HIDDEN, framed
from ward_records.store import Resident

_ROUND = {"morning": "Morning", "noon": "Noon", "evening": "Evening"}
_OUTCOME = {
    None: "–",
    "taken": "taken",
    "refused": "not taken",
    "nobody": "nobody answered",
    "no way": "no way there",
    "told": "told",
    "later": "told again later",
}
_WELL = (None, "taken", "told", "later")


def watched_rooms(rooms: Sequence[str], open_: bool) -> str:
    """Links to what the robot sees now; nothing where it sees nothing."""
    links = "".join(
        f'<li class="open"><span>The robot is in <strong>room {escape(room)}</strong></span>'
        f'<a class="button" href="/watch/{escape(room)}">Look</a></li>'
        for room in rooms
        if open_
    )
    return f'<h2>With somebody</h2><ul id="watch">{links}</ul>' if links else ""


def today(
    medicines: Sequence[Medicine],
    reminders: Sequence[Reminder],
    residents: Sequence[Resident],
    open_: bool,
    wrong: str = "",
) -> str:
    """A page of the rounds and what is told, with a form to have something told.

    wrong: what is wrong with what was just given.
    """
    rows = "".join(
        f"<tr><td>{_ROUND[one.round]}</td><td>{one.room if open_ else HIDDEN}</td>"
        f"<td>{escape(one.what) if open_ else HIDDEN}</td>{_outcome(one.outcome, open_)}</tr>"
        for one in medicines
    )
    medicine = (
        '<table id="medicines"><thead><tr><th>Round</th><th>Room</th><th>Medicine</th>'
        f"<th>Today</th></tr></thead><tbody>{rows}</tbody></table>"
        if rows
        else "<p>Nobody is given anything.</p>"
    )
    told = "".join(_reminder(one, open_) for one in reminders)
    listed = (
        '<table id="reminders"><thead><tr><th>At</th><th>For</th><th>What</th><th>Today</th><th>'
        f"</th></tr></thead><tbody>{told}</tbody></table>"
        if told
        else "<p>Nothing is to be told today.</p>"
    )
    form = _new(residents, wrong) if open_ else ""
    body = (
        f'<p><a href="/">Ward</a></p><h1>Today</h1><h2>Medicine</h2>{medicine}'
        f"<h2>What the robot tells</h2>{listed}{form}"
    )
    return framed("Today", body)


def _reminder(one: Reminder, open_: bool) -> str:
    if one.room is None:
        whom, what = "all", escape(one.what)
    else:
        whom, what = (f"room {one.room}", escape(one.what)) if open_ else (HIDDEN, HIDDEN)
    remove = (
        f'<form method="post" action="/reminders/{one.id}">'
        f'<button class="quiet" aria-label="Remove {what}">Remove</button></form>'
        if open_
        else ""
    )
    return (
        f"<tr><td>{one.begins}</td><td>{whom}</td><td>{what}</td>"
        f"{_outcome(one.outcome, open_ or one.room is None)}<td>{remove}</td></tr>"
    )


def _outcome(outcome: str | None, open_: bool) -> str:
    if not open_:
        return f"<td>{HIDDEN}</td>"
    outside = "" if outcome in _WELL else ' class="outside"'
    return f"<td{outside}>{_OUTCOME[outcome]}</td>"


def _new(residents: Sequence[Resident], wrong: str) -> str:
    told = f'<p class="wrong" role="alert">Not added: {escape(wrong)}</p>' if wrong else ""
    whom = "".join(
        f'<option value="{one.id}">Room {one.room}, {escape(one.name)}</option>'
        for one in residents
    )
    return (
        f'<h3>Have the robot tell</h3>{told}<form method="post" action="/reminders">'
        '<label for="begins">At</label><input id="begins" name="begins" type="time" required>'
        '<label for="what">What</label><input id="what" name="what" maxlength="200" required>'
        '<label for="whom">For</label><select id="whom" name="whom">'
        f'<option value="">all, where the robot is</option>{whom}</select>'
        '<label class="tick"><input type="checkbox" name="daily" value="yes"> every day</label>'
        "<button>Add</button></form>"
    )


def medicine_form(resident: int, medicines: Sequence[Medicine]) -> str:
    """What one resident is given, to be changed."""
    given = {one.round: one.what for one in medicines}
    fields = "".join(
        f'<label for="{name}">{_ROUND[name]}</label>'
        f'<input id="{name}" name="{name}" maxlength="200" value="{escape(given.get(name, ""))}">'
        for name in ROUNDS
    )
    return (
        "<h2>Medicine</h2><p>As the robot is to say it, with how to take it. Empty: nothing then."
        f'</p><form method="post" action="/residents/{resident}/medicine">{fields}'
        "<button>Save medicine</button></form>"
    )


def watch(room: str) -> str:
    """What the robot sees in a room; the picture renews itself in its frame."""
    shown = escape(room)
    body = (
        f'<p><a href="/">Ward</a></p><h1>Room {shown}</h1>'
        f'<iframe class="camera" src="/watch/{shown}/live" title="What the robot sees"></iframe>'
        "<p>The robot has said that a nurse sees them. It stays until you or they let it go.</p>"
        f'<form method="post" action="/watch/{shown}"><button>Help is there</button></form>'
    )
    return framed("Room", body)


def live(room: str, seen: bool) -> str:
    """The inside of the frame, which asks for the next picture every second."""
    picture = (
        f'<img class="camera" src="/watch/{escape(room)}/picture" alt="What the robot sees">'
        if seen
        else '<p id="nothing">The robot shows nothing now.</p>'
    )
    return framed("Camera", picture, refresh=1)
