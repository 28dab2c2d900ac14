"""The records over HTTP: what the robot asks, and the nurse's page.

======================================  =====================================================
``POST /login`` {room, pin}             {user: {id, name, room, limits}}; 401: not this PIN, 429:
                                        too many wrong ones
``POST /readings`` {reading}            {kept: true}; 400: no such reading, 404: no such resident
``POST /contacts`` {user, group}        {contacts: [{id, name, address}, …]}; 404: no such resident
``GET /``                               the nurse's page
``GET /residents/ID``                   one resident: readings, limits
``POST /residents/ID``                  her limits, from that page's form
``POST /calls/ID``                      a nurse goes there, from the page's button
======================================  =====================================================

Roles are those of docs/security.md: the robot has the token of a service and may log people in
and write; an operator's token opens the page; with a viewer's, what is private is •••, and
nothing can be changed. The page takes its token once, by ``/?token=TOKEN``, and keeps it in a
cookie of this browser.
"""

from __future__ import annotations

import json
from collections.abc import Awaitable, Callable
from typing import Any, Literal

from aiohttp import web
from msgspec import Struct, to_builtins

from situ.resources import resource
from ward_records import page
from ward_records.store import LIMITS, Locked, Reading, Store, Unfit, Unknown, WrongPin, number_in

COOKIE = "ward"
LONGEST_BODY = 64 * 1024

Role = Literal["service", "operator", "viewer"]
Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


class Tokens(Struct, frozen=True):
    """The token of each role; long and random, for whoever has one has its rights."""

    service: str
    operator: str
    viewer: str

    def role(self, token: str | None) -> Role | None:
        known: dict[str, Role] = {
            self.service: "service",
            self.operator: "operator",
            self.viewer: "viewer",
        }
        return known.get(token or "")


def application(store: Store, tokens: Tokens) -> web.Application:
    """The whole service, to be run by aiohttp."""
    ward = _Ward(store, tokens)
    made = web.Application(client_max_size=LONGEST_BODY, middlewares=[_careful])
    made.router.add_post("/login", ward.login)
    made.router.add_post("/readings", ward.keep)
    made.router.add_post("/contacts", ward.contacts)
    made.router.add_get("/", ward.page)
    made.router.add_get("/page.css", ward.style)
    made.router.add_static("/fonts", resource("fonts"))
    made.router.add_get("/residents/{id:[0-9]{1,9}}", ward.resident)
    made.router.add_post("/residents/{id:[0-9]{1,9}}", ward.set_limits)
    made.router.add_post("/calls/{id:[0-9]{1,9}}", ward.see)
    return made


@web.middleware
async def _careful(request: web.Request, handler: Handler) -> web.StreamResponse:
    """No answer but a font is kept by a browser, shown in another page, or may run anything."""
    try:
        answer = await handler(request)
    except web.HTTPException as said:
        _guard(said, "no-store")
        raise
    _guard(answer, "max-age=86400" if request.path.startswith("/fonts/") else "no-store")
    return answer


def _guard(answer: web.StreamResponse, kept: str) -> None:
    answer.headers["Cache-Control"] = kept
    answer.headers["Referrer-Policy"] = "no-referrer"
    answer.headers["X-Content-Type-Options"] = "nosniff"
    answer.headers["Content-Security-Policy"] = (
        "default-src 'none'; style-src 'self'; font-src 'self'; img-src data:; "
        "form-action 'self'; frame-ancestors 'none'; base-uri 'none'"
    )


