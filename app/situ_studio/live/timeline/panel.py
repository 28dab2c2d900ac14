"""The Timeline panel: the drawing over time, and a bar to move in it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QToolButton, QVBoxLayout, QWidget

from situ_studio.live.timeline.bookmarks import Bookmarks
from situ_studio.live.timeline.chart import ZOOM, TimelineChart
from situ_studio.live.timeline.marking import Ask, Marking
from situ_studio.live.timeline.painting import StateName
from situ_studio.live.viewing import Viewing
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.icon_widgets import IconButton, retheme
from situ_studio.wording.language import tr
from situ_studio.wording.lasting import lasting


class Timeline(QWidget):
    """``chart`` is the drawing; everything on the bar has a key there too."""

    def __init__(self, theme: Theme, viewing: Viewing, state_name: StateName, ask: Ask) -> None:
        super().__init__()
        self._viewing = viewing
        self.bookmarks = Bookmarks(self)
        self.chart = TimelineChart(theme, viewing, self.bookmarks, state_name)
        self.marking = Marking(self.chart, self.bookmarks, ask, self)
        self.back = IconButton(theme, "left", tr("To the event before (Left)"))
        self.pause = IconButton(theme, "pause", "")
        self.step = IconButton(theme, "right", tr("To the next event (Right)"))
        self.less = IconButton(theme, "minus", tr("See more time (−)"))
        self.more = IconButton(theme, "plus", tr("See less time, more closely (+)"))
        self.whole = IconButton(theme, "fit", tr("Everything, from the beginning to the end"))
        self.seen = QLabel()
        self.seen.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.seen.setMinimumWidth(px(56))
        self.choices = QMenu(self)
        self.choices.aboutToShow.connect(self._fill_choices)
        self.data = opens(self.choices, tr("Data"), tr("Which data are drawn as curves"))
        tip = tr("Moments with a name; Page Up and Page Down go from one to another")
        self.marks = opens(self.marking.menu, tr("Bookmarks"), tip)
        self._bar = bar = QHBoxLayout()
        bar.setContentsMargins(8, 2, 8, 2)
        bar.setSpacing(4)
        for widget in (self.back, self.pause, self.step):
            bar.addWidget(widget)
        bar.addSpacing(12)
        bar.addWidget(self.data)
        bar.addWidget(self.marks)
        self._openers = bar.count()
        bar.addStretch(1)
        for other in (self.less, self.seen, self.more, self.whole):
            bar.addWidget(other)
        self._column = layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(bar)
        layout.addWidget(self.chart, 1)
        self.back.clicked.connect(lambda: self.chart.step(-1))
        self.step.clicked.connect(lambda: self.chart.step(1))
        self.pause.clicked.connect(self.chart.toggle)
        self.less.clicked.connect(lambda: self.chart.zoom(ZOOM))
        self.more.clicked.connect(lambda: self.chart.zoom(1 / ZOOM))
        self.whole.clicked.connect(self._show_whole)
        self.chart.marked.connect(self._tell_seen)
        viewing.moved.connect(self._tell)
        viewing.exchanged.connect(lambda: self.bookmarks.open(None))
        self.setFocusProxy(self.chart)
        self._tell()
        self._tell_seen()

    def set_theme(self, theme: Theme) -> None:
        retheme(self, theme)
        self.chart.set_theme(theme)

    def add_strip(self, menu: QMenu, words: str, tip: str, strip: QWidget) -> None:
        """A menu more on the bar, and what it is about between the bar and the drawing."""
        self._bar.insertWidget(self._openers, opens(menu, words, tip))
        self._column.insertWidget(1, strip)

    def _show_whole(self) -> None:
        self._viewing.pause()
        self.chart.show_all()

    def _tell(self) -> None:
        if self._viewing.follows:
            self.pause.show_icon("pause", tr("Stay here while the robot goes on (Space)"))
        else:
            self.pause.show_icon("play", tr("To the end, and with it (Space)"))

    def _tell_seen(self) -> None:
        self.seen.setText(_long(self.chart.axis.seen))

    def _fill_choices(self) -> None:
        self.choices.clear()
        shown = {row.name for row in self.chart.rows if row.kind == "data"}
        names = sorted(self._viewing.log.lanes.data)
        if not names:
            self.choices.addAction(tr("The robot has told no numbers yet")).setEnabled(False)
        for name in names:
            # An & would be taken for the key of the entry.
            action = self.choices.addAction(name.replace("&", "&&"))
            action.setCheckable(True)
            action.setChecked(name in shown)
            action.toggled.connect(lambda on, name=name: self._choose(name, on))

    def _choose(self, name: str, on: bool) -> None:
        shown = {row.name for row in self.chart.rows if row.kind == "data"}
        self.chart.choose(frozenset(shown | {name} if on else shown - {name}))


def opens(menu: QMenu, words: str, tip: str) -> QToolButton:
    """A button on the bar that opens a menu."""
    button = QToolButton()
    button.setText(words)
    button.setProperty("role", "opens")
    button.setAccessibleName(words)
    button.setToolTip(tip)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.setMenu(menu)
    return button


def _long(seconds: float) -> str:
    """How much time is seen."""
    return tr("{0} ms").format(f"{seconds * 1000:.3g}") if seconds < 1 else lasting(seconds)
