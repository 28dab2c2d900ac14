"""What is seen while a layout runs: what is done, that it goes on, and *Cancel*."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QProgressBar, QPushButton, QWidget

from situ_studio.language import tr
from situ_studio.theme import BODY, Theme, font


class ArrangingBar(QFrame):
    """In the middle of the canvas's upper edge."""

    cancelled = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._room = parent
        self.setObjectName("arranging")
        line = QHBoxLayout(self)
        line.setContentsMargins(12, 6, 6, 6)
        line.setSpacing(12)
        self.words = QLabel()
        self.words.setFont(font(BODY))
        line.addWidget(self.words)
        progress = QProgressBar()
        # How long it takes is not known before.
        progress.setRange(0, 0)
        progress.setFixedSize(96, 6)
        progress.setTextVisible(False)
        progress.setAccessibleName(tr("The layout is being made"))
        line.addWidget(progress)
        self.stop = QPushButton(tr("Cancel"))
        self.stop.clicked.connect(self.cancelled)
        line.addWidget(self.stop)
        self.hide()

    def set_theme(self, theme: Theme) -> None:
        self.setStyleSheet(
            f"#arranging {{ background: {theme.panel}; border: 1px solid {theme.line_strong};"
            " border-radius: 8px; }"
            f"QLabel {{ color: {theme.text}; background: transparent; border: none; }}"
            f"QProgressBar {{ background: {theme.line}; border: none; border-radius: 3px; }}"
            f"QProgressBar::chunk {{ background: {theme.accent}; border-radius: 3px; }}"
        )

    def tell(self, words: str) -> None:
        self.words.setText(words)
        self.show()
        self.place()
        self.raise_()

    def place(self) -> None:
        self.adjustSize()
        self.move((self._room.width() - self.width()) // 2, 12)
