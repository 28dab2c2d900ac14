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

from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.calls import Person
from situ.blackboard.client import connect_async
from situ.blackboard.identity import KeyRole
from situ.blackboard.keys import KnownKey, RobotKeys, add_known, door_to, new_robot, token_keys
from situ.blackboard.link import Link
from situ.decide.effects import Map
from situ.decide.inputs import AnyInput
from situ.document.project import Project
from situ.document.ready import load_ready
from situ.engine.deciding import Setup
from situ.engine.live import Live
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


Scene = Callable[[Page, AsyncBoard], Awaitable[None]]


@contextlib.asynccontextmanager
async def robot(folder: Path, keys: RobotKeys | None) -> AsyncIterator[tuple[str, AsyncBoard]]:
    """A robot that runs the project there; its screen's address, and Bob at its blackboard."""
    project = load_ready(folder)
    live = Live(
        project,
        Setup(keys=keys),
        lambda submit, tag: Performer(project, submit, tag=tag, services=("screen",)),
    )
    addresses = await live.start()
    assert addresses.http is not None
    try:
        if keys is None:
            board = connect_async(addresses.requests, "bob")
        else:
            bob = Person(role="operator", user="bob")
            own = door_to(keys.public)("bob's token")
            board = AsyncBoard(Link(addresses.requests, bob, keys=own))
        async with board:
            yield addresses.http, board
    finally:
        await live.stop()


@pytest.fixture
def before(theatre: Theatre, tmp_path: Path) -> Callable[..., None]:
    """Somebody before a page beside the screen: ``before(path, files, scene)``. files: of the
    project; ``token``: as in the address, the screen's unless given; ``keys``: the robot's; all
    else is the window's.
    """

    def run(
        path: str,
        files: dict[str, str],
        scene: Scene,
        token: str | None = None,
        keys: RobotKeys | None = None,
        **window: Any,
    ) -> None:
        for name, text in files.items():
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_text(text)

        async def whole() -> None:
            complaints: list[str] = []
            async with (
                asyncio.timeout(3 * DEADLINE),
                robot(tmp_path, keys) as (screen, board),
                theatre.window("about:blank", **window) as page,
            ):
                page.on("pageerror", lambda error: complaints.append(str(error)))
                root, _, own = screen.partition("?token=")
                shown = own if token is None else token
                await page.goto(f"{root}{path}?token={shown}" if shown else f"{root}{path}")
                await scene(page, board)
            assert complaints == []

        theatre.loop.run_until_complete(whole())

    return run


@pytest.fixture
def keys(tmp_path: Path) -> RobotKeys:
    """A robot's, who knows two operators and a viewer by their tokens."""
    folder = tmp_path / "state" / "keys"
    folder.mkdir(parents=True)
    new_robot(folder)
    people: dict[str, KeyRole] = {"ann": "operator", "bob": "operator", "tablet": "viewer"}
    for name, role in people.items():
        public = token_keys(f"{name}'s token")[0].decode()
        add_known(folder, name, KnownKey(public, role, (), door=True))
    return RobotKeys(folder)
