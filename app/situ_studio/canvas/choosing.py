"""What of a drawing is selected: by hand, by place, from card to card; and what is heard of it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtCore import QPointF, QRectF, Signal
from PySide6.QtWidgets import QWidget

from situ_studio.canvas import spoken, walk
from situ_studio.canvas.filling import Filling
from situ_studio.canvas.graph import Graph
from situ_studio.canvas.overlay import MiniMap
from situ_studio.canvas.viewer import Viewer
from situ_studio.edits.edit import Place


class Choosing(QWidget):
    """A drawing's selection, in places as ``Problem.place`` has them. ``Canvas`` draws."""

    selection_changed = Signal(tuple)
    activated = Signal(tuple)
    viewer: Viewer
    graph: Graph
    filling: Filling
    minimap: MiniMap

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._told: tuple[Place, ...] = ()
        self._row: tuple[str, str] | None = None
        self._quiet = 0

    # -- for subclasses --------------------------------------------------------------

    def _place(self, uid: str, exit: str | None = None) -> Place:
        raise NotImplementedError

    def _find(self, place: Place) -> tuple[str | None, str | None]:
        """The uid and the exit that a place names; None where it names none."""
        raise NotImplementedError

    def _way(self, place: Place) -> Place:
        """The place of the pipe of which ``place`` is a part."""
        return place

    def card_area(self, uid: str) -> QRectF:
        """Where a card lies in the scene."""
        raise NotImplementedError

    # -- selection -----------------------------------------------------------------------

    def selected_uids(self) -> list[str]:
        """Selected cards, in document order."""
        chosen = {item.uid for item in self.viewer.selected_nodes()}
        return [u for u in self.graph.cards if u in chosen] if chosen else []

    def selection(self) -> tuple[Place, ...]:
        """Places of what is selected: cards in document order, then transitions."""
        uids = self.selected_uids()
        if self._row is not None and uids == [self._row[0]]:
            return (self._place(*self._row),)
        places = [self._place(uid) for uid in uids]
        pipes = [p.link.id for p in self.viewer.selected_pipes() if p.link is not None]
        places += [self.link_place(id) for id in sorted(pipes) if id in self.graph.links]
        return tuple(dict.fromkeys(places))

    def link_place(self, id: tuple[str, ...]) -> Place:
        return self._place(id[0], id[1])

    def select(self, places: Iterable[Place]) -> None:
        """Selects these places and nothing else; unknown ones are left out."""
        self._quiet += 1
        try:
            self.viewer.scene().clearSelection()
            self._set_row(None)
            for place in places:
                uid, exit = self._find(place)
                if uid is None:
                    continue
                self.filling.need([uid])
                pipes = []
                if exit is not None:
                    way = self._way(place)
                    pipes = [
                        self.graph.pipe(i) for i in self.graph.links if self.link_place(i) == way
                    ]
                if pipes and pipes[0] is not None:
                    for pipe in pipes:
                        pipe.setSelected(True)
                else:
                    self.graph.nodes[uid].view.setSelected(True)
                    if exit is not None:
                        self._set_row((uid, exit))
        finally:
            self._quiet -= 1
        self._on_selection()

    def select_all(self) -> None:
        self.filling.finish()
        self._quiet += 1
        try:
            for node in self.graph.nodes.values():
                node.view.setSelected(True)
        finally:
            self._quiet -= 1
        self._on_selection()

    def clear_selection(self) -> None:
        self._set_row(None)
        self.viewer.scene().clearSelection()

    def _set_row(self, row: tuple[str, str] | None) -> None:
        if self._row is not None and self._row[0] in self.graph.nodes:
            view = self.graph.nodes[self._row[0]].view
            view.row = None
            view.update()
        self._row = row
        if row is not None:
            view = self.graph.nodes[row[0]].view
            view.row = row[1]
            view.update()

    def _on_selection(self) -> None:
        if self._quiet:
            return
        if self._row is not None and self.selected_uids() != [self._row[0]]:
            self._set_row(None)
        now = self.selection()
        if now != self._told:
            self._told = now
            self.minimap.redraw()
            if self.viewer.spoken_as is not None:
                self.viewer.spoken_as.on_selected()
            self.selection_changed.emit(now)

    # -- for screen readers ------------------------------------------------------------------

    def heard(self) -> Sequence[str]:
        """The uids of what is heard of the drawing, in document order."""
        return list(self.graph.cards)

    def spoken(self, uid: str) -> spoken.Spoken:
        """What is heard of a card."""
        return spoken.node(self.graph.cards[uid], self._place(uid))

    def lately(self, uid: str) -> str:
        """What the robot that is looked at does there; "" where none is."""
        return ""

    def choose(self, place: Place) -> None:
        """As a click there would: selects it, in view, with the focus; an action in its card."""
        self.viewer.setFocus()
        self.select([place])
        uid, _ = self._find(place)
        if uid is not None:
            self.viewer.reveal(self.card_area(uid))
        if self.selection() != (place,):
            self.selection_changed.emit((place,))

    def begin(self, place: Place) -> None:
        """As a double click there would: its form gets the focus."""
        self.choose(place)
        self.activated.emit(place)

    # -- from card to card -------------------------------------------------------------------

    def step(self, across: int, down: int) -> None:
        """Selects the card next to the selected one in that direction."""
        uids = self.selected_uids()
        if not uids:
            self._go(next(iter(self.graph.cards), None))
            return
        spots = {u: self.walked_to(u).toTuple() for u in self.graph.cards}
        self._go(walk.beside(spots, uids[-1], across, down))

    def walked_to(self, uid: str) -> QPointF:
        """The spot that stands for a card when arrows lead from one to the next."""
        return self.card_area(uid).center()

    def step_in_order(self, by: int) -> None:
        """Selects the next card in document order."""
        uids = self.selected_uids()
        self._go(walk.onwards(list(self.graph.cards), uids[-1] if uids else None, by))

    def step_to_letter(self, letter: str) -> bool:
        """Selects the next card whose name or number begins so."""
        uids = self.selected_uids()
        names = {u: (c.name, c.no) for u, c in self.graph.cards.items()}
        found = walk.beginning(names, uids[-1] if uids else None, letter)
        self._go(found)
        return found is not None

    def _go(self, uid: str | None) -> None:
        if uid is None:
            return
        self.select([self._place(uid)])
        if not self.graph.nodes[uid].view.isSelected():
            self.graph.nodes[uid].view.setSelected(True)
        self.viewer.reveal(self.card_area(uid))
