"""The window's part of a rehearsal: its desk at the right, and every live view shows it."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt

from situ.document import beside
from situ.document.check import structure
from situ.document.folder import resolve
from situ.document.project import Project
from situ_studio.edits.edit import write
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.header import PanelHeader
from situ_studio.rehearsing.course import Version
from situ_studio.rehearsing.desk import WIDE, Desk
from situ_studio.rehearsing.running import Running
from situ_studio.rehearsing.saving import SavingScenario
from situ_studio.widgets.icon_widgets import IconButton

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

DOCK = "rehearsal"
AWAY = "inspector"
"""The dock that makes room for the desk."""


class RehearsingSide(QObject):
    """``running`` is the rehearsal of this window, or None. clock: seconds that go on."""

    def __init__(self, window: MainWindow, clock: Callable[[], float] = time.monotonic) -> None:
        super().__init__(window)
        self._window = window
        self.clock = clock
        self.running: Running | None = None
        self._away = False
        """Whether the desk has taken the inspector's place."""
        self._wide = 0
        """Px that the inspector had."""
        self.desk = Desk(window.theme)
        self.desk.clock.restart_asked.connect(self.start_again)
        self.desk.notice.again_asked.connect(self.start_again)
        self.desk.notice.take_asked.connect(self.take_in)
        self.desk.notice.hurry_asked.connect(self.hurry)
        self.desk.notice.back_asked.connect(self.go_back)
        self.desk.clock.save_asked.connect(self.save)
        self.desk.settled.connect(self._settle)
        for tells in (self.desk.says.unsounded, self.desk.notice.told):
            tells.connect(window.status.announcements.tell)
        self.desk.screen_.menu_asked.connect(window.why.menus.open_on_screen)
        self._seen = (False, False)
        header = PanelHeader(self.tr("Rehearsal"))
        close = IconButton(window.theme, "close", self.tr("End the rehearsal"), "text3", 14)
        close.clicked.connect(self.end)
        header.add(close)
        right = Qt.DockWidgetArea.RightDockWidgetArea
        window.docking.add(DOCK, self.tr("Rehearsal"), self.desk, header, right)
        self._dock = window.docks[DOCK]
        self._dock.toggleViewAction().setVisible(False)
        self._dock.hide()
        window.closed.connect(lambda _: self.desk.sounding.silence())
        window.session.opened.connect(self.end)
        window.session.changed.connect(self._on_changed)
        window.robot.follower.viewing.exchanged.connect(self._on_exchanged)

    def rehearse(self) -> None:
        """The project as it is runs from its start; errors are told instead."""
        window = self._window
        window.finish_fields()
        project = window.session.project
        if project is None or not self.may_run():
            return
        if self.running is not None:
            self.start_again()
            self._dock.show()
            return
        window.robot.close_recording()
        self._show(Running(self._version(project), self.clock, self))
        self.desk.screen_.setFocus()

    def move_to(self, other: RehearsingSide) -> None:
        """What is rehearsed goes on in a window that stands in place of this one."""
        running, self.running = self.running, None
        if running is not None:
            self.desk.leave()
            running.setParent(other)
            running.begun.disconnect(self._show_course)
            running.went.disconnect(self._window.robot.follower.take_rehearsed)
            other._show(running)
            # It was made as this one is kept: with the desk in the inspector's place.
            other._away, other._wide = self._away, self._wide

    def _show(self, running: Running) -> None:
        """The desk, and every live view."""
        window = self._window
        self.running = running
        running.went.connect(window.robot.follower.take_rehearsed)
        running.begun.connect(self._show_course)
        self.desk.show_running(running)
        self._show_course()
        self._away = not window.docks[AWAY].isHidden()
        self._wide = window.docks[AWAY].width()
        window.docks[AWAY].hide()
        self._dock.show()
        window.resizeDocks([self._dock], [px(WIDE)], Qt.Orientation.Horizontal)

    def start_again(self) -> None:
        """From the start, with the project as it is now."""
        project = self._window.session.project
        if self.running is not None and project is not None and self.may_run():
            self.running.begin(self._version(project))

    def take_in(self) -> None:
        """What runs goes on as it is drawn now, at the next moment at which no action runs."""
        self._window.finish_fields()
        project = self._window.session.project
        if self.running is not None and project is not None and self.may_run():
            self.running.take_in(self._version(project))
            self.desk.show_drawn(self._window.session.project)

    def hurry(self) -> None:
        """What waits to be taken in is, at once."""
        if self.running is not None:
            self.running.hurry()
            self.desk.show_drawn(self._window.session.project)

    def go_back(self) -> None:
        """What ran before the last changes runs again."""
        if self.running is not None:
            self.running.go_back()
            self.desk.show_drawn(self._window.session.project)

    @property
    def can_take_in(self) -> bool:
        """Whether something else is drawn than runs, or waits to."""
        return self.running is not None and not self.desk.notice.take.isHidden()

    @property
    def can_go_back(self) -> bool:
        """Whether something else ran before."""
        return self.running is not None and not self.desk.notice.back.isHidden()

    def _settle(self) -> None:
        """The commands are offered where they can be done now."""
        seen = (self.can_take_in, self.can_go_back)
        if seen != self._seen:
            self._seen = seen
            self._window.actions_.refresh()

    def _version(self, project: Project) -> Version:
        """The project as it is open, with its texts."""
        session = self._window.session
        files = (*session.files, *beside.files(project))
        values = {file: session.value(file) for file in files}
        known = {file: write(value) for file, value in values.items() if value is not None}
        return Version(project, {file: data.decode() for file, data in known.items()})

    def end(self) -> None:
        """The views show the robot again, if there is one."""
        running, self.running = self.running, None
        if running is None:
            return
        running.stop()
        self.desk.leave()
        running.deleteLater()
        self._dock.hide()
        if self._away:
            inspector = self._window.docks[AWAY]
            inspector.show()
            # Side by side they are as wide as the wider one was.
            self._window.resizeDocks([inspector], [self._wide], Qt.Orientation.Horizontal)
        follower = self._window.robot.follower
        if follower.viewing.log is running.course.log:
            follower.show_link()
        self._window.robot.settle()
        self._settle()

    def pause(self) -> None:
        """Stands still, or goes on."""
        if self.running is not None:
            self.desk.clock.pause.click()

    def step(self) -> None:
        """To what happens next, and stands still there."""
        if self.running is not None:
            self.running.step()

    def save(self) -> None:
        """Asks how what was done shall be kept as a scenario; its time stands still then."""
        running, window = self.running, self._window
        if running is None:
            return
        project = running.course.project
        home = resolve(project.root, project.scenarios) if project.scenarios is not None else None
        if home is None:
            said = self.tr("Say in the project's form in which folder its scenarios lie.")
            window.dialogs.tell(said)
            return
        running.set_pace(0)
        saving = SavingScenario(running.course, home, window.theme, window)
        saving.saved.connect(self._on_saved)
        saving.open()

    def _on_saved(self, file: Path) -> None:
        window, project = self._window, self._window.session.project
        window.say(self.tr("Saved {0}").format(file.name))
        if project is not None:
            window.project_tree.show_scenarios(project)

    def set_theme(self, theme: Theme) -> None:
        self.desk.set_theme(theme)

    def may_run(self) -> bool:
        """Whether the project can run; that it can not is told."""
        window, session = self._window, self._window.session
        project = session.project
        wrong = project is None or any(session.is_incomplete(file) for file in session.files)
        if project is not None and not wrong:
            wrong = any(p.severity == "error" for p in structure(project))
        if wrong:
            window.bottom.choose("problems")
            window.say(self.tr("Mend the errors first, then the project can run."))
        return not wrong

    def _show_course(self) -> None:
        running = self.running
        assert running is not None
        self._window.robot.follower.show_rehearsal(running.course.log, lambda: running.seconds)
        self._window.robot.follower.take_rehearsed(running.course.take())
        self._window.robot.settle()

    def _on_changed(self, _: str) -> None:
        if self.running is not None:
            self.desk.show_drawn(self._window.session.project)

    def _on_exchanged(self) -> None:
        """Something else is looked at, a recording: that ends it."""
        running = self.running
        shown = self._window.robot.follower.viewing.log
        if running is not None and shown is not running.course.log:
            self.end()
