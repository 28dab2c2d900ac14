"""A window's Why? and Why not?: asked of what is selected, or of a row of the robot's panels.

A long log is looked through in slices; the window stays in use.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtWidgets import QMenu

from situ.decide.values import in_text
from situ.document.project import Project
from situ.rehearse.reason import Answer, Reason
from situ.rehearse.telling import Teller
from situ_studio import icons
from situ_studio.edit import Place
from situ_studio.language import said
from situ_studio.live.timeline.rows import RowKind
from situ_studio.live.why import Thing, ThingKind, latest, place_of, trail
from situ_studio.live.why_not import Question, events_until, wanted_at
from situ_studio.live.why_not_asking import AskingWhyNot
from situ_studio.live.why_places import priorities, tags_of, thing_at, where
from situ_studio.panels.table import RowsTable
from situ_studio.panels.why import Link, Why
from situ_studio.theme import Theme

if TYPE_CHECKING:
    from situ_studio.window import MainWindow

PANEL = "why"
INDENT = "    "
_OF_ROW: dict[RowKind, ThingKind] = {
    "state": "application", "situation": "situation", "resource": "held", "data": "tag",
}  # fmt: skip
SLICE = 0.012
"""Seconds of looking at a time."""


class WhySide(QObject):
    """Asks, and goes to what the answer names. ``panel`` has the answer."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._robot = window, window.robot
        self._viewing = window.robot.follower.viewing
        self.panel = Why(window.theme)
        self.panel.chosen.connect(self._go)
        window.bottom.add(PANEL, self.tr("Why?"), self.panel)
        self.shown: QMenu | None = None
        self._looking: Iterator[int | None] = iter(())
        self._other: Thing | None = None
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._look)
        self._wanted: tuple[dict[str, Any], tuple[str, Place] | None] = ({}, None)
        self._asking = AskingWhyNot(self)
        self._asking.answered.connect(self._answer_not)
        self._asking.gone.connect(self._on_gone)
        robot = window.robot
        for table in (robot.blackboard, robot.authority, robot.trace):
            table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
            table.customContextMenuRequested.connect(partial(self._on_menu, table))
        chart = robot.timeline.chart
        chart.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        chart.customContextMenuRequested.connect(self._on_timeline)
        robot.link.state_changed.connect(self.settle)
        self._viewing.exchanged.connect(self._on_exchanged)
        self.settle()

    def set_theme(self, theme: Theme) -> None:
        self.panel.set_theme(theme)

    def settle(self) -> None:
        """The panel is there while there is something to ask about."""
        if not self._robot.follower.shows:
            self._stop()
            self.panel.reset()
        self._window.bottom.set_shown(PANEL, self._robot.follower.shows)

    def _stop(self) -> None:
        self._slices.stop()
        self._asking.drop()

    def _on_exchanged(self) -> None:
        self._stop()
        self.panel.reset()
        self.settle()

    # -- what is asked about -----------------------------------------------------------

    def can_ask(self) -> bool:
        """Whether there is a robot, a recording or a rehearsal to ask about."""
        return self._robot.follower.shows and self._window.session.project is not None

    def ask(self) -> None:
        """About the current row of the table that has the keyboard; else what is selected."""
        for table in (self._robot.blackboard, self._robot.authority, self._robot.trace):
            if table.hasFocus() and table.currentIndex().isValid():
                things = [thing for _, thing in self._of_row(table)]
                self.ask_about(*things[:2])
                return
        thing = self._selected()
        if thing is None:
            self._window.say(self.tr("A trace tells nothing of that."))
        else:
            self.ask_about(thing)

    def _selected(self) -> Thing | None:
        window, project = self._window, self._window.session.project
        view, document = window.current_view, window.current_document
        if project is None or view is None or document is None:
            return None
        place = view.selected[0] if view.selected else ()
        thing = thing_at(project, view.file, document, place)
        if thing is None and document is project.spds and not place:
            current = self._viewing.moment().situation
            return Thing("situation", current) if current is not None else None
        return thing

    def ask_not(self) -> None:
        """What kept the selected thing from happening at the cursor."""
        window, project = self._window, self._window.session.project
        view, document = window.current_view, window.current_document
        if project is None or view is None or document is None:
            return
        place = view.selected[0] if view.selected else ()
        wanted = wanted_at(project, view.file, document, place, self._viewing.moment())
        if wanted is None:
            self._window.say(
                self.tr("Select a state, a transition, a situation, a module or a resource.")
            )
        else:
            self.ask_why_not(wanted, (view.file, place))

    def _of_row(self, table: RowsTable) -> list[tuple[str, Thing]]:
        """What can be asked of a table's current row, with its words."""
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

    def _on_menu(self, table: RowsTable, at: QPoint) -> None:
        pressed = table.indexAt(at)
        if pressed.isValid():
            table.setCurrentIndex(pressed)
        things = self._of_row(table)
        if not things or not self.can_ask():
            return
        menu = self._menu(things)
        if table is self._robot.authority:
            self._add_others(menu, things[0][1].name)
        menu.popup(table.viewport().mapToGlobal(at))

    def _on_timeline(self, at: QPoint) -> None:
        """Of what was there at the moment under the hand."""
        chart = self._robot.timeline.chart
        row, t = chart.row_at(at), chart.moment_at(at)
        if row is None or not self.can_ask():
            return
        then = self._viewing.t if t is None else t
        name, kind = row.name, _OF_ROW[row.kind]
        if row.kind == "situation":
            name = self._viewing.log.lanes.situation.at(then) or ""
        menu = self._menu([(self.tr("Why?"), Thing(kind, name))], then)
        menu.popup(chart.viewport().mapToGlobal(at))

    def _menu(self, things: list[tuple[str, Thing]], t: float | None = None) -> QMenu:
        """t: where the cursor goes before; None: it stays."""
        menu = QMenu(self._window)
        sign = icons.icon("why", self._window.theme.color("text2"), 18)
        for words, thing in things:
            action = menu.addAction(sign, words)
            action.triggered.connect(partial(self._ask_at, t, thing))
        menu.aboutToHide.connect(menu.deleteLater)
        self.shown = menu
        return menu

    def _ask_at(self, t: float | None, thing: Thing, *_: bool) -> None:
        if t is not None:
            self._viewing.seek(t)
        self.ask_about(thing)

    def _add_others(self, menu: QMenu, resource: str) -> None:
        """Why not any of the modules that could hold it?"""
        project = self._window.session.project
        if project is None or project.spds is None:
            return
        moment = self._viewing.moment()
        holder, _ = moment.holders.get(resource, (None, 0.0))
        able = [m.name for m in project.spds.modules if resource in m.resources]
        asking = [m for m, wanted in moment.asking.items() if resource in wanted]
        menu.addSeparator()
        for module in dict.fromkeys((*able, *asking)):
            if module != holder:
                wanted = {"kind": "authority", "to": module, "resource": resource}
                where = (project.spds_file or "", ("module", module))
                action = menu.addAction(self.tr("Why not {0}?").format(module))
                action.triggered.connect(partial(self.ask_why_not, wanted, where))

    # -- answering -----------------------------------------------------------------------

    def ask_about(self, thing: Thing, other: Thing | None = None) -> None:
        """Shows the panel with the answer, as of the cursor. other: where ``thing`` never was."""
        project = self._window.session.project
        if project is None:
            return
        self._begin()
        self._other = other
        self._looking = latest(self._viewing.log, project, thing, self._viewing.t)
        self._slices.start()
        self._look()

    def _begin(self) -> None:
        self._stop()
        self._window.bottom.choose(PANEL)
        self.panel.table.setFocus()
        self.panel.tell(self.tr("Looking…"))

    def _look(self) -> None:
        end = time.perf_counter() + SLICE
        while time.perf_counter() < end:
            try:
                place = next(self._looking)
            except StopIteration:
                self._slices.stop()
                if self._other is not None:
                    self.ask_about(self._other)
                else:
                    self.panel.tell(
                        self.tr("It has not happened up to this moment."),
                        self.tr("Nothing of it is in what is kept of the trace."),
                    )
                return
            if place is not None:
                self._slices.stop()
                self._answer(place)
                return

    def _answer(self, place: int) -> None:
        project, log = self._window.session.project, self._viewing.log
        if project is None:
            return
        teller = Teller(project)
        every = trail(log, place)
        links = [self._link(teller, project, one) for one in every]
        last = log.time(place)
        passed = last - log.time(every[0])
        more = self.tr("at {0} s").format(f"{last:.3f}")
        if passed > 0:
            more = self.tr("at {0} s, {1} s after what began it").format(
                f"{last:.3f}", f"{passed:.3f}"
            )
        self.panel.answer(said(teller.tell(log[place])), more, links, len(links) - 1)

    def _link(self, teller: Teller, project: Project, place: int) -> Link:
        log = self._viewing.log
        event, words = log[place], said(teller.tell(log[place]))
        if event["cause"] is None and event["kind"] != "mapping":
            words = self.tr("{0} ({1})").format(words, said(teller.origin(event)))
        moment = log.after(place + 1)
        tags = tags_of(project, event)
        values = [
            f"{tag} {in_text(moment.board[tag].value)}"
            if tag in moment.board
            else self.tr("{0} not set").format(tag)
            for tag in tags
        ]
        values += [
            self.tr("{0} has priority {1}").format(module, number)
            if number is not None
            else self.tr("{0} has no priority").format(module)
            for module, number in priorities(project, event, moment).items()
        ]
        return Link(event["t"], words, ", ".join(values), where(project, event))

    # -- what did not happen ---------------------------------------------------------------

    def ask_why_not(self, wanted: dict[str, Any], where: tuple[str, Place], *_: bool) -> None:
        """Shows the panel with what kept an event with the fields ``wanted`` from coming.

        where: what it is about.
        """
        project, t = self._window.session.project, self._viewing.t
        if project is None:
            return
        self._begin()
        self._wanted = wanted, where
        self._asking.ask(Question(project, events_until(self._viewing.log, t), wanted, t))

    def _on_gone(self) -> None:
        self.panel.tell(self.tr("There is no answer."), self.tr("The log says what went wrong."))

    def _answer_not(self, answer: Answer | str) -> None:
        project = self._window.session.project
        if project is None:
            return
        if isinstance(answer, str):
            self.panel.tell(said(answer))
            return
        place = place_of(self._viewing.log, answer.happened["seq"]) if answer.happened else None
        if place is not None:
            self._answer(place)
            return
        title = self._question(Teller(project), answer.wanted)
        more = self.tr("at {0} s").format(f"{answer.at:.3f}")
        if answer.reasons and answer.reasons[0].code == "already":
            more = self.tr("{0}: it was so already").format(more)
        elif self._robot.follower.same is False:
            more = self.tr("{0}; the documents here are not the robot's").format(more)
        links = [self._reason(project, one, depth) for one, depth in _flat(answer.reasons)]
        self.panel.answer(title, more, links, 0)

    def _question(self, teller: Teller, wanted: dict[str, Any]) -> str:
        name = wanted.get("application", "")
        match wanted["kind"]:
            case "enter":
                state = teller.state(name, wanted["state"])
                return self.tr("Why is {0} not in {1}?").format(name, state)
            case "transition":
                state, by = teller.state(name, wanted["from"]), wanted["event"]
                if by is None:
                    return self.tr("Why does {0} not leave {1} by itself?").format(name, state)
                return self.tr("Why does {0} not leave {1} by {2}?").format(name, state, by)
            case "situation":
                return self.tr("Why is {0} not the situation?").format(wanted["to"])
            case "authority":
                words = self.tr("Why does {0} not hold {1}?")
                return words.format(wanted["to"], wanted["resource"])
            case "mapping":
                words = self.tr("Why does {0} not move {1}?")
                return words.format(wanted["module"], wanted["resource"])
            case "action":
                words = self.tr("Why does {0} not begin {1}?")
                return words.format(name, wanted["action"])
        return self.tr("Why does {0} not come to {1}?").format(wanted["name"], name)

    def _reason(self, project: Project, reason: Reason, depth: int) -> Link:
        """A reason as a link: to the event that tells of it, else to what was asked about."""
        log = self._viewing.log
        place = place_of(log, reason.seq) if reason.seq is not None else None
        t, about = self._viewing.t, self._wanted[1]
        if place is not None:
            t, about = log.time(place), where(project, log[place])
        values = ", ".join(f"{tag} {in_text(value)}" for tag, value in reason.values.items())
        return Link(t, INDENT * depth + said(reason.text), values, about)

    # -- going there ---------------------------------------------------------------------

    def _go(self, link: Link) -> None:
        """To the moment of a link, and to the element that it is about."""
        self._viewing.seek(link.t)
        if link.where is not None and self._window.session.document(link.where[0]) is not None:
            self._window.go_to(*link.where)
        self.panel.table.setFocus()


def _flat(reasons: Iterable[Reason], depth: int = 0) -> Iterator[tuple[Reason, int]]:
    """Every reason with how deep it lies; what stood in its way follows it."""
    for reason in reasons:
        yield reason, depth
        yield from _flat(reason.below, depth + 1)
