"""speech-dispatcher: whatever voice the machine's own settings choose."""

from __future__ import annotations

import asyncio
import contextlib

from situ.engine.process import run
from situ.engine.voices.text import Said, Spoken

HUSH = 2.0
"""Seconds that speech-dispatcher gets to take in that it is to be silent."""


class SpeechDispatcher:
    """Speaks by ``spd-say --wait``, which ends when the text has been heard.

    Its text is an argument: what it reads from standard input may hold commands, and ends
    with each line. What it was given goes on when ``spd-say`` is gone, so that a cancelled
    speech is also taken back by ``spd-say --cancel``. program: the path of spd-say; None
    where the machine has none.
    """

    def __init__(self, program: str | None) -> None:
        self.program = program

    @property
    def missing(self) -> str | None:
        return None if self.program else "speech-dispatcher (spd-say) is not installed"

    async def speak(self, said: Said, audible: bool) -> Spoken:
        if self.program is None:
            return Spoken(unheard=self.missing, missing=True)
        if not audible:
            return Spoken()
        argv = [self.program, "--wait", "--priority", "message", "--language", said.lang]
        if said.rate != 100:
            argv += ["--rate", str(_rate(said.rate))]
        if said.volume != 100:
            argv += ["--volume", str(_volume(said.volume))]
        try:
            ended = await run([*argv, "--", said.text])
        except OSError as error:
            why = f"spd-say can not be started: {error.strerror}"
            return Spoken(unheard=why, missing=True)
        except asyncio.CancelledError:
            await self._hush()
            raise
        if ended.status != 0:
            return Spoken(unheard=f"speech-dispatcher could not be heard: {ended.complaint}")
        return Spoken(0.0)

    async def _hush(self) -> None:
        assert self.program is not None
        with contextlib.suppress(OSError, TimeoutError):
            async with asyncio.timeout(HUSH):
                await run([self.program, "--cancel"])


def _rate(percent: float) -> int:
    """On spd-say's scale of -100 (about half as fast as 0) to 100 (about 2.3 times as fast)."""
    steps = (percent - 100) * (2 if percent < 100 else 0.8)
    return round(max(-100.0, min(steps, 100.0)))


def _volume(percent: float) -> int:
    """On spd-say's scale of -100 (silent) to 100, which is as loud as it gets."""
    return round(min(2 * percent - 100, 100))
