"""Rows of fields: what a form has of a list or a table, each row with a button that removes it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from msgspec import Struct
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import FieldWidget, Line, Paragraph
from situ_studio.project_form.values import ValueField
from situ_studio.widgets.icon_widgets import IconButton

AnyField = FieldWidget | ValueField


class Column(Struct, frozen=True, kw_only=True):
    """One column. make: its field; None for words that can not be changed. share: of the room."""

    title: str
    make: Callable[[Theme, QWidget], AnyField] | None = None
    share: int = 1
    help: str = ""


class Checked(Line):
    """A line whose text becomes a value; ``read`` raises ValueError with a sentence."""

    def __init__(self, check: Callable[[str], Any], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._check = check

    def read(self, text: str) -> Any:
        return self._check(text.strip())


class Rows(QWidget):
    """movable: rows have an order that counts, and buttons that change it."""

    changed = Signal(int, int, object)
    """Row, column, and the value that was typed."""
    removed = Signal(int)
    moved = Signal(int, int)
    """From one row to another."""
    refused = Signal(str)

    def __init__(
        self,
        theme: Theme,
        columns: Sequence[Column],
        noun: str,
        movable: bool = False,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._theme, self._columns, self._noun = theme, columns, noun
        self._movable = movable
        self._rows: list[list[QWidget]] = []
        self._heads: list[QLabel] = []
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(4)
        for at, column in enumerate(columns):
            self._grid.setColumnStretch(at, column.share)
            head = QLabel(column.title)
            head.setProperty("role", "hint")
            head.setToolTip(column.help)
            self._heads.append(head)
            self._grid.addWidget(head, 0, at)

    def __len__(self) -> int:
        return len(self._rows)

    def field(self, row: int, column: int) -> QWidget:
        """The field, or label, of a cell."""
        return self._rows[row][column]

    def buttons(self, row: int) -> list[IconButton]:
        """Those at the end of a row: up and down where it can be moved, then remove."""
        return [one for one in self._rows[row] if isinstance(one, IconButton)]

    def show_rows(self, values: Sequence[Sequence[Any]]) -> None:
        """Shows these; fields that are there stay, with the focus."""
        while len(self._rows) > len(values):
            for widget in self._rows.pop():
                self._grid.removeWidget(widget)
                widget.hide()
                widget.deleteLater()
        while len(self._rows) < len(values):
            self._add_row()
        for head in self._heads:
            head.setVisible(bool(values) and bool(head.text()))
        for at, (widgets, row) in enumerate(zip(self._rows, values, strict=True)):
            for widget, value in zip(widgets, row, strict=False):
                if isinstance(widget, QLabel):
                    widget.setText(str(value))
                elif isinstance(widget, AnyField):
                    widget.show_value(value)
            for button in self.buttons(at)[: 2 if self._movable else 0]:
                up = button is self.buttons(at)[0]
                button.setEnabled(at > 0 if up else at < len(values) - 1)

    def begin(self, row: int, column: int = 0) -> None:
        """Gives a field of a row the focus, its text selected."""
        fields = self._rows[row][column:]
        first = next((w for w in fields if not isinstance(w, (QLabel, IconButton))), None)
        if first is not None:
            first.setFocus(Qt.FocusReason.OtherFocusReason)
        if isinstance(first, Line | Paragraph):
            first.selectAll()

    def _add_row(self) -> None:
        at = len(self._rows)
        widgets: list[QWidget] = []
        for number, column in enumerate(self._columns):
            if column.make is None:
                label = QLabel()
                label.setProperty("role", "dim")
                widgets.append(label)
            else:
                field = column.make(self._theme, self)
                field.setAccessibleName(f"{column.title or self._noun} {at + 1}")
                if isinstance(field, Line | ValueField):
                    field.set_help(column.help)
                else:
                    field.setToolTip(column.help)
                if isinstance(field, Line | ValueField):
                    field.refused.connect(self.refused)
                field.committed.connect(
                    lambda value, row=at, n=number: self.changed.emit(row, n, value)
                )
                widgets.append(field)
        if self._movable:
            widgets.append(self._button("up", self.tr("Up"), lambda: self.moved.emit(at, at - 1)))
            widgets.append(
                self._button("down", self.tr("Down"), lambda: self.moved.emit(at, at + 1))
            )
        words = self.tr("Remove {0}").format(self._noun)
        widgets.append(self._button("close", words, lambda: self.removed.emit(at)))
        for number, widget in enumerate(widgets):
            self._grid.addWidget(widget, at + 1, number)
        self._rows.append(widgets)

    def _button(self, icon: str, words: str, pressed: Callable[[], object]) -> IconButton:
        made = IconButton(self._theme, icon, words, "text3", 14)
        made.clicked.connect(lambda: pressed())
        return made
