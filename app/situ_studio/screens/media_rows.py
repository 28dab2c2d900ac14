"""Rows of media: what each shows, what it is called, and what is told of it."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from situ_studio.looks import icons
from situ_studio.looks.letters import enlarged, px
from situ_studio.looks.theme import FORM, LABEL, Theme, font
from situ_studio.screens.media_pictures import picture
from situ_studio.widgets.focus_ring import paint_chosen

IMPORT = "/"
"""The key of a row that asks for a file from elsewhere: no file is called so."""
HIGH = 44
"""Px of a row."""
THUMBNAIL = QSize(48, 36)
KEY = Qt.ItemDataRole.UserRole
"""A file as the project names it."""
ICON = int(KEY) + 1
"""What stands for a file that is no picture."""
DETAIL = int(KEY) + 2
"""A second line, if any."""


class MediaRows(QStyledItemDelegate):
    """A row a file: what it shows, its name, and for a picture how many px it has.

    A file is read when its row is first seen.
    """

    def __init__(self, theme: Theme, home: Path | None, parent: QWidget) -> None:
        super().__init__(parent)
        self._theme, self._home = theme, home

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
        painter.save()
        with enlarged(painter, QRectF(option.rect)) as rect:
            self._paint(painter, rect, option.state, index)
        painter.restore()

    def _paint(
        self,
        painter: QPainter,
        rect: QRectF,
        state: QStyle.StateFlag,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        theme = self._theme
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        if state & QStyle.StateFlag.State_Selected:
            paint_chosen(painter, rect, theme)
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(rect, theme.color("hover"))
        box = QRectF(rect.x() + 6, rect.center().y() - 18, THUMBNAIL.width(), THUMBNAIL.height())
        said = self._thumbnail(painter, box, index)
        right = rect.right() - 8
        middle = int(Qt.AlignmentFlag.AlignVCenter)
        detail = index.data(DETAIL)
        line = QRectF(rect.x(), rect.y() + 3, 0, 22) if detail else rect
        if said:
            painter.setFont(font(LABEL))
            painter.setPen(theme.color("text3"))
            width = painter.fontMetrics().horizontalAdvance(said)
            beside = QRectF(right - width, line.y(), width + 1, line.height())
            painter.drawText(beside, middle, said)
            right -= width + 8
        painter.setFont(font(FORM))
        painter.setPen(theme.color("text"))
        room = QRectF(box.right() + 10, line.y(), right - box.right() - 10, line.height())
        cut = Qt.TextElideMode.ElideMiddle
        name = painter.fontMetrics().elidedText(index.data(), cut, int(room.width()))
        painter.drawText(room, middle, name)
        if detail:
            painter.setFont(font(LABEL))
            painter.setPen(theme.color("text2"))
            room = QRectF(room.x(), line.bottom() - 2, rect.right() - 8 - room.x(), 18)
            cut = Qt.TextElideMode.ElideRight
            told = painter.fontMetrics().elidedText(detail, cut, int(room.width()))
            painter.drawText(room, middle, told)

    def _thumbnail(
        self, painter: QPainter, box: QRectF, index: QModelIndex | QPersistentModelIndex
    ) -> str:
        """Paints what a row is about; says how large a picture is."""
        theme = self._theme
        # Of any shape, all begin at the same place.
        painter.setBrush(theme.color("canvas"))
        painter.drawRoundedRect(box, 4, 4)
        found = picture(self._home, index.data(KEY)) if index.data(ICON) == "image" else None
        if found is None:
            icon, token = index.data(ICON), "accent" if index.data(KEY) == IMPORT else "text2"
            small = QRectF(box.center().x() - 9, box.center().y() - 9, 18, 18)
            icons.paint(painter, icon, small, theme.color(token))
            return ""
        whole = found.whole()
        size = whole.size().scaled(THUMBNAIL, Qt.AspectRatioMode.KeepAspectRatio)
        sharp = painter.device().devicePixelRatioF() * painter.transform().m11()
        area = QRectF(0, 0, size.width(), size.height())
        area.moveCenter(box.center())
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawPixmap(area, found.at(size * sharp), QRectF())
        return f"{whole.width()} × {whole.height()}"
