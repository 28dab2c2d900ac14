"""The way of one pipe, round the cards and beside the pipes that are drawn already. Pure; no Qt.

A way leaves an exit to the right and enters a card from the left. Tried are,
cheapest first: a straight line, one vertical between the two (three segments),
and one corridor above, below or between rows (five segments); a search on the
lines around the cards (``detours.py``) finds the rest. Segments already drawn make
their lane dearer, but what leads to the same card may share it.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise

from situ_studio.canvas.detours import detour, through
from situ_studio.canvas.space import (
    FAR,
    PAD,
    Box,
    Boxes,
    Cards,
    Line,
    Lines,
    Pipe,
    PipeId,
    Point,
    holes,
    length,
    segments,
    simple,
)

OUT = 14.0
"""From an exit to its first vertical lane."""
IN = 12.0
"""From the last vertical lane to the card: the arrow and what is left of the corner."""
LANE = 8.0
NARROW = 5.0
"""Between lanes where a gap has no room for six of ``LANE``."""
CORRIDOR = 12.0
JOG = 12.0
"""A shorter step between two lanes looks like a mistake."""
LOOP = 18.0
"""How far below its card a self-loop runs."""
STUB = 15.0
"""The line and arrow of a folded pipe, before its chip."""
SHARED = 60.0
"""What sharing lanes makes a way cheaper by, and 0.3 of how far it leads across."""
CLEAR = 20.0
"""A short way that costs no more than this for others is taken, where there are very many."""
TRIES = 6
"""Corridors that are drawn before the best is taken; half of them where there are very many."""
REACH = 700.0
"""How far above and below a pipe's ends corridors are looked for."""


