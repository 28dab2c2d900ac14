"""What is routed, and the ground for it: rectangles and drawn lines, found by cell. Pure; no Qt."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Generic, NamedTuple, TypeVar

from msgspec import Struct

Point = tuple[float, float]
PipeId = tuple[str, ...]
Name = TypeVar("Name")

CELL = 192.0
ALONG = 768.0
"""Of a cell of lines, the way that they run: most are long."""
FAR = 1e6
PAD = 7.0
"""How near a pipe may come to a card that it does not belong to."""


class Box(NamedTuple):
    """A rectangle that pipes go round."""

    left: float
    top: float
    right: float
    bottom: float

    def grown(self, by: float) -> Box:
        """With so much more on each side."""
        return Box(self.left - by, self.top - by, self.right + by, self.bottom + by)


class Line(NamedTuple):
    """A drawn segment: its lane, from where to where, to which card it leads, whose it is."""

    at: float
    low: float
    high: float
    target: str
    pipe: PipeId


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

    @property
    def goal(self) -> str:
        """Whose way it may share: pipes to one card do, its loops enter elsewhere."""
        return self.target if self.source != self.target else f"{self.target} loop"


class Boxes(Generic[Name]):
    """Rectangles with a name, found by place."""

    def __init__(self, boxes: Iterable[tuple[Name, Box]] = ()) -> None:
        self._cells: dict[tuple[int, int], list[tuple[Name, Box]]] = {}
        for name, box in boxes:
            self.add(name, box)

    def _of(self, box: Box) -> Iterable[tuple[int, int]]:
        for across in range(int(box.left // CELL), int(box.right // CELL) + 1):
            for down in range(int(box.top // CELL), int(box.bottom // CELL) + 1):
                yield across, down

    def add(self, name: Name, box: Box) -> None:
        entry = (name, box)
        for cell in self._of(box):
            self._cells.setdefault(cell, []).append(entry)

    def remove(self, name: Name, box: Box) -> None:
        entry = (name, box)
        for cell in self._of(box):
            entries = self._cells.get(cell)
            if entries is not None and entry in entries:
                entries.remove(entry)

    def near(self, left: float, top: float, right: float, bottom: float) -> list[tuple[Name, Box]]:
        """Every rectangle that overlaps this area, each once."""
        found: dict[int, tuple[Name, Box]] = {}
        cells = self._cells
        for across in range(int(left // CELL), int(right // CELL) + 1):
            for down in range(int(top // CELL), int(bottom // CELL) + 1):
                for entry in cells.get((across, down), ()):
                    box = entry[1]
                    if box[0] < right and left < box[2] and box[1] < bottom and top < box[3]:
                        found[id(box)] = entry
        return list(found.values())

    def is_free(self, left: float, top: float, right: float, bottom: float) -> bool:
        """Whether none overlaps this area."""
        cells = self._cells
        for across in range(int(left // CELL), int(right // CELL) + 1):
            for down in range(int(top // CELL), int(bottom // CELL) + 1):
                for _, box in cells.get((across, down), ()):
                    if box[0] < right and left < box[2] and box[1] < bottom and top < box[3]:
                        return False
        return True


class Cards(Boxes[str]):
    """The cards of a drawing, which pipes keep clear of. boxes: by name."""

    def __init__(self, boxes: Mapping[str, Box]) -> None:
        super().__init__(boxes.items())
        self.boxes = dict(boxes)
        self._extent: Box | None = None
        # Where each line that was asked for is taken: begins and ends, from low to high.
        self._taken: dict[tuple[bool, float], tuple[list[float], list[float]]] = {}

    def put(self, name: str, box: Box | None) -> None:
        """A card is elsewhere now, or (None) gone."""
        self._taken.clear()
        self._extent = None
        old = self.boxes.pop(name, None)
        if old is not None:
            self.remove(name, old)
        if box is not None:
            self.boxes[name] = box
            self.add(name, box)

    def extent(self) -> Box:
        """What all cards lie in, and as much room round them as a pipe may take."""
        if self._extent is None:
            lefts, tops, rights, bottoms = zip(*self.boxes.values(), strict=True)
            self._extent = Box(min(lefts), min(tops), max(rights), max(bottoms)).grown(400.0)
        return self._extent

    def stretch(self, upright: bool, at: float, spot: float) -> tuple[float, float]:
        """From where to where a line is free of cards round a spot on it; no length on a card."""
        if (upright, at) not in self._taken:
            self._taken[upright, at] = self._taken_of(upright, at)
        begins, ends = self._taken[upright, at]
        after = bisect_left(begins, spot)
        low = ends[after - 1] if after else -FAR
        if low > spot:
            return spot, spot
        return low, begins[after] if after < len(begins) else FAR

    def _taken_of(self, upright: bool, at: float) -> tuple[list[float], list[float]]:
        left, top, right, bottom = self.extent()
        area = (at - PAD, top, at + PAD, bottom) if upright else (left, at - PAD, right, at + PAD)
        found = [box for _, box in self.near(*area)]
        begins: list[float] = []
        ends: list[float] = []
        for begin, end in sorted((b[1], b[3]) if upright else (b[0], b[2]) for b in found):
            if ends and begin < ends[-1]:
                ends[-1] = max(ends[-1], end)
            else:
                begins.append(begin)
                ends.append(end)
        return begins, ends

    def clear_level(self, y: float, left: float, right: float, own: tuple[str, ...]) -> bool:
        """Whether a horizontal is free of cards; those of ``own`` may be touched at their edge."""
        top, bottom, cells = y - PAD, y + PAD, self._cells
        rows = range(int(top // CELL), int(bottom // CELL) + 1)
        for across in range(int(left // CELL), int(right // CELL) + 1):
            for down in rows:
                for uid, box in cells.get((across, down), ()):
                    if (
                        box[1] < bottom
                        and top < box[3]
                        and box[0] < right
                        and left < box[2]
                        and (uid not in own or (left < box[2] - 0.5 and box[0] + 0.5 < right))
                    ):
                        return False
        return True


class Lines:
    """Drawn segments of one direction, found by lane."""

    def __init__(self) -> None:
        # Each cell's lines are sorted, which is by lane first.
        self._cells: dict[tuple[int, int], list[Line]] = {}
        self._goals: dict[str, list[Line]] = {}

    def _of(self, line: Line) -> Iterable[tuple[int, int]]:
        lane = int(line.at // CELL)
        for along in range(int(line.low // ALONG), int(line.high // ALONG) + 1):
            yield lane, along

    def add(self, line: Line) -> None:
        for cell in self._of(line):
            insort(self._cells.setdefault(cell, []), line)
        self._goals.setdefault(line.target, []).append(line)

    def remove(self, line: Line) -> None:
        for cell in self._of(line):
            lines = self._cells.get(cell)
            if lines is not None and line in lines:
                lines.remove(line)
        lines = self._goals.get(line.target)
        if lines is not None and line in lines:
            lines.remove(line)

    def to(self, goal: str) -> Sequence[Line]:
        """Those of the pipes that lead there."""
        return self._goals.get(goal, ())

    def between(self, at_low: float, at_high: float, low: float, high: float) -> list[Line]:
        """Segments whose lane lies in at_low..at_high and that overlap low..high, each once."""
        found = []
        cells = self._cells
        lanes = range(int(at_low // CELL), int(at_high // CELL) + 1)
        first = int(low // ALONG)
        for along in range(first, int(high // ALONG) + 1):
            begin = along * ALONG
            for lane in lanes:
                cell = cells.get((lane, along))
                if not cell:
                    continue
                for index in range(bisect_left(cell, (at_low,)), len(cell)):
                    line = cell[index]
                    if line[0] > at_high:
                        break
                    # One that began in a cell before was found there.
                    if line[1] < high and low < line[2] and (along == first or line[1] >= begin):
                        found.append(line)
        return found


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


def holes(low: float, high: float, taken: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """What is left of low..high without the taken intervals."""
    left: list[tuple[float, float]] = []
    at = low
    for begin, end in sorted(taken):
        if begin > at:
            left.append((at, min(begin, high)))
        at = max(at, end)
        if at >= high:
            break
    if at < high:
        left.append((at, high))
    return [(a, b) for a, b in left if b - a >= 0]
