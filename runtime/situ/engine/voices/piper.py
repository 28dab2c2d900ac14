"""Piper: a voice of one's own, from a file."""

from __future__ import annotations

import array
import asyncio
import contextlib
import json
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import Any

from situ.engine.actions.sound import raw_player
from situ.engine.process import running
from situ.engine.voices.text import Said, Spoken

USUAL_RATE = 22_050
"""Samples a second of a voice whose file beside it tells nothing."""
CHUNK = 16_384


class Piper:
    """Speaks by ``piper --output_raw``, a player sounding what has been rendered so far.

    program: the path of piper; None where the machine has none. model: the voice, an
    ``.onnx`` file; the ``.onnx.json`` beside it tells its language and sample rate.
    player(samples a second): what plays 16-bit samples from standard input, or None.
    """

    def __init__(
        self,
        program: str | None,
        model: Path,
        player: Callable[[int], list[str] | None] = raw_player,
    ) -> None:
        self.program = program
        self.model = model
        self._player = player

    @property
    def missing(self) -> str | None:
        if self.program is None:
            return "piper is not installed"
        return None if self.model.is_file() else f"there is no voice {self.model}"

    async def speak(self, said: Said, audible: bool) -> Spoken:
        if self.missing is not None:
            return Spoken(unheard=self.missing, missing=True)
        language, rate = _described(self.model)
        if language is not None and language != said.lang.split("-")[0].lower():
            return Spoken(unheard=f"the voice {self.model.name} can not speak {said.lang}")
        argv = self._player(rate) if audible else None
        try:
            return await self._render(said, rate, argv, audible and argv is None)
        except OSError as error:
            return Spoken(unheard=f"piper can not be started: {error.strerror}", missing=True)

    async def _render(
        self, said: Said, rate: int, player: list[str] | None, unplayable: bool
    ) -> Spoken:
        assert self.program is not None
        argv = [self.program, "--model", str(self.model), "--output_raw"]
        async with running([*argv, "--length_scale", f"{100 / said.rate:.3f}"]) as engine:
            # One line is one text: a line break would end it early.
            engine.stdin.write((" ".join(said.text.split()) + "\n").encode())
            engine.stdin.close()
            sound = _louder(_chunks(engine.stdout), said.volume)
            size, unplayed = await _play(sound, player)
            ended = await engine.ended()
        seconds = size / (2 * rate)
        if ended.status != 0 or size == 0:
            return Spoken(unheard=f"piper could not speak: {ended.complaint}")
        if unplayable:
            unplayed = "there is neither pacat nor aplay"
        return Spoken(seconds, unplayed and f"piper could not be heard: {unplayed}")


async def _play(sound: AsyncIterator[bytes], player: list[str] | None) -> tuple[int, str | None]:
    """Plays to the end; gives the bytes, and why they could not be played."""
    if player is None:
        return sum([len(chunk) async for chunk in sound]), None
    size = 0
    async with running(player) as sounding:
        async for chunk in sound:
            size += len(chunk)
            # A player that has given up: how long the text is must still be known.
            with contextlib.suppress(ConnectionError):
                sounding.stdin.write(chunk)
                await sounding.stdin.drain()
        sounding.stdin.close()
        ended = await sounding.ended()
    return size, None if ended.status == 0 else ended.complaint


async def _chunks(stream: asyncio.StreamReader) -> AsyncIterator[bytes]:
    """What comes, in whole samples."""
    left = b""
    while data := await stream.read(CHUNK):
        data = left + data
        whole = len(data) // 2 * 2
        left = data[whole:]
        yield data[:whole]


async def _louder(sound: AsyncIterator[bytes], percent: float) -> AsyncIterator[bytes]:
    async for chunk in sound:
        if percent != 100:
            samples = array.array("h", chunk)
            chunk = array.array(
                "h", [max(-32768, min(32767, round(one * percent / 100))) for one in samples]
            ).tobytes()
        yield chunk


def _described(model: Path) -> tuple[str | None, int]:
    """The voice's language (``en``), None if nothing tells, and its samples a second."""
    try:
        described: Any = json.loads(Path(f"{model}.json").read_text("utf-8"))
        rate = described.get("audio", {}).get("sample_rate", USUAL_RATE)
        code = described.get("language", {}).get("code")
        if code is None:
            code = described.get("espeak", {}).get("voice")
    except (OSError, ValueError, AttributeError):
        return None, USUAL_RATE
    language = code.replace("_", "-").split("-")[0].lower() if isinstance(code, str) else None
    return language, rate if isinstance(rate, int) and rate > 0 else USUAL_RATE
