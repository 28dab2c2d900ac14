"""The entries of a list as a small table: a row an entry, a column each field that is shown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QWidget,
)

from situ.decide.values import in_text
from situ.document.values import read
from situ_studio.assistive.heard_cells import HeardCell
from situ_studio.looks.letters import px

ROW = 26
MOST = 6
"""Rows that are seen at once."""


class SampleTable(QTableWidget):
    """fields: of the entries; none where an entry is one value. The last row is for one more; a
    row whose cells are all empty is none.
    """

    edited = Signal(list)
    """The entries as they are now."""

    def __init__(
        self, name: str, fields: tuple[str, ...], entries: list[Any], parent: QWidget | None = None
    ) -> None:
        super().__init__(0, max(1, len(fields)), parent)
        self._fields = fields
        self._entries = entries
        self.setAccessibleName(name)
        self.setHorizontalHeaderLabels(list(fields) or [self.tr("Entry")])
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(px(ROW))
        self.setEditTriggers(QAbstractItemView.EditTrigger.AllEditTriggers)
        self.setTabKeyNavigation(False)
        for entry in entries:
            values = [
                entry.get(field) if isinstance(entry, Mapping) and field else entry
                for field in fields or ("",)
            ]
            self._add(["" if value is None else in_text(value) for value in values])
        self._add([""] * self.columnCount())
        self.horizontalHeader().setFixedHeight(px(ROW))
        self.setFixedHeight(px(ROW) * (min(len(entries) + 1, MOST) + 1) + 6)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self.cellChanged.connect(self._on_changed)

    def entries(self) -> list[Any]:
        """As they stand there; what an entry has beside these fields stays."""
        found: list[Any] = []
        for row in range(self.rowCount()):
            texts = [self._text(row, column) for column in range(self.columnCount())]
            if not any(texts):
                continue
            old = self._entries[row] if row < len(self._entries) else {}
            if not self._fields:
                found.append(read(texts[0]))
                continue
            rest = dict(old) if isinstance(old, Mapping) else {}
            given = {f: read(t) for f, t in zip(self._fields, texts, strict=True) if t}
            kept = {f: v for f, v in rest.items() if f not in self._fields}
            found.append(kept | given)
        return found

    def _add(self, texts: list[str]) -> None:
        row = self.rowCount()
        self.blockSignals(True)
        self.insertRow(row)
        for column, text in enumerate(texts):
            self.setItem(row, column, HeardCell(text))
        self.blockSignals(False)

    def _text(self, row: int, column: int) -> str:
        item = self.item(row, column)
        return item.text().strip() if item is not None else ""

    def _on_changed(self, row: int, _column: int) -> None:
        self.edited.emit(self.entries())
        if row == self.rowCount() - 1:
            self._add([""] * self.columnCount())
