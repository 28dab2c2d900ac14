"""The records over HTTP: what the robot asks, and the nurse's page.

======================================  =====================================================
``POST /login`` {room, pin, language}   {user: {id, name, said, room, limits}, messages:
                                        [{reminder, days, begins, what}, …]}: the voice of the
                                        language has the name ``said``; 401: not this PIN, 429:
                                        too many wrong ones
``POST /lives`` {user}                  {lives: true}; 410: has moved out, 404: no such resident
``POST /readings`` {reading}            {kept: true}; 400: no such reading, 404: no such resident,
                                        410: has moved out, and nothing of theirs is kept
``GET /``                               the nurse's page
``GET /residents/ID``                   one resident: readings, limits
``POST /residents/ID``                  her limits, from that page's form
``POST /calls/ID``                      a nurse goes there, from the page's button
======================================  =====================================================

What the robot does by itself is ``day_web.py``'s; who lives here and tables to take away,
``residents_web.py``'s; who moves out, ``moving_out_web.py``'s; whom they may call,
``contacts_web.py``'s; who may do what, ``access.py``'s.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping
from types import MappingProxyType
from typing import Any

from aiohttp import web

from situ.resources import resource
from ward_records import page, residents_page
from ward_records.access import COOKIE, Tokens
from ward_records.answers import refused, shown
from ward_records.contacts import Contacts
from ward_records.contacts_web import ContactsWeb
from ward_records.curves import MOST
from ward_records.day import OUTCOMES, Day
from ward_records.day_web import DayWeb
from ward_records.errors import Locked, MovedOut, Unfit, Unknown, WrongPin
from ward_records.forms import NOTHING, Entry, not_taken, overtaken, saved, settle, texts
from ward_records.language import speak, wanted, why
from ward_records.moving_out import MovingOut
from ward_records.moving_out_web import MovingOutWeb
from ward_records.names import said
from ward_records.residents_web import ResidentsWeb
from ward_records.store import Reading, Store, number_in
from ward_records.watching import Watching

LONGEST_BODY = 64 * 1024

Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


def application(store: Store, day: Day, watching: Watching, tokens: Tokens) -> web.Application:
    """The whole service, to be run by aiohttp."""
    contacts = Contacts(store)
    moving_out = MovingOut(store, day, contacts)
    ward = _Ward(store, day, watching, contacts, moving_out, tokens)
    made = web.Application(client_max_size=LONGEST_BODY, middlewares=[_careful])
    made.router.add_post("/login", ward.login)
    made.router.add_post("/lives", ward.lives)
    made.router.add_post("/readings", ward.keep)
    made.router.add_get("/", ward.page)
    made.router.add_get("/page.css", ward.style)
    made.router.add_static("/fonts", resource("fonts"))
    made.router.add_get("/residents/{id:[0-9]{1,9}}", ward.resident)
    made.router.add_post("/residents/{id:[0-9]{1,9}}", ward.set_limits)
    made.router.add_post("/calls/{id:[0-9]{1,9}}", ward.see)
    ward.of_day.add_to(made.router)
    ward.of_contacts.add_to(made.router)
    must, person = tokens.must_be_operator, ward.once_more("person")
    ResidentsWeb(store, must, moving_out, person).add_to(made.router)
    MovingOutWeb(store, must, moving_out).add_to(made.router)
    return made


@web.middleware
async def _careful(request: web.Request, handler: Handler) -> web.StreamResponse:
    """No answer but a font is kept by a browser, shown in a strange page, or may run anything."""
    speak(wanted(request.headers.get("Accept-Language", "")))
    try:
        if not _is_ours(request):
            raise web.HTTPForbidden(text="a form of another page is not taken")
        answer = await handler(request)
    except web.HTTPException as said:
        _guard(request, said)
        raise
    _guard(request, answer)
    return answer


def _is_ours(request: web.Request) -> bool:
    """Whether what a nurse's browser sends to change something comes from this very page: another
    port of the same machine is the same site to ``SameSite``."""
    if request.method in ("GET", "HEAD") or COOKIE not in request.cookies:
        return True
    site = request.headers.get("Sec-Fetch-Site")
    if site is not None:
        # No page can say this itself; behind a proxy with TLS the origin is another than ours.
        return site == "same-origin"
    origin = request.headers.get("Origin")
    return origin is None or origin == f"{request.scheme}://{request.host}"


def _guard(request: web.Request, answer: web.StreamResponse) -> None:
    kept = "max-age=86400" if request.path.startswith("/fonts/") else "no-store"
    # What the camera sees stands in a frame of the nurse's page.
    framed = "'self'" if request.path.endswith("/live") else "'none'"
    answer.headers["Cache-Control"] = kept
    # By it a form says where it comes from; nobody else is told an address.
    answer.headers["Referrer-Policy"] = "same-origin"
    answer.headers["X-Content-Type-Options"] = "nosniff"
    answer.headers["Content-Security-Policy"] = (
        "default-src 'none'; style-src 'self'; font-src 'self'; img-src 'self' data:; "
        f"frame-src 'self'; form-action 'self'; frame-ancestors {framed}; base-uri 'none'"
    )


class _Ward:
    def __init__(
        self,
        store: Store,
        day: Day,
        watching: Watching,
        contacts: Contacts,
        moving_out: MovingOut,
        tokens: Tokens,
    ) -> None:
        self._store = store
        self._day = day
        self._moving_out = moving_out
        self._tokens = tokens
        self.of_day = DayWeb(store, day, watching, tokens, self.once_more("medicine"))
        self.of_contacts = ContactsWeb(store, contacts, tokens, self.once_more("contact"))

    # -- what the robot asks -----------------------------------------------------

    async def login(self, request: web.Request) -> web.Response:
        asked = await self._tokens.asked(request)
        room, pin = number_in(asked.get("room")), asked.get("pin")
        if room is None or not room.is_integer() or not isinstance(pin, str):
            return refused(400, "room must be a number and pin a text")
        try:
            found = self._store.login(int(room), pin)
        except WrongPin as wrong:
            return refused(401, str(wrong))
        except Locked as locked:
            return refused(429, str(locked))
        user = {
            "id": found.id,
            "name": found.name,
            "said": said(found.name, found.kana, str(asked.get("language"))),
            "room": found.room,
            "limits": found.limits,
        }
        return web.json_response({"user": user, "messages": self._day.missed(found.id)})

    async def lives(self, request: web.Request) -> web.Response:
        asked = await self._tokens.asked(request)
        who = number_in(asked.get("user"))
        if who is None or not who.is_integer():
            return refused(400, "user must be the id that login gave")
        try:
            self._store.resident(int(who))
        except MovedOut as gone:
            return refused(410, str(gone))
        except Unknown as unknown:
            return refused(404, str(unknown))
        return web.json_response({"lives": True})

    async def keep(self, request: web.Request) -> web.Response:
        asked = await self._tokens.asked(request)
        reading = asked.get("reading")
        if not isinstance(reading, dict):
            return refused(400, "reading must be an object")
        try:
            self._keep(reading)
        except Unfit as unfit:
            return refused(400, str(unfit))
        except MovedOut as gone:
            return refused(410, str(gone))
        except Unknown as unknown:
            return refused(404, str(unknown))
        return web.json_response({"kept": True})

    def _keep(self, reading: dict[str, Any]) -> None:
        kind = reading.get("kind")
        if isinstance(kind, str) and kind in OUTCOMES:
            self._day.keep(reading)
        else:
            self._store.keep(reading)

    # -- the nurse's page --------------------------------------------------------

    async def page(self, request: web.Request) -> web.Response:
        given = request.query.get("token")
        if given is not None:
            if self._tokens.role(given) is None:
                return shown(page.entrance("There is no such token."), 403)
            # Out of the address: it would stand in the history of the browser.
            answer = web.Response(status=303, headers={"Location": "/"})
            answer.set_cookie(COOKIE, given, httponly=True, samesite="Strict", max_age=12 * 3600)
            return answer
        role = self._tokens.nurse(request)
        if role is None:
            return shown(page.entrance(), 403)
        residents = self._store.residents()
        latest = {one.id: self._measured(one.id) for one in residents}
        open_ = role == "operator"
        watched, left = self.of_day.watched(open_), bool(self._moving_out.all())
        return shown(page.ward(residents, latest, self._store.calls(), watched, open_, left))

    def _measured(self, number: int) -> list[Reading]:
        """The last reading of the body: a game does not hide it."""
        last = self._store.readings_of_each_kind(number, most=1)
        return [one for one in last if one.kind != "game"][:1]

    async def resident(self, request: web.Request) -> web.Response:
        role = self._tokens.nurse(request)
        if role is None:
            return shown(page.entrance(), 403)
        form = request.query.get("saved", "")
        taken = {form: saved()} if form else {}
        return self._resident(int(request.match_info["id"]), role == "operator", taken)

    async def set_limits(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        number, form = int(request.match_info["id"]), await texts(request)
        try:
            settled = settle(form, page.written(self._store.resident(number).limits))
            if settled.crossed:
                return self._resident(number, True, {"limits": overtaken(settled, page.LABELS)})
            limits = {name: number_in(value) for name, value in settled.values.items()}
            given = {name: value for name, value in limits.items() if value is not None}
            self._store.set_limits(number, given)
        except Unfit as unfit:
            entry = not_taken(settled.values, why(unfit))
            return self._resident(number, True, {"limits": entry})
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        raise web.HTTPSeeOther(f"/residents/{number}?saved=limits")

    async def see(self, request: web.Request) -> web.Response:
        self._tokens.must_be_operator(request)
        self._store.see(int(request.match_info["id"]))
        raise web.HTTPSeeOther("/")

    async def style(self, _: web.Request) -> web.Response:
        return web.Response(text=page.STYLE, content_type="text/css")

    def once_more(self, form: str) -> Callable[[int, Entry], web.Response]:
        """Her page, with what was given to one of its forms and not taken."""
        return lambda number, entry: self._resident(number, True, {form: entry})

    def _resident(
        self, number: int, open_: bool, entries: Mapping[str, Entry] = MappingProxyType({})
    ) -> web.Response:
        """entries: what was taken last, or not taken, by its form."""
        try:
            found = self._store.resident(number)
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        limits, person, contact, medicine = (
            entries.get(form, NOTHING) for form in ("limits", "person", "contact", "medicine")
        )
        forms = (
            self.of_day.medicine_form(number, medicine)
            + self.of_contacts.form(number, contact)
            + residents_page.change(found, self._store.pin_mark(number), person)
        )
        readings = self._store.readings_of_each_kind(number, most=MOST)
        made = page.resident(found, readings, forms, open_, limits)
        return shown(made, max((entry.status for entry in entries.values()), default=200))
