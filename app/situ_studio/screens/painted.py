"""A screen as it was painted last: of the next one only that is painted in which it differs."""

from __future__ import annotations

from math import ceil, floor
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPointF, QRectF, QSize
from PySide6.QtGui import QPainter, QPixmap, Qt

from situ.decide.screens import Shown
from situ_studio.screens.component_painting import Stage
from situ_studio.screens.media_pictures import picture
from situ_studio.screens.painting import FAR, clip_corners, layer, paint_stage
from situ_studio.screens.shown import Content

FEW = 12
"""Of more components that are others all of the screen is painted anew."""


class Painted:
    """One widget's. What it paints is what ``painting.paint_content`` does."""

    def __init__(self) -> None:
        self._of: tuple[Any, ...] = ()
        self._looks: list[tuple[Any, ...]] = []
        self._boxes: list[QRectF] = []
        self._picture = QPixmap()

    def paint(
        self, painter: QPainter, rect: QRectF, content: Content, media: Path | None, device: QSize
    ) -> None:
        """As ``painting.paint_content``, onto a device of the same place."""
        ratio = painter.device().devicePixelRatio()
        stage = Stage(layer(device), content, media)
        behind = picture(media, content.background or "")
        of = (rect, ratio, device, media, behind, content.language)
        looks = [_look(stage, one) for one in content.components]
        boxes = [stage.box(one) for one in content.components]
        pairs = enumerate(zip(looks, self._looks, strict=False))
        other = [at for at, (now, before) in pairs if now != before]
        if of != self._of or len(looks) != len(self._looks) or len(other) > FEW:
            size = QSize(ceil(rect.right() + 1), ceil(rect.bottom() + 1))
            self._picture = QPixmap(size * ratio)
            self._picture.setDevicePixelRatio(ratio)
            self._picture.fill(Qt.GlobalColor.transparent)
            self._paint(rect, stage, device, None)
        else:
            for at in other:
                both = self._boxes[at].united(boxes[at])
                self._paint(rect, stage, device, both.adjusted(-FAR, -FAR, FAR, FAR))
        self._of, self._looks, self._boxes = of, looks, boxes
        painter.save()
        clip_corners(painter, rect)
        painter.drawPixmap(QPointF(0, 0), self._picture)
        painter.restore()

    def _paint(self, rect: QRectF, stage: Stage, device: QSize, within: QRectF | None) -> None:
        """The screen, or what of it lies within some px of it, anew."""
        painter = QPainter(self._picture)
        if within is not None:
            across, down = rect.width() / stage.size.width(), rect.height() / stage.size.height()
            seen = QRectF(
                rect.x() + within.x() * across,
                rect.y() + within.y() * down,
                within.width() * across,
                within.height() * down,
            )
            painter.setClipRect(_whole(seen, self._picture.devicePixelRatio()))
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Clear)
            painter.fillRect(rect.adjusted(-1, -1, 1, 1), Qt.GlobalColor.black)
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceOver)
        paint_stage(painter, rect, stage, device, within=within)
        painter.end()


def _look(stage: Stage, one: Shown) -> tuple[Any, ...]:
    """All that a component's looks depend on, of itself and of the others."""
    if one["type"] in ("text", "button"):
        return one, stage.fitted(one), one is stage.first
    if one["type"] == "input":
        return one, stage.alone(one)
    return one, picture(stage.media, one.get("src") or "")


def _whole(area: QRectF, ratio: float) -> QRectF:
    """``area``, on whole px of the picture: nothing is painted half anew."""
    left, top = floor(area.left() * ratio), floor(area.top() * ratio)
    right, bottom = ceil(area.right() * ratio), ceil(area.bottom() * ratio)
    return QRectF(left / ratio, top / ratio, (right - left) / ratio, (bottom - top) / ratio)
