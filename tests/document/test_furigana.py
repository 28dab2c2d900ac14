"""A word in kanji with its reading behind it is said once."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.document.furigana import say_furigana
from situ.document.texts import read_out


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("錠剤（じょうざい）を一つ", "じょうざいを一つ"),
        ("佐々木(ささき)様", "ささき様"),
        ("甘いもの（あまいもの）を", "あまいものを"),
        ("お水（おみず）、お水（みず）、ご飯（ごはん）", "おみず、おみず、ごはん"),
        ("薬（くすり）と目薬（めぐすり）", "くすりとめぐすり"),
        # Kana between kanji is said once, too, and the word before stays.
        ("飲み薬（のみぐすり）、食べ物（たべもの）", "のみぐすり、たべもの"),
        ("お飲み物（おのみもの）と痛み止め（いたみどめ）", "おのみものといたみどめ"),
        ("朝は薬（くすり）、母の母（はは）", "朝はくすり、母のはは"),
        ("朝の飲み薬（のみぐすり）", "朝ののみぐすり"),
        # A dose is never left out.
        ("2錠（じょう）", "2じょう"),
        # What stands behind is no reading of it.
        ("薬です（くすり）", "薬です（くすり）"),
        ("朝（8:00）、朝（食後）、（くすり）", "朝（8:00）、朝（食後）、（くすり）"),
    ],
)
def test_a_word_is_said_as_what_stands_behind_it(written: str, said: str) -> None:
    assert say_furigana(written) == said


@given(st.text("薬水おのみあ12（）() ", max_size=12))
def test_no_number_is_lost(text: str) -> None:
    said = say_furigana(text)
    assert [one for one in said if one.isdigit()] == [one for one in text if one.isdigit()]


def test_it_goes_before_readings_and_is_japanese_only() -> None:
    words = {"錠剤": "じょうざい"}
    assert read_out("錠剤（じょうざい）と錠剤", words, "ja") == "じょうざいとじょうざい"
    assert read_out("錠剤（じょうざい）", {}, "en") == "錠剤（じょうざい）"
