"""*What can follow*: the menu where a pipe was dropped on empty canvas, typed to filter."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QLineEdit, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from situ_studio.assistive.announcing import CurrentRow
from situ_studio.canvas.gestures import Follow
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import FORM, Theme, font
from situ_studio.wording.language import tr


class FollowMenu(QFrame):
    """chosen: the key of what was taken. named: what was typed, for something new.
    closed: always, afterwards."""

    chosen = Signal(str)
    named = Signal(str)
    closed = Signal()

    def __init__(
        self,
        choices: Sequence[Follow],
        theme: Theme,
        parent: QWidget,
        asked: str = "",
    ) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("followMenu")
        asked = asked or tr("What follows?")
        self.choices = tuple(choices)
        self._theme = theme
        self._naming, self._new = "", ""
        layout = QVBoxLayout(self)
        layout.setContentsMargins(5, 5, 5, 5)
        layout.setSpacing(4)
        self.field = QLineEdit()
        self.field.setPlaceholderText(tr("{0} Type to filter").format(asked))
        self.field.setFont(font(FORM))
        self.field.setFixedHeight(px(28))
        self.field.setAccessibleName(asked)
        self.field.installEventFilter(self)
        self.list = QListWidget()
        self.list.setAccessibleName(asked)
        self.list.setFont(font(FORM))
        self.list.setIconSize(QSize(px(16), px(16)))
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.list.setUniformItemSizes(True)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.current_row = CurrentRow(self.list)
        layout.addWidget(self.field)
        layout.addWidget(self.list)
        self.field.textChanged.connect(self._filter)
        self.list.itemClicked.connect(self._take)
        self.setStyleSheet(
            f"#followMenu {{ background: {theme.panel}; border: 1px solid {theme.line_strong};"
            " border-radius: 8px; }"
            f"QLineEdit {{ background: {theme.field}; color: {theme.text}; padding: 0 8px;"
            f" border: 1px solid {theme.line}; border-radius: 6px; }}"
            f"QLineEdit:focus {{ border-color: {theme.accent}; }}"
            f"QListWidget {{ background: {theme.panel}; color: {theme.text}; border: none;"
            " outline: none; }"
            f"QListWidget::item {{ height: {px(26)}px; padding-left: 4px; border-radius: 4px; }}"
            f"QListWidget::item:selected {{ background: {theme.accent_soft};"
            f" color: {theme.text}; }}"
            "QScrollBar:vertical { width: 8px; background: transparent; margin: 0; }"
            f"QScrollBar::handle:vertical {{ background: {theme.line_strong};"
            " border-radius: 4px; min-height: 24px; }"
            "QScrollBar::add-line, QScrollBar::sub-line { height: 0; }"
            "QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }"
        )
        self._filter("")
        self.setFixedSize(px(280), px(46) + px(26) * min(11, len(self.choices)))

    def _filter(self, text: str) -> None:
        wanted = text.casefold().split()
        self.list.clear()
        for choice in self.choices:
            hay = f"{choice.label} {choice.words} {choice.key}".casefold()
            if all(word in hay for word in wanted):
                color = self._theme.accent if choice.icon == "plus" else self._theme.text2
                item = QListWidgetItem(icons.icon(choice.icon, color), choice.label)
                item.setData(Qt.ItemDataRole.UserRole, choice.key)
                self.list.addItem(item)
        if self._naming and wanted:
            words = self._naming.format(" ".join(text.split()))
            self.list.addItem(QListWidgetItem(icons.icon(self._new, self._theme.text2), words))
        self.list.setCurrentRow(0)

    def offer_name(self, words: str, icon: str = "state") -> None:
        """Last of all is offered something new, called as was typed. words: with ``{0}``."""
        self._naming, self._new = words, icon

    def _take(self, item: QListWidgetItem | None) -> None:
        if item is None:
            return
        key = item.data(Qt.ItemDataRole.UserRole)
        name = " ".join(self.field.text().split())
        self.close()
        if key is None:
            self.named.emit(name)
        else:
            self.chosen.emit(key)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            row, last = self.list.currentRow(), self.list.count() - 1
            match event.key():
                case Qt.Key.Key_Down:
                    self.list.setCurrentRow(min(last, row + 1))
                    return True
                case Qt.Key.Key_Up:
                    self.list.setCurrentRow(max(0, row - 1))
                    return True
                case Qt.Key.Key_Return | Qt.Key.Key_Enter:
                    self._take(self.list.currentItem())
                    return True
                case Qt.Key.Key_Escape:
                    self.close()
                    return True
        return super().eventFilter(watched, event)

    def popup(self, at: QPoint) -> None:
        """Opens at a place of the screen, or as near as it is seen whole."""
        room = self.screen().availableGeometry().adjusted(4, 4, -4, -4)
        left = min(at.x(), room.right() + 1 - self.width())
        top = min(at.y(), room.bottom() + 1 - self.height())
        self.move(max(room.left(), left), max(room.top(), top))
        self.show()
        self.field.setFocus()

    def closeEvent(self, event: Any) -> None:
        super().closeEvent(event)
        self.closed.emit()
