"""The screen's doors: the key, the origin, the media, and what comes in by the WebSocket."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import aiohttp
import pytest
from yarl import URL

from situ.decide.effects import Map
from situ.decide.inputs import Set, Touch, Use
from situ.document.project import Project
from situ.engine.screen.server import LARGEST_MESSAGE

PLACE = {"x": 0, "y": 0, "width": 10, "height": 10}
YES = {"type": "button", "id": "yes", **PLACE, "text": "YES", "event": "clickYes"}
NAME = {"type": "input", "id": "name", **PLACE, "kind": "text", "tag": "user.name"}
NAMES = {
    "type": "list",
    "id": "names",
    **PLACE,
    "items": [{"label": "Ann", "value": {"id": 2**60 + 1}}, {"label": "Bob", "value": 1.0}],
}


class Door:
    """A screen's server and a client without a browser."""

    def __init__(self, side: Any, client: aiohttp.ClientSession) -> None:
        self.side = side
        self.client = client
        self.key = str(side.performer.screen_url).partition("token=")[2]
        self.root = f"http://127.0.0.1:{side.performer.screen_port}"

    def show(self, *components: Any) -> None:
        value = {"components": list(components), "background": None}
        self.side.performer.perform(Map("screen", "reception", value))

    async def status(self, path: str, **options: Any) -> int:
        async with self.client.get(self.root + path, **options) as answer:
            return answer.status

    async def enter(self) -> None:
        assert await self.status(f"/?token={self.key}") == 200

    @asynccontextmanager
    async def socket(self) -> AsyncIterator[aiohttp.ClientWebSocketResponse]:
        await self.enter()
        async with self.client.ws_connect(self.root + "/ws", origin=self.root) as socket:
            yield socket

    async def shown(self, socket: aiohttp.ClientWebSocketResponse) -> Any:
        """The next state that the page is sent."""
        async with asyncio.timeout(20):
            while True:
                message = json.loads((await socket.receive()).data)
                if "show" in message:
                    return message["show"]

    async def said(self, count: int) -> list[Any]:
        """What has been submitted, when it is so much."""
        inputs: list[Any] = await self.side.answers.first(count)
        return inputs


def visit(situation: Any, scenario: Any) -> None:
    async def run() -> None:
        jar = aiohttp.CookieJar(unsafe=True)
        async with (
            situation.side(services=("screen",)) as side,
            aiohttp.ClientSession(cookie_jar=jar) as client,
        ):
            await scenario(Door(side, client))

    asyncio.run(run())


def test_nothing_opens_without_the_right_token(situation: Any) -> None:
    (situation.media / "a.png").write_bytes(b"png")

    async def scenario(door: Door) -> None:
        for path in ("/", "/?token=", "/?token=wrong", "/?token=%C3%BC", "/media/a.png"):
            assert await door.status(path) == 403
        with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
            await door.client.ws_connect(door.root + "/ws", origin=door.root)
        assert refused.value.status == 403
        await door.enter()
        assert await door.status("/") == 200
        assert await door.status("/media/a.png") == 200
        # A wrong key is wrong, also for somebody who is inside already.
        assert await door.status("/?token=wrong") == 403

    visit(situation, scenario)


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", "https://127.0.0.1", None, "same host"]
)
def test_a_page_of_another_origin_is_refused(situation: Any, origin: str | None) -> None:
    async def scenario(door: Door) -> None:
        await door.enter()
        given = "http://127.0.0.1:1" if origin == "same host" else origin
        with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
            await door.client.ws_connect(door.root + "/ws", origin=given)
        assert refused.value.status == 403

    visit(situation, scenario)


def test_the_page_runs_its_own_scripts_only_and_stands_in_no_frame(situation: Any) -> None:
    async def scenario(door: Door) -> None:
        async with door.client.get(f"{door.root}/?token={door.key}") as answer:
            policy = answer.headers["Content-Security-Policy"]
            cookie = answer.headers["Set-Cookie"]
            page = await answer.text()
        assert "default-src 'none'" in policy
        assert "script-src 'self'" in policy
        assert "unsafe" not in policy
        assert "frame-ancestors 'none'" in policy
        assert "HttpOnly" in cookie
        assert "SameSite=Strict" in cookie
        assert answer.headers["X-Content-Type-Options"] == "nosniff"
        assert door.key not in page

    visit(situation, scenario)


