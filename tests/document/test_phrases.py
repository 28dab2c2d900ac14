"""Where a text that is shown may go on in the next line."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.document.phrases import Part, parts


def lines(text: str) -> list[str]:
    """The phrases, their atoms parted by |, white space left out."""
    return ["|".join(one) for one in parts(text) if not isinstance(one, str)]


@pytest.mark.parametrize(
    ("text", "phrases"),
    [
        ("Hello  you\nthere", ["Hello", "you", "there"]),
        ("10\u00a0mg now", ["10\u00a0mg", "now"]),
        ("10 \u00a0 mg", ["10", "\u00a0", "mg"]),
        ("well-known and/or e-mail", ["well-", "known", "and/", "or", "e-mail"]),
        ("12-30 -x", ["12-30", "-x"]),
        ("庭でお茶を飲みましょう。", ["庭|で", "お|茶|を", "飲|み|ま|しょ|う。"]),
        ("（はい）「いいえ」", ["（は|い）", "「い|い|え」"]),
        ("检查结果", ["检|查", "结|果"]),
        ("สวัสดีครับ", ["สวัสดี", "ครับ"]),
        ("안녕하세요 여러분", ["안녕하세요", "여러분"]),
        ("", []),
    ],
)  # fmt: skip
def test_lines_end_between_words_and_phrases(text: str, phrases: list[str]) -> None:
    assert lines(text) == phrases


def test_a_sentence_that_has_just_begun_is_not_broken_off() -> None:
    def phrases(text: str) -> list[str]:
        return [one.replace("|", "") for one in lines(text)]

    assert phrases("測ります。息は普段どおりで結構です。") == [
        *("測ります。", "息は普段どおりで", "結構です。"),
    ]
    # What is long enough for a line of its own may stand there, and what would be too long.
    assert phrases("はい。看護師さんは来ます。") == ["はい。", "看護師さんは", "来ます。"]
    assert phrases("はい。息は普段どおりのままで。")[:2] == ["はい。", "息は普段どおりの"]


def whole(found: tuple[Part, ...]) -> str:
    return "".join("".join(one) for one in found)


@given(st.text(st.sampled_from("ab -/\n今はっー。「」（สั1é"), max_size=30) | st.text(max_size=20))
def test_the_parts_are_the_text_and_none_is_empty(text: str) -> None:
    found = parts(text)
    assert whole(found) == text
    assert all(found)
    assert all(all(one) for one in found)