class _Ward:
    def __init__(self, store: Store, tokens: Tokens) -> None:
        self._store = store
        self._tokens = tokens

    # -- what the robot asks -----------------------------------------------------

    async def login(self, request: web.Request) -> web.Response:
        asked = await self._asked(request)
        room, pin = number_in(asked.get("room")), asked.get("pin")
        if room is None or not room.is_integer() or not isinstance(pin, str):
            return _refused(400, "room must be a number and pin a text")
        try:
            found = self._store.login(int(room), pin)
        except WrongPin as wrong:
            return _refused(401, str(wrong))
        except Locked as locked:
            return _refused(429, str(locked))
        user = {"id": found.id, "name": found.name, "room": found.room, "limits": found.limits}
        return web.json_response({"user": user})

    async def keep(self, request: web.Request) -> web.Response:
        asked = await self._asked(request)
        reading = asked.get("reading")
        if not isinstance(reading, dict):
            return _refused(400, "reading must be an object")
        try:
            self._store.keep(reading)
        except Unfit as unfit:
            return _refused(400, str(unfit))
        except Unknown as unknown:
            return _refused(404, str(unknown))
        return web.json_response({"kept": True})

    async def contacts(self, request: web.Request) -> web.Response:
        asked = await self._asked(request)
        who, group = number_in(asked.get("user")), asked.get("group")
        if who is None or not who.is_integer() or not isinstance(group, str):
            return _refused(400, "user must be the id that login gave, and group a text")
        try:
            found = self._store.contacts(int(who), group)
        except Unknown as unknown:
            return _refused(404, str(unknown))
        return web.json_response({"contacts": [to_builtins(one) for one in found]})

    async def _asked(self, request: web.Request) -> dict[str, Any]:
        """The body, of the robot only."""
        given = request.headers.get("Authorization", "")
        if self._tokens.role(given.removeprefix("Bearer ")) != "service":
            raise web.HTTPForbidden(text="the robot's token is needed")
        try:
            body = json.loads(await request.read())
        except (ValueError, RecursionError):
            raise web.HTTPBadRequest(text="the body must be JSON") from None
        if not isinstance(body, dict):
            raise web.HTTPBadRequest(text="the body must be a JSON object")
        return body

    # -- the nurse's page --------------------------------------------------------

    async def page(self, request: web.Request) -> web.Response:
        given = request.query.get("token")
        if given is not None:
            if self._tokens.role(given) is None:
                return _page(page.entrance("There is no such token."), 403)
            # Out of the address: it would stand in the history of the browser.
            answer = web.Response(status=303, headers={"Location": "/"})
            answer.set_cookie(COOKIE, given, httponly=True, samesite="Strict", max_age=12 * 3600)
            return answer
        role = self._role(request)
        if role is None:
            return _page(page.entrance(), 403)
        residents = self._store.residents()
        latest = {one.id: self._measured(one.id) for one in residents}
        return _page(page.ward(residents, latest, self._store.calls(), role == "operator"))

    def _measured(self, number: int) -> list[Reading]:
        """The last reading of the body: a game does not hide it."""
        return [one for one in self._store.readings(number) if one.kind != "game"][:1]

    async def resident(self, request: web.Request) -> web.Response:
        role = self._role(request)
        if role is None:
            return _page(page.entrance(), 403)
        return self._resident(int(request.match_info["id"]), role == "operator")

    async def set_limits(self, request: web.Request) -> web.Response:
        self._must_be_operator(request)
        number, form = int(request.match_info["id"]), await request.post()
        limits = {name: number_in(form.get(name)) for name in LIMITS}
        given = {name: value for name, value in limits.items() if value is not None}
        try:
            self._store.set_limits(number, given)
        except Unfit as unfit:
            return self._resident(number, True, str(unfit), 400)
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        raise web.HTTPSeeOther(f"/residents/{number}")

    async def see(self, request: web.Request) -> web.Response:
        self._must_be_operator(request)
        self._store.see(int(request.match_info["id"]))
        raise web.HTTPSeeOther("/")

    async def style(self, _: web.Request) -> web.Response:
        return web.Response(text=page.STYLE, content_type="text/css")

    def _resident(
        self, number: int, open_: bool, wrong: str = "", status: int = 200
    ) -> web.Response:
        try:
            found = self._store.resident(number)
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        return _page(page.resident(found, self._store.readings(number), open_, wrong), status)

    def _role(self, request: web.Request) -> Role | None:
        role = self._tokens.role(request.cookies.get(COOKIE))
        return role if role != "service" else None

    def _must_be_operator(self, request: web.Request) -> None:
        # The cookie is sent from this page only (SameSite=Strict); a strange page has none.
        if self._role(request) != "operator":
            raise web.HTTPForbidden(text="an operator's token is needed: open /?token=TOKEN")


def _refused(status: int, why: str) -> web.Response:
    return web.json_response({"error": why}, status=status)


def _page(text: str, status: int = 200) -> web.Response:
    return web.Response(text=text, status=status, content_type="text/html")
