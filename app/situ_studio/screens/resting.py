"""What rests on a screen while components are moved: painted once, before and behind them."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPixmap

from situ_studio.screens.painting import paint_content
from situ_studio.screens.shown import Content


class Resting:
    """For one drag that changes no sizes, from which those of letters follow.

    before: the screen as it is in the document; moved: the ids of its own components that go with
    the mouse; own: how many components it has itself.
    """

    def __init__(
        self,
        before: Content,
        own: int,
        moved: Collection[str],
        media: Path | None,
        device: QSize,
    ) -> None:
        at = [i for i, one in enumerate(before.components[:own]) if one["id"] in moved]
        self._first, self._behind = min(at, default=0), max(at, default=-1) + 1
        self._before, self._media, self._device = before, media, device
        self._below: QPixmap | None = None
        self._above: QPixmap | None = None
        self._painted = (QRectF(), 0.0)

    def paint(self, painter: QPainter, rect: QRectF, now: Content) -> None:
        """Paints the screen with its moved components where they are ``now``."""
        ratio = painter.device().devicePixelRatio()
        if self._painted != (rect, ratio) or self._below is None or self._above is None:
            self._painted = rect, ratio
            parts = slice(0, self._first), slice(self._behind, None)
            self._below, self._above = (self._made(rect, ratio, part) for part in parts)
        at = QPointF(0, 0)
        if self._first == 0:
            # The ground is painted with the first component.
            paint_content(painter, rect, now, self._media, self._device, slice(0, self._behind))
        else:
            painter.drawPixmap(at, self._below)
            part = slice(self._first, self._behind)
            paint_content(painter, rect, now, self._media, self._device, part)
        painter.drawPixmap(at, self._above)

    def _made(self, rect: QRectF, ratio: float, part: slice) -> QPixmap:
        whole = QSize(round(rect.right() + 1), round(rect.bottom() + 1))
        made = QPixmap(whole * ratio)
        made.setDevicePixelRatio(ratio)
        made.fill(Qt.GlobalColor.transparent)
        if part != slice(0, 0):
            painter = QPainter(made)
            paint_content(painter, rect, self._before, self._media, self._device, part)
            painter.end()
        return made
