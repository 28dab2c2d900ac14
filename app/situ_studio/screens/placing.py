"""Where components lie: moving, resizing and aligning them, without Qt.

All lengths are percent of the robot's screen (formats.md, *Screen*), with two decimals at most.
What comes out of here lies on the screen, whatever went in.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from msgspec.structs import replace

from situ.document import rbd

LEAST = 2.0
"""A component is resized no smaller than this, either way."""
MOST = 5000.0
"""Half of the screen, in square percent."""
HANDLES = ("nw", "n", "ne", "e", "se", "s", "sw", "w")


class Box(NamedTuple):
    """What a component covers."""

    x: float
    y: float
    width: float
    height: float

    @property
    def right(self) -> float:
        return self.x + self.width

    @property
    def bottom(self) -> float:
        return self.y + self.height


def box_of(component: rbd.Component) -> Box:
    return Box(component.x, component.y, component.width, component.height)


def around(boxes: Iterable[Box]) -> Box:
    """The smallest that covers all of these, at least one."""
    every = list(boxes)
    x, y = min(b.x for b in every), min(b.y for b in every)
    return Box(x, y, max(b.right for b in every) - x, max(b.bottom for b in every) - y)


def inside(box: Box) -> Box:
    """The box of that size which lies on the screen; a larger one is as large as the screen."""
    width = round(min(max(box.width, 0.01), 100.0), 2)
    height = round(min(max(box.height, 0.01), 100.0), 2)
    x = round(min(max(box.x, 0.0), 100.0 - width), 2)
    y = round(min(max(box.y, 0.0), 100.0 - height), 2)
    return Box(x, y, width, height)


def centred(box: Box, x: float, y: float) -> Box:
    """The box with its middle there, as near as it lies on the screen."""
    return inside(box._replace(x=round(x - box.width / 2), y=round(y - box.height / 2)))


GAP = 2.5
"""What is put into free room stays so far from others: on 10 inches more than ``fitness.APART``."""


def in_free_room(box: Box, taken: Iterable[Box], beside: bool = False) -> Box:
    """The box where it lies on none of these, with GAP between where that can be; its own place
    where no room is free.

    Above or below its own place sooner than beside it; ``beside``: the other way round, and to the
    right sooner than to the left, as answers stand.

    What covers half of the screen is the ground that others lie on, and takes no room.
    """
    box = inside(box)
    others = [one for one in taken if one.width * one.height < MOST]
    free = (spot for gap in (GAP, 0.0) for spot in _spots(box, others, gap, beside))
    return next(free, box)


def _spots(box: Box, others: Sequence[Box], gap: float, beside: bool) -> Iterator[Box]:
    """Where the box is free at its own place or flush with others, the nearest first."""
    across = {box.x, *(one.x for one in others), *(one.right + gap for one in others)}
    if beside:
        across |= {one.x - gap - box.width for one in others}
    down = {box.y, *(one.bottom + gap for one in others)}
    down |= {one.y - gap - box.height for one in others}
    every = [box._replace(x=round(x, 2), y=round(y, 2)) for x in across for y in down]
    if beside:
        every.sort(key=lambda one: (abs(one.y - box.y), abs(one.x - box.x), -one.x, one.y))
    else:
        every.sort(key=lambda one: (abs(one.x - box.x), abs(one.y - box.y), -one.y, one.x))
    for spot in every:
        if spot == inside(spot) and not any(_near(spot, one, gap) for one in others):
            yield spot


def _near(one: Box, other: Box, gap: float) -> bool:
    """Whether there is less than the gap between them; a rounding is none."""
    gap -= 0.02
    return (
        one.x < other.right + gap
        and other.x < one.right + gap
        and one.y < other.bottom + gap
        and other.y < one.bottom + gap
    )


def shaped(box: Box, proportion: float) -> Box:
    """The largest within the box, about its middle, that is so many times as wide as high, each in
    percent of its side of the screen.
    """
    width = min(box.width, box.height * proportion)
    height = min(box.height, box.width / proportion)
    x, y = box.x + (box.width - width) / 2, box.y + (box.height - height) / 2
    return inside(Box(x, y, width, height))


def moved(boxes: Mapping[str, Box], dx: float, dy: float) -> dict[str, Box]:
    """All of these shifted together, as far as the screen goes: their distances stay."""
    if not boxes:
        return {}
    all_ = around(boxes.values())
    dx = max(-all_.x, min(dx, 100.0 - all_.right))
    dy = max(-all_.y, min(dy, 100.0 - all_.bottom))
    return {id: inside(b._replace(x=b.x + dx, y=b.y + dy)) for id, b in boxes.items()}


def resized(
    boxes: Mapping[str, Box], handle: str, dx: float, dy: float, keep: bool = False
) -> dict[str, Box]:
    """All of these with the edges of ``handle`` shifted; the opposite ones stay.

    Several grow and shrink together, about what covers them all, with the distances between them.
    keep: width and height stay in proportion; one that the handle does not shift grows and shrinks
    about its middle.
    """
    if not boxes:
        return {}
    boxes = {id: inside(b) for id, b in boxes.items()}
    old = around(boxes.values())
    # None becomes smaller than LEAST; one that is so already does not become smaller still.
    least_x = old.width * max(min(1.0, LEAST / b.width) for b in boxes.values())
    least_y = old.height * max(min(1.0, LEAST / b.height) for b in boxes.values())
    if keep:
        new = _in_proportion(old, handle, dx, dy, max(least_x / old.width, least_y / old.height))
    else:
        new = _shifted(old, handle, dx, dy, least_x, least_y)
    across, down = new.width / old.width, new.height / old.height
    return {
        id: inside(
            Box(
                new.x + (b.x - old.x) * across,
                new.y + (b.y - old.y) * down,
                b.width * across,
                b.height * down,
            )
        )
        for id, b in boxes.items()
    }


def _shifted(box: Box, handle: str, dx: float, dy: float, least_x: float, least_y: float) -> Box:
    left, top, right, bottom = box.x, box.y, box.right, box.bottom
    if "w" in handle:
        left = max(0.0, min(left + dx, right - least_x))
    if "e" in handle:
        right = min(100.0, max(right + dx, left + least_x))
    if "n" in handle:
        top = max(0.0, min(top + dy, bottom - least_y))
    if "s" in handle:
        bottom = min(100.0, max(bottom + dy, top + least_y))
    return Box(left, top, right - left, bottom - top)


def _in_proportion(box: Box, handle: str, dx: float, dy: float, least: float) -> Box:
    """least: the smallest factor."""
    wanted, room = [], []
    if "w" in handle or "e" in handle:
        wanted.append(1 + (dx if "e" in handle else -dx) / box.width)
        room.append(((100 - box.x) if "e" in handle else box.right) / box.width)
    else:
        middle = box.x + box.width / 2
        room.append(2 * min(middle, 100 - middle) / box.width)
    if "n" in handle or "s" in handle:
        wanted.append(1 + (dy if "s" in handle else -dy) / box.height)
        room.append(((100 - box.y) if "s" in handle else box.bottom) / box.height)
    else:
        middle = box.y + box.height / 2
        room.append(2 * min(middle, 100 - middle) / box.height)
    factor = max(wanted, key=lambda one: abs(one - 1))
    factor = max(least, min(factor, *room))
    width, height = box.width * factor, box.height * factor
    x = box.x if "e" in handle else box.right - width
    y = box.y if "s" in handle else box.bottom - height
    if not {"w", "e"} & set(handle):
        x = box.x + (box.width - width) / 2
    if not {"n", "s"} & set(handle):
        y = box.y + (box.height - height) / 2
    return Box(x, y, width, height)


def aligned(boxes: Mapping[str, Box], edge: str) -> dict[str, Box]:
    """edge: left, center, right, top, middle, bottom; or across, down: spaced evenly.

    Two or more are aligned among themselves, a single one with the screen.
    """
    if not boxes:
        return {}
    all_ = around(boxes.values()) if len(boxes) > 1 else Box(0, 0, 100, 100)
    if edge in ("across", "down"):
        return _spread(boxes, all_, edge == "across")
    made = {}
    for id, b in boxes.items():
        x = {
            "left": all_.x,
            "center": all_.x + (all_.width - b.width) / 2,
            "right": all_.right - b.width,
        }
        y = {
            "top": all_.y,
            "middle": all_.y + (all_.height - b.height) / 2,
            "bottom": all_.bottom - b.height,
        }
        made[id] = inside(b._replace(x=x.get(edge, b.x), y=y.get(edge, b.y)))
    return made


def _spread(boxes: Mapping[str, Box], all_: Box, across: bool) -> dict[str, Box]:
    """The same gap between each two; nothing where there are fewer than three."""
    if len(boxes) < 3:
        return {id: inside(b) for id, b in boxes.items()}
    size, start = (2, 0) if across else (3, 1)
    order = sorted(boxes, key=lambda id: boxes[id][start])
    gap = (all_[size] - sum(boxes[id][size] for id in order)) / (len(order) - 1)
    made, at = {}, all_[start]
    for id in order:
        box = boxes[id]
        made[id] = inside(box._replace(x=at) if across else box._replace(y=at))
        at += box[size] + gap
    return made


def placed(screen: rbd.Screen, boxes: Mapping[str, Box]) -> rbd.Screen:
    """The screen with these of its components there; the very same where nothing moves."""
    components = tuple(
        replace(c, **boxes[c.id]._asdict()) if boxes.get(c.id, box_of(c)) != box_of(c) else c
        for c in screen.components
    )
    if all(new is old for new, old in zip(components, screen.components, strict=True)):
        return screen
    return replace(screen, components=components)


def without(screen: rbd.Screen, ids: Collection[str]) -> rbd.Screen:
    """The screen without these components."""
    return replace(screen, components=tuple(c for c in screen.components if c.id not in ids))
