"""What commands do on the canvas of a script, beside gestures: without a mouse too."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QPointF, QRect, QRectF
from PySide6.QtGui import QKeyEvent, Qt

from situ.document.condition import Group, GroupName, Test
from situ.document.datatypes import write_number
from situ.document.spds import Spds
from situ_studio import places
from situ_studio.canvas import script_conditions as conditions
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas import script_piping as piping
from situ_studio.canvas.base import Canvas
from situ_studio.canvas.curves import CurvedPipe
from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.menu import FollowMenu
from situ_studio.canvas.overlay import InPlace, priority_editor
from situ_studio.canvas.script_faces import LINE, STRIP, ScriptNode, ScriptPicture
from situ_studio.canvas.script_laws import Laws
from situ_studio.canvas.script_priorities import Priorities
from situ_studio.canvas.test_editor import TestEditor
from situ_studio.edit import Place
from situ_studio.kinds import GROUPS, TYPES
from situ_studio.language import translated

ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2)


class ScriptCommands(Canvas):
    """Knows the script as a picture; how it is drawn and dragged is ``ScriptCanvas``'s."""

    document: Spds
    _picture: ScriptPicture
    _laws: Laws
    priorities: Priorities
    menu: FollowMenu | None
    test_editor: TestEditor | None
    seconds_editor: InPlace | None

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
        """Tests and groups that are selected; where a whole condition is, all that is in it."""
        found: list[Place] = []
        for place in self.selection():
            value = places.get(self.document, place)
            if isinstance(value, Test | Group):
                found.append(place)
        return found

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

    # -- asking ----------------------------------------------------------------------------

    def ask(
        self,
        choices: Sequence[Follow],
        asked: str,
        then: Callable[[str], None],
        at: QPointF,
        new: tuple[str, str, str] | None = None,
    ) -> None:
        """A menu over the drawing. new: key, words and icon of what is called as is typed."""
        menu = FollowMenu(choices, self.look.theme, self, asked)
        menu.chosen.connect(then)
        if new is not None:
            key, words, icon = new
            menu.offer_name(words, icon)
            menu.named.connect(lambda name: then(f"{key} {name}"))
        menu.closed.connect(self._menu_closed)
        self.menu = menu
        menu.popup(self.viewer.viewport().mapToGlobal(self.viewer.mapFromScene(at)))

    def _menu_closed(self) -> None:
        self.menu = None
        self.viewer.setFocus()

    def ask_where_to(self) -> None:
        """Asks what the selected node shall lead to."""
        node = self._one_node()
        if node is None or not piping.choices(self.document, node):
            self.status.emit(self.tr("Select data, a situation or a module"))
            return
        self.viewer.reveal(self.card_area(node.uid))
        self._ask_from(node, self.port_at(node.uid, "out"))

    def _ask_from(self, node: ScriptNode, at: QPointF, index: int | None = None) -> None:
        """index: which place among the situations a new one gets."""
        words = piping.new_words(node.kind)
        icon = {"data": "situation", "situation": "module"}.get(node.kind, "resource")
        self.ask(
            piping.choices(self.document, node),
            self.tr("What does it lead to?"),
            lambda key: self._follow(node.uid, key, index),
            at,
            (piping.NEW[node.kind], words, icon) if words else None,
        )

    def _follow(self, key: str, chosen: str, index: int | None) -> None:
        node = self._picture.cards.get(key)
        if node is not None:
            after, text, then = piping.follow(self.document, node, chosen, index)
            self._edit(after, text, then)

    # -- situations -------------------------------------------------------------------------

    def ask_extends(self) -> None:
        """From which situation the selected one takes over."""
        name = self._one_situation()
        if name:
            choices = piping.extensions(self.document, name)
            if not choices:
                self.status.emit(self.tr("There is no other situation to take over from"))
                return
            node = self._picture.cards[self._picture.uids["situation", name]]
            self.ask(
                choices,
                self.tr("Take over from which?"),
                lambda key: self._follow(node.uid, key, None),
                self._below(node.uid),
            )

    def ask_until(self) -> None:
        """Which data shall end the selected situation."""
        self._ask_data("until", self.tr("Until what?"))

    def ask_condition(self) -> None:
        """At which data the selected situation shall look."""
        self._ask_data("condition", self.tr("When what?"))

    def _ask_data(self, word: str, asked: str) -> None:
        name = self._one_situation()
        tags = [c for c in self._picture.cards.values() if c.kind == "data"]
        if name and not tags:
            self.status.emit(self.tr("There is no data yet: add some first"))
        elif name:
            key = self._picture.uids["situation", name]
            self.ask(
                [Follow(f"{word} {c.name}", c.name, "data", c.detail) for c in tags],
                asked,
                lambda chosen: self._observe(("situation", name, word), chosen),
                self._below(key),
            )

    def _observe(self, place: Place, chosen: str) -> None:
        after, text = conditions.observe(self.document, chosen.partition(" ")[2], place)
        latest = conditions.latest(after, place)
        if self._edit(after, text, latest):
            self.edit_test(latest)

    def edit_dwell(self) -> None:
        """How long the selected situation stays at least."""
        self._edit_seconds("dwell", self.tr("Stays at least, in seconds"))

    def edit_limit(self) -> None:
        """When the selected situation ends at the latest."""
        self._edit_seconds("limit", self.tr("Ends after, in seconds"))

    def _edit_seconds(self, which: str, asked: str) -> None:
        name = self._one_situation()
        if not name:
            return
        key = self._picture.uids["situation", name]
        now = getattr(self.document.situation(name), which)
        self.viewer.reveal(self.card_area(key))
        text = write_number(now) if now is not None else ""
        editor = priority_editor((name, which), text, self.look, self.viewer.viewport())
        editor.setAccessibleName(asked)
        editor.setPlaceholderText(asked)
        editor.finished.connect(self._on_seconds)
        self.seconds_editor = editor
        area = self.viewer.mapFromScene(self.card_area(key)).boundingRect()
        editor.open_at(QRect(area.left(), area.bottom() - 12, max(area.width(), 190), 26))

    def _on_seconds(self, key: tuple[str, str], text: str | None, _: int) -> None:
        self.seconds_editor = None
        self.viewer.setFocus()
        if text is None:
            return
        text = text.strip().removesuffix("s").strip().replace(",", ".")
        try:
            seconds = float(text) if text else None
        except ValueError:
            seconds = 0.0
        if seconds is not None and not 0 < seconds < float("inf"):
            self.status.emit(self.tr("Write seconds above 0, or nothing, not {0}").format(text))
            return
        name, which = key
        self._edit(*gestures.set_seconds(self.document, name, which, seconds))

    def _below(self, key: str) -> QPointF:
        area = self.card_area(key)
        return QPointF(area.left() + STRIP, area.bottom() + 4)

    # -- conditions -------------------------------------------------------------------------

    def edit_test(self, place: Place) -> None:
        """Opens the fields of a test at its line."""
        test = places.get(self.document, place)
        row = self.row_area(place)
        if not isinstance(test, Test) or row is None:
            return
        if self.test_editor is not None:
            self.test_editor.close_editor()
        self.viewer.reveal(row)
        editor = TestEditor(self.look.theme, place, self.viewer.viewport())
        editor.changed.connect(self._on_test)
        editor.removed.connect(lambda gone: self._edit(*gestures.delete(self.document, [gone])))
        editor.closed.connect(self._on_test_closed)
        self.test_editor = editor
        editor.show_test(test, self._tags())
        editor.open_at(self.viewer.mapFromScene(row).boundingRect())

    def _tags(self) -> tuple[str, ...]:
        return tuple(c.name for c in self._picture.cards.values() if c.kind == "data")

    def _on_test(self, place: Place, test: Test) -> None:
        done = self._edit(*conditions.change_test(self.document, place, test))
        now = places.get(self.document, place)
        if not done and self.test_editor is not None and isinstance(now, Test):
            self.test_editor.show_test(now, self._tags())

    def _on_test_closed(self) -> None:
        self.test_editor = None
        self.viewer.setFocus()

    def _follow_test(self) -> None:
        """The document is another one: so is the test that is being edited, or it is gone."""
        editor = self.test_editor
        if editor is None:
            return
        test, row = places.get(self.document, editor.place), self.row_area(editor.place)
        if isinstance(test, Test) and row is not None:
            editor.show_test(test, self._tags())
            editor.settle_at(self.viewer.mapFromScene(row).boundingRect())
        else:
            editor.close_editor()

    def row_area(self, place: Place) -> QRectF | None:
        """Where the line of a test or a group is, in the scene."""
        key = self._picture.uids.get(place[:3])
        node = self._picture.cards.get(key) if key is not None else None
        for index, row in enumerate(node.rows if node is not None else ()):
            if row.tail == place[3:] and node is not None:
                top = node.y + node.line_at(index) - LINE / 2
                return QRectF(node.x + STRIP, top, node.width - STRIP, LINE)
        return None

    def ask_joint(self, place: Place = ()) -> None:
        """Whether all, any or none of what is in a condition or a group shall hold."""
        node = self._one_node()
        if not place and (node is None or node.kind != "condition"):
            self.status.emit(self.tr("Select a condition"))
            return
        place = place or (node.place if node is not None else ())
        area = self.row_area(place)
        key = self._picture.uids[place[:3]]
        self.ask(
            [Follow(kind, translated(words), "condition") for kind, words in GROUPS],
            self.tr("What shall hold?"),
            lambda kind: self._regroup(place, kind),  # type: ignore[arg-type]
            area.bottomLeft() if area is not None else self._below(key),
        )

    def _regroup(self, place: Place, kind: GroupName) -> None:
        self._edit(*conditions.regroup(self.document, place, kind))

    def group(self, kind: GroupName) -> None:
        """The selected tests become a group of their own; of a condition, all that it has."""
        chosen = self._tests()
        node = self._one_node()
        if not chosen and node is not None and node.kind == "condition":
            self._regroup(node.place, kind)
            return
        if not chosen or len({place[:-1] for place in chosen}) > 1:
            self.status.emit(self.tr("Select tests that stand beside each other in one group"))
            return
        self._edit(*conditions.wrap(self.document, chosen, kind))

    def ungroup(self) -> None:
        """Takes the selected group away; what was in it stays."""
        chosen = self.selection()
        node = self._one_node()
        place = chosen[0] if len(chosen) == 1 else ()
        if node is not None and place == node.place and node.joined:
            place = node.joined
        if isinstance(places.get(self.document, place), Test) and len(place) > 4:
            # Of a test the group that it is in.
            place = place[:-1]
        if not place or not isinstance(places.get(self.document, place), Group):
            self.status.emit(self.tr("Select a group of tests"))
            return
        self._edit(*conditions.unwrap(self.document, place))

    # -- priorities -------------------------------------------------------------------------

    def ask_priority(self) -> None:
        """Which module's priority in the selected situation is to be typed, one taken over too."""
        name = self._one_situation()
        situation = self.document.situation(name)
        if situation is None:
            return
        every = self.document.priorities(situation)
        own = {entry.module: entry.priority for entry in situation.entries}
        choices = []
        for module in (c.name for c in self._picture.cards.values() if c.kind == "module"):
            said = module
            if module in own:
                number = own[module]
                said = f"{module}  {self.tr('none') if number is None else number}"
            elif module in every:
                said = self.tr("{0}  {1}, taken over").format(module, every[module])
            choices.append(Follow(f"module {module}", said, "module"))
        key = self._picture.uids["situation", name]
        new = ("+module", piping.new_words("situation"), "module")
        asked = self.tr("Which module's priority?")
        self.ask(choices, asked, lambda one: self._begin_priority(name, one), self._below(key), new)

    def _begin_priority(self, situation: str, chosen: str) -> None:
        word, _, module = chosen.partition(" ")
        over = next((o for o in self.priorities.taken_over if o.value.module == module), None)
        if word == "module" and over is not None and over.value.situation == situation:
            self.priorities.override(over)
            return
        if self._entry(situation, module) is None:
            self._follow(self._picture.uids["situation", situation], chosen, None)
        place = self._entry(situation, module)
        if place is not None:
            self.select([place])
            pipes = self._selected_priorities()
            if pipes:
                self.priorities.edit(pipes[0])

    def _entry(self, situation: str, module: str) -> Place | None:
        found = self.document.situation(situation)
        every = enumerate(found.entries if found is not None else ())
        index = next((i for i, e in every if e.module == module), None)
        return ("situation", situation, "entry", str(index)) if index is not None else None

    def _prioritise(self, situation: str, module: str, priority: int | None) -> None:
        self._edit(*gestures.prioritise(self.document, situation, module, priority))

    def _selected_priorities(self) -> list[CurvedPipe]:
        if self.selected_uids():
            return []
        return [p for p in self.viewer.selected_pipes() if p.link.kind == "priority"]

    def take_priority_away(self) -> None:
        """Of the selected priority: none in this situation, whatever it takes over."""
        for pipe in self._selected_priorities()[:1]:
            node = self._picture.cards[pipe.link.source]
            self._prioritise(node.name, self._picture.cards[pipe.link.target].name, None)
            return
        self.status.emit(self.tr("Select a priority"))

    # -- data ------------------------------------------------------------------------------

    def ask_type(self) -> None:
        """Of which type the selected data is."""
        node = self._one_node()
        if node is None or node.kind != "data":
            self.status.emit(self.tr("Select data"))
            return
        types = (*TYPES, ("any", self.tr("any value")))
        self.ask(
            [Follow(f"type {kind}", translated(words), "data") for kind, words in types],
            self.tr("What kind of value?"),
            lambda chosen: self._set_type(node.name, chosen.partition(" ")[2]),
            self._below(node.uid),
        )

    def _set_type(self, tag: str, kind: str) -> None:
        kinds: Any = None if kind == "any" else kind
        self._edit(*gestures.change_data(self.document, tag, type=kinds))

    # -- adding, connecting, moving -----------------------------------------------------------

    def delete_selection(self) -> None:
        self._edit(*gestures.delete(self.document, self.selection()))

    def add_situation(self, index: int | None = None) -> None:
        after, text, name = gestures.add_situation(self.document, index)
        self._edit(after, text, ("situation", name))

    def add_module(self) -> None:
        after, text, name = gestures.add_module(self.document)
        self._edit(after, text, ("module", name))

    def add_data(self) -> None:
        after, text, tag = gestures.add_data(self.document)
        self._edit(after, text, ("data", tag))

    def connect_selected(self) -> None:
        """Connects the selected nodes of neighbouring columns."""
        cards = [self._picture.cards[k] for k in self.selected_uids()]
        script, texts = self.document, []
        for source in cards:
            for target in cards:
                if piping.accepts(source, target) and source.kind != target.kind:
                    script, text, _ = piping.connect(script, source, target, "", ())
                    texts += [text] if text else []
        several = self.tr("Connect {0} cards").format(len(cards))
        self._edit(script, several if len(texts) > 1 else texts[0] if texts else "")

    def nudge(self, across: int, down: int) -> None:
        """Ctrl with up or down moves a situation in the precedence."""
        nodes = [self._picture.cards[k] for k in self.selected_uids()]
        if len(nodes) == 1 and nodes[0].kind == "situation" and down:
            index = nodes[0].number - 1 + down
            self._edit(*gestures.reorder(self.document, nodes[0].name, index))

    def _rename_card(self, key: str, name: str) -> None:
        node = self._picture.cards[key]
        after, text = gestures.rename(self.document, node.kind, node.name, name)
        self._edit(after, text, (node.kind, gestures.cleaned(node.kind, name)))

    def rename(self) -> None:
        """Edits what is selected where it stands: a name, a test, a priority."""
        chosen = self.selection()
        pipes = self._selected_priorities()
        if len(pipes) == 1 and len(chosen) == 1:
            self.priorities.edit(pipes[0])
            return
        value = places.get(self.document, chosen[0]) if len(chosen) == 1 else None
        if isinstance(value, Test):
            self.edit_test(chosen[0])
        elif isinstance(value, Group):
            self.ask_joint(chosen[0])
        else:
            super().rename()

    def edit_name(self, uid: str) -> None:
        node = self._picture.cards[uid]
        if node.kind != "condition":
            super().edit_name(uid)
        elif node.joint:
            self.ask_joint(node.place)
        else:
            self.edit_test((*node.place, *node.rows[0].tail))

    def name_area(self, uid: str) -> QRectF:
        area = self.card_area(uid)
        middle = area.top() + self._picture.cards[uid].stack()[0][1]
        return QRectF(area.left() + 34, middle - 13, area.width() - 38, 26)

    def _key(self, event: QKeyEvent) -> bool:
        pipes = self._selected_priorities()
        if len(pipes) == 1 and event.text().isdecimal():
            self.priorities.edit(pipes[0], event.text())
            return True
        if event.key() in ENTER:
            self.rename()
            return True
        return super()._key(event)

    def port_at(self, key: str, port: str) -> QPointF:
        raise NotImplementedError
