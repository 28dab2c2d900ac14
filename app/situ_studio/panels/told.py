"""The problems of what the inspector shows, above its form: each with its mark and its mend."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QGridLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QStyle,
    QStyleOptionButton,
    QWidget,
)

from situ.document.problem import Problem
from situ_studio.icon_widgets import IconLabel
from situ_studio.language import said
from situ_studio.layouts import clear
from situ_studio.letters import px
from situ_studio.theme import Theme


class Told(QWidget):
    """A warning looks like one, an error like one: by its mark and by its colour."""

    mend_asked = Signal(object)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._shown: tuple[Problem, ...] = ()
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(12, 8, 12, 0)
        self._grid.setHorizontalSpacing(6)
        self._grid.setVerticalSpacing(4)
        self._grid.setColumnStretch(1, 1)
        self.hide()

    def show_problems(self, problems: tuple[Problem, ...]) -> None:
        """Errors first; none hides it."""
        problems = tuple(sorted(problems, key=lambda one: one.severity != "error"))
        if problems != self._shown:
            self._shown = problems
            clear(self._grid)
            for problem in problems:
                self._add(problem)
        self.setVisible(bool(problems))

    def set_theme(self, theme: Theme) -> None:
        """Takes the theme for what is shown from now on; ``retheme`` does what is shown."""
        self._theme = theme

    def _add(self, problem: Problem) -> None:
        row = self._grid.rowCount()
        mark = IconLabel(self._theme, problem.severity, problem.severity, 14)
        self._grid.addWidget(mark, row, 0, Qt.AlignmentFlag.AlignTop)
        words = QLabel(said(problem.message))
        words.setProperty("severity", problem.severity)
        words.setWordWrap(True)
        # A tag of many letters is one word: it makes no panel wider either.
        words.setMinimumWidth(1)
        words.setTextFormat(Qt.TextFormat.PlainText)
        kind = self.tr("Error") if problem.severity == "error" else self.tr("Warning")
        words.setAccessibleName(f"{kind}: {words.text()}")
        self._grid.addWidget(words, row, 1)
        if problem.mend is not None:
            button = _Mend(said(problem.mend.words))
            button.setProperty("role", "mend")
            button.setToolTip(f"{button.text()}\n{words.text()}")
            button.clicked.connect(lambda _=False: self.mend_asked.emit(problem))
            self._grid.addWidget(button, row + 1, 1, Qt.AlignmentFlag.AlignLeft)


class _Mend(QPushButton):
    """Its words end with … where there is no room: a long mend makes no panel wider."""

    LEAST = 96

    def __init__(self, words: str) -> None:
        super().__init__(words)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        return QSize(min(hint.width(), px(self.LEAST)), hint.height())

    def initStyleOption(self, option: QStyleOptionButton) -> None:
        super().initStyleOption(option)
        inside = self.style().subElementRect(QStyle.SubElement.SE_PushButtonContents, option, self)
        room = max(0, inside.width())
        option.text = self.fontMetrics().elidedText(option.text, Qt.TextElideMode.ElideRight, room)
