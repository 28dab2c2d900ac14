"""Who moves out, by the nurse.

======================================  =====================================================
``GET /residents/ID/remove``            asks once more, and what becomes of the readings
``POST /residents/ID/remove``           {readings}: ``keep`` or ``erase``, from that page
``GET /moved-out``                      of whom readings were kept; ``/moved-out/ID`` asks
                                        whether to take them away
``POST /moved-out/ID``                  takes them away
======================================  =====================================================

All of it for operators only.
"""

from __future__ import annotations

from collections.abc import Callable

from aiohttp import web

from ward_records import moving_out_page
from ward_records.answers import shown
from ward_records.errors import Unknown
from ward_records.forms import texts
from ward_records.moving_out import MovingOut
from ward_records.store import Store


class MovingOutWeb:
    """must: raises where a request may not."""

    def __init__(
        self, store: Store, must: Callable[[web.Request], None], moving_out: MovingOut
    ) -> None:
        self._store = store
        self._must = must
        self._moving_out = moving_out

    def add_to(self, router: web.UrlDispatcher) -> None:
        router.add_get("/residents/{id:[0-9]{1,9}}/remove", self._ask)
        router.add_post("/residents/{id:[0-9]{1,9}}/remove", self._remove)
        router.add_get("/moved-out", self._former)
        router.add_get("/moved-out/{id:[0-9]{1,9}}", self._ask_to_erase)
        router.add_post("/moved-out/{id:[0-9]{1,9}}", self._erase)

    async def _ask(self, request: web.Request) -> web.Response:
        number = self._number(request)
        try:
            one = self._store.resident(number)
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        return shown(moving_out_page.confirm(one, len(self._store.readings(number))))

    async def _remove(self, request: web.Request) -> web.Response:
        number, chosen = self._number(request), (await texts(request)).get("readings")
        if chosen not in ("keep", "erase"):
            # What nobody has chosen is never taken away.
            raise web.HTTPSeeOther(f"/residents/{number}/remove")
        try:
            self._moving_out.remove(number, readings=chosen == "keep")
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        raise web.HTTPSeeOther("/")

    async def _former(self, request: web.Request) -> web.Response:
        self._must(request)
        return shown(moving_out_page.former(self._moving_out.all()))

    async def _ask_to_erase(self, request: web.Request) -> web.Response:
        try:
            one = self._moving_out.former(self._number(request))
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        return shown(moving_out_page.confirm_erasing(one))

    async def _erase(self, request: web.Request) -> web.Response:
        try:
            self._moving_out.take_away(self._number(request))
        except Unknown as unknown:
            raise web.HTTPNotFound(text=str(unknown)) from None
        raise web.HTTPSeeOther("/moved-out")

    def _number(self, request: web.Request) -> int:
        self._must(request)
        return int(request.match_info["id"])
