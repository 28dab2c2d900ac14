"""Pills that can be on or off, and the rows in which they stand."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import QAbstractButton, QScrollArea, QWidget

from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import LABEL, Theme, font

HIGH = 26
GAP = 6
CHECK = 12
ARROW = 18
"""Px at the right of a chip that open its choices."""


class Chip(QAbstractButton):
    """A pill: on or off, with a value behind its name. more: it has other values to choose from;
    folds: it shows and hides what stands below it.

    A click says ``clicked``; the arrow, the context menu and the down key ``menu_asked``.
    """

    menu_asked = Signal()

    def __init__(self, theme: Theme, name: str, more: bool = False, folds: bool = False) -> None:
        super().__init__()
        self._theme = theme
        self.name = name
        self._value = ""
        self._more, self._folds = more, folds
        self.setCheckable(True)
        self.setFont(font(LABEL))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAccessibleName(name)
        self.setToolTip(name)
        self._size = QSize()
        self._told: tuple[str, bool, str] | None = None

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def show_state(self, on: bool, value: str) -> None:
        """Whether it is on, and what stands behind its name."""
        told = self.name, on, value
        if told == self._told:
            return
        self._told = told
        self.setChecked(on)
        self._value = value
        self.setAccessibleName(f"{self.name}: {value}" if value else self.name)
        self._size = QSize()
        self.updateGeometry()
        self.update()

    @property
    def shown(self) -> str:
        """What is written on it."""
        return f"{self.name}: {self._value}" if self._value else self.name

    def sizeHint(self) -> QSize:
        if not self._size.isEmpty():
            return self._size
        wide = self.fontMetrics().horizontalAdvance(self.shown) + px(22)
        wide += px(CHECK + 5) if self.isChecked() and not self._folds else 0
        wide += px(ARROW - 6) if self._more or self._folds else 0
        self._size = QSize(min(wide, px(260)), px(HIGH))
        return self._size

    # -- being used ------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._more and event.position().x() > self.width() - px(ARROW):
            self.menu_asked.emit()
            return
        super().mousePressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        self.menu_asked.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Down:
            self.menu_asked.emit()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.click()
        else:
            super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        theme, on = self._theme, self.isChecked() and not self._folds
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        edge = theme.color("accent" if on or self.hasFocus() else "line_strong")
        painter.setPen(QPen(edge, 2 if self.hasFocus() else 1))
        ground = "accent_soft" if on else "hover" if self.underMouse() else "panel"
        painter.setBrush(theme.color(ground))
        inset = 1.0 if self.hasFocus() else 0.5
        area = QRectF(self.rect()).adjusted(inset, inset, -inset, -inset)
        painter.drawRoundedRect(area, area.height() / 2, area.height() / 2)
        left, middle = px(11), self.height() / 2
        check, arrow = px(CHECK), px(10)
        if on:
            spot = QRectF(left, middle - check / 2, check, check)
            icons.paint(painter, "check", spot, theme.color("accent"))
            left += check + px(5)
        right = self.width() - px(ARROW if self._more or self._folds else 10)
        painter.setPen(theme.color("accent" if on else "text2"))
        painter.setFont(self.font())
        text = painter.fontMetrics().elidedText(
            self.shown, Qt.TextElideMode.ElideRight, int(right - left) + 1
        )
        where = QRectF(left, 0, right - left + 2, self.height())
        painter.drawText(where, int(Qt.AlignmentFlag.AlignVCenter), text)
        if self._more or self._folds:
            spot = QRectF(self.width() - px(ARROW - 2), middle - arrow / 2, arrow, arrow)
            icon = "up" if self._folds and self.isChecked() else "down"
            icons.paint(painter, icon, spot, theme.color("accent" if on else "text3"))
        painter.end()


class Row(QWidget):
    """Widgets one behind the other, in as many lines as they need."""

    def __init__(self) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self._every: list[QWidget] = []

    def show_widgets(self, every: list[QWidget]) -> None:
        """Shows these; those that are there no more are deleted soon."""
        for old in self._every:
            if old not in every:
                old.hide()
                old.setParent(None)
                old.deleteLater()
        self._every = every
        for widget in every:
            if widget.parentWidget() is not self:
                widget.setParent(self)
                widget.show()
        self.place()

    @property
    def wide(self) -> int:
        """What one line of all of them would need."""
        return max(0, sum(w.sizeHint().width() + GAP for w in self._every) - GAP)

    def high(self, width: int) -> int:
        """How high it is at a width."""
        return self._laid(width, move=False)

    def place(self) -> None:
        self._laid(self.width(), move=True)
        self.updateGeometry()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.place()

    def _laid(self, width: int, move: bool) -> int:
        x = y = 0
        for widget in self._every:
            size = widget.sizeHint()
            if x and x + size.width() > width:
                x, y = 0, y + px(HIGH) + GAP
            if move:
                top = y + (px(HIGH) - size.height()) // 2
                widget.setGeometry(QRect(QPoint(x, top), size))
            x += size.width() + GAP
        return y + px(HIGH) if self._every else 0


class Rows(QScrollArea):
    """A ``Row`` that shows at most so many lines, and scrolls to the others."""

    def __init__(self, lines: int) -> None:
        super().__init__()
        self._lines = lines
        self.row = Row()
        self.setWidget(self.row)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def show_widgets(self, every: list[QWidget]) -> None:
        self.row.show_widgets(every)
        self.settle()

    def show_lines(self, most: int) -> None:
        """Shows at most so many lines from now on."""
        self._lines = most
        self.settle()

    def sizeHint(self) -> QSize:
        return QSize(self.row.wide + 2, self.height())

    def minimumSizeHint(self) -> QSize:
        return QSize(px(120), px(HIGH))

    def settle(self) -> None:
        """As high as its lines need, within bounds."""
        whole = self.row.high(self.width())
        self.row.setMinimumHeight(whole)
        self.updateGeometry()
        high = px(HIGH)
        self.setFixedHeight(max(high, min(whole, self._lines * (high + GAP) - GAP)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.settle()
