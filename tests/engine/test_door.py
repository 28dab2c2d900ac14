"""The WebSocket door: the bodies of the ZeroMQ door, for whoever has the token."""

from __future__ import annotations

import asyncio
import json
import logging
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any

import aiohttp
import pytest
from tests.unhurried import Unhurried

from situ.blackboard import gate
from situ.blackboard.asynchronous import AsyncBoard
from situ.blackboard.calls import Person
from situ.blackboard.curve import Curve
from situ.blackboard.identity import KeyRole
from situ.blackboard.keys import (
    KnownKey,
    RobotKeys,
    add_known,
    door_to,
    new_pair,
    new_robot,
    remove_known,
    token_keys,
)
from situ.blackboard.link import Link
from situ.blackboard.replies import Addresses
from situ.document.ready import load_ready
from situ.engine.deciding import Setup
from situ.engine.live import Live
from situ.engine.perform import Performer
from situ.engine.screen import door as doors
from situ.engine.services import ServicesApart

DEADLINE = 20.0
LAB = Path(__file__).parent.parent / "blackboard" / "lab"


class Visitor:
    """A client by hand: requests by number, notices as they come."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse) -> None:
        self.socket = socket
        self.notices: list[tuple[str, Any]] = []
        self._ids = 0

    async def frame(self) -> str:
        message = await self.socket.receive()
        assert message.type is aiohttp.WSMsgType.TEXT, message
        return str(message.data)

    async def ask(self, do: str, **fields: Any) -> dict[str, Any]:
        self._ids += 1
        await self.socket.send_str(json.dumps({"do": do, "id": self._ids, **fields}))
        while True:
            frame = await self.frame()
            if frame[0] != "{":
                self._heard(frame)
                continue
            reply: dict[str, Any] = json.loads(frame)
            if reply["id"] == self._ids:
                return reply

    async def follow(self, topic: str) -> None:
        """Subscribes, and returns when everything published from now on is heard."""
        echo = f"echo:{topic}\n"
        await self.socket.send_str("+" + topic)
        for _ in range(2):
            await self.socket.send_str("+" + echo)
            while not any(on == "echo" for on, _ in self.notices):
                self._heard(await self.frame())
            self.notices = [one for one in self.notices if one[0] != "echo"]
            await self.socket.send_str("-" + echo)

    async def notice(self) -> tuple[str, Any]:
        while not self.notices:
            self._heard(await self.frame())
        return self.notices.pop(0)

    def _heard(self, frame: str) -> None:
        body = json.loads(frame.partition("\n")[2])
        self.notices.append((body.pop("on"), body))


class House:
    """A real core behind a real door."""

    def __init__(self, live: Live, client: aiohttp.ClientSession, addresses: Addresses) -> None:
        self.client = client
        self.live: Live | None = live
        assert addresses.http is not None
        self.root, _, self.token = addresses.http.partition("/?token=")

    async def stop(self) -> None:
        live, self.live = self.live, None
        if live is not None:
            await live.stop()

    @asynccontextmanager
    async def visit(self, token: str | None = None) -> AsyncIterator[Visitor]:
        headers = {"Authorization": f"Bearer {token or self.token}"}
        async with self.client.ws_connect(self.root + "/board", headers=headers) as socket:
            yield Visitor(socket)

    async def status(self, path: str = "/board", **headers: str) -> int:
        with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
            await self.client.ws_connect(self.root + path, headers=headers)
        return refused.value.status


def receive(scenario: Callable[[House], Awaitable[None]], keys: RobotKeys | None = None) -> None:
    project = load_ready(LAB)

    async def run() -> None:
        live = Live(
            project,
            Setup(keys=keys),
            lambda submit, tag: Performer(project, submit, tag=tag, services=("screen",)),
        )
        addresses = await live.start()
        async with asyncio.timeout(DEADLINE), aiohttp.ClientSession() as client:
            house = House(live, client, addresses)
            try:
                await scenario(house)
            finally:
                await house.stop()

    # Who says nothing for a while, on a machine that is slow, does not lose its session here.
    with asyncio.Runner(loop_factory=Unhurried) as runner:
        runner.run(run())


def test_a_visitor_talks_to_the_core_as_by_zeromq() -> None:
    async def scenario(house: House) -> None:
        async with house.visit() as nod, house.visit() as ann:
            welcome = await nod.ask("hello", version=1, module="nod", resources=["head"])
            assert (welcome["re"], welcome["project"]) == ("welcome", "lab")
            await ann.ask("hello", version=1, role="operator", user="ann")
            assert (await nod.ask("acquire", resources=["head"]))["re"] == "granted"
            await ann.follow("t:speech.")
            snapshot = await ann.ask("watch", patterns=["speech.*"])
            assert snapshot["re"] == "snapshot"
            assert (await nod.ask("set", tags={"speech.text": "hällo"}))["re"] == "written"
            on, change = await ann.notice()
            assert (on, change["tag"], change["value"]) == ("change", "speech.text", "hällo")
            assert change["writer"] == "nod"

    receive(scenario)


def test_a_closed_connection_ends_the_session_at_once() -> None:
    async def scenario(house: House) -> None:
        async with house.visit() as ann:
            await ann.ask("hello", version=1, role="operator", user="ann")
            await ann.follow("trace\n")
            await ann.ask("trace")
            async with house.visit() as nod:
                await nod.ask("hello", version=1, module="nod", resources=["head"])
            kinds: list[str] = []
            while "lost" not in kinds:
                on, body = await ann.notice()
                kinds += [event["kind"] for event in body["events"]] if on == "events" else []

    receive(scenario)


def test_a_page_of_another_origin_is_refused_even_with_the_token() -> None:
    async def scenario(house: House) -> None:
        bearer = f"Bearer {house.token}"
        assert await house.status(Authorization=bearer, Origin="http://evil.example") == 403
        assert await house.status(Authorization=bearer, Origin="null") == 403

    receive(scenario)


def test_without_the_token_nobody_comes_in() -> None:
    async def scenario(house: House) -> None:
        assert await house.status() == 403
        assert await house.status("/board?token=wrong") == 403
        assert await house.status(Authorization="Bearer wrong") == 403
        assert await house.status(Authorization=f"Basic {house.token}") == 403

    receive(scenario)


@pytest.mark.parametrize(
    ("frame", "code"),
    [
        ("hello?", aiohttp.WSCloseCode.POLICY_VIOLATION),
        (b'{"do":"bye","id":1}', aiohttp.WSCloseCode.UNSUPPORTED_DATA),
        ("{" + " " * doors.LARGEST, aiohttp.WSCloseCode.MESSAGE_TOO_BIG),
    ],
    ids=["no-frame", "binary", "too-large"],
)
def test_what_is_no_frame_closes_the_door(frame: str | bytes, code: int) -> None:
    async def scenario(house: House) -> None:
        async with house.visit() as bad, house.visit() as good:
            if isinstance(frame, bytes):
                await bad.socket.send_bytes(frame)
            else:
                await bad.socket.send_str(frame)
            message = await bad.socket.receive()
            assert (message.type, bad.socket.close_code) == (aiohttp.WSMsgType.CLOSE, code)
            assert (await good.ask("hello", version=1, role="viewer"))["re"] == "welcome"

    receive(scenario)


def test_a_visitor_who_does_not_read_holds_nobody_up_and_finds_the_gap(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(doors, "HELD", 100_000)
    monkeypatch.setattr(doors, "NOTICES", 10)

    async def scenario(house: House) -> None:
        async with house.visit() as slow, house.visit() as ann:
            await slow.ask("hello", version=1, role="viewer")
            await slow.follow("t:picture\n")
            await slow.ask("watch", patterns=["picture"])
            await ann.ask("hello", version=1, role="operator", user="ann")
            last = 0
            for number in range(400):
                reply = await ann.ask("set", tags={"picture": f"{number}:" + "x" * 50_000})
                last = reply["versions"]["picture"]
            # It has said nothing for as long as that took, which may be more than a lease.
            assert (await slow.ask("hello", version=1, role="viewer"))["re"] == "welcome"
            # It reads again: what came, then what stands there now.
            snapshot = await slow.ask("watch", patterns=["picture"])
            assert snapshot["entries"]["picture"]["version"] == last
            heard = [body["version"] for on, body in slow.notices if on == "change"]
            assert heard == sorted(heard)
            assert len(heard) < last

    receive(scenario)


def test_visitors_are_told_that_the_robot_stops() -> None:
    async def scenario(house: House) -> None:
        async with house.visit() as ann:
            await ann.ask("hello", version=1, role="viewer")
            stopping = asyncio.create_task(house.stop())
            assert (await ann.socket.receive()).type is aiohttp.WSMsgType.CLOSE
            assert ann.socket.close_code == aiohttp.WSCloseCode.GOING_AWAY
            await stopping

    receive(scenario)


# -- with keys ---------------------------------------------------------------

TOKENS: dict[str, tuple[KeyRole, str]] = {
    "tablet": ("viewer", "tablet's token"),
    "ann": ("operator", "ann's token"),
    "face": ("module", "face's token"),
}


@pytest.fixture
def keys(tmp_path: Path) -> RobotKeys:
    """A robot's, who knows some people by their tokens."""
    new_robot(tmp_path)
    for name, (role, token) in TOKENS.items():
        public = token_keys(token)[0].decode()
        write = ("face.*",) if role == "module" else ()
        add_known(tmp_path, name, KnownKey(public, role, write, door=True))
    return RobotKeys(tmp_path)


