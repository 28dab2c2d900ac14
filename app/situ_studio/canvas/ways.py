"""The way of one pipe, round the cards and beside the pipes that are drawn already. Pure; no Qt.

A way leaves an exit to the right and enters a card from the left. Tried are,
cheapest first: a straight line, one vertical between the two (three segments),
and one corridor above, below or between rows (five segments); a search on the
lines around the cards finds the rest. Segments already drawn make their lane
dearer, but what leads to the same card may share it.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable, Mapping, Sequence

from msgspec import Struct

from situ_studio.canvas.space import (
    FAR,
    Box,
    Boxes,
    Line,
    Lines,
    PipeId,
    Point,
    holes,
    length,
    segments,
    simple,
)

PAD = 7.0
"""How near a pipe may come to a card that it does not belong to."""
OUT = 14.0
"""From an exit to its first vertical lane."""
IN = 12.0
"""From the last vertical lane to the card: the arrow and what is left of the corner."""
LANE = 8.0
CORRIDOR = 12.0
LOOP = 18.0
"""How far below its card a self-loop runs."""
STUB = 15.0
"""The line and arrow of a folded pipe, before its chip."""
REACH = 700.0
"""How far above and below a pipe's ends corridors are looked for."""


class Pipe(Struct, frozen=True):
    """What to route. start: the exit; end: the input. Ids sort in document order.

    width: of the label, 0 for none; height: of the label. chip: the width of the
    chip that it ends in when folded. fold: whether it may be folded; folded: always.
    """

    id: PipeId
    source: str
    target: str
    start: Point
    end: Point
    width: float = 0.0
    height: float = 18.0
    chip: float = 18.0
    fold: bool = True
    timeout: bool = False
    folded: bool = False


