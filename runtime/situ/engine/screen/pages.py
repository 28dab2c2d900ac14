"""The pages beside the robot's screen: ``/settings`` and ``/operate``.

A page itself is for everybody, for nothing stands in it: what it shows comes from the
blackboard's WebSocket door, with the rights of whoever has opened it.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import msgspec
from aiohttp import web

from situ.engine.screen.forms import Forms


class Pages:
    """The pages of one robot.

    forms: of the project that runs. admit: whether a request shows a token that
    opens the door. keyed: whether everybody has a token of his own. headers: a page's.
    """

    def __init__(
        self,
        folder: Path,
        forms: Forms,
        admit: Callable[[web.Request], bool],
        keyed: Callable[[], bool],
        headers: dict[str, str],
    ) -> None:
        self._folder = folder
        self.forms = forms
        self._admit = admit
        self._keyed = keyed
        self._headers = headers

    def route(self, router: web.UrlDispatcher) -> None:
        router.add_get("/{page:settings|operate}", self._on_page)
        router.add_get("/settings.json", self._on_settings)

    async def _on_page(self, request: web.Request) -> web.StreamResponse:
        headers = {"Content-Type": "text/html; charset=utf-8", **self._headers}
        return web.FileResponse(
            self._folder / f"{request.match_info['page']}.html", headers=headers
        )

    async def _on_settings(self, request: web.Request) -> web.StreamResponse:
        """``Forms``, and ``keyed``."""
        if not self._admit(request):
            return web.Response(status=403, text=_REFUSED)
        told = {**msgspec.structs.asdict(self.forms), "keyed": self._keyed()}
        return web.Response(body=msgspec.json.encode(told), content_type="application/json")


_REFUSED = "This needs a token: the one that the robot printed, or with keys one of your own.\n"
