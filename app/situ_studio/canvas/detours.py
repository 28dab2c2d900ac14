"""The way of a pipe that no simple one fits: a search on lines around the cards. Pure; no Qt."""

from __future__ import annotations

import heapq
from collections.abc import Sequence

from situ_studio.canvas.space import FAR, PAD, Box, Cards, Pipe, Point, simple


def detour(cards: Cards, pipe: Pipe, xa: float, xb: float) -> tuple[Point, ...]:
    """The shortest way on the lines around the cards; straight through where there is none.

    xa, xb: the verticals beside the exit and the input.
    """
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    for margin in (400.0, 1600.0, FAR):
        left, right = min(x1, x2) - margin, max(x1, x2) + margin
        top, bottom = min(y1, y2) - margin, max(y1, y2) + margin
        every = margin == FAR
        near = list(cards.boxes.items()) if every else cards.near(left, top, right, bottom)
        found = _walk(cards, pipe, near, xa, xb)
        if found is not None:
            return found
    return simple([(x1, y1), (xa, y1), (xa, y2), (x2, y2)])


def _walk(
    cards: Cards, pipe: Pipe, near: Sequence[tuple[str, Box]], xa: float, xb: float
) -> tuple[Point, ...] | None:
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    edge = PAD + 1
    xs = sorted({xa, xb, *(b.left - edge for _, b in near), *(b.right + edge for _, b in near)})
    ys = sorted({y1, y2, *(b.top - edge for _, b in near), *(b.bottom + edge for _, b in near)})
    where_x = {x: i for i, x in enumerate(xs)}
    where_y = {y: i for i, y in enumerate(ys)}
    begin = (where_x[xa], where_y[y1])
    goal = (where_x[xb], where_y[y2])
    if not cards.clear_level(y1, x1, xa, (pipe.source,)):
        return None
    if not cards.clear_level(y2, xb, x2, (pipe.target,)):
        return None
    # State: (column, row, 0 level or 1 upright); a bend costs as much as 40 px.
    best: dict[tuple[int, int, int], float] = {(*begin, 0): 0.0}
    came: dict[tuple[int, int, int], tuple[int, int, int]] = {}
    queue: list[tuple[float, float, tuple[int, int, int]]] = [(0.0, 0.0, (*begin, 0))]
    while queue:
        _, cost, here = heapq.heappop(queue)
        if cost > best.get(here, FAR * 100):
            continue
        column, row, direction = here
        if (column, row) == goal:
            way = [here]
            while way[-1] in came:
                way.append(came[way[-1]])
            points = [(xs[c], ys[r]) for c, r, _ in reversed(way)]
            return simple([(x1, y1), *points, (x2, y2)])
        for dc, dr in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            c, r = column + dc, row + dr
            if not (0 <= c < len(xs) and 0 <= r < len(ys)):
                continue
            if dc:
                if not cards.clear_level(
                    ys[row], min(xs[column], xs[c]), max(xs[column], xs[c]), ()
                ):
                    continue
                step, turned = abs(xs[c] - xs[column]), direction != 0
            else:
                a, b = min(ys[row], ys[r]), max(ys[row], ys[r])
                if not cards.clear_upright(xs[column], a, b):
                    continue
                step, turned = abs(ys[r] - ys[row]), direction != 1
            following = (c, r, 0 if dc else 1)
            price = cost + step + (40.0 if turned else 0.0)
            if price < best.get(following, FAR * 100):
                best[following] = price
                came[following] = here
                rest = abs(xs[c] - xb) + abs(ys[r] - y2)
                heapq.heappush(queue, (price + rest, price, following))
    return None
