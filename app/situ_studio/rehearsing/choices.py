"""A list of what may be chosen, each with its box as everywhere else; a click on a row does it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt
from PySide6.QtGui import QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QListWidget, QStyle, QStyledItemDelegate, QStyleOptionViewItem

from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme, font

HIGH, BOX, EDGE = 26, 16, 6
"""Px of a row, of its box, and beside the box."""
CHECK = Qt.ItemDataRole.CheckStateRole


class Choices(QListWidget):
    """Rows that are cut say themselves whole in their tips."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.setMouseTracking(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setItemDelegate(_Row(theme, self))


class _Row(QStyledItemDelegate):
    def __init__(self, theme: Theme, parent: QListWidget) -> None:
        super().__init__(parent)
        self._theme = theme

    def sizeHint(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        return QSize(px(80), px(HIGH))

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        theme, row = self._theme, QRectF(option.rect)
        chosen = Qt.CheckState(index.data(CHECK)) == Qt.CheckState.Checked
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if option.state & QStyle.StateFlag.State_HasFocus:
            painter.fillRect(row, theme.color("accent_soft"))
        elif option.state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(row, theme.color("hover"))
        wide = px(BOX)
        box = QRectF(row.x() + px(EDGE), row.center().y() - wide / 2, wide, wide)
        painter.setPen(QPen(theme.color("accent" if chosen else "line_strong")))
        painter.setBrush(theme.color("accent" if chosen else "field"))
        painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4)
        if chosen:
            icons.paint(painter, "check", box.adjusted(1, 1, -1, -1), theme.color("on_accent"))
        painter.setFont(font(13))
        painter.setPen(theme.color("text" if chosen else "text2"))
        room = row.adjusted(px(2 * EDGE + BOX), 0, -px(EDGE), 0)
        words = painter.fontMetrics().elidedText(
            index.data(), Qt.TextElideMode.ElideRight, int(room.width())
        )
        painter.drawText(room, int(Qt.AlignmentFlag.AlignVCenter), words)
        painter.restore()

    def editorEvent(
        self,
        event: QEvent,
        model: object,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> bool:
        if isinstance(event, QMouseEvent):
            left = event.button() == Qt.MouseButton.LeftButton
            if event.type() != QEvent.Type.MouseButtonRelease or not left:
                return event.type() == QEvent.Type.MouseButtonDblClick
            chosen = Qt.CheckState(index.data(CHECK)) == Qt.CheckState.Checked
            other = Qt.CheckState.Unchecked if chosen else Qt.CheckState.Checked
            return index.model().setData(index, other.value, CHECK)
        return super().editorEvent(event, index.model(), option, index)
