"""Speech: done when heard to its end, silent at once when cancelled, never a shell."""

from __future__ import annotations

import asyncio
import os
import subprocess
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

from situ.decide.effects import Cancel, Map
from situ.document.spoken import estimate
from situ.engine.voices.espeak import EspeakNg

TEXT = "Hello! Shall we see how you are today?"


def speech(action: int, text: str = TEXT, lang: str | None = None) -> Map:
    return Map("speech", "reception", {"text": text, "lang": lang}, (action,))


def rendered_seconds(espeak: str, *options: str) -> float:
    """How long espeak-ng itself makes the text, by its default format of 22,050 16-bit samples."""
    wave = subprocess.run(
        [espeak, *options, "--stdin", "--stdout"],
        input=TEXT.encode(),
        capture_output=True,
        check=True,
    ).stdout
    return (len(wave) - 44) / (2 * 22_050)


@pytest.mark.espeak
def test_without_a_sound_device_speech_is_done_when_it_would_have_been_heard(
    situation: Any, espeak: str
) -> None:
    expected = rendered_seconds(espeak, "-v", "en", "-s", "175")

    async def scenario() -> None:
        async with situation.side(voice=EspeakNg(espeak)) as side:
            side.performer.perform(speech(7))
            length = await side.clock.asked_for_time()
            assert length == pytest.approx(expected, abs=0.05)
            await side.clock.advance(length - 0.01)
            assert side.answers.inputs == []
            await side.clock.advance(0.02)
            assert (await side.answers.finish(7)).ok

    asyncio.run(scenario())


@pytest.mark.espeak
@pytest.mark.parametrize(("rate", "words"), [(50, "88"), (200, "350"), ("fast", "175")])
def test_the_tag_speech_rate_is_obeyed(situation: Any, espeak: str, rate: Any, words: str) -> None:
    expected = rendered_seconds(espeak, "-v", "en", "-s", words)
    situation.tags["speech.rate"] = rate

    async def scenario() -> None:
        async with situation.side(voice=EspeakNg(espeak)) as side:
            side.performer.perform(speech(7))
            assert await side.clock.asked_for_time() == pytest.approx(expected, abs=0.05)

    asyncio.run(scenario())


@pytest.mark.espeak
def test_a_language_that_espeak_does_not_know_is_text(situation: Any, espeak: str) -> None:
    async def scenario() -> None:
        async with situation.side(voice=EspeakNg(espeak)) as side:
            side.performer.perform(speech(7, lang="qqq"))
            assert await side.clock.asked_for_time() == pytest.approx(estimate(TEXT))

    asyncio.run(scenario())


def test_without_espeak_the_length_is_estimated_from_the_words(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(speech(7, "one two three four"))
            assert await side.clock.asked_for_time() == pytest.approx(0.3 + 4 * 0.35)
            await side.clock.advance(2)
            assert (await side.answers.finish(7)).ok

    asyncio.run(scenario())
    assert estimate("東京です") == pytest.approx(0.3 + 4 * 0.2)
    assert estimate("one two", rate=50) == pytest.approx(0.3 + 2 * 0.7)


def test_an_empty_speech_is_done_at_once(situation: Any) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(speech(7, " \n "))
            assert (await side.answers.finish(7)).ok

    asyncio.run(scenario())


def test_text_goes_by_standard_input_and_is_no_option_no_phoneme_and_no_shell(
    situation: Any, program: Callable[[str, str], Path]
) -> None:
    fake = program("espeak-ng", 'printf "%s\\n" "$@" > "$0.args"; cat > "$0.text"')
    situation.tags.update({"speech.volume": 150, "language": "pt_BR"})

    async def scenario() -> None:
        async with situation.side(voice=EspeakNg(str(fake))) as side:
            side.performer.perform(speech(7, "-w /x $(id) \x1b; [[h@l'oU]]"))
            await side.clock.asked_for_time()

    asyncio.run(scenario())
    assert Path(f"{fake}.text").read_text("utf-8") == "-w /x $(id)  ; [ [h@l'oU]]"
    arguments = Path(f"{fake}.args").read_text("utf-8").split()
    assert arguments == ["-v", "pt-br", "-b", "1", "-a", "150", "-s", "175", "--stdin", "--stdout"]


@pytest.mark.parametrize("lang", ["../../etc", "-w", "en --path=/", "e", "en\nde"])
def test_what_is_no_language_fails_in_plain_words(situation: Any, lang: str) -> None:
    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(speech(7, lang=lang))
            finish = await side.answers.finish(7)
            assert not finish.ok
            assert "is no language" in str(finish.error)

    asyncio.run(scenario())


@pytest.mark.parametrize("by", ["null", "another", "cancel", "close"])
def test_speech_that_is_taken_away_is_killed_at_once(
    situation: Any,
    program: Callable[[str, str], Path],
    started: Any,
    ended: Callable[[int], Awaitable[None]],
    by: str,
) -> None:
    fake = program(
        "espeak-ng", f'mkfifo "$0.never"; echo $$ > "{started.path}"; read x < "$0.never"'
    )

    async def scenario() -> int:
        async with situation.side(voice=EspeakNg(str(fake))) as side:
            side.performer.perform(speech(7))
            pid: int = await started.pid()
            if by == "null":
                side.performer.perform(Map("speech", None, None))
            elif by == "another":
                side.performer.perform(Map("speech", "m", {"text": ""}, (8,)))
                assert (await side.answers.finish(8)).ok
            elif by == "cancel":
                side.performer.perform(Cancel(7))
            if by != "close":
                await ended(pid)
        assert 7 not in [finish.id for finish in side.answers.finishes]
        return pid

    pid = asyncio.run(scenario())
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


def test_a_speech_engine_that_can_not_start_is_text(situation: Any, tmp_path: Path) -> None:
    async def scenario() -> None:
        async with situation.side(voice=EspeakNg(str(tmp_path / "missing"))) as side:
            side.performer.perform(speech(7))
            await side.clock.advance(await side.clock.asked_for_time())
            assert (await side.answers.finish(7)).ok

    asyncio.run(scenario())


def test_what_fails_to_play_is_not_done_before_it_would_have_been_heard(
    situation: Any, program: Callable[[str, str], Path]
) -> None:
    """As espeak-ng behaves without a device: it complains, and ends at once with status 0."""
    fake = program("espeak-ng", 'cat > "$0.text"; echo "cannot find card 0" >&2')

    async def scenario() -> None:
        async with situation.side(voice=EspeakNg(str(fake)), sound=True) as side:
            side.performer.perform(speech(7))
            assert await side.clock.asked_for_time() == pytest.approx(estimate(TEXT))

    asyncio.run(scenario())
