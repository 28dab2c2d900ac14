"""What of a script is selected: nodes, pipes, and lines of conditions; edits that keep its laws."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from PySide6.QtCore import QPointF, QRectF

from situ.document.condition import Group, Test
from situ.document.spds import Spds
from situ_studio.canvas.base import Canvas
from situ_studio.canvas.curves import CurvedPipe
from situ_studio.canvas.script_faces import LINE, STRIP, ScriptNode, ScriptPicture
from situ_studio.canvas.script_laws import Laws
from situ_studio.edits import places
from situ_studio.edits.edit import Place

_CONDITIONS = (("condition",), ("until",))


class ScriptChoosing(Canvas):
    """Knows the script as a picture; how it is drawn and dragged is ``ScriptCanvas``'s."""

    document: Spds
    _picture: ScriptPicture
    _laws: Laws
    _groups: tuple[Place, ...]
    """Selected groups of tests, to which no pipe leads."""
    _lines: tuple[Place, ...]
    """Selected lines of a condition, kept while its card is pressed."""
    _choosing: bool

    def _edit(self, after: Spds, text: str, then: Place = ()) -> bool:
        """One step, unless it breaks a law; then: what is selected after it."""
        if not text:
            return False
        breach = self._laws.breach(self.document, after)
        if breach:
            self.status.emit(breach)
            return False
        self.edited.emit(after, text)
        if then:
            self.select([then])
        return True

    # -- selection ----------------------------------------------------------------------------

    def selection(self) -> tuple[Place, ...]:
        """Groups of tests too, to which no pipe leads."""
        groups = (g for g in self._groups if places.get(self.document, g) is not None)
        return (*super().selection(), *groups)

    def select(self, chosen: Iterable[Place]) -> None:
        every = list(chosen)
        self._groups = tuple(p for p in every if self._is_group(p))
        self._choosing = True
        try:
            super().select(p for p in every if p not in self._groups)
        finally:
            self._choosing = False
        self._lines = tuple(p for p in self.selection() if p[2:3] in _CONDITIONS and len(p) > 3)

    def clear_selection(self) -> None:
        self._groups = ()
        super().clear_selection()
        self._on_selection()

    def _show(self, cards: dict[str, Any], links: dict[tuple[str, ...], Any]) -> None:
        self._choosing = True
        try:
            super()._show(cards, links)
        finally:
            self._choosing = False

    def _on_selection(self) -> None:
        if not self._quiet and not self._choosing:
            # A hand chose something else.
            self._groups = ()
            if any(self._picture.cards[key].kind != "condition" for key in self.selected_uids()):
                self._lines = ()
        super()._on_selection()

    def _is_group(self, place: Place) -> bool:
        if place[2:3] not in _CONDITIONS or len(place) < 4:
            return False
        return isinstance(places.get(self.document, place), Group)

    # -- what is selected ------------------------------------------------------------------

    def _one_node(self) -> ScriptNode | None:
        """The node that is selected, or the one in which what is selected stands."""
        chosen = self.selection()
        found = self._find(chosen[0])[0] if len(chosen) == 1 else None
        return self._picture.cards.get(found) if found is not None else None

    def _one_situation(self) -> str:
        """The name of the situation that is selected, or of which something is; "" for none."""
        chosen = self.selection()
        named = {place[1] for place in chosen if place[0] == "situation"}
        if len(named) == 1 and all(place[0] == "situation" for place in chosen):
            return named.pop()
        self.status.emit(self.tr("Select one situation"))
        return ""

    def _tests(self) -> list[Place]:
        """Tests and groups that are selected."""
        every = self.selection()
        return [p for p in every if isinstance(places.get(self.document, p), Test | Group)]

    def _stops(self, node: ScriptNode) -> list[Place]:
        """What can be selected of a node, from top to bottom."""
        if node.kind == "condition":
            return [(*node.place, *row.tail) for row in node.rows]
        ends = (
            link.target if node.kind == "resource" else link.source
            for link in self._picture.links.values()
        )
        every = zip(self._picture.links.values(), ends, strict=True)
        return [link.place for link, end in every if end == node.uid and link.place]

    def select_followers(self) -> None:
        """Adds the nodes to which pipes lead from what is selected."""
        chosen, picture = self._chosen_ends(), self._picture
        every = [k for k in picture.links.values() if k.source in chosen or k.id in chosen]
        self._add({link.target for link in every})

    def select_leading(self) -> None:
        """Adds the nodes from which pipes lead to what is selected."""
        chosen, picture = self._chosen_ends(), self._picture
        every = [k for k in picture.links.values() if k.target in chosen or k.id in chosen]
        self._add({link.source for link in every})

    def _chosen_ends(self) -> set[Any]:
        """The keys of the selected nodes, else the ids of the selected pipes."""
        pipes = {p.link.id for p in self.viewer.selected_pipes() if p.link is not None}
        return set(self.selected_uids()) or pipes

    def _add(self, keys: set[str]) -> None:
        """Selects these nodes too, in the order of reading."""
        more = [card.place for key, card in self._picture.cards.items() if key in keys]
        if set(more) <= set(self.selection()):
            self.status.emit(self.tr("All of them are selected already"))
            return
        self.select(dict.fromkeys((*self.selection(), *more)))
        self.bring_into_view(self.selection())

    def next_exit(self) -> None:
        """From pipe to pipe of the selected node, and from line to line of a condition."""
        self._step_exit(1)

    def previous_exit(self) -> None:
        self._step_exit(-1)

    def _step_exit(self, by: int) -> None:
        node = self._one_node()
        stops = self._stops(node) if node is not None else []
        if not stops or node is None:
            self.status.emit(self.tr("Select something from which a pipe leads"))
            return
        now = self.selection()[0]
        first = 0 if by > 0 else len(stops) - 1
        self.select([stops[(stops.index(now) + by) % len(stops) if now in stops else first]])
        self.bring_into_view([node.place])

    def _selected_priorities(self) -> list[CurvedPipe]:
        if self.selected_uids():
            return []
        return [p for p in self.viewer.selected_pipes() if p.link.kind == "priority"]

    def row_area(self, place: Place) -> QRectF | None:
        """Where the line of a test or a group is, in the scene."""
        key = self._picture.uids.get(place[:3])
        node = self._picture.cards.get(key) if key is not None else None
        for index, row in enumerate(node.rows if node is not None else ()):
            if row.tail == place[3:] and node is not None:
                top = node.y + node.line_at(index) - LINE / 2
                return QRectF(node.x + STRIP, top, node.width - STRIP, LINE)
        return None

    # -- places ----------------------------------------------------------------------------------

    def _place(self, uid: str, exit: str | None = None) -> Place:
        place = self._picture.cards[uid].place
        row = next((r for r in self._picture.cards[uid].rows if r.path == exit), None)
        return (*place, *row.tail) if row is not None else place

    def link_place(self, id: tuple[str, ...]) -> Place:
        link = self._picture.links.get(id)
        if link is None:
            return ()
        return link.place or self._picture.cards[link.target].place

    def _find(self, place: Place) -> tuple[str | None, str | None]:
        for end in range(len(place), 0, -1):
            found = self._picture.uids.get(place[:end])
            if found is not None:
                rest = place[end:]
                node = self._picture.cards[found]
                if node.kind == "condition":
                    row = next((r for r in node.rows if r.tail == rest), None)
                    return found, row.path if row is not None else None
                return found, ("out" if rest else None)
        return None, None

    def port_at(self, key: str, port: str) -> QPointF:
        raise NotImplementedError
