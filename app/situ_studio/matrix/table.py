"""The table of priorities: a spreadsheet's keys, its range, and the handle that fills."""

from __future__ import annotations

from typing import Any, overload

from msgspec import Struct
from PySide6.QtCore import (
    QEvent,
    QItemSelection,
    QItemSelectionModel,
    QPoint,
    QRect,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QContextMenuEvent,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QPainter,
    QPaintEvent,
)
from PySide6.QtWidgets import QAbstractItemView, QTableView, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.matrix.cells import Cells, Sentence, outline
from situ_studio.matrix.headers import ModuleHeader, SituationHeader
from situ_studio.matrix.model import AnyIndex, MatrixModel

ROW = 28
HANDLE = 4
"""Px that the filling handle reaches from the corner of the range."""

_KEYS = {
    QKeySequence.StandardKey.Copy: "copy",
    QKeySequence.StandardKey.Cut: "cut",
    QKeySequence.StandardKey.Paste: "paste",
    QKeySequence.StandardKey.SelectAll: "select_all",
}
_CONTROL = {Qt.Key.Key_D: "fill_down", Qt.Key.Key_R: "fill_right"}
_PLAIN = {
    Qt.Key.Key_Delete: "clear",
    Qt.Key.Key_Backspace: "clear",
    Qt.Key.Key_F2: "edit",
}
_ALT = {Qt.Key.Key_Up: "move_up", Qt.Key.Key_Down: "move_down"}


class Area(Struct, frozen=True):
    """A rectangle of cells."""

    top: int
    left: int
    high: int = 1
    wide: int = 1

    @property
    def right(self) -> int:
        return self.left + self.wide - 1

    @property
    def bottom(self) -> int:
        return self.top + self.high - 1


