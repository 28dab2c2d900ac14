"""A list of the column beside the drawing: rows that are told when they are seen, and go on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import (
    QAbstractListModel,
    QEvent,
    QModelIndex,
    QPersistentModelIndex,
    QPoint,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QFocusEvent, QFontMetrics, QKeyEvent, QMouseEvent, QPainter, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from situ_studio import icons
from situ_studio.icon_widgets import IconButton
from situ_studio.language import tr
from situ_studio.letters import enlarged, px
from situ_studio.live.column_rows import ColumnRow
from situ_studio.theme import CAPTION, LABEL, Theme, face

AnyIndex = QModelIndex | QPersistentModelIndex

ROW = 26
EDGE = 12
SINCE = 40
"""Px that the time at the right end has."""
SHARE = 0.45
"""Of the room, what a long value gets in any case."""
MOST = 6
"""Rows for which a list wants room; of more it scrolls."""
_ICONS = {"state": "state", "resource": "resource"}
_IN_PILL = {"module": "module", "state": "state"}


class ColumnModel(QAbstractListModel):
    """Rows by their names; each is told when it is looked at."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.names: list[str] = []
        self._tell: Callable[[str], ColumnRow] | None = None
        self._told: dict[str, ColumnRow] = {}

    def show(self, names: Sequence[str], tell: Callable[[str], ColumnRow], seen: range) -> None:
        """Goes on to another moment. seen: places of the rows that are seen now; of those that are
        not, nothing is told before they are.
        """
        self._tell, before = tell, self._told
        if self.names != names:
            self.beginResetModel()
            self.names, self._told = list(names), {}
            self.endResetModel()
            return
        self._told = {}
        for place in seen:
            if place < len(self.names) and self.row(place) != before.get(self.names[place]):
                index = self.index(place)
                self.dataChanged.emit(index, index)

    def row(self, place: int) -> ColumnRow:
        name = self.names[place]
        told = self._told.get(name)
        if told is None:
            assert self._tell is not None
            told = self._told[name] = self._tell(name)
        return told

    def rowCount(self, parent: AnyIndex = QModelIndex()) -> int:
        return 0 if parent.isValid() else len(self.names)

    def data(self, index: AnyIndex, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if role == Qt.ItemDataRole.DisplayRole:
            return self.row(index.row()).title
        if role == Qt.ItemDataRole.ToolTipRole:
            return self.row(index.row()).tip
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return self.row(index.row()).spoken
        return None


class ColumnDelegate(QStyledItemDelegate):
    """Paints a row: a name at the left, what it is and since when at the right."""

    def __init__(self, theme: Theme, parent: QListView) -> None:
        super().__init__(parent)
        self.theme = theme
        self._size = QSize(px(80), px(ROW))
        # Many rows in each of 60 frames a second: what is the same in all of them is made once.
        self._plain, self._strong, self._small = face(LABEL), face(LABEL, 600), face(CAPTION)
        self._metrics = QFontMetrics(self._plain)
        self._strongs, self._smalls = QFontMetrics(self._strong), QFontMetrics(self._small)

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return self._size

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        model = index.model()
        assert isinstance(model, ColumnModel)
        with enlarged(painter, QRectF(option.rect)) as rect:
            self._ground(painter, rect, option.state, model.row(index.row()))
            self._row(painter, rect, model.row(index.row()))

    def _ground(
        self, painter: QPainter, rect: QRectF, state: QStyle.StateFlag, row: ColumnRow
    ) -> None:
        theme = self.theme
        chosen = state & QStyle.StateFlag.State_Selected and state & QStyle.StateFlag.State_HasFocus
        if chosen:
            painter.fillRect(rect, theme.color("accent_soft"))
            painter.fillRect(QRectF(rect.x(), rect.y(), 2, rect.height()), theme.color("accent"))
        elif row.lit:
            painter.fillRect(rect, theme.color("live_soft"))
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(rect, theme.color("hover"))

    def _row(self, painter: QPainter, rect: QRectF, row: ColumnRow) -> None:
        theme, middle = self.theme, Qt.AlignmentFlag.AlignVCenter
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        left, right = rect.x() + EDGE, rect.right() - EDGE
        sign = _ICONS.get(row.kind)
        if sign is not None:
            box = QRectF(left, rect.center().y() - 7, 14, 14)
            if row.stands:
                icons.paint(painter, "pause", box, theme.color("warning"))
            else:
                icons.paint(painter, sign, box, theme.color(row.kind))
            left += 22
        if row.since:
            painter.setFont(self._small)
            painter.setPen(theme.color("text3"))
            # Times stand below each other; a state has little room.
            wide = self._smalls.horizontalAdvance(row.since) + 8
            wide = max(wide, SINCE if row.kind == "data" else 0)
            place = QRectF(right - wide, rect.y(), wide, rect.height())
            painter.drawText(place, middle | Qt.AlignmentFlag.AlignRight, row.since)
            right -= wide
        metrics = self._metrics if row.faint or row.pill else self._strongs
        title, taken = self._metrics.horizontalAdvance(row.title), self._taken(row, metrics)
        room = right - left
        wanted = min(float(taken), max(room - title - 8, room * SHARE))
        box = QRectF(right - wanted, rect.y(), wanted, rect.height())
        painter.setFont(self._plain if row.faint or row.pill else self._strong)
        if row.pill:
            self._pill(painter, box, row)
        else:
            token = "text3" if row.faint else "live" if row.lit else "text"
            painter.setPen(theme.color(token))
            shown = row.value if taken <= wanted else _cut(metrics, row.value, wanted)
            painter.drawText(box, middle | Qt.AlignmentFlag.AlignRight, shown)
        painter.setFont(self._plain)
        painter.setPen(theme.color("text"))
        free = max(room - wanted - 8, 0)
        shown = row.title
        if title > free:
            shown = self._metrics.elidedText(row.title, Qt.TextElideMode.ElideMiddle, int(free))
        painter.drawText(QRectF(left, rect.y(), free + 1, rect.height()), middle, shown)
        if row.fresh:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(theme.color("live"))
            painter.drawEllipse(QRectF(rect.x() + 4, rect.center().y() - 2.5, 5, 5))

    def _taken(self, row: ColumnRow, metrics: QFontMetrics) -> int:
        """How wide what stands at the right is, with what a pill has beside its words."""
        words = metrics.horizontalAdvance(row.value)
        if not row.pill:
            return words
        icon = 17 if row.pill in _IN_PILL else 0
        after = metrics.horizontalAdvance(row.after) + 6 if row.after else 0
        return words + 14 + icon + after

    def _pill(self, painter: QPainter, box: QRectF, row: ColumnRow) -> None:
        theme, middle = self.theme, Qt.AlignmentFlag.AlignVCenter
        box = box.adjusted(0, 3, 0, -3)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.color(f"{row.pill}_soft"))
        painter.drawRoundedRect(box, 4, 4)
        inside = box.adjusted(7, 0, -7, 0)
        sign = _IN_PILL.get(row.pill)
        if sign is not None:
            place = QRectF(inside.left() - 1, inside.center().y() - 6.5, 13, 13)
            icons.paint(painter, sign, place, theme.color(row.pill))
            inside.setLeft(inside.left() + 17)
        painter.setPen(theme.color(row.pill))
        if row.after:
            painter.drawText(inside, middle | Qt.AlignmentFlag.AlignRight, row.after)
            inside.setRight(inside.right() - self._metrics.horizontalAdvance(row.after) - 6)
        painter.drawText(inside, middle, _cut(self._metrics, row.value, inside.width()))


