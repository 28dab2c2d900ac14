"""Whether two pictures of a window show the same, as far as a person sees.

Both are made small and compared in blocks of 8 × 8 px of the window. How letters are smoothed,
and a line that stands half a pixel elsewhere, moves a block's mean by a few of 255 steps; a word
that is gone, another theme's colour or a moved panel moves it by more than ``TOLERANCE``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter

HALF = 2
"""A kept picture has one pixel for so many of the window, in both directions."""
BLOCK = 4
"""Px of a block's side in a kept picture."""
TOLERANCE = 14
"""Steps of 255, in the colour that differs most, that a block's mean may differ."""
COLOURS = 256

Palette = Callable[[Counter[int]], list[int]]
"""Chooses at most ``COLOURS``, told how often each is used."""


def made_small(picture: QImage) -> QImage:
    """As it is kept: half as wide and as high."""
    size = picture.size() / HALF
    return picture.scaled(
        size, Qt.AspectRatioMode.IgnoreAspectRatio, Qt.TransformationMode.SmoothTransformation
    ).convertToFormat(QImage.Format.Format_RGB32)


def keep(small: QImage, file: Path, palette: Palette | None = None) -> None:
    """Writes an RGB32 picture with a palette; None: of the colours that most of it has."""
    table = (palette or _palette)(Counter(memoryview(bytes(small.constBits())).cast("I")))
    flags = Qt.ImageConversionFlag.ThresholdDither | Qt.ImageConversionFlag.AvoidDither
    kept = small.convertToFormat(QImage.Format.Format_Indexed8, table, flags)
    # Nothing of how and when it was made.
    for key in kept.textKeys():
        kept.setText(key, "")
    file.parent.mkdir(parents=True, exist_ok=True)
    assert kept.save(str(file), quality=0), f"{file} can not be written"


def _palette(counted: Counter[int]) -> list[int]:
    """Of colours that are alike the most used one, of those the most used ones."""
    alike: dict[int, list[int]] = {}
    for colour, times in counted.most_common():
        near = alike.setdefault(colour & 0xF0F0F0, [colour, 0])
        near[1] += times
    best = sorted(alike.values(), key=lambda one: -one[1])[:COLOURS]
    exact = [colour for colour, _ in counted.most_common(COLOURS // 4)]
    return list(dict.fromkeys([*exact, *(colour for colour, _ in best)]))[:COLOURS]


def _means(small: QImage, size: QSize) -> QImage:
    """Each block's mean colour, as one pixel."""
    return small.scaled(
        size, Qt.AspectRatioMode.IgnoreAspectRatio, Qt.TransformationMode.SmoothTransformation
    ).convertToFormat(QImage.Format.Format_RGB888)


def differences(ours: QImage, kept: QImage) -> list[QRect]:
    """The blocks, in px of the kept picture, in which they differ; all of it where the sizes do."""
    if ours.size() != kept.size():
        return [ours.rect() | kept.rect()]
    size = QSize(ours.width() // BLOCK, ours.height() // BLOCK)
    return list(_apart(_means(ours, size), _means(kept, size)))


def _apart(ours: QImage, kept: QImage) -> Iterator[QRect]:
    width = ours.width()
    for y in range(ours.height()):
        ours_row, kept_row = _row(ours, y), _row(kept, y)
        if ours_row == kept_row:
            continue
        for x in range(width):
            pair = zip(ours_row[x * 3 : x * 3 + 3], kept_row[x * 3 : x * 3 + 3], strict=True)
            if max(abs(a - b) for a, b in pair) > TOLERANCE:
                yield QRect(x * BLOCK, y * BLOCK, BLOCK, BLOCK)


def _row(means: QImage, y: int) -> bytes:
    start = y * means.bytesPerLine()
    return bytes(means.constBits())[start : start + means.width() * 3]


def marked(ours: QImage, apart: list[QRect]) -> QImage:
    """Ours, pale, with every block that differs framed."""
    made = ours.convertToFormat(QImage.Format.Format_RGB32)
    painter = QPainter(made)
    painter.fillRect(made.rect(), QColor(255, 255, 255, 150))
    painter.setPen(QColor("#C2255C"))
    for block in apart:
        painter.drawRect(block.adjusted(0, 0, -1, -1))
    painter.end()
    return made
