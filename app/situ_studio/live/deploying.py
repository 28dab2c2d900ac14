"""A deploy, or a way back, from its first byte to the end of its first minute.

It is told by polling, so that it goes on over losses of the link and starts of the robot.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Literal, TypeVar

from PySide6.QtCore import QObject, QTimer, Signal

from situ_studio.live.link import RobotLink

if TYPE_CHECKING:
    from situ.blackboard.calls import Call
    from situ.blackboard.dialog import Dialog
    from situ.blackboard.replies import Deployment, Staged, Turns

POLL = 200
"""Milliseconds between two questions how far it is."""
T = TypeVar("T")
Kind = Literal["idle", "sending", "robot", "failed", "elsewhere"]


class Deploying(QObject):
    """One at a time, over one link.

    kind: ``sending``; ``robot``: as ``state`` tells; ``failed``: ``why`` the robot did not take it;
    ``elsewhere``: another version runs, ``why`` says more. number: the version that was asked for.
    sent, size: bytes. turns: what happened to the robot's versions; None before it is known.
    """

    changed = Signal()
    """Anything of it is another."""
    ended = Signal()
    """It runs and counts, was refused, or the robot has gone back."""

    def __init__(self, link: RobotLink, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._link = link
        self.kind: Kind = "idle"
        self.state: Deployment | None = None
        self.turns: Turns | None = None
        self.number: int | None = None
        self.sent = self.size = 0
        self.why = ""
        self._attempt = 0
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(POLL)
        self._timer.timeout.connect(self._poll)
        link.state_changed.connect(self._on_link)

    @property
    def stands(self) -> str:
        """``idle``, ``sending``, ``failed``, ``elsewhere``, or how it stands with the robot:
        ``checking``, ``waiting``, ``running``, ``refused`` or ``returned``."""
        if self.kind == "robot":
            assert self.state is not None
            return self.state.stands
        return self.kind

    @property
    def is_on_its_way(self) -> bool:
        """Whether the robot does not run it yet, and may still come to do so."""
        return self.stands in ("sending", "checking", "waiting")

    @property
    def is_on_trial(self) -> bool:
        """Whether it runs, and the robot would still go back by itself."""
        state = self.state
        return self.stands == "running" and state is not None and state.minute is not None

    # -- what a person does --------------------------------------------------

    def deploy(self, files: Mapping[str, bytes], main: str, force_after: float | None) -> None:
        """Sends files, as ``Plan`` has them, to be run. force_after: seconds; None: the robot waits
        for its safe point as long as it takes."""
        from situ.blackboard import sending

        self._begin("sending")
        self.size = sum(map(len, files.values()))

        def staged(reply: Staged) -> None:
            self.size = sum(len(files[path]) for path in reply.wanted)
            send(sending.pieces(files, reply.wanted))

        def send(pieces: Iterator[tuple[str, int, bytes]]) -> None:
            piece = next(pieces, None)
            if piece is None:
                self._ask(lambda dialog: sending.deploy(dialog, force_after), self._asked)
                return

            def came(_: object) -> None:
                self.sent += len(piece[2])
                self.changed.emit()
                send(pieces)

            self._ask(lambda dialog: sending.send(dialog, piece), came)

        self._ask(lambda dialog: sending.stage(dialog, files, main), staged)
        self.changed.emit()

    def rollback(self, version: int | None = None, force_after: float | None = None) -> None:
        """Has a former version run again; None: the one that ran before."""
        from situ.blackboard import sending

        self._begin("sending")
        self._ask(lambda dialog: sending.rollback(dialog, version, force_after), self._asked)
        self.changed.emit()

    def stop(self) -> None:
        """What is on its way does not come: the robot goes on with what it runs."""
        if self.stands == "sending":
            self._begin("idle")
            self.changed.emit()
        elif self.is_on_its_way and self.state is not None:
            self.rollback(self.state.version)

    @property
    def is_connected(self) -> bool:
        """Whether the robot is there."""
        return self._link.connected

    def is_paused(self, application: str) -> bool:
        """Whether somebody has paused it: nothing that it does ends then."""
        one = self._link.log.now.applications.get(application)
        return one is not None and one.paused

    @property
    def is_allowed(self) -> bool:
        """Whether the robot takes versions from who is connected."""
        return not self._link.looks_only

    def ask_history(self) -> None:
        from situ.blackboard import sending

        def told(turns: Turns) -> None:
            self.turns = turns
            self.changed.emit()

        self._link.ask(self, sending.history, told, lambda _: None)

    # -- how it goes on ------------------------------------------------------

    def _begin(self, kind: Kind) -> None:
        self._attempt += 1
        self._timer.stop()
        self.kind, self.why, self.state, self.number = kind, "", None, None
        self.sent = self.size = 0

    def _ask(self, begin: Callable[[Dialog], Call[T]], answered: Callable[[T], None]) -> None:
        """What is answered to an attempt that was given up is passed over."""
        attempt = self._attempt

        def well(reply: T) -> None:
            if attempt == self._attempt:
                answered(reply)

        def ill(why: str) -> None:
            if attempt == self._attempt:
                self._end("failed", why)

        self._link.ask(self, begin, well, ill)

    def _asked(self, state: Deployment) -> None:
        self.number = state.asked
        self._take(state)

    def _take(self, state: Deployment) -> None:
        if state.asked != self.number and not (state.stands == "refused" and state.waits):
            # The robot was started again, or somebody else asked for another version.
            from situ.blackboard import sending

            self._ask(sending.history, self._look_back)
            return
        before, self.state, self.kind = self.state, state, "robot"
        if before is None or before.stands != state.stands:
            self.ask_history()
        if state.stands in ("refused", "returned"):
            self._end("robot", "\n".join(state.problems))
        elif state.stands == "running" and state.minute is None:
            self._end("robot", "")
        else:
            self._timer.start()
            self.changed.emit()

    def _look_back(self, turns: Turns) -> None:
        """Which version runs, where progress does not know of ours."""
        self.turns = turns
        mine = [i for i, turn in enumerate(turns.turns) if turn.version == self.number]
        after = turns.turns[mine[-1] + 1 :] if mine else ()
        if after and after[0].did == "returned":
            self._end("elsewhere", after[0].why)
        else:
            self._end("elsewhere", "")

    def _poll(self) -> None:
        from situ.blackboard import sending

        self._ask(sending.progress, self._take)

    def _end(self, kind: Kind, why: str) -> None:
        self._timer.stop()
        self.kind, self.why = kind, why
        self.changed.emit()
        self.ended.emit()

    def _on_link(self) -> None:
        if self._link.state.kind == "none" and (self.kind != "idle" or self.turns is not None):
            self._begin("idle")
            self.turns = None
            self.changed.emit()
