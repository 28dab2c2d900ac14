"""Which component lies over which."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.document import rbd
from situ_studio.screens import ordering
from situ_studio.screens.ordering import Way


def screen(ids: str) -> rbd.Screen:
    return rbd.Screen(
        components=tuple(rbd.Text(id=id, x=0, y=0, width=10, height=10) for id in ids)
    )


def order(ids: str, chosen: str, way: Way) -> str:
    made = ordering.reordered(screen(ids), chosen, way)
    return "".join(c.id for c in made.components)


@pytest.mark.parametrize(
    ("way", "one", "two"),
    [
        ("front", "acdeb", "acebd"),
        ("forward", "acbde", "acbed"),
        ("backward", "bacde", "badce"),
        ("back", "bacde", "bdace"),
    ],
)
def test_the_order_of_the_document_is_the_order_on_the_screen(way: Way, one: str, two: str) -> None:
    assert order("abcde", "b", way) == one
    assert order("abcde", "bd", way) == two


def test_what_is_in_front_already_goes_nowhere() -> None:
    there = screen("abc")
    assert ordering.reordered(there, "c", "forward") is there
    assert ordering.reordered(there, "bc", "front") is there
    assert ordering.reordered(there, "ab", "backward") is there


@given(st.sets(st.sampled_from("abcdef")), st.sampled_from(["forward", "backward"]))
@settings(max_examples=40, deadline=None)
def test_step_by_step_one_comes_to_the_end_and_the_chosen_keep_their_order(
    chosen: set[str], way: Way
) -> None:
    now = screen("abcdef")
    for _ in range(6):
        now = ordering.reordered(now, chosen, way)
    end: Way = "front" if way == "forward" else "back"
    assert now == ordering.reordered(screen("abcdef"), chosen, end)
