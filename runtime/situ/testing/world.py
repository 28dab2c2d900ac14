"""The core of a robot in memory, and the lines that lead to it."""

from __future__ import annotations

import math
import threading
from typing import Any

import msgspec

from situ.blackboard.calls import Person
from situ.blackboard.core import Core, Outgoing
from situ.blackboard.replies import Addresses
from situ.blackboard.session import Sessions
from situ.decide import inputs
from situ.decide.robot import Robot
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent
from situ.document.project import Project
from situ.errors import BlackboardError
from situ.testing.memory import MemoryLine
from situ.testing.shared_time import SharedTime


class World:
    """trace: every event so far. failures: what callbacks and modules raised.

    ``exchange``, ``take`` and ``begin`` are called with ``time.lock``.
    """

    def __init__(self, project: Project, seed: int, auto_finish: float | None) -> None:
        self.trace: list[dict[str, Any]] = []
        self.failures: list[BaseException] = []
        self.time = SharedTime(self.exchange, self._due, self._untold, self._tell)
        self._project = project
        self._options = seed, auto_finish
        self._lines: dict[object, MemoryLine] = {}
        self._connections = 0
        self._telling = threading.Lock()
        self.begin()

    def begin(self) -> None:
        """A core that has just been started."""
        self._begun = self._micros()
        seed, auto_finish = self._options
        self.core = Core(Robot(self._project), self._project, heard=self._heard)
        self._sessions = Sessions(self.core, Addresses("memory", "memory"))
        self._sessions.start(seed, auto_finish)
        self._deliver(self._sessions.take())

    def line(self, who: Person, looped: bool) -> MemoryLine:
        """Another way to the core."""
        self._connections += 1
        line = MemoryLine(who, self, self._connections, looped)
        with self.time.lock:
            self._lines[line.peer] = line
        return line

    def lines(self) -> list[MemoryLine]:
        return list(self._lines.values())

    def of(self, module: str) -> list[MemoryLine]:
        """The lines of a module. Raises BlackboardError where it has none."""
        found = [one for one in self._lines.values() if one.dialog.person.module == module]
        if not found:
            raise BlackboardError(f"no module {module} was connected in this test")
        return found

    def regain(self, line: MemoryLine) -> None:
        """A line that was cut is there again, as another connection."""
        del self._lines[line.peer]
        line.regain()
        self._lines[line.peer] = line

    def submit(self, given: inputs.AnyInput) -> str | None:
        """An input from outside; why it was refused, or None."""
        with self.time.lock:
            refused = self._sessions.submit(given, self._moment())
            self._deliver(self._sessions.take())
        return refused

    # -- for the lines -------------------------------------------------------

    def exchange(self) -> None:
        """Does what is due, and carries messages until nobody has any left."""
        moment = self._moment()
        if (due := self._sessions.due()) is not None and due <= moment:
            self._sessions.advance(moment)
            self._deliver(self._sessions.take())
        busy = True
        while busy:
            busy = False
            for line in self._kept():
                busy |= line.work()

    def take(self, line: MemoryLine, body: bytes) -> None:
        """A request; what follows is put into the lines' ``inbox``es."""
        self._sessions.receive(line.peer, body, self._moment())
        self._deliver(self._sessions.take())

    def closed(self, line: MemoryLine) -> None:
        """The line is used no longer."""
        with self.time.lock:
            self._lines.pop(line.peer, None)

    def _kept(self) -> list[MemoryLine]:
        return [line for line in self._lines.values() if not line.looped]

    def _deliver(self, out: Outgoing) -> None:
        for frame in out.notices:
            for line in self._lines.values():
                line.hear(frame)
        for peer, body in out.replies:
            if peer in self._lines:
                self._lines[peer].put(False, body)

    def _heard(self, events: list[TraceEvent], moment: float) -> None:
        # How the modules end with the test is nothing that happened to the robot.
        if not self.time.over:
            self.trace += [msgspec.to_builtins(event) for event in events]

    # -- for time ------------------------------------------------------------

    def _due(self) -> float:
        due = self._sessions.due()
        core = math.inf if due is None else (due + self._begun) / SECOND
        return min([core, *(line.due() for line in self._kept())])

    def _called(self) -> list[Any]:
        """What has something for its callback."""
        following = (one for line in self._kept() for one in line.dialog.following())
        return [one for one in following if one.callback is not None and len(one)]

    def _untold(self) -> bool:
        return not self._telling.locked() and bool(self._called())

    def _tell(self) -> None:
        """Calls callbacks, one at a time."""
        if not self._telling.acquire(blocking=False):
            return
        try:
            with self.time.lock:
                told = [
                    (one.callback, item) for one in self._called() for item in iter(one.take, None)
                ]
            for callback, item in told:
                try:
                    callback(item)
                except Exception as error:
                    self.failures.append(error)
        finally:
            self._telling.release()

    def _micros(self) -> int:
        return round(self.time.now * SECOND)

    def _moment(self) -> int:
        """The core's time, in µs since its start."""
        return self._micros() - self._begun
