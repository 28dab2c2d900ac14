"""Numbers in a Japanese text are said as they are meant."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.document.japanese_numbers import say_numbers
from situ.document.texts import read_out


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("血糖値は5.6です", "血糖値は5てん6です"),
        ("36.75度、0.5", "36てん7 5度、0てん5"),
        ("(-5．6)", "(マイナス5てん6)"),
        ("気温は-5度、外は−2.5度", "気温はマイナス5度、外はマイナス2てん5度"),
        ("1,234.5円、12,34", "1234てん5円、12,34"),
        ("５，０００円、１２，３４", "5000円、12，34"),
        ("98 %と５％", "98パーセントと5パーセント"),
        ("3-5回、A-1", "3-5回、A-1"),
        ("1.2.3と192.168.0.1", "1.2.3と192.168.0.1"),
        ("5. 6つ", "5. 6つ"),
        ("14:30に", "じゅうよじさんじゅっぷんに"),
        ("１４：３０に", "じゅうよじさんじゅっぷんに"),
        ("07:05から9:00", "しちじごふんからくじ"),
        ("0:10、10:01", "れいじじゅっぷん、じゅうじいっぷん"),
        ("23:47", "にじゅうさんじよんじゅうななふん"),
        ("20:59", "にじゅうじごじゅうきゅうふん"),
        ("24:00、14:30:05、3:7", "24:00、14:30:05、3:7"),
    ],
)
def test_a_number_is_said_as_it_is_meant(written: str, said: str) -> None:
    assert say_numbers(written) == said


@given(st.integers(0, 99_999), st.text("0123456789", min_size=1, max_size=4))
def test_no_digit_of_a_decimal_number_is_lost(whole: int, rest: str) -> None:
    said = say_numbers(f"値は{whole}.{rest}です")
    assert said == f"値は{whole}てん{' '.join(rest)}です"
    # What is said already is said in the same way.
    assert say_numbers(said) == said


@pytest.mark.parametrize("language", ["ja", "ja-JP", "JA_jp"])
def test_numbers_are_said_so_in_japanese_only_and_readings_go_before(language: str) -> None:
    assert read_out("5.6", {}, language) == "5てん6"
    assert read_out("5.6、7.8", {"5.6": "ごーてんろく"}, language) == "ごーてんろく、7てん8"
    assert read_out("5.6 at 14:30", {}, "en") == "5.6 at 14:30"
    assert read_out("5.6", {}, "jam") == "5.6"
