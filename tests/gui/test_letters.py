"""The page's fonts beside what the care lint ``small-text`` takes of them; only Qt reads them."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtGui import QRawFont

from situ.document.care_screen import FULL_ONES, LETTER, LETTERS, NARROW, NARROW_ONES

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
