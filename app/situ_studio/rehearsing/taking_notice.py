"""What was drawn since a rehearsal began: taken into it, waited for, gone back from."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from situ.document.diff import compare
from situ.document.project import Project
from situ_studio.live.deploying_words import waited
from situ_studio.rehearsing.course import Course
from situ_studio.wording.language import said, tr

MOST = 3
"""Changes that are told."""


class TakingNotice(QFrame):
    """There while something else is drawn than runs, and while what ran before can run again."""

    take_asked = Signal()
    """What runs shall go on as it is drawn now."""
    hurry_asked = Signal()
    """What waits shall run at once."""
    back_asked = Signal()
    """What ran before shall run again."""
    again_asked = Signal()
    """From the start, as it is drawn now."""
    told = Signal(str)
    """How it is now with the changes."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._compared: tuple[Project, Project, list[str]] | None = None
        self.setProperty("role", "box")
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 7, 8, 8)
        column.setSpacing(6)
        self.words = QLabel()
        self.words.setProperty("role", "words")
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setAccessibleDescription(self.tr("How it is with your changes"))
        column.addWidget(self.words)
        line = QHBoxLayout()
        line.setSpacing(6)
        self.take = self._button(
            line,
            self.tr("Take in"),
            self.tr("It goes on with your changes, from the next moment at which no action runs"),
        )
        self.take.clicked.connect(self.take_asked)
        self.hurry = self._button(
            line, self.tr("At once"), self.tr("What runs now is broken off if it is another now")
        )
        self.hurry.clicked.connect(self.hurry_asked)
        self.back = self._button(
            line, self.tr("Go back"), self.tr("It goes on as before your changes, at once")
        )
        self.back.clicked.connect(self.back_asked)
        self.again = self._button(
            line, self.tr("Start again"), self.tr("From the start, with your changes")
        )
        self.again.clicked.connect(self.again_asked)
        line.addStretch(1)
        column.addLayout(line)
        self.hide()

    def _button(self, line: QHBoxLayout, words: str, tip: str) -> QPushButton:
        button = QPushButton(words)
        button.setProperty("role", "mend")
        button.setAccessibleName(words)
        button.setToolTip(tip)
        line.addWidget(button)
        return button

    def show_course(self, course: Course, drawn: Project | None) -> None:
        """drawn: the project as it is now; None where it can not be known."""
        awaited = course.awaited
        differs = drawn is not None and drawn != (awaited or course.project)
        words = ""
        if awaited is not None:
            what = ", ".join(map(waited, course.deployment.waits)) or self.tr("a moment")
            words = self.tr("Your changes wait until no action runs: {0}.").format(what)
        elif course.failed is not None:
            words = self.tr("With your changes it went wrong, and what ran before runs again: {0}")
            words = words.format(said(course.failed))
        elif differs and drawn is not None:
            told = self._told(course, drawn)
            words = "\n".join((self.tr("The project has changed since."), *told))
        elif course.can_return:
            words = self.tr("It goes on with your changes.")
        if words != self.words.text():
            self.words.setText(words)
            self.told.emit(words)
        self.take.setVisible(differs)
        self.hurry.setVisible(awaited is not None)
        self.back.setVisible(course.can_return and awaited is None)
        self.again.setVisible(differs and awaited is None)
        self.setVisible(bool(words))

    def _told(self, course: Course, drawn: Project) -> list[str]:
        """What it would do differently; compared once, for this is asked with every event."""
        known, runs = self._compared, course.project
        if known is None or known[0] is not runs or known[1] is not drawn:
            known = self._compared = (runs, drawn, _changes(runs, drawn))
        return known[2]


def _changes(runs: Project, drawn: Project) -> list[str]:
    """The first of them, each in a line."""
    changes = [one for one in compare(runs, drawn) if one.behaviour]
    told = [f"– {said(one.text)}" for one in changes[:MOST]]
    if len(changes) > MOST:
        told.append(tr("and {0} more").format(len(changes) - MOST))
    return told
