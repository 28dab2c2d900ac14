"""A form made from one row of the kinds' table.

A form shows the value at a place of a document and tells the whole new document
when a field is finished: one field, one named edit.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from situ.document import rbd
from situ.document.condition import Test
from situ_studio.edits import changes, notes, places, words
from situ_studio.help.help_topics import HELP, field_topic
from situ_studio.kinds import Field, Kind, Section
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.component_sections import SECTIONS, ComponentSection
from situ_studio.panels.field_making import make_field, offer
from situ_studio.panels.fields import Choice, FieldWidget, Flag, Line, Paragraph
from situ_studio.panels.section import SectionEditor
from situ_studio.panels.subject import LABEL, MARGIN, Subject
from situ_studio.panels.test_box import TestBox
from situ_studio.panels.timeout_rows import TimeoutRows
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.widgets.layouts import rule
from situ_studio.wording.language import translated


class Form(QWidget):
    """The fields and sections of one kind."""

    edited = Signal(object, str, tuple)
    """The new document, the step's name, the place at which the value stands now."""
    place_asked = Signal(tuple)
    screen_asked = Signal(tuple)
    kind_asked = Signal(tuple, str)
    """Something new of a kind is wanted, in what stands at the place."""
    file_asked = Signal(tuple, str)
    """A file is wanted: for which place, and for which attribute of what stands there."""
    refused = Signal(str)
    """Why what was typed is not taken."""

    def __init__(self, kind: Kind, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.kind = kind
        self._theme = theme
        self._subject: Subject | None = None
        self._fields: list[tuple[Field, FieldWidget, QWidget]] = []
        self._sections: list[SectionEditor] = []
        self._told: list[ComponentSection] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 8, 0, 12)
        column.setSpacing(0)
        self._timeout: TimeoutRows | None = None
        self._test: TestBox | None = None
        if kind.value is Test:
            self._test = TestBox(theme, self)
            self._test.remove.hide()
            self._test.changed.connect(self._on_test)
            self._test.refused.connect(self.refused)
            around = QHBoxLayout()
            around.setContentsMargins(MARGIN, 0, MARGIN, 4)
            around.addWidget(self._test)
            column.addLayout(around)
        for field in kind.fields if self._test is None else ():
            if field.editor == "timeout":
                self._timeout = TimeoutRows(theme, self)
                self._timeout.changed.connect(self._on_timeout)
                self._timeout.seconds.refused.connect(self.refused)
                column.addWidget(self._timeout)
            else:
                column.addWidget(self._row(field))
        column.addSpacing(4)
        for section in kind.sections:
            column.addWidget(rule())
            editor: QWidget
            if section.editor == "fields":
                editor = self._fields_section(section)
            elif section.editor in SECTIONS:
                told = SECTIONS[section.editor](section, theme, self)
                told.edited.connect(self.edited)
                told.place_asked.connect(self.place_asked)
                self._told.append(told)
                editor = told
            else:
                made = SectionEditor(section, theme, self)
                made.changed.connect(self._on_section)
                made.place_asked.connect(self.place_asked)
                made.screen_asked.connect(self.screen_asked)
                made.kind_asked.connect(self._on_kind_asked)
                made.refused.connect(self.refused)
                self._sections.append(made)
                editor = made
            column.addWidget(editor)
        column.addStretch(1)

    def show_subject(self, subject: Subject) -> None:
        """Shows another value of the same kind."""
        if self._subject is not None and self._subject.place != subject.place:
            self._put_back()
        self._subject = subject
        for field, widget, _ in self._fields:
            offer(widget, field.editor, subject.vocabulary, field.choices, self._empty(field))
            widget.show_value(_value(field, subject.value))
        if self._test is not None:
            self._test.show_test(subject.value, subject.vocabulary)
        if self._timeout is not None:
            self._timeout.show_value(subject.value.timeout, subject.vocabulary)
        for section in self._sections:
            section.show_subject(subject)
        for told in self._told:
            told.show_subject(subject)

    def _put_back(self) -> None:
        """What is being written is of another value than comes now."""
        focus = self.window().focusWidget()
        if isinstance(focus, Line | Paragraph | Choice) and self.isAncestorOf(focus):
            focus.put_back()

    def minimumSizeHint(self) -> QSize:
        # Never wider than the panel: what is too long in it is shortened with ….
        return QSize(0, super().minimumSizeHint().height())

    def begin(self, attribute: str = "") -> None:
        """Gives a field the focus, its text selected; the first one unless named."""
        wanted = attribute or (self.kind.fields[0].attribute if self.kind.fields else "")
        if not wanted:
            return
        widget = self.field(wanted)
        widget.setFocus(Qt.FocusReason.OtherFocusReason)
        if isinstance(widget, Line | Paragraph):
            widget.selectAll()

    def field(self, attribute: str) -> FieldWidget:
        """The field of an attribute; LookupError where the form has none."""
        if attribute == "timeout" and self._timeout is not None:
            return self._timeout.seconds
        if self._test is not None:
            return self._test.field(attribute)
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

    def told(self, editor: str) -> ComponentSection:
        """What is told of a component under that editor's name; LookupError where it is not."""
        for told in self._told:
            if told.section.editor == editor:
                return told
        raise LookupError(editor)

    # -- building ----------------------------------------------------------------

    def _empty(self, field: Field) -> str:
        if field.editor == "next":
            return self.tr("nothing, it stays")
        return translated(field.placeholder)

    def _widget(self, field: Field) -> FieldWidget:
        label = translated(field.label)
        widget = make_field(field.editor, self._theme, label, translated(field.unit))
        widget.setAccessibleName(label)
        if isinstance(widget, Line):
            widget.set_help(translated(field.help))
        else:
            widget.setToolTip(translated(field.help))
        widget.setAccessibleDescription(translated(field.help))
        widget.setProperty(HELP, field_topic(self.kind, field))
        if isinstance(widget, Line):
            widget.refused.connect(self.refused)
            if field.placeholder:
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
        label.setFixedWidth(px(LABEL))
        label.setToolTip(translated(field.help))
        label.setProperty(HELP, field_topic(self.kind, field))
        label.setBuddy(widget)
        if isinstance(widget, Paragraph):
            label.setAlignment(Qt.AlignmentFlag.AlignTop)
            label.setContentsMargins(0, 6, 0, 0)
        line.addWidget(label)
        line.addWidget(widget, 1)
        if field.editor == "media":
            choose = IconButton(self._theme, "folder", self.tr("Choose a file…"), "text3", 16)
            choose.clicked.connect(lambda: self._ask_for_file(field.attribute))
            line.addWidget(choose)
        self._fields.append((field, widget, holder))
        return holder

    def _ask_for_file(self, attribute: str) -> None:
        if self._subject is not None:
            self.file_asked.emit(self._subject.place, attribute)

    def _fields_section(self, section: Section) -> QWidget:
        holder = QWidget()
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 8)
        column.setSpacing(0)
        heading = QLabel(translated(section.title))
        heading.setProperty("role", "heading")
        heading.setFixedHeight(px(32))
        heading.setContentsMargins(MARGIN, 0, MARGIN, 0)
        heading.setToolTip(translated(section.help))
        column.addWidget(heading)
        small = all(len(f.label) == 1 for f in section.fields)
        if not small:
            for field in section.fields:
                column.addWidget(self._row(field))
            return holder
        grid = QGridLayout()
        grid.setContentsMargins(MARGIN, 0, MARGIN, 4)
        grid.setHorizontalSpacing(4)
        grid.setVerticalSpacing(8)
        for index, field in enumerate(section.fields):
            row, at = index // 2, index % 2 * 2
            label = QLabel(translated(field.label))
            label.setProperty("role", "label")
            label.setMinimumWidth(px(14))
            label.setToolTip(translated(field.help))
            label.setProperty(HELP, field_topic(self.kind, field))
            # The second one stands a little away from the first one's field.
            label.setContentsMargins(4 if at else 0, 0, 0, 0)
            widget = self._widget(field)
            self._fields.append((field, widget, holder))
            grid.addWidget(label, row, at)
            grid.addWidget(widget, row, at + 1)
            grid.setColumnStretch(at + 1, 1)
        column.addLayout(grid)
        return holder

    # -- changes -----------------------------------------------------------------

    def _on_field(self, field: Field, value: Any) -> None:
        subject = self._subject
        if subject is None:
            return
        old = _value(field, subject.value)
        widget = self.field(field.attribute)
        if value == "" or value is None:
            if field.fixed:
                self._refuse(widget, old, self.tr("This can not be left empty."))
                return
            value = field.empty
        if value == old:
            return
        if field.editor == "note":
            noted, text = notes.annotate(subject.document, subject.place, value)
            if text:
                self.edited.emit(noted, text, subject.place)
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

    def _on_test(self, test: Test) -> None:
        subject = self._subject
        if subject is None or test == subject.value:
            return
        document = places.put(subject.document, subject.place, test)
        where = words.place_words(subject.document, subject.place)
        self.edited.emit(document, self.tr("Change {0}").format(where), subject.place)

    def _on_kind_asked(self, name: str) -> None:
        if self._subject is not None:
            self.kind_asked.emit(self._subject.place, name)

    def _on_section(self, attribute: str, value: Any, text: str) -> None:
        subject = self._subject
        if subject is None:
            return
        document = places.change(subject.document, subject.place, **{attribute: value})
        where = words.place_words(subject.document, subject.place)
        self.edited.emit(document, self.tr("{0} of {1}").format(text, where), subject.place)


def _value(field: Field, subject: Any) -> Any:
    """What a field shows of a value."""
    return notes.note_of(subject) if field.editor == "note" else getattr(subject, field.attribute)
