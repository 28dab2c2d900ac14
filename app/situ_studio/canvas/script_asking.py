"""What a person is asked about a script, in menus over the drawing: by keys too."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QPointF, QRect

from situ.document.datatypes import write_number
from situ_studio.canvas import script_conditions as conditions
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas import script_piping as piping
from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.menu import FollowMenu
from situ_studio.canvas.overlay import InPlace, priority_editor
from situ_studio.canvas.script_choosing import ScriptChoosing
from situ_studio.canvas.script_faces import STRIP, ScriptNode
from situ_studio.canvas.script_priorities import Priorities
from situ_studio.edits import notes, places
from situ_studio.edits.edit import Place
from situ_studio.kinds import TYPES
from situ_studio.wording.language import translated


class ScriptAsking(ScriptChoosing):
    """Asks, and does what was chosen."""

    priorities: Priorities
    menu: FollowMenu | None
    field_editor: InPlace | None

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
        node = self._picture.cards[self._picture.uids["situation", name]]
        now = getattr(self.document.situation(name), which)
        text = write_number(now) if now is not None else ""
        self._open_field(node, (name, which), text, asked, self._on_seconds)

    def _on_seconds(self, key: tuple[str, str], text: str | None, _: int) -> None:
        self.field_editor = None
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

    def edit_unit(self) -> None:
        """In which unit the selected data is."""
        node = self._one_node()
        if node is None or node.kind != "data":
            self.status.emit(self.tr("Select data"))
            return
        known = next((o for o in self.document.observe if o.tag == node.name), None)
        text = (known.unit if known is not None else None) or ""
        self._open_field(node, node.name, text, self.tr("Unit, such as deg or m"), self._on_unit)

    def _on_unit(self, tag: str, text: str | None, _: int) -> None:
        self.field_editor = None
        self.viewer.setFocus()
        if text is not None:
            unit = " ".join(text.split()) or None
            self._edit(*gestures.change_data(self.document, tag, unit=unit))

    def edit_note(self) -> None:
        """What is to be remembered about what is selected; of nothing, about the script."""
        chosen = self.selection()
        place = chosen[0] if len(chosen) == 1 else ()
        value = places.get(self.document, place) if place else self.document
        if len(chosen) > 1 or value is None:
            self.status.emit(self.tr("Select one thing, or nothing for a note on the script"))
            return
        node = self._one_node() or next(iter(self._picture.cards.values()), None)
        if node is not None:
            asked = self.tr("Note")
            self._open_field(node, place, notes.note_of(value), asked, self._on_note, 420)

    def _on_note(self, place: Place, text: str | None, _: int) -> None:
        self.field_editor = None
        self.viewer.setFocus()
        if text is not None:
            self._edit(*notes.annotate(self.document, place, text))

    def _open_field(
        self,
        node: ScriptNode,
        key: object,
        text: str,
        asked: str,
        then: Callable[..., None],
        least: int = 190,
    ) -> None:
        """A field at the lower edge of a node, so many px wide at least."""
        self.viewer.reveal(self.card_area(node.uid))
        editor = priority_editor(key, text, self.look, self.viewer.viewport())
        editor.setAccessibleName(asked)
        editor.setPlaceholderText(asked)
        editor.finished.connect(then)
        self.field_editor = editor
        area = self.viewer.mapFromScene(self.card_area(node.uid)).boundingRect()
        editor.open_at(QRect(area.left(), area.bottom() - 12, max(area.width(), least), 26))

    def edit_test(self, place: Place) -> None:
        raise NotImplementedError
