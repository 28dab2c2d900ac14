"""A window's column of the moment: where it stands, what its rows go to, what is asked of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt

from situ.document.project import Project
from situ.document.spds import Spds
from situ.rehearse.ways import frames
from situ_studio.edits.edit import Place
from situ_studio.live.column import MomentColumn
from situ_studio.live.moment import Moment
from situ_studio.looks.theme import Theme

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

DOCK = "moment"
OPEN = "moment_open"
"""Where the settings keep whether it is wanted, of a robot and of a rehearsal."""
LEFT = Qt.DockWidgetArea.LeftDockWidgetArea


class ColumnSide(QObject):
    """To be made after the window's ``why`` and ``rehearsing``.

    While there is something live the column stands where project, outline and palette stood, until
    somebody wants those back; dragged elsewhere it stands there, and they stay.
    """

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._robot = window, window.robot
        self._viewing = window.robot.follower.viewing
        self.column = column = MomentColumn(window.theme, window.robot.state_name)
        title = self.tr("Robot at this moment")
        window.docking.add(DOCK, title, column, column.header, LEFT)
        self._dock = window.docks[DOCK]
        self._dock.hide()
        self._dock.installEventFilter(self)
        self._action = self._dock.toggleViewAction()
        self._action.triggered.connect(self._on_wanted)
        self._dock.topLevelChanged.connect(lambda _: self._on_moved())
        self._dock.dockLocationChanged.connect(lambda _: self._on_moved())
        column.left.connect(self._dock.close)
        column.chosen.connect(self.go)
        column.why_asked.connect(window.why.menus.ask_of)
        column.menu_asked.connect(window.why.menus.open_of)
        self._robot.follower.refreshed.connect(self._show)
        self._robot.settled.connect(self.settle)
        self._seen = False
        self.settle()

    def set_theme(self, theme: Theme) -> None:
        self.column.set_theme(theme)

    # -- where it stands ---------------------------------------------------------------

    @property
    def _kept(self) -> str:
        """Of a rehearsal a person may want the palette and of a robot not: each is kept alone."""
        return f"{OPEN}/{'rehearsal' if self._robot.follower.rehearses else 'robot'}"

    @property
    def _in_place(self) -> bool:
        area = self._window.dockWidgetArea(self._dock)
        return not self._dock.isFloating() and area == LEFT

    def settle(self) -> None:
        """It is there while there is something live, unless somebody has closed it."""
        live = self._robot.follower.shows and self._window.stack.currentIndex() == 1
        self._action.setEnabled(live)
        seen = live and self._window.settings.value(self._kept, True, bool) is True
        if self._in_place:
            self._window.left_place.want(DOCK, seen)
        elif seen != self._seen:
            self._dock.setVisible(seen)
        self._seen = seen
        if seen:
            self._show_now()

    def leave(self) -> None:
        """The panels are where they are without it."""
        self._seen = False
        self._window.left_place.want(DOCK, False)
        self._dock.hide()

    def _on_wanted(self, wanted: bool) -> None:
        self._window.settings.setValue(self._kept, wanted)
        self.settle()

    def _on_moved(self) -> None:
        if not self._seen:
            return
        if self._in_place:
            self._window.left_place.want(DOCK, True)
        else:
            self._window.left_place.release(DOCK)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Close and self._seen:
            self._window.settings.setValue(self._kept, False)
            self.settle()
        return super().eventFilter(watched, event)

    # -- what it shows -----------------------------------------------------------------

    def _show_now(self) -> None:
        self._show(self._viewing.moment(), self._viewing.t)

    def _show(self, moment: Moment, t: float) -> None:
        if self._seen:
            self.column.show_moment(moment, t, self._viewing.log.lanes, self._script)

    @property
    def _project(self) -> Project | None:
        return self._window.why.project

    @property
    def _script(self) -> Spds | None:
        """The one by which what is looked at runs, at the cursor."""
        project = self._project
        return project.spds if project is not None else None

    # -- what its rows are about -------------------------------------------------------

    def go(self, kind: str, name: str) -> None:
        """To a situation, state, holder or datum: in its document, or on the blackboard."""
        project, moment = self._project, self._viewing.moment()
        if project is None:
            return
        if kind == "data":
            self._go_to_tag(project, name, moment)
            return
        file, place = project.spds_file, self._place(kind, name, moment)
        if kind == "state":
            one = moment.applications.get(name)
            active = frames(project, name, one.state or "") if one is not None else []
            if not active:
                return
            file, place = active[-1].file, ("state", active[-1].state.no)
        if file is not None and self._window.session.document(file) is not None:
            self._window.go_to(file, place)

    @staticmethod
    def _place(kind: str, name: str, moment: Moment) -> Place:
        if kind == "resource":
            holder, _ = moment.holders.get(name, (None, 0.0))
            return ("module", holder) if holder is not None else ("resource", name)
        return (kind, name)

    def _go_to_tag(self, project: Project, name: str, moment: Moment) -> None:
        tag = name
        while tag and tag not in moment.board:
            tag = tag.rpartition(".")[0]
        if not tag:
            # It stands nowhere: where the script says what it is.
            if project.spds_file is not None:
                self._window.go_to(project.spds_file, ("data", name))
            return
        board = self._robot.blackboard
        self._window.bottom.choose("blackboard")
        self._robot.follower.refresh()
        board.choose(tag)
