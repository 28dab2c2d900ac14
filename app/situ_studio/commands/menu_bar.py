"""The menu bar: the letters that open its menus are underlined while Alt is held."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QMenuBar, QStyleOptionMenuItem, QWidget

_PRESSED = (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress)


class MenuBar(QMenuBar):
    """Of a window, whose keys it listens to."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._letters = False
        window.installEventFilter(self)

    def initStyleOption(self, option: QStyleOptionMenuItem, action: QAction) -> None:
        super().initStyleOption(option, action)
        if not self._letters:
            option.text = action.text().replace("&", "")

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in _PRESSED and isinstance(event, QKeyEvent):
            self._underline(event.key() == Qt.Key.Key_Alt)
        elif event.type() in (QEvent.Type.KeyRelease, QEvent.Type.WindowDeactivate):
            self._underline(False)
        return False

    def _underline(self, letters: bool) -> None:
        if letters != self._letters:
            self._letters = letters
            self.update()
