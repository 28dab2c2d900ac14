"""Brings what a robot does into a window: graphs, panels and status bar.

Everything live is drawn from the log's moment and the document; nothing live ever
changes a document.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer, Signal

from situ.document import codec
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.edits.edit import Document
from situ_studio.live.link import RobotLink
from situ_studio.live.log import TraceLog
from situ_studio.live.moment import ApplicationMoment, Moment, TraceFields
from situ_studio.live.recordings import Recording
from situ_studio.live.viewing import Viewing
from situ_studio.live.views import Runs, live_part, live_script, live_view, runs_of
from situ_studio.panels.authority import Authority
from situ_studio.panels.blackboard import Blackboard
from situ_studio.panels.trace import Trace

FRAME = 16
"""Milliseconds in which events are gathered before they are drawn."""
TICK = 250
"""Milliseconds between redraws while nothing comes: times go on, a loss grows older."""


class Followed(Protocol):
    """What a follower needs of its window."""

    def live_documents(self) -> dict[str, Document]:
        """Every open document by file."""

    def live_project(self) -> Project | None:
        """The open project; None while there is none."""

    def show_live(self, file: str, live: LiveView | LiveScript | None) -> None:
        """Lets the graph of a document glow; None: it is as drawn."""

    def show_link(self, kind: str, words: str) -> None:
        """kind: as ``LinkState.kind``; words: as a designer reads them."""


class Follower(QObject):
    """Follows one link for one window. ``panels`` are its tables, to be put into tabs."""

    refreshed = Signal(object, float)
    """The moment that all views show now, and when that is."""

    def __init__(
        self,
        window: Followed,
        link: RobotLink,
        blackboard: Blackboard,
        authority: Authority,
        trace: Trace,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._window = window
        self._link = link
        self._blackboard = blackboard
        self._authority = authority
        self._trace = trace
        self._told = self._at = self._reached = 0.0
        self.viewing = Viewing(link.log, self)
        self.viewing.show(link.log, self._end)
        self.viewing.moved.connect(self.refresh)
        trace.watch(self.viewing)
        self._recording: Recording | None = None
        self._rehearses = False
        self._painted: Mapping[str, LiveView | LiveScript] | None = None
        self.same: bool | None = None
        self._runs: tuple[Project | None, Runs] = (None, {})
        self._read: tuple[dict[str, str] | None, dict[str, Document | None]] = (None, {})
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(FRAME)
        self._soon.timeout.connect(self.refresh)
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.setInterval(TICK)
        self._later.timeout.connect(self.refresh)
        self._tick = QTimer(self)
        self._tick.setInterval(TICK)
        self._tick.timeout.connect(self.refresh)
        link.state_changed.connect(self._on_state)
        link.moment_changed.connect(self._on_moment)
        link.began_anew.connect(self._on_began_anew)
        link.documents_came.connect(self.compare)

    def show_recording(self, recording: Recording) -> None:
        """All views show that run, from its beginning."""
        self._recording, self._rehearses = recording, False
        self._painted = None
        self.viewing.show(recording.log)
        self.viewing.seek(recording.log.lanes.start)
        self.compare()

    def show_rehearsal(self, log: TraceLog, end: Callable[[], float]) -> None:
        """All views show that run, as it goes on. end: its time now."""
        self._recording, self._rehearses = None, True
        self._painted = None
        self.viewing.show(log, end)
        self.compare()

    def take_rehearsed(self, events: list[TraceFields]) -> None:
        """The rehearsal that is shown has gone on; its time alone is drawn four times a second."""
        if events:
            self._trace.go_on()
        timer = self._soon if events else self._later
        if not timer.isActive():
            timer.start()

    def show_link(self) -> None:
        """All views show the link's robot again; as drawn where there is none."""
        self._recording, self._rehearses = None, False
        self._painted = None
        self.viewing.show(self._link.log, self._end)
        self.compare()
        self._on_state()

    @property
    def _files(self) -> dict[str, str] | None:
        """The documents of who is looked at; None where they are the open ones, or not known."""
        if self._rehearses:
            return None
        return self._recording.files if self._recording is not None else self._link.files

    def paint(self, painted: Mapping[str, LiveView | LiveScript] | None) -> None:
        """The drawings show that, by file, instead of a moment; None: the moment again."""
        self._painted = painted
        if painted is None and not self.shows:
            self._on_state()
        self.refresh()

    def compare(self) -> None:
        """Whether the open documents are the robot's own; it has none of what only an editor needs,
        so the drawing does not count."""
        different = self.different(self._files)
        self.same = None if different is None else not different
        self._tell()

    def different(self, files: dict[str, str] | None) -> list[str] | None:
        """The open documents that are others in those files; None where these are not known."""
        if files is None:
            return None
        return [
            file
            for file, document in self._window.live_documents().items()
            if file not in files or self._theirs(files, file) != document
        ]

    def _theirs(self, files: dict[str, str], file: str) -> Document | None:
        """A document of the robot's: read once, for every edit here is compared with it."""
        if files is not self._read[0]:
            self._read = files, {}
        read = self._read[1]
        if file not in read:
            read[file] = codec.read(files[file].encode(), file)[0]
        return read[file]

    def refresh(self) -> None:
        """Draws the moment as it is now, with all that came by now: it is drawn once a frame."""
        self._soon.stop()
        self._later.stop()
        self._tell()
        for file, live in (self._painted or {}).items():
            self._window.show_live(file, live)
        if not self.shows:
            return
        moment, t = self.viewing.moment(), self.viewing.t
        documents = self._window.live_documents() if self._painted is None else {}
        for file, document in documents.items():
            if isinstance(document, Application):
                self._window.show_live(file, self._live(file, document, moment, t))
            elif isinstance(document, Spds):
                self._window.show_live(file, live_script(moment))
        self._blackboard.show_moment(moment, t)
        self._authority.show_moment(moment, t)
        self._trace.go_on()
        self.refreshed.emit(moment, t)

    def _live(self, file: str, document: Application, moment: Moment, t: float) -> LiveView:
        project = self._window.live_project()
        if project is None or file not in project.parts:
            mine = moment.applications.get(document.name, ApplicationMoment())
            live = live_view(document, mine, t)
        else:
            if project is not self._runs[0]:
                self._runs = project, runs_of(project)
            live = live_part(document, moment, self._runs[1].get(file, ()), t)
        return replace(live, since=self.viewing.begun) if self.viewing.log.late else live

    @property
    def rehearses(self) -> bool:
        """Whether it is a rehearsal that all views show."""
        return self._rehearses

    @property
    def shows(self) -> bool:
        """Whether there is anything live to be shown: a robot, or a log that is looked at."""
        looked_at = self._recording is not None or self._rehearses
        return self._link.state.kind != "none" or looked_at

    def _end(self) -> float:
        """The robot's time now: while nothing comes it goes on all the same, until it is lost."""
        t = self._link.log.now.t
        if not self._link.connected:
            return max(t, self._reached)
        self._reached = t + max(self._link.clock() - self._at, 0.0)
        return self._reached

    def _on_moment(self) -> None:
        t = self._link.log.now.t
        # What stands there, and what its clock says, is told without an event.
        if t != self._told:
            self._told, self._at = t, self._link.clock()
        if not self._soon.isActive():
            self._soon.start()

    def _on_began_anew(self) -> None:
        """No moment of the run before is kept: neither cursor nor bookmarks can stay there."""
        # Its events may all have been at 0, and then none of them begins its time.
        self._told, self._at, self._reached = 0.0, self._link.clock(), 0.0
        if self.viewing.log is self._link.log:
            self.viewing.show(self._link.log, self._end)

    def _on_state(self) -> None:
        if self._link.state.kind == "none" and not self._rehearses:
            self._soon.stop()
            self._tick.stop()
            self._later.stop()
        if not self.shows:
            self.same = None
            for file in self._window.live_documents():
                self._window.show_live(file, None)
        elif self._recording is None and not self._tick.isActive():
            self._tick.start()
        self._tell()

    def _beside(self) -> str:
        """The robot that a link leads to while something else is looked at."""
        state, paused = self._link.state, self._link.log.now.applications
        words = state.words(self._link.clock())
        if not self._link.connected:
            return self.tr("robot: {0}").format(words)
        project = state.project or state.endpoint
        names = [name for name, one in paused.items() if one.paused]
        if names:
            return self.tr("{0} of {1} is paused").format(", ".join(names), project)
        return self.tr("{0} is connected").format(project)

    def _lacking(self) -> str:
        """What is not known of the run that is looked at."""
        log, words = self.viewing.log, ""
        if not self.shows:
            return words
        if log.lacks:
            words += self.tr(", known since {0}").format(self.viewing.begun)
        if log.gaps:
            missed = sum(gap.count for gap in log.gaps)
            words += self.tr(", {0} events missed").format(f"{missed:,}")
        return words

    def _compared(self) -> str:
        """Whether what is open here is what runs, or ran."""
        if self.same is None:
            return ""
        if self.same:
            recorded = self._recording is not None
            return self.tr(", same as it ran") if recorded else self.tr(", same as the robot")
        recording, own = self._recording, self._window.live_project()
        theirs = recording.project if recording is not None else self._link.state.project
        if own is not None and theirs and theirs != own.name:
            return self.tr(", project {0}, not {1}").format(theirs, own.name)
        return self.tr(", differs here")

    def _tell(self) -> None:
        state, viewing = self._link.state, self.viewing
        kind, words = state.kind, state.words(self._link.clock())
        if self._recording is not None:
            kind = "replaying"
            words = self.tr("{0}, {1}").format(self._recording.path.name, viewing.clock())
        elif self._rehearses:
            kind = "rehearsing"
            words = self.tr("rehearsing, {0:.1f} s").format(viewing.t)
            if state.kind != "none":
                words = self.tr("{0}; {1}").format(words, self._beside())
        elif not viewing.follows and kind != "none":
            kind, words = "replaying", self.tr("replaying {0}").format(viewing.clock())
        words += self._lacking()
        if kind in ("live", "replaying"):
            words += self._compared()
        if kind == "replaying" and state.kind not in ("none", "live"):
            words = self.tr("{0}; {1}").format(words, self._beside())
        self._window.show_link(kind, words)
