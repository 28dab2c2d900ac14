"""A card that is dragged onto a pipe goes in between, unless Alt is held."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainterPath, QPen
from PySide6.QtWidgets import QGraphicsPathItem

from situ.document.rbd import Application
from situ_studio.canvas import gestures
from situ_studio.canvas.picture import Card
from situ_studio.canvas.pipes import RoutedPipe
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ_studio.canvas.application import ApplicationCanvas

NEAR = 8.0
"""Px on screen between the cursor and a pipe that is meant."""
HINT = 6.0
"""Px that the pipe which is meant is painted wide, where it was when the drag began."""


class Between:
    """Knows while one card is dragged which pipe the cursor is on, and shows it.

    Pipes get out of a dragged card's way, so they are meant where they were before the drag.
    """

    def __init__(self, canvas: ApplicationCanvas) -> None:
        self._canvas = canvas
        self._ways: dict[tuple[str, ...], QPainterPath] | None = None
        self._meant: tuple[str, ...] | None = None
        self._hint: QGraphicsPathItem | None = None

    def follow(self, cards: Mapping[str, Card]) -> None:
        """To be called before the pipes follow a card to where it is dragged."""
        viewer, graph = self._canvas.viewer, self._canvas.graph
        at = viewer.dragged_to()
        if at is None or self._canvas.look.level != "full":
            return
        if self._ways is None:
            self._ways = {
                item.link.id: item.path()
                for item in viewer.scene().items(viewer.seen())
                if isinstance(item, RoutedPipe) and item.link is not None and not item.route.folded
            }
        moved = list(graph.moved(viewer.touched))
        card = cards.get(moved[0]) if len(moved) == 1 else None
        alone = viewer.held & Qt.KeyboardModifier.AltModifier
        meant = self._under(card, at) if card is not None and not alone else None
        if meant != self._meant:
            self._meant = meant
            self._show_hint()
            said = tr("State {0} goes in between here. Alt: it is only moved.")
            no = card.no if card is not None and meant is not None else ""
            self._canvas.status.emit(said.format(no) if no else "")

    def _under(self, card: Card, at: QPointF) -> tuple[str, ...] | None:
        """The pipe at a spot that neither leaves nor enters the card, and that it can lead on."""
        state = self._canvas.document.state(card.no) if card.no else None
        if state is None or state.final or self._ways is None:
            return None
        near = NEAR / self._canvas.look.zoom
        found = [
            (_distance(way, at), id)
            for id, way in self._ways.items()
            if card.uid not in (id[0], id[-1])
            and id in self._canvas.graph.links
            and way.boundingRect().adjusted(-near, -near, near, near).contains(at)
        ]
        distance, id = min(found, default=(near, ()))
        return id if distance < near else None

    def _show_hint(self) -> None:
        if self._hint is None:
            self._hint = QGraphicsPathItem()
            self._hint.setZValue(0.5)
            self._hint.setAcceptedMouseButtons(Qt.MouseButton.NoButton)
            self._canvas.viewer.scene().addItem(self._hint)
        if self._meant is None or self._ways is None:
            self._hint.setPath(QPainterPath())
            return
        ink = self._canvas.look.faint("accent", 0.55)
        self._hint.setPen(QPen(ink, HINT, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        self._hint.setPath(self._ways[self._meant])

    def end(self) -> tuple[str, ...] | None:
        """The drag has ended: the pipe that was meant."""
        meant, self._meant, self._ways = self._meant, None, None
        if meant is not None:
            self._canvas.status.emit("")
        if self._hint is not None:
            self._hint.setPath(QPainterPath())
        if self._canvas.viewer.held & Qt.KeyboardModifier.AltModifier:
            return None
        return meant

    def put(self, after: Application, uid: str, id: tuple[str, ...]) -> tuple[Application, str]:
        """The card put in between, in the document in which it was moved; "" where the pipe
        leads elsewhere by now."""
        card = self._canvas.graph.cards.get(uid)
        if card is None or id not in self._canvas.graph.links:
            return after, ""
        return gestures.put_between(after, self._canvas.link_place(id), card.no)


def _distance(way: QPainterPath, at: QPointF) -> float:
    """How far a spot is from a way, or a little more: looked for every few px."""
    length = way.length()
    steps = max(1, int(length / 4))
    points = (way.pointAtPercent(way.percentAtLength(length * i / steps)) for i in range(steps + 1))
    return min((point - at).manhattanLength() for point in points)
