"""Services: real requests to a real web service on this machine, and files of the media."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from aiohttp import web

from situ.decide.effects import Begin, Cancel
from situ.decide.inputs import Finish
from situ.engine.actions import service


def begin(url: str, method: str = "GET", **params: Any) -> Begin:
    fields = {"name": "find", "url": url, "method": method, "params": params}
    return Begin(7, "reception", "service", "find", fields)


class Records:
    """A web service that tells what it was asked, and misbehaves on other paths."""

    def __init__(self) -> None:
        self.address = ""
        self.asked = asyncio.Event()
        self.left = asyncio.Event()

    async def echo(self, request: web.Request) -> web.Response:
        body = await request.json() if request.can_read_body else None
        return web.json_response(
            {"method": request.method, "query": dict(request.query), "body": body}
        )

    async def behave(self, request: web.Request) -> web.StreamResponse:
        how = request.match_info["how"]
        if how == "never":
            self.asked.set()
            try:
                await asyncio.Event().wait()
            finally:
                self.left.set()
        if how == "large":
            return web.Response(body=b'"' + b"x" * service.LIMIT + b'"')
        answers = {
            "empty": web.Response(status=204),
            "page": web.Response(text="<html>", content_type="text/html"),
            "plain": web.Response(text="fine"),
            "nan": web.Response(text='{"x": NaN}', content_type="application/json"),
            "deep": web.Response(text="[" * 150 + "]" * 150, content_type="application/json"),
            "deeper": web.Response(text="[" * 90_000, content_type="application/json"),
            "broken": web.Response(status=500, text="Traceback …"),
            "moved": web.Response(status=302, headers={"Location": "/echo"}),
            "round": web.Response(status=302, headers={"Location": "/round"}),
            "elsewhere": web.Response(status=302, headers={"Location": "file:///etc/passwd"}),
        }
        return answers[how]


@asynccontextmanager
async def records() -> AsyncIterator[Records]:
    served = Records()
    app = web.Application()
    app.router.add_route("*", "/echo", served.echo)
    app.router.add_route("*", "/{how}", served.behave)
    runner = web.AppRunner(app, access_log=None, shutdown_timeout=0.1, handler_cancellation=True)
    await runner.setup()
    await web.TCPSite(runner, "127.0.0.1", 0).start()
    served.address = f"http://127.0.0.1:{runner.addresses[0][1]}"
    try:
        yield served
    finally:
        await runner.cleanup()


def ask(
    situation: Any, path: str, method: str = "GET", timeout: float = 20.0, **params: Any
) -> Finish:
    async def scenario() -> Finish:
        async with records() as served, situation.side(timeout=timeout) as side:
            side.performer.perform(begin(served.address + path, method, **params))
            finish: Finish = await side.answers.finish(7)
            return finish

    return asyncio.run(scenario())


def test_get_sends_its_params_as_a_query_beside_what_the_url_has(situation: Any) -> None:
    finish = ask(situation, "/echo?kept=1", x="A & B", n=2.0, who={"name": "Ann"}, on=True)
    assert finish.ok
    assert finish.status == 200
    query = {"kept": "1", "x": "A & B", "n": "2", "who": '{"name":"Ann"}', "on": "true"}
    assert finish.result == {"method": "GET", "query": query, "body": None}


@pytest.mark.parametrize("method", ["POST", "PUT", "PATCH"])
def test_other_methods_send_a_json_object(situation: Any, method: str) -> None:
    finish = ask(situation, "/echo", method, x="A", list=[1, None])
    assert finish.result == {"method": method, "query": {}, "body": {"x": "A", "list": [1, None]}}


@pytest.mark.parametrize(
    ("path", "result"),
    [
        ("/empty", None),
        ("/plain", "fine"),
        ("/moved", {"method": "GET", "query": {}, "body": None}),
    ],
)
def test_an_empty_answer_is_null_and_plain_text_a_string(
    situation: Any, path: str, result: Any
) -> None:
    finish = ask(situation, path)
    assert (finish.ok, finish.result) == (True, result)


@pytest.mark.parametrize(
    ("path", "status", "words"),
    [
        ("/broken", 500, "answered 500 Internal Server Error"),
        ("/page", 200, "no JSON"),
        ("/nan", 200, "no JSON"),
        ("/deep", 200, "nested too deep"),
        ("/deeper", 200, "nested too deep"),
        ("/large", 200, "more than"),
        ("/round", None, "from one address to the next"),
        ("/elsewhere", None, ""),
    ],
)
def test_a_bad_answer_fails_in_one_line(
    situation: Any, monkeypatch: pytest.MonkeyPatch, path: str, status: int | None, words: str
) -> None:
    monkeypatch.setattr(service, "LIMIT", 1 << 20)
    finish = ask(situation, path)
    assert (finish.ok, finish.status) == (False, status)
    assert words in str(finish.error)
    assert "\n" not in str(finish.error)


def test_a_service_that_never_answers_fails(situation: Any) -> None:
    finish = ask(situation, "/never", timeout=0.2)
    assert (finish.ok, finish.status) == (False, None)
    assert "did not answer within 0.2 s" in str(finish.error)


def test_a_cancelled_service_hangs_up_and_answers_nothing(situation: Any) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            side.performer.perform(begin(served.address + "/never"))
            async with asyncio.timeout(20):
                await served.asked.wait()
                side.performer.perform(Cancel(7))
                await served.left.wait()
            assert side.answers.inputs == []

    asyncio.run(scenario())


@pytest.mark.parametrize(
    ("url", "words"),
    [
        ("http://127.0.0.1:1/find?key=secret", "http://127.0.0.1:1/find can not be reached"),
        ("ftp://host/x", "is no address"),
        ("file:///etc/passwd", "is no address"),
        ("", "is no address"),
        ("http://[::1", "is no address"),
        ("http://host:99999/", "is no address"),
        ("board:map/places", "not built yet"),
        ("media:missing.json", "no file missing.json"),
        ("media:../situ.toml", "no file ../situ.toml"),
        ("media:%2e%2e/situ.toml", "no file"),
        ("media:link.json", "no file"),
        ("media:broken.json", "is no JSON"),
    ],
)
def test_what_can_not_be_asked_fails_in_plain_words(situation: Any, url: str, words: str) -> None:
    (situation.media.parent / "situ.toml").write_text("[project]", "utf-8")
    (situation.media / "link.json").symlink_to(situation.media.parent / "situ.toml")
    (situation.media / "broken.json").write_text("{", "utf-8")

    async def scenario() -> Finish:
        async with situation.side() as side:
            side.performer.perform(begin(url))
            finish: Finish = await side.answers.finish(7)
            return finish

    finish = asyncio.run(scenario())
    assert not finish.ok
    assert words in str(finish.error)
    assert "secret" not in str(finish.error)


def test_a_method_that_is_none_fails(situation: Any) -> None:
    assert "BREW" in str(ask(situation, "/echo", "BREW").error)


def test_media_reads_a_file_of_the_project(situation: Any) -> None:
    (situation.media / "deep").mkdir()
    (situation.media / "deep" / "quiz one.json").write_text('{"questions": [1]}', "utf-8")

    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(begin("media:deep/quiz%20one.json"))
            finish = await side.answers.finish(7)
            assert (finish.ok, finish.result, finish.status) == (True, {"questions": [1]}, None)

    asyncio.run(scenario())


def test_a_proxy_of_the_environment_does_not_stand_before_this_machine(
    situation: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("HTTP_PROXY", "http://127.0.0.1:1")
    monkeypatch.delenv("NO_PROXY", raising=False)
    monkeypatch.delenv("no_proxy", raising=False)
    assert ask(situation, "/echo").ok
