"""What a drag of the mouse does with components: move, resize, or select by a rubber band.

Each is made where the mouse is pressed, and says at any moment what it would be if the mouse were
let go. Pure, no Qt; lengths are percent of the robot's screen.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import NamedTuple

from situ_studio.screens import placing, snapping
from situ_studio.screens.guides import Guide
from situ_studio.screens.placing import Box
from situ_studio.screens.snapping import Gap, Snap


class Held(NamedTuple):
    """The keys that are held. free: nothing is snapped; straight: along one axis, or in
    proportion.
    """

    free: bool = False
    straight: bool = False


class Proposal(NamedTuple):
    """Where components would lie, the guides that they lie on, and how far they are from others."""

    boxes: Mapping[str, Box]
    snap: Snap = Snap(0, 0)
    gaps: tuple[Gap, ...] = ()


class Moving:
    """Components go with the mouse, all by the same way. others: what stays."""

    def __init__(
        self, boxes: Mapping[str, Box], others: Collection[Box], guides: Collection[Guide] = ()
    ) -> None:
        self._boxes, self._others, self._guides = boxes, others, guides

    def at(self, dx: float, dy: float, held: Held) -> Proposal:
        if held.straight:
            dx, dy = (dx, 0.0) if abs(dx) >= abs(dy) else (0.0, dy)
        snap = Snap(dx, dy)
        if not held.free:
            whole = placing.around(self._boxes.values())
            snap = snapping.snapped(whole, self._others, dx, dy, guides=self._guides)
            if held.straight:
                snap = snap._replace(dy=0.0, lying=()) if dx else snap._replace(dx=0.0, upright=())
        made = placing.moved(self._boxes, snap.dx, snap.dy)
        return Proposal(made, snap, _gaps(made, self._others, held))


class Resizing:
    """Edges of components, or of what covers several, go with the mouse."""

    def __init__(
        self,
        boxes: Mapping[str, Box],
        others: Collection[Box],
        handle: str,
        guides: Collection[Guide] = (),
    ) -> None:
        self._boxes, self._others, self._handle, self._guides = boxes, others, handle, guides

    def at(self, dx: float, dy: float, held: Held) -> Proposal:
        snap = Snap(dx, dy)
        if not held.free and not held.straight:
            whole = placing.around(self._boxes.values())
            snap = snapping.snapped(
                whole, self._others, dx, dy, self._handle, move=False, guides=self._guides
            )
        made = placing.resized(self._boxes, self._handle, snap.dx, snap.dy, held.straight)
        return Proposal(made, snap, _gaps(made, self._others, held))


def _gaps(boxes: Mapping[str, Box], others: Collection[Box], held: Held) -> tuple[Gap, ...]:
    return () if held.free else snapping.gaps(placing.around(boxes.values()), others)


class Banding:
    """A rubber band from ``x``, ``y``: what it touches is selected, beside what was before.

    before: the ids that stay selected.
    """

    def __init__(self, x: float, y: float, before: tuple[str, ...] = ()) -> None:
        self._x, self._y, self._before = x, y, before
        self.box = Box(x, y, 0.0, 0.0)

    def at(self, x: float, y: float, boxes: Mapping[str, Box]) -> tuple[str, ...]:
        """The ids that are selected with the mouse there. boxes: of all components."""
        left, top = min(x, self._x), min(y, self._y)
        self.box = Box(left, top, abs(x - self._x), abs(y - self._y))
        band = self.box
        touched = (
            id
            for id, b in boxes.items()
            if b.x <= band.right and b.right >= band.x and b.y <= band.bottom and b.bottom >= band.y
        )
        return (*self._before, *(id for id in touched if id not in self._before))
