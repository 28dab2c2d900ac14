"""What the robot does by itself, over HTTP.

=========================================  ==================================================
``POST /rounds`` {round}                   {round: [{id, room, what, round}, …]}: who is to be
                                           visited now; 400: no such round
``POST /schedule``                         {notices, reminders}: what is still to be told today
``PUT /watch/ROOM`` a picture              {watched, ended}; 415: no picture
``GET /watch/ROOM``                        a nurse looks; ``/live`` and ``/picture`` are in it
``POST /watch/ROOM``                       help is there, from that page's button
``GET /today``                             medicine and reminders of today, a page
``POST /reminders``, ``/reminders/ID``     something is to be told, or no more, from the page;
                                           ``GET /reminders/ID`` asks whether no more
``POST /residents/ID/medicine``            what somebody is given, from her page
=========================================  ==================================================
"""

from __future__ import annotations

from collections.abc import Callable

from aiohttp import web

from ward_records import day_page, page
from ward_records.access import Tokens
from ward_records.answers import refused, shown
from ward_records.day import Day
from ward_records.errors import Unfit, Unknown
from ward_records.forms import NOTHING, Entry, not_taken, overtaken, settle, texts
from ward_records.language import why
from ward_records.store import Store
from ward_records.watching import KINDS, Picture, Watching

LARGEST = 512 * 1024
"""Bytes of a picture."""

_ROOM = "/watch/{room:[A-Za-z0-9-]{1,20}}"


class DayWeb:
    """resident: her page, with what she is given that was not taken."""

    def __init__(
        self,
        store: Store,
        day: Day,
        watching: Watching,
        tokens: Tokens,
        resident: Callable[[int, Entry], web.Response],
    ) -> None:
        self._store = store
        self._day = day
        self._watching = watching
        self._tokens = tokens
        self._resident = resident

    def add_to(self, router: web.UrlDispatcher) -> None:
        router.add_post("/rounds", self._round)
        router.add_post("/schedule", self._schedule)
        router.add_put(_ROOM, self._show)
        router.add_get(_ROOM, self._watch)
        router.add_get(f"{_ROOM}/live", self._live)
        router.add_get(f"{_ROOM}/picture", self._picture)
        router.add_post(_ROOM, self._end)
        router.add_get("/today", self._today)
        router.add_post("/reminders", self._remind)
        router.add_get("/reminders/{id:[0-9]{1,9}}", self._ask)
        router.add_post("/reminders/{id:[0-9]{1,9}}", self._forget)
        router.add_post("/residents/{id:[0-9]{1,9}}/medicine", self._prescribe)

    # -- parts of other pages ----------------------------------------------------

    def watched(self, open_: bool) -> str:
        return day_page.watched_rooms(self._watching.rooms(), open_)

    def medicine_form(self, resident: int, entry: Entry) -> str:
        return day_page.medicine_form(resident, self._day.medicines(resident), entry)

    # -- what the robot asks -----------------------------------------------------

    async def _round(self, request: web.Request) -> web.Response:
        asked = await self._tokens.asked(request)
        try:
            return web.json_response({"round": self._day.round(str(asked.get("round")))})
        except Unfit as unfit:
            return refused(400, str(unfit))

    async def _schedule(self, request: web.Request) -> web.Response:
        self._tokens.must_be_robot(request)
        return web.json_response(self._day.schedule())

    async def _show(self, request: web.Request) -> web.Response:
        self._tokens.must_be_robot(request)
        if request.content_type not in KINDS:
            return refused(415, f"a picture is one of {', '.join(KINDS)}")
        content = await request.clone(client_max_size=LARGEST).read()
        picture = Picture(request.content_type, content)
        return web.json_response(self._watching.show(request.match_info["room"], picture))

    # -- what the nurse does -----------------------------------------------------

    async def _today(self, request: web.Request) -> web.Response:
        role = self._tokens.nurse(request)
        if role is None:
            return shown(page.entrance(), 403)
        return self._day_shown(role == "operator")

    def _day_shown(self, open_: bool, entry: Entry = NOTHING) -> web.Response:
        every = (self._day.medicines(), self._day.reminders(), self._store.residents())
        return shown(day_page.today(*every, open_, entry), entry.status)

    async def _watch(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        return shown(day_page.watch(request.match_info["room"]))

    async def _live(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        room = request.match_info["room"]
        return shown(day_page.live(room, self._watching.look(room) is not None))

    async def _picture(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        picture = self._watching.look(request.match_info["room"])
        if picture is None:
            raise web.HTTPNotFound(text="the robot shows nothing now")
        return web.Response(body=picture.content, content_type=picture.kind)

    async def _end(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        self._watching.end(request.match_info["room"])
        raise web.HTTPSeeOther("/")

    async def _remind(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        form = await texts(request)
        whom = form.get("whom", "0")
        try:
            # What is meant for one is never told to all for a number that can not be read.
            number = int(whom) if whom.isdecimal() and len(whom) < 10 else 0
            who = self._store.resident(number).id if whom else None
            self._day.remind(form.get("begins", ""), form.get("what", ""), who, "daily" in form)
        except Unfit as unfit:
            return self._day_shown(True, not_taken(form, why(unfit), "Not added: {0}"))
        except Unknown as unknown:
            return self._day_shown(True, not_taken(form, str(unknown), "Not added: {0}"))
        raise web.HTTPSeeOther("/today")

    async def _ask(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        number = int(request.match_info["id"])
        for one in self._day.reminders():
            if one.id == number:
                return shown(day_page.forget(one))
        raise web.HTTPSeeOther("/today")

    async def _forget(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        self._day.forget(int(request.match_info["id"]))
        raise web.HTTPSeeOther("/today")

    async def _prescribe(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        form = await texts(request)
        try:
            who = self._store.resident(int(request.match_info["id"])).id
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        settled = settle(form, day_page.written(self._day.medicines(who)))
        if settled.crossed:
            return self._resident(who, overtaken(settled, day_page.ROUND))
        for name, what in settled.values.items():
            self._day.prescribe(who, name, what)
        raise web.HTTPSeeOther(f"/residents/{who}?saved=medicine")
