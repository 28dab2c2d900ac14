"""How a Japanese word is said, written behind it: 錠剤（じょうざい）, as people write it where no
small kana can stand above."""

from __future__ import annotations

import re

KANJI = "[\u3005-\u3007\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff\U00020000-\U0003ffff]"
_KANA = "[\u3041-\u3096\u30a1-\u30fa\u30fb\u30fc]"
_READ = re.compile(f"([おご]?)({KANJI}+)({_KANA}*)[（(]({_KANA}+)[)）]")


def say_furigana(text: str) -> str:
    """Each such word as what stands behind it; kana that is part of both is said once. Where what
    stands behind ends otherwise than the word, it is no reading, and all stays as it is."""
    return _READ.sub(_said, text)


def _said(found: re.Match[str]) -> str:
    before, _, after, reading = found.groups()
    if not reading.endswith(after):
        return found[0]
    return reading if reading.startswith(before) else before + reading
