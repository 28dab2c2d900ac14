"""Find in the whole project: a field, below it every place in plain words; Enter goes there."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QPainter, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from situ_studio.assistive.announcing import CurrentRow
from situ_studio.finding.search import Hit, Hits
from situ_studio.looks import icons
from situ_studio.looks.letters import enlarged, px
from situ_studio.looks.theme import Theme, face
from situ_studio.panels.empty import EmptyHint
from situ_studio.panels.lists import PLACE, AnyIndex
from situ_studio.widgets.focus_ring import paint_chosen

WHERE = 320
"""Px of width that a place has before its text."""


class _HitDelegate(QStyledItemDelegate):
    """26 px: icon, place, text, as in the list of problems."""

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self.theme = theme

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return QSize(px(200), px(26))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        with enlarged(painter, QRectF(option.rect)) as rect:
            self._paint(painter, rect, option.state, index.data(PLACE))

    def _paint(self, painter: QPainter, rect: QRectF, state: QStyle.StateFlag, hit: Hit) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if state & QStyle.StateFlag.State_Selected:
            paint_chosen(painter, rect, self.theme)
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(rect, self.theme.color("hover"))
        box = QRectF(rect.x() + 12, rect.center().y() - 7.5, 15, 15)
        icons.paint(painter, hit.icon, box, self.theme.color(hit.token))
        painter.setFont(face(13))
        middle, right = int(Qt.AlignmentFlag.AlignVCenter), Qt.TextElideMode.ElideRight
        where = QRectF(rect.x() + 36, rect.y(), min(WHERE, rect.width() / 2 - 36), rect.height())
        text = QRectF(where.right() + 12, rect.y(), rect.right() - where.right() - 20, 26)
        for area, words, token in ((where, hit.where, "text2"), (text, hit.text, "text")):
            painter.setPen(self.theme.color(token))
            shown = painter.fontMetrics().elidedText(words, right, int(area.width()))
            painter.drawText(area, middle, shown)


class Finding(QWidget):
    """Asks for what is typed, shows what was found, and tells which of it was chosen."""

    asked = Signal(str)
    chosen = Signal(object)
    """A ``Hit``."""
    left = Signal()

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        line = QHBoxLayout()
        line.setContentsMargins(12, 6, 12, 6)
        line.setSpacing(12)
        self.field = QLineEdit()
        self.field.setMaximumWidth(px(320))
        self.field.setClearButtonEnabled(True)
        self.field.setPlaceholderText(self.tr("States, texts, events, tags, notes"))
        self.field.setAccessibleName(self.tr("Find in the project"))
        self.field.setToolTip(self.tr("Finds every place in which a text or a name stands."))
        self.field.textChanged.connect(self.asked)
        self.field.installEventFilter(self)
        line.addWidget(self.field, 2)
        self.count = QLabel()
        self.count.setProperty("role", "dim")
        line.addWidget(self.count, 1)
        column.addLayout(line)
        self.list = QListView()
        self.list.setAccessibleName(self.tr("Found"))
        # One row at the least: the panel does not become higher because something is looked for.
        self.list.setMinimumHeight(px(26))
        self.list.setUniformItemSizes(True)
        self.list.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self._delegate = _HitDelegate(theme, self.list)
        self.list.setMouseTracking(True)
        self.list.setItemDelegate(self._delegate)
        self._model = QStandardItemModel(0, 1, self)
        self.list.setModel(self._model)
        self.current_row = CurrentRow(self.list)
        self.list.clicked.connect(lambda index: self.chosen.emit(index.data(PLACE)))
        self.list.activated.connect(lambda index: self.chosen.emit(index.data(PLACE)))
        self.list.installEventFilter(self)
        column.addWidget(self.list, 1)
        self.hint = EmptyHint(
            self.list,
            self.tr(
                "Write a word or a name: every place of the project in which it stands is listed "
                "here, and Enter goes there."
            ),
        )
        self.field.textChanged.connect(lambda text: self.hint.want(not text.strip()))

    def set_theme(self, theme: Theme) -> None:
        self._delegate.theme = theme
        self.list.viewport().update()

    @property
    def query(self) -> str:
        """What is looked for."""
        return self.field.text()

    def look_for(self, query: str) -> None:
        """Looks for this; as if it had been typed."""
        self.field.setText(query)
        self.field.setFocus()
        self.field.selectAll()

    def show_hits(self, found: Hits) -> None:
        """What was found; the row that was current stays so if it is still there."""
        current = self.list.currentIndex().data(PLACE)
        self._model.clear()
        row = 0
        for at, hit in enumerate(found.hits):
            item = QStandardItem(hit.text)
            item.setData(hit, PLACE)
            item.setToolTip(f"{hit.text}\n{hit.where}")
            item.setAccessibleText(f"{hit.text}, {hit.where}")
            self._model.appendRow(item)
            if hit == current:
                row = at
        if found.hits:
            self.list.setCurrentIndex(self._model.index(row, 0))
        self.count.setText(self._counted(found))

    def _counted(self, found: Hits) -> str:
        if not self.query.strip():
            return self.tr("F3 goes from one to the next")
        if found.count == 0:
            return self.tr("Nothing in this project has that.")
        if found.count > len(found.hits):
            shown = self.tr("{0} places, the first {1} are shown")
            return shown.format(found.count, len(found.hits))
        return self.tr("{0} places").format(found.count) if found.count > 1 else self.tr("1 place")

    @property
    def has_hits(self) -> bool:
        return self._model.rowCount() > 0

    def step(self, by: int) -> None:
        """Chooses the next row, round the end."""
        rows = self._model.rowCount()
        if rows:
            row = (self.list.currentIndex().row() + by) % rows
            self.list.setCurrentIndex(self._model.index(row, 0))
            self.chosen.emit(self._model.index(row, 0).data(PLACE))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() != QEvent.Type.KeyPress or not isinstance(event, QKeyEvent):
            return False
        key = event.key()
        if key == Qt.Key.Key_Escape:
            self.left.emit()
            return True
        if watched is not self.field:
            return False
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            index = self.list.currentIndex()
            if index.isValid():
                self.chosen.emit(index.data(PLACE))
            return True
        if key in (Qt.Key.Key_Down, Qt.Key.Key_Up):
            row = self.list.currentIndex().row() + (1 if key == Qt.Key.Key_Down else -1)
            if 0 <= row < self._model.rowCount():
                self.list.setCurrentIndex(self._model.index(row, 0))
            return True
        return False
