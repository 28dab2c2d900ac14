"""Problems: a row each with its mark, its place and plain words; a click goes there."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QPainter, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import (
    QLabel,
    QListView,
    QStackedLayout,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from situ.document.problem import Problem
from situ_studio import icons
from situ_studio.panels.lists import PLACE, AnyIndex
from situ_studio.theme import Theme, font

PROBLEM = PLACE
WHERE = PLACE + 10


class ProblemDelegate(QStyledItemDelegate):
    """28 px: mark, place (128 px), words."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return QSize(200, 28)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        theme = self._theme
        rect = QRectF(option.rect)
        state = option.state
        problem: Problem = index.data(PROBLEM)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if state & QStyle.StateFlag.State_Selected:
            painter.fillRect(rect, theme.color("accent_soft"))
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(rect, theme.color("hover"))
        box = QRectF(rect.x() + 12, rect.center().y() - 7.5, 15, 15)
        icons.paint(painter, problem.severity, box, theme.color(problem.severity))
        painter.setFont(font(13))
        painter.setPen(theme.color("text2"))
        where = QRectF(rect.x() + 36, rect.y(), 168, rect.height())
        middle = int(Qt.AlignmentFlag.AlignVCenter)
        cut = painter.fontMetrics().elidedText
        right = Qt.TextElideMode.ElideRight
        painter.drawText(where, middle, cut(index.data(WHERE), right, int(where.width())))
        painter.setPen(theme.color("text"))
        words = QRectF(where.right() + 8, rect.y(), rect.right() - where.right() - 20, 28)
        painter.drawText(words, middle, cut(problem.message, right, int(words.width())))
        painter.restore()


class Problems(QWidget):
    """Tells the problem that a person chose."""

    chosen = Signal(object)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._stack = QStackedLayout(self)
        self.list = QListView()
        self.list.setAccessibleName(self.tr("Problems"))
        self.list.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self.list.setMouseTracking(True)
        self._delegate = ProblemDelegate(theme, self.list)
        self.list.setItemDelegate(self._delegate)
        self._model = QStandardItemModel(self)
        self.list.setModel(self._model)
        self.list.clicked.connect(self._on_chosen)
        self.list.activated.connect(self._on_chosen)
        good = QWidget()
        column = QVBoxLayout(good)
        column.setContentsMargins(16, 10, 16, 10)
        self.good = QLabel(self.tr("No problems."))
        self.good.setProperty("role", "dim")
        column.addWidget(self.good)
        column.addStretch(1)
        self._stack.addWidget(self.list)
        self._stack.addWidget(good)

    def set_theme(self, theme: Theme) -> None:
        self._delegate.set_theme(theme)
        self.list.viewport().update()

    def show_problems(self, problems: list[tuple[Problem, str]]) -> None:
        """Each problem with its place in words; errors stand first."""
        problems = sorted(problems, key=lambda pair: pair[0].severity != "error")
        current = self.list.currentIndex().data(PROBLEM)
        self._model.clear()
        for problem, where in problems:
            item = QStandardItem(problem.message)
            item.setData(problem, PROBLEM)
            item.setData(where, WHERE)
            item.setToolTip(problem.message)
            item.setAccessibleText(f"{problem.severity}: {where}: {problem.message}")
            self._model.appendRow(item)
            if problem == current:
                self.list.setCurrentIndex(item.index())
        self._stack.setCurrentIndex(0 if problems else 1)

    def _on_chosen(self, index: QModelIndex) -> None:
        self.chosen.emit(index.data(PROBLEM))
