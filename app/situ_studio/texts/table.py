"""The table of texts as a spreadsheet: keys, copy and paste, and the way to where a text stands."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtCore import QCoreApplication, QEvent, QModelIndex, Qt, QTimer, Signal
from PySide6.QtGui import (
    QFontMetrics,
    QInputMethodEvent,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractScrollArea,
    QApplication,
    QHeaderView,
    QTableView,
    QWidget,
)

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme, font
from situ_studio.matrix import clipboard
from situ_studio.texts.cells import ONE_LINE, TextDelegate
from situ_studio.texts.model import ROW, STATE, WRITTEN, TextsModel
from situ_studio.texts.sheet import Typed

_KEYS = {
    QKeySequence.StandardKey.Copy: "copy",
    QKeySequence.StandardKey.Cut: "cut",
    QKeySequence.StandardKey.Paste: "paste",
    QKeySequence.StandardKey.SelectAll: "selectAll",
    QKeySequence.StandardKey.Delete: "clear_cells",
}
_WIDTHS = (176, 168)
BESIDE, ROOMY = 44, 320
"""Px beside the words of a place, and of a text before places get more room."""


class TextsTable(QTableView):
    """tags: what ``{`` offers, at the time of the call."""

    go_asked = Signal(str, tuple)
    """The file and the place of a text."""
    refused = Signal(str)

    def __init__(
        self, theme: Theme, tags: Callable[[], tuple[str, ...]], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Texts"))
        self.texts = TextsModel(self)
        self.setModel(self.texts)
        self.cells = TextDelegate(theme, tags, self._went, self)
        self.setItemDelegate(self.cells)
        self.setShowGrid(False)
        self.setMouseTracking(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.AnyKeyPressed
        )
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.verticalHeader().hide()
        self.verticalHeader().setMinimumSectionSize(px(ONE_LINE))
        self.verticalHeader().setDefaultSectionSize(px(ONE_LINE))
        header = self.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setMinimumSectionSize(px(80))
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(0)
        self._soon.timeout.connect(self._on_soon)
        self._changed: set[int] | None = None
        """Rows that may be of another height; None: any."""
        header.sectionResized.connect(lambda *_: self._settle_soon())
        self.texts.modelReset.connect(self._on_reset)
        self.texts.dataChanged.connect(self._on_rows)
        self._columns = 0
        self._wanted = list(_WIDTHS)

    def set_theme(self, theme: Theme) -> None:
        self.cells.theme = theme
        self.viewport().update()

    # -- sizes -------------------------------------------------------------------

    def _on_reset(self) -> None:
        if self.texts.columnCount() != self._columns:
            self._columns = self.texts.columnCount()
            self._measure()
            self._share_width()
        self._settle_soon()

    def _measure(self) -> None:
        """How wide the places are, and what their texts are."""
        measure = QFontMetrics(font(13)).horizontalAdvance
        rows = range(self.texts.rowCount())
        self._wanted = []
        for column in range(WRITTEN):
            words = {str(self.texts.index(row, column).data()) for row in rows}
            self._wanted.append(max(map(measure, words), default=0) + px(BESIDE))

    def _share_width(self) -> None:
        """Texts share what room the places leave, which are cut only where texts need it."""
        header = self.horizontalHeader()
        count = self.texts.columnCount() - WRITTEN
        spare = self.viewport().width() - sum(_WIDTHS) - count * ROOMY
        places = []
        for wanted, least in zip(self._wanted, _WIDTHS, strict=True):
            places.append(least + max(0, min(wanted - least, spare)))
            spare -= places[-1] - least
        for column, width in enumerate(places):
            header.resizeSection(column, width)
        room = self.viewport().width() - sum(places)
        for column in range(WRITTEN, WRITTEN + count):
            wide = max(220, header.sectionSizeHint(column), room // max(1, count))
            header.resizeSection(column, wide)

    def _settle_soon(self) -> None:
        self._changed = None
        self._soon.start()

    def _on_rows(self, first: QModelIndex, last: QModelIndex) -> None:
        if self._soon.isActive() and self._changed is None:
            return
        self._changed = (self._changed or set()) | set(range(first.row(), last.row() + 1))
        self._soon.start()

    def _on_soon(self) -> None:
        rows, self._changed = self._changed, None
        every = range(self.texts.rowCount())
        self.settle_heights(every if rows is None else [row for row in rows if row in every])

    def settle_heights(self, rows: Iterable[int]) -> None:
        """Each row is as high as the longest of its texts wants, up to some lines."""
        widths = [self.columnWidth(column) for column in range(self.texts.columnCount())]
        header = self.verticalHeader()
        for row in rows:
            high = max(
                (
                    self.cells.height(self.texts.index(row, column), widths[column])
                    for column in range(WRITTEN, len(widths))
                ),
                default=ONE_LINE,
            )
            if header.sectionSize(row) != high:
                header.resizeSection(row, high)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._share_width()

    # -- going there -------------------------------------------------------------

    def go(self) -> None:
        """Asks for the place of the current text."""
        index = self.currentIndex()
        if index.isValid():
            row = index.data(ROW)
            self.go_asked.emit(row.file, row.place)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        self._hover(self.indexAt(event.position().toPoint()))

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._hover(QModelIndex())

    def _hover(self, index: QModelIndex) -> None:
        over = (index.row(), index.column()) if index.isValid() else None
        if over != self.cells.hovered:
            self.cells.hovered = over
            self.viewport().update()
        linked = over is not None and over[1] == STATE
        shape = Qt.CursorShape.PointingHandCursor if linked else Qt.CursorShape.ArrowCursor
        self.viewport().setCursor(shape)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        super().mouseReleaseEvent(event)
        index = self.indexAt(event.position().toPoint())
        plain = event.modifiers() == Qt.KeyboardModifier.NoModifier
        one = len(self.selectedIndexes()) == 1
        left = event.button() == Qt.MouseButton.LeftButton
        if left and plain and one and index.isValid() and index.column() == STATE:
            self.go()

    # -- keys --------------------------------------------------------------------

    def event(self, event: QEvent) -> bool:
        override = event.type() == QEvent.Type.ShortcutOverride
        if override and isinstance(event, QKeyEvent) and any(map(event.matches, _KEYS)):
            event.accept()
            return True
        return super().event(event)

    def focusNextPrevChild(self, next: bool) -> bool:
        """Tab goes from cell to cell, and on behind the last one: Qt would begin again."""
        ways = self.CursorAction
        way = ways.MoveNext if next else ways.MovePrevious
        to = self.moveCursor(way, Qt.KeyboardModifier.NoModifier)
        here, there = ((at.row(), at.column()) for at in (self.currentIndex(), to))
        if there > here if next else there < here:
            return super().focusNextPrevChild(next)
        return QAbstractScrollArea.focusNextPrevChild(self, next)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        for key, method in _KEYS.items():
            if event.matches(key):
                getattr(self, method)()
                return
        if event.key() == Qt.Key.Key_Backspace:
            self.clear_cells()
            return
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
                self.go()
            elif self.currentIndex().flags() & Qt.ItemFlag.ItemIsEditable:
                self.edit(self.currentIndex())
            else:
                self.go()
            return
        super().keyPressEvent(event)

    def inputMethodEvent(self, event: QInputMethodEvent) -> None:
        # What is written without being composed first begins a cell too: Qt would drop it.
        index = self.currentIndex()
        begins = bool(event.commitString()) and self.state() == self.State.NoState
        if not begins or not index.flags() & Qt.ItemFlag.ItemIsEditable:
            super().inputMethodEvent(event)
            return
        self.edit(index)
        QCoreApplication.sendEvent(self.indexWidget(index), event)

    def _went(self, key: Qt.Key, shift: bool) -> None:
        """Enter goes down, Tab to the right, with Shift back."""
        by = -1 if key == Qt.Key.Key_Backtab or shift else 1
        index = self.currentIndex()
        down = key in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        row, column = index.row() + (by if down else 0), index.column() + (0 if down else by)
        wanted = self.texts.index(row, column)
        if wanted.isValid():
            self.setCurrentIndex(wanted)
        self.setFocus()

    def select(self, file: str, place: tuple[str, ...], language: str | None) -> None:
        """Makes the cell of a text current, if it is shown."""
        row = self.texts.row_at(file, place)
        if row >= 0:
            languages = self.texts.languages
            step = languages.index(language) + 1 if language in languages else 0
            self.setCurrentIndex(self.texts.index(row, WRITTEN + step))

    # -- as in a spreadsheet -----------------------------------------------------

    def copy(self) -> None:
        """Copies the selected cells, for a spreadsheet too."""
        chosen = sorted(self.selectedIndexes(), key=lambda one: (one.row(), one.column()))
        if not chosen:
            return
        lines: dict[int, list[str]] = {}
        for one in chosen:
            lines.setdefault(one.row(), []).append(str(one.data()))
        if len(chosen) == 1:
            QApplication.clipboard().setText(str(chosen[0].data()))
        else:
            clipboard.put(list(lines.values()))

    def cut(self) -> None:
        """Copies the selected cells and empties them."""
        self.copy()
        self.clear_cells()

    def clear_cells(self) -> None:
        """Takes the selected translations away."""
        self._type([(one, "") for one in self.selectedIndexes()])

    def paste(self) -> None:
        """Fills the cells from the current one on; one cell fills all that are selected."""
        cells = clipboard.cells()
        chosen = sorted(self.selectedIndexes(), key=lambda one: (one.row(), one.column()))
        if not cells or not chosen:
            return
        if len(cells) == 1 == len(cells[0]):
            self._type([(one, cells[0][0]) for one in chosen])
            return
        first = chosen[0]
        typed = [
            (self.texts.index(first.row() + down, first.column() + across), text)
            for down, line in enumerate(cells)
            for across, text in enumerate(line)
        ]
        inside = [(index, text) for index, text in typed if index.isValid()]
        last = inside[-1][0].row(), inside[-1][0].column()
        self._type(inside)
        if len(inside) < len(typed):
            told = self.tr("{0} cells had no room in the table and were left out.")
            self.refused.emit(told.format(len(typed) - len(inside)))
        # What was typed may have made other rows.
        self.scrollTo(self.texts.index(*last))

    def _type(self, cells: list[tuple[QModelIndex, str]]) -> None:
        """Types into cells, those before the texts left out, as one step."""
        typed = []
        for index, text in cells:
            if index.column() < WRITTEN or not index.flags() & Qt.ItemFlag.ItemIsEditable:
                continue
            cell = self.texts.cell(index)
            if cell is not None and cell.text != text.strip():
                language = self.texts.language(index.column())
                typed.append(Typed(index.data(ROW), language, text))
        if typed:
            self.texts.typed.emit(typed)
