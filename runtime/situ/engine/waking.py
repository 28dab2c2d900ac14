"""Waking a thread that waits in ``select``: by signals, and by calls of other threads."""

from __future__ import annotations

import contextlib
import signal
import socket
from collections import deque
from collections.abc import Callable
from types import TracebackType


class Waking:
    """A context, in the main thread: inside of it these signals are told instead of done.

    fileno(): to wait on for reading; then ``take``. came: the signals that came, in order.
    """

    def __init__(self, *signals: signal.Signals) -> None:
        self.came: list[int] = []
        self._signals = signals
        self._calls: deque[Callable[[], None]] = deque()
        self._inside, self._outside = socket.socketpair()
        for one in (self._inside, self._outside):
            one.setblocking(False)

    def fileno(self) -> int:
        return self._inside.fileno()

    def __enter__(self) -> Waking:
        self._before = {
            number: signal.signal(number, lambda number, _: self.came.append(number))
            for number in self._signals
        }
        self._woken = signal.set_wakeup_fd(self._outside.fileno(), warn_on_full_buffer=False)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        signal.set_wakeup_fd(self._woken)
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._inside.close()
        self._outside.close()

    def soon(self, call: Callable[[], None]) -> None:
        """Has it called by the next ``take``; from any thread."""
        self._calls.append(call)
        # Where the buffer is full it is awake already.
        with contextlib.suppress(BlockingIOError):
            self._outside.send(b"\0")

    def take(self) -> None:
        """Forgets that it was woken, and does what was asked for by then."""
        with contextlib.suppress(BlockingIOError):
            while self._inside.recv(4096):
                pass
        while self._calls:
            self._calls.popleft()()
