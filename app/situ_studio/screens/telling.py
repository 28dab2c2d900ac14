"""Where components lie after they were moved or resized, in words for whoever does not see it."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from situ.document import rbd
from situ_studio.screens import marks, placing
from situ_studio.screens.accessible import called
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.placing import box_of
from situ_studio.wording.language import tr

SAME = 0.05
"""Percent of the screen: what lies apart by less lies level."""


def told_placed(screen: rbd.Screen, ids: Collection[str], device: Device = USUAL) -> str:
    """How far they are from the left and the top, how large, and what they are level with."""
    moved = [one for one in screen.components if one.id in ids]
    if not moved:
        return ""
    box = placing.around(map(box_of, moved))
    where = tr("{0} % from the left, {1} % from the top").format(f"{box.x:g}", f"{box.y:g}")
    others = [(called(one), box_of(one)) for one in screen.components if one.id not in ids]
    across = _level(
        (box.x, box.right),
        [(name, it.x, it.right) for name, it in others],
        tr("at the left edge of the screen"),
        tr("at the right edge of the screen"),
        tr("in the middle of the screen, across"),
        tr("left edge level with {0}"),
        tr("right edge level with {0}"),
        tr("middle level with {0}, across"),
    )
    down = _level(
        (box.y, box.bottom),
        [(name, it.y, it.bottom) for name, it in others],
        tr("at the upper edge of the screen"),
        tr("at the lower edge of the screen"),
        tr("in the middle of the screen, up and down"),
        tr("upper edge level with {0}"),
        tr("lower edge level with {0}"),
        tr("middle level with {0}, up and down"),
    )
    return "; ".join([where, marks.measured(box, moved, device), *filter(None, (across, down))])


def _level(
    placed: tuple[float, float], others: Iterable[tuple[str, float, float]], *words: str
) -> str:
    """What the edges or the middle of something are level with, the screen's own before others;
    nothing where there is none. placed: from where to where it goes one way. words: for the
    screen's edges and middle, and then those of others.
    """
    screen, theirs = words[:3], words[3:]
    for name, low, high in (("", 0.0, 100.0), *others):
        ways = zip(_lines(*placed), _lines(low, high), theirs if name else screen, strict=True)
        for line, other, told in ways:
            if abs(line - other) < SAME:
                return told.format(name)
    return ""


def _lines(low: float, high: float) -> tuple[float, float, float]:
    return low, high, (low + high) / 2