class Ways:
    """Cards, and the pipes drawn between them so far.

    careful: crossings count; too dear for very many pipes.
    """

    def __init__(self, boxes: Mapping[str, Box], careful: bool = True) -> None:
        self.boxes = dict(boxes)
        self.careful = careful
        self.space = Boxes(self.boxes.items())
        self.level, self.upright = Lines(), Lines()
        self.chips: dict[str, list[Box]] = {}

    # -- what stands and runs there ------------------------------------------------

    def put_box(self, name: str, box: Box | None) -> None:
        """A card is elsewhere now, or (None) gone."""
        old = self.boxes.pop(name, None)
        if old is not None:
            self.space.remove(name, old)
        if box is not None:
            self.boxes[name] = box
            self.space.add(name, box)

    def draw(self, pipe: Pipe, points: Sequence[Point]) -> None:
        for horizontal, at, low, high in segments(points):
            lines = self.level if horizontal else self.upright
            lines.add(Line(at, low, high, pipe.target, pipe.id))

    def rub_out(self, pipe: Pipe, points: Sequence[Point]) -> None:
        for horizontal, at, low, high in segments(points):
            lines = self.level if horizontal else self.upright
            lines.remove(Line(at, low, high, pipe.target, pipe.id))

    def put_chip(self, pipe: Pipe) -> None:
        """A folded pipe takes the room of its chip."""
        x, y = pipe.start
        chip = Box(x, y - 9, x + STUB + pipe.chip, y + 9)
        self.chips.setdefault(pipe.source, []).append(chip)

    def drop_chip(self, pipe: Pipe) -> None:
        x, y = pipe.start
        kept = [c for c in self.chips.get(pipe.source, ()) if (c.left, c.top) != (x, y - 9)]
        self.chips[pipe.source] = kept

    def free(self, points: Sequence[Point], own: str) -> bool:
        """Whether a way that begins at ``own`` keeps clear of all cards."""
        for horizontal, at, low, high in segments(points):
            if horizontal:
                if not self.clear_level(at, low, high, (own,)):
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
        if pipe.source == pipe.target:
            return self._loop(pipe)
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        ends = (pipe.source, pipe.target)
        if abs(y1 - y2) < 0.5 and x2 - x1 >= IN and self.clear_level(y1, x1, x2, ends):
            return (x1, y1), (x2, y2)
        best: tuple[float, tuple[Point, ...]] | None = None
        for points in self._short(pipe):
            cost = self.cost(pipe, points)
            if best is None or cost < best[0]:
                best = cost, points
        bound = best[0] if best is not None else FAR
        for points in self._long(pipe, bound):
            cost = self.cost(pipe, points)
            if best is None or cost < best[0]:
                best = cost, points
        if best is None:
            return self._search(pipe)
        return best[1]

    def _loop(self, pipe: Pipe) -> tuple[Point, ...]:
        (x1, y1) = pipe.start
        box = self.boxes[pipe.source]
        below, x = box.bottom + LOOP, x1 + OUT
        middle = box.left + 112
        return (x1, y1), (x, y1), (x, below), (middle, below), (middle, box.bottom)

    def _short(self, pipe: Pipe) -> Iterable[tuple[Point, ...]]:
        """One vertical between source and target."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        if x2 - x1 < OUT + IN:
            return
        for low, high in self._gaps(x1 + OUT, x2 - IN, y1, y2):
            lanes = {low + k * LANE for k in range(6)} | {high - k * LANE for k in range(3)}
            for x in sorted(v for v in lanes if low <= v <= high):
                if self.clear_level(y1, x1, x, (pipe.source,)) and self.clear_level(
                    y2, x, x2, (pipe.target,)
                ):
                    yield (x1, y1), (x, y1), (x, y2), (x2, y2)

    def _gaps(self, low: float, high: float, y1: float, y2: float) -> list[tuple[float, float]]:
        """Intervals of x in low..high in which a vertical from y1 to y2 is free."""
        top, bottom = min(y1, y2), max(y1, y2)
        near = self.space.near(low - PAD, top - PAD, high + PAD, bottom + PAD)
        return holes(low, high, [(b.left - PAD, b.right + PAD) for _, b in near])

    def _long(self, pipe: Pipe, bound: float) -> Iterable[tuple[Point, ...]]:
        """One corridor: right, up or down, along, up or down, right."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        xa, xb = x1 + OUT, x2 - IN
        left, right = min(xa, xb), max(xa, xb)
        lanes: list[tuple[float, float]] = []
        low, high = min(y1, y2) - REACH, max(y1, y2) + REACH
        near = self.space.near(left - PAD, low, right + PAD, high)
        margin = PAD + 5
        free = holes(low, high, [(b.top - margin, b.bottom + margin) for _, b in near])
        for gap_low, gap_high in free:
            for y in _rungs(gap_low, gap_high, y1, y2):
                travel = abs(y - y1) + abs(y - y2)
                lanes.append((travel + self._crowd(y, left, right, pipe), y))
        lanes.sort()
        tried = 0
        for estimate, y in lanes:
            if tried >= 6 or estimate > bound:
                break
            one = self._lane(pipe, x1, y1, y, +1, pipe.source)
            if one is None:
                continue
            two = self._lane(pipe, x2, y2, y, -1, pipe.target)
            if two is None or not self.clear_level(y, min(one, two), max(one, two), ()):
                continue
            tried += 1
            yield (x1, y1), (one, y1), (one, y), (two, y), (two, y2), (x2, y2)

    def _crowd(self, y: float, left: float, right: float, pipe: Pipe) -> float:
        """What a horizontal lane costs for those that are drawn there already."""
        cost = 0.0
        for at, low, high, target, other in self.level.between(
            y - 23.9, y + 23.9, left - LANE, right + LANE
        ):
            if other == pipe.id:
                continue
            if target == pipe.target:
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
            for k in range(6):
                lane = near + side * k * LANE
                if not gap_low <= lane <= gap_high:
                    break
                if not self.clear_level(y, min(x, lane), max(x, lane), (own,)):
                    break
                cost = abs(lane - begin) + self._press(lane, top, bottom, pipe, side)
                if side > 0:
                    cost += self._chip_cost(pipe, lane, top, bottom)
                if best is None or cost < best[0]:
                    best = cost, lane
        return best[1] if best is not None else None

    def _press(self, x: float, top: float, bottom: float, pipe: Pipe, side: int) -> float:
        """What a vertical lane costs for those that are drawn there already."""
        cost = 0.0
        for at, _, _, target, other in self.upright.between(x - 7.9, x + 7.9, top - 4, bottom + 4):
            if other == pipe.id or (target == pipe.target and at == x):
                continue
            cost += 90.0 if abs(at - x) < 5 else 20.0
        if self.careful:
            for at, low, high, target, other in self.level.between(top, bottom, x - 0.5, x + 0.5):
                if (
                    other != pipe.id
                    and target != pipe.target
                    and low < x < high
                    and top < at < bottom
                ):
                    cost += 10.0
        return cost

    def _chip_cost(self, pipe: Pipe, lane: float, top: float, bottom: float) -> float:
        """Crossing the chip of a folded pipe, or the room of one, is ugly."""
        cost = 0.0
        for chip in self.chips.get(pipe.source, ()):
            if chip.left - 3 < lane < chip.right + 3 and chip.top < bottom and top < chip.bottom:
                cost += 64.0
        return cost

    def clear_level(self, y: float, left: float, right: float, own: tuple[str, ...]) -> bool:
        """Whether a horizontal is free of cards; those of ``own`` may be touched at their edge."""
        for uid, box in self.space.near(left, y - PAD, right, y + PAD):
            if uid in own and (box.right <= left + 0.5 or right - 0.5 <= box.left):
                continue
            if uid not in own or (left < box.right - 0.5 and box.left + 0.5 < right):
                return False
        return True

    def cost(self, pipe: Pipe, points: Sequence[Point]) -> float:
        """What a way costs: its length, its bends, and being in the way of others."""
        points = simple(points)
        cost = length(points) + 14.0 * (len(points) - 2)
        for horizontal, at, low, high in segments(points):
            if horizontal:
                for y, a, b, target, other in self.level.between(at - 11.9, at + 11.9, low, high):
                    if other == pipe.id or target == pipe.target:
                        if y == at and target == pipe.target and other != pipe.id:
                            cost -= 0.3 * (min(b, high) - max(a, low))
                        continue
                    overlap = min(b, high) - max(a, low)
                    if overlap > 1:
                        cost += 160.0 if abs(y - at) < 5 else 30.0
                if self.careful:
                    for x, a, b, target, other in self.upright.between(
                        low, high, at - 0.5, at + 0.5
                    ):
                        if (
                            other != pipe.id
                            and target != pipe.target
                            and a < at < b
                            and low < x < high
                        ):
                            cost += 16.0
            else:
                cost += self._press(at, low, high, pipe, 0)
                for chip in self.chips.get(pipe.source, ()):
                    if (
                        chip.left - 3 < at < chip.right + 3
                        and chip.top < high
                        and low < chip.bottom
                    ):
                        cost += 64.0
        return cost

    def _search(self, pipe: Pipe) -> tuple[Point, ...]:
        """The shortest way on the lines around the cards; straight through where there is none."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        xa, xb = x1 + OUT, x2 - IN
        for margin in (400.0, 1600.0, FAR):
            left, right = min(x1, x2) - margin, max(x1, x2) + margin
            top, bottom = min(y1, y2) - margin, max(y1, y2) + margin
            if margin == FAR:
                near = list(self.boxes.items())
            else:
                near = self.space.near(left, top, right, bottom)
            found = self._walk(pipe, near, xa, xb)
            if found is not None:
                return found
        return simple([(x1, y1), (xa, y1), (xa, y2), (x2, y2)])

    def _walk(
        self, pipe: Pipe, near: Sequence[tuple[str, Box]], xa: float, xb: float
    ) -> tuple[Point, ...] | None:
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        edge = PAD + 1
        xs = sorted({xa, xb, *(b.left - edge for _, b in near), *(b.right + edge for _, b in near)})
        ys = sorted({y1, y2, *(b.top - edge for _, b in near), *(b.bottom + edge for _, b in near)})
        where_x = {x: i for i, x in enumerate(xs)}
        where_y = {y: i for i, y in enumerate(ys)}
        begin = (where_x[xa], where_y[y1])
        goal = (where_x[xb], where_y[y2])
        if not self.clear_level(y1, x1, xa, (pipe.source,)):
            return None
        if not self.clear_level(y2, xb, x2, (pipe.target,)):
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
                    if not self.clear_level(
                        ys[row], min(xs[column], xs[c]), max(xs[column], xs[c]), ()
                    ):
                        continue
                    step, turned = abs(xs[c] - xs[column]), direction != 0
                else:
                    a, b = min(ys[row], ys[r]), max(ys[row], ys[r])
                    if self.space.near(xs[column] - PAD, a, xs[column] + PAD, b):
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

    def crossings(self, pipe: Pipe, points: Sequence[Point]) -> int:
        """How many other pipes, to other cards, it crosses."""
        count = 0
        for horizontal, at, low, high in segments(points):
            lines = self.upright if horizontal else self.level
            for x, a, b, target, other in lines.between(low, high, at - 0.5, at + 0.5):
                if (
                    other != pipe.id
                    and target != pipe.target
                    and a + 1 < at < b - 1
                    and low + 1 < x < high - 1
                ):
                    count += 1
        return count


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
