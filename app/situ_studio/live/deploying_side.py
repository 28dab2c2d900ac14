"""A window's deploys: when one can be asked for, and what is told of it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document import beside
from situ.errors import UsageError
from situ_studio.edits.edit import write
from situ_studio.live import deploying_theirs, deploying_words
from situ_studio.live.deploying import Deploying
from situ_studio.live.deploying_dialog import DeployDialog
from situ_studio.live.deploying_plan import Plan, plan
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class DeployingSide(QObject):
    """To be made after the window's ``robot``."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._link = link = window.robot.link
        self.deploying = Deploying(link, self)
        self.deploying.ended.connect(self._on_ended)
        self.dialog: DeployDialog | None = None
        self._seen = (False, False)
        for signal in (link.state_changed, link.documents_came, window.session.changed):
            signal.connect(self._settle)
            signal.connect(self._settle_dialog)
        window.session.problems_changed.connect(self._settle_dialog)

    @property
    def can_deploy(self) -> bool:
        """Whether there is a robot that something can be deployed to, and something."""
        return self._link.connected and self._window.session.project is not None

    @property
    def differs(self) -> bool:
        """Whether the robot runs other documents than those that are open."""
        return self.can_deploy and self._window.robot.follower.same is False

    def ask(self) -> None:
        """Shows what would change, and lets a person decide."""
        if self.dialog is None:
            window = self._window
            self.dialog = DeployDialog(self.deploying, self._plan, window.theme, window)
            self.dialog.theirs_asked.connect(self.open_theirs)
        self.deploying.ask_history()
        self.dialog.settle()
        self.dialog.show()
        self.dialog.activateWindow()
        self.dialog.deploy.setFocus()

    def move_to(self, other: DeployingSide) -> None:
        """What is on its way, or on trial, is told of by a window in place of this one."""
        mine, other.deploying = other.deploying, self.deploying
        mine.deleteLater()
        self.deploying.setParent(other)
        self.deploying.ended.disconnect(self._on_ended)
        self.deploying.ended.connect(other._on_ended)
        if self.dialog is not None and self.dialog.isVisible():
            self.dialog.close()
            other.ask()

    def open_theirs(self) -> None:
        """What the robot runs, in a new folder and a window of its own."""
        window, files, sent = self._window, self._link.files, self._plan()
        if files is None or sent is None or window.windows is None:
            return
        name = f"{self._link.state.project}-robot"
        title = self.tr("Where the folder {0} shall be made").format(name)
        parent = window.dialogs.new_folder(str(window.session.root.parent), title)
        if parent is None:
            return
        try:
            deploying_theirs.keep(files, sent.media, Path(parent) / name)
            window.windows.show_project(Path(parent) / name)
        except UsageError as error:
            window.dialogs.tell(said(str(error)))

    def _plan(self) -> Plan | None:
        session, files = self._window.session, self._link.files
        if session.project is None or files is None or not self._link.connected:
            return None
        values = {file: session.value(file) for file in session.dirty if beside.is_beside(file)}
        unsaved = {file: write(value) for file, value in values.items() if value is not None}
        return plan(session.project, unsaved, files, session.problems)

    def _settle(self) -> None:
        """The command is offered where it can be done now."""
        seen = (self.can_deploy, self.differs)
        if seen != self._seen:
            self._seen = seen
            self._window.actions_.refresh()

    def _settle_dialog(self) -> None:
        if self.dialog is not None and self.dialog.isVisible():
            self.dialog.settle()

    def _on_ended(self) -> None:
        """Who has closed the dialog is told all the same."""
        if self.dialog is not None and self.dialog.isVisible():
            return
        words = deploying_words.standing(self.deploying)
        if self.deploying.stands == "running":
            self._window.say(words)
        else:
            self._window.dialogs.tell(words)