class MatrixTable(QTableView):
    """Cells of ``shown`` columns of a model that other tables show too.

    asked: a command that its keys mean, by the name of the view's method. filled: the handle was
    dragged: the range before, and the larger one. left_by: an arrow wants to go on beside it.
    """

    asked = Signal(str)
    filled = Signal(object, object)
    left_by = Signal(int)
    menu_asked = Signal(QPoint)

    def __init__(self, theme: Theme, model: MatrixModel, name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._theme = theme
        self._model = model
        self._fill: Area | None = None
        self.setAccessibleName(name)
        self.cells = Cells(theme, model, self)
        self.setItemDelegate(self.cells)
        self.heads = ModuleHeader(theme, self)
        self.setHorizontalHeader(self.heads)
        self.rows = SituationHeader(theme, self)
        self.setVerticalHeader(self.rows)
        self.rows.setDefaultSectionSize(px(ROW))
        self.setModel(model)
        self.setWordWrap(False)
        self.setCornerButtonEnabled(False)
        self.setTabKeyNavigation(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.AnyKeyPressed
            | QAbstractItemView.EditTrigger.DoubleClicked
        )
        self.setMouseTracking(True)
        self.sentence = Sentence(self.viewport())
        self.sentence.set_theme(theme)
        self.cells.refused.connect(self._on_refused)
        self.cells.accepted.connect(self.sentence.hide)
        self.cells.moved.connect(self.step)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.cells.set_theme(theme)
        self.setStyleSheet(
            f"QTableView {{ gridline-color: {theme.line}; }}"
            f"QTableCornerButton::section {{ background: {theme.panel}; border: 0;"
            f" border-right: 1px solid {theme.line}; border-bottom: 1px solid {theme.line}; }}"
        )
        self.heads.set_theme(theme)
        self.rows.set_theme(theme)
        self.sentence.set_theme(theme)
        self.viewport().update()

    # -- the range ---------------------------------------------------------------------

    @property
    def area(self) -> Area | None:
        """The range that is selected, of modules only; None where none is."""
        chosen = self.selectionModel().selection()
        every = (chosen.at(one) for one in range(chosen.count()))
        ranges = [r for r in every if r.isValid() and r.left() < len(self._model.modules)]
        if not ranges:
            return None
        top, bottom = min(r.top() for r in ranges), max(r.bottom() for r in ranges)
        left, right = min(r.left() for r in ranges), max(r.right() for r in ranges)
        right = min(right, len(self._model.modules) - 1)
        return Area(top, left, bottom - top + 1, right - left + 1)

    def choose(self, area: Area, current: tuple[int, int] | None = None) -> None:
        """Selects a range; ``current`` is the cell that typing goes to, the corner unless given."""
        row, column = current if current is not None else (area.top, area.left)
        flag = QItemSelectionModel.SelectionFlag
        model, cell = self.selectionModel(), self._model.index(row, column)
        model.setCurrentIndex(cell, flag.NoUpdate)
        corner = self._model.index(area.bottom, area.right)
        model.select(
            QItemSelection(self._model.index(area.top, area.left), corner), flag.ClearAndSelect
        )
        self.scrollTo(cell)

    def step(self, across: int, down: int) -> bool:
        """The current cell goes on; round the end of the row across. False at the very end."""
        at = self.currentIndex()
        wide, high = len(self._model.modules), self._model.rowCount()
        if not at.isValid() or not wide or at.column() >= wide:
            return False
        row, column = at.row() + down, at.column() + across
        if not 0 <= column < wide:
            row, column = row + across, 0 if across > 0 else wide - 1
        if not 0 <= row < high:
            return False
        self.choose(Area(row, column))
        return True

    # -- keys ------------------------------------------------------------------------------

    def edit_current(self) -> None:
        index = self.currentIndex()
        if index.isValid():
            self.edit(index)

    @overload
    def edit(self, index: AnyIndex, /) -> None: ...
    @overload
    def edit(
        self, index: AnyIndex, trigger: QAbstractItemView.EditTrigger, event: QEvent, /
    ) -> bool: ...
    def edit(self, index: AnyIndex, /, *how: Any) -> bool | None:
        self.cells.by_typing = how[:1] == (QAbstractItemView.EditTrigger.AnyKeyPressed,)
        return super().edit(index, *how)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride:
            assert isinstance(event, QKeyEvent)
            if self._meant(event):
                # A spreadsheet's key, before the window's command of the same key.
                event.accept()
                return True
        return super().event(event)

    def _meant(self, event: QKeyEvent) -> str:
        for keys, name in _KEYS.items():
            if event.matches(keys):
                return name
        held = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        table = {
            Qt.KeyboardModifier.NoModifier: _PLAIN,
            Qt.KeyboardModifier.ControlModifier: _CONTROL,
            Qt.KeyboardModifier.AltModifier: _ALT,
        }.get(held, {})
        return table.get(Qt.Key(event.key()), "")

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self.state() == QAbstractItemView.State.EditingState:
            super().keyPressEvent(event)
            return
        meant, key = self._meant(event), event.key()
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if key == Qt.Key.Key_Escape and self._fill is not None:
            self._end_fill()
        elif meant:
            self.asked.emit(meant)
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.step(0, -1 if shift else 1)
        elif not shift and self._leaves(key):
            self.left_by.emit(1 if key == Qt.Key.Key_Right else -1)
        else:
            super().keyPressEvent(event)

    def _leaves(self, key: int) -> bool:
        """Whether an arrow leads out of the columns that are shown here."""
        ways = {Qt.Key.Key_Right: 1, Qt.Key.Key_Left: -1}
        way = ways.get(Qt.Key(key), 0)
        at = self.currentIndex()
        if not way or not at.isValid():
            return False
        there = at.siblingAtColumn(at.column() + way)
        return there.isValid() and self.isColumnHidden(there.column())

    def focusNextPrevChild(self, next: bool) -> bool:
        if self.isVisible() and self.step(1 if next else -1, 0):
            return True
        # Past the last cell the focus goes on to what stands beside.
        return super().focusNextPrevChild(next)

    # -- the mouse ------------------------------------------------------------------------

    def _corner(self) -> QRect | None:
        """Where the handle is that fills."""
        area = self.area
        if area is None or not self._model.modules or self.isColumnHidden(area.right):
            return None
        last = self.visualRect(self._model.index(area.bottom, area.right))
        at = last.bottomRight()
        return QRect(at.x() - HANDLE, at.y() - HANDLE, 2 * HANDLE, 2 * HANDLE)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        corner = self._corner()
        at = event.position().toPoint()
        if (
            event.button() == Qt.MouseButton.LeftButton
            and corner is not None
            and corner.adjusted(-2, -2, 2, 2).contains(at)
        ):
            self._fill = self.area
            return
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position().toPoint()
        if self._fill is not None:
            self._fill = self._reaching(at)
            self.viewport().update()
            return
        corner = self._corner()
        over = corner is not None and corner.contains(at)
        self.viewport().setCursor(
            Qt.CursorShape.CrossCursor if over else Qt.CursorShape.ArrowCursor
        )
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._fill is not None:
            area, to = self.area, self._fill
            self._end_fill()
            if area is not None and to != area:
                self.filled.emit(area, to)
            return
        super().mouseReleaseEvent(event)

    def _end_fill(self) -> None:
        self._fill = None
        self.viewport().update()

    def _reaching(self, at: QPoint) -> Area:
        """The range as the handle is dragged: longer or wider, whichever it is dragged further."""
        area = self.area
        assert area is not None
        row, column = self.rowAt(at.y()), self.columnAt(at.x())
        row = self._model.rowCount() - 1 if row < 0 and at.y() > 0 else row
        column = len(self._model.modules) - 1 if column < 0 and at.x() > 0 else column
        down = max(0, row - area.bottom)
        across = max(0, min(column, len(self._model.modules) - 1) - area.right)
        if down >= across:
            return Area(area.top, area.left, area.high + down, area.wide)
        return Area(area.top, area.left, area.high, area.wide + across)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        self.menu_asked.emit(event.globalPos())

    # -- painting ----------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        area = self.area
        if area is None or self.isColumnHidden(area.left):
            return
        painter = QPainter(self.viewport())
        outline(painter, self._rect(area), self._theme)
        if self._fill is not None and self._fill != area:
            outline(painter, self._rect(self._fill), self._theme, dashed=True)
        corner = self._corner()
        if corner is not None and self.state() != QAbstractItemView.State.EditingState:
            painter.setPen(self._theme.color("panel"))
            painter.setBrush(self._theme.color("accent"))
            painter.drawRect(corner.adjusted(0, 0, -1, -1))
        painter.end()

    def _rect(self, area: Area) -> QRect:
        first = self.visualRect(self._model.index(area.top, area.left))
        last = self.visualRect(self._model.index(area.bottom, area.right))
        return first.united(last).adjusted(0, 0, -1, -1)

    def _on_refused(self, editor: QWidget, text: str) -> None:
        self.sentence.say(editor.geometry(), text)

    def selectionChanged(self, selected: QItemSelection, deselected: QItemSelection) -> None:
        super().selectionChanged(selected, deselected)
        # The frame reaches over its cells' edges.
        self.viewport().update()
