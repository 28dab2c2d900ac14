"""What is done with a range of cells: typed, cleared, filled, copied, pasted; each is one step."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QObject, Signal

from situ_studio.matrix import clipboard, edits
from situ_studio.matrix.edits import Wanted
from situ_studio.matrix.model import MatrixModel
from situ_studio.matrix.table import Area, MatrixTable


class RangeEdits(QObject):
    """The edits of one table. Nothing is kept here: the script that follows is told."""

    edited = Signal(object, str)
    status = Signal(str)

    def __init__(self, model: MatrixModel, table: MatrixTable) -> None:
        super().__init__(table)
        self._model, self._table = model, table
        model.typed.connect(self._on_typed)
        table.filled.connect(self._on_filled)

    def _put(self, wanted: dict[tuple[int, str], Wanted], text: str) -> None:
        """One step for all of these cells; none where nothing changes."""
        assert self._model.grid is not None
        script = self._model.grid.script
        after = edits.put(script, wanted)
        if after is not script:
            self.edited.emit(after, text)

    def _on_typed(self, row: int, column: int, text: str) -> None:
        assert self._model.grid is not None
        try:
            value = edits.read(text)
        except ValueError as wrong:
            self.status.emit(str(wrong))
            return
        module = self._model.grid.modules[column]
        name = self._model.line(row).situation.name
        said = self.tr("none") if value in (None, "none") else str(value)
        told = self.tr("Give {0} the priority {1} in {2}").format(module, said, name)
        self._put({(row, module): value}, told)

    def edit(self) -> None:
        self._table.edit_current()

    def clear(self) -> None:
        """The cells of the range say nothing themselves any more."""
        area = self._table.area
        if area is None or self._model.grid is None:
            return
        wanted: dict[tuple[int, str], Wanted] = {
            (row, self._model.grid.modules[column]): None for row, column in _cells(area)
        }
        before = self._model.grid
        self._put(wanted, self._named(self.tr("Clear {0}"), area))
        cell = self._model.cell(area.top, area.left)
        if self._model.grid is before and cell.source and area.high == area.wide == 1:
            self.status.emit(
                self.tr("This is taken over from {0}: type none to take it away here.").format(
                    cell.source
                )
            )

    def copy(self) -> None:
        """The range to the clipboard, as text and as a table."""
        area = self._table.area
        if area is None:
            return
        clipboard.put(self._texts(area))
        self.status.emit(self._named(self.tr("{0} copied"), area))

    def cut(self) -> None:
        self.copy()
        self.clear()

    def paste(self) -> None:
        """What the clipboard holds into the range, all of it or, where it can not be, nothing."""
        self._fill(clipboard.cells(), self._table.area, self.tr("Paste {0}"))

    def fill_down(self) -> None:
        """The first row of the range into the others; into a single row what stands above it."""
        area = self._table.area
        if area is None or (area.high == 1 and not area.top):
            return
        top = area.top if area.high > 1 else area.top - 1
        first = Area(top, area.left, 1, area.wide)
        self._on_filled(first, Area(top, area.left, area.bottom - top + 1, area.wide))
        self._table.choose(area)

    def fill_right(self) -> None:
        """The first column of the range into the others; into a single one what is left of it."""
        area = self._table.area
        if area is None or (area.wide == 1 and not area.left):
            return
        left = area.left if area.wide > 1 else area.left - 1
        first = Area(area.top, left, area.high, 1)
        self._on_filled(first, Area(area.top, left, area.high, area.right - left + 1))
        self._table.choose(area)

    def _on_filled(self, first: Area, whole: Area) -> None:
        """The cells of the first range again and again, as far as the whole one reaches."""
        texts = self._texts(first)
        rows = [
            [texts[down % first.high][across % first.wide] for across in range(whole.wide)]
            for down in range(whole.high)
        ]
        self._fill(rows, whole, self.tr("Fill {0}"))

    def _fill(self, rows: edits.Texts, area: Area | None, text: str) -> None:
        grid = self._model.grid
        if area is None or grid is None:
            return
        try:
            wanted = edits.spread(grid, rows, area.top, area.left, area.high, area.wide)
        except ValueError as wrong:
            cell = self._table.visualRect(self._model.index(area.top, area.left))
            self._table.sentence.say(cell, str(wrong))
            self.status.emit(str(wrong))
            return
        self._table.sentence.hide()
        whole = Area(area.top, area.left, *edits.reach(rows, area.high, area.wide))
        self._put(wanted, self._named(text, whole))
        self._table.choose(whole)

    def _texts(self, area: Area) -> list[list[str]]:
        columns = range(area.left, area.right + 1)
        return [
            [self._model.cell(row, column).text for column in columns]
            for row in range(area.top, area.bottom + 1)
        ]

    def _named(self, text: str, area: Area) -> str:
        """The name of a step, with what it changes: one priority, or how many."""
        if area.high * area.wide > 1:
            many = self.tr("{0} priorities").format(area.high * area.wide)
            return text.format(many)
        name = self._model.line(area.top).situation.name
        one = self.tr("{0} in {1}").format(self._model.modules[area.left], name)
        return text.format(one)


def _cells(area: Area) -> Iterator[tuple[int, int]]:
    for row in range(area.top, area.bottom + 1):
        for column in range(area.left, area.right + 1):
            yield row, column
