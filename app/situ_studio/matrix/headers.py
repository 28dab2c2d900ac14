"""The headers of the matrix: situations in precedence, which are dragged to another place, and
modules and resources.
"""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QPoint, QRect, QRectF, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QHeaderView, QWidget

from situ_studio.canvas.overlay import InPlace
from situ_studio.looks import icons
from situ_studio.looks.letters import factor, px
from situ_studio.looks.theme import BODY, CAPTION, LABEL, Theme, font
from situ_studio.matrix.model import SHOWN, Head

HIGH = 28
NAME, SIGN = 59, 15
"""Px: where the name of a situation begins, and what a sign behind it takes."""
GRIP = 22
"""Px at the left of a situation where it is dragged."""
SITUATION_WIDE, MODULE_WIDE = (132, 240), (74, 148)
"""How narrow and how wide headers are, in px."""
NARROW = 54
"""Px that a column keeps where there is little room."""


class _Header(QHeaderView):
    """What both share: another name is written where the old one stands."""

    renamed = Signal(int, str)

    def __init__(self, theme: Theme, way: Qt.Orientation, parent: QWidget) -> None:
        super().__init__(way, parent)
        self._theme = theme
        self._table = parent
        self.chosen: frozenset[int] = frozenset()
        self.editor: InPlace | None = None
        self.setSectionsClickable(True)
        self.setHighlightSections(False)
        self.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.sectionDoubleClicked.connect(self.edit_name)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.viewport().update()

    def head(self, section: int) -> Head | None:
        found = self.model().headerData(section, self.orientation(), int(SHOWN))
        return found if isinstance(found, Head) else None

    def area_of(self, section: int) -> QRect:
        at, size = self.sectionViewportPosition(section), self.sectionSize(section)
        if self.orientation() == Qt.Orientation.Vertical:
            return QRect(0, at, self.width(), size)
        return QRect(at, 0, size, self.height())

    def name_area(self, section: int) -> QRect:
        return self.area_of(section).adjusted(px(18), 1, -2, -2)

    def edit_name(self, section: int) -> None:
        head = self.head(section)
        if head is None:
            return
        if self.editor is not None:
            self.editor.close_editor()
        editor = InPlace(section, head.text, BODY * factor(), self.viewport())
        editor.setAccessibleName(self.tr("Name"))
        editor.dress(self._theme, 4)
        editor.finished.connect(self._on_name)
        self.editor = editor
        editor.open_at(self.name_area(section))

    def _on_name(self, section: int, name: str | None, _: int) -> None:
        self.editor = None
        self._table.setFocus()
        if name is not None:
            self.renamed.emit(section, name)

    def _icon(self, painter: QPainter, name: str, left: float, middle: float, size: int) -> None:
        token = name if name in ("warning", "error", "module", "situation", "resource") else "text3"
        size = px(size)
        spot = QRectF(left, middle - size / 2, size, size)
        icons.paint(painter, name, spot, self._theme.color(token))


class ModuleHeader(_Header):
    """An icon and the name of each column."""

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(theme, Qt.Orientation.Horizontal, parent)
        self.icons = True
        self.setFixedHeight(px(HIGH))
        self.setFont(font(CAPTION, 600))

    def wide(self, section: int) -> int:
        """The width that a column wants."""
        least, most = MODULE_WIDE
        return max(px(least), min(px(most), self.narrow(section) + px(17)))

    def narrow(self, section: int) -> int:
        """The width with which its name alone can be read, if it is not long."""
        head, metrics = self.head(section), self.fontMetrics()
        if head is None:
            return px(NARROW)
        name = metrics.horizontalAdvance(head.text) + px(15 + (17 if head.mark else 0))
        below = metrics.horizontalAdvance(head.below) + 4
        return max(px(NARROW), min(px(MODULE_WIDE[1]), max(name, below)))

    def settle(self, sections: Iterable[int]) -> None:
        """Icons stand before all names of these columns, or before none."""
        self.icons = all(self.sectionSize(one) >= self.narrow(one) + px(17) for one in sections)

    def paintSection(self, painter: QPainter, rect: QRect, section: int) -> None:
        head = self.head(section)
        if head is None or not rect.isValid():
            return
        theme = self._theme
        ground = "accent_soft" if section in self.chosen else "panel"
        painter.fillRect(rect, theme.color(ground))
        painter.setPen(theme.color("line"))
        painter.drawLine(rect.topRight(), rect.bottomRight())
        painter.drawLine(rect.bottomLeft(), rect.bottomRight())
        quiet = head.icon == "resource"
        painter.setFont(font(CAPTION, 500 if quiet else 600))
        metrics = painter.fontMetrics()
        room = rect.width() - px(10 + (17 if head.mark else 0))
        icon = px(17) if self.icons else 0
        text = metrics.elidedText(head.text, Qt.TextElideMode.ElideRight, room - icon)
        took = icon + metrics.horizontalAdvance(text) + px(17 if head.mark else 0)
        left = rect.left() + (rect.width() - took) / 2
        middle = rect.center().y() + 0.5
        if icon:
            self._icon(painter, head.icon, left, middle, 14)
        painter.setPen(theme.color("text2" if quiet else "text"))
        where = QRectF(left + icon, rect.top(), rect.width(), rect.height() - 1)
        painter.drawText(where, int(Qt.AlignmentFlag.AlignVCenter), text)
        if head.mark:
            self._icon(painter, head.mark, left + took - px(14), middle, 14)


