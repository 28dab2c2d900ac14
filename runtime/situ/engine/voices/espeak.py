"""espeak-ng: what speaks unless another engine is chosen."""

from __future__ import annotations

import asyncio
import struct

from situ.engine.process import Ended, run
from situ.engine.voices.text import Said, Spoken

NORMAL_WORDS_A_MINUTE = 175


class EspeakNg:
    """Speaks by espeak-ng, the text by standard input.

    The same program renders the text, which tells how long it takes to hear. program: its
    path; None where the machine has none.
    """

    def __init__(self, program: str | None) -> None:
        self.program = program
        self._unknown: set[str] = set()

    @property
    def missing(self) -> str | None:
        return None if self.program else "espeak-ng is not installed"

    async def speak(self, said: Said, audible: bool) -> Spoken:
        if self.program is None:
            return Spoken(unheard=self.missing, missing=True)
        if said.lang in self._unknown:
            return Spoken(unheard=f"espeak-ng can not speak {said.lang}")
        argv = [
            *(self.program, "-v", said.lang.lower(), "-b", "1"),
            *("-a", str(round(said.volume))),
            *("-s", str(round(NORMAL_WORDS_A_MINUTE * said.rate / 100)), "--stdin"),
        ]
        text = _plain(said.text).encode()
        try:
            if not audible:
                return self._told(said.lang, await run([*argv, "--stdout"], text))
            # Both: what fails to play at once must not count as heard at once.
            played, rendered = await asyncio.gather(run(argv, text), run([*argv, "--stdout"], text))
        except OSError as error:
            why = f"espeak-ng can not be started: {error.strerror}"
            return Spoken(unheard=why, missing=True)
        told = self._told(said.lang, rendered)
        if played.status != 0 and told.unheard is None:
            return Spoken(told.seconds, f"espeak-ng could not be heard: {played.complaint}")
        return told

    def _told(self, lang: str, rendered: Ended) -> Spoken:
        """What the rendered text tells."""
        seconds = _wave_length(rendered.out) if rendered.status == 0 else None
        if seconds is None:
            self._unknown.add(lang)
            why = f"espeak-ng can not speak {lang}: {rendered.complaint}"
            return Spoken(unheard=why)
        return Spoken(seconds)


def _plain(text: str) -> str:
    # "[[" would begin phoneme names, which nobody who writes a text means.
    return text.replace("[[", "[ [")


def _wave_length(wave: bytes) -> float | None:
    """Seconds of a WAV that was streamed, whose header therefore knows no length."""
    if len(wave) < 44 or wave[:4] != b"RIFF":
        return None
    bytes_a_second: int = struct.unpack_from("<I", wave, 28)[0]
    return (len(wave) - 44) / bytes_a_second if bytes_a_second else None
