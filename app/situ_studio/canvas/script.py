"""The canvas of a script: what is observed, when situations hold, and who may move the robot."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QKeyEvent, QPainter
from PySide6.QtWidgets import QWidget

from situ.document.problem import Problem
from situ.document.spds import Spds
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.base import Canvas
from situ_studio.canvas.curves import CurvedPipe, InheritedPipe
from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.live import LiveScript
from situ_studio.canvas.menu import FollowMenu
from situ_studio.canvas.nodes import NodeFace
from situ_studio.canvas.overlay import InPlace, priority_editor
from situ_studio.canvas.script_nodes import ScriptItem
from situ_studio.canvas.script_projection import (
    LEFT,
    OUT,
    TITLES,
    TOP,
    ScriptLink,
    ScriptNode,
    ScriptPicture,
    inherited,
    named,
    picture,
    uid,
)
from situ_studio.canvas.style import Label
from situ_studio.edit import Place
from situ_studio.theme import Theme

TAKES = {
    "data": ("condition", "situation"),
    "situation": ("module",),
    "module": ("resource",),
}
"""Which kinds a pipe from a kind may go to."""


class ScriptCanvas(Canvas):
    """Shows a script; gestures become ``edited``. Positions are the canvas's, never the file's."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(theme, parent)
        self.document: Spds = Spds(name="")
        self._picture = ScriptPicture({}, {}, {}, TOP)
        self._taken_over: list[InheritedPipe] = []
        self._drop: tuple[Any, Any, QPointF] | None = None
        self._pill_editor: InPlace | None = None
        self._titles = [(LEFT[k], Label(t, 12, 600)) for k, t in TITLES.items()]
        self.menu: FollowMenu | None = None
        self.minimap.wanted = False
        self.viewer.pipe_kind = CurvedPipe
        self.viewer.accepts = self._accepts
        self.viewer.on_ground = self._draw_titles
        self.viewer.dropped.connect(self._on_dropped)
        self.selection_changed.connect(self._show_taken_over)

    def _item_kind(self, card: Any) -> type[NodeFace]:
        return ScriptItem

    # -- showing -----------------------------------------------------------------------

    def show_document(self, document: Spds, problems: Sequence[Problem] = ()) -> None:
        self.document = document
        self._problems = tuple(problems)
        self.render_document()

    def render_document(self) -> None:
        old = self._picture.cards
        self._picture = picture(self.document, self._problems)
        # What did not change keeps its identity, so that it is not built again.
        cards = {
            key: old[key] if key in old and old[key] == node else node
            for key, node in self._picture.cards.items()
        }
        self._picture.cards = cards
        self._show(cards, self._picture.links)
        self._show_taken_over()

    def _route(self, moved: Iterable[str] | None = None) -> None:
        beside: dict[str, int] = {}
        for id, link in self._picture.links.items():
            pipe = self.graph.pipe(id)
            if pipe is None or link.source not in self.graph.nodes:
                continue
            order = beside[link.source] = beside.get(link.source, -1) + 1
            start, end = self._end(link.source, link.exit), self._end(link.target, link.entry)
            pipe.set_curve(start, end, 0.62 if order % 2 == 0 else 0.7)
        self._mark_way()

    def _end(self, key: str, port: str) -> QPointF:
        view = self.graph.nodes[key].view
        x, y = self._picture.cards[key].port(port)
        return QPointF(view.x() + x, view.y() + y)

    def _mark_way(self) -> None:
        """The pipes that lead to the selected situation and on from it."""
        chosen: set[str] = set()
        for key in self.selected_uids():
            node = self._picture.cards.get(key)
            if node is not None and node.kind == "situation":
                chosen.add(uid("condition", key.removeprefix("situation ")))
                situation = self.document.situation(node.name)
                if situation is not None:
                    chosen |= {uid("module", e.module) for e in situation.entries}
        for id, link in self._picture.links.items():
            pipe = self.graph.pipe(id)
            if pipe is None:
                continue
            on_way = (link.kind == "observes" and link.target in chosen) or (
                link.kind == "uses" and link.source in chosen
            )
            if pipe.chosen != on_way:
                pipe.chosen = on_way
                pipe.refresh()

    def _show_taken_over(self, _: Any = None) -> None:
        """Priorities that the selected situation takes over, dashed."""
        for item in self._taken_over:
            self.viewer.release_pipe(item)
        self._taken_over = []
        self._mark_way()
        keys = [k for k in self.selected_uids() if self._picture.cards[k].kind == "situation"]
        if len(keys) != 1:
            return
        key = keys[0].removeprefix("situation ")
        pairs = zip(
            self.document.situations,
            named(s.name for s in self.document.situations),
            strict=True,
        )
        situation = next((s for s, (_, k) in pairs if k == key), None)
        if situation is None:
            return
        pills = [
            p.pill()
            for i in self.graph.links
            if (p := self.graph.pipe(i)) and p.link.kind == "priority"
        ]
        for value in inherited(self.document, situation, key):
            if value.target not in self.graph.nodes:
                continue
            item = InheritedPipe(self.look, value)
            self.viewer.hold_pipe(item)
            start = self._end(value.source, OUT) + QPointF(0, 8)
            end = self._end(value.target, "in") - QPointF(0, 7)
            for part in (0.22, 0.28, 0.34, 0.4, 0.16, 0.46, 0.52, 0.58, 0.25):
                item.set_curve(start, end, part)
                if not any(item.pill().adjusted(-2, -1, 2, 1).intersects(p) for p in pills):
                    break
            pills.append(item.pill())
            self._taken_over.append(item)

    def _draw_titles(self, painter: QPainter) -> None:
        if self.look.level in ("quarter", "tiny"):
            return
        for x, label in self._titles:
            label.draw(painter, x, 26, self.look["text2"])

    def extent(self) -> QRectF:
        return super().extent().united(QRectF(16, 8, 940, 60))

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

    # -- gestures become edits -------------------------------------------------------------

    def _accepts(self, start: Any, end: Any) -> bool:
        source, target = start.node.face, end.node.face
        return target.kind in TAKES.get(source.kind, ())

    def settle(self) -> None:
        moved = self.graph.moved(self.viewer.touched)
        connections, slices = self.graph.take_intents()
        after, text = self.document, ""
        if connections:
            after, text = self._connected(*connections[-1])
        elif slices:
            gone = [self._between(leaving, entry) for cut in slices for entry, leaving in cut]
            after, text = gestures.delete(self.document, [p for p in gone if p])
        elif moved:
            after, text = self._reordered(moved)
        if text:
            self.edited.emit(after, text)
        if self.viewer.touched:
            self.render_document()
        drop, self._drop = self._drop, None
        if drop is not None:
            self._after_drop(*drop)

    def _between(self, leaving: Any, entry: Any) -> Place:
        """The place of the pipe between two ports; () where there is none to change."""
        if leaving.node is None or entry.node is None:
            return ()
        link = self._picture.links.get((leaving.node.uid, leaving.name, entry.node.uid, entry.name))
        return link.place if link is not None else ()

    def _connected(self, gone: list[Any], made: list[Any]) -> tuple[Spds, str]:
        leaving, entry = made[0]
        if leaving.node is None or entry.node is None:
            return self.document, ""
        source: ScriptNode = leaving.node.face
        target: ScriptNode = entry.node.face
        old = self._between(*gone[0]) if gone else ()
        script, text = self.document, ""
        match source.kind:
            case "data":
                name = target.name
                if old and old[1] == name:
                    return self.document, ""
                if old:
                    script, _ = gestures.delete(script, [old])
                script, text = gestures.observe(script, source.name, name)
            case "situation":
                priority: int | None = gestures.new_priority(script, source.name)
                if any(
                    e.module == target.name
                    for s in script.situations
                    if s.name == source.name
                    for e in s.entries
                ):
                    return self.document, ""
                if old:
                    link = next((x for x in self._picture.links.values() if x.place == old), None)
                    priority = link.priority if link is not None else priority
                    script, _ = gestures.delete(script, [old])
                script, text = gestures.prioritise(script, source.name, target.name, priority)
            case "module":
                if old:
                    script, _ = gestures.delete(script, [old])
                script, text = gestures.use(script, source.name, target.name)
        return script, text

    def _reordered(self, moved: dict[str, tuple[float, float]]) -> tuple[Spds, str]:
        """The situation that was dragged goes where it was dropped among the others."""
        key = max(moved, key=lambda k: abs(moved[k][1] - self._picture.cards[k].y))
        dragged = self._picture.cards[key]
        if dragged.kind != "situation":
            return self.document, ""
        y = moved[key][1]
        others = [c for c in self._picture.cards.values() if c.kind == "situation" and c.uid != key]
        index = sum(1 for c in others if c.y < y)
        return gestures.reorder(self.document, dragged.name, index)

    def _on_dropped(self, leaving: Any, spot: QPointF) -> None:
        self._drop = leaving, self.viewer._detached_port, spot

    def _after_drop(self, leaving: Any, detached: Any, spot: QPointF) -> None:
        """A pipe that was pulled off goes; one that was begun asks what it shall lead to."""
        if leaving.node is None:
            return
        if detached is not None:
            place = self._between(leaving, detached)
            if place:
                self._edit(*gestures.delete(self.document, [place]))
            return
        source: ScriptNode = leaving.node.face
        choices: list[Follow] = []
        match source.kind:
            case "data":
                choices = [Follow("+situation", "New situation", "situation", "add")]
                kinds = "situation"
            case "situation":
                choices = [Follow("+module", "New module", "module", "add")]
                kinds = "module"
            case "module":
                kinds = "resource"
            case _:
                return
        choices += [
            Follow(f"={c.name}", c.name, kinds)
            for c in self._picture.cards.values()
            if c.kind == kinds
        ]
        menu = FollowMenu(choices, self.look.theme, self)
        menu.chosen.connect(lambda key: self._follow(source, key))
        menu.closed.connect(self._menu_closed)
        self.menu = menu
        menu.popup(self.viewer.viewport().mapToGlobal(self.viewer.mapFromScene(spot)))

    def _menu_closed(self) -> None:
        self.menu = None
        self.viewer.setFocus()

    def _follow(self, source: ScriptNode, key: str) -> None:
        script = self.document
        if source.uid not in self._picture.cards:
            return
        if key == "+situation":
            script, text, name = gestures.add_situation(script)
            script, _ = gestures.delete(script, [("situation", name, "condition", "0")])
            script, _ = gestures.observe(script, source.name, name)
            self._edit(script, text)
            self.select([("situation", name)])
        elif key == "+module":
            script, text, name = gestures.add_module(script, source.name)
            self._edit(script, text)
            self.select([("module", name)])
        elif source.kind == "data":
            self._edit(*gestures.observe(script, source.name, key[1:]))
        elif source.kind == "situation":
            known = {
                e.module for s in script.situations if s.name == source.name for e in s.entries
            }
            if key[1:] not in known:
                priority = gestures.new_priority(script, source.name)
                self._edit(*gestures.prioritise(script, source.name, key[1:], priority))
        else:
            self._edit(*gestures.use(script, source.name, key[1:]))

    # -- priorities, edited where they stand --------------------------------------------------

    def edit_priority(self, link: ScriptLink | None, item: Any, typed: str = "") -> None:
        """Opens the pill's editor: of an entry's pipe, or of one that is taken over."""
        if self._pill_editor is not None:
            self._pill_editor.close_editor()
        if link is not None:
            node = self._picture.cards[link.source]
            situation, module = node.name, self._picture.cards[link.target].name
            text = "none" if link.priority is None else str(link.priority)
        else:
            situation, module = item.value.situation, item.value.module
            text = str(item.value.priority)
        centre = self.viewer.mapFromScene(item.pill()).boundingRect().center()
        key = situation, module
        editor = priority_editor(key, typed or text, self.look, self.viewer.viewport())
        editor.finished.connect(self._on_priority)
        self._pill_editor = editor
        editor.open_at(QRect(centre.x() - 28, centre.y() - 13, 56, 26))
        if typed:
            editor.deselect()
            editor.setCursorPosition(len(typed))

    def _on_priority(self, key: tuple[str, str], value: str | None, _: int) -> None:
        self._pill_editor = None
        self.viewer.setFocus()
        if value is None:
            return
        value = value.strip()
        if value in ("none", "-", ""):
            self._edit(*gestures.prioritise(self.document, *key, None))
        elif value.removeprefix("-").isdigit():
            self._edit(*gestures.prioritise(self.document, *key, int(value)))
        else:
            self.status.emit(f"A priority is a whole number or none, not {value}")

    def _selected_entry(self) -> CurvedPipe | None:
        pipes = [p for p in self.viewer.selected_pipes() if p.link.kind == "priority"]
        return pipes[0] if len(pipes) == 1 and not self.selected_uids() else None

    def _key(self, event: QKeyEvent) -> bool:
        entry = self._selected_entry()
        if entry is not None:
            if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2):
                self.edit_priority(entry.link, entry)
                return True
            if event.text().isdigit():
                self.edit_priority(entry.link, entry, event.text())
                return True
        return super()._key(event)

    def _on_clicked(self, item: Any, spot: QPointF) -> None:
        if item is None:
            over = next((g for g in self._taken_over if g.pill().contains(spot)), None)
            if over is not None:
                self.edit_priority(None, over)
                return
        super()._on_clicked(item, spot)

    def _choose_exit(self, card: NodeFace, exit: str) -> None:
        self.select([self._place(card.uid)])

    # -- commands -------------------------------------------------------------------------------

    def _edit(self, after: Spds, text: str) -> None:
        if text:
            self.edited.emit(after, text)

    def delete_selection(self) -> None:
        self._edit(*gestures.delete(self.document, self.selection()))

    def add_situation(self) -> None:
        after, text, name = gestures.add_situation(self.document)
        self._edit(after, text)
        self.select([("situation", name)])

    def add_module(self) -> None:
        after, text, name = gestures.add_module(self.document)
        self._edit(after, text)
        self.select([("module", name)])

    def add_data(self) -> None:
        after, text, tag = gestures.add_data(self.document)
        self._edit(after, text)
        self.select([("data", tag)])

    def connect_selected(self) -> None:
        """Connects the selected nodes of neighbouring columns."""
        cards = [self._picture.cards[k] for k in self.selected_uids()]
        script, texts = self.document, []
        for source in cards:
            for target in cards:
                text = ""
                if source.kind == "data" and target.kind == "situation":
                    script, text = gestures.observe(script, source.name, target.name)
                elif source.kind == "situation" and target.kind == "module":
                    priority = gestures.new_priority(script, source.name)
                    script, text = gestures.prioritise(script, source.name, target.name, priority)
                elif source.kind == "module" and target.kind == "resource":
                    script, text = gestures.use(script, source.name, target.name)
                texts += [text] if text else []
        self._edit(script, "Connect" if len(texts) > 1 else texts[0] if texts else "")

    def nudge(self, across: int, down: int) -> None:
        """Ctrl with up or down moves a situation in the precedence."""
        nodes = [self._picture.cards[k] for k in self.selected_uids()]
        if len(nodes) == 1 and nodes[0].kind == "situation" and down:
            index = nodes[0].number - 1 + down
            self._edit(*gestures.reorder(self.document, nodes[0].name, index))

    def _rename_card(self, key: str, name: str) -> None:
        node = self._picture.cards[key]
        after, text = gestures.rename(self.document, node.kind, node.name, name)
        self._edit(after, text)
        if text:
            self.select([(node.kind, name)])

    def edit_name(self, uid: str) -> None:
        if self._picture.cards[uid].kind != "condition":
            super().edit_name(uid)

    def name_area(self, uid: str) -> QRectF:
        area = self.card_area(uid)
        return QRectF(area.left() + 34, area.center().y() - 13, area.width() - 38, 26)

    def _on_double_click(self, card: NodeFace, spot: QPointF) -> None:
        if card.face.kind != "condition" and spot.x() > 32:
            self.edit_name(card.uid)
        else:
            self.activated.emit(card.face.place)

    # -- places ----------------------------------------------------------------------------------

    def _place(self, uid: str, exit: str | None = None) -> Place:
        place: Place = self._picture.cards[uid].place
        return place

    def link_place(self, id: tuple[str, ...]) -> Place:
        link = self._picture.links.get(id)
        if link is None:
            return ()
        return link.place or self._picture.cards[link.target].place

    def _find(self, place: Place) -> tuple[str | None, str | None]:
        for end in range(len(place), 0, -1):
            found = self._picture.uids.get(place[:end])
            if found is not None:
                return found, (OUT if len(place) > end else None)
        return None, None
