"""Where components lie: the laws of moving, resizing and aligning."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.document import rbd
from situ_studio.screens import placing
from situ_studio.screens.devices import USUAL
from situ_studio.screens.fitness import APART
from situ_studio.screens.placing import Box

WAYS = st.floats(-150, 150)
BOXES = st.builds(
    lambda x, y, width, height: placing.inside(Box(x, y, width, height)),
    st.floats(0, 100),
    st.floats(0, 100),
    st.floats(2, 100),
    st.floats(2, 100),
)
EDGES = ("left", "center", "right", "top", "middle", "bottom", "across", "down")
STEPS = st.lists(
    st.one_of(
        st.tuples(st.just("move"), WAYS, WAYS),
        st.tuples(st.sampled_from(placing.HANDLES), WAYS, WAYS),
        st.tuples(st.sampled_from(EDGES), st.just(0.0), st.just(0.0)),
    ),
    max_size=8,
)


def on_screen(box: Box) -> bool:
    return box.x >= 0 and box.y >= 0 and box.right <= 100.0001 and box.bottom <= 100.0001


@given(st.lists(BOXES, min_size=1, max_size=5), STEPS, st.booleans())
@settings(max_examples=80, deadline=None)
def test_whatever_is_done_components_stay_on_the_screen(
    boxes: list[Box], steps: list[tuple[str, float, float]], keep: bool
) -> None:
    now = {f"c{i}": box for i, box in enumerate(boxes)}
    for what, dx, dy in steps:
        if what == "move":
            now = placing.moved(now, dx, dy)
        elif what in EDGES:
            now = placing.aligned(now, what)
        else:
            now = placing.resized(now, what, dx, dy, keep)
        assert all(on_screen(box) and box.width > 0 and box.height > 0 for box in now.values())


def _apart(a: Box, b: Box) -> bool:
    across = a.x >= b.right - 0.03 or b.x >= a.right - 0.03
    return across or a.y >= b.bottom - 0.03 or b.y >= a.bottom - 0.03


@given(st.lists(BOXES, max_size=5), BOXES, st.booleans())
@settings(max_examples=80, deadline=None)
def test_what_is_new_lies_on_nothing_or_where_it_would_be_anyway(
    others: list[Box], box: Box, beside: bool
) -> None:
    new = placing.in_free_room(box, others, beside)
    assert on_screen(new)
    small = [one for one in others if one.width * one.height < placing.MOST]
    assert new == placing.inside(box) or all(_apart(new, one) for one in small)


def test_free_room_is_below_what_is_there_and_a_picture_of_the_ground_takes_none() -> None:
    ground, there = Box(0, 0, 100, 100), Box(10, 10, 80, 20)
    assert placing.in_free_room(there, [ground]) == there
    assert placing.in_free_room(there, [ground, there]) == Box(10, 32.5, 80, 20)
    low = Box(35, 75, 30, 15)
    assert placing.in_free_room(low, [low]) == Box(35, 57.5, 30, 15)
    # Answers stand beside each other, the second at the right.
    second = placing.in_free_room(low, [low], beside=True)
    assert second == Box(67.5, 75, 30, 15)
    assert placing.in_free_room(low, [low, second], beside=True) == Box(2.5, 75, 30, 15)
    # A finger that means one of two buttons hits that one.
    assert USUAL.millimetres(0, placing.GAP)[1] >= APART
    full = [Box(0, y, 100, 24) for y in (0, 25, 50, 75)]
    assert placing.in_free_room(there, full) == there


@given(BOXES, st.floats(0.2, 5))
@settings(max_examples=60, deadline=None)
def test_a_shape_is_the_largest_within_a_box_about_its_middle(box: Box, proportion: float) -> None:
    new = placing.shaped(box, proportion)
    assert new.width == pytest.approx(new.height * proportion, abs=0.03 * max(1, proportion))
    assert new.width <= box.width + 0.01
    assert new.height <= box.height + 0.01
    full = (new.width / box.width, new.height / box.height)
    assert max(full) == pytest.approx(1, abs=0.01)
    assert new.x + new.width / 2 == pytest.approx(box.x + box.width / 2, abs=0.02)
    assert new.y + new.height / 2 == pytest.approx(box.y + box.height / 2, abs=0.02)


@given(st.lists(BOXES, min_size=2, max_size=5), WAYS, WAYS)
@settings(max_examples=60, deadline=None)
def test_what_is_moved_together_keeps_its_distances(boxes: list[Box], dx: float, dy: float) -> None:
    before = {f"c{i}": box for i, box in enumerate(boxes)}
    after = placing.moved(before, dx, dy)
    shifts = {(after[id].x - before[id].x, after[id].y - before[id].y) for id in before}
    assert max(x for x, _ in shifts) - min(x for x, _ in shifts) <= 0.0101
    assert max(y for _, y in shifts) - min(y for _, y in shifts) <= 0.0101


@given(
    st.lists(BOXES, min_size=1, max_size=4),
    st.sampled_from(placing.HANDLES),
    WAYS,
    WAYS,
    st.booleans(),
)
@settings(max_examples=100, deadline=None)
def test_a_handle_leaves_the_opposite_edges_where_they_are(
    boxes: list[Box], handle: str, dx: float, dy: float, keep: bool
) -> None:
    every = {f"c{i}": box for i, box in enumerate(boxes)}
    before = placing.around(boxes)
    after = placing.around(placing.resized(every, handle, dx, dy, keep).values())
    if "e" in handle or (not keep and "w" not in handle):
        assert after.x == pytest.approx(before.x, abs=0.021)
    if "w" in handle or (not keep and "e" not in handle):
        assert after.right == pytest.approx(before.right, abs=0.021)
    if "s" in handle or (not keep and "n" not in handle):
        assert after.y == pytest.approx(before.y, abs=0.021)
    if "n" in handle or (not keep and "s" not in handle):
        assert after.bottom == pytest.approx(before.bottom, abs=0.021)


@given(BOXES, st.sampled_from(placing.HANDLES), WAYS, WAYS)
@settings(max_examples=80, deadline=None)
def test_in_proportion_a_component_stays_as_wide_as_it_is_high(
    box: Box, handle: str, dx: float, dy: float
) -> None:
    after = placing.resized({"a": box}, handle, dx, dy, keep=True)["a"]
    assert after.width * box.height == pytest.approx(after.height * box.width, abs=1.1)


def test_several_are_resized_together_and_so_are_the_distances_between_them() -> None:
    both = {"a": Box(10, 10, 20, 10), "b": Box(40, 30, 10, 10)}
    made = placing.resized(both, "se", 40, 30)
    assert made == {"a": Box(10, 10, 40, 20), "b": Box(70, 50, 20, 20)}


def test_of_several_the_smallest_stays_large_enough_to_be_seen() -> None:
    both = {"a": Box(10, 10, 40, 10), "b": Box(60, 10, 4, 10)}
    made = placing.resized(both, "e", -100, 0)
    assert made["b"].width == placing.LEAST
    assert made["a"].width == 20


def test_a_single_one_is_aligned_with_the_screen_several_among_themselves() -> None:
    one, two = Box(10, 10, 20, 10), Box(60, 40, 30, 20)
    assert placing.aligned({"a": one}, "center")["a"].x == 40
    made = placing.aligned({"a": one, "b": two}, "right")
    assert made["a"].right == made["b"].right == 90


def test_three_are_spread_with_the_same_gap() -> None:
    boxes = {"a": Box(0, 0, 10, 5), "b": Box(15, 0, 10, 5), "c": Box(70, 0, 10, 5)}
    made = placing.aligned(boxes, "across")
    assert made["b"].x == 35


def test_a_screen_on_which_nothing_moves_is_the_very_same() -> None:
    screen = rbd.Screen(components=(rbd.Text(id="a", x=1, y=2, width=30, height=4, text="Hello"),))
    assert placing.placed(screen, {"a": Box(1, 2, 30, 4)}) is screen
    assert placing.placed(screen, {"a": Box(5, 2, 30, 4)}).components[0].x == 5
