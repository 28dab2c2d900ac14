"""Values as people read them: never as they travel."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ_studio.wording.value_words import LINES, value_lines, value_words, with_unit

SCALARS = st.none() | st.booleans() | st.integers(-99, 99) | st.text("abc", max_size=3)
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text("xyz"), inner, max_size=3),
    max_leaves=6,
)


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (None, ""),
        (True, "true"),
        (40.0, "40"),
        ("Jack", "Jack"),
        ({"text": "Yes please", "confidence": 0.9}, "text: Yes please, confidence: 0.9"),
        (["a", "b"], "a, b"),
        ([{"name": "Jack", "id": 3}, {"name": "Ann"}], "name: Jack, id: 3; name: Ann"),
        ({"name": "Jo", "initial": {"x": "J", "y": "N"}}, "name: Jo, initial: (x: J, y: N)"),
        ({"names": [], "user": {}, "said": ""}, "names: empty, user: empty, said: empty"),
    ],
)
def test_a_value_is_told_in_one_line_without_the_signs_of_its_notation(
    value: Any, words: str
) -> None:
    assert value_words(value) == words


@given(VALUES)
def test_no_value_is_shown_as_it_travels(value: Any) -> None:
    assert not {"{", "}", "[", "]", '"'} & {*value_words(value), *value_lines(value)}


def test_a_long_value_is_told_line_by_line_up_to_a_number_of_lines() -> None:
    said = value_lines({"heard": {"text": "yes"}, "names": ["Jo", {"name": "Ann"}]})
    assert said.splitlines() == [
        "heard:",
        "    text: yes",
        "names:",
        "    1. Jo",
        "    2.",
        "        name: Ann",
    ]
    long = value_lines([*range(LINES + 5)]).splitlines()
    assert len(long) == LINES + 1
    assert long[-1] == "… and 5 lines more"


@pytest.mark.parametrize(
    ("value", "unit", "words"),
    [
        (2.2134, "m", "2.213 m"),
        (40, "deg", "40°"),
        (97.0, "%", "97 %"),
        (12345678, "", "12345678"),
        (True, "m", "true"),
        ("far", "m", "far"),
    ],
)
def test_a_number_has_its_unit_and_as_many_digits_as_tell_it_apart(
    value: Any, unit: str, words: str
) -> None:
    assert with_unit(value, unit) == words
