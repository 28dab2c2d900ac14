"""The status bar's part about the link: to where, as whom, how much comes; the rest at a click."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QPushButton, QWidget

from situ import __version__
from situ_studio.live.moment import TraceFields
from situ_studio.looks.letters import px
from situ_studio.widgets.layouts import clear
from situ_studio.wording.language import tr

if TYPE_CHECKING:
    from situ.blackboard.replies import Turns
    from situ_studio.window.main_window import MainWindow

OVER = 2.0
"""Seconds over which events are counted."""
EACH = 500
"""Milliseconds between two countings."""


class Rate:
    """How many events come in a second, as counted over the last ones."""

    def __init__(self) -> None:
        self._came: deque[tuple[float, int]] = deque()

    def add(self, now: float, count: int) -> None:
        self._came.append((now, count))
        self.at(now)

    def at(self, now: float) -> float:
        while self._came and self._came[0][0] <= now - OVER:
            self._came.popleft()
        return sum(count for _, count in self._came) / OVER


class LinkStatus(QObject):
    """Of one window; there while there is a link. ``button`` opens what else is known of it."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._link = window.robot.link
        self._rate = Rate()
        self.version: int | None = None
        """Of the robot's documents; 0 is what it was started with, None is not known."""
        self.button = QPushButton()
        self.button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.button.setToolTip(self.tr("What is known of the robot and of the link to it"))
        self.button.clicked.connect(self.open)
        self.right = QWidget()
        line = QHBoxLayout(self.right)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(16)
        self.rate, self.version_label = QLabel(), QLabel()
        line.addWidget(self.rate)
        line.addWidget(self.version_label)
        window.status.add_to_link(self.button, self.right)
        self.popup = LinkPopup(window)
        self._timer = QTimer(self)
        self._timer.setInterval(EACH)
        self._timer.timeout.connect(self._tell)
        self._found = 0
        self._link.state_changed.connect(self._on_state)
        self._link.came.connect(self._on_came)
        self._on_state()

    # -- the robot ---------------------------------------------------------------------

    def _on_state(self) -> None:
        link = self._link
        if not link.connected:
            self._timer.stop()
            self._rate = Rate()
            self.version = None
        elif not self._timer.isActive() or link.found != self._found:
            self._found = link.found
            self._timer.start()
            self._ask_version()
        self._tell()

    def _on_came(self, events: list[TraceFields]) -> None:
        self._rate.add(self._link.clock(), len(events))
        if any(event["kind"] == "deployed" for event in events):
            self._ask_version()

    def _ask_version(self) -> None:
        from situ.blackboard import sending

        def told(turns: Turns) -> None:
            self.version = turns.version
            self._tell()

        self._link.ask(self, sending.history, told, lambda _: None)

    # -- words -------------------------------------------------------------------------

    @property
    def role(self) -> str:
        """As whom the robot knows us."""
        return self.tr("viewer") if self._link.state.looks_only else self.tr("operator")

    def _tell(self) -> None:
        state, connected = self._link.state, self._link.connected
        words = state.endpoint
        if connected:
            words = self.tr("{0}, {1}").format(state.endpoint, self.role)
        self.button.setVisible(state.kind not in ("none", "connecting"))
        self.button.setText(words)
        self.button.setAccessibleName(self.tr("About the link: {0}").format(words))
        self.right.setVisible(connected)
        self.rate.setText(self._events)
        self.version_label.setText(self._version)
        self.version_label.setVisible(bool(self.version))
        if self.popup.isVisible():
            self.popup.show_facts(self.facts())

    @property
    def _events(self) -> str:
        return self.tr("{0} events/s").format(f"{self._rate.at(self._link.clock()):.0f}")

    @property
    def _version(self) -> str:
        return self.tr("Version {0}").format(self.version) if self.version else ""

    @property
    def _situ(self) -> str:
        """Which Situ the robot runs, beside the one here."""
        theirs = self._link.situ
        if theirs is None:
            return self.tr("not told; an older one")
        if theirs == __version__:
            return self.tr("{0}, as here").format(theirs)
        return self.tr("{0}; here it is {1}").format(theirs, __version__)

    def facts(self) -> list[tuple[str, str]]:
        """What is known, each with its name."""
        link, follower = self._link, self._window.robot.follower
        state = link.state
        told = [
            (self.tr("Address"), state.endpoint),
            (self.tr("Project"), state.project),
            (self.tr("Link"), state.words(link.clock())),
        ]
        if not link.connected:
            return [one for one in told if one[1]]
        person = (link.writer or "").removeprefix("operator:")
        role = f"{self.role} {person}".strip()
        if link.looks_only:
            role = self.tr("{0}: you can look only").format(role)
        told.append((self.tr("You are"), role))
        if self.version is not None:
            given = self.tr("the project that it was started with")
            version = self.tr("version {0}").format(self.version) if self.version else given
            told.append((self.tr("It runs"), version))
        told.append((self.tr("Its Situ"), self._situ))
        different = follower.different(link.files)
        if different is None:
            said = self.tr("not known yet")
        elif different:
            said = self.tr("differ from these here: {0}").format(", ".join(different))
        else:
            said = self.tr("the same as here")
        return [
            *told,
            (self.tr("Its documents"), said),
            (self.tr("It tells"), self._events),
            (self.tr("Events kept"), f"{len(link.log):,}"),
        ]

    def open(self) -> None:
        """Shows all that is known above the button."""
        self.popup.show_facts(self.facts())
        self.popup.adjustSize()
        above = self.button.mapToGlobal(QPoint(0, -self.popup.height() - px(4)))
        self.popup.move(above)
        self.popup.show()
        self.popup.setFocus()


class LinkPopup(QFrame):
    """Names and what they are, until something else is done."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window, Qt.WindowType.Popup)
        self.setProperty("role", "popup")
        self.setAccessibleName(tr("About the link"))
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(14, 12, 14, 12)
        self._grid.setHorizontalSpacing(16)
        self._grid.setVerticalSpacing(6)
        self._shown: list[tuple[str, str]] = []
        self._values: list[QLabel] = []

    def show_facts(self, facts: list[tuple[str, str]]) -> None:
        """The rows stay where only their words are others."""
        if [name for name, _ in facts] != [name for name, _ in self._shown]:
            clear(self._grid)
            self._values = []
            for row, (name, _) in enumerate(facts):
                title, value = QLabel(name), QLabel()
                title.setProperty("role", "label")
                value.setProperty("role", "under")
                value.setTextFormat(Qt.TextFormat.PlainText)
                value.setWordWrap(True)
                value.setFixedWidth(px(280))
                value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
                top = Qt.AlignmentFlag.AlignTop
                self._grid.addWidget(title, row, 0, top)
                self._grid.addWidget(value, row, 1, top)
                self._values.append(value)
        self._shown = facts
        for value, (name, words) in zip(self._values, facts, strict=True):
            if value.text() != words:
                value.setText(words)
                value.setAccessibleName(f"{name}: {words}")
        self.setAccessibleDescription(". ".join(f"{name}: {words}" for name, words in facts))
