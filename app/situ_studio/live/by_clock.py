"""Sentences of the runtime with their moments as the window writes them."""

from __future__ import annotations

import re

from situ_studio.live.viewing import Viewing

MOMENT = re.compile(r"“[^“”]*”|\b(?P<word>since|at|from|to) (?P<t>\d+(?:\.\d+)?) s\b")
"""A moment in a sentence of the runtime's; or what a person wrote, which may read like one."""


def by_clock(text: str, viewing: Viewing) -> str:
    """The runtime's sentence with its moments as all other times here are written: the runtime
    knows seconds of the trace alone. What a person wrote stays.
    """
    if viewing.wall() is None:
        return text

    def written(found: re.Match[str]) -> str:
        if found["t"] is None:
            return found[0]
        return f"{found['word']} {viewing.written(float(found['t']))}"

    return MOMENT.sub(written, text)
