"""A window's Why? and Why not?: asked of what is selected, or of a row of the robot's panels.

A long log is looked through in slices; the window stays in use.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from situ.decide.values import in_text
from situ.document.project import Project
from situ.rehearse.reason import Answer, Reason
from situ.rehearse.scenario import WRITER
from situ.rehearse.telling import Teller
from situ_studio.edits import places, project_documents
from situ_studio.edits.edit import Document, Place
from situ_studio.edits.words import state_alone
from situ_studio.live.by_clock import by_clock
from situ_studio.live.counterpart import counterpart
from situ_studio.live.moment import TraceFields
from situ_studio.live.ran import Ran, WhatRan
from situ_studio.live.why import Thing, latest, trail
from situ_studio.live.why_menus import WhyMenus
from situ_studio.live.why_not import Question, Wanted, events_until, wanted_at
from situ_studio.live.why_not_asking import AskingWhyNot
from situ_studio.live.why_places import meant_by, priorities, tags_of, where
from situ_studio.looks.theme import Theme
from situ_studio.panels.blackboard import ago
from situ_studio.panels.why import Link, Why
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.views.document_view import DocumentView
    from situ_studio.window.main_window import MainWindow

PANEL = "why"
INDENT = "    "
SLICE = 0.012
"""Seconds of looking at a time."""


class WhySide(QObject):
    """Asks, and goes to what the answer names. ``panel`` has the answer."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._robot = window, window.robot
        self._viewing = window.robot.follower.viewing
        self._ran = WhatRan(window)
        self.panel = Why(window.theme)
        self.panel.chosen.connect(self._go)
        window.bottom.add(PANEL, self.tr("Why?"), self.panel)
        self._looking: Iterator[int | None] = iter(())
        self._other: Thing | None = None
        self._of: Ran | None = None
        """What ran at the moment that was asked about."""
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._look)
        self._about: tuple[str, Place] | None = None
        """What it was asked of why it did not happen."""
        self._asking = AskingWhyNot(self)
        self._asking.answered.connect(self._answer_not)
        self._asking.gone.connect(self._on_gone)
        self.menus: WhyMenus = WhyMenus(window, self)
        window.robot.link.state_changed.connect(self.settle)
        self._viewing.exchanged.connect(self._on_exchanged)
        self._robot.trace.teller = self._teller_of
        window.robot.link.documents_came.connect(self._retell)
        window.session.changed.connect(self._retell)
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

    @property
    def project(self) -> Project | None:
        """What is asked: what ran at the cursor, though another may be open by now; the open one
        only where nothing is known of that.
        """
        return self.project_at(self._viewing.t)

    def project_at(self, t: float) -> Project | None:
        """The same for another moment."""
        return self._ran.project(t)

    def document(self, file: str) -> Document | None:
        """A document of that project; None where it has none of the name."""
        project = self.project
        return project_documents.document(project, file) if project is not None else None

    def _retell(self) -> None:
        self._robot.trace.retell()

    def _teller_of(self, event: TraceFields) -> Teller:
        """Of a row of the trace."""
        return self.teller(self._ran.project(event["t"]))

    def teller(self, project: Project | None) -> Teller:
        """Tells events of what is looked at; what who sits here did is told as *you*."""
        link = self._robot.link
        if self._ran.course is not None:
            return Teller(project, WRITER)
        return Teller(project, link.writer if self._viewing.log is link.log else None)

    # -- what is asked about -----------------------------------------------------------

    def can_ask(self) -> bool:
        """Whether there is a robot, a recording or a rehearsal to ask about."""
        return self._robot.follower.shows and self._window.session.project is not None

    def ask(self) -> None:
        """About the current row of the table that has the keyboard; else what is selected."""
        if self.menus.ask():
            return
        meant = self._meant()
        if meant is None:
            return
        thing, other = meant_by(*meant, self._viewing.moment())
        if thing is None:
            self._window.say(self.tr("A trace tells nothing of that."))
        else:
            self.ask_about(thing, other)

    def _meant(self) -> tuple[Project, str, Document, Place] | None:
        """What ran, and its document and place that are those which are selected here; None where
        there is nothing of it, which is then said.
        """
        window, project = self._window, self.project
        view, mine = window.current_view, window.current_document
        if project is None or view is None or mine is None:
            return None
        theirs = self.document(view.file)
        if theirs is None:
            self._window.say(self.tr("What ran had no {0}.").format(view.file))
            return None
        place = counterpart(mine, self._place_meant(view), theirs)
        if place is None:
            self._window.say(self.tr("What ran had nothing of that in {0}.").format(view.file))
            return None
        return project, view.file, theirs, place

    @staticmethod
    def _place_meant(view: DocumentView) -> Place:
        """Of a piece that knows it more closely than by what is selected: a cell of the matrix."""
        focus = view.window().focusWidget()
        for piece in view.shown_pieces:
            if piece.isAncestorOf(focus) and hasattr(piece, "asked_about"):
                return tuple(piece.asked_about())
        return view.selected[0] if view.selected else ()

    def ask_not(self) -> None:
        """What kept the selected thing from happening at the cursor."""
        if self.menus.ask_not():
            return
        meant = self._meant()
        if meant is None:
            return
        _, file, _, place = meant
        wanted = wanted_at(*meant, self._viewing.moment())
        if wanted is None:
            self._window.say(
                self.tr("Select a state, a transition, a situation, a module or a resource.")
            )
        else:
            self.ask_why_not(wanted, (file, place))

    # -- answering -----------------------------------------------------------------------

    def ask_about(self, thing: Thing, other: Thing | None = None) -> None:
        """Shows the panel with the answer, as of the cursor. other: where ``thing`` never was."""
        project = self.project
        if project is None:
            return
        self._begin(self._viewing.t)
        self._other = other
        self._looking = latest(self._viewing.log, project, thing, self._viewing.t)
        self._slices.start()
        self._look()

    def place(self, seq: int) -> int | None:
        """Where the event of that seq is in the log that is looked at."""
        return self._viewing.log.place(seq)

    def _begin(self, t: float) -> None:
        self._stop()
        self._of = self._ran.at(t)
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
        if self._of is None:
            return
        project, log = self._of.project, self._viewing.log
        teller = self.teller(project)
        every = trail(log, place)
        links = [self._link(teller, project, one) for one in every]
        last = log.time(place)
        passed, since = last - log.time(every[0]), self._viewing.t - last
        more = self.tr("at {0}").format(self._viewing.written(last))
        if passed > 0:
            more = self.tr("{0}, {1} s after what began it").format(more, f"{passed:.3f}")
        if since >= 0.1:
            more = self.tr("{0}; {1} ago").format(more, ago(since))
        more = self._asked_of(more)
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
        at = self._viewing.written(event["t"])
        return Link(event["t"], at, words, ", ".join(values), where(project, event))

    # -- what did not happen ---------------------------------------------------------------

    def ask_why_not(self, wanted: Wanted, where: tuple[str, Place]) -> None:
        """Shows the panel with what kept an event with the fields ``wanted`` from coming.

        where: what it is about.
        """
        project, t = self.project, self._viewing.t
        if project is None:
            return
        self._begin(t)
        self._about = where
        log = self._viewing.log
        events, clock = events_until(log, t), log.clock.until(t)
        self._asking.ask(Question(project, events, wanted, t, clock))

    def _on_gone(self) -> None:
        self.panel.tell(self.tr("There is no answer."), self.tr("The log says what went wrong."))

    def _answer_not(self, answer: Answer | str) -> None:
        if self._of is None:
            return
        project = self._of.project
        if isinstance(answer, str):
            self.panel.tell(said(answer))
            return
        happened = answer.happened
        place = self._viewing.log.place(happened["seq"]) if happened is not None else None
        if place is not None:
            self._answer(place)
            return
        title = self.question(self.teller(project), answer.wanted)
        more = self.tr("at {0}").format(self._viewing.written(answer.at))
        if answer.reasons and answer.reasons[0].code == "already":
            more = self.tr("{0}: it was so already").format(more)
        more = self._asked_of(more)
        links = [self._reason(project, one, depth) for one, depth in _flat(answer.reasons)]
        self.panel.answer(title, more, links, 0)

    def _asked_of(self, more: str) -> str:
        """With a word about the documents, where those that are open are not those that ran."""
        ran = self._of
        if ran is not None and ran.differs:
            return self.tr("{0}; by the documents that ran, not those open here").format(more)
        if ran is not None and not ran.own:
            words = self.tr("{0}; by the documents open here: those that ran are not known")
            return words.format(more)
        return more

    def question(self, teller: Teller, wanted: Wanted) -> str:
        """What is asked, in words."""
        name = wanted.get("application", "")
        match wanted["kind"]:
            case "enter":
                state = state_alone(wanted["state"], teller.state(name, wanted["state"]))
                return self.tr("Why is {0} not in {1}?").format(name, state)
            case "transition":
                state, by = wanted["from"], wanted["event"]
                state = state_alone(state, teller.state(name, state))
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
        place = log.place(reason.seq) if reason.seq is not None else None
        t, about = self._viewing.t, self._about
        if place is not None:
            t, about = log.time(place), where(project, log[place])
        values = ", ".join(f"{tag} {in_text(value)}" for tag, value in reason.values.items())
        at = self._viewing.written(t)
        text = by_clock(reason.text, self._viewing)
        return Link(t, at, INDENT * depth + said(text), values, about)

    # -- going there ---------------------------------------------------------------------

    def _go(self, link: Link) -> None:
        """To the moment of a link, and to the element that it is about."""
        self._viewing.seek(link.t)
        if link.where is not None and self._of is not None:
            self._go_to(self._of.project, *link.where)
        self.panel.table.setFocus()

    def _go_to(self, project: Project, file: str, place: Place) -> None:
        """To what a place of what ran is in the open documents; where they have no such thing, that
        is said, and what is nearest to it is shown.
        """
        theirs = project_documents.document(project, file)
        mine = self._window.session.document(file)
        if theirs is None:
            return
        if mine is None:
            self._window.say(self.tr("{0} is not open here: only what ran has it.").format(file))
            return
        found = counterpart(theirs, place, mine)
        if found is not None:
            self._window.go_to(file, found)
            return
        near: Place | None = None
        while near is None:
            place = places.nearest(theirs, place[:-1])
            near = counterpart(theirs, place, mine)
        self._window.go_to(file, near)
        self._window.say(self.tr("Only what ran has that: {0} here has not.").format(file))


def _flat(reasons: Iterable[Reason], depth: int = 0) -> Iterator[tuple[Reason, int]]:
    """Every reason with how deep it lies; what stood in its way follows it."""
    for reason in reasons:
        yield reason, depth
        yield from _flat(reason.below, depth + 1)
