"""Where components lie after they were moved or resized, in words for whoever does not see it."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from situ.document import rbd
from situ_studio.language import tr
from situ_studio.screens import marks, placing
from situ_studio.screens.accessible import called
from situ_studio.screens.devices import USUAL, Device
from situ_studio.screens.placing import Box, box_of

SAME = 0.05
"""Percent of the screen: what lies apart by less lies level."""


def told_placed(screen: rbd.Screen, ids: Collection[str], device: Device = USUAL) -> str:
    """How far they are from the left and the top, how large, and what they are level with."""
    moved = [one for one in screen.components if one.id in ids]
    if not moved:
        return ""
    box = placing.around(map(box_of, moved))
    where = tr("{0} % from the left, {1} % from the top").format(f"{box.x:g}", f"{box.y:g}")
    others = [one for one in screen.components if one.id not in ids]
    level = [next(words, "") for words in (_upright(box, others), _lying(box, others))]
    return "; ".join([where, marks.measured(box, moved, device), *filter(None, level)])


def _upright(box: Box, others: Collection[rbd.Component]) -> Iterator[str]:
    """What its left, middle and right are level with, the screen's own before others."""
    if abs(box.x) < SAME:
        yield tr("at the left edge of the screen")
    if abs(box.right - 100) < SAME:
        yield tr("at the right edge of the screen")
    if abs(box.x + box.right - 100) < SAME:
        yield tr("in the middle of the screen, across")
    for other in others:
        it, name = box_of(other), called(other)
        if abs(box.x - it.x) < SAME:
            yield tr("left edge level with {0}").format(name)
        if abs(box.right - it.right) < SAME:
            yield tr("right edge level with {0}").format(name)
        if abs(box.x + box.right - it.x - it.right) < SAME:
            yield tr("middle level with {0}, across").format(name)


def _lying(box: Box, others: Collection[rbd.Component]) -> Iterator[str]:
    """The same of its top, middle and bottom."""
    if abs(box.y) < SAME:
        yield tr("at the upper edge of the screen")
    if abs(box.bottom - 100) < SAME:
        yield tr("at the lower edge of the screen")
    if abs(box.y + box.bottom - 100) < SAME:
        yield tr("in the middle of the screen, up and down")
    for other in others:
        it, name = box_of(other), called(other)
        if abs(box.y - it.y) < SAME:
            yield tr("upper edge level with {0}").format(name)
        if abs(box.bottom - it.bottom) < SAME:
            yield tr("lower edge level with {0}").format(name)
        if abs(box.y + box.bottom - it.y - it.bottom) < SAME:
            yield tr("middle level with {0}, up and down").format(name)
