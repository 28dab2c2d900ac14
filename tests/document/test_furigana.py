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
        # A number that is part of both is said once.
        ("１日（いちにち）三回（さんかい）", "いちにちさんかい"),
        ("1日２回（いちにちにかい）、10錠（じゅうじょう）", "いちにちにかい、じゅうじょう"),
        (
            "2つ（ふたつ）、1か月（いっかげつ）、14日（じゅうよっか）",
            "ふたつ、いっかげつ、じゅうよっか",
        ),
        ("8時30分（さんじゅっぷん）、20日（はつか）", "8時さんじゅっぷん、はつか"),
        ("4日（よっか）と8日（ようか）、朝2錠（あさにじょう）", "よっかとようか、あさにじょう"),
        ("お1人（おひとり）、お2人（ふたり）", "おひとり、おふたり"),
        # A dose is never left out: it may be the counter alone that is read.
        ("2錠（じょう）、朝2錠（じょう）", "2じょう、朝2じょう"),
        ("1日（にち）、2日（にち）、2人（にん）", "1にち、2にち、2にん"),
        ("5号室（ごうしつ）、4週（しゅう）、9組（くみ）", "5ごうしつ、4しゅう、9くみ"),
        ("0.5錠（ごじょう）、-5度（ごど）", "0.5ごじょう、-5ごど"),
        ("60分（ろくじゅっぷん）、0度（れいど）", "60ろくじゅっぷん、0れいど"),
        # What stands behind is no reading of it.
        ("薬です（くすり）", "薬です（くすり）"),
        ("朝（8:00）、朝（食後）、（くすり）", "朝（8:00）、朝（食後）、（くすり）"),
    ],
)
def test_a_word_is_said_as_what_stands_behind_it(written: str, said: str) -> None:
    assert say_furigana(written) == said


@given(st.text("薬水おのみあ12（）() ", max_size=12))
def test_no_number_is_lost_that_the_reading_does_not_say(text: str) -> None:
    said = say_furigana(text)
    assert [one for one in said if one.isdigit()] == [one for one in text if one.isdigit()]


def test_it_goes_before_readings_and_is_japanese_only() -> None:
    words = {"錠剤": "じょうざい"}
    assert read_out("錠剤（じょうざい）と錠剤", words, "ja") == "じょうざいとじょうざい"
    assert read_out("錠剤（じょうざい）", {}, "en") == "錠剤（じょうざい）"
