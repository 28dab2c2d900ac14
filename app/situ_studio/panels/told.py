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
from situ_studio.assistive.tab_order import stops
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.icon_widgets import IconLabel
from situ_studio.widgets.layouts import clear
from situ_studio.wording.language import said, tr

SEEN = 2
"""Problems that are seen at once: of more, the form would begin far below."""


class Told(QWidget):
    """A warning looks like one, an error like one: by its mark and by its colour.

    Of many the first are seen; a button shows the others, as long as the same place is shown.
    """

    mend_asked = Signal(object)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._shown: tuple[Problem, ...] = ()
        self._unfolded = False
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
            before, self._shown = self._shown, problems
            same = before and problems and before[0].place == problems[0].place
            self._unfolded = self._unfolded and bool(same)
            clear(self._grid)
            seen = len(problems) if self._unfolded else SEEN
            for problem in problems[:seen]:
                self._add(problem)
            if problems[seen:]:
                self._add_more(len(problems) - seen)
        self.setVisible(bool(problems))

    def set_theme(self, theme: Theme) -> None:
        """Takes the theme for what is shown from now on; ``retheme`` does what is shown."""
        self._theme = theme

    def _add(self, problem: Problem) -> QWidget | None:
        """What mends it, if anything does."""
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
        if problem.mend is None:
            return None
        mend = said(problem.mend.words)
        button = _Mend(mend)
        button.setProperty("role", "mend")
        button.setToolTip(f"{mend}\n{words.text()}")
        button.clicked.connect(lambda _=False: self.mend_asked.emit(problem))
        self._grid.addWidget(button, row + 1, 1, Qt.AlignmentFlag.AlignLeft)
        return button

    def _add_more(self, others: int) -> None:
        button = QPushButton(tr("and {0} more").format(others))
        button.setProperty("role", "mend")
        button.clicked.connect(lambda: self._unfold(button))
        left = Qt.AlignmentFlag.AlignLeft
        self._grid.addWidget(button, self._grid.rowCount(), 1, left)

    def _unfold(self, button: QPushButton) -> None:
        self._unfolded = True
        panel = self.parentWidget()
        assert panel is not None
        around = stops(panel)
        below = around[around.index(button) + 1 :]
        mends = [self._add(problem) for problem in self._shown[SEEN:]]
        # The keyboard goes to the first mend that was not seen, or on to the form.
        goes_to = next(filter(None, (*mends, *below)), None)
        if button.hasFocus() and goes_to is not None:
            goes_to.show()
            goes_to.setFocus(Qt.FocusReason.TabFocusReason)
        button.hide()
        button.deleteLater()


class _Mend(QPushButton):
    """Its words end with … where there is no room: a long mend makes no panel wider."""

    LEAST = 96

    def __init__(self, words: str) -> None:
        super().__init__(words.replace("&", "&&"))
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        return QSize(min(hint.width(), px(self.LEAST)), hint.height())

    def initStyleOption(self, option: QStyleOptionButton) -> None:
        super().initStyleOption(option)
        inside = self.style().subElementRect(QStyle.SubElement.SE_PushButtonContents, option, self)
        room = max(0, inside.width())
        right, keys = Qt.TextElideMode.ElideRight, Qt.TextFlag.TextShowMnemonic
        option.text = self.fontMetrics().elidedText(option.text, right, room, keys)