class Ways:
    """Cards, and the pipes drawn between them so far.

    careful: crossings count; too dear for very many pipes.
    """

    def __init__(self, boxes: Mapping[str, Box], careful: bool = True) -> None:
        self.careful = careful
        self.space = Cards(boxes)
        self.level, self.upright = Lines(), Lines()
        self.chips: Boxes[PipeId] = Boxes()
        self.joining: dict[PipeId, tuple[float, float]] = {}
        """How far up and down the exits lie whose pipes join this one beside its card."""

    # -- what stands and runs there ------------------------------------------------

    def draw(self, pipe: Pipe, points: Sequence[Point]) -> None:
        for horizontal, at, low, high in segments(points):
            lines = self.level if horizontal else self.upright
            lines.add(Line(at, low, high, pipe.goal, pipe.id))

    def rub_out(self, pipe: Pipe, points: Sequence[Point]) -> None:
        for horizontal, at, low, high in segments(points):
            lines = self.level if horizontal else self.upright
            lines.remove(Line(at, low, high, pipe.goal, pipe.id))

    def put_chip(self, pipe: Pipe) -> None:
        """A folded pipe takes the room of its chip."""
        self.chips.add(pipe.id, _chip(pipe))

    def drop_chip(self, pipe: Pipe) -> None:
        self.chips.remove(pipe.id, _chip(pipe))

    def free(self, points: Sequence[Point], own: str) -> bool:
        """Whether a way that begins at ``own`` keeps clear of all cards."""
        for horizontal, at, low, high in segments(points):
            if horizontal:
                if not self.space.clear_level(at, low, high, (own,)):
                    return False
            elif any(name != own for name, _ in self.space.near(at - PAD, low, at + PAD, high)):
                return False
        return True

    def through(self, box: Box) -> set[PipeId]:
        """The pipes that run where a card is now, or too near it."""
        found = {
            line.pipe
            for line in self.level.between(box.top - PAD, box.bottom + PAD, box.left, box.right)
        }
        found |= {
            line.pipe
            for line in self.upright.between(box.left - PAD, box.right + PAD, box.top, box.bottom)
        }
        return found

    # -- ways ------------------------------------------------------------------------

    def find(self, pipe: Pipe) -> tuple[Point, ...]:
        """The cheapest way. Always one: straight through only where every other is blocked."""
        return self.find_within(pipe, FAR) or self.straight(pipe)

    def straight(self, pipe: Pipe) -> tuple[Point, ...]:
        """The way that minds no card."""
        return through(pipe, *_beside(pipe))

    def is_shut(self, pipe: Pipe) -> bool:
        """Whether a card stands right before its exit or its input."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        xa, xb = _beside(pipe)
        clear = self.space.clear_level
        return not (clear(y1, x1, xa, (pipe.source,)) and clear(y2, xb, x2, (pipe.target,)))

    def find_within(self, pipe: Pipe, bound: float) -> tuple[Point, ...] | None:
        """The cheapest way; None where only ways longer than ``bound`` lead round the cards."""
        if pipe.source == pipe.target:
            return self._loop(pipe)
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        ends = (pipe.source, pipe.target)
        if abs(y1 - y2) < 0.5 and x2 - x1 >= IN and self.space.clear_level(y1, x1, x2, ends):
            return (x1, y1), (x2, y2)
        best = self._best(pipe, self._short(pipe))
        if best is None or self.careful or best[0] > _least(pipe, 2) + CLEAR:
            best = self._long(pipe, best)
        return best[1] if best is not None else detour(self.space, pipe, *_beside(pipe), bound)

    def _best(
        self,
        pipe: Pipe,
        ways: Iterable[tuple[Point, ...]],
        best: tuple[float, tuple[Point, ...]] | None = None,
    ) -> tuple[float, tuple[Point, ...]] | None:
        """The cheapest with its cost, ``best`` where none is cheaper."""
        enough = 0.0 if self.careful else _least(pipe, 2) + 1.0
        for points in ways:
            points = simple(points)
            cost = self.cost(pipe, points)
            if (best is None or cost < best[0]) and not _cramped(pipe, points):
                best = cost, points
                if cost < enough:
                    break
        return best

    def _loop(self, pipe: Pipe) -> tuple[Point, ...]:
        """Down beside its card and into the lower edge; further off where others are."""
        (x, y), box = pipe.start, self.space.boxes[pipe.source]
        middle = box.left + 112
        usual = self._round(x, y, OUT, LOOP, box, middle)
        best = (self.cost(pipe, usual), usual) if self.free(usual, pipe.source) else None
        if best is not None and best[0] - length(usual) < 14.0 * len(usual):
            return usual
        ways = (
            self._round(x, y, OUT + across * LANE, LOOP + down * CORRIDOR, box, middle)
            for across in range(6)
            for down in range(3)
        )
        best = self._best(pipe, (w for w in ways if self.free(w, pipe.source)), best)
        return best[1] if best is not None else usual

    @staticmethod
    def _round(
        x: float, y: float, out: float, down: float, box: Box, middle: float
    ) -> tuple[Point, ...]:
        below = box.bottom + down
        return (x, y), (x + out, y), (x + out, below), (middle, below), (middle, box.bottom)

    def _short(self, pipe: Pipe) -> Iterable[tuple[Point, ...]]:
        """One vertical between source and target."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        if x2 - x1 < OUT + IN:
            return
        for low, high in self._gaps(x1 + OUT, x2 - IN, y1, y2):
            step = _step(high - low)
            lanes = {low + k * step for k in range(6)} | {high - k * step for k in range(3)}
            for x in sorted(v for v in lanes if low <= v <= high):
                if self.space.clear_level(y1, x1, x, (pipe.source,)) and self.space.clear_level(
                    y2, x, x2, (pipe.target,)
                ):
                    yield (x1, y1), (x, y1), (x, y2), (x2, y2)

    def _gaps(self, low: float, high: float, y1: float, y2: float) -> list[tuple[float, float]]:
        """Intervals of x in low..high in which a vertical from y1 to y2 is free."""
        top, bottom = min(y1, y2), max(y1, y2)
        near = self.space.near(low - PAD, top - PAD, high + PAD, bottom + PAD)
        return holes(low, high, [(b.left - PAD, b.right + PAD) for _, b in near])

    def _long(
        self, pipe: Pipe, best: tuple[float, tuple[Point, ...]] | None
    ) -> tuple[float, tuple[Point, ...]] | None:
        """One corridor: right, up or down, along, up or down, right. ``best`` or a cheaper one."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        tried = 0
        ahead = _least(pipe, 4) - abs(y2 - y1)
        if self.careful:
            # Sharing lanes makes a way cheaper, by no more than this.
            ahead -= SHARED + 0.3 * abs(x2 - x1)
        for estimate, travel, y in self._corridors(pipe):
            if tried >= (TRIES if self.careful else TRIES // 2):
                break
            if best is not None and estimate > best[0]:
                break
            if best is not None and travel + ahead > best[0]:
                continue
            one = self._lane(pipe, x1, y1, y, +1, pipe.source)
            if one is None:
                continue
            two = self._lane(pipe, x2, y2, y, -1, pipe.target)
            if two is None or not self.space.clear_level(y, min(one, two), max(one, two), ()):
                continue
            tried += 1
            way = (x1, y1), (one, y1), (one, y), (two, y), (two, y2), (x2, y2)
            best = self._best(pipe, [way], best)
        return best

    def _corridors(self, pipe: Pipe) -> Iterable[tuple[float, float, float]]:
        """(estimate, way up and down, y) of the lanes worth a look, the best first.

        How crowded one is is looked at when those nearer by are found to be dearer.
        """
        y1, y2 = pipe.start[1], pipe.end[1]
        xa, xb = _beside(pipe)
        left, right = min(xa, xb), max(xa, xb)
        low, high = min(y1, y2) - REACH, max(y1, y2) + REACH
        near = self.space.near(left - PAD, low, right + PAD, high)
        margin = PAD + 5
        free = holes(low, high, [(b.top - margin, b.bottom + margin) for _, b in near])
        waiting = sorted(
            (abs(y - y1) + abs(y - y2), y)
            for gap_low, gap_high in free
            for y in _rungs(gap_low, gap_high, y1, y2)
        )
        found = [
            (travel + self._crowd(y, left, right, pipe), travel, y)
            for travel, y in self._shared(pipe, free, left, right)
        ]
        heapq.heapify(found)
        for travel, y in waiting:
            while found and found[0][0] <= travel - SHARED / 2:
                yield heapq.heappop(found)
            heapq.heappush(found, (travel + self._crowd(y, left, right, pipe), travel, y))
        while found:
            yield heapq.heappop(found)

    def _shared(
        self, pipe: Pipe, free: Sequence[tuple[float, float]], left: float, right: float
    ) -> list[tuple[float, float]]:
        """The corridors in which others run to the same card already."""
        y1, y2 = pipe.start[1], pipe.end[1]
        low, high = (free[0][0], free[-1][1]) if free else (0.0, 0.0)
        found = {
            line.at
            for line in self.level.to(pipe.goal)
            if line.pipe != pipe.id
            and low <= line.at <= high
            and line.low < right
            and left < line.high
        }
        return [(abs(y - y1) + abs(y - y2), y) for y in found if any(a <= y <= b for a, b in free)]

    def _crowd(self, y: float, left: float, right: float, pipe: Pipe) -> float:
        """What a horizontal lane costs for those that are drawn there already."""
        cost = 0.0
        for at, low, high, target, other in self.level.between(
            y - 23.9, y + 23.9, left - LANE, right + LANE
        ):
            if other == pipe.id:
                continue
            if target == pipe.goal:
                if at == y:
                    cost -= min(60.0, min(high, right) - max(low, left)) * 0.5
                continue
            apart = abs(at - y)
            cost += 260.0 if apart < 7 else 60.0 if apart < 15 else 14.0
        return cost

    def _lane(self, pipe: Pipe, x: float, y: float, to: float, side: int, own: str) -> float | None:
        """A vertical lane beside a port, free from y to the corridor; None where there is none."""
        begin = x + (OUT if side > 0 else -IN)
        limit = begin + side * 420
        low, high = min(begin, limit), max(begin, limit)
        best: tuple[float, float] | None = None
        top, bottom = min(y, to), max(y, to)
        for gap_low, gap_high in self._gaps(low, high, y, to):
            near = gap_low if side > 0 else gap_high
            if best is not None and abs(near - begin) > best[0]:
                continue
            step = _step(gap_high - gap_low)
            for k in range(6):
                lane = near + side * k * step
                if not gap_low <= lane <= gap_high:
                    break
                if best is not None and abs(lane - begin) >= best[0]:
                    break
                if not self.space.clear_level(y, min(x, lane), max(x, lane), (own,)):
                    break
                cost = abs(lane - begin) + self._press(lane, top, bottom, pipe)
                cost += self._chip_cost(pipe, lane, top, bottom, side > 0)
                if best is None or cost < best[0]:
                    best = cost, lane
        return best[1] if best is not None else None

    def beside(self, pipe: Pipe, height: float, end: float) -> float:
        """The lane from an exit to a straight way at ``height``; beyond the chips between."""
        x, y = pipe.start
        lane, last = x + OUT, end - IN
        top, bottom = min(y, height), max(y, height)
        chips = [box.right for _, box in self.chips.near(lane - 3, top, lane + 3, bottom)]
        return min(max(lane, *(right + 6 for right in chips)) if chips else lane, last)

    def _press(self, x: float, top: float, bottom: float, pipe: Pipe) -> float:
        """What a vertical lane costs for those that are drawn there already."""
        cost = 0.0
        for at, _, _, target, other in self.upright.between(x - 7.9, x + 7.9, top - 4, bottom + 4):
            if other == pipe.id or (target == pipe.goal and at == x):
                continue
            cost += 140.0 if abs(at - x) < 4 else 20.0
        if self.careful:
            for at, low, high, target, other in self.level.between(top, bottom, x - 0.5, x + 0.5):
                if (
                    other != pipe.id
                    and target != pipe.goal
                    and low < x < high
                    and top < at < bottom
                ):
                    cost += 10.0
        return cost

    def _chip_cost(
        self, pipe: Pipe, lane: float, top: float, bottom: float, first: bool = False
    ) -> float:
        """Crossing chips of folded pipes is ugly. first: the lane beside the exit, which other
        exits' pipes join."""
        if first and pipe.id in self.joining:
            up, down = self.joining[pipe.id]
            top, bottom = min(top, up), max(bottom, down)
        return 125.0 * len(self.chips.near(lane - 3, top, lane + 3, bottom))

    def cost(self, pipe: Pipe, points: Sequence[Point]) -> float:
        """What a way costs: its length, its bends, and being in the way of others."""
        cost = length(points) + 14.0 * (len(points) - 2)
        for (ax, ay), (bx, by) in pairwise(points[1:-1]):
            if abs(ax - bx) + abs(ay - by) < JOG:
                cost += 24.0
        beside = points[1][0]
        for horizontal, at, low, high in segments(points):
            if horizontal:
                for y, a, b, target, other in self.level.between(at - 11.9, at + 11.9, low, high):
                    overlap = min(b, high) - max(a, low)
                    if other == pipe.id:
                        continue
                    if target == pipe.goal and y == at:
                        cost -= 0.3 * overlap
                    elif overlap > 1:
                        cost += 160.0 if abs(y - at) < 5 else 30.0
                if self.careful:
                    for x, a, b, target, other in self.upright.between(
                        low, high, at - 0.5, at + 0.5
                    ):
                        if (
                            other != pipe.id
                            and target != pipe.goal
                            and a < at < b
                            and low < x < high
                        ):
                            cost += 16.0
                cost += 125.0 * len(self.chips.near(low, at - 1, high, at + 1))
            else:
                cost += self._press(at, low, high, pipe)
                cost += self._chip_cost(pipe, at, low, high, at == beside)
        return cost

    def crossings(self, pipe: Pipe, points: Sequence[Point]) -> int:
        """How many other pipes, to other cards, it crosses."""
        count = 0
        for horizontal, at, low, high in segments(points):
            lines = self.upright if horizontal else self.level
            for x, a, b, target, other in lines.between(low, high, at - 0.5, at + 0.5):
                if (
                    other != pipe.id
                    and target != pipe.goal
                    and a + 1 < at < b - 1
                    and low + 1 < x < high - 1
                ):
                    count += 1
        return count


