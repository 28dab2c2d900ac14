"""The heading of a panel: a title at the left, a hint or buttons at the right; 32 px high."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

HEIGHT = 32


class PanelHeader(QWidget):
    """Also the title bar of the panel's dock, by which it is dragged."""

    def __init__(self, title: str, hint: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedHeight(HEIGHT)
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

    def sizeHint(self) -> QSize:
        # A dock asks for the hint of its title bar, whatever its fixed height is.
        return QSize(80, HEIGHT)

    def minimumSizeHint(self) -> QSize:
        return QSize(80, HEIGHT)

    def add(self, widget: QWidget) -> None:
        """Puts a button at the right end."""
        self._line.addWidget(widget)
