"""A strip above the canvas: something about a file that a person should know, and may answer."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QWidget,
)

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.icon_widgets import IconLabel

Answer = tuple[str, Callable[[], object]]

LEAST = 200
"""Px that the words have beside the answers; where they had less, the answers stand below."""


class Notice(QFrame):
    """Words with a button an answer; an answer hides it."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "notice")
        self._whole = QBoxLayout(QBoxLayout.Direction.LeftToRight, self)
        self._whole.setContentsMargins(12, 4, 8, 4)
        self._whole.setSpacing(8)
        asked, self._line = QHBoxLayout(), QHBoxLayout()
        self._whole.addLayout(asked, 1)
        self._whole.addLayout(self._line)
        for line in (asked, self._line):
            line.setSpacing(8)
        asked.addWidget(IconLabel(theme, "warning", "warning", 16))
        self._line.addStretch(1)
        self.words = QLabel()
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setWordWrap(True)
        self.words.setMinimumHeight(px(28))
        self.words.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        asked.addWidget(self.words, 1)
        self.buttons: list[QPushButton] = []
        self.about = ""
        """The file that it asks about."""
        self.hide()

    def ask(self, text: str, *answers: Answer, about: str = "") -> None:
        """Shows itself in place of what it asked before."""
        self.about = about
        for button in self.buttons:
            self._line.removeWidget(button)
            button.hide()
            button.deleteLater()
        self.buttons = []
        for words, answer in answers:
            button = QPushButton(words)
            button.clicked.connect(lambda _=False, do=answer: self._answered(do))
            self._line.addWidget(button)
            self.buttons.append(button)
        self.words.setText(text)
        self.words.setToolTip(text)
        self._settle()
        self.show()

    def _settle(self) -> None:
        beside = self.width() - self._line.sizeHint().width() >= px(LEAST)
        ways = QBoxLayout.Direction
        self._whole.setDirection(ways.LeftToRight if beside else ways.TopToBottom)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._settle()

    def _answered(self, do: Callable[[], object]) -> None:
        self.hide()
        do()
