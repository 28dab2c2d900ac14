"""The link to a running robot, in Qt's own loop: no thread, no polling.

The blackboard's client does the talking (``situ.blackboard.link.Link``); this drives
it by socket notifiers and one timer, and tells the window what came.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from msgspec.structs import replace
from PySide6.QtCore import QObject, QSocketNotifier, Qt, QTimer, Signal
from shiboken6 import isValid

from situ.decide.clock import CLOCK
from situ.errors import BlackboardError, Unreachable
from situ.rehearse.clock import Hidden
from situ_studio.live.clock_seen import is_clock
from situ_studio.live.delay import Delays
from situ_studio.live.link_state import LinkState
from situ_studio.live.log import TraceLog
from situ_studio.live.moment import TraceFields
from situ_studio.wording.language import said, tr

if TYPE_CHECKING:
    from situ.blackboard.client import Call, Dialog
    from situ.blackboard.link import Link
    from situ.blackboard.replies import Entry as Standing
    from situ.blackboard.replies import ModuleState

T = TypeVar("T")


def not_asked() -> str:
    """What is said of a hand's request whose robot was lost before it was answered."""
    return tr(
        "The robot was lost meanwhile and is not asked again: see how it is now, and ask anew."
    )


class RobotLink(QObject):
    """One robot at a time; reconnects by itself until ``disconnect_robot``.

    now: the wall clock, to be compared with the robot's.
    """

    state_changed = Signal()
    """``state`` is another, in more than how far it is behind: that is so with every event."""
    came = Signal(list)
    """New trace events (plain objects), already in ``log``."""
    moment_changed = Signal()
    """``log.now`` is not what it was; at most once a turn of the loop."""
    began_anew = Signal()
    """``log`` is that of another run, and empty."""
    documents_came = Signal(dict)
    """The robot's own files: path in the project to text."""

    def __init__(
        self,
        parent: QObject | None = None,
        now: Callable[[], datetime] = lambda: datetime.now(UTC),
    ) -> None:
        super().__init__(parent)
        self.log = TraceLog()
        self.state = LinkState()
        self.files: dict[str, str] | None = None
        self.known: list[tuple[int, dict[str, str]]] = []
        """What the robot ran at an event, by its seq: its files each time that it was asked."""
        self._now = now
        self._link: Link | None = None
        self._notifiers: list[QSocketNotifier] = []
        self._restarts = self._backlog = 0
        self._delays = Delays()
        self.found = 0
        """How often a robot was found: what was meant for one is none of the next one's."""
        self._runtime: str | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._turn)

    def clock(self) -> float:
        """Seconds, the clock of ``LinkState.since``; 0 while there is no link."""
        return self._link.clock() if self._link is not None else 0.0

    def connect_robot(self, endpoint: str, key: str = "") -> None:
        """Begins to follow the robot at ``endpoint``, with the keys that lie here for it; for the
        one whose public key has the fingerprint ``key``, if that was found there.

        Raises UsageError where it is no address, or where the keys are not right.
        """
        # Sockets, asyncio and all: a tenth of the start, and most people draw without a robot.
        from situ.blackboard.client import client_keys, person
        from situ.blackboard.link import Link

        self.disconnect_robot()
        keys = client_keys(endpoint, robot=key)
        link = Link(endpoint, person(keys=keys), keys=keys)
        self._link = link
        self._feed = link.dialog.trace(since=1)
        self._clock = link.dialog.watch(f"{CLOCK}*")
        self._restarts = 0
        link.dialog.changed = self._on_dialog
        for descriptor in link.descriptors():
            notifier = QSocketNotifier(descriptor, QSocketNotifier.Type.Read, self)
            notifier.activated.connect(self._turn)
            self._notifiers.append(notifier)
        self._become(LinkState("connecting", endpoint, since=link.clock()))
        self._turn()

    def disconnect_robot(self) -> None:
        """Ends the link; the log stays to be looked at."""
        if self._link is None:
            return
        for notifier in self._notifiers:
            notifier.setEnabled(False)
            notifier.deleteLater()
        self._notifiers.clear()
        self._timer.stop()
        link, self._link = self._link, None
        link.dialog.changed = None
        link.dialog.bye()
        link.turn()
        link.close()
        self._runtime = self.files = None
        self.known = []
        self._become(LinkState())

    @property
    def connected(self) -> bool:
        return self.state.kind == "live"

    @property
    def situ(self) -> str | None:
        """The version of Situ that the robot runs; None where there is none, or it tells none."""
        return self._link.dialog.situ if self._link is not None and self.connected else None

    @property
    def looks_only(self) -> bool:
        """Whether the robot is there and its keys here are a viewer's."""
        return self.connected and self.state.looks_only

    @property
    def writer(self) -> str | None:
        """Who is told in the trace of what is done from here; None where nobody does anything."""
        person = self._link.dialog.person if self._link is not None else None
        return f"operator:{person.user}" if person is not None and person.user else None

    # -- what an operator may do ---------------------------------------------

    def set(self, asker: QObject, tags: Mapping[str, Any], told: Callable[[str], None]) -> None:
        """Sets tags; ``told`` gets one line where the robot refuses."""
        self.act(asker, lambda dialog: dialog.set(tags), lambda _: None, told)

    def publish(
        self, asker: QObject, event: str, application: str | None, told: Callable[[str], None]
    ) -> None:
        """Raises an event; ``told`` gets one line where the robot refuses."""
        self.act(asker, lambda dialog: dialog.publish(event, application), lambda _: None, told)

    def act(
        self,
        asker: QObject,
        begin: Callable[[Dialog], Call[T]],
        answered: Callable[[T], None],
        refused: Callable[[str], None],
    ) -> None:
        """A hand's request, as ``ask``, but of the robot as it is now alone: where that is lost
        before it has answered, ``refused`` is told, and the one that comes back does nothing of it.
        Where it was this window that stood still it is carried out once.
        """
        if not self.connected:
            refused(self._not_there())
            return

        def kept(dialog: Dialog) -> Call[T]:
            call = begin(dialog)
            call.otherwise = Unreachable(not_asked())
            return call

        self.ask(asker, kept, answered, refused)

    def ask_modules(self, asker: QObject, told: Callable[[tuple[ModuleState, ...]], None]) -> None:
        """Tells the modules that the robot knows; nothing where there is no answer."""
        self.ask(
            asker,
            lambda dialog: dialog.modules(),
            lambda reply: told(reply.modules),
            lambda _: None,
        )

    def ask(
        self,
        asker: QObject,
        begin: Callable[[Dialog], Call[T]],
        answered: Callable[[T], None],
        refused: Callable[[str], None],
    ) -> None:
        """Any request of the protocol; later ``answered`` gets what came, or ``refused`` one line
        that says why nothing did. Either may ask for more, connect, or hold up the loop.

        asker: whose question it is; once that is deleted nobody is told: a window made anew leaves
        the link to the next one.
        """
        if self._link is None:
            refused(self._not_there())
            return
        call = begin(self._link.dialog)

        def done() -> None:
            try:
                result = call.result()
            except BlackboardError as error:
                told = partial(refused, said(str(error)))
            else:
                told = partial(answered, result)
            if isValid(asker):
                QTimer.singleShot(0, asker, told)

        call.then(done)
        self._timer.start(0)

    def _not_there(self) -> str:
        if self.state.kind == "lost":
            return self.tr(
                "The robot does not answer. It is looked for; ask again once it is there."
            )
        return self.tr("No robot is connected.")

    # -- the loop ------------------------------------------------------------

    def _turn(self) -> None:
        link = self._link
        if link is None:
            return
        link.turn()
        if self._link is None:
            return
        self._take_events()
        self._take_clock()
        self._timer.start(max(0, round((link.due() - link.clock()) * 1000)))

    def _take_events(self) -> None:
        if self._feed.restarts != self._restarts:
            self._restarts = self._feed.restarts
            self._begin_anew()
            self._keep_clock(self._clock.known)
        events: list[TraceFields] = []
        while (event := self._feed.take()) is not None:
            events.append(event)
        if not events:
            return
        new = self.log.add(events)
        if new:
            self._measure(new[-1])
            turned = [e["seq"] for e in new if e["kind"] == "deployed"]
            if turned and turned[-1] > self._backlog:
                self._ask_documents(turned[-1])
            self.came.emit(new)
            self.moment_changed.emit()

    def _take_clock(self) -> None:
        """What the robot's clock says goes on though nothing else does."""
        came = []
        while (change := self._clock.take()) is not None:
            # Of none that it has not written: the robot began anew.
            if change.writer is not None:
                came.append(Hidden(change.time / 1e6, change.tag, change.value, change.writer))
        if came:
            self.log.keep_clock(came)
            self.moment_changed.emit()

    def _measure(self, last: TraceFields) -> None:
        written = last.get("time")
        if self.state.kind != "live" or not isinstance(written, str):
            return
        if last["seq"] <= self._backlog:
            return
        at = datetime.fromisoformat(written).timestamp()
        found = self._delays.take(last["t"], self.clock(), at, self._now().timestamp())
        self.state = replace(self.state, behind=found.behind, apart=found.apart)

    def _on_dialog(self) -> None:
        link = self._link
        if link is None:
            return
        dialog = link.dialog
        at = self.state.endpoint
        if dialog.connected and dialog.welcome is not None:
            if self.state.kind != "live":
                # What had happened before is no measure of how far behind we are.
                self._backlog = dialog.welcome.seq
                self._delays = Delays()
                self.found += 1
                self._greeted(dialog.welcome.runtime)
                project = dialog.welcome.project
                looks_only = dialog.person.role == "viewer"
                now = link.clock()
                self._become(LinkState("live", at, project, now, looks_only=looks_only))
        elif dialog.ended:
            self._become(LinkState("refused", at, since=link.clock(), why=str(dialog.problem)))
        elif self.state.kind == "live":
            self._become(LinkState("lost", at, self.state.project, link.clock()))

    def _greeted(self, runtime: str) -> None:
        """A session began: what stands there, and the robot's own documents."""
        link = self._link
        assert link is not None
        if runtime != self._runtime:
            self._runtime = runtime
            self.known = []
            self._begin_anew()
        entries = link.dialog.entries(["**"])
        entries.then(lambda: self._stand(entries))
        self._ask_documents(self._backlog)

    def _begin_anew(self) -> None:
        self.log.clear()
        self.began_anew.emit()

    def _ask_documents(self, seq: int) -> None:
        """Those that the robot runs now, after that event."""
        assert self._link is not None
        files = self._link.dialog.documents()

        def compared() -> None:
            try:
                told = files.result().files
            except BlackboardError:
                return
            # Most often they are what they were: a robot that is lost and found many times.
            last = self.known[-1][1] if self.known else None
            self.files = last if told == last else told
            self.known.append((seq, self.files))
            self.documents_came.emit(self.files)

        files.then(compared)

    def _stand(self, call: Call[dict[str, Standing]]) -> None:
        try:
            entries = call.result()
        except BlackboardError:
            return
        clock = {tag: entry for tag, entry in entries.items() if is_clock(tag)}
        self._keep_clock(clock)
        self.log.stand(
            {
                tag: (e.value, e.writer, e.time / 1e6)
                for tag, e in entries.items()
                if tag not in clock
            }
        )
        self.moment_changed.emit()

    def _keep_clock(self, entries: Mapping[str, Standing]) -> None:
        self.log.keep_clock(
            Hidden(e.time / 1e6, tag, e.value, e.writer or "") for tag, e in entries.items()
        )

    def _become(self, state: LinkState) -> None:
        if state != self.state:
            self.state = state
            self.state_changed.emit()
