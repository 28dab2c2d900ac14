"""Time that stands while anybody computes, for all threads of a test.

It moves only while every one of them waits, and then to when the next thing falls due. So
no test sleeps, none is ever too slow, and what comes out does not depend on the machine.
"""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Iterable
from selectors import DefaultSelector, SelectorKey

from situ.errors import BlackboardError, Unreachable

COMPUTING = 10.0
"""Real seconds after which a thread that does not come to wait is told of."""
FOREVER = 600.0
"""Seconds of the robot's time that a test waits at most where it names no end."""

Ready = Callable[[], bool]


class SharedTime:
    """now: seconds since the start.

    exchange: carries messages until nobody has any left. due: when the next of what it carries
    falls due. untold: whether callbacks are to be called. These and every ``ready`` are called
    with ``lock``. tell: calls the callbacks, without it.
    """

    def __init__(
        self,
        exchange: Callable[[], None],
        due: Callable[[], float],
        untold: Callable[[], bool],
        tell: Callable[[], None],
    ) -> None:
        self.now = 0.0
        self.lock = threading.Condition(threading.Lock())
        self.over = False
        self._exchange = exchange
        self._due = due
        self._untold = untold
        self._tell = tell
        self._owner = threading.get_ident()
        self._threads = {self._owner}
        self._waiting: dict[int, tuple[Ready, float | None]] = {}

    def until(self, ready: Ready, timeout: float | None, loop: bool = False) -> bool:
        """Waits until ``ready()``; False when ``timeout`` seconds are over, or all is over.

        Raises Unreachable in a module's thread when the test is over, so that it ends; not in
        a loop, whose tasks are cancelled.
        """
        me = threading.get_ident()
        end = None if timeout is None else self.now + timeout
        last = self.now + FOREVER if me == self._owner and end is None else None
        while True:
            # Callbacks may wait in their turn.
            self._tell()
            with self.lock:
                self._exchange()
                if self.over and me != self._owner and not loop:
                    raise Unreachable("the test is over")
                if ready():
                    return True
                if self.over:
                    self.now = self.now if end is None else max(self.now, end)
                    return False
                if end is not None and self.now >= end:
                    return False
                if last is not None and self.now >= last:
                    raise BlackboardError(
                        f"nothing came in {FOREVER:g} seconds of the robot's time: "
                        "say how long to wait (within)"
                    )
                if self._untold():
                    continue
                self._waiting[me] = (ready, end if last is None else last)
                try:
                    self._rest(me)
                finally:
                    del self._waiting[me]

    def settle(self) -> None:
        """Returns when every other thread waits for what has not come, at this moment."""
        me = threading.get_ident()
        while True:
            self._tell()
            with self.lock:
                self._exchange()
                if self._untold():
                    continue
                if all(self._rests(thread) for thread in self._threads if thread != me):
                    return
                self._pause()

    def join(self) -> None:
        """This thread takes part: time stands while it computes."""
        with self.lock:
            self._threads.add(threading.get_ident())

    def leave(self) -> None:
        """This thread takes part no longer."""
        with self.lock:
            self._threads.discard(threading.get_ident())
            self.lock.notify_all()

    def end(self, tasks: Iterable[Callable[[], None]] = ()) -> None:
        """Ends all waiting. tasks: cancel those of the loops, and are called with ``lock``."""
        with self.lock:
            self.over = True
            # At once: a loop that woke in between would go on to what it waits for.
            for cancel in tasks:
                cancel()
            self.lock.notify_all()

    def woken(self) -> None:
        """Something may have come for one of the threads."""
        with self.lock:
            self.lock.notify_all()

    def _rests(self, thread: int) -> bool:
        if thread not in self._waiting:
            return False
        ready, end = self._waiting[thread]
        return not ready() and (end is None or self.now < end)

    def _rest(self, me: int) -> None:
        """One moment further, where all wait; else until another has done something."""
        if any(not self._rests(thread) for thread in self._threads | self._waiting.keys()):
            self._pause()
            return
        ends = [end for _, end in self._waiting.values() if end is not None]
        self.now = max(self.now, min([self._due(), *ends]))
        self.lock.notify_all()

    def _pause(self) -> None:
        self.lock.notify_all()
        if not self.lock.wait(COMPUTING) and threading.get_ident() == self._owner:
            raise BlackboardError(
                f"a module has not come back to the blackboard in {COMPUTING:g} seconds: "
                "what it waits for (a camera, time.sleep) must not be in a test"
            )


class Selector(DefaultSelector):
    """Waits for descriptors in shared time."""

    def __init__(self, time: SharedTime) -> None:
        super().__init__()
        self._time = time

    def select(self, timeout: float | None = None) -> list[tuple[SelectorKey, int]]:
        found = super().select(0)
        if found or (timeout is not None and timeout <= 0):
            return found
        self._time.until(self._has_some, timeout, loop=True)
        return super().select(0)

    def _has_some(self) -> bool:
        return bool(super().select(0))


class Loop(asyncio.SelectorEventLoop):
    """An asyncio loop whose time is the shared one: ``asyncio.sleep`` takes none of ours."""

    def __init__(self, time: SharedTime) -> None:
        self._shared = time
        super().__init__(Selector(time))

    def time(self) -> float:
        return self._shared.now