def test_of_what_is_shown_only_what_is_another_file_now_is_loaded_anew(
    situation: Any, tmp_path: Path
) -> None:
    names = ("same.png", "other.png", "ward.png")
    new = tmp_path / "new"
    (new / "media").mkdir(parents=True)
    for name in names:
        (situation.media / name).write_bytes(b"old")
        (new / "media" / name).write_bytes(b"old" if name == "same.png" else b"new")
    components = [{"id": name, "type": "image", "src": name, **PLACE} for name in names[:2]]
    value = {"background": "ward.png", "components": components}

    async def scenario(door: Door) -> None:
        async with door.socket() as socket:
            door.side.performer.perform(Map("screen", "lab", value))
            while (shown := (await door.shown(socket))["screen"]) is None:
                pass
            assert [one["src"] for one in shown["components"]] == [
                "/media/same.png",
                "/media/other.png",
            ]
            project = Project(root=str(new), name="test", media="media")
            door.side.performer.turn_to(project)
            shown = (await door.shown(socket))["screen"]
            assert [one["src"] for one in shown["components"]] == [
                "/media/same.png",
                "/media/other.png?edition=1",
            ]
            assert shown["background"] == "/media/ward.png?edition=1"
            address = door.root + shown["background"]
            async with door.client.get(address) as answer:
                assert await answer.read() == b"new"

    visit(situation, scenario)


def test_media_are_served_with_their_types_and_in_ranges(situation: Any) -> None:
    (situation.media / "a b").mkdir()
    (situation.media / "a b" / "m.webm").write_bytes(bytes(range(100)))
    (situation.media / "x.svg").write_text("<svg><script>alert(1)</script></svg>", "utf-8")

    async def scenario(door: Door) -> None:
        await door.enter()
        part = {"Range": "bytes=10-19"}
        async with door.client.get(door.root + "/media/a%20b/m.webm", headers=part) as answer:
            assert answer.status == 206
            assert answer.content_type == "video/webm"
            assert await answer.read() == bytes(range(10, 20))
        async with door.client.get(door.root + "/media/x.svg") as answer:
            assert answer.content_type == "image/svg+xml"
            assert "sandbox" in answer.headers["Content-Security-Policy"]

    visit(situation, scenario)


@pytest.mark.parametrize(
    "path",
    [
        "/media/%2e%2e/secret.png",
        "/media/..%2fsecret.png",
        "/media/link.png",
        "/media//etc/hostname",
        "/media/missing.png",
        "/media/notes.txt",
        "/media/a%00.png",
        "/page/..%2f..%2fsitu.toml",
        "/page/server.py",
        "/page/index.html",
        "/elsewhere",
    ],
)
def test_nothing_outside_the_media_and_the_page_is_served(situation: Any, path: str) -> None:
    secret = situation.media.parent / "secret.png"
    secret.write_bytes(b"secret")
    (situation.media / "link.png").symlink_to(secret)
    (situation.media / "notes.txt").write_text("notes", "utf-8")

    async def scenario(door: Door) -> None:
        await door.enter()
        async with door.client.get(URL(door.root + path, encoded=True)) as answer:
            assert answer.status in (400, 404)

    visit(situation, scenario)


