"""Routes: right-angled, from exit to input, never through a card; for any drawing."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ_studio.canvas.routes import Route, Router
from situ_studio.canvas.space import Box, Boxes, Pipe, PipeId, segments
from situ_studio.canvas.ways import STUB

WIDTH, HEIGHT = 176.0, 116.0


def card(x: float, y: float, height: float = HEIGHT) -> Box:
    return Box(x, y, x + WIDTH, y + height)


def pipe(boxes: Mapping[str, Box], source: str, target: str, exit: int = 0, **more: object) -> Pipe:
    a, b = boxes[source], boxes[target]
    return Pipe(
        id=(source, str(exit), target),
        source=source,
        target=target,
        start=(a.right, a.top + 63 + 18 * exit),
        end=(b.left, b.top + 63),
        width=60,
        height=22 if exit == 2 else 18,
        **more,  # type: ignore[arg-type]
    )


def lawful(boxes: Mapping[str, Box], pipes: list[Pipe], routes: Mapping[PipeId, Route]) -> None:
    """What holds for every route of every drawing in which cards stand apart."""
    assert set(routes) == {p.id for p in pipes}
    for one in pipes:
        route = routes[one.id]
        if route.folded:
            assert not route.points
            continue
        points = route.points
        assert points[0] == one.start
        if route.trunk is None:
            end = points[-1]
            loop = one.source == one.target
            assert end == one.end if not loop else end[1] == boxes[one.source].bottom
            assert loop or end[0] - points[-2][0] >= 12, "no room for the arrow"
        else:
            on = routes[route.trunk].points
            assert any(_on(points[-1], a, b) for a, b in pairwise(on))
        for (ax, ay), (bx, by) in pairwise(points):
            assert ax == bx or ay == by
        for (ax, ay), (bx, by), (cx, cy) in zip(points, points[1:], points[2:], strict=False):
            assert (bx - ax) * (cx - bx) + (by - ay) * (cy - by) >= 0, "runs back over itself"
        assert points[1][0] >= points[0][0]
        for horizontal, at, low, high in segments(points):
            for box in boxes.values():
                if horizontal:
                    inside = box.top < at < box.bottom and low < box.right and box.left < high
                else:
                    inside = box.left < at < box.right and low < box.bottom and box.top < high
                assert not inside, (one.id, points, box)
    named = {p.id: _area(p, routes[p.id]) for p in pipes if routes[p.id].label is not None}
    for id, area in named.items():
        assert not any(_meet(area, box) for box in boxes.values()), "a label lies on a card"
        assert not any(_meet(area, other) for i, other in named.items() if i != id)
        assert any(_on(routes[id].label or (0, 0), a, b) for a, b in pairwise(routes[id].points))
        for other in pipes:
            for horizontal, at, low, high in segments(routes[other.id].points):
                line = Box(low, at, high, at) if horizontal else Box(at, low, at, high)
                assert other.id == id or not _meet(area, line), "a pipe runs over a label"


def _area(pipe: Pipe, route: Route) -> Box:
    """Where a pipe's label is painted."""
    assert route.label is not None
    (x, y), half, tall = route.label, route.room / 2, pipe.height / 2
    return Box(x - half, y - tall, x + half, y + tall)


def _meet(a: Box, b: Box) -> bool:
    return a.left < b.right and b.left < a.right and a.top < b.bottom and b.top < a.bottom


def _on(point: tuple[float, float], a: tuple[float, float], b: tuple[float, float]) -> bool:
    (x, y), (ax, ay), (bx, by) = point, a, b
    return min(ax, bx) <= x <= max(ax, bx) and min(ay, by) <= y <= max(ay, by)


@st.composite
def drawings(draw: st.DrawFn) -> tuple[dict[str, Box], list[Pipe]]:
    """Up to 14 cards anywhere, at least 44 apart, as a designer would drag them; any pipes."""
    boxes: dict[str, Box] = {}
    for index in range(draw(st.integers(2, 14))):
        x, y = draw(st.integers(0, 130)) * 8.0, draw(st.integers(0, 110)) * 8.0
        box = card(x, y, HEIGHT + 18 * draw(st.integers(0, 3)))
        apart = all(
            box.left > b.right + 44
            or b.left > box.right + 44
            or box.top > b.bottom + 44
            or b.top > box.bottom + 44
            for b in boxes.values()
        )
        if apart:
            boxes[str(index)] = box
    names = list(boxes)
    pipes = []
    for name in names:
        for exit in range(draw(st.integers(0, 3))):
            target = draw(st.sampled_from(names))
            timeout = draw(st.booleans())
            pipes.append(pipe(boxes, name, target, exit, timeout=timeout))
    return boxes, pipes


