"""Where a text that is shown may go on in the next line.

The robot's page and the editor both take these places, and no others: what is drawn breaks where
the robot breaks it, in every browser.

Words stay whole, but for a hyphen, a dash or a stroke between two letters and two. Japanese,
Chinese and Thai, which are written without spaces, go on after a phrase (BudouX), but not after
the first of a sentence where it is short; where phrases are too long, Japanese and Chinese after
any character that may end a line (JIS X 4051, strict).
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise

import budoux

Part = str | tuple[str, ...]
"""White space, or a phrase: its characters, or what must not be parted of them."""

_SPACE = re.compile(r"([ \t\n\r\f]+)")
"""What CSS takes for white space: the spaces that shall not part stay in their words."""
_WIDE = re.compile(
    "[\u2e80-\u303f\u3041-\u30ff\u3105-\u312f\u31a0-\u31bf\u31f0-\u31ff\u3400-\u4dbf\u4e00-\u9fff"
    "\uf900-\ufaff\uff01-\uff9f\uffe0-\uffe6\U00020000-\U0003ffff]"
)
_KANA = re.compile("[\u3041-\u30ff\uff66-\uff9f]")
_HAN = re.compile("[\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff\U00020000-\U0003ffff]")
_THAI = re.compile("[\u0e00-\u0e7f]")
_JOINING = "-\u2010\u2013\u2014/"
_NOT_FIRST = frozenset(
    "ぁぃぅぇぉっゃゅょゎゕゖァィゥェォッャュョヮヵヶㇰㇱㇲㇳㇴㇵㇶㇷㇸㇹㇺㇻㇼㇽㇾㇿ"
    "ーｰヽヾゝゞ々〻、。，．・：；！？‼⁇⁈⁉）］｝〉》」』】〕〗〙〟｠»）｡､｣％‰℃°′″…‥〜–—"
    ",.:;!?)]}%’”"
)
_STOPS = frozenset("。！？!?")
_BEGUN, _TOGETHER = 4, 10
"""So many characters of a new sentence do not stay behind; with what follows they are so many."""
_NOT_LAST = frozenset("（［｛〈《「『【〔〖〘〝｟｢￥＄￡#$([{£¥€‘“«")


@lru_cache(maxsize=1024)
def parts(text: str) -> tuple[Part, ...]:
    """The text in parts, which together are the text: between two of them a line may end."""
    found: list[Part] = []
    for piece in _SPACE.split(text):
        if _SPACE.fullmatch(piece):
            found.append(piece)
        elif piece:
            found += _phrases(piece)
    return tuple(found)


def _phrases(run: str) -> list[tuple[str, ...]]:
    """The phrases of what has no white space."""
    parser = _parser(run)
    if parser is None:
        return [(one,) for one in _cut(run, _hyphens(run))]
    ends = _ends(parser.parse(run))
    if not _WIDE.search(run):
        return [(one,) for one in _cut(run, ends | _hyphens(run))]
    ends = ends & _between(run)
    phrases = _cut(run, ends - _begun(run, ends) | _hyphens(run))
    return [tuple(_cut(one, _between(one))) for one in phrases]


def _begun(run: str, ends: set[int]) -> set[int]:
    """Where a sentence that has just begun would be broken off: its topic, or a ``then``, at the
    end of the line of the sentence before goes on in its own."""
    found = set()
    for start, end, after in _three([0, *sorted(ends), len(run)]):
        if run[start - 1] in _STOPS and end - start <= _BEGUN and after - start <= _TOGETHER:
            found.add(end)
    return found


def _three(places: list[int]) -> Iterator[tuple[int, int, int]]:
    return zip(places[1:], places[2:], places[3:], strict=False)


def _hyphens(run: str) -> set[int]:
    """Where a line may end after a hyphen, as the number of characters before."""
    if not any(one in run for one in _JOINING):
        return set()
    return {
        at
        for at in range(3, len(run) - 1)
        if run[at - 1] in _JOINING and run[at - 3 : at - 1].isalnum() and run[at : at + 2].isalpha()
    }


def _between(run: str) -> set[int]:
    """Where a line may end beside a Japanese or Chinese character."""
    return {
        at
        for at in range(1, len(run))
        if (_WIDE.match(run[at - 1]) or _WIDE.match(run[at]))
        and run[at] not in _NOT_FIRST
        and run[at - 1] not in _NOT_LAST
        and not unicodedata.category(run[at]).startswith("M")
    }


def _cut(run: str, ends: set[int]) -> list[str]:
    at = [0, *sorted(ends), len(run)]
    return [run[start:end] for start, end in pairwise(at)]


def _ends(phrases: list[str]) -> set[int]:
    found, at = set(), 0
    for phrase in phrases[:-1]:
        at += len(phrase)
        found.add(at)
    return found


def _parser(run: str) -> budoux.Parser | None:
    if _KANA.search(run):
        return _japanese()
    if _HAN.search(run):
        return _chinese()
    return _thai() if _THAI.search(run) else None


@lru_cache(maxsize=1)
def _japanese() -> budoux.Parser:
    return budoux.load_default_japanese_parser()


@lru_cache(maxsize=1)
def _chinese() -> budoux.Parser:
    return budoux.load_default_simplified_chinese_parser()


@lru_cache(maxsize=1)
def _thai() -> budoux.Parser:
    return budoux.load_default_thai_parser()
