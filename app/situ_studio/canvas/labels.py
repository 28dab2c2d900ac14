"""Where labels of pipes stand: on free stretches, not on cards, labels or other pipes. Pure."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from situ_studio.canvas.space import FAR, Box, Boxes, Line, Lines, Pipe, PipeId, Point, segments
from situ_studio.canvas.ways import Ways

SHORT = 84.0
"""The width that a label may be shortened to."""


class Labels:
    """The labels of one drawing, and what joins pipes at a dot, which labels leave free."""

    def __init__(self, ways: Ways) -> None:
        self._ways = ways
        self._taken: Boxes[PipeId] = Boxes()
        self._boxes: dict[PipeId, Box] = {}
        self._level, self._upright = Lines(), Lines()
        self._stubs: dict[PipeId, list[tuple[Lines, Line]]] = {}

    def put_stub(self, pipe: Pipe, points: Sequence[Point]) -> None:
        for horizontal, at, low, high in segments(points):
            lines = self._level if horizontal else self._upright
            line = Line(at, low, high, pipe.target, pipe.id)
            lines.add(line)
            self._stubs.setdefault(pipe.id, []).append((lines, line))

    def forget(self, pipe: PipeId) -> None:
        """The pipe's label and stub are free again."""
        self.take_up(pipe)
        for lines, line in self._stubs.pop(pipe, ()):
            lines.remove(line)

    def take_up(self, pipe: PipeId) -> None:
        """The label's place is free again."""
        box = self._boxes.pop(pipe, None)
        if box is not None:
            self._taken.remove(pipe, box)

    def under(self, points: Sequence[Point]) -> set[PipeId]:
        """The pipes over whose labels this way runs."""
        found: set[PipeId] = set()
        for horizontal, at, low, high in segments(points):
            area = (low, at - 1, high, at + 1) if horizontal else (at - 1, low, at + 1, high)
            found.update(pipe for pipe, _ in self._taken.near(*area))
        return found

    def on(self, box: Box) -> set[PipeId]:
        """The pipes whose labels lie on a card that is there now."""
        return {pipe for pipe, _ in self._taken.near(*box)}

    def place(self, pipe: Pipe, points: Sequence[Point]) -> tuple[Point, float] | None:
        """A label's centre and width: whole on a horizontal, else shortened there, else whole
        across a vertical; None where there is no room. It is taken from then on."""
        spot, width = self._along(pipe, points, pipe.width), pipe.width
        if spot is None and pipe.width > SHORT:
            spot, width = self._along(pipe, points, SHORT), SHORT
        if spot is None:
            spot, width = self._across(pipe, points), pipe.width
        if spot is None:
            return None
        half, tall = width / 2 + 6, pipe.height / 2 + 1
        x, y = spot
        box = Box(x - half, y - tall, x + half, y + tall)
        self._boxes[pipe.id] = box
        self._taken.add(pipe.id, box)
        return spot, width

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
        ways = self._ways
        if ways.space.near(*area) or ways.chips.near(*area) or self._taken.near(*area):
            return FAR
        cost = 0.0
        for lines in (ways.upright, self._upright):
            for line in lines.between(x - half, x + half, y - tall, y + tall):
                cost += 100.0 if line.pipe != pipe.id else 0.0
        for lines in (ways.level, self._level):
            for line in lines.between(y - tall, y + tall, x - half, x + half):
                cost += 100.0 if line.pipe != pipe.id else 0.0
        return cost
