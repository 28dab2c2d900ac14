"""Names, and how the robot says them.

No voice reads a name in kanji for certain, and espeak-ng spells it in English: beside such a name
stands in kana how it is said. A voice of another language is given that in Latin letters.
"""

from __future__ import annotations

import re
import unicodedata

from situ.document.furigana import KANJI
from ward_records.errors import Unfit

LONGEST = 80

_KANJI = re.compile(f"{KANJI}+")
_LETTER = "[\u3041-\u3096\u30a1-\u30fa]"
_KANA = re.compile(f"{_LETTER}(?:{_LETTER}|[\u30fc\u30fb ])*")
_UNICODE_NAME = re.compile(r"(?:HIRAGANA|KATAKANA) LETTER (SMALL )?(\w+)")
_HEPBURN = {"SI": "SHI", "TI": "CHI", "TU": "TSU", "HU": "FU", "ZI": "JI", "DI": "JI", "DU": "ZU"}
_WITH_A_Y = ("SHI", "CHI", "JI")
"""What is written so has a Y of its own, which a small kana after it has not once more."""
_TOGETHER = {
    ("TO", "U"): "TU",
    ("DO", "U"): "DU",
    ("TE", "YU"): "TU",
    ("DE", "YU"): "DU",
    ("FU", "YU"): "FYU",
    ("VU", "YU"): "VYU",
    ("I", "E"): "YE",
    **{(f"{one}U", small): f"{one}W{small}" for one in "KG" for small in "AIEO"},
}
"""What stands before a small kana and that, of names from elsewhere, to both."""


def needs_kana(name: str) -> bool:
    return _KANJI.search(name) is not None


def as_kana(kana: str) -> str:
    """As it is kept: half-width kana and wide blanks as they are usual."""
    return " ".join(unicodedata.normalize("NFKC", kana).split())


def must_be_a_name(name: str, kana: str) -> None:
    """kana: as ``as_kana`` gives it. Raises Unfit, too where the name is in kanji and nothing says
    how it is said."""
    if not 0 < len(name.strip()) <= LONGEST:
        raise Unfit("a name has 1 to 80 letters")
    found = _KANJI.search(name)
    if found is not None and not kana:
        raise Unfit("the robot can not read {0}: type in kana how the name is said", found[0])
    if kana and not (len(kana) <= LONGEST and _KANA.fullmatch(kana)):
        raise Unfit("how the name is said: hiragana or katakana only")


def said(name: str, kana: str, language: str) -> str:
    """What the robot's voice of a language is given for a name; the name itself where that voice
    can say it, or where nothing better is known."""
    if language == "ja":
        return kana or name
    if name.isascii() or not (_KANJI.search(name) or _KANA.search(name)):
        return name
    return latin(kana or name)


def latin(kana: str) -> str:
    """In Latin letters, after Hepburn; what is no kana stays as it is."""
    made: list[str] = []
    for letter in kana:
        found = _UNICODE_NAME.match(unicodedata.name(letter, ""))
        small, sound = found.groups() if found is not None else (None, "")
        before = made[-1] if made else ""
        if letter in "\u30fc\u30fb":
            made += [" "] * (letter == "\u30fb")
        elif not sound:
            made.append(letter)
        elif small and (before, sound) in _TOGETHER:
            made[-1] = _TOGETHER[before, sound]
        elif small and sound == "TU":
            made.append("*")
        elif small and sound[0] == "Y" and before.endswith("I"):
            made[-1] = before[:-1] + (sound[1:] if before in _WITH_A_Y else sound)
        elif small and sound in "AIUEO" and (before[-1:] in ("E", "U") or before in _WITH_A_Y):
            made[-1] = (before[:-1] or "W") + sound
        else:
            made.append(_HEPBURN.get(sound, sound))
    joined = re.sub(r"\*+([A-Z]?)", r"\1\1", "".join(made)).replace("CCH", "TCH")
    return joined.title()
