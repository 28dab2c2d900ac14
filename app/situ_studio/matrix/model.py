"""The matrix as Qt's model: situations down, modules and then resources across."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from msgspec import Struct
from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtWidgets import QWidget

from situ.decide.all_ask import Holding
from situ.document.problem import Problem
from situ_studio.matrix.grid import Cell, Grid, Line
from situ_studio.matrix.marks import Marks
from situ_studio.wording.language import said

AnyIndex = QModelIndex | QPersistentModelIndex
SHOWN = Qt.ItemDataRole.UserRole
"""A role: what the headers paint, as ``Head``."""


class Shown(Struct, frozen=True):
    """One cell as it is painted. kind: of its text. mark: an icon beside it, or nothing."""

    text: str
    kind: str
    mark: str = ""


_BLANK = Shown("", "taken")
# Asked of every cell that is painted.
_READ = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
_TYPED = _READ | Qt.ItemFlag.ItemIsEditable


class Head(Struct, frozen=True):
    """A header as it is painted. number: of a situation; current, holds: what is supposed, or what
    a robot does. below: the longest text that may stand below it.
    """

    text: str
    icon: str
    number: int = 0
    mark: str = ""
    current: bool = False
    holds: bool = False
    below: str = ""


class MatrixModel(QAbstractTableModel):
    """Shows a ``Grid``; a text that was typed is told, not kept."""

    typed = Signal(int, int, str)
    """Row, column, text."""

    _NO: ClassVar[QModelIndex] = QModelIndex()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.grid: Grid | None = None
        self.marks = Marks((), None)
        self._current: str | None = None
        self._holds: frozenset[str] = frozenset()

    # -- taking a new value --------------------------------------------------------

    def show(self, grid: Grid) -> bool:
        """Takes a new grid. False where rows and columns are the same as before, so that only
        what differs was told.
        """
        before, self.grid = self.grid, grid
        same = (
            before is not None
            and before.modules == grid.modules
            and before.resources == grid.resources
            and _names(before) == _names(grid)
        )
        if not same or before is None:
            self.beginResetModel()
            self.endResetModel()
            return True
        pairs = zip(before.lines, grid.lines, strict=True)
        changed = [row for row, (old, new) in enumerate(pairs) if old is not new]
        for first, last in _runs(changed) if self.columnCount() else ():
            end = self.index(last, self.columnCount() - 1)
            self.dataChanged.emit(self.index(first, 0), end)
        return False

    def show_problems(self, problems: Sequence[Problem]) -> bool:
        """Marks what a check has found; whether that is anything else than before."""
        script = self.grid.script if self.grid is not None else None
        marks = Marks(problems, script)
        if marks == self.marks:
            return False
        self.marks = marks
        if self.grid is not None and self.grid.lines and self.columnCount():
            self.dataChanged.emit(
                self.index(0, 0), self.index(self.rowCount() - 1, self.columnCount() - 1)
            )
            self._heads_changed()
        return True

    def show_situation(self, current: str | None, holds: frozenset[str]) -> None:
        """Marks the current situation, and those whose condition holds; None: none is marked."""
        if (current, holds) != (self._current, self._holds):
            self._current, self._holds = current, holds
            self._heads_changed()

    def _heads_changed(self) -> None:
        for way, count in (
            (Qt.Orientation.Vertical, self.rowCount()),
            (Qt.Orientation.Horizontal, self.columnCount()),
        ):
            if count:
                self.headerDataChanged.emit(way, 0, count - 1)

    # -- Qt's questions ---------------------------------------------------------------

    def rowCount(self, parent: AnyIndex = _NO) -> int:
        return 0 if parent.isValid() or self.grid is None else len(self.grid.lines)

    def columnCount(self, parent: AnyIndex = _NO) -> int:
        if parent.isValid() or self.grid is None:
            return 0
        return len(self.grid.modules) + len(self.grid.resources)

    @property
    def modules(self) -> tuple[str, ...]:
        return self.grid.modules if self.grid is not None else ()

    def line(self, row: int) -> Line:
        assert self.grid is not None
        return self.grid.lines[row]

    def cell(self, row: int, column: int) -> Cell:
        """Of a module's column."""
        return self.line(row).cell(self.modules[column])

    def flags(self, index: AnyIndex) -> Qt.ItemFlag:
        if not index.isValid():
            return Qt.ItemFlag.NoItemFlags
        return _TYPED if index.column() < len(self.modules) else _READ

    def setData(self, index: AnyIndex, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or index.column() >= len(self.modules):
            return False
        self.typed.emit(index.row(), index.column(), str(value))
        return True

    def data(self, index: AnyIndex, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid() or self.grid is None:
            return None
        row, column = index.row(), index.column()
        if column < len(self.modules):
            return self._of_module(row, column, role)
        return self._of_resource(row, self.grid.resources[column - len(self.modules)], role)

    def shown(self, row: int, column: int) -> Shown:
        """A cell as it is painted."""
        assert self.grid is not None
        modules, line = self.grid.modules, self.grid.lines[row]
        if column >= len(modules):
            held = line.holdings[self.grid.resources[column - len(modules)]]
            kind = "tie" if held.rivals else "holder" if held.module else "nobody"
            return Shown(self._holder(held), kind)
        cell = line.cells.get(modules[column])
        if cell is None:
            return _BLANK
        mark = self.marks.cell(line.situation.name, modules[column])
        text = self.tr("none") if cell.text == "none" else cell.text
        kind = "own" if cell.own else "taken"
        return Shown(text, kind, mark or ("warning" if cell.rivals else ""))

    def _holder(self, held: Holding) -> str:
        return self.tr("tie") if held.rivals else held.module or self.tr("nobody")

    def _of_module(self, row: int, column: int, role: int) -> Any:
        cell = self.cell(row, column)
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            return self.tr("none") if cell.text == "none" else cell.text
        if role == Qt.ItemDataRole.ToolTipRole:
            return "\n".join(self._told(row, column, cell)) or None
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return self._heard(row, column, cell)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignCenter
        return None

    def _heard(self, row: int, column: int, cell: Cell) -> str:
        name, module = self.line(row).situation.name, self.modules[column]
        parts = [cell.text or self.tr("nothing")]
        if cell.source and not cell.own:
            parts.append(self.tr("taken over from {0}").format(cell.source))
        if cell.rivals:
            parts.append(self.tr("tie"))
        if self.marks.cell(name, module):
            parts.append(self.tr("with a problem"))
        return self.tr("priority of {0} in {1}: {2}").format(module, name, ", ".join(parts))

    def _told(self, row: int, column: int, cell: Cell) -> list[str]:
        """What a tooltip says; nothing where the number says it all."""
        name, module = self.line(row).situation.name, self.modules[column]
        found = []
        if cell.own and cell.priority is None:
            found.append(self.tr("Taken away here: {0} can hold nothing.").format(module))
        elif cell.source and not cell.own:
            found.append(self.tr("Taken over from {0}.").format(cell.source))
        if cell.own and cell.source and cell.taken is not None:
            there = self.tr("Without this it would be {0}, as in {1}.")
            found.append(there.format(cell.taken, cell.source))
        told = self.marks.told_of_cell(name, module)
        if cell.rivals and not told:
            both = self.tr("The same priority as {0}: whoever asks first holds it.")
            found.append(both.format(", ".join(cell.rivals)))
        return [*found, *map(said, told)]

    def _of_resource(self, row: int, resource: str, role: int) -> Any:
        held = self.line(row).holdings[resource]
        if role == Qt.ItemDataRole.DisplayRole:
            return self._holder(held)
        if role in (Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleTextRole):
            name = self.line(row).situation.name
            holder = held.module or self.tr("nobody")
            who = self.tr("{0} in {1}, when all ask: {2}").format(resource, name, holder)
            if not held.rivals:
                return who
            first = self.tr("{0} in {1}: a tie; whoever asks first holds it, of {2}")
            several = (held.module, *held.rivals) if held.module is not None else held.rivals
            return first.format(resource, name, ", ".join(several))
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignCenter
        return None

    # -- headers --------------------------------------------------------------------

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        down = orientation == Qt.Orientation.Vertical
        count = self.rowCount() if down else self.columnCount()
        if self.grid is None or not 0 <= section < count:
            return None
        if down:
            return self._of_situation(section, role)
        if section < len(self.modules):
            return self._of_column(self.modules[section], role)
        resource = self.grid.resources[section - len(self.modules)]
        if role == SHOWN:
            asked = self.grid.asked.by_module
            askers = (module for module, several in asked.items() if resource in several)
            return Head(resource, "resource", below=max(askers, key=len, default=""))
        if role == Qt.ItemDataRole.ToolTipRole:
            return self.tr("Who holds {0} when all modules ask for all they can use").format(
                resource
            )
        return resource if role == Qt.ItemDataRole.DisplayRole else None

    def _of_column(self, module: str, role: int) -> Any:
        assert self.grid is not None
        if role == Qt.ItemDataRole.DisplayRole:
            return module
        told = self.marks.told_of_module(module)
        if role == SHOWN:
            return Head(module, "module", mark="warning" if told else "")
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return self.tr("{0}, with a problem").format(module) if told else module
        if role == Qt.ItemDataRole.ToolTipRole:
            uses = " ".join(self.grid.asked.by_module[module]) or self.tr("nothing")
            return "\n".join(
                (self.tr("{0} may ask for: {1}").format(module, uses), *map(said, told))
            )
        return None

    def _of_situation(self, row: int, role: int) -> Any:
        name = self.line(row).situation.name
        current, holds = name == self._current, name in self._holds
        mark = self.marks.situation(name)
        if role == Qt.ItemDataRole.DisplayRole:
            return name
        if role == SHOWN:
            return Head(name, "situation", row + 1, mark, current, holds)
        if role == Qt.ItemDataRole.AccessibleTextRole:
            parts = [f"{row + 1} {name}"]
            parts += [self.tr("current")] if current else []
            parts += [self.tr("its condition holds")] if holds else []
            parts += [self.tr("with a problem")] if mark else []
            return ", ".join(parts)
        if role == Qt.ItemDataRole.ToolTipRole:
            above = self.line(row).chain[1:]
            told = [self.tr("{0}, before all below it").format(name)]
            if above:
                told.append(self.tr("Takes over from {0}.").format(above[0].name))
            return "\n".join((*told, *map(said, self.marks.told_of_situation(name))))
        return None


def _names(grid: Grid) -> list[str]:
    return [line.situation.name for line in grid.lines]


def _runs(rows: Sequence[int]) -> list[tuple[int, int]]:
    """Rows that follow each other, as their first and last."""
    found: list[tuple[int, int]] = []
    for row in rows:
        if found and found[-1][1] == row - 1:
            found[-1] = found[-1][0], row
        else:
            found.append((row, row))
    return found
