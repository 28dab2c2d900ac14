"""What commands do on the canvas of an application, beside gestures: without a mouse too."""

from __future__ import annotations

from situ.document.rbd import Application
from situ_studio.canvas import gestures
from situ_studio.canvas.base import Canvas
from situ_studio.canvas.picture import NEW, Card, Picture, exit_of
from situ_studio.edits.edit import Place


class CommandedCanvas(Canvas):
    """Knows the document as a picture; how it is drawn and dragged is ``ApplicationCanvas``'s."""

    document: Application
    _picture: Picture

    def _edit(self, after: Application, text: str) -> None:
        if text:
            self.edited.emit(after, text)

    def _numbers(self) -> list[str]:
        cards = (self._picture.cards.get(uid) for uid in self.selected_uids())
        return [c.no for c in cards if c is not None and c.no]

    def _one_exit(self) -> Place | None:
        """The place of the transition that is selected, if one alone is."""
        chosen = self.selection()
        return chosen[0] if len(chosen) == 1 and exit_of(chosen[0]) is not None else None

    def _one_card(self) -> Card | None:
        """The card that is selected, or the one of the selected transition."""
        chosen = self.selection()
        uid = self._find(chosen[0])[0] if len(chosen) == 1 else None
        return self._picture.cards.get(uid) if uid is not None else None

    # -- selecting ------------------------------------------------------------------------

    def select_followers(self) -> None:
        """Adds the states to which the selected ones lead."""
        self._add(gestures.followers(self.document, self._numbers()))

    def select_leading(self) -> None:
        """Adds the states that lead to the selected ones."""
        self._add(gestures.leading(self.document, self._numbers()))

    def _add(self, numbers: tuple[str, ...]) -> None:
        more = [("state", no) for no in numbers]
        if set(more) <= set(self.selection()):
            self.status.emit(self.tr("All of them are selected already"))
            return
        self.select(dict.fromkeys((*self.selection(), *more)))
        self.bring_into_view(self.selection())

    # -- from transition to transition ---------------------------------------------------

    def next_exit(self) -> None:
        """From transition to transition of the selected card, in document order."""
        self._step_exit(1)

    def previous_exit(self) -> None:
        self._step_exit(-1)

    def _step_exit(self, by: int) -> None:
        card = self._one_card()
        if card is None or not card.exits:
            self.status.emit(self.tr("Select a state with transitions"))
            return
        names = [e.id for e in card.exits]
        place = self._one_exit()
        here = exit_of(place) if place is not None else None
        first = 0 if by > 0 else -1
        at = first if here is None else (names.index(here) + by) % len(names)
        self.select([gestures.exit_place(card.place, names[at])])
        self.bring_into_view([card.place])

    # -- changing ----------------------------------------------------------------------------

    def ask_where_to(self) -> None:
        """Asks where the selected transition leads, or a new one of the selected card."""
        card = self._one_card()
        if card is None:
            self.status.emit(self.tr("Select one state, or one transition"))
            return
        place = self._one_exit()
        exit = exit_of(place) if place is not None else None
        self._ask_from(card, exit if exit is not None else NEW)

    def _ask_from(self, card: Card, exit: str) -> None:
        raise NotImplementedError

    def snap_to_grid(self) -> None:
        """The selected cards, or all where none is, to the nearest points of the grid."""
        every = self._picture.cards
        cards = [every[uid] for uid in self.selected_uids() or every if uid in every]
        after, text = gestures.snap_all(self.document, {c.place: (c.x, c.y) for c in cards})
        if not text:
            self.status.emit(self.tr("They are on the grid already"))
        self._edit(after, text)
