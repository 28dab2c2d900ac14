"""The way of a pipe that no simple one fits: a search on lines around the cards. Pure; no Qt.

It goes from line to line, each as long as nothing stands on it, and so looks at a few dozen
where a search from crossing to crossing looks at thousands.
"""

from __future__ import annotations

import heapq
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from situ_studio.canvas.space import FAR, PAD, Box, Cards, Pipe, Point, simple

BEND = 40.0
"""A bend costs as much as so many px."""


class _Turn(NamedTuple):
    """Where a way turns onto a line, and the turn before."""

    rest: float
    cost: float
    at: Point
    upright: bool
    before: _Turn | None


def through(pipe: Pipe, xa: float, xb: float) -> tuple[Point, ...]:
    """The way that minds no card: xa, xb are the verticals beside the exit and the input."""
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    return simple([(x1, y1), (xa, y1), (xa, y2), (x2, y2)])


def detour(
    cards: Cards, pipe: Pipe, xa: float, xb: float, bound: float = FAR
) -> tuple[Point, ...] | None:
    """A short way with few bends on the lines around the cards, no longer than ``bound``.

    xa, xb: the verticals beside the exit and the input. None where there is none.
    """
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    if not cards.clear_level(y1, x1, xa, (pipe.source,)):
        return None
    if not cards.clear_level(y2, xb, x2, (pipe.target,)):
        return None
    spare = (bound - abs(xa - xb) - abs(y1 - y2)) / 2
    if spare < 0:
        return None
    for margin in (400.0, 1600.0, FAR):
        reach = min(margin, spare)
        area = cards.extent() if reach == FAR else _round(pipe).grown(reach)
        found = _walk(cards, (xa, y1), (xb, y2), area, bound)
        if found is not None:
            return simple([(x1, y1), *found, (x2, y2)])
        if reach == spare:
            break
    return None


def _round(pipe: Pipe) -> Box:
    """What lies between a pipe's ends."""
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    return Box(min(x1, x2), min(y1, y2), max(x1, x2), max(y1, y2))


def _walk(
    cards: Cards, begin: Point, goal: Point, area: Box, bound: float
) -> Sequence[Point] | None:
    near = [box for _, box in cards.near(*area)]
    edge = PAD + 1
    goal_x, goal_y = goal
    xs = {begin[0], goal_x, *(b.left - edge for b in near), *(b.right + edge for b in near)}
    ys = {begin[1], goal_y, *(b.top - edge for b in near), *(b.bottom + edge for b in near)}
    # The lines that a way on a level one, on an upright one may turn onto.
    across = sorted(xs), sorted(ys)
    best: dict[tuple[Point, bool], float] = {}
    known: set[tuple[float, float, bool]] = set()
    queue = [
        _Turn(0.0, 0.0, begin, False, None),
        _Turn(0.0, BEND, begin, True, None),
    ]
    while queue:
        turn = heapq.heappop(queue)
        _, cost, (x, y), upright, _ = turn
        if (x, y) == goal:
            return [one.at for one in _back(turn)][::-1]
        line, here = (x, y) if upright else (y, x)
        low, high = cards.stretch(upright, line, here)
        key = (line, low, upright)
        if key in known:
            continue
        known.add(key)
        lines = across[upright]
        for other in lines[bisect_left(lines, low) : bisect_right(lines, high)]:
            at = (x, other) if upright else (other, y)
            price = cost + abs(other - here) + BEND
            if at == goal and not upright:
                if x > goal_x:
                    # It would come to the card's arrow from behind.
                    continue
                price -= BEND
            elif other == here:
                continue
            rest = price + abs(at[0] - goal_x) + abs(at[1] - goal_y)
            if rest > bound or price >= best.get((at, not upright), FAR * 100):
                continue
            best[at, not upright] = price
            heapq.heappush(queue, _Turn(rest, price, at, not upright, turn))
    return None


def _back(turn: _Turn) -> Iterator[_Turn]:
    yield turn
    while turn.before is not None:
        turn = turn.before
        yield turn
