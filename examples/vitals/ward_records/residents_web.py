"""Who lives in the ward, changed by the nurse, and what was measured as a table to take away.

======================================  =====================================================
``GET /residents``                      a form for somebody new
``POST /residents``                     somebody new, from that form
``POST /residents/ID/person``           another name, room or PIN, from her page
``GET /readings.csv``                   all readings; ``/residents/ID/readings.csv``: hers
======================================  =====================================================

All of it for operators only.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Mapping, Sequence

from aiohttp import web

from ward_records import residents_page
from ward_records.answers import shown
from ward_records.errors import Unfit, Unknown
from ward_records.forms import NOTHING, Entry, not_taken, overtaken, settle, texts
from ward_records.language import why
from ward_records.moving_out import Former, MovingOut
from ward_records.page import HIDDEN
from ward_records.store import KINDS, Reading, Resident, Store


class ResidentsWeb:
    """must: raises where a request may not. resident: her page, with what was not taken."""

    def __init__(
        self,
        store: Store,
        must: Callable[[web.Request], None],
        moving_out: MovingOut,
        resident: Callable[[int, Entry], web.Response],
    ) -> None:
        self._store = store
        self._must = must
        self._moving_out = moving_out
        self._resident = resident

    def add_to(self, router: web.UrlDispatcher) -> None:
        router.add_get("/residents", self._new)
        router.add_post("/residents", self._add)
        router.add_post("/residents/{id:[0-9]{1,9}}/person", self._change)
        router.add_get("/readings.csv", self._every)
        router.add_get("/residents/{id:[0-9]{1,9}}/readings.csv", self._hers)

    async def _new(self, request: web.Request) -> web.Response:
        self._must(request)
        return shown(residents_page.add(NOTHING))

    async def _add(self, request: web.Request) -> web.Response:
        self._must(request)
        given = await texts(request)
        try:
            name, kana = given.get("name", ""), given.get("kana", "")
            made = self._store.add(_room(given), name, given.get("pin", ""), kana)
        except Unfit as unfit:
            return shown(residents_page.add(not_taken(given, why(unfit))), 400)
        raise web.HTTPSeeOther(f"/residents/{made.id}")

    async def _change(self, request: web.Request) -> web.Response:
        self._must(request)
        number, given = int(request.match_info["id"]), await texts(request)
        pin = given.get("pin") or None
        try:
            settled = settle(given, residents_page.written(self._store.resident(number)))
            if pin and given.get("pin-was") not in (None, self._store.pin_mark(number)):
                settled.crossed["pin"] = (HIDDEN, HIDDEN)
            if settled.crossed:
                return self._resident(number, overtaken(settled, residents_page.LABELS))
            now = settled.values
            self._store.change(number, _room(now), now["name"], pin, now["kana"])
        except Unfit as unfit:
            return self._resident(number, not_taken(settled.values, why(unfit)))
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        raise web.HTTPSeeOther(f"/residents/{number}?saved=person")

    async def _every(self, request: web.Request) -> web.Response:
        self._must(request)
        every: list[Resident | Former] = [*self._store.residents(), *self._moving_out.all()]
        return _table(every, self._store.readings(), "readings.csv")

    async def _hers(self, request: web.Request) -> web.Response:
        self._must(request)
        number = int(request.match_info["id"])
        try:
            former = {each.id: each for each in self._moving_out.all()}
            one = former.get(number) or self._store.resident(number)
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        return _table([one], self._store.readings(one.id), f"readings-{one.room}.csv")


def _room(given: Mapping[str, str]) -> int:
    """Raises Unfit."""
    room = given.get("room", "")
    if not (room.isascii() and room.isdigit() and len(room) <= 4):
        raise Unfit("the room must be a number")
    return int(room)


def _table(
    residents: Sequence[Resident | Former], readings: Sequence[Reading], name: str
) -> web.Response:
    """The oldest first, times in UTC, one column for each value that can be measured."""
    values = list(dict.fromkeys(value for kind in KINDS.values() for value in kind))
    whose = {one.id: one for one in residents}
    out = io.StringIO()
    writer = csv.writer(out)
    writer.writerow(["time", "room", "name", "kind", *values])
    for one in reversed(readings):
        who = whose[one.resident]
        measured = [f"{one.measured[value]:g}" if value in one.measured else "" for value in values]
        writer.writerow([one.at.isoformat(), who.room, _text(who.name), one.kind, *measured])
    return web.Response(
        # With a mark, by which spreadsheets know that it is UTF-8.
        body=out.getvalue().encode("utf-8-sig"),
        content_type="text/csv",
        charset="utf-8",
        headers={"Content-Disposition": f'attachment; filename="{name}"'},
    )


def _text(name: str) -> str:
    """A name that a spreadsheet would take for a formula, as a text."""
    return f"'{name}" if name[:1] in ("=", "+", "-", "@", "\t", "\r") else name
