"""A quiet table of text for what a robot tells: rows are replaced, the selection stays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from msgspec import Struct
from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QPersistentModelIndex,
    QRectF,
    Qt,
    Signal,
)
from PySide6.QtGui import QFontMetrics, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QShowEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from situ_studio.assistive.heard_cells import headed
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme, font
from situ_studio.widgets.focus_ring import paint_bar

ROW = 24
BESIDE = 20
"""What a cell leaves free beside its words."""


class Row(Struct, frozen=True):
    """key: what a row is about, the same over changes. marked: drawn in the live colour. link: the
    cell that leads elsewhere.
    """

    key: str
    cells: tuple[str, ...]
    marked: bool = False
    tip: str = ""
    link: int = -1


class RowsModel(QAbstractTableModel):
    """Rows in the order given; only what differs is told to the view.

    tips: what each column says, for its head.
    """

    tips: Sequence[str] = ()

    def __init__(self, titles: Sequence[str], theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self._titles = list(titles)
        self._theme = theme
        self._rows: Sequence[Row] = []
        self._later: Callable[[], list[Row]] | None = None

    @property
    def rows(self) -> Sequence[Row]:
        """Also those that nobody has looked at yet."""
        self.settle()
        return self._rows

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self._told(0, len(self._rows) - 1)

    def show_later(self, make: Callable[[], list[Row]]) -> None:
        """Takes the rows that ``make`` gives, once somebody looks."""
        self._later = make

    def settle(self) -> None:
        """Takes what was to be taken later."""
        make, self._later = self._later, None
        if make is not None:
            self.show(make())

    def show(self, rows: list[Row]) -> None:
        """Takes these rows; the same keys in the same order keep their places."""
        self._later = None
        if [row.key for row in rows] != [row.key for row in self._rows]:
            self.exchange(rows)
            return
        before, self._rows = self._rows, rows
        changed = [n for n, (a, b) in enumerate(zip(before, rows, strict=True)) if a != b]
        if changed:
            self._told(changed[0], changed[-1])

    def exchange(self, rows: Sequence[Row]) -> None:
        """Takes other rows, which may be read where they are looked at only."""
        self.beginResetModel()
        self._rows = rows
        self.endResetModel()

    def drop(self, gone: int, drop: Callable[[int], None]) -> None:
        """``drop`` takes so many of the first rows away."""
        if gone:
            self.beginRemoveRows(QModelIndex(), 0, gone - 1)
            drop(gone)
            self.endRemoveRows()

    def add(self, came: int, add: Callable[[int], None]) -> None:
        """``add`` puts so many rows at the end."""
        if came:
            first = len(self._rows)
            self.beginInsertRows(QModelIndex(), first, first + came - 1)
            add(came)
            self.endInsertRows()

    def _told(self, first: int, last: int) -> None:
        if last >= first:
            end = self.index(last, len(self._titles) - 1)
            self.dataChanged.emit(self.index(first, 0), end)

    def rowCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: QModelIndex | QPersistentModelIndex = QModelIndex()) -> int:
        return 0 if parent.isValid() else len(self._titles)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation == Qt.Orientation.Horizontal and role == Qt.ItemDataRole.DisplayRole:
            return self._titles[section]
        if orientation == Qt.Orientation.Horizontal and role == Qt.ItemDataRole.ToolTipRole:
            return self.tips[section] if self.tips else None
        return None

    def data(
        self,
        index: QModelIndex | QPersistentModelIndex,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        row = self._rows[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return row.cells[index.column()]
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return headed(self._titles[index.column()], row.cells[index.column()])
        if role == Qt.ItemDataRole.ForegroundRole:
            if index.column() == row.link:
                return self._theme.color("accent")
            token = "text2" if index.column() else "text"
            return self._theme.color("live" if row.marked else token)
        if role == Qt.ItemDataRole.ToolTipRole:
            return row.tip or row.cells[index.column()]
        if role == Qt.ItemDataRole.FontRole:
            return font(12)
        return None


class RowsTable(QTableView):
    """widths: of all columns but the last, which takes the rest; px of the design."""

    chosen = Signal(QModelIndex)
    """A row that a person clicks, or presses Enter on; once also where it is clicked twice."""

    def __init__(
        self,
        name: str,
        titles: Sequence[str],
        widths: Sequence[int],
        theme: Theme,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self._theme = theme
        self.rows = RowsModel(titles, theme, self)
        self.setModel(self.rows)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(px(ROW))
        self.verticalHeader().setMinimumSectionSize(px(ROW))
        self.clicked.connect(self.chosen)
        header = self.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setFixedHeight(px(ROW))
        for column, width in enumerate(widths):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Interactive)
            header.resizeSection(column, px(width))
        header.setStretchLastSection(True)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.rows.set_theme(theme)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self.viewport())
        for index in self.selectionModel().selectedRows():
            paint_bar(painter, QRectF(self.visualRect(index)), self._theme, px(2))
        painter.end()

    def show_made(self, make: Callable[[], list[Row]]) -> None:
        """The rows that ``make`` gives: at once where they are seen, else once they are."""
        if self.isVisible():
            self.rows.show(make())
        else:
            self.rows.show_later(make)

    def showEvent(self, event: QShowEvent) -> None:
        self.rows.settle()
        super().showEvent(event)

    def make_room(self, column: int, text: str) -> None:
        """That column becomes as wide as it must be for the text, never narrower."""
        needed = QFontMetrics(font(12)).horizontalAdvance(text) + px(BESIDE)
        if needed > self.columnWidth(column):
            self.setColumnWidth(column, needed)

    def choose(self, key: str) -> None:
        """The row of that key has the keyboard and is seen, if there is one."""
        for place, row in enumerate(self.rows.rows):
            if row.key == key:
                self.setCurrentIndex(self.rows.index(place, 0))
                self.scrollTo(self.currentIndex())
                self.setFocus()

    def when_chosen(self, told: Callable[[str], None]) -> None:
        """``told`` gets the key of a row that is ``chosen``."""
        self.chosen.connect(lambda index: told(self.rows.rows[index.row()].key))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        index = self.currentIndex()
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and index.isValid():
            self.chosen.emit(index)
        else:
            super().keyPressEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        # Its first press has chosen the row already.
        event.accept()
