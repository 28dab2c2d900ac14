"""How long a text takes to say, where no voice can tell.

One home for these figures: the engine waits by them where it has no voice, and ``check``
judges speeches by them.
"""

from __future__ import annotations

import re

WORD = 0.35
"""Seconds of a word at normal rate: 175 words a minute, as espeak-ng speaks."""

UNPARTED = 0.2
"""Seconds of a character of scripts that do not part words (Chinese, Japanese, Thai …)."""

PAUSE = 0.3
"""Seconds before a voice is heard."""

_UNPARTED = re.compile("[\u0e00-\u0eff\u1000-\u109f\u1780-\u17ff\u3040-\u30ff\u3400-\u9fff]")


def estimate(text: str, rate: float = 100) -> float:
    """Seconds that a text takes to say at ``rate`` percent of normal.

    Never less for a text into which more was put.
    """
    unparted = len(_UNPARTED.findall(text))
    words = len(_UNPARTED.sub(" ", text).split())
    return PAUSE + (words * WORD + unparted * UNPARTED) * 100 / rate
