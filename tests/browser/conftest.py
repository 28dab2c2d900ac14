"""Real Chromium before the robot's real screen; one browser for all, a fresh page for each."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from playwright.async_api import Browser, Page, ViewportSize, async_playwright, expect

from situ.decide.effects import Map
from situ.decide.inputs import AnyInput
from situ.document.project import Project
from situ.engine.perform import Performer
from situ.engine.voices.espeak import EspeakNg

DEADLINE = 20.0
ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-quic",
]
KIOSK = ViewportSize(width=1280, height=800)
PHONE = ViewportSize(width=390, height=844)


class Stage:
    """A robot's screen and a page that shows it; what people do comes out of ``next``."""

    def __init__(self, root: Path, state: Path, options: dict[str, Any]) -> None:
        self.media = root / "media"
        self._project = Project(root=str(root), name="test", media="media")
        self._state = state
        self._options: dict[str, Any] = {"services": ("screen",), "captions": False} | options
        self._inputs: asyncio.Queue[AnyInput] = asyncio.Queue()
        self.performer = self._performer(0)
        self.page: Page

    def _performer(self, port: int) -> Performer:
        return Performer(
            self._project,
            self._inputs.put_nowait,
            screen=("127.0.0.1", port),
            state_dir=self._state,
            sound=False,
            voice=EspeakNg(None),
            **self._options,
        )

    async def start(self) -> None:
        await self.performer.start()

    async def stop(self) -> int:
        """Stops the robot; gives the port for ``restart``."""
        port = self.performer.screen_port
        assert port is not None
        await self.performer.close()
        return port

    async def restart(self, port: int) -> None:
        self.performer = self._performer(port)
        await self.performer.start()

    def show(self, *components: dict[str, Any], **more: Any) -> None:
        """What an application shows; ``actions`` are the ids of its movies."""
        actions = more.pop("actions", ())
        value = {"components": list(components), "background": None} | more
        self.performer.perform(Map("screen", "reception", value, actions))

    def clear(self) -> None:
        self.performer.perform(Map("screen", None, None))

    def component(self, name: str) -> Any:
        return self.page.locator(f'[data-id="{name}"]')

    async def next(self) -> AnyInput:
        """The next input that comes from the screen."""
        async with asyncio.timeout(DEADLINE):
            return await self._inputs.get()

    def nothing_more(self) -> bool:
        return self._inputs.empty()


class Theatre:
    """The browser, and the loop that it and the robot share."""

    def __init__(self, executable: str) -> None:
        self.loop = asyncio.new_event_loop()
        # Files are read in a thread: it is there from the start, so that none is new in a test.
        self.loop.set_default_executor(ThreadPoolExecutor(1))
        self.loop.run_until_complete(self.loop.run_in_executor(None, bool))
        self._playwright = self.loop.run_until_complete(async_playwright().start())
        self._browser: Browser = self.loop.run_until_complete(
            self._playwright.chromium.launch(executable_path=executable, args=ARGUMENTS)
        )

    def close(self) -> None:
        self.loop.run_until_complete(self._browser.close())
        self.loop.run_until_complete(self._playwright.stop())
        self.loop.run_until_complete(self.loop.shutdown_asyncgens())
        self.loop.run_until_complete(self.loop.shutdown_default_executor())
        self.loop.close()

    @contextlib.asynccontextmanager
    async def window(self, address: str, **options: Any) -> AsyncIterator[Page]:
        """A page of its own, before the screen at that address. options: the window's."""
        context = await self._browser.new_context(**{"viewport": KIOSK} | options)
        try:
            context.set_default_timeout(DEADLINE * 1000)
            page = await context.new_page()
            await page.goto(address)
            yield page
        finally:
            await context.close()

    async def play(
        self,
        stage: Stage,
        scenario: Callable[[Stage], Awaitable[None]],
        address: str,
        context_options: dict[str, Any],
    ) -> None:
        complaints: list[str] = []
        await stage.start()
        context = await self._browser.new_context(**context_options)
        try:
            context.set_default_timeout(DEADLINE * 1000)
            stage.page = page = await context.new_page()
            page.on("pageerror", lambda error: complaints.append(str(error)))
            page.on(
                "console",
                lambda line: complaints.append(line.text) if line.type == "error" else None,
            )
            await page.goto(f"{stage.performer.screen_url}{address}")
            await scenario(stage)
        finally:
            await context.close()
            await stage.performer.close()
        # A server that is away, and a file that is missing, are the tests' own doing.
        known = ("ERR_CONNECTION_REFUSED", "WebSocket connection to", "status of 40")
        assert [line for line in complaints if not any(one in line for one in known)] == []


Play = Callable[..., None]


@pytest.fixture(scope="session")
def theatre(chromium: str) -> Iterator[Theatre]:
    expect.set_options(timeout=DEADLINE * 1000)
    made = Theatre(chromium)
    yield made
    made.close()


@pytest.fixture
def play(theatre: Theatre, tmp_path: Path) -> Play:
    """Plays a scenario: ``play(scenario)``; ``address`` is added to the page's,
    ``viewport`` and ``has_touch`` are the window's, all else is the performer's.
    """

    def run(scenario: Callable[[Stage], Awaitable[None]], **options: Any) -> None:
        window = {k: options.pop(k) for k in ("viewport", "has_touch") if k in options}
        address = options.pop("address", "")
        media = tmp_path / "project" / "media"
        with contextlib.suppress(FileExistsError):
            media.mkdir(parents=True)

        async def whole() -> None:
            stage = Stage(media.parent, tmp_path / "state", options)
            await theatre.play(stage, scenario, address, {"viewport": KIOSK} | window)

        theatre.loop.run_until_complete(whole())

    return run


@pytest.fixture
def media(tmp_path: Path) -> Path:
    """The project's media folder."""
    folder = tmp_path / "project" / "media"
    folder.mkdir(parents=True)
    return folder