@settings(max_examples=120, deadline=None)
@given(drawings())
def test_no_route_crosses_a_card(drawing: tuple[dict[str, Box], list[Pipe]]) -> None:
    boxes, pipes = drawing
    routes = Router().route(boxes, pipes)
    lawful(boxes, pipes, routes)
    # Once more, and not out of memory.
    anew = Router()
    assert all(step is None for step in anew.routing(boxes, pipes))
    assert anew.routes == routes


@settings(max_examples=60, deadline=None)
@given(drawings(), st.data())
def test_a_change_routes_anew_what_it_touches(
    drawing: tuple[dict[str, Box], list[Pipe]], data: st.DataObject
) -> None:
    boxes, pipes = drawing
    router = Router()
    router.route(boxes, pipes)
    name = data.draw(st.sampled_from(sorted(boxes)))
    # Far away from all others, and back between them.
    for x, y in ((3000.0, 200.0), boxes[name][:2]):
        before = dict(router.routes)
        moved = {**boxes, name: card(x, y, boxes[name].bottom - boxes[name].top)}
        new = [pipe(moved, p.source, p.target, int(p.id[1]), timeout=p.timeout) for p in pipes]
        changed = router.change(
            {name: moved[name]}, {p.id: p for p in new if name in (p.source, p.target)}
        )
        lawful(moved, new, router.routes)
        for id, route in router.routes.items():
            assert (route != before[id]) == (id in changed)


def row(count: int) -> dict[str, Box]:
    return {str(i): card(230.0 * i, 52) for i in range(count)}


def test_neighbours_are_joined_by_a_straight_line() -> None:
    boxes = row(2)
    only = pipe(boxes, "0", "1")
    assert Router().route(boxes, [only])[only.id].points == (only.start, only.end)


def test_a_long_way_back_runs_in_the_corridor_with_its_label() -> None:
    boxes = row(5)
    back = pipe(boxes, "4", "0")
    route = Router().route(boxes, [back])[back.id]
    assert len(route.points) == 6
    level = route.points[2][1]
    assert level < 52 or level > 168
    assert route.label is not None
    assert route.label[1] == level


def test_exits_to_one_card_join_at_a_dot() -> None:
    boxes = row(2)
    first, second = pipe(boxes, "0", "1"), pipe(boxes, "0", "1", 1)
    routes = Router().route(boxes, [first, second])
    assert routes[first.id].trunk is None
    assert routes[second.id].trunk == first.id
    joint = routes[second.id].joint
    assert joint is not None
    assert joint[1] == first.start[1]
    assert first.start[0] < joint[0] < first.end[0]


def test_a_loop_enters_the_lower_edge() -> None:
    boxes = row(1)
    loop = pipe(boxes, "0", "0", 2, timeout=True)
    points = Router().route(boxes, [loop])[loop.id].points
    assert points[-1] == (112.0, 168.0)
    assert points[-2][1] > 168


def test_a_loop_shares_no_lane_with_what_comes_from_elsewhere() -> None:
    boxes = {**row(2), "2": card(0, 280)}
    loop = pipe(boxes, "0", "0", 1)
    below = pipe(boxes, "2", "0")
    routes = Router().route(boxes, [loop, below])
    for horizontal, at, low, high in segments(routes[loop.id].points):
        for level, other, begin, end in segments(routes[below.id].points):
            shared = level == horizontal and abs(other - at) < 4
            assert not (shared and begin < high and low < end)


def chip(one: Pipe) -> Box:
    """Where the arrow and the chip of a folded pipe are painted."""
    (x, y) = one.start
    return Box(x + 4, y - 8, x + STUB + one.chip, y + 8)


