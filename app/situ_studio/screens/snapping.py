"""Where the edges of a component are drawn to while it is dragged, and how far it is from others.

Pure, no Qt. All lengths are percent of the robot's screen, as in ``placing``.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

from situ_studio.screens.guides import Axis, Guide
from situ_studio.screens.placing import Box

GRID = 1.0
NEAR = 1.0
"""An edge or a middle nearer than this to another's is put there."""
SAME = 0.05
"""Two gaps that differ by less are even."""


class Snap(NamedTuple):
    """A shift of ``dx`` and ``dy``, and the guides that it lies on: x of upright ones, y of
    lying ones.
    """

    dx: float
    dy: float
    upright: tuple[float, ...] = ()
    lying: tuple[float, ...] = ()


class Gap(NamedTuple):
    """What is free from ``start`` to ``end`` of one axis, at ``at`` of the other.

    across: along x. even: it is as long as another one of the same row or column.
    """

    across: bool
    start: float
    end: float
    at: float
    even: bool = False

    @property
    def length(self) -> float:
        return self.end - self.start


def snapped(
    box: Box,
    others: Collection[Box],
    dx: float,
    dy: float,
    handle: str = "nesw",
    move: bool = True,
    guides: Collection[Guide] = (),
) -> Snap:
    """The shift nearest to this one that puts an edge or the middle on a guide, else leaves the
    gaps beside it even, else puts it on the grid.

    Guides are the edges and middles of ``others`` and of the screen, and those that a person has
    put there. handle: the edges that go;
    move: all of it goes, so that its middle counts too, and its gaps.
    """
    xs = [*_lines("x", others), *(one.at for one in guides if one.axis == "x")]
    ys = [*_lines("y", others), *(one.at for one in guides if one.axis == "y")]
    own_x = [v for letter, v in (("w", box.x), ("e", box.right)) if letter in handle]
    own_y = [v for letter, v in (("n", box.y), ("s", box.bottom)) if letter in handle]
    if move:
        own_x.append(box.x + box.width / 2)
        own_y.append(box.y + box.height / 2)
    to_x, upright = _on_guide(own_x, xs, dx)
    to_y, lying = _on_guide(own_y, ys, dy)
    if move:
        if not upright:
            shifted = box._replace(y=box.y + to_y)
            to_x = _even(_lying(shifted), [_lying(b) for b in others], dx, to_x)
        if not lying:
            shifted = box._replace(x=box.x + to_x)
            to_y = _even(_upright(shifted), [_upright(b) for b in others], dy, to_y)
    return Snap(to_x, to_y, upright, lying)


def guided(axis: Axis, at: float, boxes: Collection[Box]) -> float:
    """Where a guide goes that is dragged there: on an edge or a middle, else on the grid."""
    by, _ = _on_guide([at], _lines(axis, boxes), 0.0)
    return at + by


def _lines(axis: Axis, boxes: Collection[Box]) -> list[float]:
    """The edges and middles of the screen and of these, across one axis."""
    if axis == "x":
        return [0.0, 50.0, 100.0, *(v for b in boxes for v in (b.x, b.x + b.width / 2, b.right))]
    return [0.0, 50.0, 100.0, *(v for b in boxes for v in (b.y, b.y + b.height / 2, b.bottom))]


def _on_guide(own: list[float], guides: list[float], by: float) -> tuple[float, tuple[float, ...]]:
    if not own:
        return 0.0, ()
    pull = min((g - v - by for v in own for g in guides), key=abs)
    if abs(pull) > NEAR:
        return round((own[0] + by) / GRID) * GRID - own[0], ()
    by += pull
    met = {round(g, 2) for v in own for g in guides if abs(v + by - g) < 0.005}
    return by, tuple(sorted(met))


class _Span(NamedTuple):
    """A box along one axis, from ``start`` to ``end``, and what it covers of the other."""

    start: float
    end: float
    low: float
    high: float

    def meets(self, other: _Span) -> bool:
        """Whether both stand in one row or column."""
        return self.low < other.high and other.low < self.high


def _lying(box: Box) -> _Span:
    return _Span(box.x, box.right, box.y, box.bottom)


def _upright(box: Box) -> _Span:
    return _Span(box.y, box.bottom, box.x, box.right)


def _row(own: _Span, others: Collection[_Span]) -> tuple[float, float, list[tuple[float, float]]]:
    """Of what stands in one row with it: how far it is free before and behind, and the gaps
    elsewhere in the row, the margins of the screen among them.
    """
    row = sorted(o for o in others if o.meets(own))
    middle = (own.start + own.end) / 2
    before = max((o.end for o in row if (o.start + o.end) / 2 <= middle), default=0.0)
    behind = min((o.start for o in row if (o.start + o.end) / 2 > middle), default=100.0)
    gaps: list[tuple[float, float]] = []
    reached = 0.0
    for start, end in [*((o.start, o.end) for o in row), (100.0, 100.0)]:
        if start > reached + SAME and not (reached <= middle <= start):
            gaps.append((reached, start))
        reached = max(reached, end)
    return before, behind, gaps


def _even(own: _Span, others: Collection[_Span], by: float, otherwise: float) -> float:
    """The shift near ``by`` that leaves even gaps; ``otherwise`` where there is none."""
    moved = own._replace(start=own.start + by, end=own.end + by)
    before, behind, gaps = _row(moved, others)
    size = own.end - own.start
    goals = [(before + behind - size) / 2]
    for start, end in gaps:
        goals += [before + end - start, behind - (end - start) - size]
    near = [g - own.start for g in goals if g >= before and g + size <= behind]
    best = min(near, key=lambda shift: abs(shift - by), default=otherwise)
    return best if abs(best - by) <= NEAR else otherwise


def gaps(box: Box, others: Collection[Box]) -> tuple[Gap, ...]:
    """How far a box is from its neighbours on all four sides, or from the edge of the screen, and
    the gaps in its row and its column that are as long.
    """
    found: list[Gap] = []
    for across, turn in ((True, _lying), (False, _upright)):
        own = turn(box)
        before, behind, elsewhere = _row(own, [turn(b) for b in others])
        beside = [
            (start, end)
            for start, end in ((before, own.start), (own.end, behind))
            if end - start > SAME
        ]
        lengths = [end - start for start, end in (*beside, *elsewhere)]
        at = (own.low + own.high) / 2
        for index, (start, end) in enumerate((*beside, *elsewhere)):
            alike = [
                other
                for other, length in enumerate(lengths)
                if other != index and abs(length - (end - start)) <= SAME
            ]
            # Of those elsewhere only such as are told with one beside the box.
            if index < len(beside) or any(other < len(beside) for other in alike):
                found.append(Gap(across, start, end, at, bool(alike)))
    return tuple(found)
