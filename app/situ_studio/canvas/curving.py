"""When pipes of a script get their ways: those that are seen at once, very many others after."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import Any

from PySide6.QtCore import QObject, Qt, QTimer

from situ_studio.canvas.curves import CurvedPipe
from situ_studio.canvas.graph import LinkId
from situ_studio.canvas.script_priorities import Priorities

SLICE = 0.008
"""Seconds at a time for pipes that nobody sees."""
BEYOND = 60.0
"""What is so near to what is seen is seen too: a pill reaches beyond the ends of its pipe."""


class Curving(QObject):
    """Gives the pipes of one canvas their ways and their priorities a place on them."""

    def __init__(self, canvas: Any, priorities: Priorities) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._priorities = priorities
        self._waiting: dict[LinkId, None] = {}
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._curve_slice)

    def is_curving(self) -> bool:
        """Whether pipes out of sight still have the way that they had."""
        return bool(self._waiting)

    def curve(self, ids: Iterable[LinkId], few: int) -> None:
        """New ways; where there are more than ``few``, what is not seen follows in slices."""
        every = dict.fromkeys(id for id in ids if id in self._canvas.graph.links)
        now = every if len(every) <= few else dict.fromkeys(filter(self._is_seen(), every))
        for id in now:
            self._waiting.pop(id, None)
            self._curve(id)
        if len(now) < len(every):
            later = [id for id in every if id not in now]
            self._waiting.update(dict.fromkeys(later))
            for id in later:
                # Where it stood is free.
                self._priorities.forget(id)
            self._slices.start()

    def _is_seen(self) -> Callable[[LinkId], bool]:
        """Whether a pipe is in sight, as it is or as it is going to be."""
        viewer, graph = self._canvas.viewer, self._canvas.graph
        area = viewer.seen().adjusted(0, -BEYOND, 0, BEYOND)
        top, bottom = area.top(), area.bottom()
        items = viewer.scene().items(area, Qt.ItemSelectionMode.IntersectsItemBoundingRect)
        before = {p.link.id for p in items if isinstance(p, CurvedPipe) and p.link is not None}

        def is_seen(id: LinkId) -> bool:
            link, cards = graph.links[id], graph.cards
            one, other = cards[link.source], cards[link.target]
            above = max(one.y + one.height, other.y + other.height) < top
            return id in before or not (above or min(one.y, other.y) > bottom)

        return is_seen

    def _curve_slice(self) -> None:
        deadline = time.perf_counter() + SLICE
        while self._waiting and time.perf_counter() < deadline:
            id = next(iter(self._waiting))
            del self._waiting[id]
            self._curve(id)
        if not self._waiting:
            self._slices.stop()

    def _curve(self, id: LinkId) -> None:
        pipe = self._canvas.graph.pipe(id)
        if pipe is not None:
            link = pipe.link
            canvas = self._canvas
            pipe.set_curve(
                canvas.port_at(link.source, link.exit), canvas.port_at(link.target, link.entry)
            )
            self._priorities.place(pipe)
