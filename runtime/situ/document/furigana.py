"""How a Japanese word is said, written behind it: 錠剤（じょうざい）, as people write it where no
small kana can stand above."""

from __future__ import annotations

import re

KANJI = "[\u3005-\u3007\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff\U00020000-\U0003ffff]"
_KANA = "[\u3041-\u3096\u30a1-\u30fa\u30fb\u30fc]"
_EITHER = f"(?:{KANJI}|{_KANA})"
_READ = re.compile(rf"(?<!{_EITHER})(?<!\d)((?:{_EITHER}|\d)*{_EITHER})[（(]({_KANA}+)[)）]")
# Of 0.5, 8:30, 1/2 and -5 the last digits alone are no number.
_NUMBER = r"(?<![\d.．,，:：/／\-\u2212\uff0d])\d{1,2}(?!\d)"
_WORD = re.compile(f"([おご]?)(?:{KANJI}+|{_NUMBER})")
_PIECE = re.compile(rf"{KANJI}+|{_KANA}+|\d+")

_UNITS = (
    "(?!)",
    "いち|いっ|ひと|つい",
    "に(?!ち)|ふた|ふつ",
    "さん|みっ",
    "よん|よっ|よ(?!う)|し(?=がつ)",
    "ご(?![うご])|いつ",
    "ろく|ろっ|むい|むっ",
    "しち|なな|なの",
    "はち|はっ|やっ|よう(?=か)",
    "きゅう|ここの|く(?=がつ|じ|にち)",
)
_TENS = ("", "", "に", "さん", "よん", "ご")
_WHOLE = {10: "|とお", 20: "|はつ|はた"}
"""How numbers begin what is said of them with a counter. Left out is what a counter alone may be
said as, too: にち of 2日, ごう of 5号, くみ of 9組. A dose is said twice rather than not at all."""


def say_furigana(text: str) -> str:
    """Each such word as what stands behind it; kana that is part of both is said once, and so is a
    number below 60: 1日（いちにち）. Where what stands behind has not the kana and the numbers of
    the word in it, it is no reading, and all stays as it is."""
    return _READ.sub(_said, text)


def _said(found: re.Match[str]) -> str:
    """No blank tells where the word begins: it is the longest that is said so."""
    before, reading = found.groups()
    for word in _WORD.finditer(found.string, *found.span(1)):
        start, honour = word.start() - found.start(1), word[1]
        rest = before[start + len(honour) :]
        if _is_said(rest, reading) or _is_said(rest, reading.removeprefix(honour)):
            return before[:start] + (reading if reading.startswith(honour) else honour + reading)
    return found[0]


def _is_said(word: str, reading: str) -> bool:
    """Whether the word's kana and numbers stand in the reading, each kanji between as some more."""
    *others, last = _PIECE.findall(word)
    at, more = 0, 0
    for piece in others:
        if _is_kanji(piece):
            more = 1
            continue
        saying = re.compile(_number(int(piece)) if piece.isdecimal() else re.escape(piece))
        found = saying.search(reading, at + 1) if more else saying.match(reading, at)
        if found is None:
            return False
        at, more = found.end(), 0
    if _is_kanji(last):
        return at < len(reading)
    rest = len(reading) - len(last) - at
    return reading.endswith(last) and (rest > 0 if more else rest == 0)


def _is_kanji(piece: str) -> bool:
    return re.match(KANJI, piece) is not None


def _number(number: int) -> str:
    tens, unit = divmod(number, 10)
    if tens >= len(_TENS):
        return _UNITS[0]
    if tens and not unit:
        said = f"{_TENS[tens]}(?:じゅう|じゅっ|じっ){_WHOLE.get(number, '')}"
    else:
        said = f"{_TENS[tens]}{'じゅう' * bool(tens)}(?:{_UNITS[unit]})"
    return f"(?:{said})(?![んっゃゅょー])"
