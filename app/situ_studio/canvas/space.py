"""The ground on which pipes are routed: rectangles and drawn lines, found by cell. Pure; no Qt."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import NamedTuple

Point = tuple[float, float]
PipeId = tuple[str, ...]

CELL = 192.0
FAR = 1e6


class Box(NamedTuple):
    """A rectangle that pipes go round."""

    left: float
    top: float
    right: float
    bottom: float


class Line(NamedTuple):
    """A drawn segment: its lane, from where to where, to which card it leads, whose it is."""

    at: float
    low: float
    high: float
    target: str
    pipe: PipeId


class Boxes:
    """Rectangles with a name, found by place."""

    def __init__(self, boxes: Iterable[tuple[str, Box]] = ()) -> None:
        self._cells: dict[tuple[int, int], list[tuple[str, Box]]] = {}
        for name, box in boxes:
            self.add(name, box)

    def _of(self, box: Box) -> Iterable[tuple[int, int]]:
        for across in range(int(box.left // CELL), int(box.right // CELL) + 1):
            for down in range(int(box.top // CELL), int(box.bottom // CELL) + 1):
                yield across, down

    def add(self, name: str, box: Box) -> None:
        entry = (name, box)
        for cell in self._of(box):
            self._cells.setdefault(cell, []).append(entry)

    def remove(self, name: str, box: Box) -> None:
        entry = (name, box)
        for cell in self._of(box):
            entries = self._cells.get(cell)
            if entries is not None and entry in entries:
                entries.remove(entry)

    def near(self, left: float, top: float, right: float, bottom: float) -> list[tuple[str, Box]]:
        """Every rectangle that overlaps this area, each once."""
        found: dict[int, tuple[str, Box]] = {}
        cells = self._cells
        for across in range(int(left // CELL), int(right // CELL) + 1):
            for down in range(int(top // CELL), int(bottom // CELL) + 1):
                for entry in cells.get((across, down), ()):
                    box = entry[1]
                    if (
                        box.left < right
                        and left < box.right
                        and box.top < bottom
                        and top < box.bottom
                    ):
                        found[id(box)] = entry
        return list(found.values())


class Lines:
    """Drawn segments of one direction, found by lane."""

    def __init__(self) -> None:
        self._cells: dict[tuple[int, int], list[Line]] = {}

    def add(self, line: Line) -> None:
        lane = int(line.at // CELL)
        for along in range(int(line.low // CELL), int(line.high // CELL) + 1):
            self._cells.setdefault((lane, along), []).append(line)

    def remove(self, line: Line) -> None:
        lane = int(line.at // CELL)
        for along in range(int(line.low // CELL), int(line.high // CELL) + 1):
            cell = self._cells.get((lane, along))
            if cell is not None and line in cell:
                cell.remove(line)

    def between(self, at_low: float, at_high: float, low: float, high: float) -> list[Line]:
        """Segments whose lane lies in at_low..at_high and that overlap low..high, each once."""
        found = {}
        cells = self._cells
        for lane in range(int(at_low // CELL), int(at_high // CELL) + 1):
            for along in range(int(low // CELL), int(high // CELL) + 1):
                for line in cells.get((lane, along), ()):
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
