"""A window's comparing: another run is put below the one that its timeline shows."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec.structs import replace
from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QMenu

from situ.errors import UsageError
from situ_studio.edits.words import running_state
from situ_studio.live.chosen_recording import ChosenRecording
from situ_studio.live.comparing import Compared, Comparing
from situ_studio.live.comparing_projects import RecordedProjects
from situ_studio.live.comparing_strip import ComparingStrip
from situ_studio.live.log import TraceLog
from situ_studio.live.recordings import Recording
from situ_studio.live.timeline.beside import LETTERS, Marked, RunBeside
from situ_studio.live.timeline.bookmarks import Bookmark, Bookmarks, beside
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme

if TYPE_CHECKING:
    from situ_studio.live.robot import RobotSide
    from situ_studio.window.main_window import MainWindow

PANEL = "timeline"
ROOM = 420
"""Px that a timeline of two runs gets at least, where the window has them."""


class ComparingSide(QObject):
    """``menu`` offers what can be put beside: a recording, or what was looked at before."""

    def __init__(self, window: MainWindow, robot: RobotSide) -> None:
        super().__init__(window)
        self._window, self._robot = window, robot
        viewing, timeline = robot.follower.viewing, robot.timeline
        self._chart, self._bookmarks = timeline.chart, timeline.bookmarks
        self.comparing = Comparing(viewing, self)
        self.strip = ComparingStrip(window.theme, self.comparing, self._chart.clock)
        self.menu = QMenu(window)
        self.menu.aboutToShow.connect(self._fill)
        timeline.add_strip(
            self.menu,
            self.tr("Compare"),
            self.tr("Another run below this one, and where they part"),
            self.strip,
        )
        self._seen: list[tuple[TraceLog, str, Recording | None]] = []
        """The runs that were looked at last, what they are called; the one of now first."""
        self._runs: tuple[RunBeside, ...] = ()
        self._shown: list[Compared] = []
        self._chosen = ChosenRecording(window, self)
        self._chosen.read.connect(self._add_recording)
        self._projects = RecordedProjects(self)
        self._projects.read.connect(self.comparing.know)
        self.strip.swap_asked.connect(self.swap)
        self.strip.end_asked.connect(self.end)
        comparing = self.comparing
        comparing.changed.connect(self._show)
        comparing.ended.connect(self._on_ended)
        comparing.failed.connect(self._on_failed)
        viewing.exchanged.connect(self.end)
        self._bookmarks.changed.connect(lambda: comparing.mark(self._bookmarks.every))
        self._remember()

    def set_theme(self, theme: Theme) -> None:
        self.strip.set_theme(theme)

    # -- which runs ----------------------------------------------------------------------

    def can_compare(self) -> bool:
        """Whether a run is looked at, and there is room for one more beside it."""
        return self._robot.follower.shows and len(self.comparing.others) + 1 < len(LETTERS)

    def compare(self) -> None:
        """Asks for a recording, and puts it below what is looked at."""
        path = self._window.dialogs.recording()
        if path is not None:
            self.compare_with(path)

    def compare_with(self, path: Path) -> None:
        """Reads the recording and puts it below what is looked at."""
        self._chosen.start(path)

    def swap(self, run: int) -> None:
        """All views show that run of those beside, at the same moment, and what they showed stands
        where it was. Nothing where it is no recording: a robot goes on, a rehearsal has ended.
        """
        comparing, viewing = self.comparing, self._robot.follower.viewing
        own, others, way = comparing.own, list(comparing.others), comparing.way
        recording = others[run].recording
        if own is None or recording is None:
            return
        t = viewing.t + comparing.shifts[run]
        others[run] = own
        self._robot.show_recording(recording)
        viewing.seek(t)
        comparing.line_up(way)
        for one in others:
            self._add(one.log, one.name, one.recording)

    def move_to(self, other: ComparingSide) -> None:
        """What stands beside, or is being read to stand there, does so in a window in place of this
        one.
        """
        other._seen = list(self._seen)
        for one in self.comparing.others:
            other._add(one.log, one.name, one.recording)
        other.comparing.line_up(self.comparing.way)
        self._chosen.move_to(other._chosen)

    def end(self) -> None:
        """The timeline shows one run only."""
        self._chosen.cancel()
        self._projects.end()
        self._remember()
        self.comparing.end()

    def _remember(self) -> None:
        log, recording = self._robot.follower.viewing.log, self._robot.recording
        if recording is not None and recording.log is not log:
            recording = None
        if recording is not None:
            name = recording.path.name
        else:
            robots = log is self._robot.link.log
            name = self.tr("the robot") if robots else self.tr("the rehearsal")
        others = [seen for seen in self._seen if seen[0] is not log]
        self._seen = [(log, name, recording), *others][:3]

    def _fill(self) -> None:
        menu = self.menu
        menu.clear()
        menu.addAction(self.tr("With a recording…")).triggered.connect(self.compare)
        self._remember()
        for log, name, recording in self._seen[1:]:
            if not len(log):
                continue
            words = self.tr("With {0}").format(name).replace("&", "&&")
            menu.addAction(words).triggered.connect(
                lambda _=False, log=log, name=name, recording=recording: self._add(
                    log, name, recording
                )
            )
        for action in menu.actions():
            action.setEnabled(self.can_compare())
        if self.comparing.goes:
            menu.addSeparator()
            menu.addAction(self.tr("Compare no more")).triggered.connect(self.end)

    def _compared(self, log: TraceLog, name: str, recording: Recording | None) -> Compared:
        project = self._window.session.project
        if recording is None:
            return Compared(name, log, project)
        theirs = self._projects.of(recording)
        return Compared(name, log, theirs or project, _bookmarks(recording.path), recording)

    def _add_recording(self, recording: Recording) -> None:
        self._add(recording.log, recording.path.name, recording)

    def _add(self, log: TraceLog, name: str, recording: Recording | None) -> None:
        self._remember()
        own = replace(self._compared(*self._seen[0]), bookmarks=tuple(self._bookmarks.every))
        self.comparing.add(own, self._compared(log, name, recording))
        self._window.bottom.choose(PANEL)
        self._make_room()
        self._chart.show_all()

    def _make_room(self) -> None:
        """Rows of two runs want more of it."""
        dock = self._window.docks["bottom"]
        room = min(px(ROOM), self._window.height() * 9 // 20)
        if dock.height() < room:
            self._window.resizeDocks([dock], [room], Qt.Orientation.Vertical)

    # -- from difference to difference ---------------------------------------------------

    def next(self, by: int) -> None:
        """To the next difference, or the one before: ``by`` is 1 or -1."""
        bottom = self._window.bottom
        if bottom.current != PANEL or bottom.is_folded:
            bottom.choose(PANEL)
        self.comparing.go(by)

    def _on_ended(self, by: int) -> None:
        further = self.tr("No difference comes after this.")
        self._window.say(further if by > 0 else self.tr("No difference comes before this."))

    def _on_failed(self) -> None:
        self.end()
        self._window.dialogs.tell(
            self.tr("The runs could not be compared; what happened is in studio.log.")
        )

    def _show(self) -> None:
        """The runs beside, as they are lined up, and where they part, into the timeline."""
        comparing, theme = self.comparing, self._window.theme
        if self._shown != comparing.others:
            self._shown = list(comparing.others)
            self._runs = tuple(
                RunBeside(one.log, theme, partial(running_state, one.project))
                for one in comparing.others
            )
        for run, shift, one in zip(self._runs, comparing.shifts, comparing.others, strict=True):
            run.shift, run.bookmarks = shift, one.bookmarks
        marks = tuple(
            Marked(run + 1, difference, comparing.chosen == (run, difference))
            for run, difference in comparing.marks
        )
        self._chart.show_beside(self._runs, marks)
        self._window.actions_.refresh()


def _bookmarks(recording: Path) -> tuple[Bookmark, ...]:
    """Those that lie beside a recording; none where they can not be read."""
    every = Bookmarks()
    try:
        every.open(beside(recording))
    except UsageError:
        return ()
    return tuple(every.every)
