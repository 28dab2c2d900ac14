"""What Why? and Why not? can be asked of the robot's panels: rows of tables, bars of the timeline.

Each has a menu by mouse; by keys the same is asked of the row that has the keyboard, and of the
timeline at its cursor.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from msgspec import Struct
from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtWidgets import QMenu

from situ.document.project import Project
from situ.rehearse.ways import frames, way_words, ways
from situ_studio.commands.context_menus import pop_up
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.live.lanes import Lane
from situ_studio.live.moment import Moment
from situ_studio.live.timeline.rows import RowKind, TimelineRow
from situ_studio.live.why import Thing, ThingKind
from situ_studio.live.why_not import Wanted, wanted_at, way_wanted
from situ_studio.live.why_places import tags_in, thing_at, where
from situ_studio.looks import icons
from situ_studio.panels.table import RowsTable

if TYPE_CHECKING:
    from situ_studio.live.why_side import WhySide
    from situ_studio.window.main_window import MainWindow

MANY = 8
"""Of more questions why not, the rest is in a menu of its own."""
_OF_ROW: dict[RowKind, ThingKind] = {
    "state": "application", "situation": "situation", "resource": "held", "data": "tag",
}  # fmt: skip


class WhyNot(Struct, frozen=True):
    """A question. wanted: the event that did not come; about: the file and place it is about."""

    words: str
    wanted: Wanted
    about: tuple[str, Place]


class WhyMenus(QObject):
    """Of one window; ``shown`` is the menu that is open, or was the last."""

    def __init__(self, window: MainWindow, side: WhySide) -> None:
        super().__init__(side)
        self._window, self._side, self._robot = window, side, window.robot
        self._viewing = window.robot.follower.viewing
        self.shown: QMenu | None = None
        for table in self._tables:
            table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
            table.customContextMenuRequested.connect(partial(self._on_menu, table))
        chart = self._robot.timeline.chart
        chart.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        chart.customContextMenuRequested.connect(self._on_timeline)

    @property
    def _tables(self) -> tuple[RowsTable, ...]:
        return self._robot.blackboard, self._robot.authority, self._robot.trace

    # -- by keys -----------------------------------------------------------------------

    def ask(self) -> bool:
        """Of what has the keyboard, if that is one of the robot's panels."""
        about = self._window.moment.column.asked_about
        if about is not None:
            self.ask_of(*about)
            return True
        for table in self._tables:
            if table.hasFocus() and table.currentIndex().isValid():
                things = [thing for _, thing in self._of_row(table)]
                self._side.ask_about(*things[:2])
                return True
        screen = self._window.rehearsing.desk.screen_
        if screen.hasFocus():
            shown = self._on_screen(screen.current.id if screen.current is not None else "")
            if shown is not None:
                self._ask_component(*shown)
            return shown is not None
        return self._ask_timeline()

    def ask_not(self) -> bool:
        """The same; of several questions one is to be chosen."""
        project = self._side.project
        about = self._window.moment.column.asked_about
        if about is not None:
            self.open_of(*about, self._window.moment.column.below_focus)
            return True
        for table in self._tables:
            if project is not None and table.hasFocus() and table.currentIndex().isValid():
                questions = self._not_of_row(project, table)
                if len(questions) == 1:
                    self._ask_not(None, questions[0])
                elif questions:
                    menu = self._menu([])
                    self._add_questions(menu, questions)
                    at = table.visualRect(table.currentIndex()).bottomLeft()
                    pop_up(menu, table.viewport().mapToGlobal(at))
                return bool(questions)
        screen = self._window.rehearsing.desk.screen_
        if screen.hasFocus() and project is not None:
            shown = self._on_screen(screen.current.id if screen.current is not None else "")
            question = self._not_of_component(project, *shown) if shown is not None else None
            if question is not None:
                self._ask_not(None, question)
            return question is not None
        return self._ask_timeline()

    def _ask_timeline(self) -> bool:
        """What there is at the cursor, in a menu of its own each."""
        chart, project = self._robot.timeline.chart, self._side.project
        if not chart.hasFocus() or project is None or not chart.rows:
            return False
        menu = self._menu([])
        for row in chart.rows:
            name = row.name or self.tr("Situation")
            below = menu.addMenu(name.replace("&", "&&"))
            self._fill_for_row(below, project, row, self._viewing.t)
        pop_up(menu, chart.viewport().mapToGlobal(QPoint(chart.viewport().width() // 3, 8)))
        menu.setActiveAction(menu.actions()[0])
        return True

    # -- by mouse ----------------------------------------------------------------------

    def _on_menu(self, table: RowsTable, at: QPoint) -> None:
        pressed = table.indexAt(at)
        if pressed.isValid():
            table.setCurrentIndex(pressed)
        things, project = self._of_row(table), self._side.project
        if not things or project is None or not self._side.can_ask():
            return
        menu = self._menu(things)
        self._add_questions(menu, self._not_of_row(project, table))
        pop_up(menu, table.viewport().mapToGlobal(at))

    def _on_timeline(self, at: QPoint) -> None:
        """Of what was there at the moment under the hand."""
        chart = self._robot.timeline.chart
        row, t = chart.row_at(at), chart.moment_at(at)
        project = self._side.project_at(self._viewing.t if t is None else t)
        if row is None or project is None or not self._side.can_ask():
            return
        menu = self._menu([])
        self._fill_for_row(menu, project, row, self._viewing.t if t is None else t)
        pop_up(menu, chart.viewport().mapToGlobal(at))

    def open_on_screen(self, component: str, at: QPoint) -> None:
        """Of what lies on the screen of the robot that is rehearsed; "": of its state."""
        shown, project = self._on_screen(component), self._side.project
        if shown is None or project is None or not self._side.can_ask():
            return
        menu = self._menu([])
        self._add(menu, self.tr("Why?"), partial(self._ask_component, *shown))
        question = self._not_of_component(project, *shown)
        self._add_questions(menu, [question] if question is not None else [])
        pop_up(menu, at)

    def ask_of(self, kind: RowKind, name: str) -> None:
        """Of what stands in the column of the moment: of a resource why it is held so."""
        self._side.ask_about(Thing(_OF_ROW[kind], name))

    def open_of(self, kind: RowKind, name: str, at: QPoint) -> None:
        """A menu of what can be asked of that."""
        project = self._side.project
        if project is None or not self._side.can_ask():
            return
        row = TimelineRow(kind, "" if kind == "situation" else name, Lane())
        menu = self._menu([])
        self._add(menu, self.tr("Why?"), partial(self.ask_of, kind, name))
        if kind == "resource":
            words = self.tr("Why did {0} move?").format(name)
            self._add(menu, words, partial(self._ask_at, None, Thing("resource", name)))
        self._add_questions(menu, list(self._not_of_lane(project, row, self._viewing.moment())))
        pop_up(menu, at)

    def _on_screen(self, component: str) -> tuple[str, Place] | None:
        """The file and place of a component that is shown now; of the state where it is none."""
        project, moment = self._side.project, self._viewing.moment()
        if project is None:
            return None
        state: tuple[str, Place] | None = None
        for name, one in moment.applications.items():
            for frame in reversed(frames(project, name, one.state or "")):
                state = state or (frame.file, ("state", frame.state.no))
                always = frame.application.always
                for holder, value in (
                    (("state", frame.state.no), frame.state),
                    (("always",), always),
                ):
                    screen = value.screen if value is not None else None
                    parts = screen.components if screen is not None else ()
                    if any(part.id == component for part in parts):
                        return frame.file, (*holder, "screen", component)
        return state

    def _ask_component(self, file: str, place: Place) -> None:
        project, document = self._side.project, self._side.document(file)
        if project is None or document is None:
            return
        thing = thing_at(project, file, document, place)
        if thing is not None:
            self._side.ask_about(thing, thing_at(project, file, document, places.root(place)))

    def _not_of_component(self, project: Project, file: str, place: Place) -> WhyNot | None:
        document = self._side.document(file)
        if document is None:
            return None
        wanted = wanted_at(project, file, document, place, self._viewing.moment())
        if wanted is None:
            return None
        return WhyNot(
            self._side.question(self._side.teller(project), wanted), wanted, (file, place)
        )

    def _fill_for_row(self, menu: QMenu, project: Project, row: TimelineRow, t: float) -> None:
        log = self._viewing.log
        name = (log.lanes.situation.at(t) or "") if row.kind == "situation" else row.name
        thing = Thing(_OF_ROW[row.kind], name)
        self._add(menu, self.tr("Why?"), partial(self._ask_at, t, thing))
        self._add_questions(menu, list(self._not_of_lane(project, row, log.at(t))), t)

    def _menu(self, things: Iterable[tuple[str, Thing]]) -> QMenu:
        menu = QMenu(self._window)
        for words, thing in things:
            self._add(menu, words, partial(self._ask_at, None, thing))
        menu.aboutToHide.connect(menu.deleteLater)
        self.shown = menu
        return menu

    def _add(self, menu: QMenu, words: str, ask: Callable[[], None], sign: str = "why") -> None:
        icon = icons.icon(sign, self._window.theme.color("text2"), 18)
        # An & would be taken for the key of the entry.
        menu.addAction(icon, words.replace("&", "&&")).triggered.connect(lambda _=False: ask())

    def _add_questions(self, menu: QMenu, questions: list[WhyNot], t: float | None = None) -> None:
        if questions and not menu.isEmpty():
            menu.addSeparator()
        room = menu
        for place, question in enumerate(questions):
            if place == MANY and len(questions) > MANY + 1:
                room = menu.addMenu(self.tr("Others"))
            self._add(room, question.words, partial(self._ask_not, t, question), "why_not")

    def _ask_at(self, t: float | None, thing: Thing) -> None:
        """t: where the cursor goes before; None: it stays."""
        if t is not None:
            self._viewing.seek(t)
        self._side.ask_about(thing)

    def _ask_not(self, t: float | None, question: WhyNot) -> None:
        if t is not None:
            self._viewing.seek(t)
        self._side.ask_why_not(question.wanted, question.about)

    # -- what can be asked ---------------------------------------------------------------

    def _of_row(self, table: RowsTable) -> list[tuple[str, Thing]]:
        """Of a table's current row, with its words."""
        index = table.currentIndex()
        if not index.isValid():
            return []
        key = table.rows.rows[index.row()].key
        if table is self._robot.blackboard:
            return [(self.tr("Why?"), Thing("tag", key))]
        if table is self._robot.trace:
            return [(self.tr("Why?"), Thing("event", key))]
        return [
            (self.tr("Why did {0} move?").format(key), Thing("resource", key)),
            (self.tr("Why is {0} held so?").format(key), Thing("held", key)),
        ]

    def _not_of_row(self, project: Project, table: RowsTable) -> list[WhyNot]:
        key, moment = table.rows.rows[table.currentIndex().row()].key, self._viewing.moment()
        if table is self._robot.authority:
            return list(self._others(project, key, moment))
        if table is self._robot.blackboard:
            return list(self._situations_with(project, key, moment))
        return list(self._of_event(project, int(key), moment))

    def _not_of_lane(self, project: Project, row: TimelineRow, moment: Moment) -> Iterator[WhyNot]:
        if row.kind == "resource":
            yield from self._others(project, row.name, moment)
        elif row.kind == "data":
            yield from self._situations_with(project, row.name, moment)
        elif row.kind == "situation":
            script = project.spds
            names = [s.name for s in script.situations] if script is not None else []
            yield from self._situations(project, names, moment)
        else:
            yield from self._ways(project, row.name, moment)

    def _others(self, project: Project, resource: str, moment: Moment) -> Iterator[WhyNot]:
        """The modules that could hold a resource, and do not."""
        if project.spds is None:
            return
        holder, _ = moment.holders.get(resource, (None, 0.0))
        able = [m.name for m in project.spds.modules if resource in m.resources]
        asking = [m for m, wanted in moment.asking.items() if resource in wanted]
        for module in dict.fromkeys((*able, *asking)):
            if module != holder:
                wanted = {"kind": "authority", "to": module, "resource": resource}
                about = (project.spds_file or "", ("module", module))
                yield WhyNot(self.tr("Why not {0}?").format(module), wanted, about)

    def _situations_with(self, project: Project, tag: str, moment: Moment) -> Iterator[WhyNot]:
        """Those that look at a tag."""
        script = project.spds
        every = script.situations if script is not None else ()
        yield from self._situations(
            project, (s.name for s in every if tag in tags_in(s.condition)), moment
        )

    def _situations(
        self, project: Project, names: Iterable[str], moment: Moment
    ) -> Iterator[WhyNot]:
        """Those of them that are not the current one."""
        for name in names:
            if name != moment.situation:
                about = (project.spds_file or "", ("situation", name))
                words = self.tr("Why is {0} not the situation?").format(name)
                yield WhyNot(words, {"kind": "situation", "to": name}, about)

    def _ways(self, project: Project, application: str, moment: Moment) -> Iterator[WhyNot]:
        """The ways out of the state in which an application was."""
        one = moment.applications.get(application)
        if one is None or one.state is None:
            return
        for way in ways(project, application, one.state):
            said = way_words(way) if way.event is not None else self.tr("the timeout")
            wanted = way_wanted(application, one.state, way)
            yield WhyNot(self.tr("Why not {0}?").format(said), wanted, (way.file, way.place))

    def _of_event(self, project: Project, seq: int, moment: Moment) -> Iterator[WhyNot]:
        """What an event is about: why is it not so at the cursor?"""
        log = self._viewing.log
        event = log[self._side.place(seq) or 0]
        about = where(project, event)
        document = self._side.document(about[0]) if about is not None else None
        if about is None or document is None:
            return
        wanted = wanted_at(project, about[0], document, about[1], moment)
        if wanted is not None:
            yield WhyNot(self._side.question(self._side.teller(project), wanted), wanted, about)
