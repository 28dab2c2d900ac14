"""Where the nodes of a script stand, and the priorities on its pipes. Pure, but for Qt's values.

Situations stand in precedence from top to bottom, everything else near what it belongs to when it
is shown first, and there from then on; in the measures of mockups/script-light.png; nothing lies on
anything.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence

from PySide6.QtCore import QRectF

from situ.document.spds import Situation
from situ_studio.canvas.script_faces import LINE, PITCH, TALL, TOP
from situ_studio.canvas.script_rows import Shape, Shapes
from situ_studio.canvas.space import Box, Boxes

GAP = 20.0
"""Between one row of situations and the next."""
GRID = 4.0
BETWEEN = 10.0
"""Between a situation's condition and what ends it."""


class Tier:
    """The row of one situation: where its condition, what ends it and itself stand."""

    __slots__ = ("condition", "height", "situation", "top", "until")

    def __init__(self, situation: Situation, first: Shape, second: Shape, top: float) -> None:
        self.top = top
        card = situation_height(situation)
        high = condition_height(len(first.rows)) if first.rows else 0.0
        low = condition_height(len(second.rows)) if second.rows else 0.0
        # Its strip says that it ends the situation, and what joins its lines.
        low += 8.0 if second.joint else 0.0
        beside = max(high, card) if high or not low else max(low, card)
        self.condition = (top + (beside - high) / 2, high)
        self.situation = (top + (beside - card) / 2, card)
        self.until = (top + (beside + BETWEEN if high else (beside - low) / 2), low)
        bottom = max(self.condition[0] + high, self.situation[0] + card)
        if low:
            bottom = max(bottom, self.until[0] + low)
        self.height = max(bottom - top + GAP, PITCH)


def situation_height(situation: Situation) -> float:
    told = bool(situation.extends) or (
        situation.condition is None or not situation.condition.children
    )
    timed = situation.dwell is not None or situation.limit is not None
    return TALL + 16 if told and timed else TALL


def condition_height(lines: int) -> float:
    return max(TALL, 16 + LINE * lines)


def tiers(situations: Iterable[Situation], shapes: Shapes) -> list[Tier]:
    made: list[Tier] = []
    top = TOP
    for situation in situations:
        tier = Tier(situation, shapes.of(situation.condition), shapes.of(situation.until), top)
        made.append(tier)
        top += tier.height
    return made


def spread(
    wanted: Sequence[tuple[str, float]], pitch: float, in_rows: bool = False
) -> dict[str, float]:
    """Tops as near as can be to what is wanted, in that order, at least ``pitch`` apart, none above
    ``TOP``. Those that want one place stand round it; in_rows: whole pitches below ``TOP``."""
    order = sorted(enumerate(wanted), key=lambda one: (one[1][1], one[0]))
    # Blocks of neighbours that touch; each stands where all in it are nearest to what they want.
    blocks: list[tuple[float, list[str]]] = []
    for _, (name, top) in order:
        at, names = max(top, TOP), [name]
        while blocks and blocks[-1][0] + pitch * len(blocks[-1][1]) > at:
            before, others = blocks.pop()
            count, more = len(others), len(names)
            mean = (before * count + (at - pitch * count) * more) / (count + more)
            at, names = max(mean, TOP), others + names
        blocks.append((at, names))
    # Not to the px: where one thing moves a little, the others stay.
    step = pitch if in_rows else GRID
    blocks = [(TOP + round((at - TOP) / step) * step, names) for at, names in blocks]
    return {name: at + pitch * i for at, names in blocks for i, name in enumerate(names)}


class Columns:
    """Where data, modules and resources stand in one drawing of a script, while it is shown.

    A card keeps its place whatever is typed or drawn. One that comes as another goes, as by another
    name, takes its place, and one that comes back has the place that it had; any other that is new
    goes to the free place nearest to what it belongs to. A column without cards is arranged as a
    whole.
    """

    def __init__(self) -> None:
        self._shown: dict[str, dict[str, float]] = {}
        self._known: dict[str, dict[str, float]] = {}

    def like(self, other: Columns) -> None:
        """The places of another drawing."""
        self._shown, self._known = dict(other._shown), dict(other._known)

    def place(
        self,
        kind: str,
        names: Sequence[str],
        wanted: Callable[[str], float | None],
        pitch: float,
        in_rows: bool = False,
    ) -> dict[str, float]:
        """The tops of a column's cards. wanted: where one that is new belongs, None below all."""
        before, known = self._shown.get(kind), self._known.get(kind, {})
        if before:
            tops = {name: before[name] for name in names if name in before}
            left = [top for name, top in before.items() if name not in tops]
        else:
            at = {name: wanted(name) for name in names}
            tops = spread([(n, y) for n, y in at.items() if y is not None], pitch, in_rows)
            left = []
        step = pitch if in_rows else GRID
        for name in names:
            if name not in tops:
                if name in known:
                    near: float | None = known[name]
                else:
                    near = left.pop(0) if left else wanted(name)
                tops[name] = _free(near, tops.values(), pitch, step)
        self._shown[kind], self._known[kind] = tops, {**known, **tops}
        return tops


def _free(near: float | None, taken: Iterable[float], pitch: float, step: float) -> float:
    """The top nearest to ``near``, else below all, that is a pitch away from those taken."""
    others = sorted(taken)
    if near is None:
        return others[-1] + pitch if others else TOP
    at = TOP + round((max(near, TOP) - TOP) / step) * step
    beside = (top + way for top in others for way in (pitch, -pitch))
    every = sorted((top for top in (at, *beside) if top >= TOP), key=lambda top: abs(top - at))
    return next(t for t in every if all(abs(t - other) >= pitch for other in others))


class Pills:
    """Where priorities stand on their pipes: on none of the others, as far as there is room."""

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        self._areas: dict[Hashable, Box] = {}
        self._ground: Boxes[Hashable] = Boxes()

    def remove(self, key: Hashable) -> None:
        area = self._areas.pop(key, None)
        if area is not None:
            self._ground.remove(key, area)

    def put(self, key: Hashable, area: QRectF) -> None:
        self.remove(key)
        box = self._areas[key] = Box(area.left(), area.top(), area.right(), area.bottom())
        self._ground.add(key, box)

    def is_free(self, area: QRectF) -> bool:
        left, top = area.left(), area.top()
        return self._ground.is_free(left - 3, top - 2, area.right() + 3, area.bottom() + 2)
