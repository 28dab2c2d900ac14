"""Speech: said by the robot's voice (``situ.engine.voices``), as text where nobody hears it.

``done`` comes when the text has been heard to its end. Where there is no sound device, or
the voice can not speak the language, it comes when it would have been: the voice's own
rendering tells how long the text is, else its words do (``situ.document.spoken``). Where
something could be heard and the engine is missing, the text stands on the screen as long,
and then the action fails.
"""

from __future__ import annotations

import asyncio
import logging
import re
from collections.abc import Callable
from typing import Any

from situ.document.spoken import estimate
from situ.engine.actions import ActionFailed
from situ.engine.clock import Clock, pause
from situ.engine.voices import Voice
from situ.engine.voices.text import Said

LONGEST = 20_000
"""Characters of one speech; more is cut off with a warning."""

_LANGUAGE = re.compile(r"[A-Za-z]{2,3}(?:[-_][A-Za-z0-9]{1,8}){0,3}")
_CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f]")


class Speaker:
    """Speaks texts, one at a time: a new one begins when the one cut off is silent.

    audible: whether there is a sound device; without one nothing is played, and time passes
    as if it were. unheard: is called whenever a text that should have been was not heard.
    """

    def __init__(
        self,
        voice: Voice,
        audible: bool,
        clock: Clock,
        log: logging.Logger,
        unheard: Callable[[], None],
    ) -> None:
        self.voice = voice
        self.audible = audible
        self._clock = clock
        self._log = log
        self._unheard = unheard
        self._turn = asyncio.Lock()
        self._told: set[str] = set()
        if voice.missing is not None:
            self._text_instead(voice.missing)

    async def say(self, text: str, lang: str = "en", volume: Any = None, rate: Any = None) -> None:
        """Returns when the text was heard to its end, or would have been.

        volume and rate are percent of normal (100): 0 to 200, and 25 to 250; anything
        else counts as normal. Raises ActionFailed where ``lang`` is no language tag, and, when
        the text could have been read, where the engine is missing and there is a sound device.
        """
        if not _LANGUAGE.fullmatch(lang):
            raise ActionFailed(f"{lang!r} is no language; write it like en or pt-BR")
        text = _CONTROLS.sub(" ", text).strip()
        if len(text) > LONGEST:
            self._log.warning("a speech of %d characters is cut at %d", len(text), LONGEST)
            text = text[:LONGEST]
        said = Said(text, lang.replace("_", "-"), _percent(volume, 0, 200), _percent(rate, 25, 250))
        async with self._turn:
            if text:
                await self._say(said)

    async def _say(self, said: Said) -> None:
        begun = self._clock.time()
        spoken = await self.voice.speak(said, self.audible)
        if spoken.unheard is not None:
            self._text_instead(spoken.unheard)
        seconds = spoken.seconds
        if seconds is None:
            seconds = estimate(said.text, said.rate)
        await pause(self._clock, begun + seconds - self._clock.time())
        if spoken.missing and self.audible:
            raise ActionFailed(f"{spoken.unheard}: the text was only shown")

    def _text_instead(self, why: str) -> None:
        self._unheard()
        if why not in self._told:
            self._told.add(why)
            self._log.warning("%s: speech is text", why)


def _percent(value: Any, low: float, high: float) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return 100.0
    return float(min(max(value, low), high))
