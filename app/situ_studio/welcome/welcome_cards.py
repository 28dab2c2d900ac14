"""The cards of the welcome page: something to start with, an example."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAccessible, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from situ.document.spds import Spds
from situ_studio.assistive.heard_as import hear_as
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.welcome.project_pictures import Example, LargePicture, Picture, facts
from situ_studio.widgets.icon_widgets import Elided, IconLabel
from situ_studio.wording.language import tr

START, HIGH = 324, 64
"""Px that a choice is wide, and high."""


class Press(QFrame):
    """A frame that acts as a button."""

    pressed = Signal()

    def __init__(self, role: str, words: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", role)
        self.setAccessibleName(words)
        hear_as(self, QAccessible.Role.Button, lambda card: card.pressed.emit())
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self.rect().contains(event.position().toPoint()):
            self.pressed.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self.pressed.emit()
        else:
            super().keyPressEvent(event)


class Choice(Press):
    """Something to start with: an icon or a small picture, what it is, and a line below it.

    role: ``first`` of the one that is meant for most, ``card`` of others. keys: that do it too.
    """

    def __init__(
        self,
        theme: Theme,
        icon: str | Picture,
        title: str,
        below: str,
        keys: str = "",
        role: str = "card",
    ) -> None:
        super().__init__(role, title)
        self.setAccessibleDescription(below)
        self.setFixedSize(px(START), px(HIGH))
        self.line = QHBoxLayout(self)
        self.line.setContentsMargins(16, 0, 16, 0)
        self.line.setSpacing(14)
        if isinstance(icon, Picture):
            self.line.setContentsMargins(12, 0, 12, 0)
            self.line.addWidget(icon)
        else:
            token = "on_accent" if role == "first" else "accent"
            self.line.addWidget(IconLabel(theme, icon, token, 20))
        self.line.addLayout(two_lines(Elided(title, "strong"), Elided(below, "label")), 1)
        if keys:
            label = QLabel(keys)
            label.setProperty("role", "kbd")
            self.line.addWidget(label, 0, Qt.AlignmentFlag.AlignVCenter)

    def take_all_room(self) -> None:
        """As wide as there is room, where it shares a row with others."""
        self.setMinimumWidth(0)
        self.setMaximumWidth(px(2 * START))


class ExampleCard(Press):
    """An example: its drawing, its name, what is in it, and what it is about."""

    def __init__(self, theme: Theme, example: Example) -> None:
        title = example.name.replace("-", " ").capitalize()
        super().__init__("card", tr("Open a copy of the example {0}").format(title))
        self.setObjectName(f"example {example.name}")
        column = QVBoxLayout(self)
        column.setContentsMargins(1, 1, 1, 1)
        column.setSpacing(0)
        column.addWidget(LargePicture(theme, example.document))
        words = QVBoxLayout()
        words.setContentsMargins(16, 12, 16, 14)
        words.setSpacing(4)
        line = QHBoxLayout()
        line.setSpacing(8)
        kind = "situation" if isinstance(example.document, Spds) else "state"
        line.addWidget(IconLabel(theme, kind, kind, 18))
        name = QLabel(title)
        name.setProperty("role", "section")
        line.addWidget(name)
        line.addStretch(1)
        words.addLayout(line)
        count = Elided(facts(example.document), "hint")
        words.addWidget(count)
        about = QLabel(example.about)
        about.setProperty("role", "dim")
        about.setWordWrap(True)
        about.setMinimumHeight(px(40))
        about.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        words.addWidget(about)
        words.addStretch(1)
        column.addLayout(words)


def two_lines(upper: QWidget, lower: QWidget) -> QVBoxLayout:
    """The words of a card, in the middle of its height."""
    words = QVBoxLayout()
    words.setSpacing(0)
    words.addStretch(1)
    words.addWidget(upper)
    words.addWidget(lower)
    words.addStretch(1)
    return words
