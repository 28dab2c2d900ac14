"""What both canvases are: a viewer with a graph, its zoom, its selection, its edits."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from PySide6.QtCore import QMimeData, QPoint, QPointF, QRect, QRectF, QSizeF, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from situ.document.problem import Problem
from situ_studio import kinds
from situ_studio.canvas import accessible
from situ_studio.canvas.choosing import Choosing
from situ_studio.canvas.filling import Filling
from situ_studio.canvas.graph import Graph
from situ_studio.canvas.nodes import NodeFace, Spot
from situ_studio.canvas.note_editor import NoteEditor
from situ_studio.canvas.overlay import Advice, InPlace, MiniMap, ZoomBar, name_editor
from situ_studio.canvas.pipes import RoutedPipe
from situ_studio.canvas.style import FULL, Look
from situ_studio.canvas.viewer import Viewer
from situ_studio.commands.insert import NotHere, insert
from situ_studio.edits.edit import Place
from situ_studio.looks.theme import Theme

BAR = 40.0
"""The lower edge that the zoom bar takes."""
READABLE = 0.8
"""The zoom at which a drawing opens that does not fit."""
ZOOMS = (0.1, 0.15, 0.25, 0.4, 0.5, 0.65, 0.8, 1.0, 1.25, 1.5, 2.0, 3.0)


class Canvas(Choosing):
    """A drawing of one document: never changes it, emits ``edited``, shows what it is given.

    Selections and problems are places, as ``Problem.place`` has them.
    """

    edited = Signal(object, str)
    """The document after a gesture, and the edit's name."""
    status = Signal(str)
    zoomed = Signal(float)
    menu_requested = Signal(tuple, QPoint)
    """A right click: the place under it (empty for the ground), where on the screen."""
    mends_asked = Signal()
    """The sign of a problem was clicked, of what is selected now."""
    media_asked = Signal(tuple, str, object)
    """A file is wanted for something new there, as ``StateScreen.media_asked``."""
    module_dropped = Signal(str, tuple)
    """The name of a module that was dragged here, and the place of what it was dropped on."""
    pointed: QPointF | None
    """Where in the scene a context menu was opened, while what it offers is done: what is added
    or pasted goes there."""
    few = 150
    """Up to so many pipes, all are routed anew at each edit, for the best picture."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        accessible.install()
        self.look = Look(theme)
        self.viewer = Viewer(self.look, self)
        self.graph = Graph(self.viewer, self.look, self._item_kind)
        self.viewer.straight_lines = self.graph.lines
        self.filling = Filling(self.graph, self.viewer, self)
        self.filling.filled.connect(self._on_filled)
        self.viewer.on_key = self._key
        self.viewer.speaker = self
        self.document: Any = None
        self._problems: tuple[Problem, ...] = ()
        self._fitted = self._begins = False
        self._editor: InPlace | NoteEditor | None = None
        self.pointed: QPointF | None = None
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.viewer)
        self.setFocusProxy(self.viewer)
        self.zoom_bar = ZoomBar(self)
        self.zoom_bar.stepped.connect(self._step_zoom)
        self.zoom_bar.fitted.connect(self.zoom_to_fit)
        self.zoom_bar.set_theme(theme)
        self.minimap = MiniMap(self.viewer, self.look, self)
        self.advice = Advice(self)
        self.advice.set_theme(theme)
        self._moved_timer = QTimer(self)
        self._moved_timer.setSingleShot(True)
        self._moved_timer.setInterval(0)
        self._moved_timer.timeout.connect(self._follow_cards)
        self.viewer.moved.connect(self._moved_timer.start)
        self.viewer.settled.connect(self.settle)
        self.viewer.cancelled.connect(self._on_cancelled)
        self.viewer.zoomed.connect(self._on_zoomed)
        self.viewer.looked.connect(self._show_minimap)
        self.viewer.double_click.connect(self._on_double_click)
        self.viewer.clicked.connect(self._on_clicked)
        self.viewer.menu_wanted.connect(self._on_menu)
        self.viewer.data_dropped.connect(self._on_data_dropped)
        self.viewer.scene().selectionChanged.connect(self._on_selection)

    # -- for subclasses --------------------------------------------------------------

    def _item_kind(self, card: Any) -> type[NodeFace]:
        raise NotImplementedError

    def render_document(self) -> None:
        """Shows the document as it is now, touched nodes included."""
        raise NotImplementedError

    def settle(self) -> None:
        """Turns what a gesture asked for into one edit or none, and heals the view."""
        raise NotImplementedError

    def _route(self, moved: Iterable[str] | None = None) -> None:
        """Every pipe's way; with ``moved``, only what these cards change."""
        raise NotImplementedError

    def _sign(self, changed: Iterable[str]) -> None:
        """Pipes have the signs of what these cards say, where they do not say so themselves."""

    def _rename_card(self, uid: str, name: str) -> None:
        raise NotImplementedError

    def delete_selection(self) -> None:
        raise NotImplementedError

    def _advise(self) -> str:
        """What to do first on a drawing that has next to nothing yet; "" on others."""
        return ""

    # -- showing -----------------------------------------------------------------------

    def _show(self, cards: dict[str, Any], links: dict[tuple[str, ...], Any]) -> None:
        cards, links = self.filling.take(cards, links)
        chosen = [p.link.id for p in self.viewer.selected_pipes() if p.link is not None]
        self._quiet += 1
        try:
            first = not self.graph.cards
            changed = self.graph.show_picture(cards, links)
            self.viewer.drop_dead_ends()
            for id in chosen:
                pipe = self.graph.pipe(id)
                if pipe is not None:
                    pipe.setSelected(True)
            if self._row is not None and self._row[0] not in cards:
                self._row = None
        finally:
            self._quiet -= 1
        if self._editor is not None and self._editor.key not in cards:
            self._editor.close_editor()
        if self.viewer.spoken_as is not None:
            self.viewer.spoken_as.on_shown()
        self._moved_timer.stop()
        self._sign(changed)
        few = len(links) <= self.few or first or 3 * len(changed) > len(cards)
        self._route(None if few and not self.filling.is_filling else changed)
        self.minimap.redraw()
        self._show_minimap()
        self.advice.say(self._advise())
        self._on_selection()
        if not self._fitted and cards and self.isVisible():
            self._fitted = True
            self.zoom_to_begin()

    def _on_filled(self) -> None:
        """The last of many cards is there."""
        self.render_document()
        self._route()

    def _follow_cards(self) -> None:
        """Cards are being dragged: the pipes follow."""
        self._route(self.graph.moved(self.viewer.touched))
        self.minimap.redraw()

    def set_theme(self, theme: Theme) -> None:
        self.look.set_theme(theme)
        for node in self.graph.nodes.values():
            node.view.prepare()
        self.zoom_bar.set_theme(theme)
        self.advice.set_theme(theme)
        self.viewer.viewport().update()
        self.minimap.redraw()

    def showEvent(self, event: Any) -> None:
        super().showEvent(event)
        if not self._fitted and self.graph.cards:
            self._fitted = self._begins = True
            QTimer.singleShot(0, self, self._begin)

    def _begin(self) -> None:
        """Unless somebody has said meanwhile where to look."""
        if self._begins:
            self.zoom_to_begin()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.zoom_bar.move(8, self.height() - self.zoom_bar.height() - 8)
        self.minimap.move(
            self.width() - self.minimap.width() - 8, self.height() - self.minimap.height() - 8
        )
        self._show_minimap()
        self.advice.place()

    def _show_minimap(self) -> None:
        """Where there is room, and something out of sight."""
        room = self.minimap.wanted and self.height() >= 560 and self.width() >= 500
        if room:
            seen = self.viewer.seen()
            room = not all(seen.contains(self.card_area(uid)) for uid in self.graph.cards)
        self.minimap.setVisible(room)
        if room:
            self.minimap.update()

    # -- zoom ---------------------------------------------------------------------------

    def zoom(self) -> float:
        """1.0 is 100 %."""
        return self.look.zoom

    def set_zoom(self, factor: float) -> None:
        """Around the middle of the canvas."""
        self.viewer.zoom_to(factor)

    def looking(self) -> tuple[float, float, float]:
        """Where it looks: the zoom, and the scene's point in the upper left corner."""
        corner = self.viewer.seen().topLeft()
        return self.look.zoom, corner.x(), corner.y()

    def look_at(self, looking: tuple[float, float, float]) -> None:
        """Looks where ``looking`` said."""
        self._fitted, self._begins = True, False
        zoom, left, top = looking
        size = QSizeF(self.viewer.viewport().size()) / zoom
        self.viewer.show_area(QRectF(QPointF(left, top), size), zoom)

    def zoom_to_fit(self) -> None:
        """The whole drawing, at most at 100 %."""
        self.viewer.show_area(self.extent().adjusted(-24, -24, 24, 8), below=BAR)

    def zoom_to_begin(self) -> None:
        """The whole drawing where it can be read so, else its upper left corner at 80 %, or what
        it begins with where that lies elsewhere."""
        area = self.extent().adjusted(-24, -24, 24, 24)
        size = QSizeF(self.viewer.viewport().size())
        if min(size.width() / area.width(), (size.height() - BAR) / area.height()) >= FULL:
            self.zoom_to_fit()
            return
        room = QRectF(area.topLeft(), size / READABLE)
        first = self._first()
        if first is not None and not room.contains(self.card_area(first)):
            room.moveTopLeft(self.card_area(first).topLeft() - QPointF(56, 56))
        self.viewer.show_area(room, READABLE)

    def _first(self) -> str | None:
        """The card that the drawing begins with, if one does."""
        return None

    def _area_of(self, places: Iterable[Place]) -> QRectF:
        area = QRectF()
        for place in places:
            uid, _ = self._find(place)
            if uid is not None:
                area = area.united(self.card_area(uid))
        return area

    def bring_into_view(self, places: Iterable[Place]) -> None:
        """Moves the drawing as far as needed so that the cards of these places are seen."""
        area = self._area_of(places)
        if not area.isEmpty() and not self.viewer.seen().contains(area):
            self.viewer.reveal(area)

    def zoom_to(self, places: Iterable[Place]) -> None:
        """Cards of these places, moved into view; zoomed out only where they do not fit."""
        area = self._area_of(places)
        if not area.isEmpty():
            wide = self.viewer.seen()
            if area.width() > wide.width() or area.height() > wide.height():
                self.viewer.show_area(area.adjusted(-40, -40, 40, 40))
            elif self.look.zoom < 0.4:
                self.viewer.zoom_to(0.8)
                self.viewer.show_area(
                    QRectF(area.center() - QPointF(1, 1), area.center() + QPointF(1, 1)), 0.8
                )
            else:
                self.viewer.reveal(area)

    def zoom_to_selection(self) -> None:
        area = QRectF()
        for uid in self.selected_uids():
            area = area.united(self.card_area(uid))
        if not area.isEmpty():
            self.viewer.show_area(area.adjusted(-60, -60, 60, 60))

    def _step_zoom(self, direction: int) -> None:
        now = self.look.zoom
        if direction > 0:
            self.set_zoom(next((z for z in ZOOMS if z > now * 1.01), ZOOMS[-1]))
        else:
            self.set_zoom(next((z for z in reversed(ZOOMS) if z < now * 0.99), ZOOMS[0]))

    def zoom_in(self) -> None:
        self._step_zoom(1)

    def zoom_out(self) -> None:
        self._step_zoom(-1)

    def _on_cancelled(self) -> None:
        self.graph.take_intents()
        if self.viewer.touched:
            self.render_document()

    def _on_zoomed(self, zoom: float) -> None:
        self.zoom_bar.set_zoom(zoom)
        if self._editor is not None:
            self._editor.close_editor()
        self.zoomed.emit(zoom)

    def extent(self) -> QRectF:
        """What the drawing takes, pipes included."""
        area = QRectF()
        for uid in self.filling.cards:
            area = area.united(self.card_area(uid))
        for id in self.graph.links:
            pipe = self.graph.pipe(id)
            if pipe is not None:
                area = area.united(pipe.boundingRect())
        return area

    def cards_at(self, places: Iterable[Place]) -> set[str]:
        """The uids of the cards that these places are or lie on."""
        return {uid for uid, _ in map(self._find, places) if uid is not None}

    def arrange_like(self, other: Any) -> None:
        """Shows what has no place in the file where ``other``, of the same kind, shows it."""

    def card_area(self, uid: str) -> QRectF:
        node = self.graph.nodes.get(uid)
        if node is None:
            card = self.filling.cards[uid]
            return QRectF(card.x, card.y, card.width, card.height)
        view = node.view
        return QRectF(view.x(), view.y(), view.width, view.height)

    # -- mouse and keys ---------------------------------------------------------------------

    def _on_clicked(self, item: Any, spot: QPointF) -> None:
        if isinstance(item, Spot) and item.node is not None:
            self._choose_exit(item.node, item.name)
        elif isinstance(item, RoutedPipe) and item.link is not None:
            on_sign = item.sign_area().contains(spot)
            link = item.wrong() if on_sign else item.link
            if on_sign or not item.isSelected():
                self.select([self.link_place(link.id)])
            if on_sign:
                self.mends_asked.emit()

    def _choose_exit(self, card: NodeFace, exit: str) -> None:
        """A click on an exit selects its transition."""
        self.select([self._place(card.uid, exit)])

    def _on_double_click(self, card: NodeFace, spot: QPointF) -> None:
        if spot.y() < 28:
            self.edit_name(card.uid)
        else:
            self.activated.emit(self._place(card.uid))

    def place_at(self, spot: QPointF) -> Place:
        """What lies at a spot of the scene, as a place; () for the ground."""
        return self._place_of(self.viewer.hit(spot))

    def _place_of(self, item: Any) -> Place:
        if isinstance(item, Spot):
            return self._place(item.node.uid, item.name)
        if isinstance(item, NodeFace):
            return self._place(item.uid)
        if isinstance(item, RoutedPipe) and item.link is not None:
            return self.link_place(item.link.id)
        return ()

    def _on_data_dropped(self, mime: QMimeData, spot: QPoint) -> None:
        if mime.hasFormat(kinds.MODULE_MIME):
            name = bytes(mime.data(kinds.MODULE_MIME).data()).decode()
            self.module_dropped.emit(name, self.place_at(QPointF(spot)))
            return
        name = bytes(mime.data(kinds.MIME).data()).decode()
        kind = next((k for k in kinds.KINDS if k.name == name), None)
        if kind is not None:
            self.drop_kind(kind, QPointF(spot))

    def drop_kind(self, kind: kinds.Kind, spot: QPointF) -> None:
        """Something was dragged here from the palette."""
        place = self.place_at(spot)
        if kind.file:
            self.media_asked.emit(place, kind.name, None)
            return
        try:
            after, made, text = insert(self.document, kind, place)
        except NotHere as error:
            self.status.emit(str(error))
            return
        if text:
            self.edited.emit(after, text)
        self.select([made])

    def _on_menu(self, item: Any, at: QPoint) -> None:
        self.pointed = self.viewer.mapToScene(self.viewer.viewport().mapFromGlobal(at))
        self.menu_requested.emit(self._place_of(item), at)

    def menu_corner(self) -> QPoint:
        """Where on the screen a menu about the selection opens."""
        area = self._area_of(self.selection())
        spot = area.center() if not area.isEmpty() else self.viewer.seen().center()
        corner: QPoint = self.viewer.viewport().mapToGlobal(self.viewer.mapFromScene(spot))
        return corner

    def _key(self, event: QKeyEvent) -> bool:
        key, held = event.key(), event.modifiers()
        control = bool(held & Qt.KeyboardModifier.ControlModifier)
        arrows = {
            Qt.Key.Key_Left: (-1, 0),
            Qt.Key.Key_Right: (1, 0),
            Qt.Key.Key_Up: (0, -1),
            Qt.Key.Key_Down: (0, 1),
        }
        if key in arrows:
            across, down = arrows[Qt.Key(key)]
            if control:
                self.nudge(across, down)
            else:
                self.step(across, down)
            return True
        if key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
            self.step_in_order(-1 if key == Qt.Key.Key_Backtab else 1)
            return True
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2):
            self.rename()
            return True
        if key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.delete_selection()
            return True
        if key == Qt.Key.Key_Escape:
            self.clear_selection()
            return True
        if control and key == Qt.Key.Key_A:
            self.select_all()
            return True
        if event.text().isalnum() and not control:
            return self.step_to_letter(event.text())
        return False

    def nudge(self, across: int, down: int) -> None:
        """Moves the selected cards by keys; not every canvas has cards that move."""

    # -- names --------------------------------------------------------------------------------

    def rename(self) -> None:
        """Edits the selected card's name in place."""
        uids = self.selected_uids()
        if len(uids) == 1:
            self.edit_name(uids[0])

    def name_area(self, uid: str) -> QRectF:
        """Where the card's name stands, in the scene."""
        area = self.card_area(uid)
        return QRectF(area.left() + 29, area.top() + 2, area.width() - 33, 24)

    def edit_name(self, uid: str) -> None:
        self.viewer.reveal(self.card_area(uid))
        corner = self.viewer.mapFromScene(self.name_area(uid).topLeft())
        size = self.name_area(uid).size() * self.look.zoom
        name = self.graph.cards[uid].name
        editor = name_editor(uid, name, self.look, self.viewer.viewport())
        self._begin_editor(editor)
        wide, high = max(120, round(size.width())), max(24, round(size.height()))
        editor.open_at(QRect(corner.x(), corner.y(), wide, high))

    def _begin_editor(self, editor: InPlace | NoteEditor) -> None:
        """A field over the drawing, of which there is one at a time."""
        if self._editor is not None:
            self._editor.close_editor()
        editor.finished.connect(self._on_named)
        self._editor = editor

    def _on_named(self, uid: str, name: str | None, onwards: int) -> None:
        self._editor = None
        self.viewer.setFocus()
        if name and uid in self.graph.cards and name != self.graph.cards[uid].name:
            self._rename_card(uid, name)
        if onwards:
            self.step_in_order(onwards)
            self.rename()

    def cards_in_view(self) -> Sequence[str]:
        """Uids of the cards that are at least partly seen."""
        seen = self.viewer.seen()
        return [uid for uid in self.graph.cards if seen.intersects(self.card_area(uid))]
