"""The robot's side of a window: its link, what follows it, and the commands about it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from situ.document.project import Project
from situ.errors import SituError, UsageError
from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.edits.edit import Document
from situ_studio.edits.words import running_state
from situ_studio.live.chosen_recording import ChosenRecording
from situ_studio.live.comparing_side import ComparingSide
from situ_studio.live.follower import Follower
from situ_studio.live.following import FollowMode
from situ_studio.live.link import RobotLink
from situ_studio.live.recordings import Recording
from situ_studio.live.saving_recording import SavingRecording
from situ_studio.live.telling import SituationTelling
from situ_studio.live.timeline.bookmarks import beside
from situ_studio.live.timeline.panel import Timeline
from situ_studio.looks.theme import Theme
from situ_studio.panels.authority import Authority
from situ_studio.panels.blackboard import Blackboard
from situ_studio.panels.trace import Trace
from situ_studio.panels.trace_kinds import TraceKinds
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

PANELS = ("blackboard", "timeline", "authority", "trace")
USUAL = "tcp://127.0.0.1:5570"


class RobotSide(QObject):
    """One window's link to a robot; ``link`` is there from the start, connected or not."""

    settled = Signal()
    """What there is to be looked at may be something else."""

    def __init__(self, window: MainWindow, link: RobotLink | None = None) -> None:
        super().__init__(window)
        self._window = window
        self.following = FollowMode(window)
        self.link = link or RobotLink()
        self.link.setParent(self)
        theme = window.theme
        self.blackboard, self.authority, self.trace = (
            Blackboard(theme),
            Authority(theme),
            Trace(theme),
        )
        self.follower = Follower(self, self.link, self.blackboard, self.authority, self.trace, self)
        SituationTelling(self.follower, window.status.announcements.tell)
        self.timeline = Timeline(
            theme, self.follower.viewing, self.state_name, self._ask_for_bookmark
        )
        self.timeline.marking.refused.connect(lambda why: window.dialogs.tell(why))
        titles = (
            self.tr("Blackboard"),
            self.tr("Timeline"),
            self.tr("Authority"),
            self.tr("Trace"),
        )
        self.kinds = TraceKinds(self.trace)
        shown = (*self.panels[:-1], self.kinds)
        for name, title, panel in zip(PANELS, titles, shown, strict=True):
            window.bottom.add(name, title, panel)
            window.bottom.set_shown(name, False)
        self.recording: Recording | None = None
        """The one that is looked at, instead of the robot."""
        self.chosen = ChosenRecording(window, self)
        self.chosen.read.connect(self.show_recording)
        self.saving = SavingRecording(window, self)
        self.comparing = ComparingSide(window, self)
        self.link.state_changed.connect(self.settle)
        window.session.changed.connect(self._on_changed)
        window.session.opened.connect(self.follower.compare)

    @property
    def panels(self) -> tuple[Blackboard, Timeline, Authority, Trace]:
        return self.blackboard, self.timeline, self.authority, self.trace

    @property
    def connected(self) -> bool:
        """Whether there is a link, if only one that tries."""
        return self.link.state.kind != "none"

    def ask(self) -> None:
        """Asks for an address and connects."""
        project = self._window.session.project
        usual = project.endpoint if project is not None else USUAL
        window = self._window
        chosen = window.dialogs.robot(usual)
        if chosen is None:
            return
        try:
            self.connect_robot(chosen.endpoint, chosen.key)
        except SituError as error:
            window.dialogs.tell(said(str(error)))

    def connect_robot(self, endpoint: str, key: str = "") -> None:
        """As ``RobotLink.connect_robot``, with what it raises."""
        self.close_recording()
        self.link.connect_robot(endpoint, key)

    def disconnect_robot(self) -> None:
        self.link.disconnect_robot()

    def set_theme(self, theme: Theme) -> None:
        for panel in self.panels:
            panel.set_theme(theme)
        self.comparing.set_theme(theme)

    # -- recordings ----------------------------------------------------------

    def open_recording(self, path: Path) -> None:
        """Reads it, and lets all views show it from its beginning."""
        self.chosen.start(path)

    def close_recording(self) -> None:
        """The views show the robot again, if there is one."""
        self.chosen.cancel()
        if self.recording is not None:
            self.recording = None
            self.follower.show_link()
            self.settle()

    def show_recording(self, recording: Recording) -> None:
        """All views show that run, instead of the robot."""
        self.disconnect_robot()
        self.recording = recording
        self.follower.show_recording(recording)
        try:
            self.timeline.bookmarks.open(beside(recording.path))
        except UsageError as error:
            self._window.dialogs.tell(said(str(error)))
        if notice := recording.notice():
            self._window.say(notice)
        self.settle()

    def _ask_for_bookmark(self, usual: str) -> str | None:
        return self._window.dialogs.name(self.tr("Bookmark"), self.tr("Name"), usual)

    # -- what the follower needs ---------------------------------------------

    def live_documents(self) -> dict[str, Document]:
        session = self._window.session
        found = {file: session.document(file) for file in session.files}
        return {file: document for file, document in found.items() if document is not None}

    def live_project(self) -> Project | None:
        return self._window.session.project

    def state_name(self, application: str, state: str) -> str:
        """By number and name, as the open project has it: in what is told of traces too."""
        return running_state(self._window.session.project, application, state)

    def show_live(self, file: str, live: LiveView | LiveScript | None) -> None:
        for view in self._window.sides.views_of(file):
            view.set_live(live)
            self.following.bring(view, live)

    def show_link(self, kind: str, words: str) -> None:
        live = {"live": "true", "lost": "lost", "refused": "lost"}.get(kind, "")
        icon = "unlink" if kind in ("none", "refused") else "link"
        self._window.status.show_link(icon, words, live)

    def _on_changed(self, _: str) -> None:
        self.follower.compare()

    def settle(self) -> None:
        """The robot's panels are there while there is something live."""
        for name in PANELS:
            self._window.bottom.set_shown(name, self.follower.shows)
        self.settled.emit()
        self._window.actions_.refresh()
