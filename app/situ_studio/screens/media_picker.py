"""*Which picture?*: those of the project's media, typed to filter, and a file from elsewhere."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import (
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from situ_studio import icons
from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.menu import FollowMenu
from situ_studio.language import tr
from situ_studio.letters import enlarged, px
from situ_studio.screens.media_pictures import picture
from situ_studio.theme import FORM, LABEL, Theme, font

IMPORT = "/"
"""The key of the row that asks for a file from elsewhere: no file is called so."""
WIDE = 320
HIGH = 44
"""Px of a row."""
ROWS = 6
"""So many are seen at the most; the others are reached by scrolling."""
THUMBNAIL = QSize(48, 36)
KEY = Qt.ItemDataRole.UserRole


def asked(kind: str) -> str:
    """What is wanted of a kind of media: ``image``, ``movie`` or ``sound``."""
    if kind == "image":
        return tr("Which picture?")
    return tr("Which movie?") if kind == "movie" else tr("Which sound?")


class MediaPicker(FollowMenu):
    """``chosen`` tells a file as the project names it, a reference or an address that was typed, or
    IMPORT.

    kind: ``image``, ``movie`` or ``sound``. names: of the files that fit, home the folder in which
    they are. now: the one that is chosen at first, of those that are there.
    """

    def __init__(
        self,
        kind: str,
        names: Iterable[str],
        home: Path | None,
        theme: Theme,
        parent: QWidget,
        now: str = "",
    ) -> None:
        choices = [Follow(IMPORT, tr("Import a file…"), "plus")]
        choices += [Follow(name, name, kind) for name in names]
        super().__init__(choices, theme, parent, asked(kind))
        self.field.setPlaceholderText(tr("{0} Type to filter").format(asked(kind)))
        self.list.setItemDelegate(_Media(theme, home, self.list))
        self.list.setAccessibleName(asked(kind))
        self.list.setMouseTracking(True)
        self.setFixedSize(px(WIDE), px(48) + px(HIGH) * min(ROWS, len(self.choices)))
        for row in range(self.list.count()):
            if self.list.item(row).data(KEY) == now:
                self.list.setCurrentRow(row)

    def _filter(self, text: str) -> None:
        """What is typed as a reference, an address, or a file that is still to come can be used."""
        typed = text.strip()
        wanted = typed.casefold().split()
        self.list.clear()
        for choice in self.choices:
            if choice.key == IMPORT or all(word in choice.label.casefold() for word in wanted):
                self._add(choice.key, choice.label, choice.icon)
        refers = typed.startswith("{") or "://" in typed
        known = {choice.key for choice in self.choices}
        if (refers or Path(typed).suffix) and typed not in known:
            self._add(typed, tr("Use {0}").format(typed), "link")
        # A picture rather than the import, which stands before them.
        first = self.list.item(0)
        several = self.list.count() > 1 and first is not None and first.data(KEY) == IMPORT
        self.list.setCurrentRow(1 if several else 0)

    def _add(self, key: str, label: str, icon: str) -> None:
        item = QListWidgetItem(label)
        item.setData(KEY, key)
        item.setData(ICON, icon)
        item.setToolTip(label)
        self.list.addItem(item)


ICON = int(KEY) + 1


class _Media(QStyledItemDelegate):
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
            painter.setBrush(theme.color("accent_soft"))
            painter.drawRoundedRect(rect, 4, 4)
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.setBrush(theme.color("hover"))
            painter.drawRoundedRect(rect, 4, 4)
        box = QRectF(rect.x() + 6, rect.center().y() - 18, THUMBNAIL.width(), THUMBNAIL.height())
        said = self._thumbnail(painter, box, index)
        right = rect.right() - 8
        middle = int(Qt.AlignmentFlag.AlignVCenter)
        if said:
            painter.setFont(font(LABEL))
            painter.setPen(theme.color("text3"))
            width = painter.fontMetrics().horizontalAdvance(said)
            beside = QRectF(right - width, rect.y(), width + 1, rect.height())
            painter.drawText(beside, middle, said)
            right -= width + 8
        painter.setFont(font(FORM))
        painter.setPen(theme.color("text"))
        room = QRectF(box.right() + 10, rect.y(), right - box.right() - 10, rect.height())
        cut = Qt.TextElideMode.ElideMiddle
        name = painter.fontMetrics().elidedText(index.data(), cut, int(room.width()))
        painter.drawText(room, middle, name)

    def _thumbnail(
        self, painter: QPainter, box: QRectF, index: QModelIndex | QPersistentModelIndex
    ) -> str:
        """Paints what a row is about; says how large a picture is."""
        theme = self._theme
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
