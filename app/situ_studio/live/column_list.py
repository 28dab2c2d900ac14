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
    QPointF,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import (
    QAccessible,
    QColor,
    QFocusEvent,
    QFontMetrics,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QRegion,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QFrame,
    QListView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from situ_studio.live.column_rows import ColumnRow
from situ_studio.live.column_words import Lettering
from situ_studio.looks import icons
from situ_studio.looks.letters import enlarged, px
from situ_studio.looks.theme import CAPTION, LABEL, Theme
from situ_studio.widgets.focus_ring import paint_chosen
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.wording.language import tr

AnyIndex = QModelIndex | QPersistentModelIndex

ROW = 26
EDGE = 12
SINCE = 40
"""Px that the time at the right end has."""
SHARE = 0.4
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
            return self.row(index.row()).whole_tip
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return self.row(index.row()).spoken
        return None


class ColumnDelegate(QStyledItemDelegate):
    """Paints a row: a name at the left, what it is and since when at the right."""

    def __init__(self, theme: Theme, parent: QListView) -> None:
        super().__init__(parent)
        self.theme = theme
        self._size = QSize(px(80), px(ROW))
        self.region = QRegion()
        """Of the list, what is to be painted: the view asks for each row between two of them."""
        # Many rows in each of many frames a second: what is the same in all of them is made once.
        self._plain, self._strong = Lettering(LABEL), Lettering(LABEL, 600)
        self._small = Lettering(CAPTION)

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return self._size

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        if not self.region.intersects(option.rect):
            return
        model = index.model()
        assert isinstance(model, ColumnModel)
        row = model.row(index.row())
        with enlarged(painter, QRectF(option.rect)) as rect:
            self._ground(painter, rect, option.state, row)
            self._row(painter, rect, row)

    def _ground(
        self, painter: QPainter, rect: QRectF, state: QStyle.StateFlag, row: ColumnRow
    ) -> None:
        theme = self.theme
        chosen = state & QStyle.StateFlag.State_Selected and state & QStyle.StateFlag.State_HasFocus
        if chosen:
            paint_chosen(painter, rect, theme)
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
            shown, token = ("pause", "warning") if row.stands else (sign, row.kind)
            _icon(painter, shown, QPointF(left, rect.center().y() - 7), 14, theme.color(token))
            left += 22
        said = self._plain if row.faint or row.pill else self._strong
        title, taken = self._plain.advance(row.title), self._taken(row, said)
        if row.since:
            # Times stand below each other; a state has little room, and its name goes before.
            wide = self._small.advance(row.since) + 8
            free = right - left - title - 8 - taken
            if row.kind == "data" or free >= wide:
                self._small.draw(painter, row.since, right, rect, theme.color("text3"), ends=True)
                # So do values, unless they would be cut for it.
                right -= SINCE if row.kind == "data" and wide < SINCE <= free else wide
        room = right - left
        wanted = min(float(taken), max(room - title - 8, room * SHARE))
        shown = row.title
        if title > room - wanted - 8:
            # Whole letters leave some px, which the value gets.
            most = int(max(room - wanted - 8, 0))
            shown = self._plain.metrics.elidedText(row.title, Qt.TextElideMode.ElideMiddle, most)
            wanted = min(float(taken), room - self._plain.advance(shown) - 8)
        self._plain.draw(painter, shown, left, rect, theme.color("text"))
        box = QRectF(right - wanted, rect.y(), wanted, rect.height())
        painter.setFont(said.font)
        if row.pill:
            self._pill(painter, box, row)
        else:
            token = "text3" if row.faint else "live" if row.lit else "text"
            painter.setPen(theme.color(token))
            value = row.value if taken <= wanted else _cut(said.metrics, row.value, wanted)
            painter.drawText(box, middle | Qt.AlignmentFlag.AlignRight, value)
        if row.fresh:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(theme.color("live"))
            painter.drawEllipse(QRectF(rect.x() + 4, rect.center().y() - 2.5, 5, 5))

    def _taken(self, row: ColumnRow, said: Lettering) -> int:
        """How wide what stands at the right is, with what a pill has beside its words."""
        words = said.advance(row.value)
        if not row.pill:
            return words
        icon = 17 if row.pill in _IN_PILL else 0
        after = said.advance(row.after) + 6 if row.after else 0
        return words + 14 + icon + after

    def _pill(self, painter: QPainter, box: QRectF, row: ColumnRow) -> None:
        theme, said = self.theme, self._plain
        box = box.adjusted(0, 3, 0, -3)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.color(f"{row.pill}_soft"))
        painter.drawRoundedRect(box, 4, 4)
        inside = box.adjusted(7, 0, -7, 0)
        sign = _IN_PILL.get(row.pill)
        if sign is not None:
            corner = QPointF(inside.left() - 1, inside.center().y() - 6.5)
            _icon(painter, sign, corner, 13, theme.color(row.pill))
            inside.setLeft(inside.left() + 17)
        color = theme.color(row.pill)
        if row.after:
            said.draw(painter, row.after, inside.right(), inside, color, ends=True)
            inside.setRight(inside.right() - said.advance(row.after) - 6)
        shown = row.value
        if said.advance(shown) > inside.width():
            shown = _cut(said.metrics, shown, inside.width())
        said.draw(painter, shown, inside.left(), inside, color)


def _icon(painter: QPainter, name: str, corner: QPointF, size: int, color: QColor) -> None:
    """From a picture, on whole px of the screen: to draw its lines anew takes longer than a row."""
    screen = painter.deviceTransform()
    inverted, _ = screen.inverted()
    sharp = inverted.map(QPointF(screen.map(corner).toPoint()))
    painter.drawPixmap(sharp, icons.pixmap(name, color, size, screen.m11()))


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
        first = self.verticalScrollBar().value() // px(ROW)
        return range(first, first + self.viewport().height() // px(ROW) + 2)

    def dataChanged(self, first: AnyIndex, last: AnyIndex, roles: Sequence[int] = ()) -> None:
        # All rows are as high as they were: Qt would lay out the whole list, and draw all of it.
        if QAccessible.isActive():
            super().dataChanged(first, last, roles)
        else:
            self.update(first)

    def paintEvent(self, event: QPaintEvent) -> None:
        self._delegate.region = event.region()
        super().paintEvent(event)

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
