"""A list of members in a form: rows that open, move and go.

By mouse: click opens, the grip drags, the cross removes. By keyboard: Enter,
Alt+Up and Alt+Down, Delete. The context menu has it all.
"""

from __future__ import annotations

from msgspec import Struct
from PySide6.QtCore import QEvent, QPoint, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QContextMenuEvent,
    QEnterEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QHBoxLayout,
    QMenu,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from situ_studio.assistive.heard_as import hear_as
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.focus_ring import paint_ring
from situ_studio.widgets.icon_widgets import Elided, IconButton, IconLabel
from situ_studio.widgets.layouts import clear, rule


class Row(Struct, frozen=True, kw_only=True):
    """What one row shows. under: lines below, each a pair of words; guard: a pill below."""

    icon: str
    tint: str = "text2"
    title: str
    detail: str = ""
    target: str = ""
    guard: str = ""
    under: tuple[tuple[str, str], ...] = ()
    mark: str = ""


class RowWidget(QFrame):
    """One row; takes the focus."""

    opened = Signal()
    removed = Signal()
    moved = Signal(int)
    dragged = Signal(QPoint)
    dropped = Signal(QPoint)

    def __init__(self, theme: Theme, row: Row, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "row")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        words = " ".join(w for w in (row.title, row.detail, row.target, row.guard) if w)
        self.setAccessibleName(words)
        hear_as(self, QAccessible.Role.Button, lambda row: row.opened.emit())
        self._press: QPoint | None = None
        self._dragging = False
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 7, 6, 7)
        column.setSpacing(4)
        line = QHBoxLayout()
        line.setSpacing(7)
        self._grip = IconLabel(theme, "grip", "text3", 14)
        line.addWidget(self._grip)
        line.addWidget(IconLabel(theme, row.icon, row.tint, 15))
        title = Elided(row.title, "rowtitle")
        title.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        line.addWidget(title)
        if row.detail or not row.target:
            line.addWidget(Elided(row.detail, "words"), 1)
        else:
            line.addStretch(1)
        if row.mark:
            line.addWidget(IconLabel(theme, row.mark, row.mark, 14))
        if row.target:
            line.addWidget(IconLabel(theme, "right", "text3", 12))
            target = Elided(row.target, "words")
            target.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
            target.setMinimumWidth(min(80, target.sizeHint().width()))
            line.addWidget(target)
        self._remove = IconButton(theme, "close", self.tr("Remove"), "text3", 12)
        self._remove.setFixedSize(px(18), px(18))
        self._remove.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._remove.clicked.connect(self.removed)
        # Over the end of the row, so that it takes no room while nobody points there.
        self._remove.setParent(self)
        self._remove.setProperty("role", "over")
        column.addLayout(line)
        if row.guard:
            column.addWidget(_guard(theme, row.guard))
        for name, value in row.under:
            under = QHBoxLayout()
            under.setContentsMargins(42, 0, 0, 0)
            under.setSpacing(8)
            label = Elided(name, "label")
            label.setFixedWidth(px(56))
            under.addWidget(label)
            under.addWidget(Elided(value, "under"), 1)
            column.addLayout(under)
        self._show_remove(False)

    def _show_remove(self, shown: bool) -> None:
        self._remove.setVisible(shown)
        self._remove.raise_()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._remove.move(self.width() - 24, 8)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.hasFocus():
            # Within the row, whose words stay where they are; its ground alone is too pale a sign.
            paint_ring(self)

    def enterEvent(self, event: QEnterEvent) -> None:
        self._show_remove(True)
        super().enterEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        self._show_remove(self.hasFocus())
        super().leaveEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self._show_remove(True)
        super().focusInEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._show_remove(self.underMouse())
        super().focusOutEvent(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._press = event.position().toPoint()
            self._dragging = False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._press is None:
            return
        at = event.position().toPoint()
        if (at - self._press).manhattanLength() >= QApplication.startDragDistance():
            self._dragging = True
        if self._dragging:
            self.dragged.emit(self.mapToParent(at))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._press is None or event.button() != Qt.MouseButton.LeftButton:
            return
        self._press = None
        at = event.position().toPoint()
        if self._dragging:
            self._dragging = False
            self.dropped.emit(self.mapToParent(at))
        elif self.rect().contains(at):
            self.opened.emit()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            alt = event.modifiers() & Qt.KeyboardModifier.AltModifier
            moves = alt and event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down)
            if moves or event.key() == Qt.Key.Key_Delete:
                # They mean this row here, not what the window's commands do with the selection.
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        alt = event.modifiers() & Qt.KeyboardModifier.AltModifier
        key = event.key()
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self.opened.emit()
        elif key == Qt.Key.Key_Delete:
            self.removed.emit()
        elif alt and key == Qt.Key.Key_Up:
            self.moved.emit(-1)
        elif alt and key == Qt.Key.Key_Down:
            self.moved.emit(1)
        elif key == Qt.Key.Key_Up:
            self.focusPreviousChild()
        elif key == Qt.Key.Key_Down:
            self.focusNextChild()
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        menu = QMenu(self)
        menu.addAction(self.tr("Open"), self.opened.emit)
        menu.addAction(self.tr("Move up"), lambda: self.moved.emit(-1))
        menu.addAction(self.tr("Move down"), lambda: self.moved.emit(1))
        menu.addSeparator()
        menu.addAction(self.tr("Remove"), self.removed.emit)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(event.globalPos())


