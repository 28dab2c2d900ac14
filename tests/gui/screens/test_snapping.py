"""What a dragged component is drawn to, and the distances that are told of it."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from situ_studio.screens import placing, snapping
from situ_studio.screens.drags import Banding, Held, Moving, Resizing
from situ_studio.screens.placing import Box

FREE = Held(free=True)
STRAIGHT = Held(straight=True)
BOXES = st.builds(
    lambda x, y, width, height: placing.inside(Box(x, y, width, height)),
    st.floats(0, 90),
    st.floats(0, 90),
    st.floats(2, 50),
    st.floats(2, 50),
)


def test_an_edge_near_another_is_put_there_and_told_as_a_guide() -> None:
    box, other = Box(10, 10, 20, 10), Box(42.5, 60, 20, 10)
    snap = snapping.snapped(box, [other], 32.0, 5.0)
    assert box.x + snap.dx == 42.5
    assert 42.5 in snap.upright


def test_far_from_every_guide_it_goes_to_the_grid() -> None:
    snap = snapping.snapped(Box(10.3, 10, 20, 10), [], 6.0, 0.0)
    assert (10.3 + snap.dx) == 16.0
    assert snap.upright == ()


def test_between_two_it_is_drawn_to_even_gaps() -> None:
    left, right = Box(0, 40, 20, 10), Box(75, 40, 25, 10)
    made = Moving({"a": Box(30, 40, 20, 10)}, [left, right]).at(6.7, 0, Held())
    assert made.boxes["a"].x == 37.5
    beside = [g for g in made.gaps if g.across]
    assert [(g.length, g.even) for g in beside] == [(17.5, True), (17.5, True)]


def test_beside_a_row_it_is_drawn_to_the_gap_that_the_row_has() -> None:
    row = [Box(3.3, 40, 10, 10), Box(20.6, 40, 10, 10)]
    made = Moving({"a": Box(50, 40, 10, 10)}, row).at(-12.5, 0, Held())
    assert made.boxes["a"].x == 37.9
    even = [(round(g.start, 2), round(g.length, 2)) for g in made.gaps if g.across and g.even]
    assert even == [(30.6, 7.3), (13.3, 7.3)]


def test_the_margins_of_the_screen_are_gaps_too() -> None:
    # As the answers of a screen stand: 8 % beside each and between them.
    made = Moving({"no": Box(60, 68, 38, 22)}, [Box(8, 68, 38, 22)]).at(-6.2, 0, Held())
    assert made.boxes["no"].x == 54
    across = [(g.start, g.end, g.even) for g in made.gaps if g.across]
    assert across == [(46, 54, True), (92, 100, True), (0, 8, True)]


def test_free_it_goes_where_the_mouse_is_and_nothing_is_told() -> None:
    made = Moving({"a": Box(10, 10, 20, 10)}, [Box(42.5, 60, 20, 10)]).at(32.1, 0.3, FREE)
    assert made.boxes["a"] == Box(42.1, 10.3, 20, 10)
    assert (made.snap.upright, made.gaps) == ((), ())


def test_straight_it_moves_along_the_longer_way_only() -> None:
    made = Moving({"a": Box(10.5, 10.5, 20, 10)}, []).at(15.2, 8.0, STRAIGHT)
    assert made.boxes["a"].y == 10.5
    assert made.boxes["a"].x == 26


def test_a_corner_is_resized_in_proportion_when_straight() -> None:
    made = Resizing({"a": Box(10, 10, 20, 10)}, [], "se").at(20, 0, STRAIGHT)
    assert made.boxes["a"] == Box(10, 10, 40, 20)


def test_a_rubber_band_selects_what_it_touches_beside_what_was_before() -> None:
    boxes = {"a": Box(0, 0, 10, 10), "b": Box(20, 0, 10, 10), "c": Box(60, 60, 10, 10)}
    band = Banding(25, 30, ("c",))
    assert band.at(26, 20, boxes) == ("c",)
    assert band.at(9, 9, boxes) == ("c", "a", "b")
    assert band.box == Box(9, 9, 16, 21)


@given(BOXES, st.lists(BOXES, max_size=5), st.floats(-60, 60), st.floats(-60, 60))
@settings(max_examples=80, deadline=None)
def test_nothing_is_drawn_further_than_near(
    box: Box, others: list[Box], dx: float, dy: float
) -> None:
    snap = snapping.snapped(box, others, dx, dy)
    assert abs(snap.dx - dx) <= snapping.NEAR + 1e-9
    assert abs(snap.dy - dy) <= snapping.NEAR + 1e-9


@given(BOXES, st.lists(BOXES, max_size=5))
@settings(max_examples=80, deadline=None)
def test_a_told_gap_is_free_on_the_screen_and_even_ones_come_in_pairs(
    box: Box, others: list[Box]
) -> None:
    told = snapping.gaps(box, others)
    for gap in told:
        assert 0 <= gap.start < gap.end <= 100
        alike = [g for g in told if g.across == gap.across and abs(g.length - gap.length) <= 0.05]
        assert gap.even == (len(alike) > 1)
