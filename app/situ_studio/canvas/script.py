"""The canvas of a script: what is observed, when situations hold, and who may move the robot."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from PySide6.QtCore import QPointF, QRectF, QSizeF
from PySide6.QtGui import QPainter, QResizeEvent, Qt
from PySide6.QtWidgets import QWidget

from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.spds import Spds
from situ_studio.canvas import headings, script_piping, script_spoken, spoken
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.base import BAR, READABLE
from situ_studio.canvas.curves import CurvedPipe
from situ_studio.canvas.curving import Curving
from situ_studio.canvas.graph import differing
from situ_studio.canvas.ground import ZOOM_LEAST
from situ_studio.canvas.headings import Headings
from situ_studio.canvas.live import LiveScript
from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.script_commands import ScriptCommands
from situ_studio.canvas.script_faces import STRIP, ScriptNode, ScriptPicture
from situ_studio.canvas.script_landing import Landing
from situ_studio.canvas.script_laws import Laws
from situ_studio.canvas.script_layout import Columns
from situ_studio.canvas.script_nodes import ScriptItem
from situ_studio.canvas.script_priorities import Priorities
from situ_studio.canvas.script_projection import ScriptProjector
from situ_studio.copying.script_clipboard import ScriptCopying
from situ_studio.edits.edit import Place
from situ_studio.kinds import Kind
from situ_studio.looks.theme import Theme
from situ_studio.wording.language import tr


class ScriptCanvas(ScriptCommands):
    """Shows a script; gestures become ``edited``. Positions are the canvas's, never the file's.

    project: the project as it is at the time of the call.
    """

    def __init__(
        self,
        theme: Theme,
        parent: QWidget | None = None,
        project: Callable[[], Project | None] = lambda: None,
    ) -> None:
        super().__init__(theme, parent)
        self.project = project
        self.document = Spds(name="")
        self._picture = ScriptPicture({}, {}, {})
        self._projector = ScriptProjector()
        self._laws = Laws()
        self.origin = ""
        self._copying = ScriptCopying(self, lambda: self.document, self._laws)
        self.copy, self.cut = self._copying.copy, self._copying.cut
        self.paste, self.duplicate = self._copying.paste, self._copying.duplicate
        self.priorities = Priorities(self, self._prioritise, self.status.emit)
        self.curving = Curving(self, self.priorities)
        self.landing = Landing(self)
        self.menu = self.test_editor = self.field_editor = None
        self._drop: tuple[Any, Any, QPointF] | None = None
        self._why_not: tuple[ScriptNode, ScriptNode] | None = None
        self._fresh: list[tuple[str, ...]] = []
        self._on_way: set[tuple[str, ...]] = set()
        self._groups: tuple[Place, ...] = ()
        self._lines: tuple[Place, ...] = ()
        self._choosing = self._rendering = False
        self.minimap.wanted = False
        self.headings = Headings(self.viewer, self.look, self)
        self.viewer.looked.connect(self.headings.update)
        self.viewer.pipe_kind = CurvedPipe
        self.viewer.accepts = self._accepts
        self.viewer.on_ground = self._draw_headings
        self.viewer.dropped.connect(self._on_dropped)
        self.viewer.refused.connect(self._on_refused)
        self.selection_changed.connect(self._on_chosen)

    def _item_kind(self, card: Any) -> type[NodeFace]:
        return ScriptItem

    # -- showing -----------------------------------------------------------------------

    def show_document(self, document: Spds, problems: Sequence[Problem] = ()) -> None:
        self.document = document
        self._problems = tuple(problems)
        self.render_document()

    def render_document(self) -> None:
        old = self._picture
        new = self._picture = self._projector.picture(self.document, self._problems)
        gone, self._fresh = differing(old.links, new.links)
        for id in gone:
            self.priorities.forget(id)
        self._rendering = True
        try:
            self._show(new.cards, new.links)
        finally:
            self._rendering = False
        self._on_chosen()
        self._follow_test()

    def arrange_like(self, other: ScriptCanvas) -> None:
        self._projector.columns.like(other._projector.columns)

    def auto_layout(self) -> None:
        """Every card near what it belongs to, as when the script was opened; no edit."""
        self._projector.columns.like(Columns())
        self.render_document()

    def _route(self, moved: Iterable[str] | None = None) -> None:
        if moved is None:
            self.priorities.begin()
            self.curving.curve(self.graph.links, self.few)
        else:
            links = (id for key in moved for id in self.graph.links_at(key))
            self.curving.curve((*self._fresh, *links), self.few)
        self._fresh = []
        if not self._rendering:
            self._show_taken_over()

    def port_at(self, key: str, port: str) -> QPointF:
        """Where a port is in the scene now, in the middle of a drag too."""
        view = self.graph.nodes[key].view
        x, y = self._picture.cards[key].port(port)
        return QPointF(view.x() + x, view.y() + y)

    def around(self, spot: QPointF) -> QRectF:
        return QRectF(spot.x() - 28, spot.y() - 13, 56, 26)

    def _on_chosen(self, _: Any = None) -> None:
        if self._rendering:
            # What is asked for last sees all pipes on their way.
            return
        self._show_taken_over()
        self._mark_way()
        self._mark_rows()

    def _show_taken_over(self) -> None:
        """Priorities that the selected situation takes over, dashed."""
        self.priorities.show_taken_over(self.document, self._picture, self._shown_situation())

    def _shown_situation(self) -> list[str]:
        """The situation that is selected, or of which a priority is."""
        keys = self.selected_uids()
        if not keys:
            chosen = [p for p in self.selection() if p[0] == "situation" and p[2:3] == ("entry",)]
            keys = list(dict.fromkeys(self._picture.uids.get(p[:2], "") for p in chosen))
        return [key for key in keys if key in self._picture.cards]

    def _mark_way(self) -> None:
        """The pipes that lead to the selected situation and on from it, without touching it."""
        links = self._picture.links
        wanted: set[tuple[str, ...]] = set()
        for key in self._shown_situation():
            near = [links[id] for id in self.graph.links_at(key) if id in links]
            for link in near if self._picture.cards[key].kind == "situation" else ():
                end = link.source if link.kind == "holds" else link.target
                beyond = "observes" if link.kind == "holds" else "uses"
                for id in self.graph.links_at(end):
                    if id in links and links[id].kind == beyond:
                        wanted.add(id)
        for id in wanted ^ self._on_way:
            pipe = self.graph.pipe(id)
            if pipe is not None:
                pipe.chosen = id in wanted
                pipe.refresh()
        self._on_way = wanted

    def _mark_rows(self) -> None:
        """The lines of conditions that are selected."""
        chosen: dict[str, set[str]] = {}
        for place in self.selection():
            key = self._picture.uids.get(place[:3])
            if key is not None and len(place) > 3:
                chosen.setdefault(key, set()).add("/".join(place[3:]))
        for key, node in self.graph.nodes.items():
            rows = frozenset(chosen.get(key, ()))
            if node.view.chosen_rows != rows:
                node.view.chosen_rows = rows
                node.view.update()

    def _draw_headings(self, painter: QPainter) -> None:
        if self.look.on_paper:
            headings.draw(painter, self.look)

    def extent(self) -> QRectF:
        return super().extent().united(headings.EXTENT)

    def zoom_to_fit(self) -> None:
        """The whole drawing, at most at 100 %, right below the headings."""
        size, area = self._room()
        self._look_from_top(min(1.0, size.width() / area.width(), size.height() / area.height()))

    def zoom_to_begin(self) -> None:
        """All columns, where they can be read so; what is further down is scrolled to."""
        size, area = self._room()
        self._look_from_top(max(READABLE, min(1.0, size.width() / area.width())))

    def _room(self) -> tuple[QSizeF, QRectF]:
        """What the drawing can have of the window, and what it takes of the scene."""
        size = QSizeF(self.viewer.viewport().size())
        return size - QSizeF(0, BAR), self.extent().adjusted(-24, -8, 24, 0)

    def _look_from_top(self, zoom: float) -> None:
        size, area = self._room()
        zoom = max(ZOOM_LEAST, zoom)
        wide = size.width() / zoom
        left = area.center().x() - wide / 2 if area.width() <= wide else area.left()
        # The headings are as high at any zoom.
        below = super().extent().top() - (headings.HIGH + 4) / zoom
        self.look_at((zoom, left, min(area.top(), below)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.headings.setGeometry(0, 0, self.width(), headings.HIGH)

    def set_theme(self, theme: Theme) -> None:
        super().set_theme(theme)
        self.headings.update()

    def _advise(self) -> str:
        if not self.document.situations:
            return self.tr(
                "No situation yet. Drag Situation, Data and Module from the palette to here, then "
                "from card to card, from left to right."
            )
        if len(self.document.situations) == 1 and not self.document.observe:
            return self.tr(
                "When shall something else go first? Press Data in the palette and name what the "
                "robot notices, then drag from its right edge to an empty place: a situation."
            )
        return ""

    def set_live(self, live: LiveScript | None) -> None:
        """Current situation, what holds, who holds what; None for none."""
        self.look.live = live
        for node in self.graph.nodes.values():
            node.view.update()
        for id in self.graph.links:
            pipe = self.graph.pipe(id)
            if pipe is not None:
                pipe.update()
        self.minimap.redraw()

    def choose_copies(self, made: tuple[Place, ...]) -> None:
        self.select(made)
        self.bring_into_view(list(made[:1]))

    # -- gestures become edits -------------------------------------------------------------

    def _accepts(self, start: Any, end: Any) -> bool:
        source, target = start.node.face, end.node.face
        return script_piping.accepts(source, target)

    def _follow_cards(self) -> None:
        self.landing.follow(self.graph.moved(self.viewer.touched))
        super()._follow_cards()

    def _on_cancelled(self) -> None:
        self.landing.end()
        super()._on_cancelled()

    def settle(self) -> None:
        self.landing.end()
        moved = self.graph.moved(self.viewer.touched)
        connections, slices = self.graph.take_intents()
        edit: tuple[Spds, str, Place] = (self.document, "", ())
        if connections:
            edit = self._connected(*connections[-1])
        elif slices:
            gone = [self._between(leaving, entry) for cut in slices for entry, leaving in cut]
            edit = *gestures.delete(self.document, [p for p in gone if p]), ()
        elif moved:
            edit = *self._reordered(moved), ()
        self._edit(*edit)
        if self.viewer.touched:
            self.render_document()
        drop, self._drop = self._drop, None
        if drop is not None:
            self._after_drop(*drop)
        why_not, self._why_not = self._why_not, None
        if why_not is not None:
            self.status.emit(script_piping.refusal(*why_not))

    def _between(self, leaving: Any, entry: Any) -> Place:
        """The place of the pipe between two ports; () where there is none to change."""
        if leaving.node is None or entry.node is None:
            return ()
        link = self._picture.links.get((leaving.node.uid, leaving.name, entry.node.uid, entry.name))
        return link.place if link is not None else ()

    def _connected(self, gone: list[Any], made: list[Any]) -> tuple[Spds, str, Place]:
        leaving, entry = made[0]
        if leaving.node is None or entry.node is None:
            return self.document, "", ()
        old = self._between(*gone[0]) if gone else ()
        source, target = leaving.node.face, entry.node.face
        if not script_piping.accepts(source, target):
            return self.document, "", ()
        return script_piping.connect(self.document, source, target, entry.name, old)

    def _reordered(self, moved: dict[str, tuple[float, float]]) -> tuple[Spds, str]:
        """The situation that was dragged goes where it was dropped among the others."""
        dragged = self.dragged(moved)
        if dragged is None:
            return self.document, ""
        index = self.index_at(moved[dragged.uid][1] + dragged.height / 2, dragged.uid)
        return gestures.reorder(self.document, dragged.name, index)

    def dragged(self, moved: Mapping[str, tuple[float, float]]) -> ScriptNode | None:
        """Of cards that are elsewhere the situation that was dragged farthest."""
        if not moved:
            return None
        key = max(moved, key=lambda k: abs(moved[k][1] - self._picture.cards[k].y))
        dragged = self._picture.cards[key]
        return dragged if dragged.kind == "situation" else None

    def index_at(self, y: float, but: str = "") -> int:
        """Which place among the situations a height stands for."""
        every = self._picture.cards.values()
        others = (c for c in every if c.kind == "situation" and c.uid != but)
        return sum(1 for c in others if c.y + c.height / 2 < y)

    def _on_dropped(self, leaving: Any, spot: QPointF) -> None:
        self._drop = leaving, self.viewer._detached_port, spot

    def _on_refused(self, leaving: Any, spot: QPointF) -> None:
        faces = [item for item in self.viewer.scene().items(spot) if isinstance(item, NodeFace)]
        if leaving.node is not None and faces and self.viewer._detached_port is None:
            self._why_not = leaving.node.face, faces[0].face

    def _after_drop(self, leaving: Any, detached: Any, spot: QPointF) -> None:
        """A pipe that was pulled off goes; one that was begun goes where a pipe leads on which it
        was dropped, or asks what it shall lead to."""
        if leaving.node is None:
            return
        if detached is not None:
            place = self._between(leaving, detached)
            if place:
                self._edit(*gestures.delete(self.document, [place]))
            return
        source: ScriptNode = leaving.node.face
        hit = self.viewer.hit(spot)
        link = hit.link if isinstance(hit, CurvedPipe) else None
        if link is not None and link.source != source.uid:
            target = self._picture.cards[link.source if link.kind == "holds" else link.target]
            if script_piping.accepts(source, target):
                edit = script_piping.connect(self.document, source, target, link.entry, ())
                self._edit(*edit)
                return
        if script_piping.choices(self.document, source):
            self._ask_from(source, spot, self.index_at(spot.y()))
        else:
            self.status.emit(script_piping.refusal(source, source))

    def drop_kind(self, kind: Kind, spot: QPointF) -> None:
        """What was dragged from the palette; what it was dropped on says what it belongs to."""
        item = self.viewer.hit(spot)
        node: ScriptNode | None = item.face if isinstance(item, NodeFace) else None
        if isinstance(item, CurvedPipe) and item.link is not None:
            at = item.link.source if item.link.kind in ("holds", "priority") else item.link.target
            node = self._picture.cards[at]
        about = "" if node is None or node.kind not in ("situation", "condition") else node.name
        match kind.name:
            case "data":
                self.add_data()
            case "situation":
                tag = node.name if node is not None and node.kind == "data" else ""
                index = self.index_at(spot.y())
                after, text, name = gestures.add_situation(self.document, index, tag)
                self._edit(after, text, ("situation", name))
            case "module":
                after, text, name = gestures.add_module(self.document, about or None)
                self._edit(after, text, ("module", name))
            case "condition" if about:
                self.select([node.place if node is not None else ("situation", about)])
                word = "until" if node is not None and node.until else "condition"
                self._ask_data(word, self.tr("When what?"))
            case "condition":
                self.status.emit(self.tr("Drop a condition on the situation that it is of"))

    # -- clicks -----------------------------------------------------------------------------

    def _on_clicked(self, item: Any, spot: QPointF) -> None:
        over = self.priorities.taken_over_at(spot)
        if over is not None and (item is None or isinstance(item, CurvedPipe)):
            self.priorities.override(over)
            return
        several = bool(self.viewer.held & Qt.KeyboardModifier.ControlModifier)
        if item is None and self._groups and not several:
            self.clear_selection()
        if isinstance(item, ScriptItem) and item.face.kind == "condition":
            self._on_row(item, item.mapFromScene(spot), several)
            return
        super()._on_clicked(item, spot)
        on_pill = isinstance(item, CurvedPipe) and item.pill().contains(spot)
        if on_pill and not several and not item.sign_area().contains(spot):
            self.select([self.link_place(item.link.id)])
            self.priorities.edit(item)

    def _on_row(self, item: ScriptItem, at: QPointF, several: bool) -> None:
        """A click on a line of a condition selects it; with Ctrl, it too or no longer."""
        row = item.face.row_at(at.y()) if at.x() > STRIP else None
        if row is None:
            return
        place = (*item.face.place, *row.tail)
        before = list(self._lines) if several else []
        if place in before:
            before.remove(place)
            self.select(before)
        else:
            self.select([*before, place])

    def _choose_exit(self, card: NodeFace, exit: str) -> None:
        self.select([self._place(card.uid)])

    def _on_double_click(self, card: NodeFace, spot: QPointF) -> None:
        """Edits what it was on: a name, a line of a condition, its sign, a time, a type."""
        node: ScriptNode = card.face
        if node.kind == "condition":
            row = node.row_at(spot.y())
            if spot.x() <= STRIP and node.joint:
                self.ask_joint(node.place)
            elif row is not None and spot.x() > STRIP:
                self.select([(*node.place, *row.tail)])
                self.rename()
            return
        line = node.line_of(spot.y()) if spot.x() > STRIP else ""
        if line == "":
            self.activated.emit(node.place)
        elif line == "times":
            situation = self.document.situation(node.name)
            limited = situation is not None and situation.limit is not None
            (self.edit_limit if limited else self.edit_dwell)()
        elif line == "extends":
            self.ask_extends()
        elif line == "detail" and node.kind == "data":
            self.ask_type()
        else:
            self.edit_name(card.uid)

    # -- for screen readers -------------------------------------------------------------------

    def spoken(self, uid: str) -> spoken.Spoken:
        return script_spoken.node(self.document, self._picture, self._picture.cards[uid])

    def lately(self, uid: str) -> str:
        node, live = self._picture.cards[uid], self.look.live
        current = isinstance(live, LiveScript) and (node.kind, node.name) == (
            "situation",
            live.situation,
        )
        return tr("It is the current situation.") if current else ""
