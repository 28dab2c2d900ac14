"""Who may do what, by the token that a request carries.

Roles are those of docs/security.md: the robot has the token of a service and may log people in
and write; an operator's token opens the page; with a viewer's, what is private is •••, and
nothing can be changed. The page takes its token once, by ``/?token=TOKEN``, and keeps it in a
cookie of this browser.
"""

from __future__ import annotations

from typing import Any, Literal

import msgspec
from aiohttp import web
from msgspec import Struct

COOKIE = "ward"

Role = Literal["service", "operator", "viewer"]


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
        # An empty one in tokens.json is nobody's, not everybody's.
        return known.get(token) if token else None

    def nurse(self, request: web.Request) -> Role | None:
        """operator or viewer, as the browser's cookie says; None: neither."""
        role = self.role(request.cookies.get(COOKIE))
        return role if role != "service" else None

    def must_be_operator(self, request: web.Request) -> None:
        """Raises HTTPForbidden."""
        # The cookie is sent from this page only (SameSite=Strict); a strange page has none.
        if self.nurse(request) != "operator":
            raise web.HTTPForbidden(text="an operator's token is needed: open /?token=TOKEN")

    def must_be_robot(self, request: web.Request) -> None:
        """Raises HTTPForbidden."""
        given = request.headers.get("Authorization", "")
        if self.role(given.removeprefix("Bearer ")) != "service":
            raise web.HTTPForbidden(text="the robot's token is needed")

    async def asked(self, request: web.Request) -> dict[str, Any]:
        """The body, of the robot only. Raises HTTPForbidden, and HTTPBadRequest where it is no
        JSON object."""
        self.must_be_robot(request)
        try:
            # Not json: that takes half a character, which no file can hold.
            body = msgspec.json.decode(await request.read())
        except (msgspec.DecodeError, RecursionError):
            raise web.HTTPBadRequest(text="the body must be JSON") from None
        if not isinstance(body, dict):
            raise web.HTTPBadRequest(text="the body must be a JSON object")
        return body
