"""The seam's upper half: NodeGraphQt's graph, written only by ``show_picture``.

It compares what is shown with what shall be, node by node, and
touches only what differs; shown again for touched nodes, it heals what a
gesture left behind. NodeGraphQt's undo is not used.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from itertools import compress, count, filterfalse
from operator import is_not
from typing import Any, TypeVar

from PySide6.QtCore import QLineF
from PySide6.QtGui import QUndoStack

from situ_studio.canvas.library import NodeGraph, PortConnectedCmd, PortDisconnectedCmd
from situ_studio.canvas.nodes import IN, OUT, Node, NodeFace
from situ_studio.canvas.style import Look
from situ_studio.canvas.viewer import Viewer

LinkId = tuple[str, ...]
K = TypeVar("K")

FEW = 8
"""Keys that come or go in one edit, mostly."""


class Graph(NodeGraph):
    """nodes: our id to node. links: what is connected, by id (source, exit, target, …)."""

    def __init__(self, viewer: Viewer, look: Look, kind: Callable[[Any], type[NodeFace]]) -> None:
        self.look = look
        self.kind = kind
        self.nodes: dict[str, Node] = {}
        self.cards: dict[str, Any] = {}
        self.links: dict[LinkId, Any] = {}
        self._at: dict[str, dict[LinkId, None]] = {}
        self.connections: list[tuple[list[Any], list[Any]]] = []
        self.slices: list[list[Any]] = []
        self._lines: tuple[Any, list[QLineF], list[QLineF]] | None = None
        self.folds: Callable[[LinkId], bool] = lambda id: False
        """Whether a link ends in a chip: far out it would only cross the drawing."""
        # A throw-away stack: the library wants one, nothing is ever pushed.
        super().__init__(viewer=viewer, undo_stack=QUndoStack())
        self.set_acyclic(False)

    # -- what NodeGraphQt would do ------------------------------------------------------

    def _register_builtin_nodes(self) -> None:
        return

    def _register_context_menu(self) -> None:
        return

    def get_unique_name(self, name: str) -> str:
        return name

    def _wire_signals(self) -> None:
        """The viewer's own signals are intents; they are kept until the gesture has settled."""
        self._viewer.connection_changed.connect(self._on_changed)
        self._viewer.connection_sliced.connect(self._on_sliced)

    def _on_changed(self, disconnected: list[Any], connected: list[Any]) -> None:
        self.connections.append((disconnected, connected))

    def _on_sliced(self, ports: list[Any]) -> None:
        self.slices.append(ports)

    def take_intents(self) -> tuple[list[tuple[list[Any], list[Any]]], list[list[Any]]]:
        """What was asked for since the last call."""
        connections, slices = self.connections, self.slices
        self.connections, self.slices = [], []
        return connections, slices

    # -- the document heals the view -----------------------------------------------------

    def show_picture(self, cards: Mapping[str, Any], links: Mapping[LinkId, Any]) -> set[str]:
        """Makes model and view equal to the picture. Returns the uids that were changed."""
        viewer = self._viewer
        # Not what is moved here.
        touched = set(viewer.touched)
        gone, fresh = differing(self.cards, cards)
        cut, drawn = differing(self.links, links)
        stale = {*cut, *(id for id in drawn if id in self.links and self.links[id] != links[id])}
        for uid in gone:
            stale.update(self.links_at(uid))
        # A port that goes takes its pipes with it; they come back with the links that are left.
        for uid in fresh:
            node = self.nodes.get(uid)
            if node is not None:
                card = cards[uid]
                lost = {p.name() for p in node._outputs} - set(card.outputs)
                entries = {p.name() for p in node._inputs} - set(card.inputs)
                if lost or entries:
                    stale |= {
                        link.id
                        for link in map(self.links.__getitem__, self.links_at(uid))
                        if (link.source == uid and link.exit in lost)
                        or (link.target == uid and link.entry in entries)
                    }
        for id in stale:
            self._disconnect(self._forget(id))
        for uid in gone:
            self._remove(uid)
        for uid in fresh:
            self._put(cards[uid])
        for uid in touched.difference(fresh):
            if uid in self.nodes:
                self._replace(uid, cards[uid])
        for id in {**dict.fromkeys(drawn), **dict.fromkeys(i for i in stale if i in links)}:
            self._connect(links[id], id in self.links)
        self.links = dict(links)
        if touched:
            self._mend(touched)
        self.cards = dict(cards)
        self._lines = None
        viewer.touched = set()
        self.set_acyclic(False)
        viewer.forget()
        return {*fresh, *gone}

    def extend(self, card: Any, links: Mapping[LinkId, Any]) -> None:
        """One more card, and of these links those whose cards are both there."""
        self._put(card)
        self.cards[card.uid] = card
        touched = set(self._viewer.touched)
        for id, link in links.items():
            if id not in self.links and link.source in self.nodes and link.target in self.nodes:
                self._connect(link, False)
                self.links[id] = link
                line = self._line(link)
                if self._lines is not None and line is not None:
                    self._lines[1].append(line)
        # Nobody's gesture touched anything.
        self._viewer.touched = touched

    def _put(self, card: Any) -> None:
        node = self.nodes.get(card.uid)
        if node is None:
            node = Node(self.kind(card), self.look)
            node._graph = self
            node.model._graph_model = self.model
            self.nodes[card.uid] = node
            self.model.nodes[node.id] = node
            node.show_face(card)
            self._viewer.add_node(node.view, (card.x, card.y))
        else:
            node.show_face(card)

    def _replace(self, uid: str, card: Any) -> None:
        """A touched card goes back to where the document has it."""
        view = self.nodes[uid].view
        if (view.x(), view.y()) != (card.x, card.y):
            view.setPos(card.x, card.y)

    def _remove(self, uid: str) -> None:
        node = self.nodes.pop(uid)
        self.model.nodes.pop(node.id)
        view = node.view
        view.setSelected(False)
        self._viewer.bury((view, node))
        view.delete()

    def _ends(self, link: Any) -> tuple[Any, Any] | None:
        source, target = self.nodes.get(link.source), self.nodes.get(link.target)
        if source is None or target is None:
            return None
        leaving, entry = source.port(OUT, link.exit), target.port(IN, link.entry)
        return (leaving, entry) if leaving is not None and entry is not None else None

    def _connect(self, link: Any, there: bool) -> None:
        """there: whether its pipe was kept."""
        for uid in (link.source, link.target):
            self._at.setdefault(uid, {})[link.id] = None
        ends = self._ends(link)
        if ends is None:
            return
        if not there:
            PortConnectedCmd(*ends, emit_signal=False).redo()
        pipe = self.pipe_between(*ends)
        if pipe is not None:
            pipe.link = link

    def _forget(self, id: LinkId) -> Any:
        """The link, which is no more."""
        link = self.links.pop(id)
        for uid in (link.source, link.target):
            self._at.get(uid, {}).pop(id, None)
        return link

    def _disconnect(self, link: Any) -> None:
        ends = self._ends(link)
        if ends is not None:
            PortDisconnectedCmd(*ends, emit_signal=False).redo()
            for near, far in (ends, ends[::-1]):
                # The library leaves empty lists behind.
                there = near.model.connected_ports
                if not there.get(far.node().id, True):
                    del there[far.node().id]

    def pipe_between(self, leaving: Any, entry: Any) -> Any:
        """The pipe's item, or None."""
        return next((p for p in leaving.view.connected_pipes if p.input_port is entry.view), None)

    def pipe(self, id: LinkId) -> Any:
        """The item of a link, or None."""
        ends = self._ends(self.links[id]) if id in self.links else None
        return self.pipe_between(*ends) if ends is not None else None

    def _mend(self, touched: Iterable[str]) -> None:
        """The pipes of touched nodes as the model has them; gestures delete and make some."""
        near = set(touched)
        wanted: set[tuple[int, int]] = set()
        for link in (self.links[id] for uid in near for id in self.links_at(uid)):
            ends = self._ends(link)
            if ends is None:
                continue
            leaving, entry = ends
            wanted.add((id(leaving.view), id(entry.view)))
            pipe = self.pipe_between(leaving, entry)
            if pipe is None:
                self._viewer.establish_connection(leaving.view, entry.view)
                pipe = self.pipe_between(leaving, entry)
            pipe.link = link
        for uid in near:
            node = self.nodes.get(uid)
            if node is None:
                continue
            for port in (*node._inputs, *node._outputs):
                self._weed(port.view, wanted)

    @staticmethod
    def _weed(port: Any, wanted: set[tuple[int, int]]) -> None:
        """Without pipes that nobody wants, or that are there twice."""
        seen: set[tuple[int, int]] = set()
        for pipe in list(port.connected_pipes):
            ends = (id(pipe.output_port), id(pipe.input_port))
            if ends in wanted and ends not in seen:
                seen.add(ends)
            else:
                pipe.delete()

    # -- asking ---------------------------------------------------------------------------

    def links_at(self, uid: str) -> list[LinkId]:
        """What leaves or enters a card."""
        return list(self._at.get(uid, ()))

    def moved(self, touched: Iterable[str]) -> dict[str, tuple[float, float]]:
        """Touched cards that are not where the picture has them."""
        found = {}
        for uid in touched:
            node, card = self.nodes.get(uid), self.cards.get(uid)
            if node is not None and card is not None:
                at = (node.view.x(), node.view.y())
                if at != (card.x, card.y):
                    found[uid] = at
        return found

    def lines(self) -> tuple[list[QLineF], list[QLineF]]:
        """Every link as a straight line between its cards, without those that ``folds`` names,
        and those that the robot just took."""
        live = getattr(self.look.live, "taken", ())
        if self._lines is not None and self._lines[0] is live:
            return self._lines[1], self._lines[2]
        hot = {(t.state, t.exit) for t in live}
        plain, taken = [], []
        for id, link in self.links.items():
            line = self._line(link)
            if line is None:
                continue
            if not self.folds(id):
                plain.append(line)
            if (link.source, link.exit) in hot:
                taken.append(line)
        self._lines = live, plain, taken
        return plain, taken

    def forget_lines(self) -> None:
        """``folds`` says something else now."""
        self._lines = None

    def _line(self, link: Any) -> QLineF | None:
        source, target = self.cards.get(link.source), self.cards.get(link.target)
        if source is None or target is None or source is target:
            return None
        ax, ay = source.port(link.exit)
        bx, by = target.port(link.entry)
        return QLineF(source.x + ax, source.y + ay, target.x + bx, target.y + by)


def differing(before: Mapping[K, Any], now: Mapping[K, Any]) -> tuple[list[K], list[K]]:
    """The keys that are gone, and those whose value is not the very object that it was."""
    old, new, was, here = [*before], [*now], [*before.values()], [*now.values()]
    gone: list[K] = []
    fresh: list[K] = []
    # All keys but a few are mostly the same ones in the same order: side by side they are compared
    # in a fifth of the time that looking each up takes.
    for _ in range(FEW):
        if old == new:
            return gone, [*fresh, *compress(new, map(is_not, was, here))]
        at = next(compress(count(), map(is_not, old, new)), min(len(old), len(new)))
        if at < len(old) and old[at] not in now:
            gone.append(old.pop(at))
            del was[at]
        elif at < len(new) and new[at] not in before:
            fresh.append(new.pop(at))
            del here[at]
        else:
            break
    gone = [*filterfalse(now.__contains__, before)]
    return gone, [*compress(now, map(is_not, map(before.get, now), now.values()))]
