"""What the nurse's page shows of ``day.py`` and ``watching.py``, as HTML."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ward_records import unread
from ward_records.day import ROUNDS, Medicine, Reminder
from ward_records.forms import Entry, stood
from ward_records.language import say
from ward_records.page import HIDDEN, asked, framed, removal, table
from ward_records.store import Resident

ROUND = {"morning": "Morning", "noon": "Noon", "evening": "Evening"}
_OUTCOME = {
    None: "–",
    "taken": "taken",
    "refused": "not taken",
    "nobody": "nobody answered",
    "no way": "no way there",
    "told": "told",
    "later": "told again later",
}
_TOLD = "The robot has said that a nurse sees them. It stays until you or they let it go."
_WELL = (None, "taken", "told", "later")


def watched_rooms(rooms: Sequence[str], open_: bool) -> str:
    """Links to what the robot sees now; nothing where it sees nothing."""
    links = "".join(
        f'<li class="open"><span>{say("The robot is with somebody")}: '
        f"<strong>{say('room {0}').format(escape(room))}</strong></span>"
        f'<a class="button" href="/watch/{escape(room)}">{say("Look")}</a></li>'
        for room in rooms
        if open_
    )
    return f'<h2>{say("With somebody")}</h2><ul id="watch">{links}</ul>' if links else ""


def today(
    medicines: Sequence[Medicine],
    reminders: Sequence[Reminder],
    residents: Sequence[Resident],
    open_: bool,
    entry: Entry,
) -> str:
    """A page of the rounds and what is told, with a form to have something told.

    entry: one that was not taken.
    """
    rows = "".join(
        f"<tr><td>{say(ROUND[one.round])}</td><td>{one.room if open_ else HIDDEN}</td>"
        f"<td>{escape(one.what) if open_ else HIDDEN}</td>{_outcome(one.outcome, open_)}</tr>"
        for one in medicines
    )
    medicine = (
        table("medicines", ("Round", "Room", "Medicine", "Today"), rows)
        if rows
        else f"<p>{say('Nobody is given anything.')}</p>"
    )
    told = "".join(_reminder(one, open_) for one in reminders)
    listed = (
        table("reminders", ("At", "For", "Message", "Today", ""), told)
        if told
        else f"<p>{say('Nothing is to be told today.')}</p>"
    )
    # In the table it would be a column of single words on a telephone.
    notes = "".join(unread.told(one.what, f"{one.begins}: ") for one in reminders if open_)
    form = _new(residents, entry) if open_ else ""
    body = (
        f'<p><a href="/">{say("Ward")}</a></p><h1>{say("Today")}</h1>'
        f"<h2>{say('Medicine')}</h2>{medicine}"
        f"<h2>{say('What the robot tells')}</h2>{listed}{notes}{form}"
    )
    return framed("Today", body)


def _reminder(one: Reminder, open_: bool) -> str:
    if one.room is None:
        whom, what = say("all"), escape(one.what)
    else:
        room = say("room {0}").format(one.room)
        whom, what = (room, escape(one.what)) if open_ else (HIDDEN, HIDDEN)
    remove = removal(f"/reminders/{one.id}", what) if open_ else ""
    return (
        f"<tr><td>{one.begins}</td><td>{whom}</td><td>{what}</td>"
        f"{_outcome(one.outcome, open_ or one.room is None)}<td>{remove}</td></tr>"
    )


def forget(one: Reminder) -> str:
    """Asks once more."""
    whom = say("all") if one.room is None else say("room {0}").format(one.room)
    what = f"{one.begins}, {whom}: {one.what}"
    return asked((say("Today"), "/today"), "Today", one.what, what, f"/reminders/{one.id}")


def _outcome(outcome: str | None, open_: bool) -> str:
    if not open_:
        return f"<td>{HIDDEN}</td>"
    outside = "" if outcome in _WELL else ' class="outside"'
    return f"<td{outside}>{say(_OUTCOME[outcome])}</td>"


def _new(residents: Sequence[Resident], entry: Entry) -> str:
    given = entry.given
    whom = "".join(
        f'<option value="{one.id}"{" selected" if given.get("whom") == str(one.id) else ""}>'
        f"{say('Room {0}').format(one.room)}, {escape(one.name)}</option>"
        for one in residents
    )
    begins, what = escape(given.get("begins", "")), escape(given.get("what", ""))
    daily = " checked" if "daily" in given else ""
    return (
        f"<h3>{say('Have the robot tell')}</h3>{entry.told}"
        '<form method="post" action="/reminders">'
        f'<label for="begins">{say("At")}</label>'
        f'<input id="begins" name="begins" type="time" required value="{begins}">'
        f'<label for="what">{say("Message")}</label>'
        f'<input id="what" name="what" maxlength="200" required value="{what}">'
        f'<label for="whom">{say("For")}</label><select id="whom" name="whom">'
        f'<option value="">{say("all, where the robot is")}</option>{whom}</select>'
        f'<label class="tick"><input type="checkbox" name="daily" value="yes"{daily}> '
        f"{say('every day')}</label><button>{say('Add')}</button></form>"
    )


def written(medicines: Sequence[Medicine]) -> dict[str, str]:
    """What one resident is given, as it stands in its form."""
    return dict.fromkeys(ROUNDS, "") | {one.round: one.what for one in medicines}


def medicine_form(resident: int, medicines: Sequence[Medicine], entry: Entry) -> str:
    """What one resident is given, to be changed. entry: one that was not taken."""
    fields = "".join(
        f'<label for="{name}">{say(ROUND[name])}</label>'
        f'<input id="{name}" name="{name}" maxlength="200" '
        f'value="{escape(entry.given.get(name, value))}">{stood(name, value)}{unread.told(value)}'
        for name, value in written(medicines).items()
    )
    return (
        f'<h2 id="medicine">{say("Medicine")}</h2>'
        f"<p>{say('As the robot is to say it, with how to take it. Empty: nothing then.')}</p>"
        f'{entry.told}<form method="post" action="/residents/{resident}/medicine#medicine">'
        f"{fields}<button>{say('Save medicine')}</button></form>"
    )


def watch(room: str) -> str:
    """What the robot sees in a room; the picture renews itself in its frame."""
    shown = escape(room)
    body = (
        f'<p><a href="/">{say("Ward")}</a></p><h1>{say("Room {0}").format(shown)}</h1>'
        f'<iframe class="camera" src="/watch/{shown}/live" title="{say("What the robot sees")}">'
        f"</iframe><p>{say(_TOLD)}</p>"
        f'<form method="post" action="/watch/{shown}">'
        f"<button>{say('Help is there')}</button></form>"
    )
    return framed("Room", body)


def live(room: str, seen: bool) -> str:
    """The inside of the frame, which asks for the next picture every second."""
    picture = (
        f'<img class="camera" src="/watch/{escape(room)}/picture" '
        f'alt="{say("What the robot sees")}">'
        if seen
        else f'<p id="nothing">{say("The robot shows nothing now.")}</p>'
    )
    return framed("Camera", picture, refresh=1)
