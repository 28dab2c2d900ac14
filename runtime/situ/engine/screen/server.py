"""The screen's web server: the page, the project's media, and the WebSocket between.

Who opens the page needs the token in its address (``ScreenServer.url``); the page
then carries it in a cookie that no script can read. The WebSocket is refused to
pages of other origins. docs/architecture.md, *The robot's screen*, has the messages. Beside the
screen stands the blackboard's WebSocket door, for whoever knows the same token.
"""

from __future__ import annotations

import asyncio
import filecmp
import hmac
import logging
import secrets
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import msgspec
from aiohttp import WSCloseCode, WSMsgType, web
from msgspec import UNSET, Struct, UnsetType

from situ.decide.inputs import AnyInput, Set, Touch, Use
from situ.document.phrases import parts
from situ.document.project import Project
from situ.engine.media import MediaFolder
from situ.engine.screen.content import Content, Shown, content
from situ.engine.screen.door import Door
from situ.engine.screen.forms import Forms
from situ.engine.screen.pages import Pages
from situ.errors import UsageError
from situ.resources import resource

LARGEST_MESSAGE = 64 * 1024
BEAT = 2.0
"""Seconds between two signs of life; a page that misses three of them reconnects."""
MOST_PAGES = 32

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; "
    "img-src 'self' http: https:; media-src 'self' http: https:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-cache",
}
_MEDIA_TYPES = {
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".jpeg": "image/jpeg",
    ".gif": "image/gif",
    ".webp": "image/webp",
    ".avif": "image/avif",
    ".svg": "image/svg+xml",
    ".webm": "video/webm",
    ".mp4": "video/mp4",
    ".ogv": "video/ogg",
    ".ogg": "audio/ogg",
    ".oga": "audio/ogg",
    ".wav": "audio/wav",
    ".mp3": "audio/mpeg",
    ".m4a": "audio/mp4",
}
_PAGE_TYPES = {
    ".css": "text/css",
    ".js": "text/javascript",
    ".otf": "font/otf",
    ".svg": "image/svg+xml",
}
_REFUSED = (
    "This address needs the key that the robot printed when it started: "
    "open the whole address, with token=… at its end.\n"
)


class Used(Struct, forbid_unknown_fields=True):
    """A component used: what was typed, or the number of the list's item."""

    component: str
    value: str | float | UnsetType = UNSET
    item: int | UnsetType = UNSET


class Ended(Struct, forbid_unknown_fields=True):
    """A movie ended, or could not be played."""

    action: int
    error: str | None = None


class FromPage(Struct, forbid_unknown_fields=True):
    """One message from the page. revision: of the content that the person saw.

    Exactly one of: use; write (typed and left without Enter); touch; ended.
    """

    revision: int
    use: Used | None = None
    write: Used | None = None
    touch: bool = False
    ended: Ended | None = None


