"""A sentence about what went wrong, with the details folded, to be copied into a report."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QLabel,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from situ_studio.looks.letters import px


class Details(QDialog):
    """words: a sentence that says what to do; details: as many lines as there are.

    unfolded: the details are what one came for.
    """

    def __init__(
        self, title: str, words: str, details: str, parent: QWidget, unfolded: bool = False
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(title)
        self.setMinimumWidth(px(480))
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 16)
        column.setSpacing(12)
        self.words = QLabel(words)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.words.setWordWrap(True)
        column.addWidget(self.words)
        self.details = QPlainTextEdit(details)
        self.details.setReadOnly(True)
        self.details.setAccessibleName(self.tr("Details"))
        self.details.setMinimumHeight(px(240))
        self.details.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        column.addWidget(self.details, 1)
        buttons = QDialogButtonBox()
        role = QDialogButtonBox.ButtonRole
        self.fold = buttons.addButton(self.tr("Details"), role.HelpRole)
        self.fold.setCheckable(True)
        self.fold.toggled.connect(self._on_fold)
        self.copy = buttons.addButton(self.tr("Copy the details"), role.ActionRole)
        self.copy.clicked.connect(self._on_copy)
        close: QPushButton = buttons.addButton(self.tr("Close"), role.RejectRole)
        close.clicked.connect(self.reject)
        self.close_button = close
        column.addWidget(buttons)
        # Here: a button that lies in no dialog yet would not be the dialog's.
        close.setDefault(True)
        self.buttons = buttons
        self.fold.setVisible(not unfolded)
        self.fold.setChecked(unfolded)
        self._on_fold(unfolded)
        if unfolded:
            self.resize(px(760), 520)
            self.details.moveCursor(self.details.textCursor().MoveOperation.End)

    def _on_fold(self, shown: bool) -> None:
        self.details.setVisible(shown)
        self.adjustSize()

    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(f"{self.words.text()}\n\n{self.details.toPlainText()}")
