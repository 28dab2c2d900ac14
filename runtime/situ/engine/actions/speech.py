"""Speech by espeak-ng; as text where there is none, or where nobody could hear it.

``done`` comes when the text has been heard to its end. Where there is no sound
device it comes when it would have been: espeak-ng renders the text and the
rendering tells how long it is. Where there is no espeak-ng, or it does not know
the language, the length is estimated (``situ.document.spoken``).
"""

from __future__ import annotations

import asyncio
import logging
import re
import struct
from typing import Any

from situ.document.spoken import estimate
from situ.engine.actions import ActionFailed
from situ.engine.clock import Clock, pause
from situ.engine.process import run

NORMAL_WORDS_A_MINUTE = 175
LONGEST = 20_000
"""Characters of one speech; more is cut off with a warning."""

_LANGUAGE = re.compile(r"[A-Za-z]{2,3}(?:[-_][A-Za-z0-9]{1,8}){0,3}")
_CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f]")


class Speaker:
    """Speaks texts.

    program: the path of espeak-ng, or None. audible: whether there is a sound
    device; without one nothing is played, and time passes as if it were.
    """

    def __init__(self, program: str | None, audible: bool, clock: Clock, log: logging.Logger):
        self.program = program
        self.audible = audible
        self._clock = clock
        self._log = log
        self._unknown: set[str] = set()

    async def say(self, text: str, lang: str = "en", volume: Any = None, rate: Any = None) -> None:
        """Returns when the text was heard to its end, or would have been.

        volume and rate are percent of normal (100): 0 to 200, and 25 to 250; anything
        else counts as normal. Raises ActionFailed where ``lang`` is no language tag.
        """
        if not _LANGUAGE.fullmatch(lang):
            raise ActionFailed(f"{lang!r} is no language; write it like en or pt-BR")
        text = _plain(text)
        if len(text) > LONGEST:
            self._log.warning("a speech of %d characters is cut at %d", len(text), LONGEST)
            text = text[:LONGEST]
        if not text:
            return
        speed = _percent(rate, 25, 250)
        argv = [
            *("-v", lang.replace("_", "-").lower(), "-b", "1"),
            *("-a", str(round(_percent(volume, 0, 200)))),
            *("-s", str(round(NORMAL_WORDS_A_MINUTE * speed / 100))),
        ]
        begun = self._clock.time()
        if self.audible and self.program and lang not in self._unknown:
            # Both: what fails to play at once must not count as heard at once.
            _, length = await asyncio.gather(self._play(argv, text), self._length(argv, text, lang))
        else:
            length = await self._length(argv, text, lang)
        if length is None:
            length = estimate(text, speed)
        await pause(self._clock, begun + length - self._clock.time())

    async def _play(self, argv: list[str], text: str) -> None:
        assert self.program is not None
        try:
            ended = await run([self.program, *argv, "--stdin"], text.encode())
        except OSError as error:
            raise ActionFailed(f"espeak-ng can not be started: {error.strerror}") from error
        if ended.status != 0:
            self._log.warning("espeak-ng could not be heard: %s", ended.complaint)

    async def _length(self, argv: list[str], text: str, lang: str) -> float | None:
        """Seconds of the rendered text; None where espeak-ng can not tell."""
        if self.program is None or lang in self._unknown:
            return None
        try:
            ended = await run([self.program, *argv, "--stdin", "--stdout"], text.encode())
        except OSError as error:
            self._log.warning("espeak-ng can not be started (%s): speech is text", error.strerror)
            return None
        length = _wave_length(ended.out) if ended.status == 0 else None
        if length is None:
            self._unknown.add(lang)
            self._log.warning("espeak-ng can not speak %s (%s): it is text", lang, ended.complaint)
        return length


def _plain(text: str) -> str:
    # "[[" would begin phoneme names, which nobody who writes a text means.
    return _CONTROLS.sub(" ", text).replace("[[", "[ [").strip()


def _percent(value: Any, low: float, high: float) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return 100.0
    return float(min(max(value, low), high))


def _wave_length(wave: bytes) -> float | None:
    """Seconds of a WAV that was streamed, whose header therefore knows no length."""
    if len(wave) < 44 or wave[:4] != b"RIFF":
        return None
    bytes_a_second: int = struct.unpack_from("<I", wave, 28)[0]
    return (len(wave) - 44) / bytes_a_second if bytes_a_second else None