@pytest.mark.parametrize(
    ("message", "code"),
    [
        ("x" * (LARGEST_MESSAGE + 1), 1009),
        ("no json", 1008),
        ("[]", 1008),
        ('{"revision":1,"eval":"x"}', 1008),
        ('{"revision":"1","touch":true}', 1008),
        ('{"revision":1,"use":{"component":7}}', 1008),
        (b"\xff\x00", 1008),
    ],
)
def test_a_message_that_is_none_or_too_large_closes_the_connection(
    situation: Any, message: Any, code: int
) -> None:
    async def scenario(door: Door) -> None:
        async with door.socket() as socket:
            await door.shown(socket)
            if isinstance(message, bytes):
                await socket.send_bytes(message)
            else:
                await socket.send_str(message)
            closed = await socket.receive(20)
            assert closed.type in (aiohttp.WSMsgType.CLOSE, aiohttp.WSMsgType.CLOSED)
            assert socket.close_code == code
        assert door.side.answers.inputs == []

    visit(situation, scenario)


def test_what_is_used_is_what_the_robot_showed_to_the_last_digit(situation: Any) -> None:
    async def scenario(door: Door) -> None:
        door.show(YES, NAME, NAMES)
        async with door.socket() as socket:
            revision = (await door.shown(socket))["revision"]
            for said in (
                {"use": {"component": "names", "item": 0}},
                {"use": {"component": "names", "item": 2}},
                {"use": {"component": "names", "item": -1}},
                {"use": {"component": "names", "value": "Mallory"}},
                {"use": {"component": "name"}},
                {"use": {"component": "gone"}},
                {"write": {"component": "yes", "value": "x"}},
                {"use": {"component": "yes", "value": "x"}},
                {"use": {"component": "name", "value": "Ann"}},
                {"write": {"component": "name", "value": "Ann B"}},
                {"touch": True},
            ):
                await socket.send_json({"revision": revision} | said)
            assert await door.said(5) == [
                Use("names", {"id": 2**60 + 1}),
                Use("yes"),
                Use("name", "Ann"),
                Set({"user.name": "Ann B"}, "screen"),
                Touch(),
            ]

    visit(situation, scenario)


def test_a_touch_of_what_stood_there_before_counts_for_nothing(situation: Any) -> None:
    async def scenario(door: Door) -> None:
        door.show(YES, NAMES)
        async with door.socket() as socket:
            old = (await door.shown(socket))["revision"]
            door.show(YES | {"event": "deleteAll"}, NAMES | {"items": []}, NAME)
            new = (await door.shown(socket))["revision"]
            for revision, said in (
                (old, {"use": {"component": "yes"}}),
                (old, {"use": {"component": "names", "item": 0}}),
                (old, {"touch": True}),
                (new, {"use": {"component": "yes"}}),
            ):
                await socket.send_json({"revision": revision} | said)
            assert await door.said(1) == [Use("yes")]

    visit(situation, scenario)


def test_a_live_text_does_not_make_a_touch_old(situation: Any) -> None:
    async def scenario(door: Door) -> None:
        door.show(YES)
        async with door.socket() as socket:
            old = (await door.shown(socket))["revision"]
            door.show(YES | {"text": "YES (9)"})
            await door.shown(socket)
            await socket.send_json({"revision": old, "use": {"component": "yes"}})
            await socket.send_json({"revision": old, "touch": True})
            assert await door.said(2) == [Use("yes"), Touch()]

    visit(situation, scenario)


def test_a_page_is_told_the_latest_and_gets_signs_of_life(
    situation: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.engine.screen.server.BEAT", 0.02)

    async def scenario(door: Door) -> None:
        async with door.socket() as socket:
            await door.shown(socket)
            for number in range(500):
                door.show(YES | {"text": str(number)})
            shown = await door.shown(socket)
            assert shown["screen"]["components"][0]["parts"] == [["499"]]
            assert json.loads((await socket.receive(20)).data) == {"beat": True}

    visit(situation, scenario)


def test_more_pages_than_a_robot_has_are_refused(
    situation: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.engine.screen.server.MOST_PAGES", 1)

    async def scenario(door: Door) -> None:
        async with door.socket() as socket:
            await door.shown(socket)
            with pytest.raises(aiohttp.WSServerHandshakeError) as refused:
                await door.client.ws_connect(door.root + "/ws", origin=door.root)
            assert refused.value.status == 503

    visit(situation, scenario)
