"""A window's Why? and Why not?: asked of what is selected, or of a row of the robot's panels.

A long log is looked through in slices; the window stays in use.
"""

from __future__ import annotations

import re
import time
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from situ.decide.values import in_text
from situ.document.project import Project
from situ.rehearse.reason import Answer, Reason
from situ.rehearse.scenario import WRITER
from situ.rehearse.telling import Teller
from situ_studio import places
from situ_studio.edit import Document, Place
from situ_studio.language import said
from situ_studio.live.viewing import Viewing
from situ_studio.live.why import Thing, latest, place_of, trail
from situ_studio.live.why_menus import WhyMenus
from situ_studio.live.why_not import Question, Wanted, events_until, wanted_at
from situ_studio.live.why_not_asking import AskingWhyNot
from situ_studio.live.why_places import priorities, tags_of, thing_at, where
from situ_studio.panels.blackboard import ago
from situ_studio.panels.why import Link, Why
from situ_studio.theme import Theme

if TYPE_CHECKING:
    from situ_studio.document_view import DocumentView
    from situ_studio.window import MainWindow

PANEL = "why"
INDENT = "    "
SLICE = 0.012
"""Seconds of looking at a time."""
MOMENT = re.compile(r"“[^“”]*”|\b(?P<word>since|at) (?P<t>\d+(?:\.\d+)?) s\b")
"""A moment in a sentence of the runtime's; or what a person wrote, which may read like one."""


class WhySide(QObject):
    """Asks, and goes to what the answer names. ``panel`` has the answer."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._robot = window, window.robot
        self._viewing = window.robot.follower.viewing
        self.panel = Why(window.theme)
        self.panel.chosen.connect(self._go)
        window.bottom.add(PANEL, self.tr("Why?"), self.panel)
        self._looking: Iterator[int | None] = iter(())
        self._other: Thing | None = None
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._look)
        self._about: tuple[str, Place] | None = None
        """What it was asked of why it did not happen."""
        self._asking = AskingWhyNot(self)
        self._asking.answered.connect(self._answer_not)
        self._asking.gone.connect(self._on_gone)
        self.menus = WhyMenus(window, self)
        window.robot.link.state_changed.connect(self.settle)
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

    @property
    def project(self) -> Project | None:
        """What is asked: of a rehearsal the project that runs, though another may be drawn by now;
        else the open one.
        """
        running = self._window.rehearsing.running
        if running is not None and self._viewing.log is running.course.log:
            return running.course.project
        return self._window.session.project

    def document(self, file: str) -> Document | None:
        """A document of that project; None where it has none of the name."""
        project = self.project
        if project is None:
            return None
        if file == project.spds_file:
            return project.spds
        return project.applications.get(file) or project.parts.get(file)

    def teller(self, project: Project) -> Teller:
        """Tells events of what is looked at; what who sits here did is told as *you*."""
        running, link = self._window.rehearsing.running, self._robot.link
        if running is not None and self._viewing.log is running.course.log:
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
        thing, other = self._selected()
        if thing is None:
            self._window.say(self.tr("A trace tells nothing of that."))
        else:
            self.ask_about(thing, other)

    def _selected(self) -> tuple[Thing | None, Thing | None]:
        """What is meant, and what is told of where that never was."""
        window, project = self._window, self._window.session.project
        view, document = window.current_view, window.current_document
        if project is None or view is None or document is None:
            return None, None
        place = self._place_meant(view)
        thing = thing_at(project, view.file, document, place)
        if thing is None and document is project.spds and not place:
            current = self._viewing.moment().situation
            return (Thing("situation", current) if current is not None else None), None
        if thing is not None and thing.kind == "application" and self._stands_still(thing.name):
            return Thing("halt", thing.name), thing
        if places.is_component(place):
            return thing, thing_at(project, view.file, document, places.root(place))
        return thing, None

    def _stands_still(self, application: str) -> bool:
        one = self._viewing.moment().applications.get(application)
        return one is not None and (one.suspended or one.paused)

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
        window, project = self._window, self._window.session.project
        view, document = window.current_view, window.current_document
        if project is None or view is None or document is None:
            return
        place = self._place_meant(view)
        wanted = wanted_at(project, view.file, document, place, self._viewing.moment())
        if wanted is None:
            self._window.say(
                self.tr("Select a state, a transition, a situation, a module or a resource.")
            )
        else:
            self.ask_why_not(wanted, (view.file, place))

    # -- answering -----------------------------------------------------------------------

    def ask_about(self, thing: Thing, other: Thing | None = None) -> None:
        """Shows the panel with the answer, as of the cursor. other: where ``thing`` never was."""
        project = self.project
        if project is None:
            return
        self._begin()
        self._other = other
        self._looking = latest(self._viewing.log, project, thing, self._viewing.t)
        self._slices.start()
        self._look()

    def place(self, seq: int) -> int | None:
        """Where the event of that seq is in the log that is looked at."""
        return place_of(self._viewing.log, seq)

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
        project, log = self.project, self._viewing.log
        if project is None:
            return
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
        self._begin()
        self._about = where
        self._asking.ask(Question(project, events_until(self._viewing.log, t), wanted, t))

    def _on_gone(self) -> None:
        self.panel.tell(self.tr("There is no answer."), self.tr("The log says what went wrong."))

    def _answer_not(self, answer: Answer | str) -> None:
        project = self.project
        if project is None:
            return
        if isinstance(answer, str):
            self.panel.tell(said(answer))
            return
        place = place_of(self._viewing.log, answer.happened["seq"]) if answer.happened else None
        if place is not None:
            self._answer(place)
            return
        title = self.question(self.teller(project), answer.wanted)
        more = self.tr("at {0}").format(self._viewing.written(answer.at))
        if answer.reasons and answer.reasons[0].code == "already":
            more = self.tr("{0}: it was so already").format(more)
        elif self._robot.follower.same is False:
            more = self.tr("{0}; the documents here are not the robot's").format(more)
        links = [self._reason(project, one, depth) for one, depth in _flat(answer.reasons)]
        self.panel.answer(title, more, links, 0)

    def question(self, teller: Teller, wanted: Wanted) -> str:
        """What is asked, in words."""
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
        if link.where is not None and self._window.session.document(link.where[0]) is not None:
            self._window.go_to(*link.where)
        self.panel.table.setFocus()


def by_clock(text: str, viewing: Viewing) -> str:
    """The runtime's sentence with its moments as all other times here are written: the runtime
    knows seconds of the trace alone. What a person wrote stays.
    """
    if viewing.wall() is None:
        return text

    def written(found: re.Match[str]) -> str:
        if found["t"] is None:
            return found[0]
        return f"{found['word']} {viewing.written(float(found['t']))}"

    return MOMENT.sub(written, text)


def _flat(reasons: Iterable[Reason], depth: int = 0) -> Iterator[tuple[Reason, int]]:
    """Every reason with how deep it lies; what stood in its way follows it."""
    for reason in reasons:
        yield reason, depth
        yield from _flat(reason.below, depth + 1)
