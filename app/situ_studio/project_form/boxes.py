"""The boxes of the project form: single fields, or rows of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFormLayout, QFrame, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from situ.document import toml_writing as writing
from situ.document.beside import Toml
from situ_studio.edits.edit import Place
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.project_form.rows import Checked, Column, Rows
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.wording.language import tr

LABEL = 128
"""Px that the longest label needs, in any language."""
Change = Callable[[Toml], Toml]
Tables = Mapping[str, Any]


class Section(QFrame):
    """A box with a title, what it is for, and what is in it."""

    edited = Signal(object, str)
    """A ``Change``, and the name of the step."""
    refused = Signal(str)

    def __init__(self, theme: Theme, title: str, hint: str, plus: str = "") -> None:
        super().__init__()
        self.setProperty("role", "box")
        self.theme = theme
        self.setAccessibleName(title)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 10, 12, 14)
        column.setSpacing(8)
        head = QHBoxLayout()
        self.title = QLabel(title)
        self.title.setProperty("role", "subject")
        head.addWidget(self.title, 1)
        self.plus = IconButton(theme, "plus", plus, "text2", 16)
        self.plus.setVisible(bool(plus))
        head.addWidget(self.plus)
        column.addLayout(head)
        if hint:
            told = QLabel(hint)
            told.setProperty("role", "words")
            told.setWordWrap(True)
            column.addWidget(told)
        self.body = column

    def show_tables(self, tables: Tables) -> None:
        """Shows what the file says."""

    def tell(self, change: Change, words: str) -> None:
        self.edited.emit(change, words)


class FieldsSection(Section):
    """Single values. fields: (table, key, label, help, check)."""

    def __init__(
        self,
        theme: Theme,
        title: str,
        hint: str,
        fields: Sequence[tuple[str, str, str, str, Callable[[str], str]]],
    ) -> None:
        super().__init__(theme, title, hint)
        form = QFormLayout()
        form.setHorizontalSpacing(12)
        form.setVerticalSpacing(6)
        self.fields: dict[tuple[str, str], Checked] = {}
        for table, key, label, help, check in fields:
            field = Checked(check)
            field.set_help(help)
            field.setAccessibleName(label)
            field.setPlaceholderText(help)
            field.refused.connect(self.refused)
            field.committed.connect(
                lambda value, t=table, k=key, words=label: self._on_value(t, k, words, value)
            )
            words = QLabel(label)
            words.setProperty("role", "label")
            # Boxes stand below each other, their fields in one line.
            words.setMinimumWidth(px(LABEL))
            words.setBuddy(field)
            words.setToolTip(help)
            form.addRow(words, field)
            self.fields[table, key] = field
        self.body.addLayout(form)

    def show_tables(self, tables: Tables) -> None:
        for (table, key), field in self.fields.items():
            value = table_of(tables, table).get(key)
            field.show_value(value if isinstance(value, str) else "")

    def field_of(self, table: str, key: str) -> QWidget | None:
        """The field of a value; None where it has none."""
        return self.fields.get((table, key))

    def _on_value(self, table: str, key: str, label: str, value: str) -> None:
        words = tr("Change {0}").format(label.lower())
        self.tell(lambda toml: writing.put(toml, table, key, value or None), words)


class RowsSection(Section):
    """A list or table, a row each."""

    noun = ""

    def __init__(
        self, theme: Theme, title: str, hint: str, columns: Sequence[Column], noun: str
    ) -> None:
        super().__init__(theme, title, hint, tr("Add {0}").format(noun))
        self.noun = noun
        self.rows = Rows(theme, columns, noun, self.movable)
        self.rows.changed.connect(self.on_changed)
        self.rows.removed.connect(self.on_removed)
        self.rows.moved.connect(self.on_moved)
        self.rows.refused.connect(self.refused)
        self.plus.clicked.connect(self.on_added)
        self.body.addWidget(self.rows)

    movable = False

    def row_of(self, place: Place) -> int | None:
        """Which row shows what stands at a place of the file; None: no single one."""
        at = place[2:3] if place[:1] != ("setting",) else place[1:2]
        return int(at[0]) if at and at[0].isdecimal() else None

    def show_values(self, values: Sequence[Sequence[Any]]) -> None:
        self.rows.show_rows(values)
        self.rows.setVisible(bool(values))

    def on_changed(self, row: int, column: int, value: Any) -> None:
        """A cell got another value."""

    def on_removed(self, row: int) -> None: ...

    def on_moved(self, row: int, to: int) -> None: ...

    def on_added(self) -> None: ...

    def added(self, change: Change) -> None:
        """Tells one more row, and puts the cursor into it."""
        before = len(self.rows)
        self.tell(change, tr("Add {0}").format(self.noun))
        if len(self.rows) > before:
            self.rows.begin(len(self.rows) - 1)


def table_of(tables: Tables, name: str) -> Mapping[str, Any]:
    found = tables.get(name)
    return found if isinstance(found, dict) else {}


def texts_of(value: Any) -> list[str]:
    return [one for one in value if isinstance(one, str)] if isinstance(value, list) else []