def _cut(metrics: QFontMetrics, words: str, room: float) -> str:
    """What of that has room, ending with … where not all has."""
    return metrics.elidedText(words, Qt.TextElideMode.ElideRight, int(room) + 1)


class ColumnList(QListView):
    """Rows of one kind. A click, or Enter, goes to what a row is about; Why? has a button at the
    row under the hand or with the keyboard, and a menu.
    """

    chosen = Signal(str)
    """The row of that name, by a click or Enter."""
    why_asked = Signal(str)
    menu_asked = Signal(str, QPoint)
    """name, and where on the screen."""

    def __init__(self, theme: Theme, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self.rows = ColumnModel(self)
        self.setModel(self.rows)
        self._delegate = ColumnDelegate(theme, self)
        self.setItemDelegate(self._delegate)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.why = IconButton(theme, "why", tr("Why?"), "text2", 16, self.viewport())
        self.why.setFixedSize(px(22), px(22))
        self.why.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.why.setProperty("role", "over")
        self.why.hide()
        self._why_of = -1
        self.why.clicked.connect(self._ask)
        self.clicked.connect(lambda index: self.chosen.emit(self.rows.names[index.row()]))
        self.verticalScrollBar().valueChanged.connect(lambda _: self._place_why(-1))

    def set_theme(self, theme: Theme) -> None:
        self._delegate.theme = theme
        self.why.set_theme(theme)
        self.viewport().update()

    def show_rows(self, names: Sequence[str], tell: Callable[[str], ColumnRow]) -> None:
        """The same rows at another moment, or other ones; the chosen one stays so."""
        kept = self.current_name
        grown = len(names) != len(self.rows.names)
        other = self.rows.names != names
        self.rows.show(names, tell, self._seen())
        if other:
            self._place_why(-1)
            if kept is not None and kept in names:
                self.setCurrentIndex(self.rows.index(self.rows.names.index(kept)))
        if grown:
            self.updateGeometry()

    def _seen(self) -> range:
        first = self.indexAt(QPoint(1, 1)).row()
        if first < 0:
            return range(0)
        return range(first, first + self.viewport().height() // px(ROW) + 2)

    @property
    def current_name(self) -> str | None:
        """Of the row that has the keyboard."""
        index = self.currentIndex()
        return self.rows.names[index.row()] if index.isValid() else None

    # -- why ---------------------------------------------------------------------------

    def _place_why(self, row: int) -> None:
        """The button stands over the end of that row; -1: nowhere."""
        self._why_of = row
        if row < 0:
            self.why.hide()
            return
        rect = self.visualRect(self.rows.index(row))
        middle = rect.center().y() - self.why.height() // 2 + 1
        self.why.move(rect.right() - self.why.width() - px(6), middle)
        self.why.show()

    def _ask(self) -> None:
        if 0 <= self._why_of < len(self.rows.names):
            self.why_asked.emit(self.rows.names[self._why_of])

    def contextMenuEvent(self, event: Any) -> None:
        by_keys = event.reason() == event.Reason.Keyboard
        index = self.currentIndex() if by_keys else self.indexAt(event.pos())
        if not index.isValid():
            return
        self.setCurrentIndex(index)
        at = event.globalPos()
        if by_keys:
            at = self.viewport().mapToGlobal(self.visualRect(index).bottomLeft())
        self.menu_asked.emit(self.rows.names[index.row()], at)

    # -- hands and keys ----------------------------------------------------------------

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        row = self.indexAt(event.position().toPoint()).row()
        if row != self._why_of:
            self._place_why(row)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._place_why(self.currentIndex().row() if self.hasFocus() else -1)

    def currentChanged(self, current: AnyIndex, previous: AnyIndex) -> None:
        super().currentChanged(current, previous)
        if self.hasFocus():
            self._place_why(current.row())

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        by_keys = event.reason() != Qt.FocusReason.MouseFocusReason
        if by_keys and not self.currentIndex().isValid() and self.rows.names:
            self.setCurrentIndex(self.rows.index(0))
        # A hand that presses the button gives the list the focus, too.
        if by_keys:
            self._place_why(self.currentIndex().row())

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        if event.reason() != Qt.FocusReason.PopupFocusReason:
            self._place_why(-1)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_why(-1)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        name = self.current_name
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and name is not None:
            self.chosen.emit(name)
        else:
            super().keyPressEvent(event)

    # -- size --------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        return QSize(px(160), min(len(self.rows.names), MOST) * px(ROW) + px(6))

    def minimumSizeHint(self) -> QSize:
        return QSize(px(80), min(len(self.rows.names), 3) * px(ROW))
