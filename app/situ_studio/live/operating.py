"""An operator's hand: what a window asks the robot's debugger for, and what is told of it."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QLabel

from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio import places
from situ_studio.context_menus import context_of
from situ_studio.edit import Place
from situ_studio.language import said
from situ_studio.live.breakpoints import Breakpoints
from situ_studio.live.moment import ApplicationMoment
from situ_studio.theme import Theme

if TYPE_CHECKING:
    from situ.blackboard.protocol import DebugVerb
    from situ_studio.window import MainWindow


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
        self.waiting = QLabel()
        self.waiting.setAccessibleName(self.tr("Where the robot is paused"))
        self.waiting.setProperty("role", "medium")
        self.waiting.hide()
        window.status.insertWidget(1, self.waiting)
        self.panel = Breakpoints(window.theme, window.robot.state_name)
        self.panel.removed.connect(lambda number: self._ask("unbreak", breakpoint=number))
        self.panel.when_chosen(self._go_to_breakpoint)
        window.bottom.add("breakpoints", self.tr("Breakpoints"), self.panel)
        window.bottom.set_shown("breakpoints", False)
        self._seen: object = None
        link.moment_changed.connect(self._settle)
        link.state_changed.connect(self._settle)

    # -- what can be done ----------------------------------------------------

    @property
    def can_operate(self) -> bool:
        """Whether a robot is there to be told something."""
        return self._link.connected

    @property
    def is_paused(self) -> bool:
        """Whether the application that is worked in is, elsewhere: any."""
        return self.can_operate and any(one.paused for one in self._moments)

    @property
    def can_pause(self) -> bool:
        return self.can_operate and any(not one.paused for one in self._moments)

    @property
    def can_break(self) -> bool:
        return self.can_operate and self._point is not None

    @property
    def can_go_to(self) -> bool:
        return self.can_operate and self.application is not None and self._state is not None

    @property
    def has_breakpoints(self) -> bool:
        return self.can_operate and bool(self._link.log.now.breakpoints)

    @property
    def application(self) -> str | None:
        """The name of the one that is worked in."""
        window = self._window
        document, file = window.current_document, window.current_file
        if isinstance(document, Application) and not window.parts.is_part(file or ""):
            return document.name
        return None

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
        """The application leaves its state for the selected one."""
        self._ask("goto", application=self.application, state=self._state)

    def toggle_breakpoint(self) -> None:
        """One stands where there was none, or none where there was one."""
        point = self._point
        if point is None:
            return
        for one in self._link.log.now.breakpoints:
            if all(one.get(key) == point.get(key) for key in _POINT):
                self._ask("unbreak", breakpoint=one["id"])
                return
        # The protocol's word is a keyword of Python.
        fields = {"source" if key == "from" else key: value for key, value in point.items()}
        self._ask("break", **fields)

    def clear_breakpoints(self) -> None:
        self._ask("unbreak")

    def raise_event(self) -> None:
        """Asks which one; the selected transition's unless another is named."""
        document, place = self._window.current_document, self._selected
        usual = ""
        if isinstance(document, Application) and context_of((place,) if place else ()) == "exit":
            usual = getattr(places.get(document, place), "name", None) or ""
        dialogs = self._window.dialogs
        event = dialogs.name(self.tr("Raise an event"), self.tr("Event"), usual)
        if event is not None:
            self._link.publish(event, self.application, self._refused)

    def set_value(self) -> None:
        """Asks which one, and what."""
        title, label = self.tr("Set a value"), self.tr("Tag = value; nothing behind = removes it")
        given = self._window.dialogs.name(title, label, "")
        if given is None:
            return
        tag, sign, text = given.partition("=")
        if not sign:
            self._window.say(self.tr("Write it as tag = value, like volume = 40."))
            return
        self._link.set({tag.strip(): read(text)}, self._refused)

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
    def _state(self) -> str | None:
        place = self._selected
        return place[1] if len(place) == 2 and place[0] == "state" else None

    @property
    def _point(self) -> dict[str, Any] | None:
        """The breakpoint that the selection means."""
        place, application = self._selected, self.application
        if place[:1] == ("situation",) and len(place) == 2:
            return {"situation": place[1]}
        if application is None or place[:1] != ("state",):
            return None
        if self._state is not None:
            return {"application": application, "state": self._state}
        document = self._window.current_document
        if document is None or context_of((place,)) != "exit":
            return None
        leaving = places.get(document, place)
        to = getattr(leaving, "next", None)
        if not to or to.startswith("#"):
            return {"application": application, "from": place[1]}
        return {"application": application, "from": place[1], "to": to}

    def _ask(self, verb: DebugVerb, **fields: Any) -> None:
        def done(_: object) -> None:
            return

        self._link.ask(lambda dialog: dialog.debug(verb, **fields), done, self._refused)

    def _go_to_breakpoint(self, key: str) -> None:
        """Shows what it stands on."""
        for one in self._link.log.now.breakpoints:
            if str(one["id"]) != key:
                continue
            state = one.get("state") or one.get("from") or one.get("to")
            for file, document in self._window.robot.live_documents().items():
                if isinstance(document, Spds) and one.get("situation") is not None:
                    self._window.go_to(file, ("situation", one["situation"]))
                mine = isinstance(document, Application) and document.name == one.get("application")
                if mine and state is not None:
                    self._window.go_to(file, ("state", state.partition("/")[0]))

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
        seen = (self.can_operate, paused, now.breakpoints, self.can_pause)
        if seen == self._seen:
            return
        self._seen = seen
        self.waiting.setText(", ".join(self._waiting(name, *one) for name, one in paused.items()))
        self.waiting.setVisible(bool(paused))
        stopped = frozenset(number for _, number in paused.values() if number is not None)
        self.panel.show_breakpoints(now.breakpoints, stopped)
        self._window.bottom.set_shown("breakpoints", self.has_breakpoints)
        self._window.actions_.refresh()

    def _waiting(self, name: str, state: str | None, stopped: int | None) -> str:
        where = self._window.robot.state_name(name, state or "")
        if stopped is None:
            return self.tr("{0} is paused at {1}").format(name, where)
        return self.tr("{0} is paused at {1}, at breakpoint {2}").format(name, where, stopped)


_POINT = ("application", "state", "from", "to", "situation")


def read(text: str) -> Any:
    """A value as a person types it: numbers, ``true``, lists, objects as JSON has them; all else
    is text. None where nothing is typed."""
    text = text.strip()
    if not text:
        return None
    try:
        return json.loads(text)
    except ValueError:
        return text
