"""The forms of the nurse's page: what was typed is never lost, nor what another nurse has changed.

Beside each field stands, unseen, what stood in it when the page was made. So a field that she left
as it was undoes nothing, and where two have changed the same one the later is told.
"""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from types import MappingProxyType

from aiohttp import web
from msgspec import Struct

from ward_records.language import say


class Entry(Struct, frozen=True):
    """given: what was typed into a form that was not taken; told: why not, or that another one
    was, as HTML."""

    given: Mapping[str, str] = MappingProxyType({})
    told: str = ""
    status: int = 200


NOTHING = Entry()
"""Nothing that was given was refused."""


def saved() -> Entry:
    """For the page after a form that was taken."""
    return Entry(told=f'<p class="saved" role="status">{say("Saved.")}</p>')


class Settled(Struct, frozen=True):
    """values: what is to stand in each field. crossed: those that another nurse has changed
    meanwhile, too: to what they were, and what they are."""

    values: dict[str, str]
    crossed: dict[str, tuple[str, str]]


async def texts(request: web.Request) -> dict[str, str]:
    """What stands in a form that was sent, without blanks around it."""
    form = await request.post()
    return {name: value.strip() for name, value in form.items() if isinstance(value, str)}


def settle(form: Mapping[str, str], stands: Mapping[str, str]) -> Settled:
    """What a form says, against what ``stands`` there now. A field without what stood there is
    taken as it is."""
    values, crossed = {}, {}
    for name, now in stands.items():
        given, was = form.get(name, ""), form.get(f"{name}-was")
        values[name] = now if given == was else given
        if was is not None and now not in (was, values[name]):
            crossed[name] = (was, now)
    return Settled(values, crossed)


def stood(name: str, value: str) -> str:
    """Beside a field: what stands there, where nobody sees it."""
    return f'<input type="hidden" name="{name}-was" value="{escape(value)}">'


def not_taken(form: Mapping[str, str], why: str, said: str = "Not saved: {0}") -> Entry:
    told = escape(say(said).format(why))
    return Entry(form, f'<p class="wrong" role="alert">{told}</p>', 400)


def overtaken(settled: Settled, labels: Mapping[str, str]) -> Entry:
    """Of what she typed nothing was saved, but all of it stands there still. labels: of the
    fields, as ``say`` knows them."""
    changed = "".join(
        f"<li>{say(labels[name])}: {escape(was) or '–'} → {escape(now) or '–'}</li>"
        for name, (was, now) in settled.crossed.items()
    )
    told = say("Another nurse has changed this meanwhile:")
    on = say("What you typed stands here still. Save once more, and it replaces that.")
    wrong = f'<div class="wrong" role="alert"><p>{told}</p><ul>{changed}</ul><p>{on}</p></div>'
    return Entry(settled.values, wrong, 409)
