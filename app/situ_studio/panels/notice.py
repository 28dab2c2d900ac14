"""A strip above the canvas: something about a file that a person should know, and may answer."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
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


class Notice(QFrame):
    """Words with a button an answer; an answer hides it."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "notice")
        self._line = QHBoxLayout(self)
        self._line.setContentsMargins(12, 4, 8, 4)
        self._line.setSpacing(8)
        self._line.addWidget(IconLabel(theme, "warning", "warning", 16))
        self.words = QLabel()
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setWordWrap(True)
        self.words.setMinimumHeight(px(28))
        self.words.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._line.addWidget(self.words, 1)
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
        self.show()

    def _answered(self, do: Callable[[], object]) -> None:
        self.hide()
        do()
