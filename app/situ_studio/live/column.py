"""The robot at the moment of the cursor, in a column beside the drawing: the situation and what it
rests on, where the applications are, who holds what, and the data.
"""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLineEdit, QSizePolicy, QVBoxLayout, QWidget

from situ.document.spds import Spds
from situ_studio.live.column_list import ColumnList
from situ_studio.live.column_rows import Telling
from situ_studio.live.column_situation import SituationCard
from situ_studio.live.column_words import Words
from situ_studio.live.lanes import Lanes
from situ_studio.live.moment import Moment
from situ_studio.live.timeline.rows import RowKind
from situ_studio.looks.letters import px
from situ_studio.looks.theme import CAPTION, Theme
from situ_studio.panels.blackboard import ago
from situ_studio.panels.header import PanelHeader
from situ_studio.widgets.icon_widgets import IconButton, retheme
from situ_studio.widgets.layouts import rule
from situ_studio.wording.language import tr

FRAME = 50
"""Milliseconds between two drawings at least: nobody reads numbers faster, and the graph beside it
has the frames between for itself."""

StateName = Callable[[str, str], str]


class MomentColumn(QWidget):
    """``header`` is to be the title bar of its dock. Nothing is drawn while nobody sees it."""

    chosen = Signal(str, str)
    """What a row is about: its kind, and its name (of a situation too)."""
    why_asked = Signal(str, str)
    menu_asked = Signal(str, str, QPoint)
    left = Signal()
    """What stood here before is wanted back."""

    def __init__(self, theme: Theme, state_name: StateName) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self._state_name = state_name
        self._telling = Telling(None)
        self._latest: tuple[Moment, float, Lanes] | None = None
        self.header = PanelHeader(tr("Situation"))
        self.back = IconButton(theme, "close", tr("Project, outline and palette again"))
        self.back.clicked.connect(self.left)
        self.since = Words(theme, CAPTION, token="text3", wide=96)
        self.header.add(self.since)
        self.header.add(self.back)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.card = SituationCard(theme)
        around = QWidget()
        line = QVBoxLayout(around)
        line.setContentsMargins(12, 0, 12, 12)
        line.addWidget(self.card)
        self._around = around
        column.addWidget(around)
        self.states = ColumnList(theme, tr("Applications"))
        self.resources = ColumnList(theme, tr("Who holds what"))
        self.data = ColumnList(theme, tr("Blackboard"))
        self._above: dict[ColumnList, tuple[QWidget, QWidget]] = {}
        self._section(column, tr("Applications"), self.states)
        self._section(column, tr("Who holds what"), self.resources)
        head = self._section(column, tr("Blackboard"), self.data)
        self.search = IconButton(theme, "search", tr("Find in the data"), "text3", 14)
        self.search.clicked.connect(self._toggle_search)
        head.addWidget(self.search)
        self.wanted = QLineEdit()
        self.wanted.setPlaceholderText(tr("Find a tag"))
        self.wanted.setAccessibleName(tr("Find in the data"))
        self.wanted.setClearButtonEnabled(True)
        self.wanted.textChanged.connect(lambda _: self.draw())
        self.wanted.hide()
        column.insertWidget(column.indexOf(self.data), self.wanted)
        column.setStretchFactor(self.data, 1)
        self._lists: dict[RowKind, ColumnList] = {
            "state": self.states,
            "resource": self.resources,
            "data": self.data,
        }
        for kind, rows in self._lists.items():
            rows.chosen.connect(lambda name, kind=kind: self.chosen.emit(kind, name))
            rows.why_asked.connect(lambda name, kind=kind: self.why_asked.emit(kind, name))
            rows.menu_asked.connect(
                lambda name, at, kind=kind: self.menu_asked.emit(kind, name, at)
            )
        self.card.chosen.connect(lambda: self.chosen.emit("situation", self._situation))
        self.card.why_asked.connect(lambda: self.why_asked.emit("situation", self._situation))
        self.card.menu_asked.connect(
            lambda at: self.menu_asked.emit("situation", self._situation, at)
        )
        self._frame = QTimer(self)
        self._frame.setSingleShot(True)
        self._frame.setInterval(FRAME)
        self._frame.timeout.connect(self._on_frame)
        self._waits = False

    def _section(self, column: QVBoxLayout, title: str, rows: ColumnList) -> QHBoxLayout:
        head = QWidget()
        line = QHBoxLayout(head)
        line.setContentsMargins(12, 0, 8, 0)
        line.setSpacing(4)
        head.setFixedHeight(px(30))
        words = QLabel(title)
        words.setProperty("role", "heading")
        line.addWidget(words, 1)
        above = rule()
        column.addWidget(above)
        column.addWidget(head)
        column.addWidget(rows)
        self._above[rows] = (above, head)
        if rows is not self.data:
            rows.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)
        return line

    def _show_section(self, rows: ColumnList, headed: bool = True) -> None:
        """A section is there while it has rows. headed: it has a heading of its own."""
        there = bool(rows.rows.names)
        for widget, shown in (
            (rows, there),
            *((one, there and headed) for one in self._above[rows]),
        ):
            if widget.isHidden() == shown:
                widget.setVisible(shown)

    def set_theme(self, theme: Theme) -> None:
        retheme(self, theme)
        self.card.set_theme(theme)
        retheme(self.header, theme)
        self.since.theme = theme
        for rows in self._lists.values():
            rows.set_theme(theme)

    @property
    def _situation(self) -> str:
        moment = self._latest[0] if self._latest is not None else None
        return (moment.situation or "") if moment is not None else ""

    @property
    def asked_about(self) -> tuple[RowKind, str] | None:
        """What has the keyboard here."""
        if self.card.hasFocus():
            return "situation", self._situation
        for kind, rows in self._lists.items():
            if rows.hasFocus() and rows.current_name is not None:
                return kind, rows.current_name
        return None

    @property
    def below_focus(self) -> QPoint:
        """Where on the screen a menu opens for what has the keyboard."""
        for rows in self._lists.values():
            if rows.hasFocus():
                at = rows.visualRect(rows.currentIndex()).bottomLeft()
                return rows.viewport().mapToGlobal(at)
        return self.card.mapToGlobal(self.card.rect().bottomLeft())

    # -- what is shown -----------------------------------------------------------------

    def show_moment(self, moment: Moment, t: float, lanes: Lanes, script: Spds | None) -> None:
        """The robot at ``t`` seconds of a run. lanes: of the whole run; script: what it runs by."""
        if script is not self._telling.script:
            self._telling = Telling(script)
        self._latest = (moment, t, lanes)
        if not self.isVisible():
            return
        if self._frame.isActive():
            self._waits = True
        else:
            self.draw()
            self._frame.start()

    def _on_frame(self) -> None:
        if self._waits:
            self._waits = False
            self.draw()
            self._frame.start()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.draw()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._waits = False

    def draw(self) -> None:
        """Shows the latest moment that it was told."""
        if self._latest is None or not self.isVisible():
            return
        telling, (moment, t, lanes) = self._telling, self._latest
        told = telling.situation(moment, t)
        self._around.setVisible(told is not None)
        scripted = told is not None or telling.script is not None
        head = tr("Situation") if scripted else tr("Applications")
        if self.header.title.text() != head:
            self.header.title.setText(head)
        since = ""
        if told is not None:
            self.card.show_told(told)
            since = tr("since {0}").format(ago(t - moment.situation_since))
        self.since.setVisible(told is not None)
        self.since.show_words(since)
        self.states.show_rows(
            sorted(moment.applications),
            lambda name: telling.state(name, moment, t, self._state_name),
        )
        self.resources.show_rows(
            telling.resources(moment), lambda name: telling.resource(name, moment, t)
        )
        self._show_section(self.states, scripted)
        self._show_section(self.resources)
        found = self.wanted.text().strip() if self.wanted.isVisible() else ""
        self.data.show_rows(
            telling.tags(moment, found), lambda name: telling.tag(name, moment, t, lanes)
        )

    def _toggle_search(self) -> None:
        self.wanted.setVisible(self.wanted.isHidden())
        if self.wanted.isVisible():
            self.wanted.setFocus(Qt.FocusReason.OtherFocusReason)
        else:
            self.wanted.clear()
        self.draw()
