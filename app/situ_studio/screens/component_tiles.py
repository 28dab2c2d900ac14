"""The components of screens, to drag onto one, or to press."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QWidget

from situ_studio.kinds import COMPONENTS
from situ_studio.looks.theme import Theme
from situ_studio.panels.palette import PaletteItem


class ComponentTiles(QWidget):
    """Two columns. pressed: the name of a kind."""

    pressed = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        grid = QGridLayout(self)
        grid.setContentsMargins(8, 0, 12, 8)
        grid.setSpacing(4)
        self.items: dict[str, PaletteItem] = {}
        for at, kind in enumerate(COMPONENTS):
            item = PaletteItem(theme, kind, self)
            item.clicked.connect(lambda _=False, n=kind.name: self.pressed.emit(n))
            grid.addWidget(item, at // 2, at % 2)
            self.items[kind.name] = item

    def set_theme(self, theme: Theme) -> None:
        for item in self.items.values():
            item.set_theme(theme)
