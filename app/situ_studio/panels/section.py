"""The sections of a form that hold lists: their heading, what adds to them, their members."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QMenu, QVBoxLayout, QWidget

from situ.document import rbd, spds
from situ_studio import kinds
from situ_studio.edits import words
from situ_studio.edits.edit import Place
from situ_studio.kinds import Kind, Section
from situ_studio.looks.theme import Theme
from situ_studio.panels.conditions import AddTest, ConditionEditor
from situ_studio.panels.pairs import PAIRS, PairsEditor
from situ_studio.panels.preview import ScreenPreview
from situ_studio.panels.priorities import PrioritiesEditor
from situ_studio.panels.rows import RowList
from situ_studio.panels.section_head import SectionHead
from situ_studio.panels.subject import MARGIN, Subject
from situ_studio.panels.summaries import action_row, component_row, event_row
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.wording.language import translated


class SectionEditor(QWidget):
    """A section with a list: its heading, the button that adds, and the members."""

    changed = Signal(str, object, str)
    refused = Signal(str)
    """Why what was typed is not taken."""
    place_asked = Signal(tuple)
    screen_asked = Signal(tuple)
    """The place of a screen that is to be drawn, in the view made for it."""
    kind_asked = Signal(str)
    """A new member of that kind is wanted."""

    def __init__(self, section: Section, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.section = section
        # Two of a form may have the same button; a reader tells in which it is.
        self.setAccessibleName(translated(section.title))
        self._theme = theme
        self._subject: Subject | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(MARGIN, 0, MARGIN, 8)
        column.setSpacing(0)
        self._head = head = SectionHead(section)
        column.addLayout(head)
        self.rows: RowList | None = None
        self.preview: ScreenPreview | None = None
        self.condition: ConditionEditor | None = None
        self.pairs: PairsEditor | None = None
        self.priorities: PrioritiesEditor | None = None
        self._words: QLabel | None = None
        self._body: QWidget
        if section.attribute == "screen":
            self.preview = self._body = ScreenPreview(theme)
            self.preview.clicked.connect(self._open_screen)
            self._open = IconButton(theme, "launch", self.tr("Open the screen"), "text3", 15)
            self._open.clicked.connect(self._open_screen)
            self._drop = IconButton(
                theme, "close", self.tr("Keep what was shown before"), "text3", 12
            )
            self._drop.clicked.connect(lambda: self._tell(None, self.tr("Remove screen")))
            head.addWidget(self._drop)
            head.addWidget(self._open)
        elif section.editor in ("actions", "events", "components"):
            self.rows = self._body = RowList(theme)
            self.rows.opened.connect(self._open_row)
            self.rows.removed.connect(self._remove_row)
            self.rows.moved.connect(self._move_row)
            self.add = self._add_button()
        elif section.editor == "condition":
            self.condition = self._body = ConditionEditor(theme)
            self.condition.changed.connect(self._tell)
            self.condition.refused.connect(self.refused)
            head.addWidget(AddTest(theme, self.condition.add))
        elif section.editor == "entries":
            self.priorities = self._body = PrioritiesEditor(theme)
            self.priorities.changed.connect(self._tell)
            self.priorities.refused.connect(self.refused)
            self._plus(self.tr("Add a priority"), self.priorities.add)
        elif section.editor == "words":
            self._words = QLabel()
            self._words.setProperty("role", "words")
            self._words.setWordWrap(True)
            self._body = self._words
        else:
            self.pairs = self._body = PairsEditor(theme, section.editor)
            self.pairs.changed.connect(self._tell)
            self._plus(
                self.tr("Add a {0}").format(translated(PAIRS[section.editor].noun)), self.pairs.add
            )
        column.addWidget(self._body)

    def _plus(self, tip: str, pressed: Any) -> IconButton:
        button = IconButton(self._theme, "plus", tip, "text3", 16)
        button.clicked.connect(lambda: pressed())
        self._head.addWidget(button)
        return button

    def _add_button(self) -> IconButton:
        if self.section.editor == "events":
            return self._plus(self.tr("Add an event"), lambda: self.kind_asked.emit("event"))
        button = IconButton(self._theme, "plus", self.tr("Add"), "text3", 16)
        button.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        menu = QMenu(button)
        button.setMenu(menu)
        button.setPopupMode(button.ToolButtonPopupMode.InstantPopup)
        menu.aboutToShow.connect(lambda: self._fill_menu(menu))
        self._head.addWidget(button)
        return button

    def offered(self) -> tuple[Kind, ...]:
        """The kinds that can be added here."""
        if self.section.editor == "components":
            return kinds.COMPONENTS
        in_event = self._subject is not None and isinstance(self._subject.value, rbd.Event)
        return kinds.EVENT_ACTIONS if in_event else kinds.STATE_ACTIONS

    def _fill_menu(self, menu: QMenu) -> None:
        menu.clear()
        for kind in self.offered():
            action = menu.addAction(translated(kind.title))
            action.setToolTip(translated(kind.help))
            action.triggered.connect(lambda _=False, k=kind: self.kind_asked.emit(k.name))

    # -- showing -----------------------------------------------------------------

    def show_subject(self, subject: Subject) -> None:
        before, self._subject = self._subject, subject
        if self.condition is not None and before is not None and _is_elsewhere(before, subject):
            self.condition.give_up()
        value: Any = getattr(subject.value, self.section.attribute, None)
        theme, document = subject.theme, subject.document
        if self.preview is not None:
            above: tuple[rbd.Component, ...] = ()
            if isinstance(document, rbd.Application) and isinstance(subject.value, rbd.State):
                always = document.always
                if always is not None and always.screen is not None and subject.value.always:
                    above = always.screen.components
            self.preview.show_screen(theme, value, above, subject.media)
            self._drop.setVisible(value is not None)
        elif self.rows is not None:
            self.rows.show_rows(theme, tuple(self._row(i, m) for i, m in enumerate(value)))
        elif self.condition is not None:
            self.condition.show_value(theme, value, subject.vocabulary)
        elif self.priorities is not None and isinstance(document, spds.Spds):
            self.priorities.show_value(theme, document, subject.value, subject.vocabulary)
        elif self.pairs is not None:
            self.pairs.show_value(theme, value, subject.vocabulary)
        elif self._words is not None and isinstance(document, spds.Spds):
            self._words.setText(words.situation_words(document, subject.value))

    def _row(self, index: int, member: Any) -> Any:
        assert self._subject is not None
        mark = self._mark((*self._subject.place, *self._step(index, member)))
        if isinstance(member, rbd.Event):
            return event_row(self._subject.document, member, mark)
        if isinstance(member, rbd.Component):
            return component_row(member, mark)
        return action_row(member, mark)

    def _mark(self, place: Place) -> str:
        """``error`` or ``warning`` where a problem stands at that place, else nothing."""
        assert self._subject is not None
        found = {p.severity for p in self._subject.problems if p.place[: len(place)] == place}
        return "error" if "error" in found else "warning" if found else ""

    def _step(self, index: int, member: Any) -> Place:
        if isinstance(member, rbd.Component):
            return (member.id,)
        return ("event" if isinstance(member, rbd.Event) else "action", str(index))

    # -- changes -----------------------------------------------------------------

    def _members(self) -> tuple[Any, ...]:
        assert self._subject is not None
        return tuple(getattr(self._subject.value, self.section.attribute))

    def _tell(self, value: Any, text: str) -> None:
        self.changed.emit(self.section.attribute, value, text)

    def _remove_row(self, index: int) -> None:
        members = self._members()
        title = words.member_words(members[index])
        self._tell((*members[:index], *members[index + 1 :]), self.tr("Remove {0}").format(title))

    def _move_row(self, start: int, end: int) -> None:
        members = list(self._members())
        title = words.member_words(members[start])
        members.insert(end, members.pop(start))
        self._tell(tuple(members), self.tr("Move {0}").format(title))

    def _open_row(self, index: int) -> None:
        assert self._subject is not None
        member = self._members()[index]
        self.place_asked.emit((*self._subject.place, *self._step(index, member)))

    def _open_screen(self) -> None:
        assert self._subject is not None
        if self._subject.value.screen is None:
            self._tell(rbd.Screen(), self.tr("Add screen"))
        self.screen_asked.emit((*self._subject.place, "screen"))


def _is_elsewhere(before: Subject, after: Subject) -> bool:
    """Whether it is another thing: at another place, or there in another document."""
    first, then = (getattr(one.document, "name", None) for one in (before, after))
    return before.place != after.place or first != then
