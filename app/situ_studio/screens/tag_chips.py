"""The tags of a project as chips: dragged into a text, or pressed."""

from __future__ import annotations

from PySide6.QtCore import QMimeData, QPoint, QRect, QSize, Signal
from PySide6.QtWidgets import QLabel, QLayout, QLayoutItem, QWidget

from situ_studio.looks.theme import Theme
from situ_studio.widgets.dragging import Dragging
from situ_studio.widgets.icon_widgets import ThemedButton
from situ_studio.widgets.layouts import clear

TAG = "application/x-situ-tag"
"""What a dragged chip carries: the tag; as plain text, the reference to it."""
MOST = 30


class Flow(QLayout):
    """Widgets side by side, in as many lines as there must be."""

    def __init__(self, gap: int) -> None:
        super().__init__()
        self._items: list[QLayoutItem] = []
        self._gap = gap

    def addItem(self, item: QLayoutItem) -> None:
        self._items.append(item)

    def count(self) -> int:
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        return self._lay_out(QRect(0, 0, width, 0), False)

    def setGeometry(self, rect: QRect) -> None:
        super().setGeometry(rect)
        self._lay_out(rect, True)

    def sizeHint(self) -> QSize:
        return self.minimumSize()

    def minimumSize(self) -> QSize:
        size = QSize()
        for item in self._items:
            size = size.expandedTo(item.minimumSize())
        margins = self.contentsMargins()
        return size + QSize(margins.left() + margins.right(), margins.top() + margins.bottom())

    def _lay_out(self, rect: QRect, place: bool) -> int:
        margins = self.contentsMargins()
        room = rect.marginsRemoved(margins)
        x, y, high = room.left(), room.top(), 0
        for item in self._items:
            size = item.sizeHint()
            wide = min(size.width(), room.width())
            if x > room.left() and x + wide > room.right() + 1:
                x, y, high = room.left(), y + high + self._gap, 0
            if place:
                item.setGeometry(QRect(QPoint(x, y), QSize(wide, size.height())))
            x += wide + self._gap
            high = max(high, size.height())
        return y + high - rect.top() + margins.bottom()


class TagChip(ThemedButton):
    """One tag. A drag carries it as ``TAG``, and as text what stands for it."""

    def __init__(self, theme: Theme, tag: str) -> None:
        super().__init__(theme, "data", tag, "", "data", 13)
        self.tag = tag
        self.setToolTip(self.tr("Drag it into a text, or press it to put it at its end"))
        Dragging(self, lambda: dragged(self.tag))

    def set_theme(self, theme: Theme) -> None:
        super().set_theme(theme)
        self.setStyleSheet(
            f"QPushButton {{ background: {theme.data_soft}; color: {theme.data}; font-size: 12px;"
            " border: 1px solid transparent; border-radius: 4px; padding: 0 6px; min-height: 20px;"
            " max-height: 20px; text-align: left; }"
            f"QPushButton:hover {{ border-color: {theme.data}; }}"
            f"QPushButton:focus {{ border-color: {theme.accent}; }}"
        )


def dragged(tag: str) -> QMimeData:
    """What a chip carries: the tag, and ``{tag}`` for any field that takes text."""
    data = QMimeData()
    data.setData(TAG, tag.encode())
    data.setText(f"{{{tag}}}")
    return data


class TagChips(QWidget):
    """pressed: the tag that shall be put at the end of the selected text."""

    pressed = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Tags"))
        self._theme = theme
        self._tags: tuple[str, ...] | None = None
        self._flow = Flow(6)
        self._flow.setContentsMargins(12, 0, 12, 8)
        self.setLayout(self._flow)
        self.show_tags(())

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme

    def show_tags(self, tags: tuple[str, ...]) -> None:
        tags = tags[:MOST]
        if tags == self._tags:
            return
        self._tags = tags
        clear(self._flow)
        for tag in tags:
            chip = TagChip(self._theme, tag)
            chip.clicked.connect(lambda _=False, t=tag: self.pressed.emit(t))
            self._flow.addWidget(chip)
        if not tags:
            none = QLabel(self.tr("None yet: write {name} in a text"))
            none.setProperty("role", "hint")
            self._flow.addWidget(none)
        self.updateGeometry()

    def chip(self, tag: str) -> TagChip:
        """LookupError where there is no such chip."""
        for chip in self.findChildren(TagChip):
            if chip.tag == tag and not chip.isHidden():
                return chip
        raise LookupError(tag)
