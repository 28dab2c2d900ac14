"""A drawing on paper: painted by the canvas that shows it, in lines that stay sharp at any size."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QFontMetricsF, QPainter, QPainterPath, QStaticText

from situ_studio.edits.edit import Place

MARGIN = 24.0
"""Px left round a drawing."""


class Paper:
    """A document as its canvas shows it at 100 %, with nothing of the window on it.

    canvas: shows the document, is not shown itself, and is the paper's from now on.
    like: the canvas that a person looks at; cards without a place in the file stand where it has
    them. only: of the drawing just the cards at these places, with the pipes between them.
    """

    def __init__(
        self,
        canvas: Any,
        document: object,
        like: Any = None,
        only: Iterable[Place] | None = None,
    ) -> None:
        self._canvas = canvas
        # Every pipe has its way before anything is painted.
        canvas.few = 2**31
        canvas.look.on_paper = True
        canvas.set_zoom(1.0)
        scene = canvas.viewer.scene()
        # NodeGraphQt's own ground, which its viewer here never shows.
        scene.grid_mode = 0
        scene.setBackgroundBrush(Qt.BrushStyle.NoBrush)
        if like is not None:
            canvas.arrange_like(like)
        canvas.show_document(document)
        canvas.filling.finish()
        self._whole = only is None
        if only is not None:
            self._leave(only)
        area = QRectF(canvas.extent()) if only is None else self._area_of(self._left(only))
        self.area: QRectF = area.adjusted(-MARGIN, -MARGIN, MARGIN, MARGIN)
        """What of the scene there is to paint, in px at 100 %."""

    def area_of(self, places: Iterable[Place]) -> QRectF:
        """What ``area`` would be with only these places; empty where none is on the drawing."""
        left = self._left(places)
        if not left:
            return QRectF()
        return self._area_of(left).adjusted(-MARGIN, -MARGIN, MARGIN, MARGIN)

    def _left(self, places: Iterable[Place]) -> set[str]:
        return {uid for uid in self._canvas.cards_at(places) if uid in self._canvas.graph.nodes}

    def _leave(self, places: Iterable[Place]) -> None:
        """Takes away all but the cards at these places, and what leads from one to another."""
        graph = self._canvas.graph
        left = self._left(places)
        for uid, node in graph.nodes.items():
            node.view.setVisible(uid in left)
        for id, link in graph.links.items():
            pipe = graph.pipe(id)
            if pipe is not None:
                pipe.setVisible(link.source in left and link.target in left)

    def _area_of(self, left: set[str]) -> QRectF:
        """What these cards take, with the pipes from one to another."""
        graph = self._canvas.graph
        area = QRectF()
        for uid in left:
            area = area.united(graph.nodes[uid].view.sceneBoundingRect())
        for id, link in graph.links.items():
            pipe = graph.pipe(id)
            if pipe is not None and link.source in left and link.target in left:
                area = area.united(pipe.boundingRect())
        return area

    def paint(self, painter: QPainter, part: QRectF, onto: QRectF) -> None:
        """Paints ``part`` of the scene into ``onto`` of the painter's device, nothing beside."""
        canvas = self._canvas
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.TextAntialiasing)
        painter.setClipRect(onto)
        if self._whole and canvas.viewer.on_ground is not None:
            painter.save()
            painter.translate(onto.topLeft())
            painter.scale(onto.width() / part.width(), onto.height() / part.height())
            painter.translate(-part.topLeft())
            canvas.viewer.on_ground(painter)
            painter.restore()
        canvas.viewer.scene().render(painter, onto, part, Qt.AspectRatioMode.IgnoreAspectRatio)
        painter.restore()

    def close(self) -> None:
        """Lets the canvas go."""
        self._canvas.deleteLater()


class Outlines(QPainter):
    """Paints texts as outlines: they look the same where the typeface is not there.

    Works for what is painted from Python: only there a subclass's methods are found.
    """

    def drawStaticText(self, *arguments: object) -> None:
        corner, text = arguments
        assert isinstance(corner, QPointF)
        assert isinstance(text, QStaticText)
        self._outline(corner.x(), corner.y() + QFontMetricsF(self.font()).ascent(), text.text())

    def drawText(self, *arguments: object) -> None:  # type: ignore[override]
        room, flags, text = arguments
        assert isinstance(room, QRectF)
        assert isinstance(flags, int)
        metrics = QFontMetricsF(self.font())
        box = metrics.boundingRect(room, flags, str(text))
        self._outline(box.left(), box.top() + metrics.ascent(), str(text))

    def _outline(self, x: float, baseline: float, text: str) -> None:
        path = QPainterPath()
        path.addText(QPointF(x, baseline), self.font(), text)
        self.fillPath(path, self.pen().brush())
