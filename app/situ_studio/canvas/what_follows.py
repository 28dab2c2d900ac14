"""Asking what follows an exit: a menu of what it can lead to, and what comes of the choice."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF

from situ_studio.canvas import gestures, layout
from situ_studio.canvas.menu import FollowMenu
from situ_studio.canvas.picture import FIRST, NEW, Card, Picture

if TYPE_CHECKING:
    from situ_studio.canvas.application import ApplicationCanvas


class WhatFollows:
    """Asks on one canvas. picture: what it shows now.

    naming: what offers a new state called as was typed, with ``{0}`` for that.
    menu: while it is open.
    """

    def __init__(
        self, canvas: ApplicationCanvas, picture: Callable[[], Picture], naming: str
    ) -> None:
        self._canvas = canvas
        self._picture = picture
        self._naming = naming
        self.menu: FollowMenu | None = None

    def ask_beside(self, card: Card, exit: str) -> None:
        """Asks at the exit itself; a new state goes to a free place beside the card."""
        picture = self._picture()
        uid = picture.uids[card.place]
        self._canvas.viewer.reveal(self._canvas.card_area(uid))
        x, y = card.port(exit)
        taken = [(c.x, c.y, c.width, c.height) for c in picture.cards.values()]
        free = QPointF(*layout.beside(taken, card.x + 230, card.y)) + QPointF(0, FIRST)
        self.ask(uid, exit, free, QPointF(card.x + x, card.y + y))

    def ask(self, uid: str, exit: str, spot: QPointF, at: QPointF | None = None) -> None:
        """spot: where a new state goes; at: where the menu opens, there if None."""
        canvas, card = self._canvas, self._picture().cards.get(uid)
        if card is None:
            return
        choices = gestures.choices(canvas.document, card.place, exit)
        menu = FollowMenu(choices, canvas.look.theme, canvas)
        menu.chosen.connect(lambda key: self._follow(uid, exit, key, spot))
        menu.named.connect(lambda name: self._follow(uid, exit, "state", spot, name))
        menu.offer_name(self._naming)
        menu.closed.connect(self._on_closed)
        self.menu = menu
        corner = canvas.viewer.mapFromScene(at if at is not None else spot)
        menu.popup(canvas.viewer.viewport().mapToGlobal(corner))

    def _on_closed(self) -> None:
        self.menu = None
        self._canvas.viewer.setFocus()

    def _follow(self, uid: str, exit: str, key: str, spot: QPointF, name: str = "") -> None:
        canvas, card = self._canvas, self._picture().cards.get(uid)
        if card is None or (exit != NEW and card.exit(exit) is None):
            return
        x, y = layout.entry(spot.x(), spot.y())
        after, text, no = gestures.follow(canvas.document, card.place, exit, key, x, y)
        if no is not None and name:
            after, _ = gestures.rename(after, no, name)
        if text:
            canvas.edited.emit(after, text)
        if no is not None and ("state", no) in self._picture().uids:
            canvas.select([("state", no)])
            # Let go at the edge, it would be half in view, and its plus out of reach.
            canvas.viewer.reveal(canvas.card_area(self._picture().uids["state", no]))
            if not name:
                canvas.filled_in.emit(("state", no))
