"""What lies on a screen, front to back: selected, and dragged into another order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QModelIndex, QPoint, QSize, Qt, Signal
from PySide6.QtGui import (
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QStandardItem,
    QStandardItemModel,
)
from PySide6.QtWidgets import QAbstractItemView, QApplication, QListView, QWidget

from situ.document import rbd
from situ.document.problem import Problem
from situ_studio import kinds
from situ_studio.looks.theme import Theme
from situ_studio.panels.lists import COUNT, ICON, MARKS, PLACE, RowDelegate
from situ_studio.screens.problem_marks import Told, spoken, told_words, worst

ROW = 24
NONE: Told = {}
BACKGROUND = ""
"""The id of the row of what is behind everything."""


class Layers(QListView):
    """One row a component, the foremost first, and one of the background."""

    chosen = Signal(tuple)
    """The ids that a person selected."""
    background_chosen = Signal()
    moved = Signal(str, int)
    """A component shall stand at another place: its id, and the number from the back."""
    opened = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("On this screen"))
        self._theme = theme
        self._model = QStandardItemModel(self)
        self._delegate = RowDelegate(theme, ROW, self)
        self.setModel(self._model)
        self.setItemDelegate(self._delegate)
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.selectionModel().selectionChanged.connect(self._on_selection)
        self.activated.connect(self._on_activated)
        self._rows: list[tuple[str, str, tuple[str, str], str, Sequence[Problem]]] = []
        """What each row says: text, id, icon, what stands at its end, and its problems."""
        self._showing = False
        self._pressed: QPoint | None = None
        self._gap: int | None = None

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self._delegate.set_theme(theme)
        self.viewport().update()

    @property
    def ids(self) -> list[str]:
        """Of the rows, front to back; the last one is the background's."""
        return [row[1] for row in self._rows]

    def show_screen(
        self, screen: rbd.Screen | None, selected: tuple[str, ...], told: Told = NONE
    ) -> None:
        """told: the problems by which rows are marked."""
        self._showing = True
        try:
            rows = [_row(one) for one in reversed(screen.components)] if screen is not None else []
            behind = (screen.background if screen is not None else None) or self.tr("none")
            rows.append((self.tr("Background"), BACKGROUND, ("lock", "text3"), behind))
            if self._model.rowCount() != len(rows):
                self._model.setRowCount(len(rows))
                for row in range(len(rows)):
                    if self._model.item(row) is None:
                        self._model.setItem(row, QStandardItem())
                self.updateGeometry()
            told_of = [(*row, told.get(row[1], ())) for row in rows]
            before, self._rows = self._rows, told_of
            for row, (text, id, icon, count, wrong) in enumerate(told_of):
                if row < len(before) and before[row] == told_of[row]:
                    continue
                item = self._model.item(row)
                for role, value in (
                    (int(Qt.ItemDataRole.DisplayRole), text),
                    (PLACE, id),
                    (ICON, icon),
                    (COUNT, count),
                    *_marked(text, wrong),
                ):
                    if item.data(role) != value:
                        item.setData(value, role)
            self._select(selected)
        finally:
            self._showing = False

    def _select(self, ids: tuple[str, ...]) -> None:
        chosen = self.selectionModel()
        wanted = {row for row, id in enumerate(self.ids) if id in ids}
        if {index.row() for index in chosen.selectedIndexes()} == wanted:
            return
        chosen.clearSelection()
        for row in sorted(wanted):
            chosen.select(self._model.index(row, 0), chosen.SelectionFlag.Select)
        if len(wanted) == 1:
            index = self._model.index(next(iter(wanted)), 0)
            chosen.setCurrentIndex(index, chosen.SelectionFlag.NoUpdate)
            self.scrollTo(index)

    def sizeHint(self) -> QSize:
        return QSize(160, ROW * max(2, self._model.rowCount()) + 2)

    def _on_selection(self) -> None:
        if not self._showing:
            rows = sorted({index.row() for index in self.selectedIndexes()})
            ids = tuple(self.ids[row] for row in reversed(rows) if self.ids[row] != BACKGROUND)
            if rows and not ids:
                self.background_chosen.emit()
            else:
                self.chosen.emit(ids)

    def _on_activated(self, index: QModelIndex) -> None:
        if id := index.data(PLACE):
            self.opened.emit(id)

    # -- another order -----------------------------------------------------------------

    def _count(self) -> int:
        """How many components there are."""
        return max(0, self._model.rowCount() - 1)

    def _move(self, row: int, to: int) -> None:
        """The component of a row shall be in another one; rows count from the front."""
        count = self._count()
        to = min(max(to, 0), count - 1)
        if 0 <= row < count and to != row:
            self.moved.emit(self.ids[row], count - 1 - to)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        at = event.position().toPoint()
        plain = event.modifiers() == Qt.KeyboardModifier.NoModifier
        row = self.indexAt(at).row()
        grips = event.button() == Qt.MouseButton.LeftButton and plain
        self._pressed = at if grips and 0 <= row < self._count() else None

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position().toPoint()
        if self._pressed is None:
            super().mouseMoveEvent(event)
            return
        far = (at - self._pressed).manhattanLength() >= QApplication.startDragDistance()
        if self._gap is not None or far:
            top = self.visualRect(self._model.index(0, 0)).top()
            self._gap = min(max(round((at.y() - top) / ROW), 0), self._count())
            self.viewport().update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        pressed, gap = self._pressed, self._gap
        self._pressed = self._gap = None
        self.viewport().update()
        if pressed is None or gap is None:
            super().mouseReleaseEvent(event)
            return
        row = self.indexAt(pressed).row()
        self._move(row, gap - 1 if gap > row else gap)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        ways = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}
        by = ways.get(Qt.Key(event.key()))
        if by is not None and event.modifiers() & Qt.KeyboardModifier.AltModifier:
            self._move(self.currentIndex().row(), self.currentIndex().row() + by)
        elif event.key() == Qt.Key.Key_Escape and self._gap is not None:
            self._pressed = self._gap = None
            self.viewport().update()
        elif event.key() in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            event.ignore()
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._gap is None:
            return
        y = self.visualRect(self._model.index(0, 0)).top() + self._gap * ROW
        painter = QPainter(self.viewport())
        painter.setPen(QPen(self._theme.color("accent"), 2))
        painter.drawLine(4, y, self.viewport().width() - 4, y)
        painter.end()


def _marked(text: str, problems: Sequence[Problem]) -> tuple[tuple[int, object], ...]:
    """A row's sign, its tip, and how it is heard."""
    token = worst(problems)
    return (
        (MARKS, ((token, token),) if token else ()),
        (int(Qt.ItemDataRole.ToolTipRole), told_words(problems)),
        (
            int(Qt.ItemDataRole.AccessibleTextRole),
            f"{text}, {spoken(problems)}" if token else text,
        ),
    )


def _row(component: rbd.Component) -> tuple[str, str, tuple[str, str], str]:
    kind: Any = kinds.kind_of(component)
    text = getattr(component, "text", "") or getattr(component, "src", "")
    shown = " ".join(text.split()) or kind.summary(component) or component.id
    return shown, component.id, (kind.icon, "text2"), component.id
