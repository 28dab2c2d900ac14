"""The heading of a panel: a title at the left, a hint or buttons at the right; 32 px high."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QDockWidget, QHBoxLayout, QLabel, QMenu, QWidget

from situ_studio.looks.letters import px

HEIGHT = 32


class TitleBar(QWidget):
    """What a dock is dragged by: of a fixed height, in the panels' colour.

    Its context menu lets the dock float, or lie where it lay, and closes it.
    """

    def __init__(self, height: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._height = height
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedHeight(px(height))

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        dock = self.parentWidget()
        if not isinstance(dock, QDockWidget):
            return
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        floats = dock.isFloating()
        free = menu.addAction(self.tr("Dock again") if floats else self.tr("Float"))
        free.triggered.connect(lambda: dock.setFloating(not floats))
        menu.addAction(self.tr("Close")).triggered.connect(dock.close)
        menu.popup(event.globalPos())

    def sizeHint(self) -> QSize:
        # A dock asks for the hint of its title bar, whatever its fixed height is.
        return QSize(px(80), px(self._height))

    def minimumSizeHint(self) -> QSize:
        return QSize(px(80), px(self._height))


class PanelHeader(TitleBar):
    """Also the title bar of the panel's dock, by which it is dragged."""

    def __init__(self, title: str, hint: str = "", parent: QWidget | None = None) -> None:
        super().__init__(HEIGHT, parent)
        self._line = QHBoxLayout(self)
        self._line.setContentsMargins(12, 0, 8, 0)
        self._line.setSpacing(4)
        self.title = QLabel(title)
        self.title.setProperty("role", "heading")
        self._line.addWidget(self.title)
        self._line.addStretch(1)
        self.hint = QLabel(hint)
        self.hint.setProperty("role", "hint")
        self._line.addWidget(self.hint)

    def add(self, widget: QWidget) -> None:
        """Puts a button at the right end."""
        self._line.addWidget(widget)
