"""A file that was changed here and by another program: both in words, and which one shall stay."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from situ.document.change import Change
from situ_studio.looks.letters import px
from situ_studio.project.differing import Differing
from situ_studio.wording.language import said

Answer = Literal["mine", "theirs", "both", "cancel"]
MOST = 500
"""Changes of one side that are listed."""


class ConflictDialog(QDialog):
    """What both sides changed, side by side. ``answer``: mine, theirs, both or cancel."""

    def __init__(self, found: Differing, parent: QWidget) -> None:
        super().__init__(parent)
        self.answer: Answer = "cancel"
        self.setWindowTitle(self.tr("{0} is another one on disk").format(found.file))
        self.resize(px(760), 340)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 16)
        column.setSpacing(12)
        self.words = QLabel(self._words(found))
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        column.addWidget(self.words)
        sides = QHBoxLayout()
        sides.setSpacing(16)
        self.mine = self._side(sides, self.tr("You changed"), found.my_changes)
        if found.base is not None and found.theirs is not None:
            title = self.tr("The other program changed")
            self.theirs = self._side(sides, title, found.their_changes)
        column.addLayout(sides, 1)
        buttons = QDialogButtonBox()
        self.buttons: dict[str, QPushButton] = {}
        role = QDialogButtonBox.ButtonRole
        if found.both is not None:
            self._button(buttons, "both", self.tr("Keep both"), role.AcceptRole)
        if found.theirs is not None:
            self._button(buttons, "theirs", self.tr("Take the one on disk"), role.ActionRole)
        self._button(buttons, "mine", self.tr("Keep mine"), role.ActionRole)
        self._button(buttons, "cancel", self.tr("Decide later"), role.RejectRole)
        first = next(iter(self.buttons.values()))
        first.setDefault(True)
        first.setProperty("role", "filled")
        column.addWidget(buttons)

    def _words(self, found: Differing) -> str:
        if found.gone:
            text = self.tr(
                "{0} is gone: another program removed or renamed it. "
                "Keep yours and it is written again when you save."
            )
        elif found.unread:
            text = self.tr(
                "Another program changed {0}, and it has errors now: {1}. "
                "Keep yours and what is there is overwritten when you save."
            )
        elif found.both is not None:
            text = self.tr(
                "Another program changed {0} while you did, at other places: both can be kept. "
                "Each choice is a step that Undo takes back."
            )
        elif found.base is None:
            text = self.tr("Another program changed {0} again. Below is how yours differs from it.")
        else:
            text = self.tr(
                "Another program changed {0} while you did, partly the same things: "
                "choose which one stays. Each choice is a step that Undo takes back."
            )
        return text.format(found.file, said(found.unread))

    def _side(self, sides: QHBoxLayout, title: str, changes: list[Change]) -> QListWidget:
        column = QVBoxLayout()
        column.setSpacing(6)
        label = QLabel(title)
        label.setProperty("role", "strong")
        column.addWidget(label)
        rows = QListWidget()
        rows.setAccessibleName(title)
        rows.setWordWrap(True)
        rows.setFrameShape(QFrame.Shape.NoFrame)
        rows.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        rows.addItems([said(change.text) for change in changes[:MOST]])
        if len(changes) > MOST:
            rows.addItem(self.tr("and {0} more").format(len(changes) - MOST))
        if not changes:
            rows.addItem(self.tr("Nothing that counts: only where things stand in the file."))
        box = QFrame()
        box.setProperty("role", "box")
        inner = QVBoxLayout(box)
        inner.setContentsMargins(4, 4, 4, 4)
        inner.addWidget(rows)
        column.addWidget(box, 1)
        sides.addLayout(column, 1)
        return rows

    def _button(
        self,
        box: QDialogButtonBox,
        answer: Answer,
        text: str,
        role: QDialogButtonBox.ButtonRole,
    ) -> None:
        button = box.addButton(text, role)
        button.clicked.connect(lambda: self._choose(answer))
        self.buttons[answer] = button

    def _choose(self, answer: Answer) -> None:
        self.answer = answer
        self.done(0)
