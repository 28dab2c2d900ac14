"""Who drives the link of a client that blocks: whoever waits, else a thread in the background."""

from __future__ import annotations

import atexit
import contextlib
import logging
import os
import select
import socket
import threading
import time
from collections.abc import Callable
from typing import Any, Protocol

from situ.blackboard.dialog import Dialog
from situ.blackboard.feeds import Feed
from situ.errors import BlackboardError

PARKED = 0.05
"""Seconds for which the background leaves the sockets to a caller that used them last."""

_log = logging.getLogger("situ.blackboard")


class Line(Protocol):
    """What carries a ``Dialog``: a ``Link``, or something like it without sockets."""

    endpoint: str
    dialog: Dialog
    clock: Callable[[], float]

    def descriptors(self) -> tuple[int, ...]: ...

    def due(self) -> float: ...

    def turn(self) -> None: ...

    def close(self) -> None: ...


class Driving(Protocol):
    """What a ``Board`` waits with. Its dialog is touched with ``lock`` only."""

    @property
    def closed(self) -> bool:
        """Whether it was shut, or is not this process's."""

    @property
    def line(self) -> Line: ...

    @property
    def lock(self) -> contextlib.AbstractContextManager[Any]: ...

    def start(self, close: Callable[[], None]) -> None:
        """The session stands: keep it. close: ends it, should the program end before."""

    def check(self) -> None:
        """Raises BlackboardError where this process may not use it."""

    def until(self, ready: Callable[[], bool], timeout: float | None) -> bool:
        """Waits until ``ready()``; False when ``timeout`` seconds are over, or it was shut."""

    def wake(self) -> None:
        """Something is to be sent soon."""

    def shut(self) -> None:
        """Ends all waiting, and closes the line."""


class Driver:
    """``Driving`` over sockets.

    A thread in the background keeps the session alive and calls callbacks. Whoever waits
    for an answer reads the sockets himself, so that no answer passes through two threads.
    """

    def __init__(self, line: Line) -> None:
        self.line = line
        self.lock = threading.Lock()
        self._shut = False
        self._process = os.getpid()
        self._close: Callable[[], None] | None = None
        self._news = threading.Condition(self.lock)
        self._parked = threading.Condition(self.lock)
        self._driving = False
        self._waiters = 0
        self._wakers = socket.socketpair()
        for waker in self._wakers:
            waker.setblocking(False)
        self._poller = select.poll()
        for descriptor in (*line.descriptors(), self._wakers[0].fileno()):
            self._poller.register(descriptor, select.POLLIN)
        self._thread = threading.Thread(target=self._keep, name="situ blackboard", daemon=True)

    @property
    def closed(self) -> bool:
        return self._shut or os.getpid() != self._process

    def start(self, close: Callable[[], None]) -> None:
        self._thread.start()
        self._close = close
        # A program that forgets to close it says goodbye all the same.
        atexit.register(close)

    def check(self) -> None:
        """A fork has neither the thread nor sockets of its own."""
        if os.getpid() != self._process:
            raise BlackboardError(
                "this connection was made before the process forked, and belongs to its parent: "
                "connect in the child anew, under another name"
            )

    def until(self, ready: Callable[[], bool], timeout: float | None) -> bool:
        self.check()
        end = None if timeout is None else time.monotonic() + timeout
        with self.lock:
            self._waiters += 1
            try:
                while True:
                    self._turn()
                    if ready():
                        return True
                    if self._shut or (end is not None and time.monotonic() >= end):
                        return False
                    self._rest(end)
            finally:
                self._waiters -= 1

    def wake(self) -> None:
        """The thread that waits on the sockets looks about."""
        with contextlib.suppress(BlockingIOError, OSError):
            self._wakers[1].send(b"\0")

    def shut(self) -> None:
        if self._close is not None:
            atexit.unregister(self._close)
        if os.getpid() != self._process:
            # The parent's sockets, and its lock, which nobody here may ever give back.
            return
        with self.lock:
            self._shut = True
            self.line.dialog.ended = True
            self.wake()
            self._news.notify_all()
            self._parked.notify_all()
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            self._thread.join()
        with self.lock:
            # Nobody may wait on descriptors that are closed.
            self._news.wait_for(lambda: not self._driving, 1.0)
            self.line.close()
        for waker in self._wakers:
            waker.close()

    # -- turns ---------------------------------------------------------------

    def _turn(self) -> None:
        """Drives the link one turn, with the lock; wakes those for whom there is news."""
        if self._shut:
            return
        self.line.turn()
        if self._waiters > 1:
            self._news.notify_all()
        if self._calling() and threading.current_thread() is not self._thread:
            self._parked.notify()
            if self._driving:
                self.wake()

    def _rest(self, end: float | None) -> None:
        """Until something may have come: one thread waits on the sockets, others on it."""
        until = self.line.due() if end is None else min(end, self.line.due())
        left = max(until - time.monotonic(), 0)
        if self._driving:
            self._news.wait(left)
            return
        self._driving = True
        self.lock.release()
        try:
            self._poll(left)
        finally:
            self.lock.acquire()
            self._driving = False
            # The seat is free: who else waits must take it or would miss the next news.
            self._news.notify_all()

    def _poll(self, seconds: float) -> None:
        # The sockets themselves are never touched here, only the descriptors they gave.
        for descriptor, _ in self._poller.poll(seconds * 1000):
            if descriptor == self._wakers[0].fileno():
                with contextlib.suppress(BlockingIOError):
                    self._wakers[0].recv(4096)

    def _calling(self) -> list[Feed[Any]]:
        """What has something for its callback."""
        following = self.line.dialog.following()
        return [one for one in following if one.callback is not None and len(one)]

    def _keep(self) -> None:
        """The background: keeps the session, and tells callbacks."""
        while True:
            told: list[tuple[Callable[[Any], None], Any]] = []
            with self.lock:
                if self._shut:
                    return
                if self._waiters:
                    # A caller drives, and likely will again at once.
                    self._parked.wait(PARKED)
                else:
                    self._turn()
                    if not self._calling():
                        self._rest(None)
                for one in self._calling():
                    assert one.callback is not None
                    while (item := one.take()) is not None:
                        told.append((one.callback, item))
            for callback, item in told:
                try:
                    callback(item)
                except Exception:
                    _log.exception("a callback failed")
