"""Texts as the robot's page sets them: their size, their lines, and where the letters stand.

The steps are those of resources/screen/fit.js (docs/screen.md): change both. Letters are measured
at ``REFERENCE`` px, without hinting, so that all sizes are in proportion, as on the page.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator
from functools import lru_cache
from typing import Literal, NamedTuple

from PySide6.QtGui import QFont, QGlyphRun, QTextLayout

from situ.document import phrases
from situ_studio.looks.theme import FAMILIES
from situ_studio.screens.measures import measures

REFERENCE = 200
"""px; Qt takes whole px only between letters, and these are some."""
_WIDE = 1e7
"""px: wider than any line."""

GRAIN = 1 / 128
"""px: the browser rounds each word up to 64ths; half of one on the average."""

Parted = Literal["phrases", "script", "anywhere", "row"]
"""How far phrases are parted: not, between Japanese and Chinese characters, those also between any
two letters that are wider than a line, or, in a row of a list, phrases that are.
"""


class Style(NamedTuple):
    """How letters look. spacing, line: between letters, and of a line, in em."""

    weight: int
    line: float
    spacing: float = 0.0
    tabular: bool = False


class Fitted(NamedTuple):
    """A text in its box. size: px. cut: it fits at no size, and its beginning is shown."""

    size: float
    parted: Parted = "phrases"
    cut: bool = False


class Line(NamedTuple):
    """What stands in one line; width and base, from the top of ``glyphs``, in em."""

    text: str
    width: float
    base: float
    glyphs: tuple[QGlyphRun, ...]


class Span(NamedTuple):
    """From one place to another of a paragraph, and the width between them in em."""

    start: int
    end: int
    width: float


# -- sizes -----------------------------------------------------------------------------


@lru_cache(maxsize=8192)
def fit(
    text: str, style: Style, width: float, height: float, wanted: float, wide: float, high: float
) -> Fitted:
    """The largest size up to ``wanted`` px at which a text lies in a box of these px.

    wide, high: the box's padding on each side, in em.
    """
    smallest = measures()["smallest"]
    paragraphs = _paragraphs(text, style)

    def fits(size: float, parted: Parted) -> bool:
        across, down = width - 2 * wide * size, height - 2 * high * size
        lines = 0
        widest = 0.0
        for one in paragraphs:
            spans = _wrapped(one, across, size, parted)
            lines += len(spans)
            widest = max(widest, max(span.width for span in spans))
        needed = max(widest * size, 0.0)
        return round(needed) <= across + 1 and lines * style.line * size <= down + 1

    def largest(parted: Parted) -> float:
        if fits(wanted, parted):
            return wanted
        low, most = smallest, wanted
        while most - low > 0.5:
            middle = (low + most) / 2
            if fits(middle, parted):
                low = middle
            else:
                most = middle
        return low if fits(low, parted) else 0.0

    size = largest("phrases")
    if size >= wanted * measures()["whole"]:
        return Fitted(size)
    if (size := largest("script")) > 0:
        return Fitted(size, "script")
    size = largest("anywhere")
    # The page tries the smallest size last, and leaves it where that does not fit either.
    return Fitted(size or smallest, "anywhere", size == 0)


def balanced(text: str, style: Style, fitted: Fitted, width: float) -> float:
    """The px that its lines are as wide as, so that they are even: there is not one more of them.

    width: px that they have at most.
    """
    paragraphs = _paragraphs(text, style)

    def measured(across: float) -> tuple[int, float]:
        spans = [
            span for one in paragraphs for span in _wrapped(one, across, fitted.size, fitted.parted)
        ]
        return len(spans), max(span.width for span in spans) * fitted.size

    count, widest = measured(width)
    if fitted.cut or count < 2:
        return width
    low, least = 0, math.ceil(min(width, _natural(paragraphs) * fitted.size))
    most = least
    while least - low > 1:
        middle = (low + least) // 2
        lines, widest = measured(middle)
        if lines > count or round(widest) > middle:
            low = middle
        else:
            least = middle
    return least + 1.0 if least < most else width


@lru_cache(maxsize=8192)
def set_lines(
    text: str, style: Style, fitted: Fitted, width: float, even: bool = True
) -> tuple[Line, ...]:
    """The lines of a text; no wider than ``width`` px, where phrases allow, and as ``even``."""
    across = balanced(text, style, fitted, width) if even else width
    return tuple(
        _line(one.text16(span.start, span.end), style)
        for one in _paragraphs(text, style)
        for span in _wrapped(one, across, fitted.size, fitted.parted)
    )


def base(style: Style, size: float) -> int:
    """px from the top of a line to what letters of ``size`` px stand on, as Chromium rounds it."""
    above, below = (one * size for one in extent(style))
    up, down = math.floor(above + 0.5), math.floor(below + 0.5)
    if down < below:
        up, down = up - 1, down + 1
    return math.floor((style.line * size - up - down) / 2) + up


@lru_cache(maxsize=64)
def extent(style: Style) -> tuple[float, float]:
    """How far letters reach above what they stand on, and below, in em."""
    layout = _laid("x", style)  # whose line it is
    line = layout.lineAt(0)
    return line.ascent() / REFERENCE, line.descent() / REFERENCE


# -- lines -----------------------------------------------------------------------------


class _Paragraph:
    """What stands between two line breaks of a text; all widths in em.

    words: where each begins and ends, as UTF-16, of phrases and of what they may be parted into.
    """

    def __init__(self, parts: list[phrases.Part], style: Style) -> None:
        self.words: dict[Parted, list[tuple[int, int]]] = {"phrases": [], "script": []}
        text, at = "", 0
        for part in parts:
            if isinstance(part, str):
                if text:
                    text, at = text + " ", at + 1
                continue
            began = at
            for one in part:
                long = len(one.encode("utf-16-le")) // 2
                self.words["script"].append((at, at + long))
                text, at = text + one, at + long
            self.words["phrases"].append((began, at))
        text = text.rstrip(" ")
        self.words |= {"anywhere": self.words["script"], "row": self.words["phrases"]}
        self._encoded = text.encode("utf-16-le")
        self._layout = _laid(text, style)
        line = self._layout.lineAt(0)
        places = {place for words in self.words.values() for one in words for place in one}
        self._x = {place: _x(line.cursorToX(place)) / REFERENCE for place in places}

    def text16(self, start: int, end: int) -> str:
        return self._encoded[2 * start : 2 * end].decode("utf-16-le")

    def width(self, start: int, end: int) -> float:
        return abs(self._x[end] - self._x[start])

    def pieces(self, start: int, end: int, across: float) -> Iterator[Span]:
        """A word that is wider than a line, as much of it in each as goes in."""
        layout = self._layout
        line = layout.lineAt(0)
        places = [start]
        while places[-1] < end:
            places.append(layout.nextCursorPosition(places[-1]))
        x = [abs(_x(line.cursorToX(one)) / REFERENCE - self._x[start]) for one in places]
        began = 0
        while began < len(places) - 1:
            ended = max(bisect_right(x, x[began] + across + 1e-6) - 1, began + 1)
            self._x[places[ended]] = _x(line.cursorToX(places[ended])) / REFERENCE
            yield Span(places[began], places[ended], x[ended] - x[began])
            began = ended


def _wrapped(one: _Paragraph, across: float, size: float, parted: Parted) -> list[Span]:
    """The lines of a paragraph that is ``across`` px wide: as many words in each as go in."""
    words = one.words[parted]
    if not words:
        return [Span(0, 0, 0.0)]
    found: list[Span] = []
    start, end = words[0][0], words[0][0]
    width = 0.0
    room, grain = across / size, GRAIN / size
    limit = room
    for began, ended in words:
        wide = one.width(start, ended)
        limit -= grain
        if wide > limit and end > start:
            found.append(Span(start, end, width))
            start, wide, limit = began, one.width(began, ended), room - grain
        if wide > limit and parted in ("anywhere", "row"):
            *before, last = one.pieces(start, ended, room)
            found += before
            start, wide = last.start, last.width
        end, width = ended, wide
    found.append(Span(start, end, width))
    return found


def _natural(paragraphs: tuple[_Paragraph, ...]) -> float:
    """The width of a text with the line breaks only that it has itself."""
    return max(
        one.width(words[0][0], words[-1][1]) if (words := one.words["phrases"]) else 0.0
        for one in paragraphs
    )


@lru_cache(maxsize=2048)
def _paragraphs(text: str, style: Style) -> tuple[_Paragraph, ...]:
    found: list[list[phrases.Part]] = [[]]
    for part in phrases.parts(text):
        if isinstance(part, str) and "\n" in part:
            found += [[] for _ in range(part.count("\n"))]
        else:
            found[-1].append(part)
    if len(found) > 1 and not found[-1]:
        found.pop()  # what ends a text begins no line
    return tuple(_Paragraph(one, style) for one in found)


@lru_cache(maxsize=4096)
def _line(text: str, style: Style) -> Line:
    layout = _laid(text, style)
    line = layout.lineAt(0)
    width, base = line.naturalTextWidth() / REFERENCE, line.ascent() / REFERENCE
    return Line(text, width, base, tuple(layout.glyphRuns()))


def _laid(text: str, style: Style) -> QTextLayout:
    """A text in one line."""
    layout = QTextLayout(text, _font(style))
    layout.beginLayout()
    layout.createLine().setLineWidth(_WIDE)
    layout.endLayout()
    return layout


@lru_cache(maxsize=64)
def _font(style: Style) -> QFont:
    font = QFont()
    font.setFamilies(FAMILIES)
    font.setPixelSize(REFERENCE)
    font.setWeight(QFont.Weight(style.weight))
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    font.setFeature(QFont.Tag("ss03"), 1)
    if style.tabular:
        font.setFeature(QFont.Tag("tnum"), 1)
    if style.spacing:
        spacing = style.spacing * REFERENCE
        font.setLetterSpacing(QFont.SpacingType.AbsoluteSpacing, spacing)
    return font


def _x(found: object) -> float:
    # PySide gives the place of the cursor too, and does not say so.
    assert isinstance(found, tuple)
    return float(found[0])
