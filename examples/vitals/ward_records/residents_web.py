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
from ward_records.language import why
from ward_records.store import KINDS, Reading, Resident, Store, Unfit, Unknown


class ResidentsWeb:
    """must: raises where a request may not. resident: her page, with what was given to its form
    and what is wrong with it.
    """

    def __init__(
        self,
        store: Store,
        must: Callable[[web.Request], None],
        resident: Callable[[int, Mapping[str, str], str], web.Response],
    ) -> None:
        self._store = store
        self._must = must
        self._resident = resident

    def add_to(self, router: web.UrlDispatcher) -> None:
        router.add_get("/residents", self._new)
        router.add_post("/residents", self._add)
        router.add_post("/residents/{id:[0-9]{1,9}}/person", self._change)
        router.add_get("/readings.csv", self._every)
        router.add_get("/residents/{id:[0-9]{1,9}}/readings.csv", self._hers)

    async def _new(self, request: web.Request) -> web.Response:
        self._must(request)
        return shown(residents_page.add({}))

    async def _add(self, request: web.Request) -> web.Response:
        self._must(request)
        given = await _given(request)
        try:
            made = self._store.add(_room(given), given.get("name", ""), given.get("pin", ""))
        except Unfit as unfit:
            return shown(residents_page.add(given, why(unfit)), 400)
        raise web.HTTPSeeOther(f"/residents/{made.id}")

    async def _change(self, request: web.Request) -> web.Response:
        self._must(request)
        number, given = int(request.match_info["id"]), await _given(request)
        name, pin = given.get("name", ""), given.get("pin", "")
        try:
            self._store.change(number, _room(given), name, pin or None)
        except Unfit as unfit:
            return self._resident(number, given, why(unfit))
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        raise web.HTTPSeeOther(f"/residents/{number}")

    async def _every(self, request: web.Request) -> web.Response:
        self._must(request)
        return _table(self._store.residents(), self._store.readings(), "readings.csv")

    async def _hers(self, request: web.Request) -> web.Response:
        self._must(request)
        try:
            one = self._store.resident(int(request.match_info["id"]))
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        return _table([one], self._store.readings(one.id), f"readings-{one.room}.csv")


async def _given(request: web.Request) -> dict[str, str]:
    form = await request.post()
    return {name: value.strip() for name, value in form.items() if isinstance(value, str)}


def _room(given: Mapping[str, str]) -> int:
    """Raises Unfit."""
    room = given.get("room", "")
    if not (room.isascii() and room.isdigit() and len(room) <= 4):
        raise Unfit("the room must be a number")
    return int(room)


def _table(residents: Sequence[Resident], readings: Sequence[Reading], name: str) -> web.Response:
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
