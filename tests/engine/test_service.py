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
        self.tries = 0
        self.told: list[tuple[str, str | None]] = []
        self.sends_on_to = ""

    async def echo(self, request: web.Request) -> web.Response:
        body = await request.json() if request.can_read_body else None
        return web.json_response(
            {"method": request.method, "query": dict(request.query), "body": body}
        )

    async def form(self, request: web.Request) -> web.Response:
        return web.json_response({"type": request.content_type, "form": dict(await request.post())})

    async def told_key(self, request: web.Request) -> web.Response:
        """Keeps what it was told, and repeats it."""
        self.told.append((request.path_qs, request.headers.get("X-Key")))
        return web.json_response({"key": request.headers.get("X-Key")})

    async def on(self, request: web.Request) -> web.Response:
        self.told.append((request.path_qs, request.headers.get("X-Key")))
        return web.Response(status=307, headers={"Location": self.sends_on_to})

    async def busy(self, request: web.Request) -> web.Response:
        self.tries += 1
        if self.tries <= int(request.match_info["times"]):
            return web.Response(status=503)
        return web.json_response(self.tries)

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
            "number": web.json_response(3),
            "string": web.json_response("fine"),
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
    app.router.add_route("*", "/form", served.form)
    app.router.add_route("*", "/key/{which}", served.told_key)
    app.router.add_route("*", "/on/{which}", served.on)
    app.router.add_route("*", "/busy/{times}", served.busy)
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
        ("/number", 3),
        ("/string", "fine"),
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
        ("media:missing.json", "no file missing.json"),
        ("media:../situ.toml", "no file ../situ.toml"),
        ("media:%2e%2e/situ.toml", "no file"),
        ("media:link.json", "no file"),
        ("media:broken.json", "is no JSON"),
    ],
)
def test_what_can_not_be_asked_fails_in_plain_words(
    situation: Any, monkeypatch: pytest.MonkeyPatch, url: str, words: str
) -> None:
    monkeypatch.setattr(service, "AGAIN", ())
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


# -- what is tried again -------------------------------------------------------


@pytest.mark.parametrize("method", ["GET", "PUT", "DELETE", "OPTIONS"])
def test_what_may_be_asked_twice_is_tried_again_after_a_while(situation: Any, method: str) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            side.performer.perform(begin(served.address + "/busy/2", method))
            for wait in service.AGAIN[:2]:
                assert await side.clock.asked_for_time() == pytest.approx(wait)
                await side.clock.advance(wait)
            finish = await side.answers.finish(7)
            assert (finish.ok, finish.result) == (True, 3)

    asyncio.run(scenario())


def test_it_is_not_tried_for_ever(situation: Any) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            side.performer.perform(begin(served.address + "/busy/99"))
            for wait in service.AGAIN:
                await side.clock.asked_for_time()
                await side.clock.advance(wait)
            finish = await side.answers.finish(7)
            assert (finish.ok, finish.status) == (False, 503)
            assert served.tries == len(service.AGAIN) + 1

    asyncio.run(scenario())


