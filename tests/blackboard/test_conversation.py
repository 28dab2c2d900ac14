"""The conversation of tests/vectors (docs/protocol.md, *Test vectors*), held against the core by
hand, against a real one by both doors, and against this client's watches."""

from __future__ import annotations

import asyncio
import json
import threading
from collections.abc import Callable, Coroutine, Iterator
from pathlib import Path
from typing import Any, Protocol, get_args

import aiohttp
import msgspec
import pytest
import zmq
from tests.unhurried import Unhurried

from situ.blackboard import protocol, replies
from situ.blackboard.feeds import Watch
from situ.blackboard.notices import Change
from situ.blackboard.replies import Addresses
from situ.document.project import Project
from situ.engine.deciding import Setup
from situ.engine.live import Live
from situ.engine.perform import Performer
from situ.rehearse.expect import fits

DEADLINE = 20.0
VECTORS = Path(__file__).parent.parent / "vectors" / "conversation.json"
STEPS: list[dict[str, Any]] = json.loads(VECTORS.read_text("utf-8"))


def notices(step: dict[str, Any]) -> list[dict[str, Any]]:
    """What everybody who subscribed to it hears of this step."""
    found = step.get("notices", [])
    return [{key: value for key, value in one.items() if key != "lost"} for one in found]


def heard(frame: bytes) -> dict[str, Any]:
    """A notice as the vectors tell it: time and seq differ from run to run."""
    topic, _, text = frame.partition(b"\n")
    body = json.loads(text)
    kept = {key: value for key, value in body.items() if key not in ("time", "seq")}
    return {"topic": topic.decode(), "body": kept}


def timeless(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: timeless(one) for key, one in value.items() if key != "time"}
    return value


def test_the_core_answers_and_notices_as_the_vectors_say(hand: Any) -> None:
    for step in STEPS:
        hand.at(step["at"])
        hand.notices.clear()
        reply = json.loads(hand.raw(step["peer"], json.dumps(step["send"]).encode()))
        assert fits(step["reply"], reply), f"{step['send']} was answered {reply}"
        assert [heard(frame) for frame in hand.notices] == notices(step), step["send"]


def test_a_watch_tells_its_user_of_gaps_as_the_vectors_say() -> None:
    """What ``other`` watches, with the notices that get lost on the way to it."""
    watches: list[Watch] = []
    must_ask = False
    for step in STEPS:
        mine, do = step["peer"] == "other", step["send"]["do"]
        if mine and step["reply"]["re"] == "snapshot":
            reply = msgspec.convert(step["reply"], replies.Snapshot)
            watches = watches or [Watch(pattern) for pattern in step["send"]["patterns"]]
            for watch in watches:
                watch.snapshot(reply)
            must_ask = False
        assert not (mine and must_ask), f"before {step['send']} it must watch anew"
        if mine and do == "heartbeat":
            changes = step["reply"]["changes"]
            behind = [watch for watch in watches if watch.behind(changes[watch.pattern])]
            must_ask = bool(behind)
        for one in step.get("notices", []):
            if one["body"]["on"] != "change" or one.get("lost"):
                continue
            notice = msgspec.convert({"time": 0, **one["body"]}, Change)
            for watch in watches:
                if watch.fits(notice.tag) and not watch.change(notice):
                    watch.asking = must_ask = True
        told = [
            {"tag": one.tag, "value": one.value, "version": one.version, "missed": one.missed}
            for watch in watches
            for one in iter(watch.take, None)
        ]
        assert told == step.get("tells", []), step["send"]


def test_every_kind_of_request_and_every_code_is_in_the_conversation() -> None:
    asked = {step["send"]["do"] for step in STEPS}
    # What is said and answered in the robot's service is told by requests.json alone.
    services = {"attend", "perform", "serve", "answer", "bundle", "fetch"}
    # So is what has become of a version, which takes a state folder.
    services |= {"progress", "history"}
    kinds = {str(kind.__struct_config__.tag) for kind in protocol.Request.__subclasses__()}
    assert asked >= kinds - services
    # These two are for strangers and for crowds.
    codes = {*get_args(replies.Code)} - {"denied", "limit"}
    assert {step["reply"].get("code") for step in STEPS} >= codes


class Door(Protocol):
    """A way into a core that runs."""

    async def ask(self, peer: str, request: dict[str, Any]) -> dict[str, Any]: ...

    async def follow(self) -> None:
        """From here on every notice is heard."""

    async def since(self) -> list[bytes]:
        """The notices since the last call, all of those that were caused so far."""

    async def close(self) -> None: ...