def test_with_keys_everybody_does_what_his_own_token_allows(keys: RobotKeys) -> None:
    async def scenario(house: House) -> None:
        async with (
            house.visit("ann's token") as ann,
            house.visit("face's token") as face,
            house.visit("tablet's token") as tablet,
        ):
            assert (await ann.ask("hello", version=1, role="operator"))["re"] == "welcome"
            assert (await face.ask("hello", version=1, module="face"))["re"] == "welcome"
            # Nobody is more than his token.
            for role in ("operator", "service", "scenario"):
                refused = await tablet.ask("hello", version=1, role=role)
                assert refused["code"] == "denied"
            assert (await tablet.ask("hello", version=1, module="face"))["code"] == "denied"
            assert (await tablet.ask("hello", version=1, role="viewer"))["re"] == "welcome"
            assert (await tablet.ask("set", tags={"user.name": "x"}))["code"] == "denied"
            assert (await face.ask("set", tags={"user.name": "x"}))["code"] == "denied"
            assert (await face.ask("set", tags={"face.visible": True}))["re"] == "written"
            await tablet.follow("t:user.name\n")
            await tablet.ask("watch", patterns=["user.name"])
            await ann.ask("set", tags={"user.name": "Ann"})
            _, change = await tablet.notice()
            assert (change["value"], change["writer"]) == ("Ann", "operator:ann")

    receive(scenario, keys)


