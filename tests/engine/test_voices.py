"""Voices beside espeak-ng, as programs that behave like them; and what happens without one."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

from situ.cli import main
from situ.decide.effects import Map
from situ.document.spoken import estimate
from situ.engine.voices.dispatcher import SpeechDispatcher
from situ.engine.voices.espeak import EspeakNg
from situ.engine.voices.piper import Piper

TEXT = "Good morning, Ann.\nDid you sleep well?"
WAITS = 'echo $$ > "{started}"; read x < "$0.end"'
"""A program that tells its process id and ends when something is written into ``$0.end``."""

Write = Callable[[str, str], Path]


def speech(action: int, text: str = TEXT, lang: str = "en") -> Map:
    return Map("speech", "reception", {"text": text, "lang": lang}, (action,))


def test_where_it_could_be_heard_a_missing_engine_shows_the_text_and_then_fails(
    situation: Any,
) -> None:
    async def scenario() -> None:
        async with situation.side(voice=EspeakNg(None), sound=True) as side:
            assert side.performer.captions
            side.performer.perform(speech(7))
            assert await side.clock.asked_for_time() == pytest.approx(estimate(TEXT))
            assert side.answers.inputs == []
            await side.clock.advance(estimate(TEXT) + 0.01)
            finish = await side.answers.finish(7)
            assert not finish.ok
            assert "espeak-ng is not installed" in str(finish.error)

    asyncio.run(scenario())


def test_what_is_said_can_be_read_from_the_first_speech_on_that_nobody_heard(
    situation: Any, program: Write
) -> None:
    fake = program("spd-say", 'test "$1" = --cancel || { echo "no server" >&2; exit 1; }')

    async def scenario() -> None:
        async with situation.side(voice=SpeechDispatcher(str(fake)), sound=True) as side:
            assert not side.performer.captions
            side.performer.perform(speech(7))
            assert await side.clock.asked_for_time() == pytest.approx(estimate(TEXT))
            assert side.performer.captions
            await side.clock.advance(estimate(TEXT) + 0.01)
            assert (await side.answers.finish(7)).ok

    asyncio.run(scenario())


def test_a_screen_apart_from_the_voice_has_a_line_for_it_too(situation: Any) -> None:
    async def scenario() -> None:
        for voice, captions in ((EspeakNg(None), True), (EspeakNg("espeak-ng"), False)):
            services = ("screen",)
            async with situation.side(voice=voice, sound=True, services=services) as side:
                assert side.performer.captions == captions

    asyncio.run(scenario())


# -- speech-dispatcher -------------------------------------------------------------


def test_speech_dispatcher_is_done_when_spd_say_has_waited_to_the_end(
    situation: Any, program: Write, started: Any
) -> None:
    fake = program(
        "spd-say", f'printf "%s\\n" "$@" > "$0.args"; {WAITS}'.format(started=started.path)
    )
    os.mkfifo(f"{fake}.end")
    situation.tags.update({"speech.rate": 200, "speech.volume": 50})

    async def scenario() -> None:
        async with situation.side(voice=SpeechDispatcher(str(fake)), sound=True) as side:
            side.performer.perform(speech(7, "--cancel $(id)", "pt_BR"))
            await started.pid()
            assert side.answers.inputs == []
            await asyncio.to_thread(Path(f"{fake}.end").write_text, "end\n")
            assert (await side.answers.finish(7)).ok

    asyncio.run(scenario())
    assert Path(f"{fake}.args").read_text("utf-8").splitlines() == [
        *("--wait", "--priority", "message", "--language", "pt-BR"),
        *("--rate", "80", "--volume", "0", "--", "--cancel $(id)"),
    ]


def test_speech_dispatcher_is_told_to_be_silent_before_the_next_speech_begins(
    situation: Any, program: Write, started: Any, ended: Callable[[int], Awaitable[None]]
) -> None:
    fake = program(
        "spd-say",
        'echo "$@" >> "$0.calls"; case "$*" in --cancel | *next) exit 0; esac; '
        + WAITS.format(started=started.path),
    )
    os.mkfifo(f"{fake}.end")

    async def scenario() -> None:
        async with situation.side(voice=SpeechDispatcher(str(fake)), sound=True) as side:
            side.performer.perform(speech(7))
            pid = await started.pid()
            side.performer.perform(speech(8, "next"))
            await ended(pid)
            assert (await side.answers.finish(8)).ok
            assert [finish.id for finish in side.answers.finishes] == [8]

    asyncio.run(scenario())
    calls = Path(f"{fake}.calls").read_text("utf-8").splitlines()
    assert calls[-2] == "--cancel"
    assert calls[-1].endswith("-- next")


# -- piper ---------------------------------------------------------------------------

SECOND = 16_000
PIPER = (
    f'printf "%s\\n" "$@" > "$0.args"; cat > "$0.text"; yes | tr -d "\\n" | head -c {3 * SECOND}'
)
"""A second and a half of sound, every sample 0x7979."""


def model(folder: Path, language: str = "en_GB") -> Path:
    file = folder / "ann.onnx"
    file.touch()
    described = f'{{"audio": {{"sample_rate": {SECOND}}}, "language": {{"code": "{language}"}}}}'
    Path(f"{file}.json").write_text(described, "utf-8")
    return file


def test_piper_is_heard_through_a_player_at_the_volume_and_rate_of_the_tags(
    situation: Any, program: Write, tmp_path: Path
) -> None:
    fake, player = program("piper", PIPER), program("player", 'cat > "$0.heard"')
    rates: list[int] = []
    situation.tags.update({"speech.rate": 200, "speech.volume": 50})

    def play(rate: int) -> list[str]:
        rates.append(rate)
        return [str(player)]

    async def scenario() -> None:
        voice = Piper(str(fake), model(tmp_path), play)
        async with situation.side(voice=voice, sound=True) as side:
            side.performer.perform(speech(7))
            # The player has swallowed it at once: what is left is the time that it takes to hear.
            assert await side.clock.asked_for_time() == pytest.approx(1.5)
            await side.clock.advance(1.51)
            assert (await side.answers.finish(7)).ok
            assert not side.performer.captions

    asyncio.run(scenario())
    assert rates == [SECOND]
    heard = Path(f"{player}.heard").read_bytes()
    assert heard == round(0x7979 / 2).to_bytes(2, "little") * (3 * SECOND // 2)
    assert Path(f"{fake}.text").read_text("utf-8") == "Good morning, Ann. Did you sleep well?\n"
    assert Path(f"{fake}.args").read_text("utf-8").split() == [
        *("--model", str(tmp_path / "ann.onnx"), "--output_raw", "--length_scale", "0.500"),
    ]


@pytest.mark.parametrize(
    ("sound", "player", "captions"),
    [
        (False, None, True),
        (True, None, True),
        (True, 'echo "device busy" >&2; exit 1', True),
    ],
    ids=["no-device", "no-player", "busy"],
)
def test_piper_unheard_is_done_when_it_would_have_been_heard(
    situation: Any, program: Write, tmp_path: Path, sound: bool, player: str | None, captions: bool
) -> None:
    fake = program("piper", PIPER)
    argv = [str(program("player", player))] if player else None

    async def scenario() -> None:
        voice = Piper(str(fake), model(tmp_path), lambda rate: argv)
        async with situation.side(voice=voice, sound=sound) as side:
            side.performer.perform(speech(7))
            assert await side.clock.asked_for_time() == pytest.approx(1.5)
            assert side.performer.captions == captions

    asyncio.run(scenario())


@pytest.mark.parametrize(
    ("script", "lang"), [(PIPER, "ja"), ('echo "no such model" >&2; exit 1', "en")]
)
def test_what_piper_can_not_speak_is_text(
    situation: Any, program: Write, tmp_path: Path, script: str, lang: str
) -> None:
    fake, player = program("piper", script), program("player", 'cat > "$0.heard"')

    async def scenario() -> None:
        voice = Piper(str(fake), model(tmp_path), lambda rate: [str(player)])
        async with situation.side(voice=voice, sound=True) as side:
            side.performer.perform(speech(7, lang=lang))
            await side.clock.advance(await side.clock.asked_for_time())
            assert (await side.answers.finish(7)).ok
            assert side.performer.captions

    asyncio.run(scenario())
    heard = Path(f"{player}.heard")
    assert not heard.exists() or heard.read_bytes() == b""


def test_a_voice_file_that_is_missing_fails(situation: Any, program: Write, tmp_path: Path) -> None:
    async def scenario() -> None:
        voice = Piper(str(program("piper", PIPER)), tmp_path / "gone.onnx")
        async with situation.side(voice=voice, sound=True) as side:
            side.performer.perform(speech(7))
            await side.clock.advance(await side.clock.asked_for_time())
            finish = await side.answers.finish(7)
            assert not finish.ok
            assert "gone.onnx" in str(finish.error)

    asyncio.run(scenario())


def test_piper_and_its_player_are_killed_when_the_speech_is_cut_off(
    situation: Any,
    program: Write,
    tmp_path: Path,
    started: Any,
    ended: Callable[[int], Awaitable[None]],
) -> None:
    # The engine sounds on for ever; the player tells that it has heard the beginning.
    fake = program("piper", 'cat > "$0.text"; echo $$ > "$0.pid"; exec yes')
    player = program(
        "player", f'head -c 10 > "$0.heard"; echo $$ > "{started.path}"; exec cat > /dev/null'
    )

    async def scenario() -> None:
        voice = Piper(str(fake), model(tmp_path), lambda rate: [str(player)])
        async with situation.side(voice=voice, sound=True) as side:
            side.performer.perform(speech(7))
            pid = await started.pid()
            side.performer.perform(Map("speech", None, None))
            await ended(pid)
            await ended(int(Path(f"{fake}.pid").read_text("utf-8")))
        assert side.answers.finishes == []

    asyncio.run(scenario())


# -- the choice ------------------------------------------------------------------------


@pytest.mark.parametrize("choice", ["festival", "piper", "piper:", ""])
def test_an_engine_that_is_none_is_wrong_usage(
    choice: str, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", str(project), "--no-restart", "--speech", choice]) == 2
    assert "espeak-ng, speech-dispatcher or piper:FILE" in capsys.readouterr().err


@pytest.fixture
def project(tmp_path: Path) -> Path:
    file = tmp_path / "door.rbd.xml"
    file.write_text('<application name="door"><state no="1"/></application>\n', "utf-8")
    return file