def test_nobody_there_is_tried_again_too(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(begin("http://127.0.0.1:1/find"))
            for wait in service.AGAIN:
                await side.clock.asked_for_time()
                await side.clock.advance(wait)
            finish = await side.answers.finish(7)
            assert "can not be reached" in str(finish.error)

    asyncio.run(scenario())


@pytest.mark.parametrize("method", ["POST", "PATCH"])
def test_what_may_not_be_asked_twice_is_asked_once(situation: Any, method: str) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            side.performer.perform(begin(served.address + "/busy/1", method))
            finish = await side.answers.finish(7)
            assert (finish.ok, finish.status, served.tries) == (False, 503, 1)

    asyncio.run(scenario())


# -- secrets -----------------------------------------------------------------

KEY = "a-very-long-key"


def secrets(situation: Any, text: str, mode: int = 0o600) -> None:
    file = situation.state / "secrets.toml"
    file.write_text(text, "utf-8")
    file.chmod(mode)


def listed(url: str) -> str:
    return f'[[service]]\nurl = "{url}"\nheaders = {{ X-Key = "{KEY}" }}\n'


def test_a_service_is_told_its_secret_and_no_answer_repeats_it(situation: Any) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            more = f'query = {{ pass = "{KEY}" }}\n'
            secrets(situation, listed(served.address + "/key/*") + more)
            side.performer.perform(begin(served.address + "/key/a", x=1))
            finish = await side.answers.finish(7)
            assert served.told == [(f"/key/a?x=1&pass={KEY}", KEY)]
            assert (finish.ok, finish.result) == (True, {"key": "•••"})

    asyncio.run(scenario())


def test_another_address_is_not_told_the_secret(situation: Any) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            secrets(situation, listed(served.address + "/key/mine"))
            side.performer.perform(begin(served.address + "/key/yours"))
            await side.answers.finish(7)
            assert served.told == [("/key/yours", None)]

    asyncio.run(scenario())


@pytest.mark.parametrize("listens", ["other", "same"])
def test_who_is_sent_on_takes_the_secret_only_where_it_belongs(
    situation: Any, listens: str
) -> None:
    async def scenario() -> None:
        async with records() as first, records() as second, situation.side() as side:
            secrets(situation, listed(first.address + "/**"))
            first.sends_on_to = (second if listens == "other" else first).address + "/key/a"
            side.performer.perform(begin(first.address + "/on/a", "POST"))
            finish = await side.answers.finish(7)
            assert finish.ok
            assert first.told[0] == ("/on/a", KEY)
            if listens == "other":
                assert second.told == [("/key/a", None)]
            else:
                assert first.told[1] == ("/key/a", KEY)

    asyncio.run(scenario())


def test_a_form_is_sent_where_the_service_is_said_to_want_one(situation: Any) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            kind = "application/x-www-form-urlencoded"
            secrets(
                situation,
                f'[[service]]\nurl = "{served.address}/form"\n'
                f'headers = {{ Content-Type = "{kind}" }}\n',
            )
            side.performer.perform(begin(served.address + "/form", "POST", x="A & B", n=2.0))
            finish = await side.answers.finish(7)
            assert finish.result == {"type": kind, "form": {"x": "A & B", "n": "2"}}

    asyncio.run(scenario())


@pytest.mark.parametrize(
    ("text", "mode", "words"),
    [
        (f'[[service]]\nurl = "x"\nkey = "{KEY}"\n', 0o600, "unknown field"),
        (f'[[service]\nurl = "{KEY}"\n', 0o600, "no TOML at line 1"),
        (listed("https://api.example/**"), 0o640, "chmod 600"),
        (listed("https://api.example/**"), 0o604, "chmod 600"),
    ],
)
def test_secrets_that_can_not_be_used_fail_the_service_without_being_told(
    situation: Any, caplog: pytest.LogCaptureFixture, text: str, mode: int, words: str
) -> None:
    secrets(situation, text, mode)
    finish = ask(situation, "/echo")
    assert not finish.ok
    assert words in str(finish.error)
    assert KEY not in str(finish.error) + caplog.text


@pytest.mark.parametrize("key", [f"{KEY}\\n", f"{KEY}\\u0000", f"{KEY}…"])
def test_a_header_that_can_not_be_sent_is_not_repeated(situation: Any, key: str) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            secrets(situation, listed(served.address + "/**").replace(KEY, key))
            side.performer.perform(begin(served.address + "/echo", "POST"))
            finish = await side.answers.finish(7)
            assert not finish.ok
            assert "the header X-Key" in str(finish.error)
            assert KEY not in str(finish.error)

    asyncio.run(scenario())


def test_no_log_has_the_secret(situation: Any, caplog: pytest.LogCaptureFixture) -> None:
    async def scenario() -> None:
        async with records() as served, situation.side() as side:
            more = f'query = {{ pass = "{KEY}" }}\n'
            secrets(situation, listed(served.address + "/**") + more)
            for path in ("/key/a", "/broken", "/page"):
                side.performer.perform(begin(served.address + path))
                finish = await side.answers.finish(7)
                side.answers.inputs.clear()
                assert KEY not in str(finish)

    with caplog.at_level("DEBUG"):
        asyncio.run(scenario())
    assert KEY not in caplog.text