def test_with_keys_it_is_written_down_who_came_from_where(
    keys: RobotKeys, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.INFO, "situ.audit")

    async def scenario(house: House) -> None:
        async with house.visit("ann's token"):
            pass
        assert await house.status(Authorization="Bearer wrong") == 403

    receive(scenario, keys)
    public = token_keys("ann's token")[0].decode()
    lines = [line for line in caplog.messages if "socket=board" in line]
    assert lines[0].startswith("connected socket=board address=127.0.0.1 name=ann key=")
    assert public in lines[0]
    assert "token" not in lines[0]
    assert lines[1].startswith("refused socket=board address=127.0.0.1 why=")


def test_with_keys_the_screens_token_opens_nothing(keys: RobotKeys) -> None:
    async def scenario(house: House) -> None:
        assert await house.status() == 403
        assert await house.status(Authorization=f"Bearer {house.token}") == 403
        assert await house.status(f"/board?token={house.token}") == 403
        assert await house.status(Authorization="Bearer wrong") == 403
        async with house.client.get(f"{house.root}/?token={house.token}") as page:
            assert page.status == 200
        # The page's cookie neither.
        assert await house.status() == 403
        headers = {"Origin": "http://evil.example"}
        assert await house.status("/board?token=ann's token", **headers) == 403

    receive(scenario, keys)


def test_a_visitor_whom_the_robot_knows_no_longer_is_sent_away(
    keys: RobotKeys, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "LOOK", 0.0)

    async def scenario(house: House) -> None:
        async with house.visit("ann's token") as ann:
            await ann.ask("hello", version=1, role="operator")
            remove_known(keys.folder, "ann")

            async def talk() -> None:
                with suppress(ConnectionError):
                    while True:
                        await ann.socket.send_str('{"do":"heartbeat","id":9}')
                        await asyncio.sleep(0)

            talking = asyncio.create_task(talk())
            async for _ in ann.socket:
                pass
            await talking
            assert ann.socket.close_code == aiohttp.WSCloseCode.TRY_AGAIN_LATER
        assert await house.status("/board?token=ann's token") == 403

    receive(scenario, keys)


def test_the_door_of_a_screen_on_another_machine_leaves_to_the_core_whom_it_lets_in(
    keys: RobotKeys,
) -> None:
    project = load_ready(LAB)
    pair = new_pair("screen")
    add_known(keys.folder, "screen", KnownKey(pair.public, "service"))
    own = Curve(pair.public.encode(), pair.secret.encode(), keys.public, "screen")

    async def run() -> None:
        live = Live(project, Setup(keys=keys))
        core = await live.start()
        person = Person(role="service", services=("screen",))
        apart = ServicesApart(
            AsyncBoard(Link(core.requests, person, keys=own), DEADLINE),
            ("screen",),
            lambda submit, tag: Performer(project, submit, tag=tag, services=("screen",)),
            door_to(keys.public),
        )
        try:
            addresses = await apart.start()
            async with asyncio.timeout(DEADLINE), aiohttp.ClientSession() as client:
                house = House(live, client, addresses)
                async with house.visit("ann's token") as ann:
                    await ann.ask("hello", version=1, role="operator")
                    assert (await ann.ask("set", tags={"user.name": "Ann"}))["re"] == "written"
                assert await house.status() == 403
                async with house.visit("nobody's token") as nobody:
                    for _ in range(1_000):
                        await nobody.socket.send_str('{"do":"hello","id":1,"version":1}')
                    await nobody.socket.send_str('{"do":"hello","id":1,"version":1}')
                    message = await nobody.socket.receive()
                    assert message.type is aiohttp.WSMsgType.CLOSE
                    assert nobody.socket.close_code == aiohttp.WSCloseCode.TRY_AGAIN_LATER
        finally:
            await apart.stop()
            await live.stop()

    asyncio.run(run())


def test_the_keys_of_a_program_open_no_door(keys: RobotKeys) -> None:
    secret = "a secret key is no token"
    public = token_keys(secret)[0].decode()
    add_known(keys.folder, "nod", KnownKey(public, "module"))
    keys.refresh()
    assert keys.identity(public) is not None
    assert keys.door(secret) is None
