"""What commands do on the canvas of a script, beside gestures: without a mouse too."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

from PySide6.QtCore import QRectF
from PySide6.QtGui import QKeyEvent, Qt

from situ.document.condition import Group, GroupName, Test
from situ.document.project import Project
from situ_studio.canvas import script_conditions as conditions
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas import script_piping as piping
from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.script_asking import ScriptAsking
from situ_studio.canvas.test_editor import TestEditor
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.edits.vocabulary import Vocabulary, known_data
from situ_studio.kinds import GROUPS
from situ_studio.wording.language import translated

ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2)


class ScriptCommands(ScriptAsking):
    """Changes what is selected."""

    test_editor: TestEditor | None
    project: Callable[[], Project | None]
    """The project as it is at the time of the call."""

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
        editor.box.refused.connect(self._on_refused_value)
        editor.changed.connect(self._on_test)
        editor.removed.connect(lambda gone: self._edit(*gestures.delete(self.document, [gone])))
        editor.closed.connect(self._on_test_closed)
        self.test_editor = editor
        editor.show_test(test, self._words())
        editor.open_at(self.viewer.mapFromScene(row).boundingRect())

    def _words(self) -> Vocabulary:
        tags = tuple(c.name for c in self._picture.cards.values() if c.kind == "data")
        return Vocabulary(tags=tags, data=known_data(self.project(), self.document.observe))

    def _on_test(self, place: Place, test: Test) -> None:
        done = self._edit(*conditions.change_test(self.document, place, test))
        now = places.get(self.document, place)
        if not done and self.test_editor is not None and isinstance(now, Test):
            self.test_editor.show_test(now, self._words())
            self.test_editor.refuse()

    def _on_refused_value(self, why: str) -> None:
        self.status.emit(why)
        if self.test_editor is not None:
            self.test_editor.refuse()

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
            editor.show_test(test, self._words())
            editor.settle_at(self.viewer.mapFromScene(row).boundingRect())
        else:
            editor.close_editor()

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
            lambda kind: self._regroup(place, cast(GroupName, kind)),
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

    def _prioritise(self, situation: str, module: str, priority: int | None) -> None:
        self._edit(*gestures.prioritise(self.document, situation, module, priority))

    def take_priority_away(self) -> None:
        """Of the selected priority: none in this situation, whatever it takes over."""
        for pipe in self._selected_priorities()[:1]:
            node = self._picture.cards[pipe.link.source]
            self._prioritise(node.name, self._picture.cards[pipe.link.target].name, None)
            return
        self.status.emit(self.tr("Select a priority"))

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