class ScreenServer:
    """Serves one screen to any number of pages; all show the same.

    use: gets what people do. ended(action, error): a movie's end. token: 32 random
    characters unless given. door: leads to the blackboard once it is opened. forms: what the
    pages ``/settings`` and ``/operate`` show.
    """

    def __init__(
        self,
        media: MediaFolder,
        use: Callable[[AnyInput], None],
        ended: Callable[[int, str | None], None],
        log: logging.Logger,
        *,
        token: str | None = None,
        forms: Forms | None = None,
    ) -> None:
        self._media = media
        self._use = use
        self._ended = ended
        self._log = log
        self.door = Door()
        self._token = token or secrets.token_urlsafe(24)
        self._folder = resource("screen")
        self._fonts = resource("fonts")
        self._beside = Pages(
            self._folder,
            forms or Forms(),
            self._admits,
            lambda: self.door.keyed,
            {"Content-Security-Policy": POLICY},
        )
        self._content = Content()
        self._caption: dict[str, Any] | None = None
        self._captions = False
        # How often a file that was shown became another one, by its address.
        self._editions: dict[str | None, int] = {}
        self._lang = "en"
        self._pages: dict[web.WebSocketResponse, asyncio.Event] = {}
        self._runner: web.AppRunner | None = None
        self._address = ("", 0)
        self._decoder = msgspec.json.Decoder(FromPage)

    @property
    def port(self) -> int:
        return self._address[1]

    @property
    def url(self) -> str:
        """The address to open, its token included."""
        host, port = self._address
        host = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(host, host)
        host = f"[{host}]" if ":" in host and not host.startswith("[") else host
        return f"http://{host}:{port}/?token={self._token}"

    @property
    def pages(self) -> int:
        """How many pages show the screen now."""
        return len(self._pages)

    async def start(self, host: str, port: int) -> None:
        """Listens; port 0 picks a free one. Raises UsageError where the port is taken."""
        app = web.Application(client_max_size=LARGEST_MESSAGE, middlewares=[_with_headers])
        app.router.add_get("/", self._on_page)
        app.router.add_get("/page/{name}", self._on_file)
        app.router.add_get("/media/{path:.+}", self._on_media)
        app.router.add_get("/ws", self._on_socket)
        app.router.add_get("/board", self._on_board)
        self._beside.route(app.router)
        runner = web.AppRunner(app, access_log=None, handle_signals=False, shutdown_timeout=0.5)
        await runner.setup()
        try:
            await web.TCPSite(runner, host, port).start()
        except OSError as error:
            await runner.cleanup()
            raise UsageError(
                f"the screen can not be served at {host}:{port} ({error.strerror}); "
                "choose another port, or 0 for a free one"
            ) from error
        self._runner = runner
        self._address = (host, runner.addresses[0][1])

    async def close(self) -> None:
        """Tells the pages to wait for the next start, and stops listening."""
        for page in list(self._pages):
            await page.close(code=WSCloseCode.GOING_AWAY, message=b"the robot stops")
        await self.door.close()
        if self._runner is not None:
            await self._runner.cleanup()
            self._runner = None

    def turn_to(self, project: Project, forms: Forms) -> None:
        """From here on the media of this project, and these forms. What is shown stays; a picture
        of which there is another one under its name is loaded anew, and no other."""
        shown = [one.page.get("src") for one in self._content.components or ()]
        addresses = {str(src) for src in (*shown, self._content.background) if src}
        before = {address: self._file_of(address) for address in addresses}
        self._media.turn_to(project)
        for address, file in before.items():
            if not _same(file, self._file_of(address)):
                self._editions[address] = self._editions.get(address, 0) + 1
        self._beside.forms = forms
        self._tell()

    def _file_of(self, address: str) -> Path | None:
        return self._media.find(unquote(address).removeprefix("/media/"))

    # -- what is shown -----------------------------------------------------------

    def show(self, value: Any, actions: Sequence[int] = (), lang: str = "en") -> None:
        """Shows a value of ``robot/screen``; None shows the idle face."""
        self._content = content(value, actions, self._content, self._log)
        self._lang = lang
        self._tell()

    def caption(self, text: str | None, lang: str = "en") -> None:
        """What is being said, as text; None: nothing."""
        self._caption = {"parts": parts(text), "lang": lang} if text else None
        self._tell()

    @property
    def captions(self) -> bool:
        """Whether the page keeps a line for what is being said."""
        return self._captions

    @captions.setter
    def captions(self, on: bool) -> None:
        self._captions = on
        self._tell()

    def _tell(self) -> None:
        for changed in self._pages.values():
            changed.set()

    def _message(self) -> bytes:
        state = {
            "revision": self._content.revision,
            "since": self._content.since,
            "screen": self._page(),
            "captions": self._captions,
            "caption": self._caption,
            "lang": self._lang,
        }
        return msgspec.json.encode({"show": state})

    def _page(self) -> dict[str, Any] | None:
        """The content, with addresses under which a page does not have another file already."""
        page = self._content.page()
        if page is None or not self._editions:
            return page
        components = [
            {**one, "src": self._edition(one["src"])} if "src" in one else one
            for one in page["components"]
        ]
        return {"background": self._edition(page["background"]), "components": components}

    def _edition(self, address: str | None) -> str | None:
        if address not in self._editions:
            return address
        return f"{address}?edition={self._editions[address]}"

    # -- requests ----------------------------------------------------------------

    async def _on_page(self, request: web.Request) -> web.StreamResponse:
        given = request.query.get("token")
        if given is None and not self._known(request):
            return web.Response(status=403, text=_REFUSED)
        if given is not None and not self._right(given):
            return web.Response(status=403, text=_REFUSED)
        response = web.FileResponse(self._folder / "index.html")
        response.content_type = "text/html"
        response.charset = "utf-8"
        response.headers["Content-Security-Policy"] = POLICY
        response.set_cookie(self._cookie, self._token, httponly=True, samesite="Strict", path="/")
        return response

    async def _on_file(self, request: web.Request) -> web.StreamResponse:
        name = request.match_info["name"]
        folder = self._fonts if name.endswith(".otf") else self._folder
        kind = _PAGE_TYPES.get(Path(name).suffix)
        file = folder / name
        if kind is None or Path(name).name != name or not file.is_file():
            raise web.HTTPNotFound
        return web.FileResponse(file, headers={"Content-Type": kind})

    async def _on_media(self, request: web.Request) -> web.StreamResponse:
        if not self._known(request):
            return web.Response(status=403, text=_REFUSED)
        path = request.match_info["path"]
        kind = _MEDIA_TYPES.get(Path(path).suffix.lower())
        file = self._media.find(path) if kind is not None else None
        if file is None or kind is None:
            raise web.HTTPNotFound
        # A picture opened by itself may not run anything either.
        policy = "default-src 'none'; style-src 'unsafe-inline'; sandbox"
        return web.FileResponse(
            file, headers={"Content-Type": kind, "Content-Security-Policy": policy}
        )

    async def _on_socket(self, request: web.Request) -> web.StreamResponse:
        origin = request.headers.get("Origin")
        if origin != _own(request):
            self._log.warning("refused the screen to a page of %s", origin)
            return web.Response(status=403, text="The screen is not for other pages.\n")
        if not self._known(request):
            self._log.warning("refused the screen to a page without the right token")
            return web.Response(status=403, text=_REFUSED)
        if len(self._pages) >= MOST_PAGES:
            return web.Response(status=503, text="Too many pages show this screen.\n")
        page = web.WebSocketResponse(max_msg_size=LARGEST_MESSAGE)
        await page.prepare(request)
        changed = self._pages[page] = asyncio.Event()
        changed.set()
        teller = asyncio.create_task(self._keep_told(page, changed))
        try:
            async for message in page:
                if message.type is not WSMsgType.TEXT or not self._hear(message.data):
                    await page.close(code=WSCloseCode.POLICY_VIOLATION)
                    break
        finally:
            del self._pages[page]
            teller.cancel()
        return page

    async def _on_board(self, request: web.Request) -> web.StreamResponse:
        # A browser always tells the origin; a program of its own has none.
        origin = request.headers.get("Origin")
        if origin not in (None, _own(request)):
            self._log.warning("refused the blackboard to a page of %s", origin)
            return web.Response(status=403, text="The blackboard is not for other pages.\n")
        # The door itself knows everybody's own tokens, and writes down whom it refuses.
        if not self.door.keyed and not self._admits(request):
            self._log.warning("refused the blackboard to %s without the token", request.remote)
            return web.Response(status=403, text=_REFUSED)
        return await self.door.visit(request, _token(request))

    def _admits(self, request: web.Request) -> bool:
        """Whether who asks may come in by the door."""
        token = _token(request)
        # Where everybody has a token of his own, the screen's opens nothing here.
        if self.door.keyed:
            return self.door.knows(token)
        return self._right(token) or self._known(request)

    async def _keep_told(self, page: web.WebSocketResponse, changed: asyncio.Event) -> None:
        """Sends the latest state whenever it changed: a slow page skips, and piles up nothing."""
        try:
            while True:
                try:
                    async with asyncio.timeout(BEAT):
                        await changed.wait()
                except TimeoutError:
                    await page.send_str('{"beat":true}')
                    continue
                changed.clear()
                await page.send_bytes(self._message())
        except (ConnectionError, RuntimeError):
            return

    @property
    def _cookie(self) -> str:
        # Cookies know no ports: several robots may run on one machine.
        return f"situ-screen-{self.port}"

    def _known(self, request: web.Request) -> bool:
        return self._right(request.cookies.get(self._cookie, ""))

    def _right(self, token: str) -> bool:
        return hmac.compare_digest(token.encode("utf-8", "replace"), self._token.encode())

    # -- what people do ------------------------------------------------------------

    def _hear(self, data: str) -> bool:
        """Takes one message of a page; False where it is none."""
        try:
            said = self._decoder.decode(data)
        except (msgspec.DecodeError, UnicodeEncodeError) as error:
            self._log.warning("a page sent something that is no message: %s", error)
            return False
        if said.touch:
            if said.revision >= self._content.since:
                self._use(Touch())
        elif said.ended is not None:
            self._ended(said.ended.action, said.ended.error)
        elif said.use is not None:
            self._hear_use(said.revision, said.use)
        elif said.write is not None:
            shown = self._meant(said.revision, said.write)
            if shown is not None and shown.type == "input" and shown.tag is not None:
                value = None if said.write.value is UNSET else said.write.value
                self._use(Set({shown.tag: value}, "screen"))
        return True

    def _hear_use(self, revision: int, used: Used) -> None:
        shown = self._meant(revision, used)
        if shown is None:
            return
        if shown.type == "button":
            self._use(Use(shown.id))
        elif shown.type == "input" and used.value is not UNSET:
            self._use(Use(shown.id, used.value))
        elif (
            shown.type == "list" and used.item is not UNSET and used.item in range(len(shown.items))
        ):
            # The page says which item it was, so that its value is ours, to the last digit.
            self._use(Use(shown.id, shown.items[used.item]))

    def _meant(self, revision: int, used: Used) -> Shown | None:
        """The component that the person meant; None where another stands there by now."""
        shown = self._content.component(used.component)
        if shown is None or revision < shown.since:
            self._log.info("%s was used when it was gone already", used.component)
            return None
        return shown


def _same(one: Path | None, other: Path | None) -> bool:
    """Whether two files have the same content; a missing one is like a missing one only."""
    if one is None or other is None:
        return one is other
    try:
        return one.samefile(other) or filecmp.cmp(one, other, shallow=False)
    except OSError:
        return False


def _token(request: web.Request) -> str:
    """What the request shows at the door; empty where it shows nothing."""
    scheme, _, given = request.headers.get("Authorization", "").partition(" ")
    return given.strip() if scheme.lower() == "bearer" else request.query.get("token", "")


def _own(request: web.Request) -> str:
    return f"{request.scheme}://{request.host}"


@web.middleware
async def _with_headers(
    request: web.Request, handler: Callable[[web.Request], Awaitable[web.StreamResponse]]
) -> web.StreamResponse:
    try:
        response = await handler(request)
    except web.HTTPException as refusal:
        refusal.headers.update(_HEADERS)
        raise
    if not response.prepared:
        response.headers.update(_HEADERS)
    return response
