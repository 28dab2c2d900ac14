"""docs/adapters.md: the adapter that is shown there works as it stands."""

from __future__ import annotations

import asyncio
import logging
import re
import socket
from collections.abc import Awaitable, Callable
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

from situ.document.project import Project
from situ.engine.robots import Adapter, Surroundings

PAGE = (Path(__file__).resolve().parent.parent / "docs" / "adapters.md").read_text("utf-8")
(CODE,) = re.findall(r"```python\n(.*?)```", PAGE, re.S)
DEADLINE = 20.0

Ended = tuple[str, bool, str | None]


class MotorBoard:
    """Hears lines, and answers what the test makes it answer."""

    def __init__(self) -> None:
        self.heard: asyncio.Queue[str] = asyncio.Queue()
        self._socket = socket.socket(type=socket.SOCK_DGRAM | socket.SOCK_NONBLOCK)
        self._socket.bind(("127.0.0.1", 0))
        self.at = f"127.0.0.1:{self._socket.getsockname()[1]}"
        self._peer: Any = None
        asyncio.get_running_loop().add_reader(self._socket, self._hear)

    def _hear(self) -> None:
        said, self._peer = self._socket.recvfrom(100)
        self.heard.put_nowait(said.decode())

    def answer(self, *lines: str) -> None:
        for line in lines:
            self._socket.sendto(line.encode(), self._peer)

    def close(self) -> None:
        asyncio.get_running_loop().remove_reader(self._socket)
        self._socket.close()


class Torso:
    """The page's adapter with its motor board; ``ended`` gets what it tells."""

    def __init__(self) -> None:
        self.board = MotorBoard()
        self.ended: asyncio.Queue[Ended] = asyncio.Queue()
        names: dict[str, Any] = {}
        exec(compile(CODE, "docs/adapters.md", "exec"), names)
        project = Project(root="", name="test", tags={"torso.board": self.board.at})
        around = Surroundings(
            project,
            asyncio.get_running_loop(),
            lambda *ended: self.ended.put_nowait(ended),
            None,
            logging.getLogger("test"),
        )
        self.adapter: Adapter = names["Torso"](around)

    def lift(self, height: float) -> None:
        self.adapter.apply("torso", {"command": "raise", "params": {"height": height}})


def with_torso(test: Callable[[Torso], Awaitable[None]]) -> None:
    async def within() -> None:
        async with asyncio.timeout(DEADLINE):
            torso = Torso()
            await torso.adapter.start()
            try:
                await test(torso)
            finally:
                await torso.adapter.close()
                torso.board.close()

    asyncio.run(within())


def test_it_is_about_thirty_lines() -> None:
    assert len([line for line in CODE.splitlines() if line.strip()]) <= 35


def test_it_rises_and_tells_when_it_is_there() -> None:
    async def test(torso: Torso) -> None:
        torso.lift(40)
        assert await torso.board.heard.get() == "to 40 #1"
        torso.board.answer("there #1")
        assert await torso.ended.get() == ("torso", True, None)
        torso.lift(999)
        assert await torso.board.heard.get() == "to 60 #2"
        torso.board.answer("jammed #2")
        assert await torso.ended.get() == ("torso", False, "it is jammed")

    with_torso(test)


def test_null_stops_it_and_an_answer_that_comes_too_late_ends_nothing() -> None:
    async def test(torso: Torso) -> None:
        torso.lift(40)
        torso.adapter.apply("torso", None)
        torso.lift(20)
        assert [await torso.board.heard.get() for _ in range(3)] == ["to 40 #1", "stop", "to 20 #3"]
        torso.board.answer("there #1", "jammed #3")
        assert await torso.ended.get() == ("torso", False, "it is jammed")

    with_torso(test)


def test_what_it_does_not_know_stops_it_and_fails_in_plain_words() -> None:
    async def test(torso: Torso) -> None:
        for value, words in (
            ({"command": "dance"}, "the torso can not dance; it knows raise"),
            ("up", "the torso takes an object, not 'up'"),
            ({"command": "raise"}, "height has to be a number, not None"),
        ):
            torso.adapter.apply("torso", value)
            assert await torso.board.heard.get() == "stop"
            assert await torso.ended.get() == ("torso", False, words)

    with_torso(test)


def test_the_page_names_every_adapter_that_is_there() -> None:
    named = set(re.findall(r"`([a-z0-9-]+)`", "".join(re.findall(r"^\| (`.*?) \|", PAGE, re.M))))
    assert {entry.name for entry in entry_points(group="situ.robots")} <= named
