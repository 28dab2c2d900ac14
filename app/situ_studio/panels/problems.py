"""Problems: a row each with its mark, its place and plain words; a click goes there.

Where there is a mend it stands at the right end of the row: a click, or Ctrl+Enter, does it.
Of many warnings of one kind the first few are shown, so that they hide no others, and a row that
shows the rest.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from PySide6.QtCore import QModelIndex, QPoint, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QFontMetrics,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPen,
    QStandardItem,
    QStandardItemModel,
    QTextLayout,
)
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
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme, font
from situ_studio.panels.lists import PLACE, AnyIndex
from situ_studio.widgets.focus_ring import paint_chosen
from situ_studio.wording.language import said

PROBLEM = PLACE
WHERE = PLACE + 10
MORE = PLACE + 11
"""The code of the warnings that a row shows or hides."""


MANY, FEW = 8, 3
"""Of more than so many warnings of one code, so many are shown."""
PLACE_MOST = 160
"""Px of width that the words of a place get at most."""
LINE = 18
"""Px from one line of a problem's words to the next."""
MEND_MOST = 280
"""Px of width that a mend's words get at most."""


def mend_box(rect: QRect, problem: Problem | None) -> QRect:
    """Where the mend's button stands in a row; empty where there is none."""
    if problem is None or problem.mend is None:
        return QRect()
    width = QFontMetrics(font(12, 500)).horizontalAdvance(said(problem.mend.words)) + px(40)
    width = min(width, px(MEND_MOST), rect.width() // 2)
    return QRect(rect.right() - width - px(8), rect.y() + px(3), width, px(22))


def lines(words: str, width: int) -> tuple[str, ...]:
    """Words in at most two lines of that width: how it is mended stands at their end."""
    measure = QFontMetrics(font(13))
    if measure.horizontalAdvance(words) <= width:
        return (words,)
    layout = QTextLayout(words, font(13))
    layout.beginLayout()
    line = layout.createLine()
    line.setLineWidth(max(1, width))
    layout.endLayout()
    first, rest = words[: line.textLength()].rstrip(), words[line.textLength() :]
    return (first, measure.elidedText(rest, Qt.TextElideMode.ElideRight, width))


class ProblemDelegate(QStyledItemDelegate):
    """28 px: mark, place, words, and the mend's button; a second line where the words need it."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self.place_width = 0
        """Px that the places take."""

    def fit(self, places: Iterable[str]) -> None:
        """As wide as the longest place, up to ``PLACE_MOST``: the words get what is left.

        No narrower than before while there are problems: the words do not jump.
        """
        measure = QFontMetrics(font(13)).horizontalAdvance
        widths = [min(measure(one), px(PLACE_MOST)) + px(8) for one in set(places)]
        self.place_width = max([self.place_width, *widths]) if widths else 0

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        view = self.parent()
        assert isinstance(view, QListView)
        row = QRect(0, 0, view.viewport().width(), px(28))
        problem: Problem | None = index.data(PROBLEM)
        many = 1
        if problem is not None:
            many = len(lines(said(problem.message), self._room(row, problem).width()))
        return QSize(px(200), px(28) + (many - 1) * px(LINE))

    def _room(self, rect: QRect, problem: Problem) -> QRect:
        """Where the words stand in a row, in their first line."""
        button = mend_box(rect, problem)
        end = button.x() if button.width() else rect.right()
        begin = rect.x() + px(36) + self.place_width + px(8)
        return QRect(begin, rect.y(), max(0, end - begin - px(12)), px(28))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        theme = self._theme
        rect = QRectF(option.rect)
        state = option.state
        problem: Problem | None = index.data(PROBLEM)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if state & QStyle.StateFlag.State_Selected:
            paint_chosen(painter, rect, theme)
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(rect, theme.color("hover"))
        first = QRectF(rect.x(), rect.y(), rect.width(), px(28))
        high = px(15)
        box = QRectF(rect.x() + px(12), first.center().y() - high / 2, high, high)
        if problem is None:
            painter.setFont(font(12, 500))
            painter.setPen(theme.color("accent"))
            room = rect.adjusted(px(36), 0, 0, 0)
            painter.drawText(room, int(Qt.AlignmentFlag.AlignVCenter), index.data())
            painter.restore()
            return
        icons.paint(painter, problem.severity, box, theme.color(problem.severity))
        painter.setFont(font(13))
        painter.setPen(theme.color("text2"))
        where = QRectF(first.x() + px(36), first.y(), self.place_width, first.height())
        middle = int(Qt.AlignmentFlag.AlignVCenter)
        cut = painter.fontMetrics().elidedText
        right = Qt.TextElideMode.ElideRight
        painter.drawText(where, middle, cut(index.data(WHERE), right, int(where.width())))
        painter.setPen(theme.color("text"))
        button = QRectF(mend_box(option.rect, problem))
        words = self._room(option.rect, problem)
        for line in lines(said(problem.message), words.width()):
            painter.drawText(words, middle, line)
            words.translate(0, px(LINE))
        if problem.mend is not None:
            painter.setPen(QPen(theme.color("line_strong")))
            painter.setBrush(theme.color("panel"))
            painter.drawRoundedRect(button.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6)
            accent = theme.color("accent")
            high = px(14)
            wand = QRectF(button.x() + px(9), button.center().y() - high / 2, high, high)
            icons.paint(painter, "wand", wand, accent)
            painter.setPen(accent)
            painter.setFont(font(12, 500))
            room = button.adjusted(px(28), 0, -px(10), 0)
            mend = said(problem.mend.words)
            text = painter.fontMetrics().elidedText(mend, right, int(room.width()))
            painter.drawText(room, middle, text)
        painter.restore()


class ProblemList(QListView):
    """Tells which row's mend was asked for, or its menu."""

    mend_asked = Signal(object)
    menu_asked = Signal(object, QPoint)
    """A context menu is wanted of a problem, there on the desktop."""

    def _mend_at(self, event: QMouseEvent) -> Problem | None:
        at = event.position().toPoint()
        index = self.indexAt(at)
        problem: Problem | None = index.data(PROBLEM)
        if problem is None or not mend_box(self.visualRect(index), problem).contains(at):
            return None
        return problem

    def mousePressEvent(self, event: QMouseEvent) -> None:
        # A press on the button does not choose the row.
        if self._mend_at(event) is None:
            super().mousePressEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        problem = self._mend_at(event)
        if problem is None:
            super().mouseReleaseEvent(event)
        elif event.button() == Qt.MouseButton.LeftButton:
            self.mend_asked.emit(problem)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        hand = self._mend_at(event) is not None
        shape = Qt.CursorShape.PointingHandCursor if hand else Qt.CursorShape.ArrowCursor
        self.viewport().setCursor(shape)
        super().mouseMoveEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        index = self.indexAt(event.pos())
        problem: Problem | None = index.data(PROBLEM)
        if problem is not None:
            self.setCurrentIndex(index)
            self.menu_asked.emit(problem, event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        held = event.modifiers() & Qt.KeyboardModifier.ControlModifier
        problem: Problem | None = self.currentIndex().data(PROBLEM)
        enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        if held and enter and problem is not None and problem.mend is not None:
            self.mend_asked.emit(problem)
        else:
            super().keyPressEvent(event)


class Problems(QWidget):
    """Tells the problem that a person chose, or wants mended."""

    chosen = Signal(object)
    mend_asked = Signal(object)
    menu_asked = Signal(object, QPoint)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._stack = QStackedLayout(self)
        self.list = ProblemList()
        self.list.mend_asked.connect(self.mend_asked)
        self.list.menu_asked.connect(self.menu_asked)
        self.list.setAccessibleName(self.tr("Problems"))
        self.list.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self.list.setMouseTracking(True)
        self.list.setResizeMode(QListView.ResizeMode.Adjust)
        self._delegate = ProblemDelegate(theme, self.list)
        self.list.setItemDelegate(self._delegate)
        self._shown: list[tuple[Problem, str]] = []
        self._opened: set[str] = set()
        self._model = QStandardItemModel(0, 1, self)
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
        self._stack.setCurrentIndex(1)

    def set_theme(self, theme: Theme) -> None:
        self._delegate.set_theme(theme)
        self.list.viewport().update()

    def show_problems(self, problems: list[tuple[Problem, str]]) -> None:
        """Each problem with its place in words; errors stand first."""
        problems = sorted(problems, key=lambda pair: pair[0].severity != "error")
        if problems != self._shown:
            self._shown = problems
            self._fill()

    def _fill(self) -> None:
        rows = self._rows()
        self._delegate.fit(where for problem, where in rows if problem is not None)
        current = self.list.currentIndex().data(PROBLEM)
        # What is below the last one goes, the others change in place: the list stays where it is.
        there = self._model.rowCount()
        self._model.setRowCount(len(rows))
        self.list.setCurrentIndex(QModelIndex())
        for row, (problem, where) in enumerate(rows):
            if row >= there:
                self._model.setItem(row, QStandardItem())
            item = self._model.item(row)
            item.setData(None if problem is not None else where, MORE)
            if problem is None:
                self._tell_more(item, where)
                continue
            message = said(problem.message)
            item.setText(message)
            item.setData(problem, PROBLEM)
            item.setData(where, WHERE)
            mend = ""
            if problem.mend is not None:
                mend = self.tr("Ctrl+Enter: {0}").format(said(problem.mend.words))
            item.setToolTip(f"{message}\n{mend}".strip())
            kind = self.tr("Error") if problem.severity == "error" else self.tr("Warning")
            item.setAccessibleText(f"{kind}: {where}: {message} {mend}".strip())
            if problem == current:
                self.list.setCurrentIndex(item.index())
        self._stack.setCurrentIndex(0 if rows else 1)

    def _rows(self) -> list[tuple[Problem | None, str]]:
        """What the rows show: a problem and where it is, or none and the code of more of them."""
        counts = Counter(p.code for p, _ in self._shown if p.severity == "warning")
        found: list[tuple[Problem | None, str]] = []
        for problem, where in self._shown:
            if problem.severity == "error" or counts[problem.code] <= MANY:
                found.append((problem, where))
        for code in [code for code, count in counts.items() if count > MANY]:
            alike = [pair for pair in self._shown if pair[0].code == code]
            found += [pair for pair in alike if pair[0].severity == "warning"][
                : None if code in self._opened else FEW
            ]
            found.append((None, code))
        return found

    def _tell_more(self, item: QStandardItem, code: str) -> None:
        """The row that shows the other warnings of a code, or hides them again."""
        count = sum(p.code == code and p.severity == "warning" for p, _ in self._shown)
        words = self.tr("Show {0} more like these").format(count - FEW)
        if code in self._opened:
            words = self.tr("Show only {0} of these {1}").format(FEW, count)
        for role in (PROBLEM, WHERE):
            item.setData(None, role)
        item.setText(words)
        item.setToolTip("")
        item.setAccessibleText(words)

    def step(self, by: int) -> None:
        """Chooses the next problem that is shown, round the end."""
        every = range(self._model.rowCount())
        rows = [row for row in every if self._model.index(row, 0).data(MORE) is None]
        if rows:
            here = self.list.currentIndex().row()
            after = [row for row in rows if row > here]
            before = [row for row in rows if 0 <= row < here]
            row = (after or rows)[0] if by > 0 else (before or rows)[-1]
            self.list.setCurrentIndex(self._model.index(row, 0))
            self._on_chosen(self._model.index(row, 0))

    def _on_chosen(self, index: QModelIndex) -> None:
        code = index.data(MORE)
        if code is None:
            self.chosen.emit(index.data(PROBLEM))
            return
        self._opened ^= {code}
        self._fill()
        self.list.setCurrentIndex(self._model.index(min(index.row(), len(self._rows()) - 1), 0))
