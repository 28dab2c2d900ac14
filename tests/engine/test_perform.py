"""Effects go to who carries them out; what fails never takes the loop down."""

from __future__ import annotations

import asyncio
import logging
from typing import Any

import pytest

from situ.decide.effects import Begin, Cancel, Changed, Map, Refuse
from situ.decide.inputs import Finish
from situ.engine.actions.service import Services
from situ.errors import UsageError


class Broken:
    """An adapter that fails whenever it is used."""

    resources = frozenset({"base"})

    def __init__(self, _: Any) -> None:
        self.closed = False

    async def start(self) -> None: ...

    async def close(self) -> None:
        self.closed = True

    def apply(self, resource: str, value: Any) -> None:
        if value is not None:
            raise RuntimeError("the cable is out")


class Unplugged(Broken):
    """An adapter that can not start, and fails at whatever comes then."""

    async def start(self) -> None:
        raise UsageError("the robot is not plugged in")

    async def close(self) -> None:
        raise RuntimeError("it was never opened")

    def apply(self, resource: str, value: Any) -> None:
        raise RuntimeError("it was never opened")


def test_an_adapter_that_can_not_start_says_why_and_is_left_alone(
    situation: Any, caplog: pytest.LogCaptureFixture
) -> None:
    async def scenario() -> None:
        with pytest.raises(UsageError, match="not plugged in"):
            async with situation.side(adapter=Unplugged):
                pass

    asyncio.run(scenario())
    assert "never opened" not in caplog.text


def test_a_message_and_what_a_module_is_asked_are_the_cores_own(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            fields = {"topic": "nurse/call", "value": {"room": 12}}
            side.performer.perform(Begin(7, "reception", "message", None, fields))
            asked = {"name": "x", "url": "board:cuff/measure", "method": "GET", "params": {}}
            side.performer.perform(Begin(8, "reception", "service", "x", asked))
        assert side.answers.inputs == []

    asyncio.run(scenario())


def test_answers_never_come_from_inside_perform(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(Map("base", "m", {"command": "fly"}, (1,)))
            side.performer.perform(Begin(2, "reception", "service", "x", {"url": "x:"}))
            side.performer.perform(Map("speech", "m", {"text": ""}, (3,)))
            assert side.answers.inputs == []
            for action in (1, 2, 3):
                await side.answers.finish(action)

    asyncio.run(scenario())


def test_an_actor_that_fails_is_a_failed_action(
    situation: Any, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def explode(*_: Any) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(Services, "ask", explode)

    async def scenario() -> None:
        async with situation.side(adapter=Broken) as side:
            side.performer.perform(Map("base", "m", {"vx": 1}, (1,)))
            side.performer.perform(Begin(2, "reception", "service", "x", {"url": "x:"}))
            side.performer.perform(Begin(3, "reception", "dance", None, {}))
            for action, words in ((1, "the cable is out"), (2, "ZeroDivision"), (3, "dance")):
                finish = await side.answers.finish(action)
                assert not finish.ok
                assert words in str(finish.error)

    with caplog.at_level(logging.CRITICAL):
        asyncio.run(scenario())


def test_effects_of_services_that_run_elsewhere_are_left_alone(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side(services=("screen",)) as side:
            side.performer.perform(Map("base", "m", {"command": "fly"}, (1,)))
            side.performer.perform(Map("speech", "m", {"text": ""}, (2,)))
            side.performer.perform(Begin(3, "reception", "launch", "x", {"program": "x"}))
            side.performer.perform(Changed("a", 1, 1, "m", 0))
            side.performer.perform(Refuse("no"))
            side.performer.perform(Cancel(99))
            await asyncio.sleep(0)
        assert side.answers.inputs == []

    asyncio.run(scenario())


def test_speech_of_a_module_may_be_a_text_alone_and_nonsense_is_only_said_in_the_log(
    situation: Any, caplog: pytest.LogCaptureFixture
) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(Map("speech", "m", "one two"))
            assert await side.clock.asked_for_time() == pytest.approx(1.0)
            side.performer.perform(Map("speech", "m", {"loud": True}))
            side.performer.perform(Map("head", "m", {"spin": 3}))
            await asyncio.sleep(0)
        assert side.answers.inputs == []

    with caplog.at_level(logging.WARNING):
        asyncio.run(scenario())
    assert "neither text nor src" in caplog.text
    assert "not 'spin'" in caplog.text


def test_an_action_that_ended_is_answered_once(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side(poses=False) as side:
            side.performer.perform(
                Map("head", "m", {"command": "look", "params": {"yaw": 1}}, (1,))
            )
            await side.clock.advance(1)
            side.performer.perform(Map("head", None, None))
            side.performer.perform(Cancel(1))
            await side.clock.advance(1)
        assert side.answers.inputs == [Finish(id=1)]

    asyncio.run(scenario())


def test_after_close_nothing_is_answered(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(Map("speech", "m", {"text": "hello"}, (1,)))
            side.performer.perform(
                Map("base", "m", {"command": "drive", "params": {"distance": 1}}, (2,))
            )
            await side.clock.asked_for_time()
        await side.clock.advance(60)
        assert side.answers.inputs == []
        assert side.clock.waiting == []

    asyncio.run(scenario())


def test_a_taken_port_is_said_in_one_line(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side(services=("screen",)) as first:
            port = first.performer.screen_port
            with pytest.raises(UsageError, match=f"127.0.0.1:{port}.*free one"):
                async with situation.side(services=("screen",), screen=("127.0.0.1", port)):
                    pass

    asyncio.run(scenario())


def test_the_screens_key_stays_the_same_over_a_restart_and_is_nobody_elses(situation: Any) -> None:
    async def key() -> str:
        async with situation.side(services=("screen",)) as side:
            return str(side.performer.screen_url).partition("token=")[2]

    first = asyncio.run(key())
    assert len(first) >= 32
    assert asyncio.run(key()) == first
    file = situation.state / "keys" / "screen"
    assert file.stat().st_mode & 0o077 == 0

    file.write_text("")  # what a full disk leaves
    made = asyncio.run(key())
    assert len(made) >= 32
    assert asyncio.run(key()) == made

    file.unlink()
    file.parent.rmdir()
    file.parent.write_text("")
    with pytest.raises(UsageError, match="screen: the screen's key can not be kept there"):
        asyncio.run(key())
