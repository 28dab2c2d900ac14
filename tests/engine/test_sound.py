"""Sounds last as long as they last, heard or not."""

from __future__ import annotations

import asyncio
import struct
import wave
from pathlib import Path
from typing import Any

import pytest

from situ.decide.effects import Map
from situ.engine.actions.sound import UNKNOWN, audible, length


def chime(file: Path, seconds: float = 0.75) -> None:
    with wave.open(str(file), "wb") as out:
        out.setnchannels(1)
        out.setsampwidth(2)
        out.setframerate(8000)
        out.writeframes(b"\0\0" * int(8000 * seconds))


def sound(src: str) -> Map:
    return Map("speech", "reception", {"src": src}, (7,))


def test_a_sound_is_done_after_its_length_where_nobody_can_hear(situation: Any) -> None:
    chime(situation.media / "chime.wav")

    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(sound("chime.wav"))
            assert await side.clock.asked_for_time() == pytest.approx(0.75)
            await side.clock.advance(0.76)
            assert (await side.answers.finish(7)).ok

    asyncio.run(scenario())


@pytest.mark.parametrize("src", ["missing.wav", "../secret.wav", "/etc/hostname", ""])
def test_a_sound_that_is_not_in_the_media_fails(situation: Any, src: str) -> None:
    chime(situation.media.parent / "secret.wav")

    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(sound(src))
            finish = await side.answers.finish(7)
            assert not finish.ok
            assert "no sound" in str(finish.error)

    asyncio.run(scenario())


def test_a_sound_of_unknown_length_counts_as_one_second(situation: Any) -> None:
    (situation.media / "odd.flac").write_bytes(b"fLaC....")

    async def scenario() -> None:
        async with situation.side() as side:
            side.performer.perform(sound("odd.flac"))
            assert await side.clock.asked_for_time() == pytest.approx(UNKNOWN)

    asyncio.run(scenario())


def test_lengths_are_read_from_wav_ogg_and_mp3(tmp_path: Path) -> None:
    file = tmp_path / "sound"
    chime(file, 1.25)
    assert length(file) == pytest.approx(1.25)
    # Ogg Vorbis: the first page names the rate, the last page's position is the end.
    last = b"OggS\0\4" + struct.pack("<q", 88_200) + b"\0" * 12
    head = b"OggS\0\2" + b"\0" * 22 + b"\x01vorbis" + struct.pack("<IBI", 0, 2, 44_100)
    file.write_bytes(head + b"\0" * 70_000 + last)
    assert length(file) == pytest.approx(2.0)
    file.write_bytes(b"OggS\0\2" + b"\0" * 22 + b"OpusHead" + b"\0" * 11 + last)
    assert length(file) == pytest.approx(88_200 / 48_000)
    # MP3: 128 kbit/s behind a tag of 100 bytes.
    file.write_bytes(b"ID3\3\0\0\0\0\0\x5a" + b"\0" * 90 + b"\xff\xfb\x90\0" + b"\0" * 31_996)
    assert length(file) == pytest.approx(2.0)
    file.write_bytes(b"")
    assert length(file) is None


def test_a_sound_server_or_a_playback_device_makes_sound_audible(tmp_path: Path) -> None:
    devices = tmp_path / "snd"
    assert not audible({}, devices)
    devices.mkdir()
    (devices / "pcmC0D0c").touch()
    assert not audible({}, devices)
    (devices / "pcmC0D0p").touch()
    assert audible({}, devices)
    (tmp_path / "pulse").mkdir()
    (tmp_path / "pulse" / "native").touch()
    assert audible({"XDG_RUNTIME_DIR": str(tmp_path)}, tmp_path / "none")