def test_ways_lead_round_the_chips_of_folded_pipes() -> None:
    boxes = {str(i): card(230.0 * (i % 3), 52 + 228 * (i // 3)) for i in range(6)}
    # Into a card past its neighbour's chip, out between chips, and round the own card.
    folded = [pipe(boxes, "3", "0", 0, timeout=True), pipe(boxes, "1", "0", 1, timeout=True)]
    ways = [pipe(boxes, "0", "4", 0), pipe(boxes, "1", "5", 0), pipe(boxes, "1", "1", 2)]
    joins = [pipe(boxes, "5", "2", 0), pipe(boxes, "5", "2", 2)]
    joins += [pipe(boxes, "4", "5", 0), pipe(boxes, "4", "5", 2)]
    between = [pipe(boxes, "5", "0", 1, folded=True), pipe(boxes, "4", "0", 1, folded=True)]
    every = [*folded, *ways, *joins, *between]
    routes = Router().route(boxes, every)
    chips = [chip(p) for p in every if routes[p.id].folded]
    assert len(chips) == 4
    for one in [*ways, *joins]:
        for horizontal, at, low, high in segments(routes[one.id].points):
            line = Box(low, at, high, at) if horizontal else Box(at, low, at, high)
            assert not any(_meet(line, c) for c in chips), (one.id, routes[one.id].points)


def test_what_comes_late_to_a_card_shares_the_corridor_of_the_others() -> None:
    boxes = {**row(4), "3": card(690, 52, HEIGHT + 18), "below": card(230, 272)}
    loop, deep, up = pipe(boxes, "1", "1", 1), pipe(boxes, "3", "1", 2), pipe(boxes, "below", "1")
    routes = Router().route(boxes, [loop, deep, up])
    levels = [
        {at for horizontal, at, _, _ in segments(routes[p.id].points[1:-1]) if horizontal}
        for p in (deep, up)
    ]
    assert levels[0] == levels[1]


def test_cards_that_stand_close_leave_room_for_the_arrow() -> None:
    boxes = {"0": card(WIDTH + 24, 0), "1": card(0, HEIGHT + 52)}
    pipes = [pipe(boxes, "1", "0")]
    lawful(boxes, pipes, Router().route(boxes, pipes))


def test_a_label_makes_way_for_a_card_that_is_put_beside_its_pipe() -> None:
    boxes = row(5)
    back = pipe(boxes, "4", "0")
    router = Router()
    label = router.route(boxes, [back])[back.id].label
    assert label is not None
    near = card(label[0] - 88, label[1] - 8 - HEIGHT)
    assert router.change({"near": near}, {}) == {back.id}
    lawful({**boxes, "near": near}, [back], router.routes)


def test_twelve_exits_to_twelve_cards_are_lawful() -> None:
    boxes = {"0": card(0, 52, 62 + 12 * 18)}
    boxes |= {str(1 + i): card(230.0 * (1 + i % 4), 52 + 228 * (i // 4)) for i in range(12)}
    pipes = [pipe(boxes, "0", str(1 + i), i) for i in range(12)]
    pipes += [pipe(boxes, str(1 + i), "0") for i in range(12)]
    routes = Router().route(boxes, pipes)
    lawful(boxes, pipes, routes)
    assert sum(routes[p.id].label is not None for p in pipes) >= 8


def test_narrow_gaps_hold_more_lanes() -> None:
    boxes = {"0": card(0, 52), "1": card(WIDTH + 44, 52)}
    boxes |= {str(2 + i): card(230.0 * i, 400) for i in range(4)}
    pipes = [pipe(boxes, "0", str(2 + i), i) for i in range(4)]
    routes = Router().route(boxes, pipes)
    lanes = [routes[p.id].points[1][0] for p in pipes]
    assert len(set(lanes)) == 4


def test_a_way_of_many_bends_leads_round_a_wall() -> None:
    boxes = {"0": card(0, 0), "1": card(800, 0)}
    # A pocket, open on the left, in which the one stands; nothing short leads out of it.
    boxes |= {f"over {i}": card(180 * i, -160) for i in range(2)}
    boxes |= {f"beside {i}": card(360, -160 + 120 * i) for i in range(4)}
    boxes |= {f"under {i}": card(180 * i, 200) for i in range(2)}
    only = pipe(boxes, "0", "1")
    route = Router().route(boxes, [only])[only.id]
    lawful(boxes, [only], {only.id: route})
    assert len(route.points) >= 8


def test_what_no_way_leads_to_is_folded_until_one_does() -> None:
    boxes = {"0": card(0, 0), "1": card(800, 0)}
    wall = {f"wall {i}": card(400, -3000 + 120 * i) for i in range(50)}
    only = pipe(boxes, "0", "1")
    router = Router()
    assert router.route({**boxes, **wall}, [only])[only.id].folded
    gone = {uid: None for uid in wall if uid in ("wall 24", "wall 25", "wall 26")}
    nearer = {**boxes, "1": card(792, 0)}
    moved = pipe(nearer, "0", "1")
    router.change({**gone, "1": nearer["1"]}, {moved.id: moved})
    assert router.routes[moved.id].points


def test_what_is_shut_in_by_its_neighbours_is_folded() -> None:
    boxes = {str(i): card(220.0 * (i % 5), 122 * (i // 5)) for i in range(200)}
    over = pipe(boxes, "101", "103")
    assert Router().route(boxes, [over])[over.id].folded


def test_what_was_routed_lately_is_known_and_changed_as_if_it_had_been_routed() -> None:
    boxes = row(5)
    pipes = [pipe(boxes, "0", "4"), pipe(boxes, "4", "1", 1), pipe(boxes, "2", "3")]
    first, second, third = Router(), Router(), Router()
    routes = dict(first.route(boxes, pipes))
    known = second.route(boxes, pipes)
    assert all(known[id] is route for id, route in routes.items())
    moved = {**boxes, "4": card(3000, 200)}
    new = [pipe(moved, p.source, p.target, int(p.id[1])) for p in pipes]
    touched = {p.id: p for p in new if "4" in (p.source, p.target)}
    for router in (first, second):
        router.change({"4": moved["4"]}, touched)
    assert second.routes == first.routes != routes
    # What one of them changes is changed for it alone.
    assert third.route(boxes, pipes) == routes


def test_a_folded_pipe_of_a_known_drawing_can_be_asked_for() -> None:
    boxes = row(3)
    back = pipe(boxes, "2", "0", 1, timeout=True)
    for router in (Router(), Router()):
        assert router.route(boxes, [back])[back.id].folded
        router.drawn.add(back.id)
        assert router.change({}, {back.id: back}) == {back.id}
        assert router.routes[back.id].points


def test_very_many_pipes_are_routed_one_between_two_yields() -> None:
    boxes = {str(i): card(230.0 * (i % 20), 52 + 228 * (i // 20)) for i in range(320)}
    pipes = [pipe(boxes, str(i), str(i + 1)) for i in range(319)]
    router = Router()
    steps = sum(1 for _ in router.routing(boxes, pipes))
    assert steps > 3 * len(pipes)
    assert router.routes == Router().route(boxes, pipes)


def test_parallel_ways_keep_apart() -> None:
    boxes = {**row(5), "5": card(0, 280), "6": card(460, 280)}
    one, two = pipe(boxes, "4", "5"), pipe(boxes, "3", "6", 1)
    routes = Router().route(boxes, [one, two])
    levels = [
        {at for horizontal, at, low, high in segments(routes[p.id].points) if horizontal}
        for p in (one, two)
    ]
    assert all(abs(a - b) >= 7 for a in levels[0] for b in levels[1] if 168 < a < 280)


def test_timeouts_that_lead_back_are_folded_and_can_be_asked_for() -> None:
    boxes = row(3)
    back = pipe(boxes, "2", "0", 1, timeout=True)
    router = Router()
    assert router.route(boxes, [back])[back.id].folded
    router.drawn.add(back.id)
    assert not router.route(boxes, [back])[back.id].folded


def test_what_would_cross_the_drawing_is_folded() -> None:
    boxes = {str(i): card(230.0 * (i % 5), 52 + 228 * (i // 5)) for i in range(20)}
    way = [pipe(boxes, str(i), str(i + 1)) for i in range(19)]
    across = pipe(boxes, "18", "1", 1)
    routes = Router().route(boxes, [*way, across])
    assert routes[across.id].folded
    assert not any(routes[p.id].folded for p in way)


@pytest.mark.parametrize("gap", [0, 8, 20])
def test_cards_that_touch_still_get_a_route(gap: int) -> None:
    boxes = {"0": card(0, 0), "1": card(WIDTH + gap, 0), "2": card(2 * (WIDTH + gap), 0)}
    pipes = [pipe(boxes, "0", "2"), pipe(boxes, "2", "0"), pipe(boxes, "1", "2")]
    routes = Router().route(boxes, pipes)
    assert all(len(routes[p.id].points) >= 2 or routes[p.id].folded for p in pipes)


@settings(max_examples=60)
@given(st.lists(st.tuples(*[st.integers(-400, 400)] * 4), max_size=12), st.integers(-400, 400))
def test_an_area_is_free_where_nothing_overlaps_it(
    spots: list[tuple[int, int, int, int]], at: int
) -> None:
    boxes: Boxes[int] = Boxes()
    for name, (x, y, wide, high) in enumerate(spots):
        boxes.add(name, Box(x, y, x + abs(wide), y + abs(high)))
    area = (at, -at, at + 90, 60 - at)
    assert boxes.is_free(*area) == (not boxes.near(*area))
