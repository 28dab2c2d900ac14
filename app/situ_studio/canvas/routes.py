"""Right-angled routes for pipes: never through a card, spread in the corridors between them.

Measures are those of mockups/tokens.md, *Pipes*; lengths are scene units. Pure:
no Qt types, no clock, and the same input gives the same routes.

A route leaves an exit to the right and enters a card from the left. Tried are,
cheapest first: a straight line, one vertical between the two (three segments),
and one corridor above, below or between rows (five segments); a search on the
lines around the cards finds the rest. Segments already drawn make their lane
dearer, but what leads to the same card may share it.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from msgspec import Struct
from msgspec.structs import replace

Point = tuple[float, float]

PAD = 7.0
"""How near a pipe may come to a card that it does not belong to."""
OUT = 14.0
"""From an exit to its first vertical lane."""
IN = 12.0
"""From the last vertical lane to the card: the arrow and what is left of the corner."""
LANE = 8.0
CORRIDOR = 12.0
CELL = 192.0
FAR = 1e6
LOOP = 18.0
"""How far below its card a self-loop runs."""
BURDEN = 1000.0
"""A pipe that is more in the way than this is folded."""
STUB = 15.0
"""The line and arrow of a folded pipe, before its chip."""


class Box(NamedTuple):
    """A rectangle that pipes go round."""

    left: float
    top: float
    right: float
    bottom: float


class Pipe(Struct, frozen=True):
    """What to route. start: the exit; end: the input. Ids sort in document order.

    width: of the label, 0 for none; height: of the label. chip: the width of the
    chip that it ends in when folded. fold: whether it may be folded; folded: always.
    """

    id: tuple[str, ...]
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


class Route(Struct, frozen=True):
    """points: the corners; empty for a folded pipe. label: centre of the label, if it fits,
    room: its width there, less than was asked for where it has to be shortened.

    joint: where the pipe meets another one to the same card, a dot. trunk: the
    pipe whose label names this one too.
    """

    points: tuple[Point, ...] = ()
    label: Point | None = None
    room: float = 0.0
    joint: Point | None = None
    trunk: tuple[str, ...] | None = None
    folded: bool = False


class _Boxes:
    """Rectangles by cell."""

    def __init__(self, boxes: Iterable[tuple[str, Box]]) -> None:
        self._cells: dict[tuple[int, int], list[tuple[str, Box]]] = {}
        for entry in boxes:
            self.add(entry)

    def add(self, entry: tuple[str, Box]) -> None:
        box = entry[1]
        for cx in range(int(box.left // CELL), int(box.right // CELL) + 1):
            for cy in range(int(box.top // CELL), int(box.bottom // CELL) + 1):
                self._cells.setdefault((cx, cy), []).append(entry)

    def near(self, left: float, top: float, right: float, bottom: float) -> list[tuple[str, Box]]:
        """Every rectangle that touches this area, each once."""
        found: dict[int, tuple[str, Box]] = {}
        cells = self._cells
        for cx in range(int(left // CELL), int(right // CELL) + 1):
            for cy in range(int(top // CELL), int(bottom // CELL) + 1):
                for entry in cells.get((cx, cy), ()):
                    box = entry[1]
                    if (
                        box.left < right
                        and left < box.right
                        and box.top < bottom
                        and top < box.bottom
                    ):
                        found[id(box)] = entry
        return list(found.values())


class _Lines:
    """Drawn segments of one direction, by the cell of their lane: (at, low, high, target, id)."""

    def __init__(self) -> None:
        self._cells: dict[
            tuple[int, int], list[tuple[float, float, float, str, tuple[str, ...]]]
        ] = {}

    def add(self, at: float, low: float, high: float, target: str, id: tuple[str, ...]) -> None:
        line = (at, low, high, target, id)
        for along in range(int(low // CELL), int(high // CELL) + 1):
            self._cells.setdefault((int(at // CELL), along), []).append(line)

    def remove(self, at: float, low: float, high: float, id: tuple[str, ...]) -> None:
        for along in range(int(low // CELL), int(high // CELL) + 1):
            cell = self._cells.get((int(at // CELL), along))
            if cell:
                cell[:] = [line for line in cell if line[4] != id or line[0] != at]

    def between(
        self, at_low: float, at_high: float, low: float, high: float
    ) -> list[tuple[float, float, float, str, tuple[str, ...]]]:
        """Segments whose lane lies in at_low..at_high and that overlap low..high, each once."""
        found = {}
        for lane in range(int(at_low // CELL), int(at_high // CELL) + 1):
            for along in range(int(low // CELL), int(high // CELL) + 1):
                for line in self._cells.get((lane, along), ()):
                    if at_low <= line[0] <= at_high and line[1] < high and low < line[2]:
                        found[id(line)] = line
        return list(found.values())


def simple(points: Sequence[Point]) -> tuple[Point, ...]:
    """Without points that are doubled or lie on a straight line between their neighbours."""
    kept: list[Point] = []
    for point in points:
        if kept and abs(kept[-1][0] - point[0]) < 0.01 and abs(kept[-1][1] - point[1]) < 0.01:
            continue
        if len(kept) > 1:
            (ax, ay), (bx, by) = kept[-2], kept[-1]
            if (ax == bx == point[0]) or (ay == by == point[1]):
                kept[-1] = point
                continue
        kept.append(point)
    return tuple(kept)


def length(points: Sequence[Point]) -> float:
    return sum(abs(bx - ax) + abs(by - ay) for (ax, ay), (bx, by) in pairwise(points))


def segments(points: Sequence[Point]) -> Iterable[tuple[bool, float, float, float]]:
    """(horizontal, at, low, high) of each segment."""
    for (ax, ay), (bx, by) in pairwise(points):
        if ay == by:
            yield True, ay, min(ax, bx), max(ax, bx)
        else:
            yield False, ax, min(ay, by), max(ay, by)


class Router:
    """Routes of one drawing. ``route`` is given all cards and pipes and does what changed.

    drawn: ids that are never folded because somebody asked to see them.
    """

    def __init__(self) -> None:
        self.routes: dict[tuple[str, ...], Route] = {}
        self.drawn: set[tuple[str, ...]] = set()
        self._boxes: dict[str, Box] = {}
        self._pipes: dict[tuple[str, ...], Pipe] = {}
        self._space = _Boxes(())
        self._level = _Lines()
        self._upright = _Lines()
        self._labels = _Boxes(())
        self._chips: dict[str, list[Box]] = {}
        self._many = False
        self._folded: set[tuple[str, ...]] = set()
        self._paths: dict[tuple[str, ...], tuple[Point, ...]] = {}
        self._groups: dict[tuple[str, str], list[Pipe]] = {}
        self._stubs = _Lines()

    def route(
        self, boxes: Mapping[str, Box], pipes: Iterable[Pipe]
    ) -> dict[tuple[str, ...], Route]:
        """The route of every pipe, by id."""
        self._begin(boxes, pipes)
        self._level, self._upright = _Lines(), _Lines()
        self._paths = {}
        trunks = self._trunks()
        trunks.sort(key=_effort)
        self._fold_short(trunks)
        for pipe in trunks:
            if pipe.id not in self._folded:
                self._put(pipe, self._path(pipe))
        if not self._many:
            self._again(trunks)
        self._fold_long(trunks)
        if not self._many:
            # What is folded made room, and its chip takes some.
            self._again(trunks)
        return self._finish(trunks)

    def follow(
        self, boxes: Mapping[str, Box], pipes: Iterable[Pipe], moved: Iterable[str]
    ) -> dict[tuple[str, ...], Route]:
        """Some cards moved (they are being dragged): their pipes, and those that ran where they
        are now, are routed anew; the others stay as they are. What is folded stays so."""
        before = self._pipes
        self._begin(boxes, pipes)
        cards = set(moved)
        trunks = self._trunks()
        anew = []
        for pipe in trunks:
            points = self._paths.get(pipe.id)
            if points is None:
                continue
            if before.get(pipe.id) != pipe or self._blocked(points, pipe, cards):
                self._rub_out(pipe, points)
                anew.append(pipe)
        for pipe in sorted(anew, key=_effort):
            self._put(pipe, self._path(pipe))
        for pipe in trunks:
            if pipe.id not in self._paths and pipe.id not in self._folded:
                self._put(pipe, self._path(pipe))
        self._chips = {}
        for pipe in trunks:
            if pipe.id in self._folded:
                self._fold(pipe)
        return self._finish(trunks)

    def _begin(self, boxes: Mapping[str, Box], pipes: Iterable[Pipe]) -> None:
        self._boxes = dict(boxes)
        self._pipes = {p.id: p for p in pipes}
        self._many = len(self._pipes) > 300
        self._space = _Boxes(self._boxes.items())

    def _trunks(self) -> list[Pipe]:
        """The pipe of each pair of cards that the others of the pair join: the first event."""
        groups: dict[tuple[str, str], list[Pipe]] = {}
        for pipe in self._pipes.values():
            groups.setdefault((pipe.source, pipe.target), []).append(pipe)
        self._groups = groups
        return [min(g, key=lambda p: (p.timeout, p.start[1])) for g in groups.values()]

    def _finish(self, trunks: Sequence[Pipe]) -> dict[tuple[str, ...], Route]:
        """Joints and labels, when every way is known."""
        self._labels = _Boxes(())
        self.routes = {}
        for pipe in trunks:
            folded = pipe.id in self._folded
            self.routes[pipe.id] = Route(points=self._paths.get(pipe.id, ()), folded=folded)
        self._stubs = _Lines()
        for trunk in trunks:
            for pipe in self._groups[trunk.source, trunk.target]:
                if pipe.id != trunk.id:
                    self.routes[pipe.id] = self._join(pipe, trunk)
        self._meet(trunks)
        self._label(trunks)
        return self.routes

    def _blocked(self, points: Sequence[Point], pipe: Pipe, cards: set[str]) -> bool:
        """Whether one of these cards lies on the way."""
        for horizontal, at, low, high in segments(points):
            area = (
                (low, at - PAD, high, at + PAD) if horizontal else (at - PAD, low, at + PAD, high)
            )
            for uid, _ in self._space.near(*area):
                if uid in cards and uid not in (pipe.source, pipe.target):
                    return True
        return False

    # -- one pipe -------------------------------------------------------------------

    def _path(self, pipe: Pipe) -> tuple[Point, ...]:
        if pipe.source == pipe.target:
            return self._loop(pipe)
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        ends = (pipe.source, pipe.target)
        if abs(y1 - y2) < 0.5 and x2 - x1 >= IN and self._clear_level(y1, x1, x2, ends):
            return (x1, y1), (x2, y2)
        best: tuple[float, tuple[Point, ...]] | None = None
        for points in self._short(pipe):
            cost = self._cost(pipe, points)
            if best is None or cost < best[0]:
                best = cost, points
        bound = best[0] if best is not None else FAR
        for points in self._long(pipe, bound):
            cost = self._cost(pipe, points)
            if best is None or cost < best[0]:
                best = cost, points
        if best is None:
            return self._search(pipe)
        return best[1]

    def _loop(self, pipe: Pipe) -> tuple[Point, ...]:
        (x1, y1) = pipe.start
        box = self._boxes[pipe.source]
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
                if self._clear_level(y1, x1, x, (pipe.source,)) and self._clear_level(
                    y2, x, x2, (pipe.target,)
                ):
                    yield (x1, y1), (x, y1), (x, y2), (x2, y2)

    def _gaps(self, low: float, high: float, y1: float, y2: float) -> list[tuple[float, float]]:
        """Intervals of x in low..high in which a vertical from y1 to y2 is free."""
        top, bottom = min(y1, y2), max(y1, y2)
        near = self._space.near(low - PAD, top - PAD, high + PAD, bottom + PAD)
        return _holes(low, high, [(b.left - PAD, b.right + PAD) for _, b in near])

    def _long(self, pipe: Pipe, bound: float) -> Iterable[tuple[Point, ...]]:
        """One corridor: right, up or down, along, up or down, right."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        xa, xb = x1 + OUT, x2 - IN
        left, right = min(xa, xb), max(xa, xb)
        lanes: list[tuple[float, float]] = []
        reach = 700.0
        low, high = min(y1, y2) - reach, max(y1, y2) + reach
        near = self._space.near(left - PAD, low, right + PAD, high)
        margin = PAD + 5
        holes = _holes(low, high, [(b.top - margin, b.bottom + margin) for _, b in near])
        for gap_low, gap_high in holes:
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
            if two is None or not self._clear_level(y, min(one, two), max(one, two), ()):
                continue
            tried += 1
            yield (x1, y1), (one, y1), (one, y), (two, y), (two, y2), (x2, y2)

    def _crowd(self, y: float, left: float, right: float, pipe: Pipe) -> float:
        """What a horizontal lane costs for those that are drawn there already."""
        cost = 0.0
        for at, low, high, target, other in self._level.between(
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
                if not self._clear_level(y, min(x, lane), max(x, lane), (own,)):
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
        for at, _, _, target, other in self._upright.between(x - 7.9, x + 7.9, top - 4, bottom + 4):
            if other == pipe.id or (target == pipe.target and at == x):
                continue
            cost += 90.0 if abs(at - x) < 5 else 20.0
        if not self._many:
            for at, low, high, target, other in self._level.between(top, bottom, x - 0.5, x + 0.5):
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
        for chip in self._chips.get(pipe.source, ()):
            if chip.left - 3 < lane < chip.right + 3 and chip.top < bottom and top < chip.bottom:
                cost += 40.0
        return cost

    def _clear_level(self, y: float, left: float, right: float, own: tuple[str, ...]) -> bool:
        """Whether a horizontal is free of cards; those of ``own`` may be touched at their edge."""
        for uid, box in self._space.near(left, y - PAD, right, y + PAD):
            if uid in own and (box.right <= left + 0.5 or right - 0.5 <= box.left):
                continue
            if uid not in own or (left < box.right - 0.5 and box.left + 0.5 < right):
                return False
        return True

    def _cost(self, pipe: Pipe, points: Sequence[Point]) -> float:
        points = simple(points)
        cost = length(points) + 14.0 * (len(points) - 2)
        for horizontal, at, low, high in segments(points):
            if horizontal:
                for y, a, b, target, other in self._level.between(at - 11.9, at + 11.9, low, high):
                    if other == pipe.id or target == pipe.target:
                        if y == at and target == pipe.target and other != pipe.id:
                            cost -= 0.3 * (min(b, high) - max(a, low))
                        continue
                    overlap = min(b, high) - max(a, low)
                    if overlap > 1:
                        cost += 160.0 if abs(y - at) < 5 else 30.0
                if not self._many:
                    for x, a, b, target, other in self._upright.between(
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
                for chip in self._chips.get(pipe.source, ()):
                    if (
                        chip.left - 3 < at < chip.right + 3
                        and chip.top < high
                        and low < chip.bottom
                    ):
                        cost += 40.0
        return cost

    def _search(self, pipe: Pipe) -> tuple[Point, ...]:
        """The shortest way on the lines around the cards; straight through where there is none."""
        (x1, y1), (x2, y2) = pipe.start, pipe.end
        xa, xb = x1 + OUT, x2 - IN
        for margin in (400.0, 1600.0, FAR):
            left, right = min(x1, x2) - margin, max(x1, x2) + margin
            top, bottom = min(y1, y2) - margin, max(y1, y2) + margin
            if margin == FAR:
                near = list(self._boxes.items())
            else:
                near = self._space.near(left, top, right, bottom)
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
        if not self._clear_level(y1, x1, xa, (pipe.source,)):
            return None
        if not self._clear_level(y2, xb, x2, (pipe.target,)):
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
                    if not self._clear_level(
                        ys[row], min(xs[column], xs[c]), max(xs[column], xs[c]), ()
                    ):
                        continue
                    step, turned = abs(xs[c] - xs[column]), direction != 0
                else:
                    a, b = min(ys[row], ys[r]), max(ys[row], ys[r])
                    if self._space.near(xs[column] - PAD, a, xs[column] + PAD, b):
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

    # -- all pipes ------------------------------------------------------------------

    def _draw(self, pipe: Pipe, points: Sequence[Point]) -> None:
        for horizontal, at, low, high in segments(points):
            lines = self._level if horizontal else self._upright
            lines.add(at, low, high, pipe.target, pipe.id)

    def _rub_out(self, pipe: Pipe, points: Sequence[Point]) -> None:
        for horizontal, at, low, high in segments(points):
            lines = self._level if horizontal else self._upright
            lines.remove(at, low, high, pipe.id)

    def _put(self, pipe: Pipe, points: tuple[Point, ...]) -> None:
        self._paths[pipe.id] = points
        self._draw(pipe, points)

    def _again(self, trunks: Sequence[Pipe]) -> None:
        """Each pipe that is in another's way once more, now that all are known."""
        for _ in range(2):
            better = False
            for pipe in trunks:
                old = self._paths.get(pipe.id)
                if old is None or len(old) < 3 or pipe.source == pipe.target:
                    continue
                before = self._cost(pipe, old)
                if before - length(old) - 14.0 * (len(old) - 2) < 2.0:
                    continue
                self._rub_out(pipe, old)
                new = self._path(pipe)
                if self._cost(pipe, new) >= before - 0.5:
                    new = old
                better = better or new is not old
                self._put(pipe, new)
            if not better:
                break

    def _fold_short(self, trunks: Sequence[Pipe]) -> None:
        """Timeouts that lead back are folded before anything is drawn: they only take room."""
        self._chips = {}
        self._folded = set()
        for pipe in trunks:
            (x1, y1), (x2, y2) = pipe.start, pipe.end
            back = x2 < x1 or y2 < y1 - 60
            if pipe.id in self.drawn or not pipe.fold or pipe.source == pipe.target:
                continue
            if pipe.folded or (pipe.timeout and back):
                self._fold(pipe)

    def _fold_long(self, trunks: Sequence[Pipe]) -> None:
        """What would cross the drawing: the worst first, for the others are the better for it."""
        waiting = {
            p.id: p
            for p in trunks
            if p.id in self._paths
            and p.fold
            and p.id not in self.drawn
            and p.source != p.target
            and length(self._paths[p.id]) > 450
        }
        while waiting:
            worst = max(waiting.values(), key=lambda p: (self._burden(p), p.id))
            if self._burden(worst) <= BURDEN:
                break
            del waiting[worst.id]
            self._rub_out(worst, self._paths.pop(worst.id))
            self._fold(worst)

    def _burden(self, pipe: Pipe) -> float:
        """How much a pipe is in the way of the drawing."""
        points = self._paths[pipe.id]
        upwards = 350.0 if pipe.end[1] < pipe.start[1] - 60 else 0.0
        crossings = 0 if self._many else self._crossings(pipe, points)
        return 120.0 * crossings + 0.5 * length(points) + upwards

    def _fold(self, pipe: Pipe) -> None:
        x, y = pipe.start
        self._folded.add(pipe.id)
        chip = Box(x, y - 9, x + STUB + pipe.chip, y + 9)
        self._chips.setdefault(pipe.source, []).append(chip)

    def _crossings(self, pipe: Pipe, points: Sequence[Point]) -> int:
        count = 0
        for horizontal, at, low, high in segments(points):
            lines = self._upright if horizontal else self._level
            for x, a, b, target, other in lines.between(low, high, at - 0.5, at + 0.5):
                if (
                    other != pipe.id
                    and target != pipe.target
                    and a + 1 < at < b - 1
                    and low + 1 < x < high - 1
                ):
                    count += 1
        return count

    def _join(self, pipe: Pipe, trunk: Pipe) -> Route:
        """A further exit to the same card runs into the trunk at a dot."""
        route = self.routes[trunk.id]
        if route.folded:
            return Route(folded=True, trunk=trunk.id)
        (x, y) = pipe.start
        points = route.points
        if len(points) == 2:
            lane = min(x + 20, points[1][0] - IN)
            return self._joined(pipe, ((x, y), (lane, y), (lane, points[0][1])), trunk)
        lane = points[1][0]
        low, high = sorted((points[1][1], points[2][1]))
        if low <= y <= high:
            return self._joined(pipe, ((x, y), (lane, y)), trunk)
        return self._joined(pipe, ((x, y), (lane, y), (lane, points[1][1])), trunk)

    def _joined(self, pipe: Pipe, points: tuple[Point, ...], trunk: Pipe) -> Route:
        for horizontal, at, low, high in segments(points):
            if not horizontal:
                self._stubs.add(at, low, high, pipe.target, pipe.id)
        return Route(points=points, joint=points[-1], trunk=trunk.id)

    def _meet(self, trunks: Sequence[Pipe]) -> None:
        """Pipes of different cards to one: a dot where one runs into another's way."""
        for pipe in trunks:
            route = self.routes[pipe.id]
            if route.folded or len(route.points) < 4 or pipe.source == pipe.target:
                continue
            corner = route.points[1:-1]
            for index, (x, y) in enumerate(corner):
                if index == 0 or abs(x - pipe.end[0]) + abs(y - pipe.end[1]) < 30:
                    continue
                for at, low, high, target, other in self._level.between(y, y, x - 0.1, x + 0.1):
                    if (
                        target == pipe.target
                        and other != pipe.id
                        and at == y
                        and low + 1 < x < high - 1
                        and route.joint is None
                    ):
                        route = replace(route, joint=(x, y))
                        self.routes[pipe.id] = route

    # -- labels ---------------------------------------------------------------------

    def _label(self, trunks: Sequence[Pipe]) -> None:
        for pipe in sorted(trunks, key=lambda p: (-p.height, _effort(p))):
            route = self.routes[pipe.id]
            if route.folded or not pipe.width:
                continue
            # Whole on a horizontal, else shortened there, else across a vertical.
            short = min(pipe.width, 84.0)
            spot, width = self._along(pipe, route.points, pipe.width), pipe.width
            if spot is None and short < pipe.width:
                spot, width = self._along(pipe, route.points, short), short
            if spot is None:
                spot, width = self._across(pipe, route.points), pipe.width
            if spot is None:
                continue
            self.routes[pipe.id] = Route(
                points=route.points, label=spot, room=width, joint=route.joint, trunk=route.trunk
            )
            half, tall = width / 2 + 6, pipe.height / 2 + 1
            x, y = spot
            self._labels.add(("", Box(x - half, y - tall, x + half, y + tall)))

    def _along(self, pipe: Pipe, points: Sequence[Point], width: float) -> Point | None:
        """The best of about 35 places on the longest horizontals, where one is free."""
        levels = [
            (min(ax, bx), max(ax, bx), ay) for (ax, ay), (bx, by) in pairwise(points) if ay == by
        ]
        levels.sort(key=lambda s: s[0] - s[1])
        best: tuple[float, Point] | None = None
        for rank, (low, high, y) in enumerate(levels[:3]):
            # The arrow and the port's end need their own room.
            low, high = low + 12, high - 14
            room = high - low - width
            if room < 0:
                continue
            steps = max(1, min(14, int(room / 12)))
            for k in range(steps + 1):
                part = k / steps
                x = low + width / 2 + room * part
                cost = abs(part - 0.5) * 20 + rank * 30
                if best is None or cost < best[0]:
                    cost += self._covered(pipe, x, y, width)
                    if best is None or cost < best[0]:
                        best = cost, (x, y)
        return best[1] if best is not None and best[0] < 90 else None

    def _across(self, pipe: Pipe, points: Sequence[Point]) -> Point | None:
        """A place on a vertical that is long enough."""
        best: tuple[float, Point] | None = None
        for (ax, ay), (bx, by) in pairwise(points):
            if ax == bx and abs(by - ay) > pipe.height + 60:
                for part in (0.5, 0.35, 0.65, 0.2, 0.8):
                    y = ay + (by - ay) * part
                    cost = self._covered(pipe, ax, y, pipe.width)
                    if best is None or cost < best[0]:
                        best = cost, (ax, y)
        return best[1] if best is not None and best[0] < 90 else None

    def _covered(self, pipe: Pipe, x: float, y: float, width: float) -> float:
        half, tall = width / 2 + 4, pipe.height / 2
        area = (x - half, y - tall, x + half, y + tall)
        if self._space.near(*area) or self._labels.near(*area):
            return FAR
        cost = 0.0
        area = (y - tall, y + tall, x - half, x + half)
        for lines in (self._upright, self._stubs):
            for line in lines.between(x - half, x + half, y - tall, y + tall):
                cost += 100.0 if line[4] != pipe.id else 0.0
        for line in self._level.between(*area):
            cost += 100.0 if line[4] != pipe.id else 0.0
        return cost


def _effort(pipe: Pipe) -> tuple[float, ...]:
    """Short ways first: they take the inner lanes. Of one card's, the one nearest to its goal."""
    (x1, y1), (x2, y2) = pipe.start, pipe.end
    back = 400.0 if x2 < x1 else 0.0
    return (
        round((abs(x2 - x1) + abs(y2 - y1) + back) / 40),
        -y1 if y2 > y1 else y1,
        x1,
        y2,
        x2,
    )


def _holes(low: float, high: float, taken: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """What is left of low..high without the taken intervals."""
    holes = []
    at = low
    for begin, end in sorted(taken):
        if begin > at:
            holes.append((at, min(begin, high)))
        at = max(at, end)
        if at >= high:
            break
    if at < high:
        holes.append((at, high))
    return [(a, b) for a, b in holes if b - a >= 0]


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
