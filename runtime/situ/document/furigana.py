"""How a Japanese word is said, written behind it: 錠剤（じょうざい）, as people write it where no
small kana can stand above."""

from __future__ import annotations

import re

KANJI = "[\u3005-\u3007\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff\U00020000-\U0003ffff]"
_KANA = "[\u3041-\u3096\u30a1-\u30fa\u30fb\u30fc]"
_EITHER = f"(?:{KANJI}|{_KANA})"
_READ = re.compile(f"(?<!{_EITHER})({_EITHER}+)[（(]({_KANA}+)[)）]")
_WORD = re.compile(f"([おご]?){KANJI}+")


def say_furigana(text: str) -> str:
    """Each such word as what stands behind it; kana that is part of both is said once. Where what
    stands behind has not the kana of the word in it, it is no reading, and all stays as it is."""
    return _READ.sub(_said, text)


def _said(found: re.Match[str]) -> str:
    """No blank tells where the word begins: it is the longest that is said so."""
    before, reading = found.groups()
    for word in _WORD.finditer(before):
        if _is_said(before[word.end(1) :], reading):
            rest, honour = before[: word.start()], word[1]
            return rest + (reading if reading.startswith(honour) else honour + reading)
    return found[0]


def _is_said(word: str, reading: str) -> bool:
    """Whether the word's kana stands in the reading, each kanji between it as some more."""
    *between, end = re.split(f"{KANJI}+", word)[1:]
    at = 0
    for kana in between:
        found = reading.find(kana, at + 1)
        if found < 0:
            return False
        at = found + len(kana)
    return reading.endswith(end) and at < len(reading) - len(end)
