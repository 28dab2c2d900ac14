"""A form made from one row of the kinds' table.

A form shows the value at a place of a document and tells the whole new document
when a field is finished: one field, one named edit.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from msgspec import Struct
from msgspec.structs import replace
from PySide6.QtCore import QCoreApplication, QSize, Qt, Signal
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QMenu,
    QVBoxLayout,
    QWidget,
)

from situ.document import rbd, spds
from situ.document.problem import Problem
from situ_studio import changes, kinds, places, words
from situ_studio.edit import Document, Place
from situ_studio.icon_widgets import Elided, IconButton
from situ_studio.kinds import Field, Kind, Section
from situ_studio.layouts import rule
from situ_studio.panels.conditions import AddTest, ConditionEditor
from situ_studio.panels.fields import (
    Choice,
    FieldWidget,
    Flag,
    Line,
    Number,
    Paragraph,
    make_field,
    offer,
)
from situ_studio.panels.pairs import PAIRS, PairsEditor
from situ_studio.panels.preview import ScreenPreview
from situ_studio.panels.priorities import PrioritiesEditor
from situ_studio.panels.rows import RowList
from situ_studio.panels.summaries import action_row, component_row, event_row
from situ_studio.theme import Theme
from situ_studio.vocabulary import Vocabulary

LABEL = 72
MARGIN = 12


def translated(text: str) -> str:
    """A text of the kinds' table in the user's language."""
    return QCoreApplication.translate("kinds", text) if text else ""


class Subject(Struct, frozen=True, kw_only=True):
    """What a form shows: the value at ``place`` of ``document``, and what it is surrounded by."""

    document: Document
    place: Place
    value: Any
    theme: Theme
    vocabulary: Vocabulary = Vocabulary()
    problems: tuple[Problem, ...] = ()
    media: Path | None = None


class Form(QWidget):
    """The fields and sections of one kind."""

    edited = Signal(object, str, tuple)
    """The new document, the step's name, the place at which the value stands now."""
    place_asked = Signal(tuple)

    def __init__(self, kind: Kind, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.kind = kind
        self._theme = theme
        self._subject: Subject | None = None
        self._fields: list[tuple[Field, FieldWidget, QWidget]] = []
        self._sections: list[SectionEditor] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 8, 0, 12)
        column.setSpacing(0)
        self._timeout: TimeoutRows | None = None
        for field in kind.fields:
            if field.editor == "timeout":
                self._timeout = TimeoutRows(theme, self)
                self._timeout.changed.connect(self._on_timeout)
                column.addWidget(self._timeout)
            else:
                column.addWidget(self._row(field))
        column.addSpacing(4)
        for section in kind.sections:
            column.addWidget(rule())
            editor: QWidget
            if section.editor == "fields":
                editor = self._fields_section(section)
            else:
                made = SectionEditor(section, theme, self)
                made.changed.connect(self._on_section)
                made.place_asked.connect(self.place_asked)
                self._sections.append(made)
                editor = made
            column.addWidget(editor)
        column.addStretch(1)

    def show_subject(self, subject: Subject) -> None:
        """Shows another value of the same kind."""
        self._subject = subject
        for field, widget, _ in self._fields:
            offer(widget, field.editor, subject.vocabulary, field.choices, self._empty(field))
            widget.show_value(getattr(subject.value, field.attribute))
        if self._timeout is not None:
            self._timeout.show_value(subject.value.timeout, subject.vocabulary)
        for section in self._sections:
            section.show_subject(subject)

    def minimumSizeHint(self) -> QSize:
        # Never wider than the panel: what is too long in it is shortened with ….
        return QSize(0, super().minimumSizeHint().height())

    def field(self, attribute: str) -> FieldWidget:
        """The field of an attribute; LookupError where the form has none."""
        if attribute == "timeout" and self._timeout is not None:
            return self._timeout.seconds
        for field, widget, _ in self._fields:
            if field.attribute == attribute:
                return widget
        raise LookupError(attribute)

    def section(self, attribute: str) -> SectionEditor:
        """The section of an attribute; LookupError where the form has none."""
        for section in self._sections:
            if section.section.attribute == attribute:
                return section
        raise LookupError(attribute)

    # -- building ----------------------------------------------------------------

    def _empty(self, field: Field) -> str:
        if field.editor == "next":
            return self.tr("nothing, it stays")
        return translated(field.placeholder)

    def _widget(self, field: Field) -> FieldWidget:
        label = translated(field.label)
        widget = make_field(field.editor, self._theme, label, translated(field.unit))
        widget.setAccessibleName(label)
        widget.setToolTip(translated(field.help))
        widget.setAccessibleDescription(translated(field.help))
        if isinstance(widget, Line) and field.placeholder:
            widget.setPlaceholderText(translated(field.placeholder))
        widget.committed.connect(lambda value, f=field: self._on_field(f, value))
        return widget

    def _row(self, field: Field) -> QWidget:
        holder = QWidget()
        line = QHBoxLayout(holder)
        line.setContentsMargins(MARGIN, 0, MARGIN, 4)
        line.setSpacing(8)
        widget = self._widget(field)
        label = QLabel("" if isinstance(widget, Flag) else translated(field.label))
        label.setProperty("role", "label")
        label.setFixedWidth(LABEL)
        label.setToolTip(translated(field.help))
        label.setBuddy(widget)
        if isinstance(widget, Paragraph):
            label.setAlignment(Qt.AlignmentFlag.AlignTop)
            label.setContentsMargins(0, 6, 0, 0)
        line.addWidget(label)
        line.addWidget(widget, 1)
        self._fields.append((field, widget, holder))
        return holder

    def _fields_section(self, section: Section) -> QWidget:
        holder = QWidget()
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 8)
        column.setSpacing(0)
        heading = QLabel(translated(section.title))
        heading.setProperty("role", "heading")
        heading.setFixedHeight(32)
        heading.setContentsMargins(MARGIN, 0, MARGIN, 0)
        column.addWidget(heading)
        small = all(len(f.label) == 1 for f in section.fields)
        if not small:
            for field in section.fields:
                column.addWidget(self._row(field))
            return holder
        grid = QGridLayout()
        grid.setContentsMargins(MARGIN, 0, MARGIN, 4)
        grid.setSpacing(8)
        for index, field in enumerate(section.fields):
            cell = QHBoxLayout()
            cell.setSpacing(4)
            label = QLabel(translated(field.label))
            label.setProperty("role", "label")
            label.setFixedWidth(14)
            cell.addWidget(label)
            widget = self._widget(field)
            cell.addWidget(widget, 1)
            self._fields.append((field, widget, holder))
            grid.addLayout(cell, index // 2, index % 2)
        column.addLayout(grid)
        return holder

    # -- changes -----------------------------------------------------------------

    def _on_field(self, field: Field, value: Any) -> None:
        subject = self._subject
        if subject is None:
            return
        old = getattr(subject.value, field.attribute)
        widget = self.field(field.attribute)
        if value == "" or value is None:
            if field.fixed:
                self._refuse(widget, old, self.tr("This can not be left empty."))
                return
            value = field.empty
        if value == old:
            return
        text = words.change_words(
            subject.document, subject.place, field.attribute, translated(field.label)
        )
        try:
            document, place = changes.set_field(
                subject.document, subject.place, field.attribute, value
            )
        except ValueError as error:
            self._refuse(widget, old, str(error))
            return
        self.edited.emit(document, text, place)

    def _refuse(self, widget: FieldWidget, old: Any, why: str) -> None:
        widget.show_value(old)
        if isinstance(widget, Line):
            widget.setText(widget.written(old))
            widget.refuse(why)

    def _on_timeout(self, timeout: rbd.Timeout | None) -> None:
        subject = self._subject
        if subject is None or timeout == subject.value.timeout:
            return
        document = places.change(subject.document, subject.place, timeout=timeout)
        where = words.place_words(subject.document, subject.place)
        self.edited.emit(document, self.tr("Change timeout of {0}").format(where), subject.place)

    def _on_section(self, attribute: str, value: Any, text: str) -> None:
        subject = self._subject
        if subject is None:
            return
        document = places.change(subject.document, subject.place, **{attribute: value})
        where = words.place_words(subject.document, subject.place)
        self.edited.emit(document, self.tr("{0} of {1}").format(text, where), subject.place)


class TimeoutRows(QWidget):
    """A timeout in the form of its state: seconds; where they are set, where it leads, and how."""

    changed = Signal(object)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._timeout: rbd.Timeout | None = None
        grid = QGridLayout(self)
        grid.setContentsMargins(MARGIN, 0, MARGIN, 4)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(4)
        grid.setColumnMinimumWidth(0, LABEL)
        label = QLabel(self.tr("Timeout"))
        label.setProperty("role", "label")
        label.setFixedWidth(LABEL)
        grid.addWidget(label, 0, 0)
        self.seconds = Number(unit="s", above=True)
        self.seconds.setPlaceholderText(self.tr("none"))
        self.seconds.setAccessibleName(self.tr("Timeout"))
        self.seconds.setToolTip(
            self.tr("After so many seconds without an event the state is left.")
        )
        label.setBuddy(self.seconds)
        grid.addWidget(self.seconds, 0, 1)
        self._then = QLabel(self.tr("then to"))
        self._then.setProperty("role", "label")
        grid.addWidget(self._then, 1, 0)
        self.next = Choice(theme)
        self.next.setAccessibleName(self.tr("The timeout leads to"))
        grid.addWidget(self.next, 1, 1)
        self.idle = Flag(theme, self.tr("only when idle"))
        self.idle.setToolTip(
            self.tr("Counted anew after each touch and speech; still while the robot speaks.")
        )
        grid.addWidget(self.idle, 2, 1)
        grid.setColumnStretch(1, 1)
        self.seconds.committed.connect(self._on_seconds)
        self.next.committed.connect(lambda v: self._change(next=v))
        self.idle.committed.connect(lambda v: self._change(idle=v))

    def show_value(self, timeout: rbd.Timeout | None, vocabulary: Vocabulary) -> None:
        self._timeout = timeout
        self.seconds.show_value(timeout.seconds if timeout is not None else None)
        self.next.offer(
            (
                (None, self.tr("raises timeout")),
                *((no, f"{no} {name}".strip()) for no, name in vocabulary.states),
                (rbd.AGAIN, self.tr("the same state, anew")),
                (rbd.BACK, self.tr("back to where it came from")),
            )
        )
        for widget in (self._then, self.next, self.idle):
            widget.setVisible(timeout is not None)
        if timeout is not None:
            self.next.show_value(timeout.next)
            self.idle.show_value(timeout.idle)

    def _on_seconds(self, seconds: float | None) -> None:
        if seconds is None:
            self.changed.emit(None)
        elif self._timeout is None:
            self.changed.emit(rbd.Timeout(seconds))
        else:
            self._change(seconds=seconds)

    def _change(self, **fields: Any) -> None:
        if self._timeout is not None:
            self.changed.emit(replace(self._timeout, **fields))


class SectionEditor(QWidget):
    """A section with a list: its heading, the button that adds, and the members."""

    changed = Signal(str, object, str)
    place_asked = Signal(tuple)

    def __init__(self, section: Section, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.section = section
        self._theme = theme
        self._subject: Subject | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(MARGIN, 0, MARGIN, 8)
        column.setSpacing(0)
        head = QHBoxLayout()
        head.setSpacing(6)
        title = QLabel(translated(section.title))
        title.setProperty("role", "heading")
        title.setFixedHeight(32)
        title.setToolTip(translated(section.help))
        head.addWidget(title)
        head.addWidget(Elided(translated(section.hint), "hint"), 1)
        self._head = head
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
            head.addWidget(AddTest(theme, self.condition.add))
        elif section.editor == "entries":
            self.priorities = self._body = PrioritiesEditor(theme)
            self.priorities.changed.connect(self._tell)
            self._plus(self.tr("Add a priority"), self.priorities.add)
        elif section.editor == "words":
            self._words = QLabel()
            self._words.setProperty("role", "words")
            self._words.setWordWrap(True)
            self._body = self._words
        else:
            self.pairs = self._body = PairsEditor(theme, section.editor)
            self.pairs.changed.connect(self._tell)
            self._plus(self.tr("Add a {0}").format(PAIRS[section.editor].noun), self.pairs.add)
        column.addWidget(self._body)

    def _plus(self, tip: str, pressed: Any) -> IconButton:
        button = IconButton(self._theme, "plus", tip, "text3", 16)
        button.clicked.connect(lambda: pressed())
        self._head.addWidget(button)
        return button

    def _add_button(self) -> IconButton:
        if self.section.editor == "events":
            return self._plus(self.tr("Add an event"), lambda: self.add_member("event"))
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
            action.triggered.connect(lambda _=False, k=kind: self.add_member(k.name))

    # -- showing -----------------------------------------------------------------

    def show_subject(self, subject: Subject) -> None:
        self._subject = subject
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

    def add_member(self, name: str) -> None:
        """Adds a new member of that kind at the end and opens it."""
        if self._subject is None:
            return
        kind = kinds.kind(name)
        members = self._members()
        if isinstance(self._subject.value, rbd.Screen):
            taken = {c.id for c in members}
            number = 1
            while f"{name}{number}" in taken:
                number += 1
            made = kind.make(f"{name}{number}")
        elif name == "event":
            made = kind.make(words.expected_next(self._subject.value))
        else:
            made = kind.make("")
        place = (*self._subject.place, *self._step(len(members), made))
        self._tell((*members, made), self.tr("Add {0}").format(translated(kind.title).lower()))
        self.place_asked.emit(place)

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
        self.place_asked.emit((*self._subject.place, "screen"))
