"""Rows of the trees and lists at the left: a number or icon, a name, a count or a mark."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from situ_studio.looks import icons
from situ_studio.looks.letters import enlarged, px
from situ_studio.looks.theme import Theme, face
from situ_studio.widgets.focus_ring import paint_chosen

NUMBER = int(Qt.ItemDataRole.UserRole) + 1
"""Shown right-aligned in a narrow column before the name."""
ICON = NUMBER + 1
"""A pair of an icon's name and a colour's token."""
COUNT = NUMBER + 2
"""A small text at the right end; the name goes before it where there is little room."""
MARKS = NUMBER + 3
"""Pairs of icon and token at the right end."""
PLACE = NUMBER + 4
"""What the row stands for."""
DETAIL = NUMBER + 5
"""A second line."""
COUNT_LEAST = 36
"""Width that the small text at the right end gets in any case: that of a large number."""

AnyIndex = QModelIndex | QPersistentModelIndex


class RowDelegate(QStyledItemDelegate):
    """Paints a row in the theme's colours: 24 px high, 22 in dense lists, 44 with two lines."""

    def __init__(self, theme: Theme, height: int = 24, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme, self._height = theme, height

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme

    def sizeHint(self, option: QStyleOptionViewItem, index: AnyIndex) -> QSize:
        return QSize(px(80), px(44 if index.data(DETAIL) else self._height))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: AnyIndex) -> None:
        with enlarged(painter, QRectF(option.rect)) as rect:
            self._paint(painter, rect, option.state, index)

    def _paint(
        self, painter: QPainter, rect: QRectF, state: QStyle.StateFlag, index: AnyIndex
    ) -> None:
        theme = self._theme
        full = QRectF(0, rect.y(), rect.right() + 1, rect.height())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        selected = bool(state & QStyle.StateFlag.State_Selected)
        if selected:
            paint_chosen(painter, full, theme)
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(full, theme.color("hover"))
        if state & QStyle.StateFlag.State_HasFocus and not selected:
            painter.setPen(theme.color("accent"))
            painter.drawRect(full.adjusted(0.5, 0.5, -0.5, -0.5))
        detail = index.data(DETAIL)
        line = QRectF(rect.x(), rect.y(), rect.width(), 26 if detail else rect.height())
        x = line.x() + 4
        number = index.data(NUMBER)
        if number is not None:
            painter.setFont(face(12))
            painter.setPen(theme.color("text3"))
            width = max(18.0, painter.fontMetrics().horizontalAdvance(number) + 2.0)
            painter.drawText(
                QRectF(x + 4, line.y(), width, line.height()),
                int(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight),
                number,
            )
            x += width + 10
        icon = index.data(ICON)
        if icon is not None:
            # In line with the panels' headings; trees are indented already.
            x += 6 if rect.x() == 0 else 0
            box = QRectF(x + 2, line.center().y() - 7.5, 15, 15)
            icons.paint(painter, icon[0], box, theme.color(icon[1]))
            x += 23
        right = line.right() - 8
        for name, token in reversed(index.data(MARKS) or ()):
            box = QRectF(right - 14, line.center().y() - 7, 14, 14)
            icons.paint(painter, name, box, theme.color(token))
            right -= 18
        name = index.data(Qt.ItemDataRole.DisplayRole) or ""
        called = face(
            13 if self._height >= 24 else 12.5, index.data(Qt.ItemDataRole.FontRole) or 400
        )
        count = index.data(COUNT)
        if count:
            painter.setFont(called)
            left = right - x - painter.fontMetrics().horizontalAdvance(name) - 8
            painter.setFont(face(11))
            painter.setPen(theme.color("text3"))
            count = painter.fontMetrics().elidedText(
                count, Qt.TextElideMode.ElideRight, max(int(left), COUNT_LEAST)
            )
            width = painter.fontMetrics().horizontalAdvance(count)
            painter.drawText(
                QRectF(right - width, line.y(), width + 1, line.height()),
                int(Qt.AlignmentFlag.AlignVCenter),
                count,
            )
            right -= width + 6
        painter.setFont(called)
        painter.setPen(theme.color("text"))
        name = painter.fontMetrics().elidedText(name, Qt.TextElideMode.ElideRight, int(right - x))
        painter.drawText(
            QRectF(x, line.y(), right - x, line.height()),
            int(Qt.AlignmentFlag.AlignVCenter),
            name,
        )
        if detail:
            painter.setFont(face(11))
            painter.setPen(theme.color("text2"))
            below = QRectF(x, line.bottom() - 4, rect.right() - x - 8, 16)
            shown = painter.fontMetrics().elidedText(
                detail, Qt.TextElideMode.ElideRight, int(below.width())
            )
            painter.drawText(below, int(Qt.AlignmentFlag.AlignVCenter), shown)
            painter.setPen(theme.color("line"))
            painter.drawLine(rect.bottomLeft(), rect.bottomRight())
