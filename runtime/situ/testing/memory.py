"""What lies between a client and a core in the same process: a ``Line`` and its ``Driving``."""

from __future__ import annotations

import contextlib
import socket
from collections import deque
from collections.abc import Callable
from typing import Any, Protocol

from situ.blackboard import notices, topics, wire
from situ.blackboard.calls import Person
from situ.blackboard.dialog import Dialog
from situ.testing.shared_time import SharedTime


class Core(Protocol):
    """What lines come from, and go to."""

    time: SharedTime

    def exchange(self) -> None: ...

    def take(self, line: MemoryLine, body: bytes) -> None:
        """A request; what follows is put into the lines' ``inbox``es."""

    def closed(self, line: MemoryLine) -> None: ...


class MemoryLine:
    """As ``situ.blackboard.link.Link``, without sockets.

    inbox: (whether it is a notice, frame). cut: nothing goes through. looped: it is turned by
    a loop of its own, which is told by a descriptor; else by whoever waits.
    """

    endpoint = "a robot in memory"

    def __init__(self, person: Person, core: Core, number: int, looped: bool) -> None:
        self.dialog = Dialog(person)
        self.clock: Callable[[], float] = lambda: core.time.now
        self.inbox: deque[tuple[bool, bytes]] = deque()
        self.looped = looped
        self.cut = False
        self.peer = (number, 0)
        self._core = core
        self._topics: list[bytes] = []
        self._wakers = socket.socketpair() if looped else ()
        for waker in self._wakers:
            waker.setblocking(False)

    def descriptors(self) -> tuple[int, ...]:
        return (self._wakers[0].fileno(),) if self._wakers else ()

    def due(self) -> float:
        return self.dialog.due()

    def turn(self) -> None:
        with self._core.time.lock:
            if self._wakers:
                with contextlib.suppress(BlockingIOError):
                    self._wakers[0].recv(4096)
            self.work()
            self._core.exchange()

    def close(self) -> None:
        self._core.closed(self)
        for waker in self._wakers:
            waker.close()

    def work(self) -> bool:
        """Takes what has come, does what is due, sends what is to be sent; whether there was
        anything."""
        dialog, now = self.dialog, self.clock()
        busy = False
        while self.inbox:
            busy = True
            is_notice, frame = self.inbox.popleft()
            (dialog.hear if is_notice else dialog.receive)(frame, now)
        dialog.tick(now)
        while dialog.subscribing:
            busy = True
            topic, on = dialog.subscribing.popleft()
            if on:
                self._topics.append(topic)
                if topic.startswith(topics.ECHO):
                    self.put(True, wire.notice(topic + b"\n", notices.Echo()))
            elif topic in self._topics:
                self._topics.remove(topic)
        while dialog.outgoing and not self.cut:
            busy = True
            self._core.take(self, dialog.outgoing.popleft())
        return busy

    def hear(self, frame: bytes) -> None:
        """A notice, for whoever has subscribed to it."""
        if any(frame.startswith(topic) for topic in self._topics):
            self.put(True, frame)

    def put(self, is_notice: bool, frame: bytes) -> None:
        if self.cut:
            return
        self.inbox.append((is_notice, frame))
        if self._wakers:
            with contextlib.suppress(BlockingIOError):
                self._wakers[1].send(b"\0")

    def lose(self) -> None:
        """The connection is cut."""
        self.cut = True
        self.inbox.clear()

    def regain(self) -> None:
        """It is there again, as another one."""
        self.cut = False
        self.peer = (self.peer[0], self.peer[1] + 1)


class MemoryDriver:
    """``situ.blackboard.driving.Driving`` in shared time."""

    def __init__(self, line: MemoryLine, time: SharedTime) -> None:
        self.line = line
        self._time = time
        self._shut = False

    @property
    def closed(self) -> bool:
        return self._shut or self._time.over

    @property
    def lock(self) -> contextlib.AbstractContextManager[Any]:
        return self._time.lock

    def start(self, close: Callable[[], None]) -> None:
        pass

    def check(self) -> None:
        pass

    def until(self, ready: Callable[[], bool], timeout: float | None) -> bool:
        self._time.until(lambda: ready() or self._shut, timeout)
        return ready()

    def wake(self) -> None:
        self._time.woken()

    def shut(self) -> None:
        self._shut = self.line.dialog.ended = True
        self._time.woken()
        self.line.close()
