"""The strip above a timeline that compares: which runs, how they are lined up, where they part."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QPushButton, QVBoxLayout, QWidget

from situ_studio.assistive.announcing import announce
from situ_studio.live.comparing import AGREED, COMMON, START, Comparing, Way
from situ_studio.live.timeline.beside import LETTERS
from situ_studio.live.timeline.panel import opens
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.icon_widgets import Elided, IconButton, retheme
from situ_studio.wording.language import said, tr


class ComparingStrip(QWidget):
    """Shows ``comparing``, and moves from difference to difference; hidden while it has none."""

    swap_asked = Signal(int)
    """That run of those beside shall be the one whose moment all views show."""
    end_asked = Signal()

    def __init__(self, theme: Theme, comparing: Comparing, clock: Callable[[float], str]) -> None:
        super().__init__()
        self._comparing, self._clock = comparing, clock
        self.runs = Elided()
        self.count = QLabel()
        self.count.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.count.setMinimumWidth(px(110))
        self.before = IconButton(theme, "up", tr("To the difference before (Shift+F4)"))
        self.next = QPushButton(tr("Next difference"))
        self.next.setProperty("role", "mend")
        self.next.setToolTip(tr("Where the runs part next after the cursor (F4)"))
        self.menu = QMenu(self)
        self.menu.aboutToShow.connect(self._fill)
        tip = tr("Which moments of the runs stand above one another")
        self.way = opens(self.menu, tr("Line up"), tip)
        self.swap = IconButton(theme, "swap", "")
        self.shown = QMenu(self)
        self.close_ = IconButton(theme, "close", tr("Compare no more"))
        line = QHBoxLayout()
        line.setContentsMargins(12, 0, 8, 2)
        line.setSpacing(8)
        line.addWidget(self.runs, 1)
        for widget in (self.way, self.count, self.before, self.next, self.swap, self.close_):
            line.addWidget(widget)
        self.first, self.second = Elided(role="said"), Elided(role="said")
        row = QHBoxLayout()
        row.setContentsMargins(12, 0, 12, 0)
        row.setSpacing(24)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 4)
        column.setSpacing(2)
        column.addLayout(line)
        column.addLayout(row)
        for told in (self.first, self.second):
            row.addWidget(told, 1)
        self.before.clicked.connect(lambda: comparing.go(-1))
        self.next.clicked.connect(lambda: comparing.go(1))
        self.swap.clicked.connect(self._swap)
        self.close_.clicked.connect(self.end_asked)
        comparing.changed.connect(self._tell)
        self._heard: object = None
        self._tell()

    def set_theme(self, theme: Theme) -> None:
        retheme(self, theme)

    def _tell(self) -> None:
        comparing = self._comparing
        self.setVisible(comparing.goes)
        if not comparing.goes or comparing.own is None:
            return
        names = [comparing.own.name, *(one.name for one in comparing.others)]
        pairs = (tr("{0}: {1}").format(*pair) for pair in zip(LETTERS, names, strict=False))
        self.runs.setText(" · ".join(pairs))
        self._offer_swap()
        self.count.setText(self._count())
        self.before.setEnabled(bool(comparing.marks))
        self.next.setEnabled(bool(comparing.marks))
        parting = comparing.parting()
        for told in (self.first, self.second):
            told.setVisible(parting is not None)
        if parting is not None and comparing.chosen is not None:
            run = comparing.chosen[0]
            ours, theirs = parting.at[0], parting.at[1] - comparing.shifts[run]
            self.first.setText(self._words(0, ours, parting.first))
            self.second.setText(self._words(run + 1, theirs, parting.second))
            if self._heard != comparing.chosen:
                words = (self.count.text(), self.first.text(), self.second.text())
                announce(self, ". ".join(words))
        self._heard = comparing.chosen

    def _offer_swap(self) -> None:
        others = self._comparing.others
        able = any(one.recording is not None for one in others)
        words = tr("Let all views show the other run")
        if not able:
            words = tr("Of the runs beside, none is a recording that all views could show")
        elif len(others) > 1:
            words = tr("Let all views show another of the runs")
        self.swap.show_icon("swap", words)
        self.swap.setEnabled(able)

    def _swap(self) -> None:
        """The other run; one of several is chosen by its letter."""
        others, menu = self._comparing.others, self.shown
        if len(others) == 1:
            self.swap_asked.emit(0)
            return
        menu.clear()
        for run, one in enumerate(others):
            words = tr("{0}: {1}").format(LETTERS[run + 1], one.name).replace("&", "&&")
            action = menu.addAction(words)
            action.setEnabled(one.recording is not None)
            action.triggered.connect(lambda _=False, run=run: self.swap_asked.emit(run))
        menu.popup(self.swap.mapToGlobal(self.swap.rect().bottomLeft()))

    def _words(self, run: int, t: float, done: tuple[str, ...]) -> str:
        what = "; ".join(map(said, done)) or tr("nothing of that")
        return tr("{0}, {1}: {2}").format(LETTERS[run], self._clock(t), what)

    def _count(self) -> str:
        comparing = self._comparing
        if not comparing.ready:
            return tr("Comparing …")
        if not comparing.marks:
            return tr("They did the same.")
        every = len(comparing.marks)
        if comparing.chosen not in comparing.marks:
            return tr("{0} differences").format(every)
        return tr("{0} of {1}").format(comparing.marks.index(comparing.chosen) + 1, every)

    def _fill(self) -> None:
        menu, comparing = self.menu, self._comparing
        menu.clear()
        ways: dict[Way | str, str] = {
            START: tr("At the start"),
            COMMON: tr("At the first thing that both did"),
            AGREED: tr("Where they last did the same, at each difference"),
        }
        named = comparing.bookmarks()
        # An & would be taken for the key of the entry.
        ways |= {name: tr("At the bookmark “{0}”").format(name) for name in named}
        for way, words in ways.items():
            action = menu.addAction(words.replace("&", "&&"))
            action.setCheckable(True)
            action.setChecked(way == comparing.way)
            action.triggered.connect(lambda _=False, way=way: comparing.line_up(way))
        if not named:
            menu.addAction(tr("No bookmark is in all of the runs")).setEnabled(False)
