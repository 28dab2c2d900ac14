"""What is seen of a drawing: zoom, place, and the ground under the cards.

NodeGraphQt's viewer with exact zoom: at 100 % a scene unit is a px, a window's
new size keeps zoom and corner, two fingers on a trackpad move the ground.
"""

from __future__ import annotations

from collections.abc import Callable
from math import ceil
from typing import Any

from PySide6.QtCore import QEvent, QPointF, QRectF, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QNativeGestureEvent,
    QPainter,
    QPen,
    QPixmap,
    QTransform,
    QWheelEvent,
)
from PySide6.QtWidgets import QGraphicsItem, QGraphicsView
from PySide6.QtWidgets import QWidget as Widget

from situ_studio.canvas.library import NodeViewer
from situ_studio.canvas.pictures import by_pixels
from situ_studio.canvas.style import Look

ZOOM_LEAST, ZOOM_MOST = 0.04, 4.0
TILE = 256
"""Px of the screen that a tile of the ground takes at least."""


class Ground(NodeViewer):
    """straight_lines: every pipe as a QLineF, and those just taken, for where cards are small.
    on_ground: draws on the ground, under everything.

    Pictures are painted px for px and never smoothed: with that hint set Qt would lay them on
    much more slowly, even where nothing is scaled.
    """

    # NodeGraphQt's own, untyped.
    _scene_range: QRectF

    zoomed = Signal(float)
    looked = Signal()
    """Another part of the drawing is seen."""

    def __init__(self, look: Look, parent: Widget | None = None) -> None:
        self.look = look
        self._pipes: set[QGraphicsItem] = set()
        self.straight_lines: Callable[[], tuple[list[Any], list[Any]]] = lambda: ([], [])
        self.on_ground: Callable[[QPainter], None] | None = None
        self._dots: tuple[tuple[float, ...], QPixmap] | None = None
        super().__init__(parent)
        self.setFrameShape(QGraphicsView.Shape.NoFrame)
        self.setCacheMode(QGraphicsView.CacheModeFlag.CacheNone)
        self.setViewportUpdateMode(QGraphicsView.ViewportUpdateMode.SmartViewportUpdate)
        self.setTransformationAnchor(QGraphicsView.ViewportAnchor.NoAnchor)
        self.setResizeAnchor(QGraphicsView.ViewportAnchor.NoAnchor)
        self.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.setOptimizationFlag(QGraphicsView.OptimizationFlag.DontSavePainterState, True)
        self.setMinimumSize(120, 90)

    # -- pipes ----------------------------------------------------------------------------

    def _shows_pipes(self) -> bool:
        return self.look.level in ("full", "half")

    def hold_pipe(self, pipe: QGraphicsItem) -> None:
        """Puts a pipe into the scene, seen where pipes are not drawn as straight lines.

        Not under one parent: Qt finds what is seen and what is hit by place only among items
        that have none, and would ask every pipe at each frame and each move of the mouse.
        """
        pipe.setVisible(self._shows_pipes())
        self._pipes.add(pipe)
        self.scene().addItem(pipe)

    def release_pipe(self, pipe: QGraphicsItem) -> None:
        """Takes a pipe out of the scene."""
        self._pipes.discard(pipe)
        if pipe.scene() is not None:
            self.scene().removeItem(pipe)

    def seen(self) -> QRectF:
        """The part of the scene that is in the window."""
        return QRectF(self._scene_range)

    # -- zoom and place -----------------------------------------------------------------

    def _update_scene(self) -> None:
        """Shows ``_scene_range`` from its upper left corner, exactly: at 100 % a unit is a px."""
        area = self._scene_range
        size = self.viewport().size()
        if area.width() <= 0 or size.width() <= 0:
            return
        zoom = max(ZOOM_LEAST, min(ZOOM_MOST, size.width() / area.width()))
        left, top = round(area.left() * zoom) / zoom, round(area.top() * zoom) / zoom
        self._scene_range = QRectF(QPointF(left, top), QSizeF(size) / zoom)
        self.setSceneRect(self._scene_range)
        if self.transform().m11() != zoom:
            self.setTransform(QTransform.fromScale(zoom, zoom))
        changed = self.look.zoom != zoom
        if self.look.set_zoom(zoom):
            for pipe in self._pipes:
                pipe.setVisible(self._shows_pipes())
        if changed:
            self.zoomed.emit(zoom)
        self.looked.emit()
        self.viewport().update()

    def resizeEvent(self, event: Any) -> None:
        """The upper left corner and the zoom stay."""
        QGraphicsView.resizeEvent(self, event)
        zoom = self.look.zoom
        self._scene_range = QRectF(
            self._scene_range.topLeft(), QSizeF(self.viewport().size()) / zoom
        )
        self._last_size = self.size()
        self._update_scene()

    def zoom_by(self, factor: float, at: QPointF | None = None) -> None:
        """Zooms so that the point under ``at`` (px of the viewport) stays where it is."""
        self.zoom_to(self.look.zoom * factor, at)

    def zoom_to(self, zoom: float, at: QPointF | None = None) -> None:
        zoom = max(ZOOM_LEAST, min(ZOOM_MOST, zoom))
        if at is None:
            at = QPointF(self.viewport().rect().center())
        area = self._scene_range
        spot = QPointF(area.left() + at.x() / self.look.zoom, area.top() + at.y() / self.look.zoom)
        corner = spot - at / zoom
        self._scene_range = QRectF(corner, QSizeF(self.viewport().size()) / zoom)
        self._update_scene()

    def show_area(self, area: QRectF, most: float = 1.0, below: float = 0.0) -> None:
        """Zooms and moves so that ``area`` is seen whole, at most at ``most``; ``below`` px of the
        window's lower edge are left for what lies over it."""
        size = QSizeF(self.viewport().size())
        room = QSizeF(size.width(), max(1.0, size.height() - below))
        if area.isEmpty() or size.isEmpty():
            return
        zoom = min(most, room.width() / area.width(), room.height() / area.height())
        zoom = max(ZOOM_LEAST, zoom)
        corner = area.center() - QPointF(room.width() / zoom / 2, room.height() / zoom / 2)
        self._scene_range = QRectF(corner, size / zoom)
        self._update_scene()

    def reveal(self, area: QRectF, margin: float = 40.0) -> None:
        """Moves as little as needed so that ``area`` is seen; the zoom stays."""
        seen = self._scene_range
        margin = margin / self.look.zoom
        wanted = area.adjusted(-margin, -margin, margin, margin)
        x = y = 0.0
        if wanted.left() < seen.left():
            x = wanted.left() - seen.left()
        elif wanted.right() > seen.right():
            x = wanted.right() - seen.right()
        if wanted.top() < seen.top():
            y = wanted.top() - seen.top()
        elif wanted.bottom() > seen.bottom():
            y = wanted.bottom() - seen.bottom()
        if x or y:
            self._set_viewer_pan(x, y)

    def look_at(self, spot: QPointF) -> None:
        """Moves so that the spot is in the middle."""
        way = spot - self._scene_range.center()
        self._set_viewer_pan(way.x(), way.y())

    def wheelEvent(self, event: QWheelEvent) -> None:
        zooms = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        pixels = event.pixelDelta()
        if not zooms and not pixels.isNull() and event.phase() != Qt.ScrollPhase.NoScrollPhase:
            # Two fingers on a trackpad move the canvas.
            self._set_viewer_pan(-pixels.x() / self.look.zoom, -pixels.y() / self.look.zoom)
        else:
            turned = event.angleDelta().y() or event.angleDelta().x()
            self.zoom_by(1.0015**turned, event.position())
        event.accept()

    def viewportEvent(self, event: QEvent) -> bool:
        if (
            isinstance(event, QNativeGestureEvent)
            and event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture
        ):
            self.zoom_by(1 + event.value(), event.position())
            return True
        return bool(super().viewportEvent(event))

    # -- ground ------------------------------------------------------------------------

    def drawBackground(self, painter: QPainter, rect: QRectF) -> None:
        look = self.look
        if look.level in ("full", "half"):
            self._draw_dots(painter, rect)
        else:
            painter.fillRect(rect, look["canvas"])
        if look.level in ("quarter", "tiny") or look.unrouted:
            self._draw_straight(painter)
        if self.on_ground is not None:
            self.on_ground(painter)

    def _draw_dots(self, painter: QPainter, rect: QRectF) -> None:
        """Tile by tile: one fill of all, Qt shares out among threads, for twice the time in all."""
        to_screen, world = painter.deviceTransform(), painter.worldTransform()
        tile = self._dotted(to_screen.m11() / self.look.zoom)
        side, area = tile.width(), to_screen.mapRect(rect).toAlignedRect()
        left, top = round(to_screen.dx()), round(to_screen.dy())
        painter.setWorldTransform(by_pixels(to_screen, world), False)
        for x in range(area.left() - (area.left() - left) % side, area.right() + 1, side):
            for y in range(area.top() - (area.top() - top) % side, area.bottom() + 1, side):
                painter.drawPixmap(x, y, tile)
        painter.setWorldTransform(world, False)

    def _dotted(self, ratio: float) -> QPixmap:
        """A tile of the ground with its dots, 12 to 24 px apart and a power of two of 16 units.

        In px of the screen, ``ratio`` to one of the window's; nothing shines through.
        """
        step = 16 * self.look.zoom
        while step < 12:
            step *= 2
        while step >= 24:
            step /= 2
        pixels = max(4, round(round(step) * ratio))
        key = pixels, ratio, self.look.version
        if self._dots is None or self._dots[0] != key:
            many = ceil(TILE / pixels)
            tile = QPixmap(many * pixels, many * pixels)
            tile.fill(self.look["canvas"])
            painter = QPainter(tile)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self.look["dots"])
            for across in range(many):
                for down in range(many):
                    centre = QPointF((across + 0.5) * pixels, (down + 0.5) * pixels)
                    painter.drawEllipse(centre, 0.8 * ratio, 0.8 * ratio)
            painter.end()
            self._dots = key, tile
        return self._dots[1]

    def _draw_straight(self, painter: QPainter) -> None:
        """Far out: every pipe a straight line, all of them at once."""
        lines, taken = self.straight_lines()
        painter.setPen(QPen(self.look["pipe"], 0))
        # Smooth lines cost more than all cards together where thousands are seen.
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, len(lines) < 500)
        painter.drawLines(lines)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
        if taken:
            painter.setPen(QPen(self.look["live"], 2.5 / self.look.zoom))
            painter.drawLines(taken)
