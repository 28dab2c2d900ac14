"""The canvas of an application: state cards, transitions, and what the robot does to them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

from PySide6.QtCore import QPointF, QRectF, Signal
from PySide6.QtGui import QCursor, QKeyEvent, Qt
from PySide6.QtWidgets import QWidget

from situ.document.problem import Problem
from situ.document.rbd import Application
from situ_studio.canvas import counted, gestures, intents, layout, spoken
from situ_studio.canvas.between import Between
from situ_studio.canvas.cards import CardItem
from situ_studio.canvas.commands import CommandedCanvas
from situ_studio.canvas.figure_items import FrameItem, NoteItem
from situ_studio.canvas.figures import Figure
from situ_studio.canvas.figuring import Figuring
from situ_studio.canvas.live import LiveView, changes
from situ_studio.canvas.menu import FollowMenu
from situ_studio.canvas.nodes import NodeFace, Spot
from situ_studio.canvas.picture import ALWAYS, NEW, Card, Picture, exit_of, place_of
from situ_studio.canvas.pipes import RoutedPipe
from situ_studio.canvas.piping import Piping
from situ_studio.canvas.positions import Positions
from situ_studio.canvas.projection import Projector
from situ_studio.canvas.what_follows import WhatFollows
from situ_studio.commands.insert import insert
from situ_studio.copying.clipboard import Copying
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.kinds import Kind
from situ_studio.looks.theme import Theme
from situ_studio.wording.language import tr


class ApplicationCanvas(CommandedCanvas, Copying):
    """Shows an application; gestures become ``edited`` (canvas.md)."""

    work_begun = Signal(str, object)
    """Something goes on beside the window: what, and the job (``processes.working.follow``)."""
    filled_in = Signal(tuple)
    """The place of a new state that is to be named."""
    screen_asked = Signal(tuple)
    """The state whose screen is to be drawn."""
    part_asked = Signal(object, tuple)
    """A part shall be added: its card's corner, and the exit into whose pipe it goes, or ()."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(theme, parent)
        self.document = Application(name="")
        self._projector = Projector()
        self._picture = Picture({}, {}, {})
        self._piping = Piping(self.graph, self)
        self._figuring = Figuring(self, self._edit)
        self.positions = Positions(self, self._figuring, self._edit)
        self._between = Between(self)
        self._drop: tuple[str, str, QPointF] | None = None
        naming = self.tr("New state “{0}”")
        self._what_follows = WhatFollows(self, lambda: self._picture, naming)
        self.viewer.dropped.connect(self._on_dropped)

    # -- showing ---------------------------------------------------------------------

    def show_document(self, document: Application, problems: Sequence[Problem] = ()) -> None:
        self.document = document
        self._problems = tuple(problems)
        self.render_document()

    def render_document(self) -> None:
        self.positions.lay_out_new()
        self._picture = self._projector.picture(self.document, self._problems, self.positions.laid)
        beside = self._figuring.show(self.document)
        self._show({**self._picture.cards, **beside}, self._picture.links)

    def arrange_like(self, other: ApplicationCanvas) -> None:
        self.positions.laid = dict(other.positions.laid)
        self._piping.draw_like(other._piping)

    def _item_kind(self, card: Any) -> type[NodeFace]:
        if isinstance(card, Figure):
            return FrameItem if card.kind == "frame" else NoteItem
        return CardItem

    def _route(self, moved: Iterable[str] | None = None) -> None:
        if moved is None:
            self._piping.route(self._picture, self.few)
        else:
            beside = self._figuring.shown
            self._piping.reroute(
                self._picture, [uid for uid in moved if uid not in beside], self.few
            )

    def _sign(self, changed: Iterable[str]) -> None:
        for uid in changed:
            for id in self.graph.links_at(uid):
                pipe = self.graph.pipe(id)
                if pipe is not None:
                    pipe.update_sign()

    def _follow_cards(self) -> None:
        self._figuring.carry()
        self._between.follow(self._picture.cards)
        super()._follow_cards()

    def set_live(self, live: LiveView | None) -> None:
        """Highlights of the running robot; None for none. They live in the view only."""
        before, self.look.live = self.look.live, live
        old = before if isinstance(before, LiveView) else LiveView()
        switched = (before is None) != (live is None)
        changed, exits = changes(old, live or LiveView())
        for uid, card in self._picture.cards.items():
            if switched or card.no in changed:
                node = self.graph.nodes.get(uid)
                if node is not None:
                    node.view.setToolTip(self._hint(card, live))
                    node.view.update()
        for id in self.graph.links:
            if switched or (id[0], id[1]) in exits:
                pipe = self.graph.pipe(id)
                if pipe is not None:
                    pipe.update()
        if self.look.level in ("quarter", "tiny"):
            self.viewer.viewport().update()
        self.minimap.redraw()

    def _hint(self, card: Card, live: LiveView | None) -> str:
        told = counted.told(live, card.no) if live is not None and card.no else ""
        return f"{card.hint()}\n\n{told}" if told else card.hint()

    def _on_cancelled(self) -> None:
        self._between.end()
        super()._on_cancelled()

    # -- gestures become edits -----------------------------------------------------------

    def settle(self) -> None:
        moved = self.graph.moved(self.viewer.touched)
        connections, slices = self.graph.take_intents()
        meant = self._between.end()
        after, text = self._figuring.resized(self.document)
        if text:
            pass
        elif connections:
            after, text = intents.connected(self.document, self._picture, connections)
        elif slices:
            after, text = intents.sliced(self.document, self._picture, slices)
        elif moved:
            after, text = self.positions.moved(moved)
            if meant is not None and len(moved) == 1:
                inserted, words = self._between.put(after, next(iter(moved)), meant)
                after, text = (inserted, words) if words else (after, text)
        if text:
            self.edited.emit(after, text)
        if self.viewer.touched:
            self.render_document()
        drop, self._drop = self._drop, None
        if drop is not None:
            self._what_follows.ask(*drop)

    def face(self, uid: str) -> Card | Figure:
        """What is shown of a card, note or frame."""
        return self._figuring.shown.get(uid) or self._picture.cards[uid]

    # -- what can follow -----------------------------------------------------------------

    def _on_dropped(self, leaving: Any, spot: QPointF) -> None:
        self._drop = leaving.node.uid, leaving.name, spot

    def turn_pipe(self) -> None:
        """Draws the selected transition's pipe where it is folded, or folds it again."""
        place = self._one_exit()
        for id in [i for i in self.graph.links if self.link_place(i) == place]:
            pipe = self.graph.pipe(id)
            if pipe is not None and pipe.route.folded:
                self._piping.draw(self._picture, id)
            elif self._piping.is_drawn(id):
                self._piping.fold(id)
                self._route()
            else:
                self.status.emit(tr("Only long pipes are folded, and this one is not"))

    def _ask_from(self, card: Card, exit: str) -> None:
        self._what_follows.ask_beside(card, exit)

    @property
    def menu(self) -> FollowMenu | None:
        """The one that asks what follows, while it is open."""
        return self._what_follows.menu

    # -- commands ---------------------------------------------------------------------------

    def free_spot(self) -> QPointF:
        """Where the context menu was opened, if it was; else beside the selected card, else in the
        middle of what is seen, and then never on another card."""
        if self.pointed is not None:
            return QPointF(gestures.snap(self.pointed.x()), gestures.snap(self.pointed.y()))
        notes = (one for one in self._figuring.shown.values() if one.kind == "note")
        things: tuple[Card | Figure, ...] = (*self._picture.cards.values(), *notes)
        taken = [(c.x, c.y, c.width, c.height) for c in things]
        uids = self.selected_uids()
        if uids:
            area = self.card_area(uids[-1])
            return QPointF(*layout.beside(taken, area.left() + 230, area.top()))
        middle = self.viewer.seen().center()
        corner = gestures.snap(middle.x() - 88), gestures.snap(middle.y() - 58)
        return QPointF(*layout.beside(taken, *corner))

    def add_state(self, kind: str = "state", at: QPointF | None = None) -> None:
        """A new state, selected. at: its corner in the scene; None: a free place near."""
        at = at if at is not None else self.free_spot()
        x, y = at.x(), at.y()
        after, text, no = gestures.add_state(self.positions.pinned(), x, y, kind)
        self._edit(after, text)
        if ("state", no) in self._picture.uids:
            self.select([("state", no)])
            self.viewer.reveal(self.card_area(self._picture.uids["state", no]))

    def drop_kind(self, kind: Kind, spot: QPointF) -> None:
        """A state goes where it was dropped, into a pipe if one is there; the rest into a card."""
        if kind.name in places.DRAWN:
            self.add_drawn(kind.name, spot)
            return
        x, y = gestures.snap(spot.x() - 88), gestures.snap(spot.y() - 58)
        if kind.name == ALWAYS and self.document.always is None:
            after, made, text = insert(self.document, kind, ())
            assert isinstance(after, Application)
            self._edit(gestures.move(after, {made: (x, y)})[0], text)
            self.select([made])
            return
        if kind.name not in ("state", "part"):
            super().drop_kind(kind, spot)
            return
        place = self.place_at(spot)
        if kind.name == "part":
            self.part_asked.emit(QPointF(x, y), place if exit_of(place) is not None else ())
        elif exit_of(place) is not None:
            after, text = gestures.insert(self.positions.pinned(), place, x, y)
            self._edit(after, text)
            self.select([("state", gestures.last_number(after))])
        else:
            self.add_state(at=QPointF(x, y))

    def add_drawn(self, kind: str, at: QPointF | None = None) -> None:
        """A note or a frame, whose text is written then. at: where; None: a free place near, and
        for a frame round what is selected."""
        place = self._figuring.add(kind, at, tuple(self.selected_uids()))
        self.select([place])
        self.rename()

    def _advise(self) -> str:
        if not self.document.states:
            return self.tr("No state yet. Drag State from the palette to here.")
        if len(self.document.states) == 1 and not self._picture.links:
            return self.tr(
                "What follows? Select the state, drag the plus at its right edge to an empty "
                "place and choose. Or drag State from the palette to here."
            )
        return ""

    def _first(self) -> str | None:
        return self._picture.uids.get(("state", self.document.start_no or ""))

    def delete_selection(self) -> None:
        self._edit(*gestures.delete(self.document, self.selection()))

    # -- copies ---------------------------------------------------------------------------

    def copied_document(self) -> Application | None:
        return self.positions.pinned()

    def paste_corner(self) -> tuple[float, float] | None:
        """At the context menu, else at the mouse, else at a free place."""
        pointer = self.viewer.viewport().mapFromGlobal(QCursor.pos())
        if self.pointed is None and self.viewer.viewport().rect().contains(pointer):
            spot = self.viewer.mapToScene(pointer)
            return gestures.snap(spot.x()), gestures.snap(spot.y())
        spot = self.free_spot()
        return spot.x(), spot.y()

    # -- order ----------------------------------------------------------------------------

    def align(self, edge: str) -> None:
        """edge: left, center, right, top, middle, bottom; or across, down: spaced evenly."""
        self.positions.align(edge)

    def auto_layout(self) -> None:
        """Every card by the automatic layout; of many cards in a process, cancelled by Esc."""
        self.positions.arrange()

    def _key(self, event: QKeyEvent) -> bool:
        if event.key() == Qt.Key.Key_Escape and self.positions.arranging.is_running:
            self.positions.arranging.cancel()
            return True
        return super()._key(event)

    def connect_selected(self) -> None:
        """A new event from each selected card to the next, in the order of the document."""
        numbers = self._numbers()
        if len(numbers) < 2:
            self.status.emit(tr("Select two states to connect"))
            return
        after, texts = self.document, []
        for source, target in pairwise(numbers):
            after, text = gestures.add_event(after, ("state", source), target)
            texts.append(text)
        many = tr("Connect {0} states").format(len(numbers))
        self._edit(after, texts[0] if len(texts) == 1 else many)

    def nudge(self, across: int, down: int) -> None:
        self.positions.nudge(across, down)

    def _rename_card(self, uid: str, name: str) -> None:
        face = self.face(uid)
        if isinstance(face, Figure):
            self._figuring.write(uid, name)
        elif face.no:
            self._edit(*gestures.rename(self.document, face.no, name))

    def name_area(self, uid: str) -> QRectF:
        if uid in self._figuring.shown:
            area = self.card_area(uid)
            return QRectF(area.left() + 6, area.top() + 3, min(area.width() - 12, 240), 24)
        return super().name_area(uid)

    def edit_name(self, uid: str) -> None:
        face = self.face(uid)
        if isinstance(face, Figure) and face.kind == "note":
            self.viewer.reveal(self.card_area(uid))
            self._begin_editor(self._figuring.editor(uid))
        elif isinstance(face, Figure) or face.no:
            super().edit_name(uid)

    def walked_to(self, uid: str) -> QPointF:
        face = self.face(uid)
        if face.kind == "frame":
            # Its title: its middle lies among the cards that it holds.
            return QPointF(face.x + 60, face.y + 14)
        return super().walked_to(uid)

    def spoken(self, uid: str) -> spoken.Spoken:
        if uid in self._figuring.shown:
            return super().spoken(uid)
        cards = self._picture.cards
        links = self._picture.links.values()
        before = {link.source: None for link in links if uid == link.target != link.source}
        return spoken.card(self.document, cards[uid], [cards[one] for one in before])

    def lately(self, uid: str) -> str:
        card, live = self._picture.cards.get(uid), self.look.live
        if card is None or not card.no or not isinstance(live, LiveView):
            return ""
        return counted.told(live, card.no).replace("\n", " ")

    # -- places --------------------------------------------------------------------------------

    def _place(self, uid: str, exit: str | None = None) -> Place:
        face = self.face(uid)
        return face.place if isinstance(face, Figure) else place_of(uid, exit, face)

    def _find(self, place: Place) -> tuple[str | None, str | None]:
        root = place[:1] if place[:1] == (ALWAYS,) else place[:2]
        uid = self._picture.uids.get(root)
        if uid is None:
            uid = " ".join(place)
            return (uid, None) if uid in self._figuring.shown else (None, None)
        exit = exit_of(place)
        if exit is not None and self._picture.cards[uid].exit(exit) is None:
            exit = None
        return uid, exit

    def _way(self, place: Place) -> Place:
        """What is done on a way is a part of it."""
        uid, exit = self._find(place)
        return place if uid is None or exit is None else self._place(uid, exit)

    def _choose_exit(self, card: NodeFace, exit: str) -> None:
        if exit == NEW:
            self.select([self._place(card.uid)])
        else:
            super()._choose_exit(card, exit)

    def _on_clicked(self, item: Any, spot: QPointF) -> None:
        folded = isinstance(item, RoutedPipe) and item.route.folded and item.link is not None
        if folded and not item.sign_area().contains(spot):
            if self.viewer.held & Qt.KeyboardModifier.AltModifier:
                self._piping.draw(self._picture, item.link.id)
            else:
                target = self._picture.cards[item.link.target]
                self.select([target.place])
                self.zoom_to([target.place])
            return
        if isinstance(item, CardItem) and not isinstance(item, Spot):
            kind, _, name = item.part_at(item.mapFromScene(spot)).partition(" ")
            exit = name if kind == "exit" else None
            # The row of one exit was chosen: another one, or the card itself, is wanted now.
            if self.viewer.selected_before() == [item] and exit != item.row:
                self.select([self._place(item.uid, exit)])
                return
        super()._on_clicked(item, spot)

    def _on_double_click(self, card: NodeFace, spot: QPointF) -> None:
        face: Card | Figure = card.face
        if isinstance(face, Figure) or (spot.y() < 28 and face.no and self.look.level == "full"):
            self.edit_name(card.uid)
        elif isinstance(card, CardItem) and card.picture_area().contains(spot):
            self.screen_asked.emit(face.place)
        else:
            self.activated.emit(face.place)
