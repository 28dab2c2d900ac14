"""The texts of a project in other languages: ``texts/LANG.po`` (formats.md, *A project*), and
phrases compared as they are heard (*Speech heard*).
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from typing import Any

import polib

from situ.document.furigana import say_furigana
from situ.document.japanese_numbers import say_numbers
from situ.document.problem import Problem

MAX_BYTES = 16_000_000
READING = "reading"
"""The context (``msgctxt``) of entries that say how a word is said, and translate nothing."""

_LINE = re.compile(r"line (\d+)")


def read(data: bytes, file: str) -> tuple[dict[str, str], dict[str, str], list[Problem]]:
    """Texts as written to their translations; words, as they are written in the file's language,
    to how its voice shall say them (the context ``reading``). Empty, unsure and retired ones are
    left out.
    """
    entries, problems = parse(data, file)
    said: dict[str, str] = {}
    words: dict[str, str] = {}
    for entry in entries:
        if _is_used(entry):
            (words if entry.msgctxt == READING else said)[entry.msgid] = entry.msgstr
    return said, words, problems


def _is_used(entry: Any) -> bool:
    return bool(entry.msgid) and bool(entry.msgstr) and not entry.obsolete and not entry.fuzzy


def read_out(text: str, words: Mapping[str, str], language: str) -> str:
    """A text as a voice of the language shall say it: each of the words, the longest first, as its
    reading says; Japanese numbers as ``japanese_numbers`` does, and before all a word that has its
    reading behind it as ``furigana`` does.

    Whole words only, in scripts that have blanks between words; a letter counts as it is written,
    great or small.
    """
    japanese = re.split("[-_]", language.lower())[0] == "ja"
    if japanese:
        text = say_furigana(text)
    if words:
        longest = sorted(words, key=lambda word: (-len(word), word))
        pattern = re.compile("|".join(map(_whole, longest)))
        text = pattern.sub(lambda found: words[found[0]], text)
    return say_numbers(text) if japanese else text


def _whole(word: str) -> str:
    before = r"(?<![^\W_])" if _has_blanks(word[0]) else ""
    after = r"(?![^\W_])" if _has_blanks(word[-1]) else ""
    return f"{before}{re.escape(word)}{after}"


def _has_blanks(letter: str) -> bool:
    """Whether the letter's script puts blanks between words."""
    wide = unicodedata.east_asian_width(letter) in ("W", "F")
    return letter.isalnum() and not wide and not "\u0e00" <= letter <= "\u0eff"


def parse(data: bytes, file: str) -> tuple[Any, list[Problem]]:
    """The file as polib has it, one that writes each text on one line; an empty one, and why,
    where it is none.
    """

    def bad(message: str, line: int = 1) -> tuple[Any, list[Problem]]:
        said = Problem(file=file, line=line, column=1, code="malformed-po", message=message)
        return polib.POFile(wrapwidth=0), [said]

    if len(data) > MAX_BYTES:
        return bad(f"The file is larger than {MAX_BYTES // 1_000_000} MB")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as wrong:
        line = data[: wrong.start].count(b"\n") + 1
        return bad("The file is not UTF-8 here: save it as UTF-8", line)
    if "\n" not in text:
        # polib takes a text of one line for the name of a file.
        text += "\n#\n"
    try:
        return polib.pofile(_Lines(text.replace("\r\n", "\n").replace("\r", "\n")), wrapwidth=0), []
    except (OSError, ValueError, AttributeError, IndexError, UnicodeError) as wrong:
        match = _LINE.search(str(wrong))
        return bad(
            'This line is none of a .po file: write msgid "…" and msgstr "…"',
            int(match[1]) if match else 1,
        )


class _Lines(str):
    """A text whose lines end with a line feed only.

    Others that Unicode knows (U+2028, U+0085) stand inside of texts; polib would cut there.
    """

    def splitlines(self, keepends: bool = False) -> list[str]:
        return self.split("\n")


def heard_as(phrase: str) -> str:
    """A phrase without case, punctuation and doubled white space, to be compared."""
    kept = (c for c in phrase.casefold() if unicodedata.category(c)[0] != "P")
    return " ".join("".join(kept).split())