def _beside(pipe: Pipe) -> tuple[float, float]:
    """The first vertical and the last."""
    return pipe.start[0] + OUT, pipe.end[0] - IN


def _least(pipe: Pipe, bends: int) -> float:
    """What a way with so many bends costs at least."""
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    return abs(x2 - x1) + abs(y2 - y1) + 14.0 * bends


def _rungs(low: float, high: float, y1: float, y2: float) -> list[float]:
    """Lanes of one corridor worth a look: near the rows beside it, and near the two ends."""
    room = high - low
    if room < CORRIDOR:
        return [(low + high) / 2] if room >= 2 else []
    rungs = set()
    for k in range(8):
        for y in (low + 6 + k * CORRIDOR, high - 6 - k * CORRIDOR):
            if low <= y <= high:
                rungs.add(y)
    for y in (y1, y2):
        if low <= y <= high:
            rungs.add(y)
    return sorted(rungs)


def _step(room: float) -> float:
    """Between the lanes of a gap."""
    return LANE if room >= 5 * LANE else NARROW


def _chip(pipe: Pipe) -> Box:
    x, y = pipe.start
    return Box(x + 2, y - 8, x + STUB + pipe.chip, y + 8)


def _cramped(pipe: Pipe, points: Sequence[Point]) -> bool:
    """Whether a way leaves no room for its arrow: its last two verticals passed each other."""
    return pipe.source != pipe.target and points[-1][0] - points[-2][0] < IN
