"""The blackboard from a page: its own pages come in by the cookie, all others are refused."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from situ.blackboard.client import AsyncBoard, connect_async
from situ.document.ready import load_ready
from situ.engine.deciding import Setup
from situ.engine.live import Live

pytestmark = pytest.mark.chromium

LAB = Path(__file__).parent.parent / "blackboard" / "lab"

CLIENT = """
address => new Promise((resolve, reject) => {
  const socket = new WebSocket(address);
  const heard = [];
  const waiting = [];
  let ids = 0;
  window.ask = fields => new Promise(answered => {
    waiting.push(answered);
    socket.send(JSON.stringify({...fields, id: ++ids}));
  });
  window.subscribe = topic => socket.send("+" + topic);
  window.next = async () => {
    while (!heard.length) await new Promise(come => { window.come = come; });
    return heard.shift();
  };
  socket.onmessage = ({data}) => {
    if (data.startsWith("{")) return waiting.shift()(JSON.parse(data));
    const at = data.indexOf("\\n");
    heard.push([data.slice(0, at), JSON.parse(data.slice(at + 1))]);
    window.come && window.come();
  };
  socket.onopen = () => resolve("open");
  socket.onclose = () => resolve("closed");
})
"""


@asynccontextmanager
async def core(stage: Any) -> AsyncIterator[AsyncBoard]:
    """A core behind the stage's door; gives somebody else at its blackboard."""
    live = Live(load_ready(LAB), Setup())
    addresses = await live.start()
    try:
        stage.performer.open_door(addresses)
        async with connect_async(addresses.requests) as board:
            yield board
    finally:
        await live.stop()


def test_a_page_of_the_screen_reads_and_writes_the_blackboard(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        page = stage.page
        async with core(stage) as board:
            address = f"ws://127.0.0.1:{stage.performer.screen_port}/board"
            assert await page.evaluate(CLIENT, address) == "open"
            hello = "ask({do: 'hello', version: 1, role: 'operator', user: 'ann'})"
            assert (await page.evaluate(hello))["re"] == "welcome"
            await page.evaluate("ask({do: 'set', tags: {'speech.text': 'hello'}})")
            assert await board.get("speech.text") == "hello"
            # The first echo says that the connection stands, the second that all is heard.
            for topic in ("t:face.", "echo:1\n", "echo:2\n"):
                await page.evaluate("topic => subscribe(topic)", topic)
                if topic.startswith("echo"):
                    assert (await page.evaluate("next()"))[0] + "\n" == topic
            watched = await page.evaluate("ask({do: 'watch', patterns: ['face.*']})")
            assert watched["re"] == "snapshot"
            await board.set("face.visible", True)
            topic, change = await page.evaluate("next()")
            assert (topic, change["value"]) == ("t:face.visible", True)

    play(scenario)


def test_a_page_of_another_origin_is_refused(play: Any) -> None:
    async def scenario(stage: Any) -> None:
        page = stage.page
        async with core(stage):
            address = f"ws://127.0.0.1:{stage.performer.screen_port}/board"
            token = str(stage.performer.screen_url).partition("token=")[2]
            await page.goto("data:text/html,elsewhere")
            assert await page.evaluate(CLIENT, f"{address}?token={token}") == "closed"

    play(scenario)
