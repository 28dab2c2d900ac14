"""Cards as they were painted last, in px of the screen: a frame need not paint them anew."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from math import ceil, floor
from typing import NamedTuple

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPixmap, Qt, QTransform

MOST = 64 * 2**20
"""Bytes kept for one canvas: twice what a window of 4K shows."""


def by_pixels(to_screen: QTransform, world: QTransform) -> QTransform:
    """What takes the place of a painter's ``world`` so that its units are px of the screen.

    to_screen: the painter's ``deviceTransform``, that scales both ways alike and turns nothing.
    """
    ratio = to_screen.m11() / world.m11()
    left, top = to_screen.dx() / ratio - world.dx(), to_screen.dy() / ratio - world.dy()
    return QTransform(1 / ratio, 0.0, 0.0, 1 / ratio, -left, -top)


class _Kept(NamedTuple):
    value: object
    state: Hashable
    zoom: float
    picture: QPixmap | None
    left: int
    top: int
    size: int


class Pictures:
    """One picture a name, at most ``most`` bytes in all; what was not painted for longest goes.

    A picture lies on whole px of the screen, so it is as sharp as what is painted directly. It
    is made when the same is painted for the second time: zooming makes none.
    """

    def __init__(self, most: int = MOST) -> None:
        self.bytes = 0
        self._most = most
        self._kept: OrderedDict[str, _Kept] = OrderedDict()

    def paint(
        self,
        painter: QPainter,
        name: str,
        value: object,
        state: Hashable,
        room: QRectF,
        draw: Callable[[QPainter], None],
    ) -> None:
        """What ``draw`` draws into ``room``, from the picture where there is one of the same.

        value: what is shown, the same while it is the very object. state: all else that the
        looks depend on.
        """
        to_screen = painter.deviceTransform()
        zoom = to_screen.m11()
        kept = self._kept.get(name)
        if kept is None or (kept.value is not value or kept.state != state or kept.zoom != zoom):
            self._keep(name, _Kept(value, state, zoom, None, 0, 0, 0))
            draw(painter)
            return
        if kept.picture is None:
            kept = self._made(kept, room, painter.renderHints(), draw)
            self._keep(name, kept)
        assert kept.picture is not None
        self._kept.move_to_end(name)
        world = painter.worldTransform()
        painter.setWorldTransform(by_pixels(to_screen, world), False)
        painter.drawPixmap(
            round(to_screen.dx()) + kept.left, round(to_screen.dy()) + kept.top, kept.picture
        )
        painter.setWorldTransform(world, False)

    @staticmethod
    def _made(
        kept: _Kept,
        room: QRectF,
        hints: QPainter.RenderHint,
        draw: Callable[[QPainter], None],
    ) -> _Kept:
        zoom = kept.zoom
        left, top = floor(room.left() * zoom), floor(room.top() * zoom)
        wide, high = ceil(room.right() * zoom) - left, ceil(room.bottom() * zoom) - top
        picture = QPixmap(wide, high)
        picture.fill(Qt.GlobalColor.transparent)
        painter = QPainter(picture)
        painter.setRenderHints(hints)
        painter.translate(-left, -top)
        painter.scale(zoom, zoom)
        draw(painter)
        painter.end()
        return kept._replace(picture=picture, left=left, top=top, size=4 * wide * high)

    def _keep(self, name: str, kept: _Kept) -> None:
        before = self._kept.pop(name, None)
        self.bytes += kept.size - (before.size if before is not None else 0)
        self._kept[name] = kept
        while self.bytes > self._most and len(self._kept) > 1:
            _, gone = self._kept.popitem(last=False)
            self.bytes -= gone.size
