"""The two tables of the matrix beside each other: priorities, and who holds what when all ask.

Both show one model and share the range and the height at which they look; the situations stay at
the left and the holders at the right, however many modules there are between them.
"""

from __future__ import annotations

from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QLabel, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.matrix.model import MatrixModel
from situ_studio.matrix.table import MatrixTable

BAR = 6
SCROLL = 10
"""Px of the bar at the right end."""
LEAST = 60
"""Px to which a column is made narrower where all of them fit then."""
MOST = 0.45
"""The share of the width that the holders have at most."""


class Sides(QWidget):
    def __init__(self, theme: Theme, model: MatrixModel) -> None:
        super().__init__()
        self._model = model
        self.setProperty("role", "panel")
        self.setMinimumSize(px(240), px(90))
        self.table = MatrixTable(theme, model, self.tr("Priorities"), self)
        self.holders = MatrixTable(theme, model, self.tr("Who holds it when all ask"), self)
        self.holders.rows.hide()
        self.holders.setEditTriggers(MatrixTable.EditTrigger.NoEditTriggers)
        self.holders.setSelectionModel(self.table.selectionModel())
        self._bar = QFrame(self)
        self.hint = QLabel(self)
        self.hint.setProperty("role", "dim")
        self.hint.setContentsMargins(24, 0, 24, 0)
        self.hint.setWordWrap(True)
        # The bar at the right end moves both.
        self.table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        mine, theirs = self.table.verticalScrollBar(), self.holders.verticalScrollBar()
        mine.valueChanged.connect(theirs.setValue)
        theirs.valueChanged.connect(mine.setValue)
        self.table.left_by.connect(self._to_holders)
        self.holders.left_by.connect(self._to_modules)
        self.set_theme(theme)

    def set_theme(self, theme: Theme) -> None:
        self.table.set_theme(theme)
        self.holders.set_theme(theme)
        self._bar.setStyleSheet(f"background: {theme.line};")

    def show_chosen(self, rows: frozenset[int], columns: frozenset[int]) -> None:
        """What is selected in the document, whoever did that."""
        for table in (self.table, self.holders):
            table.cells.rows, table.cells.columns = rows, columns
            table.rows.chosen, table.heads.chosen = rows, columns
            table.viewport().update()
            table.rows.viewport().update()
            table.heads.viewport().update()

    def settle(self) -> None:
        """Other rows or columns: each table shows its own."""
        modules, every = len(self._model.modules), self._model.columnCount()
        for column in range(every):
            self.table.setColumnHidden(column, column >= modules)
            self.holders.setColumnHidden(column, column < modules)
        self.table.rows.settle_width()
        self._bar.setVisible(bool(every))
        self.holders.setVisible(bool(every))
        if not self._model.rowCount():
            self.hint.setText(self.tr("There is no situation yet: add one."))
        else:
            self.hint.setText("" if every else self.tr("There is no module yet: add one."))
        self._divide()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._divide()

    def _divide(self) -> None:
        """The holders have the width they want, within bounds; both have a bar below, or none."""
        count, every = len(self._model.modules), self._model.columnCount()
        room = self.width() - BAR
        heads = self.table.heads
        wanted = [heads.wide(column) for column in range(every)]
        narrow = [heads.narrow(column) for column in range(every)]
        widths = _fitting(wanted, narrow, room - self.table.rows.width() - SCROLL)
        for column, width in enumerate(widths):
            (self.table if column < count else self.holders).setColumnWidth(column, width)
        heads.settle(range(count))
        self.holders.heads.settle(range(count, every))
        modules = self.table.rows.width() + sum(widths[:count])
        holders = sum(widths[count:]) + SCROLL
        theirs = max(0, min(holders, max(room - modules, int(room * MOST))))
        mine = max(0, min(modules, room - theirs))
        # No layout: what the columns need is no reason for the window to be wider.
        high, beside = self.height(), mine + BAR + theirs
        self.table.setGeometry(0, 0, mine, high)
        self._bar.setGeometry(mine, 0, BAR, high)
        self.holders.setGeometry(mine + BAR, 0, theirs, high)
        self.hint.setGeometry(beside, 0, max(0, self.width() - beside), high)
        scrolls = modules > mine or holders > theirs
        policy = Qt.ScrollBarPolicy
        for table in (self.table, self.holders):
            table.setHorizontalScrollBarPolicy(
                policy.ScrollBarAlwaysOn if scrolls else policy.ScrollBarAlwaysOff
            )

    # -- going from one to the other by keys ------------------------------------------------

    def _to_holders(self) -> None:
        self._go(self.holders, len(self._model.modules))

    def _to_modules(self) -> None:
        self._go(self.table, len(self._model.modules) - 1)

    def _go(self, table: MatrixTable, column: int) -> None:
        there = self.table.currentIndex().siblingAtColumn(column)
        if there.isValid():
            flag = QItemSelectionModel.SelectionFlag.ClearAndSelect
            table.selectionModel().setCurrentIndex(there, flag)
            table.setFocus()


def _fitting(wanted: list[int], narrow: list[int], room: int) -> list[int]:
    """The widths of columns: as wanted, or narrower where they all fit then without scrolling."""
    over, spare = sum(wanted) - room, sum(wanted) - sum(narrow)
    if over <= 0 or not wanted:
        return wanted
    if over <= spare:
        pairs = zip(wanted, narrow, strict=True)
        return [wide - -(-(wide - least) * over // spare) for wide, least in pairs]
    for most in range(max(narrow), LEAST - 1, -1):
        capped = [min(width, most) for width in narrow]
        if sum(capped) <= room:
            return capped
    return wanted