class SituationHeader(_Header):
    """Grip, place in the precedence, icon and name of each row."""

    moved = Signal(int, int)
    """A row was dragged: from where, and to which place."""

    def __init__(self, theme: Theme, parent: QWidget) -> None:
        super().__init__(theme, Qt.Orientation.Vertical, parent)
        self._dragged: int | None = None
        self._to = 0
        self.setMouseTracking(True)

    def settle_width(self) -> None:
        """As wide as the names need, within bounds."""
        self.setFont(font(BODY, 500))
        metrics = self.fontMetrics()
        heads = [head for row in range(self.count()) if (head := self.head(row)) is not None]
        widest = max((metrics.horizontalAdvance(head.text) for head in heads), default=0)
        least, most = SITUATION_WIDE
        signs = 2 if any(head.mark for head in heads) else 1
        self.setFixedWidth(max(px(least), min(px(most), widest + px(NAME + signs * SIGN + 16))))

    def name_area(self, section: int) -> QRect:
        return self.area_of(section).adjusted(px(NAME - 2), 1, -2, -2)

    def paintSection(self, painter: QPainter, rect: QRect, section: int) -> None:
        head = self.head(section)
        if head is None or not rect.isValid():
            return
        theme = self._theme
        ground = "live_soft" if head.current else "panel"
        if section in self.chosen:
            ground = "accent_soft"
        painter.fillRect(rect, theme.color(ground))
        if head.current:
            painter.fillRect(QRect(rect.left(), rect.top(), 3, rect.height()), theme.color("live"))
        painter.setPen(theme.color("line"))
        painter.drawLine(rect.topRight(), rect.bottomRight())
        painter.drawLine(rect.bottomLeft(), rect.bottomRight())
        middle = rect.center().y() + 0.5
        self._icon(painter, "grip", rect.left() + px(6), middle, 14)
        painter.setFont(font(LABEL))
        painter.setPen(theme.color("text2"))
        number = QRectF(rect.left() + px(19), rect.top(), px(20), rect.height() - 1)
        painter.drawText(number, int(Qt.AlignmentFlag.AlignCenter), str(head.number))
        self._icon(painter, "situation", rect.left() + px(40), middle, 15)
        right = rect.right() - 6
        for icon in ("check" if head.holds else "", head.mark):
            if icon:
                right -= px(SIGN)
                self._icon(painter, icon, right, middle, 14)
        painter.setFont(font(BODY, 600 if head.current else 500))
        painter.setPen(theme.color("live" if head.current else "text"))
        left = rect.left() + px(NAME)
        text = painter.fontMetrics().elidedText(
            head.text, Qt.TextElideMode.ElideRight, int(right - left - 2)
        )
        where = QRectF(left, rect.top(), right - left, rect.height() - 1)
        painter.drawText(where, int(Qt.AlignmentFlag.AlignVCenter), text)

    # -- dragging ------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at = event.position().toPoint()
        row = self.logicalIndexAt(at)
        if event.button() == Qt.MouseButton.LeftButton and row >= 0 and at.x() < px(GRIP):
            self._dragged = self._to = row
            self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)
            return
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position().toPoint()
        if self._dragged is not None:
            self._to = self._place(at)
            self.viewport().update()
            return
        over = at.x() < px(GRIP) and self.logicalIndexAt(at) >= 0
        shape = Qt.CursorShape.OpenHandCursor if over else Qt.CursorShape.ArrowCursor
        self.viewport().setCursor(shape)
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._dragged is None:
            super().mouseReleaseEvent(event)
            return
        row, to = self._dragged, self._to
        self._dragged = None
        self.viewport().update()
        if to != row:
            self.moved.emit(row, to)

    def _place(self, at: QPoint) -> int:
        """Where the dragged row would stand if it were let go."""
        assert self._dragged is not None
        row = self.logicalIndexAt(at)
        if row < 0:
            return self.count() - 1 if at.y() > 0 else 0
        area = self.area_of(row)
        before = at.y() < area.center().y()
        gap = row if before else row + 1
        return gap - 1 if gap > self._dragged else gap

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._dragged is None or self._to == self._dragged:
            return
        area = self.area_of(self._to)
        y = area.bottom() if self._to > self._dragged else area.top()
        painter = QPainter(self.viewport())
        painter.setPen(QPen(self._theme.color("accent"), 3))
        painter.drawLine(2, y, self.width(), y)
        painter.end()
