"""What a voice is given to say, and what it tells of it."""

from __future__ import annotations

from msgspec import Struct


class Said(Struct, frozen=True):
    """A text to say. lang: a language tag as ``pt-BR``. volume, rate: percent of normal,
    0 to 200 and 25 to 250.
    """

    text: str
    lang: str = "en"
    volume: float = 100.0
    rate: float = 100.0


class Spoken(Struct, frozen=True):
    """How a text was said.

    seconds: what it takes to hear, from its beginning; None: the engine can not tell.
    unheard: why nobody heard it, in words. missing: because the engine is not there.
    """

    seconds: float | None = None
    unheard: str | None = None
    missing: bool = False
