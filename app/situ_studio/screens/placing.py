"""Where components lie: moving, resizing and aligning them, without Qt.

All lengths are percent of the robot's screen (formats.md, *Screen*), with two decimals at most.
What comes out of here lies on the screen, whatever went in.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import NamedTuple

from msgspec.structs import replace

from situ.document import rbd

LEAST = 2.0
"""A component is resized no smaller than this, either way."""
GRID = 1.0
NEAR = 1.0
"""An edge or a middle nearer than this to another's is put there."""
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


class Snap(NamedTuple):
    """A shift of ``dx`` and ``dy``, and the guides that it lies on: x of upright ones, y of
    lying ones.
    """

    dx: float
    dy: float
    upright: tuple[float, ...] = ()
    lying: tuple[float, ...] = ()


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


def moved(boxes: Mapping[str, Box], dx: float, dy: float) -> dict[str, Box]:
    """All of these shifted together, as far as the screen goes: their distances stay."""
    if not boxes:
        return {}
    all_ = around(boxes.values())
    dx = max(-all_.x, min(dx, 100.0 - all_.right))
    dy = max(-all_.y, min(dy, 100.0 - all_.bottom))
    return {id: inside(b._replace(x=b.x + dx, y=b.y + dy)) for id, b in boxes.items()}


def resized(box: Box, handle: str, dx: float, dy: float) -> Box:
    """The box with the edges of ``handle`` shifted; the opposite ones stay."""
    left, top, right, bottom = box.x, box.y, box.right, box.bottom
    if "w" in handle:
        left = max(0.0, min(left + dx, right - LEAST))
    if "e" in handle:
        right = min(100.0, max(right + dx, left + LEAST))
    if "n" in handle:
        top = max(0.0, min(top + dy, bottom - LEAST))
    if "s" in handle:
        bottom = min(100.0, max(bottom + dy, top + LEAST))
    return inside(Box(left, top, right - left, bottom - top))


def snapped(
    box: Box, others: Collection[Box], dx: float, dy: float, handle: str = "nesw", move: bool = True
) -> Snap:
    """The shift nearest to this one that puts an edge or the middle on a guide, else on the grid.

    Guides are the edges and middles of ``others`` and of the screen. handle: the edges that go;
    move: all of it goes, so that its middle counts too.
    """
    xs = [0.0, 50.0, 100.0, *(v for b in others for v in (b.x, b.x + b.width / 2, b.right))]
    ys = [0.0, 50.0, 100.0, *(v for b in others for v in (b.y, b.y + b.height / 2, b.bottom))]
    own_x = [v for letter, v in (("w", box.x), ("e", box.right)) if letter in handle]
    own_y = [v for letter, v in (("n", box.y), ("s", box.bottom)) if letter in handle]
    if move:
        own_x.append(box.x + box.width / 2)
        own_y.append(box.y + box.height / 2)
    dx, upright = _snapped(own_x, xs, dx)
    dy, lying = _snapped(own_y, ys, dy)
    return Snap(dx, dy, upright, lying)


def _snapped(own: list[float], guides: list[float], by: float) -> tuple[float, tuple[float, ...]]:
    if not own:
        return 0.0, ()
    pull = min((g - v - by for v in own for g in guides), key=abs)
    if abs(pull) > NEAR:
        return round((own[0] + by) / GRID) * GRID - own[0], ()
    by += pull
    met = {round(g, 2) for v in own for g in guides if abs(v + by - g) < 0.005}
    return by, tuple(sorted(met))


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
