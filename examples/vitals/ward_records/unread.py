"""What the robot's Japanese voice can not read of what a nurse types for it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from html import escape
from pathlib import Path

from situ.document.furigana import KANJI
from situ.document.texts import read, read_out
from ward_records.language import say

_TEXTS = Path(__file__).resolve().parents[1] / "texts" / "ja.po"


def unread(text: str, words: Mapping[str, str]) -> list[str]:
    """The words in kanji for which neither the text itself nor one of the ``words``, as a project
    has them with their readings, tells how they are said."""
    return list(dict.fromkeys(re.findall(f"{KANJI}+", read_out(text, words, "ja"))))


def told(text: str, of: str = "") -> str:
    """That to the nurse, as HTML, with how to mend it; nothing where all can be read. of: what it
    is about, where that is not clear."""
    found = unread(text, _of_the_project())
    if not found:
        return ""
    said = say(
        "The robot can not read {0}: type behind it how it is said, as in 錠剤（じょうざい）."
    )
    return f'<p class="unread">{escape(of + said.format("、".join(found)))}</p>'


@cache
def _of_the_project() -> Mapping[str, str]:
    return read(_TEXTS.read_bytes(), _TEXTS.name)[1]
