"""A large drawing comes a slice at a time, with the window usable: what is seen comes first."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from typing import Any

from PySide6.QtCore import QObject, QRectF, QTimer, Signal

from situ_studio.canvas.graph import Graph, LinkId
from situ_studio.canvas.viewer import Viewer

MANY = 300
"""So many new cards are not shown at once."""
FIRST = 40
SLICE = 0.008
"""Seconds of filling at a time."""

Cards = dict[str, Any]
Links = dict[LinkId, Any]


class Filling(QObject):
    """Keeps what shall be shown, and what of it is not yet. cards: the whole drawing's."""

    filled = Signal()
    """Every card is there; the pipes have no ways yet."""

    def __init__(self, graph: Graph, viewer: Viewer, parent: QObject) -> None:
        super().__init__(parent)
        self.cards: Cards = {}
        self._links: Links = {}
        self._graph = graph
        self._viewer = viewer
        self._waiting: list[str] = []
        self._at: dict[str, list[LinkId]] = {}
        self._seen_before = True
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._fill_slice)
        viewer.looked.connect(self._on_looked)

    @property
    def is_filling(self) -> bool:
        return bool(self._waiting)

    def take(self, cards: Cards, links: Links) -> tuple[Cards, Links]:
        """The drawing is this from now on. Returns what of it is to be shown at once."""
        self.cards, self._links = cards, links
        there = self._graph.cards
        waiting = [] if cards.keys() <= there.keys() else [u for u in cards if u not in there]
        if len(waiting) <= MANY:
            self._end()
            return cards, links
        self._waiting = waiting[FIRST:]
        self._at = {}
        for id, link in links.items():
            self._at.setdefault(link.source, []).append(id)
            self._at.setdefault(link.target, []).append(id)
        self._seen_before = False
        # Qt sorts all items anew whenever one makes the scene larger: it is told at once.
        self._viewer.scene().setSceneRect(_extent(cards))
        self._slices.start()
        late = set(self._waiting)
        return (
            {uid: card for uid, card in cards.items() if uid not in late},
            {
                id: link
                for id, link in links.items()
                if link.source not in late and link.target not in late
            },
        )

    def need(self, uids: Iterable[str]) -> None:
        """Puts these cards now."""
        if self.is_filling:
            now = set(uids)
            late = [uid for uid in self._waiting if uid in now]
            self._waiting = [uid for uid in self._waiting if uid not in now]
            for uid in late:
                self._put(uid)

    def finish(self) -> None:
        """Puts all that is left."""
        if self.is_filling:
            for uid in self._waiting:
                self._put(uid)
            self._end()
            self.filled.emit()

    def _end(self) -> None:
        if self._slices.isActive():
            self._viewer.scene().setSceneRect(QRectF())
        self._waiting, self._at = [], {}
        self._slices.stop()

    def _put(self, uid: str) -> None:
        links = {id: self._links[id] for id in self._at.get(uid, ())}
        self._graph.extend(self.cards[uid], links)

    def _on_looked(self) -> None:
        self._seen_before = False

    def _fill_slice(self) -> None:
        deadline = time.perf_counter() + SLICE
        if not self._seen_before:
            self._seen_before = True
            self._sort(self.cards)
        while self._waiting:
            self._put(self._waiting.pop())
            if time.perf_counter() >= deadline:
                break
        if not self._waiting:
            self._end()
            self.filled.emit()

    def _sort(self, cards: Mapping[str, Any]) -> None:
        """What is seen is put first: it stands last."""
        seen = self._viewer.seen()
        left, top, right, bottom = seen.left(), seen.top(), seen.right(), seen.bottom()

        def is_seen(uid: str) -> bool:
            card = cards[uid]
            across = card.x < right and card.x + card.width > left
            return bool(across and card.y < bottom and card.y + card.height > top)

        order = {uid: -place for place, uid in enumerate(cards)}
        self._waiting.sort(key=lambda uid: (is_seen(uid), order[uid]))


def _extent(cards: Mapping[str, Any]) -> QRectF:
    every = cards.values()
    left, top = min(card.x for card in every), min(card.y for card in every)
    right = max(card.x + card.width for card in every)
    bottom = max(card.y + card.height for card in every)
    return QRectF(left, top, right - left, bottom - top).adjusted(-1000, -1000, 1000, 1000)
