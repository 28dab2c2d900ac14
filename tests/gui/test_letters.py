"""The page's fonts beside what the care lint ``small-text`` takes of them; only Qt reads them."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtGui import QFontDatabase, QRawFont

from situ.document.care_screen import FULL_ONES, LETTER, LETTERS, NARROW, NARROW_ONES
from situ_studio.looks.theme import load_fonts

FONTS = Path(__file__).resolve().parents[2] / "resources" / "fonts"
TIGHT = 0.015
"""By how much titles are set closer (screen.css)."""


@pytest.mark.parametrize("weight", ["Regular", "Medium", "SemiBold"])
def test_no_letter_is_narrower_than_the_care_lints_take_it(weight: str) -> None:
    font = QRawFont(str(FONTS / f"Inter-{weight}.otf"), 100)
    assert font.isValid()
    for code in (*range(0x21, 0x7F), *range(0xC0, 0x100)):
        letter = chr(code)
        taken = LETTER if LETTERS.match(letter) else 0
        taken = NARROW if NARROW_ONES.match(letter) else taken
        (advance,) = font.advancesForGlyphIndexes(font.glyphIndexesForString(letter))
        assert advance.x() / 100 - TIGHT >= taken, letter
        assert not FULL_ONES.match(letter)


@pytest.mark.parametrize(
    ("weight", "letters"),
    [
        ("Regular", "はいイイエ薬を飲む。「髙橋さん」〜ｱ①"),
        ("Bold", "はいイイエ薬を飲む。「橋本さん」〜ｱ"),
    ],
)
def test_the_bundled_japanese_has_the_letters_of_texts_and_names(weight: str, letters: str) -> None:
    font = QRawFont(str(FONTS / f"NotoSansCJKjp-{weight}.otf"), 100)
    assert font.isValid()
    assert [one for one in letters if not font.supportsCharacter(ord(one))] == []


def test_the_studio_writes_japanese_with_the_bundled_letters() -> None:
    load_fonts()
    assert "Noto Sans CJK JP" in QFontDatabase.families(QFontDatabase.WritingSystem.Japanese)
