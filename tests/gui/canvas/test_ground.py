"""The ground under the cards: its dots stay where they are in the drawing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QPointF, QRect, QRectF, QSizeF
from PySide6.QtGui import QImage, QPainter

from situ.document.rbd import Application

SIZE = 360


def ground(viewer: Any, ratio: float, corner: QPointF, parts: int = 1) -> QImage:
    """``SIZE`` px of a screen of that ratio, from the drawing's ``corner``, in so many strips."""
    screen = QImage(SIZE, SIZE, QImage.Format.Format_RGB32)
    screen.setDevicePixelRatio(ratio)
    painter = QPainter(screen)
    zoom = viewer.look.zoom
    painter.scale(zoom, zoom)
    painter.translate(-corner)
    before = painter.worldTransform()
    unit = 1 / zoom / ratio
    for strip in range(parts):
        top, high = strip * SIZE // parts, SIZE // parts
        area = QRectF(corner + QPointF(0, top * unit), QSizeF(SIZE, high) * unit)
        painter.setClipRect(area)
        viewer.drawBackground(painter, area)
    assert painter.worldTransform() == before
    painter.end()
    screen.setDevicePixelRatio(1.0)
    return screen


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0])
def test_a_part_painted_anew_is_as_it_was_and_the_dots_go_with_the_drawing(
    desk: Callable[..., Any], small: Application, ratio: float
) -> None:
    viewer = desk(small, size=(640, 420)).canvas.viewer
    for zoom in (0.5, 0.8, 1.0, 1.7):
        viewer.zoom_to(zoom)
        px = 1 / zoom / ratio
        corner = QPointF(-700, -300) * px
        whole = ground(viewer, ratio, corner)
        assert ground(viewer, ratio, corner, parts=9) == whole
        along = ground(viewer, ratio, corner + QPointF(37, 113) * px)
        assert along.copy(QRect(0, 0, 200, 200)) == whole.copy(QRect(37, 113, 200, 200))
        assert along != whole


@pytest.mark.parametrize("ratio", [1, 2])
def test_at_full_size_a_dot_stands_in_the_middle_of_every_16_px(
    desk: Callable[..., Any], small: Application, ratio: int
) -> None:
    viewer = desk(small, size=(640, 420)).canvas.viewer
    viewer.zoom_to(1.0)
    screen = ground(viewer, ratio, QPointF(160, 320))
    plain = viewer.look["canvas"]
    for at in range(0, SIZE - 16 * ratio, 16 * ratio):
        assert screen.pixelColor(at, at) == plain
        assert screen.pixelColor(at + 8 * ratio, at + 8 * ratio) != plain


def test_a_view_smooths_no_pictures(desk: Callable[..., Any], small: Application) -> None:
    """They lie on whole px as they are; smoothing is what made most of a frame."""
    viewer = desk(small, size=(640, 420)).canvas.viewer
    assert not viewer.renderHints() & QPainter.RenderHint.SmoothPixmapTransform
