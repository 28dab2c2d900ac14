"""An operator's hand: what a window asks the robot's debugger for, and what is told of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QSizePolicy

from situ.decide.expected import Expectation
from situ.document import when_text
from situ.document.condition import Condition
from situ.document.rbd import Application
from situ.rehearse.telling import kept_by_runtime
from situ.rehearse.ways import frames
from situ_studio.commands.context_menus import context_of
from situ_studio.commands.reasons import reasons
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.live.breaking import KeptBreakpoints, Point, everywhere, point_of, points_at
from situ_studio.live.breakpoints import Breakpoints
from situ_studio.live.link import not_asked
from situ_studio.live.moment import ApplicationMoment
from situ_studio.live.raising_dialog import offers
from situ_studio.live.views import runs_of
from situ_studio.looks.theme import Theme
from situ_studio.widgets.icon_widgets import Elided
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ.blackboard.protocol import DebugVerb
    from situ_studio.window.main_window import MainWindow


class OperatingSide(QObject):
    """To be made after the window's ``robot``. Everything is about the document that is worked in:
    its application is paused, its selected state is where the robot is sent.

    The robot refuses who is no operator; why, is said in the status bar.
    """

    refused = Signal(str)
    """The robot did not do it, in words."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._link = link = window.robot.link
        self.waiting = Elided(role="medium")
        self.waiting.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Preferred)
        self.waiting.hide()
        window.status.insertWidget(1, self.waiting)
        self.panel = Breakpoints(window.theme, window.robot.state_name)
        self.panel.removed.connect(self._remove)
        self.panel.conditioned.connect(self._condition)
        self.panel.wanted_again.connect(self._set_again)
        self.panel.condition.refused.connect(self._refused)
        self.panel.table.when_chosen(self._go_to_breakpoint)
        self._kept = KeptBreakpoints(window.settings)
        window.bottom.add("breakpoints", self.tr("Breakpoints"), self.panel)
        window.bottom.set_shown("breakpoints", False)
        self._seen: object = None
        window.session.opened.connect(self._settle)
        link.moment_changed.connect(self._settle)
        link.state_changed.connect(self._settle)

    # -- what can be done ----------------------------------------------------

    @property
    def can_operate(self) -> bool:
        """Whether a robot is there to be told something, and is what all views show: a hand that
        means a rehearsal stops no robot.
        """
        viewing = self._window.robot.follower.viewing
        return self._link.connected and viewing.log is self._link.log

    @property
    def is_paused(self) -> bool:
        """Whether the application that is worked in is, elsewhere: any."""
        return self.can_operate and any(one.paused for one in self._moments)

    @property
    def can_pause(self) -> bool:
        return self.can_operate and any(not one.paused for one in self._moments)

    @property
    def can_break(self) -> bool:
        return self.can_operate and bool(self._points)

    @property
    def can_go_to(self) -> bool:
        return self.can_operate and any("state" in point for point in self._points)

    @property
    def has_breakpoints(self) -> bool:
        return self.can_operate and bool(self._link.log.now.breakpoints)

    @property
    def application(self) -> str | None:
        """The name of the one that is worked in."""
        window = self._window
        document, file, project = (
            window.current_document,
            window.current_file or "",
            window.session.project,
        )
        if not isinstance(document, Application) or project is None:
            return None
        if not window.parts.is_part(file):
            return document.name
        every = {name for name, _ in runs_of(project).get(file, ())}
        return every.pop() if len(every) == 1 else None

    # -- what is done ----------------------------------------------------------

    def pause(self) -> None:
        self._ask("pause", application=self.application)

    def resume(self) -> None:
        self._ask("resume", application=self.application)

    def step(self) -> None:
        every = self._link.log.now.applications
        paused = [name for name, one in every.items() if one.paused]
        self._ask("step", application=self.application or paused[0])

    def go_to(self) -> None:
        """The application leaves its state for the selected one: in the part that it is in now,
        where that runs in several states.
        """
        every = [point for point in self._points if "state" in point]
        now = self._link.log.now.applications

        def here(point: Point) -> bool:
            state = now[point["application"]].state if point["application"] in now else None
            return bool((state or "").rpartition("/")[0] == point["state"].rpartition("/")[0])

        point = next(filter(here, every), every[0])
        self._ask("goto", application=point["application"], state=point["state"])

    def toggle_breakpoint(self) -> None:
        """One stands where there was none, or none where there was one."""
        points = self._points
        standing = [one for one in self._standing if point_of(one) in points]
        for one in standing:
            self._unbreak(one)
        if not standing:
            for point in points:
                self._break(point)

    def break_while(self) -> None:
        """The selected place gets a breakpoint, if it has none, and that a condition."""
        points = self._points
        if not points:
            return
        self._window.bottom.set_shown("breakpoints", True)
        self._window.bottom.choose("breakpoints")
        self.panel.add_test(points)
        standing = [point_of(one) for one in self._standing]
        lacking = [point for point in points if point not in standing]
        for point in lacking:
            self._break(point)
        if not lacking:
            self._show()

    def clear_breakpoints(self) -> None:
        root = self._root

        def done() -> None:
            if root is not None:
                self._kept.clear(root)
                self._show()

        self._ask("unbreak", done)

    def _break(self, point: Point, done: Callable[[], None] = lambda: None) -> None:
        root = self._root

        def kept() -> None:
            if root is not None:
                self._kept.add(root, point)
            done()

        # The protocol's word is a keyword of Python.
        fields = {"source" if key == "from" else key: value for key, value in point.items()}
        self._ask("break", kept, **fields)

    def _unbreak(self, one: Point) -> None:
        root = self._root

        def forgotten() -> None:
            if root is not None:
                self._kept.remove(root, one)
                self._show()

        self._ask("unbreak", forgotten, breakpoint=one["id"])

    def _remove(self, key: str) -> None:
        one = self.panel.point(key)
        if one is None:
            return
        if "id" in one and self._link.looks_only:
            self._window.say(reasons()["may_operate"])
        elif "id" in one:
            self._unbreak(one)
        elif self._root is not None:
            self._kept.remove(self._root, one)
            self._show()

    def _condition(self, key: str, condition: Condition | None) -> None:
        one = self.panel.point(key)
        if one is not None:
            self.panel.sought.want(one, condition, self._exchange)
            self._show()

    def _exchange(self, one: Point, condition: Condition | None) -> set[int]:
        """Others in place of that one, and of those at the same place of a part in the other states
        that run it, if they had the same condition.
        """
        same, going = self._same_place(one), set()
        for each in self._standing:
            if each["id"] != one["id"] and (
                point_of(each) not in same or each.get("when") != one.get("when")
            ):
                continue
            point = point_of(each)
            if condition is not None:
                point = {**point, "when": when_text.write(condition)}
            self._break(point, partial(self._ask, "unbreak", breakpoint=each["id"]))
            going.add(each["id"])
        return going

    def _same_place(self, one: Point) -> list[Point]:
        """Where that breakpoint stands, in every state that runs its part."""
        project = self._window.session.project
        return everywhere(project, point_of(one)) if project is not None else []

    def _set_again(self) -> None:
        for point in self._earlier:
            self._break(point)

    def raise_event(self) -> None:
        """Asks which one, once the robot has told what it expects now; the selected transition's
        is offered first.
        """
        ask = partial(self._ask_event, self._link.found)
        self._link.ask(self, lambda dialog: dialog.expected(), ask, self._refused)

    def _ask_event(self, found: int, expected: Mapping[str, Expectation]) -> None:
        """found: as ``RobotLink.found`` was when somebody wanted to raise one."""
        if not self._is_still(found):
            return
        document, place, usual = self._window.current_document, self._selected, ""
        if isinstance(document, Application) and context_of((place,) if place else ()) == "exit":
            usual = getattr(places.get(document, place), "name", None) or ""
        offered, known = offers(expected, self.application), self._vocabulary.events
        event = self._window.dialogs.raising(offered, usual, known)
        if event is not None and self._is_still(found):
            self._link.publish(self, event, self.application, self._refused)

    def set_value(self) -> None:
        """Asks which one, and what."""
        board, found = self._link.log.now.board, self._link.found
        now = {
            tag: one.value
            for tag, one in board.items()
            if one.value is not None and not kept_by_runtime(tag)
        }
        given = self._window.dialogs.setting(self._vocabulary, now)
        if given is not None and self._is_still(found):
            self._link.set(self, {given.tag: given.value}, self._refused)

    # -- inside ----------------------------------------------------------------

    @property
    def _moments(self) -> list[ApplicationMoment]:
        """Of the application that is worked in; elsewhere of all."""
        every = self._link.log.now.applications
        if self.application in every:
            return [every[self.application]]
        return list(every.values())

    @property
    def _selected(self) -> Place:
        """The one place that is selected, or nothing."""
        view = self._window.current_view
        return view.selected[0] if view is not None and len(view.selected) == 1 else ()

    @property
    def _points(self) -> list[Point]:
        """The breakpoints that the selection means."""
        window, project = self._window, self._window.session.project
        document, file = window.current_document, window.current_file
        if project is None or document is None or file is None:
            return []
        return points_at(project, file, document, self._selected)

    @property
    def _vocabulary(self) -> Vocabulary:
        """The words of the whole project."""
        window, project = self._window, self._window.session.project
        document = project.spds if project is not None else None
        return window.vocabulary(document or window.current_document)

    @property
    def _standing(self) -> tuple[Point, ...]:
        return self._link.log.now.breakpoints if self.can_operate else ()

    @property
    def _root(self) -> str | None:
        project = self._window.session.project
        return str(project.root) if project is not None else None

    @property
    def _earlier(self) -> list[Point]:
        """Those that were set in this project before, and that the robot has not."""
        if self._root is None or not self.can_operate:
            return []
        standing = [point_of(one) for one in self._standing]
        return [one for one in self._kept.of(self._root) if point_of(one) not in standing]

    def _ask(self, verb: DebugVerb, done: Callable[[], None] = lambda: None, **fields: Any) -> None:
        def answered(_: object) -> None:
            done()

        def refused(why: str) -> None:
            self._refused(why)
            # What stands at that place some day was set without one.
            self.panel.add_test(())
            self.panel.sought.forget()
            self._show()

        self._link.act(self, lambda dialog: dialog.debug(verb, **fields), answered, refused)

    def _is_still(self, found: int) -> bool:
        """Whether the robot is the one that a question was about; if not, that is said."""
        still = self._link.connected and self._link.found == found
        if not still:
            self._refused(not_asked())
        return still

    def _go_to_breakpoint(self, key: str) -> None:
        """Shows what it stands on."""
        one, project = self.panel.point(key), self._window.session.project
        if one is None or project is None:
            return
        if one.get("situation") is not None and project.spds_file is not None:
            self._window.go_to(project.spds_file, ("situation", one["situation"]))
            return
        path = one.get("state") or one.get("from") or one.get("to") or ""
        active = frames(project, one.get("application") or "", path)
        if active:
            self._window.go_to(active[-1].file, ("state", active[-1].state.no))

    def set_theme(self, theme: Theme) -> None:
        self.panel.set_theme(theme)

    def _refused(self, why: str) -> None:
        self._window.say(said(why))
        self.refused.emit(why)

    def _settle(self) -> None:
        """What waits where stands in the status bar; the commands are those that can be done."""
        now = self._link.log.now
        paused = {n: (one.state, one.stopped) for n, one in now.applications.items() if one.paused}
        if not self.can_operate:
            paused = {}
        seen = (self.can_operate, paused, now.breakpoints, self.can_pause, self._root)
        if seen == self._seen:
            return
        self._seen = seen
        self.panel.sought.told(self._standing, self._exchange)
        before = self.waiting.text()
        self.waiting.setText(", ".join(self._waiting(name, *one) for name, one in paused.items()))
        if self.waiting.text() != before:
            self._window.status.announcements.tell(self.waiting.text())
        self.waiting.setVisible(bool(paused))
        self._show()
        self._window.actions_.refresh()

    def _show(self) -> None:
        """The panel is there while there is something in it."""
        every = self._link.log.now.applications.values()
        stopped = frozenset(one.stopped for one in every if one.paused and one.stopped is not None)
        earlier, window = self._earlier, self._window
        self.panel.show_breakpoints(
            self._standing, stopped, earlier, self._vocabulary, not self._link.looks_only
        )
        window.bottom.set_shown("breakpoints", bool(self._standing or earlier))

    def _waiting(self, name: str, state: str | None, stopped: int | None) -> str:
        where = self._window.robot.state_name(name, state or "")
        if stopped is None:
            return self.tr("{0} is paused at {1}").format(name, where)
        return self.tr("{0} is paused at {1}, at breakpoint {2}").format(name, where, stopped)
