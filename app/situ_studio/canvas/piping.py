"""The pipes of an application's canvas: what is routed, how it is labelled, and when.

Few pipes are all routed anew at each edit, for the best picture. Very many are
routed a slice at a time when a document is opened, with the window usable, and
from then on only where something changed.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator, Mapping

from PySide6.QtCore import QObject, QTimer

from situ_studio.canvas.chips import chip_width
from situ_studio.canvas.graph import Graph
from situ_studio.canvas.picture import TIMEOUT, Card, Link, Picture
from situ_studio.canvas.pipe_labels import GUARD_HEIGHT, LABEL_HEIGHT, LONGEST, PIXELS
from situ_studio.canvas.routes import Router
from situ_studio.canvas.space import Box, Pipe, PipeId
from situ_studio.canvas.style import Label

SLICE = 0.008
"""Seconds of routing at a time, where there are very many pipes."""
MOMENT = 0.003
"""Seconds of an edit that go into new routes at once."""


class Piping(QObject):
    """Gives the graph's pipes their routes."""

    def __init__(self, graph: Graph, parent: QObject) -> None:
        super().__init__(parent)
        self._graph = graph
        graph.folds = self._folds
        self._router = Router()
        self._picture = Picture({}, {}, {})
        self._widths: dict[str, float] = {}
        self._said: dict[PipeId, tuple[str, bool, str]] = {}
        self._at: dict[str, set[PipeId]] = {}
        self._routing: Iterator[None] = iter(())
        self._moved: dict[str, None] = {}
        self._changing: Iterator[None] | None = None
        self._changes = QTimer(self)
        self._changes.setInterval(0)
        self._changes.timeout.connect(self._change_slice)
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._route_slice)

    def route(self, picture: Picture, few: int) -> None:
        """All pipes; at once where there are few."""
        self._picture = picture
        self._moved, self._changing = {}, None
        self._changes.stop()
        boxes, pipes = self._boxes(picture.cards), self._all_pipes()
        if len(picture.links) <= few:
            self._slices.stop()
            self._graph.look.unrouted = False
            self._router.route(boxes, pipes)
            self._show(picture.links)
        else:
            self._routing = self._route_all(boxes, pipes)
            self._graph.look.unrouted = True
            self._slices.start()

    def reroute(self, picture: Picture, moved: Iterable[str], few: int = 0) -> None:
        """What changes when some cards are elsewhere, other or gone.

        At once where there are few pipes; else what takes longer than a moment follows in slices.
        """
        if self._slices.isActive():
            # What is being routed is out of date.
            self.route(picture, 0)
            return
        self._picture = picture
        self._moved.update(dict.fromkeys(moved))
        self._change_slice(MOMENT if len(picture.links) > few else math.inf)
        if self.is_changing():
            self._changes.start()

    def is_changing(self) -> bool:
        return self._changing is not None or bool(self._moved)

    def _change_slice(self, seconds: float = SLICE) -> None:
        deadline = time.perf_counter() + seconds
        while self.is_changing():
            if self._changing is None:
                self._changing = self._change(set(self._moved))
                self._moved = {}
            for _ in self._changing:
                if time.perf_counter() > deadline:
                    return
            self._changing = None
        self._changes.stop()

    def _change(self, cards: set[str]) -> Iterator[None]:
        picture, links = self._picture, self._picture.links
        boxes: dict[str, Box | None] = dict.fromkeys(cards)
        boxes.update(self._boxes({u: c for u in cards if (c := picture.cards.get(u))}))
        near = {id: links[id] for uid in cards for id in self._graph.links_at(uid)}
        pipes: dict[PipeId, Pipe | None] = dict.fromkeys(
            id for uid in cards for id in self._at.get(uid, ())
        )
        for id in pipes:
            if id not in links:
                self._unsay(id)
        in_order = sorted(
            near.values(), key=lambda x: picture.cards[x.source].outputs.index(x.exit)
        )
        pipes.update(self._pipes(in_order))
        pipes.update(self._stubs(c for u in cards if (c := picture.cards.get(u))))
        self._show((yield from self._router.changing(boxes, pipes)))

    def draw(self, picture: Picture, id: PipeId) -> None:
        """A pipe that was folded is drawn from now on."""
        self._router.drawn.add(id)
        self.reroute(picture, {id[0]})

    def fold(self, id: PipeId) -> None:
        """A pipe that ``draw`` drew is folded by the next ``route``, if it is long still."""
        self._router.drawn.discard(id)

    def is_drawn(self, id: PipeId) -> bool:
        """Whether ``draw`` has drawn it."""
        return id in self._router.drawn

    def draw_like(self, other: Piping) -> None:
        """Draws the pipes that ``other`` was told to draw."""
        self._router.drawn = set(other._router.drawn)

    def is_routing(self) -> bool:
        """Whether routes are still being looked for."""
        return self._slices.isActive() or self.is_changing()

    def _all_pipes(self) -> list[Pipe]:
        pipes = self._pipes(self._picture.links.values())
        return [*pipes.values(), *self._stubs(self._picture.cards.values()).values()]

    def _route_all(self, boxes: dict[str, Box], pipes: list[Pipe]) -> Iterator[None]:
        yield from self._router.routing(boxes, pipes)
        for id in self._picture.links:
            self._show((id,))
            yield

    def _route_slice(self) -> None:
        deadline = time.perf_counter() + SLICE
        for _ in self._routing:
            if time.perf_counter() > deadline:
                return
        self._slices.stop()
        self._graph.look.unrouted = False
        self._graph.viewer().viewport().update()

    def _boxes(self, cards: Mapping[str, Card]) -> dict[str, Box]:
        """What pipes go round: each card where it is now, with what hangs below it."""
        boxes = {}
        for uid, card in cards.items():
            view = self._graph.nodes[uid].view
            x, y = view.x(), view.y()
            boxes[uid] = Box(x, y, x + card.width, y + card.height + (8 if card.chips else 0))
        return boxes

    def _pipes(self, links: Iterable[Link]) -> dict[PipeId, Pipe]:
        """What to route for these links; those between the same two cards share their label."""
        groups: dict[tuple[str, str], list[Link]] = {}
        for link in links:
            groups.setdefault((link.source, link.target), []).append(link)
        pipes: dict[PipeId, Pipe] = {}
        nodes, cards = self._graph.nodes, self._picture.cards
        for (source, target), group in groups.items():
            pill = len(group) == 1 and bool(group[0].guard)
            text = group[0].guard if pill else ", ".join(dict.fromkeys(x.label for x in group))
            width = self._text_width(text) + (36 if pill else 10)
            leaving, entering = cards[source], cards[target]
            from_view, to_view = nodes[source].view, nodes[target].view
            for link in group:
                ax, ay = leaving.port(link.exit)
                bx, by = entering.port(link.entry)
                self._say(link.id, text, pill, entering.no)
                pipes[link.id] = Pipe(
                    id=link.id,
                    source=source,
                    target=target,
                    start=(from_view.x() + ax, from_view.y() + ay),
                    end=(to_view.x() + bx, to_view.y() + by),
                    width=width,
                    height=GUARD_HEIGHT if pill else LABEL_HEIGHT,
                    chip=chip_width(entering.no),
                    timeout=link.exit == TIMEOUT,
                    folded=leaving.kind == "always",
                )
        return pipes

    def _stubs(self, cards: Iterable[Card]) -> dict[PipeId, Pipe]:
        """What takes room at an exit without leading to a card: chips of #back, #again, errors."""
        pipes: dict[PipeId, Pipe] = {}
        for card in cards:
            view = self._graph.nodes[card.uid].view
            for leaving in card.exits:
                if not leaving.short:
                    continue
                x, y = card.port(leaving.id)
                start = (view.x() + x, view.y() + y)
                # No card is called so: each stands for itself.
                id = (card.uid, leaving.id, f" {leaving.id}")
                self._say(id)
                pipes[id] = Pipe(
                    id=id,
                    source=card.uid,
                    target=id[2],
                    start=start,
                    end=start,
                    chip=chip_width(leaving.short, not leaving.missing),
                    folded=True,
                )
        return pipes

    def _say(self, id: PipeId, text: str = "", pill: bool = False, chip: str = "") -> None:
        self._said[id] = text, pill, chip
        for uid in (id[0], id[2]):
            self._at.setdefault(uid, set()).add(id)

    def _unsay(self, id: PipeId) -> None:
        del self._said[id]
        for uid in (id[0], id[2]):
            self._at[uid].discard(id)

    def _show(self, ids: Iterable[PipeId]) -> None:
        for id in ids:
            item = self._graph.pipe(id)
            route = self._router.routes.get(id)
            if item is not None and route is not None and id in self._said:
                if item.route.folded != route.folded:
                    self._graph.forget_lines()
                item.set_route(route, *self._said[id])

    def _folds(self, id: PipeId) -> bool:
        route = self._router.routes.get(id)
        return route is not None and route.folded

    def _text_width(self, text: str) -> float:
        width = self._widths.get(text)
        if width is None:
            if len(self._widths) > 20000:
                self._widths.clear()
            width = self._widths[text] = Label(text, PIXELS, 500, LONGEST).width
        return width