def _guard(theme: Theme, words: str) -> QWidget:
    holder = QWidget()
    line = QHBoxLayout(holder)
    line.setContentsMargins(42, 0, 0, 2)
    line.setSpacing(0)
    pill = QFrame()
    pill.setProperty("role", "guard")
    pill.setStyleSheet(
        f"QFrame[role='guard'] {{ background: {theme.condition_soft}; border-radius: 4px; }}"
    )
    inner = QHBoxLayout(pill)
    inner.setContentsMargins(6, 1, 6, 1)
    inner.setSpacing(4)
    inner.addWidget(IconLabel(theme, "guard", "condition", 13))
    text = Elided(words, "pill")
    text.setProperty("pill", "condition")
    text.setSizePolicy(text.sizePolicy().Policy.Preferred, text.sizePolicy().Policy.Preferred)
    text.setStyleSheet("padding: 0;")
    inner.addWidget(text)
    line.addWidget(pill)
    line.addStretch(1)
    return holder


class RowList(QFrame):
    """The rows in a box. Numbers count from 0; ``moved`` says from where to where."""

    opened = Signal(int)
    removed = Signal(int)
    moved = Signal(int, int)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "box")
        self._theme = theme
        self._rows: tuple[Row, ...] | None = None
        self._widgets: list[RowWidget] = []
        self._drop_at: int | None = None
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(1, 1, 1, 1)
        self._layout.setSpacing(0)

    def show_rows(self, theme: Theme, rows: tuple[Row, ...]) -> None:
        """Shows these rows; the focus stays at its number."""
        if rows == self._rows and theme is self._theme:
            return
        focus = next((i for i, w in enumerate(self._widgets) if w.hasFocus()), None)
        self._theme, self._rows = theme, rows
        clear(self._layout)
        self._widgets = []
        for index, row in enumerate(rows):
            if index:
                self._layout.addWidget(rule())
            widget = RowWidget(theme, row, self)
            widget.opened.connect(lambda i=index: self.opened.emit(i))
            widget.removed.connect(lambda i=index: self.removed.emit(i))
            widget.moved.connect(lambda by, i=index: self._move(i, i + by))
            widget.dragged.connect(self._on_dragged)
            widget.dropped.connect(lambda at, i=index: self._on_dropped(i, at))
            self._layout.addWidget(widget)
            self._widgets.append(widget)
        self.setVisible(bool(rows))
        if focus is not None and self._widgets:
            self._widgets[min(focus, len(self._widgets) - 1)].setFocus()

    def row(self, index: int) -> RowWidget:
        """The widget of a row; tests click it."""
        return self._widgets[index]

    def _move(self, start: int, end: int) -> None:
        if 0 <= end < len(self._widgets) and end != start:
            self._widgets[end].setFocus()
            self.moved.emit(start, end)

    def _gap(self, at: QPoint) -> int:
        """The gap between rows (0: before the first) that is nearest to ``at``."""
        return sum(1 for w in self._widgets if at.y() > w.geometry().center().y())

    def _on_dragged(self, at: QPoint) -> None:
        self._drop_at = self._gap(at)
        self.update()

    def _on_dropped(self, start: int, at: QPoint) -> None:
        gap, self._drop_at = self._gap(at), None
        self.update()
        self._move(start, gap - 1 if gap > start else gap)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._drop_at is None or not self._widgets:
            return
        if self._drop_at < len(self._widgets):
            y = self._widgets[self._drop_at].geometry().top()
        else:
            y = self._widgets[-1].geometry().bottom()
        painter = QPainter(self)
        painter.setPen(QPen(self._theme.color("accent"), 2))
        painter.drawLine(4, y, self.width() - 4, y)
        painter.end()