class ByZeroMQ:
    def __init__(self, addresses: Addresses) -> None:
        self._addresses = addresses
        self._context: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
        self._peers: dict[str, zmq.Socket[bytes]] = {}
        self._listener = self._socket(zmq.SUB, addresses.notifications)
        self._echoes = 0

    def _socket(self, sort: int, address: str) -> zmq.Socket[bytes]:
        socket = self._context.socket(sort)
        socket.setsockopt(zmq.RCVTIMEO, int(DEADLINE * 1000))
        socket.connect(address)
        return socket

    async def ask(self, peer: str, request: dict[str, Any]) -> dict[str, Any]:
        if peer not in self._peers:
            self._peers[peer] = self._socket(zmq.DEALER, self._addresses.requests)
        self._peers[peer].send(json.dumps(request).encode())
        reply: dict[str, Any] = json.loads(self._peers[peer].recv())
        return reply

    async def follow(self) -> None:
        self._listener.setsockopt(zmq.SUBSCRIBE, b"")
        # The first echo says that the connection stands, the second that all is heard.
        await self.since()
        await self.since()

    async def since(self) -> list[bytes]:
        self._echoes += 1
        echo = b"echo:%d\n" % self._echoes
        self._listener.setsockopt(zmq.SUBSCRIBE, echo)
        return list(iter(lambda: self._next(echo), b""))

    def _next(self, echo: bytes) -> bytes:
        frame = self._listener.recv()
        return b"" if frame.startswith(echo) else frame

    async def close(self) -> None:
        self._context.destroy(linger=0)


class ByWebSocket:
    def __init__(self, addresses: Addresses) -> None:
        assert addresses.http is not None
        self._root, _, self._token = addresses.http.partition("/?token=")
        self._client = aiohttp.ClientSession()
        self._peers: dict[str, aiohttp.ClientWebSocketResponse] = {}
        self._echoes = 0

    async def _peer(self, name: str) -> aiohttp.ClientWebSocketResponse:
        if name not in self._peers:
            headers = {"Authorization": f"Bearer {self._token}"}
            self._peers[name] = await self._client.ws_connect(
                self._root + "/board", headers=headers
            )
        return self._peers[name]

    async def ask(self, peer: str, request: dict[str, Any]) -> dict[str, Any]:
        socket = await self._peer(peer)
        await socket.send_str(json.dumps(request))
        reply: dict[str, Any] = json.loads(await socket.receive_str())
        return reply

    async def follow(self) -> None:
        await (await self._peer("listener")).send_str("+")
        await self.since()
        await self.since()

    async def since(self) -> list[bytes]:
        self._echoes += 1
        echo = f"echo:{self._echoes}\n"
        listener = await self._peer("listener")
        await listener.send_str("+" + echo)
        frames: list[bytes] = []
        while not (frame := await listener.receive_str()).startswith(echo):
            frames.append(frame.encode())
        return frames

    async def close(self) -> None:
        await self._client.close()


@pytest.fixture
def addresses(lab: Project) -> Iterator[Addresses]:
    """Of a real core with both doors."""
    loop = Unhurried()
    thread = threading.Thread(target=loop.run_forever)
    thread.start()

    def wait(what: Coroutine[Any, Any, Any]) -> Any:
        return asyncio.run_coroutine_threadsafe(what, loop).result(DEADLINE)

    live = Live(
        lab,
        Setup(),
        lambda do, tag: Performer(lab, do, tag=tag, services=("screen",)),
    )
    try:
        yield wait(live.start())
        wait(live.stop())
        wait(loop.shutdown_default_executor())
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        loop.close()


@pytest.mark.parametrize("way", [ByZeroMQ, ByWebSocket])
def test_a_real_core_says_the_same_by_both_doors(
    addresses: Addresses, way: Callable[[Addresses], Door]
) -> None:
    async def replay() -> None:
        async with asyncio.timeout(DEADLINE):
            door = way(addresses)
            try:
                await door.follow()
                for step in STEPS:
                    reply = await door.ask(step["peer"], step["send"])
                    said = f"{step['send']} was answered {reply}"
                    assert fits(timeless(step["reply"]), timeless(reply)), said
                    assert [heard(frame) for frame in await door.since()] == notices(step), said
            finally:
                await door.close()

    asyncio.run(replay())
