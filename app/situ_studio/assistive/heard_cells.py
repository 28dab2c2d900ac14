"""What a screen reader says of a table's cell: the head of its column, and what stands in it.

Readers read a row cell by cell and tell a head where the column changes only, so that who goes
down a table would hear values without knowing of what.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QTableWidgetItem, QTreeWidgetItem

from situ_studio.wording.language import tr

HEARD = int(Qt.ItemDataRole.AccessibleTextRole)
SHOWN = int(Qt.ItemDataRole.DisplayRole)


def headed(head: str, said: str) -> str:
    """For ``AccessibleTextRole``. An empty cell says nothing, a column without a head its value."""
    return tr("{0}: {1}").format(head, said) if head and said else said


class HeardRow(QTreeWidgetItem):
    """A row of a tree. Below a heading its first cell says which row it is, and needs no head."""

    def data(self, column: int, role: int) -> Any:
        below = self.parent() is not None and not column
        if role != HEARD or below:
            return super().data(column, role)
        head = self.treeWidget().headerItem().text(column)
        return headed(head, str(super().data(column, SHOWN) or ""))


class HeardCell(QTableWidgetItem):
    """A cell of a table."""

    def data(self, role: int) -> Any:
        if role != HEARD:
            return super().data(role)
        head = self.tableWidget().horizontalHeaderItem(self.column())
        return headed(head.text() if head is not None else "", str(super().data(SHOWN) or ""))
