"""Routes: right-angled, from exit to input, never through a card; for any drawing."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ_studio.canvas.routes import Pipe, Route, Router
from situ_studio.canvas.space import Box, PipeId, segments

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
        else:
            on = routes[route.trunk].points
            assert any(_on(points[-1], a, b) for a, b in pairwise(on))
        for (ax, ay), (bx, by) in pairwise(points):
            assert ax == bx or ay == by
        assert points[1][0] >= points[0][0]
        for horizontal, at, low, high in segments(points):
            for box in boxes.values():
                if horizontal:
                    inside = box.top < at < box.bottom and low < box.right and box.left < high
                else:
                    inside = box.left < at < box.right and low < box.bottom and box.top < high
                assert not inside, (one.id, points, box)
        if route.label is not None:
            x, y = route.label
            half = route.room / 2
            for box in boxes.values():
                assert not (
                    x - half < box.right
                    and box.left < x + half
                    and y - 9 < box.bottom
                    and box.top < y + 9
                )


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
    assert Router().route(boxes, pipes) == routes


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
