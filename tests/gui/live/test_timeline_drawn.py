"""What a timeline draws of its lanes: all that happened, and never more than the px can show."""

from __future__ import annotations

import math
from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st

from situ_studio.live.lanes import NAN, Lane, Series
from situ_studio.live.timeline.axis import LEAST, MOST, TimeAxis
from situ_studio.live.timeline.drawn import Extremes, blocks

gaps = st.lists(st.sampled_from([0.0, 0.01, 0.1, 1.0, 5.0]), min_size=1, max_size=60)


def lane_of(gaps: list[float]) -> Lane:
    lane, t = Lane(), 0.0
    for number, gap in enumerate(gaps):
        t += gap
        lane.add(t, f"{number}")
    return lane


@settings(max_examples=60, deadline=None)
@given(gaps, st.sampled_from([0.05, 0.5, 3.0]), st.floats(0, 20))
def test_blocks_stand_seamlessly_and_count_every_value_once(
    gaps: list[float], least: float, start: float
) -> None:
    lane = lane_of(gaps)
    end = start + 40
    found = blocks(lane, start, end, least)
    seen = [t for t in lane.t if t < end]
    begun = max(0, sum(t <= start for t in lane.t) - 1)
    assert sum(block.many for block in found) == max(0, len(seen) - begun)
    assert all(a.end == b.start for a, b in pairwise(found))
    assert len(found) <= 2 * (40 / least) + 3
    if seen:
        assert found[-1].end == end
    for block in found:
        if block.many == 1:
            assert block.value == lane.at(block.start) or block.start == block.end


def test_a_value_long_enough_keeps_its_own_block_among_many_short() -> None:
    lane = lane_of([0.0, 0.001, 0.001, 0.001, 10.0, 0.001, 0.001])
    found = blocks(lane, 0.0, 20.0, 0.1)
    assert [(block.value, block.many) for block in found] == [
        (None, 3),
        ("3", 1),
        (None, 2),
        ("6", 1),
    ]


values = st.lists(st.one_of(st.integers(-9, 9).map(float), st.just(NAN)), min_size=1, max_size=400)


@settings(max_examples=60, deadline=None)
@given(values, st.sampled_from([0.5, 7.0, 150.0]), st.integers(0, 300))
def test_no_peak_is_lost_however_many_numbers_share_a_px(
    numbers: list[float], pixel: float, forgotten: int
) -> None:
    series = Series()
    for number, y in enumerate(numbers):
        series.add(float(number), y)
    extremes = Extremes(series)
    extremes.strokes(0.0, 1e9, pixel)
    series.forget(float(forgotten))
    made = extremes.strokes(0.0, 1e9, pixel)
    left = [y for y in series.y if not math.isnan(y)]
    assert made.range == ((min(left), max(left)) if left else None)
    for n, t in enumerate(made.t):
        inside = [y for s, y in zip(series.t, series.y, strict=True) if t <= s < t + pixel]
        known = [y for y in inside if not math.isnan(y)]
        assert not known or (made.low[n], made.high[n]) == (min(known), max(known))
        assert str((made.first[n], made.last[n])) == str((inside[0], inside[-1]))


@settings(max_examples=60, deadline=None)
@given(st.floats(-100, 1000), st.floats(0.001, 1000), st.floats(0, 800))
def test_zooming_keeps_the_moment_under_the_hand(start: float, factor: float, x: float) -> None:
    axis = TimeAxis()
    axis.start, axis.width = start, 800.0
    about = axis.t(x)
    axis.zoom(factor, about)
    assert abs(axis.x(about) - x) < 1e-3
    assert LEAST <= axis.seen <= MOST


def test_marks_are_whole_times_apart_enough_to_be_read() -> None:
    axis = TimeAxis()
    axis.width, axis.start, axis.seen = 600.0, 3.2, 30.0
    marks = list(axis.marks(80, origin=0.25))
    assert marks == [5.25, 10.25, 15.25, 20.25, 25.25, 30.25]


def test_the_end_that_is_followed_stands_on_whole_px_and_does_not_tremble() -> None:
    axis = TimeAxis()
    axis.width, axis.seen = 300.0, 30.0
    ends = []
    # A robot's end is reckoned: now and then a little less than a moment ago.
    for t in (40.0, 40.04, 40.21, 40.12, 40.3, 41.0):
        axis.end_at(t)
        ends.append(axis.end)
    assert ends == sorted(ends)
    assert all(abs(end / axis.pixel - round(end / axis.pixel)) < 1e-6 for end in ends)
    assert 41.0 <= ends[-1] < 41.2
    axis.end_at(5.0)
    assert axis.end == 5.0
    # Seen closely, a quarter of what is seen is far.
    axis.seen = 0.5
    axis.end_at(10.0)
    axis.end_at(9.8)
    assert abs(axis.end - 9.8) <= axis.pixel


def test_a_run_that_is_shorter_than_what_is_seen_begins_at_the_left_edge() -> None:
    axis = TimeAxis()
    axis.width, axis.seen = 300.0, 30.0
    for t in (5.0, 6.0, 34.9):
        axis.end_at(t, first=5.0)
        assert axis.start == 5.0
    axis.end_at(40.0, first=5.0)
    assert (axis.start, axis.end) == (10.0, 40.0)
