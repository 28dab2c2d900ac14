"""A strip above the canvas: another program changed a file."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QWidget,
)

from situ_studio.icon_widgets import IconLabel
from situ_studio.theme import Theme


class Notice(QFrame):
    """A strip above the canvas: another program changed a file."""

    theirs = Signal(str)
    mine = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "notice")
        self._file = ""
        line = QHBoxLayout(self)
        line.setContentsMargins(12, 4, 8, 4)
        line.setSpacing(8)
        line.addWidget(IconLabel(theme, "warning", "warning", 16))
        self.words = QLabel()
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        line.addWidget(self.words, 1)
        self.take = QPushButton(self.tr("Take the one on disk"))
        self.take.clicked.connect(lambda: self._answer(self.theirs))
        line.addWidget(self.take)
        self.keep = QPushButton(self.tr("Keep mine"))
        self.keep.clicked.connect(lambda: self._answer(self.mine))
        line.addWidget(self.keep)

    def show_for(self, file: str, text: str, can_take: bool = True) -> None:
        self._file = file
        self.words.setText(text)
        self.take.setVisible(can_take)
        self.show()

    def _answer(self, signal: Any) -> None:
        self.hide()
        signal.emit(self._file)
