"""``situ run`` keeps what it runs alive: a process that dies is started again.

Pure but for what it is given: children, a clock, and somebody who waits (``engine/parts.py``).
"""

from __future__ import annotations

import logging
import signal
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

from msgspec import Struct

from situ.engine.notify import ADDRESSES, READY, WATCHDOG

DEATHS, WITHIN = 5, 10.0
"""So many deaths in so many seconds, and it is given up."""
PAUSE, LONGEST_PAUSE = 0.1, 2.0
"""Seconds before the second start; twice as long before each one after it."""
EARLY = 1.0
"""Seconds after which a process that has said that it is ready did not die of its past."""
HANGS = 10.0
"""Seconds without a sign of life, and a process is taken for one that hangs."""
STARTING = 60.0
"""The same before it is ready: it may have much to do again."""
CLOSING = 5.0
"""Seconds in which all must have ended when they are told to; then they are killed."""

GIVEN_UP = 1

_ENDED = (0, 1, 2, 128 + signal.SIGPIPE)
"""Exit statuses of who ended by himself; anything else is a death."""

_log = logging.getLogger("situ.run")


class Child(Protocol):
    """The part of ``subprocess.Popen`` that is needed."""

    def poll(self) -> int | None: ...

    def terminate(self) -> None: ...

    def kill(self) -> None: ...


class Start(Protocol):
    """Starts the process of a part. fresh: it is not to go on from where it was; addresses: of
    the parts that are ready."""

    def __call__(self, part: str, fresh: bool, addresses: Mapping[str, str]) -> Child: ...


class Restarts:
    """When a process that dies is started again, and how."""

    def __init__(self) -> None:
        self._deaths: deque[float] = deque(maxlen=DEATHS)
        self._early = 0

    def died(self, now: float, early: bool) -> float | None:
        """Seconds until it is to be started again; None: it is given up."""
        self._deaths.append(now)
        self._early = self._early + 1 if early else 0
        recent = sum(at > now - WITHIN for at in self._deaths)
        if recent >= DEATHS:
            return None
        return 0.0 if recent == 1 else min(PAUSE * 2.0 ** (recent - 2), LONGEST_PAUSE)

    @property
    def fresh(self) -> bool:
        """It died of its own past twice: that is to be left behind."""
        return self._early >= 2


class _Part(Struct, eq=False):
    name: str
    restarts: Restarts
    child: Child | None = None
    due: float | None = None
    ready: float | None = None
    heard: float = 0.0


class Supervisor:
    """Parts of one robot, each a process; the first of them is started first, the others when it
    is ready.

    ``turn`` does what is to be done at a time and gives when it is to be called next; ``heard``
    takes what a part says (``Notifier``). ``status`` is not None when all has ended: 0 or what the
    part said that ended by itself, ``GIVEN_UP`` where one died too often.

    ready(addresses): called once, when all parts are ready, with what they told.
    """

    def __init__(
        self,
        parts: Sequence[str],
        start: Start,
        ready: Callable[[Mapping[str, str]], None],
    ) -> None:
        self.status: int | None = None
        self._parts = [_Part(name, Restarts()) for name in parts]
        self._start = start
        self._ready = ready
        self._told = False
        self._ends: int | None = None
        self._kill: float | None = None
        self._addresses: dict[str, str] = {}

    def begin(self, now: float) -> None:
        self._parts[0].due = now

    def stop(self, now: float, status: int = 0) -> None:
        """Tells all to end; asking twice is no fault."""
        if self._ends is not None:
            return
        self._ends = status
        self._kill = now + CLOSING
        for part in self._parts:
            part.due = None
            if part.child is not None:
                part.child.terminate()

    def heard(self, name: str, message: Mapping[str, str], now: float) -> None:
        """A part has told something of itself."""
        part = next(one for one in self._parts if one.name == name)
        if part.child is None:
            return
        if READY in message or WATCHDOG in message:
            part.heard = now
        if READY not in message:
            return
        part.ready = now
        if ADDRESSES in message:
            self._addresses[name] = message[ADDRESSES]
        if part is self._parts[0] and self._ends is None:
            for other in self._parts[1:]:
                if other.child is None and other.due is None:
                    other.due = now
        if not self._told and all(one.ready is not None for one in self._parts):
            self._told = True
            self._ready(self._addresses)

    def turn(self, now: float) -> float | None:
        """Seconds until the next turn at the latest, None: until something happens."""
        for part in self._parts:
            if part.child is not None:
                self._look(part, part.child, now)
        for part in self._parts:
            if part.due is not None and part.due <= now:
                part.due = None
                part.child = self._start(part.name, part.restarts.fresh, self._addresses)
                part.heard, part.ready = now, None
        if self._ends is not None:
            self._close(now)
        dues = [self._due(part) for part in self._parts]
        if self._ends is not None:
            dues = [self._kill]
        return min((max(due - now, 0.0) for due in dues if due is not None), default=None)

    def _due(self, part: _Part) -> float | None:
        if part.child is None:
            return part.due
        return part.heard + (STARTING if part.ready is None else HANGS)

    def _look(self, part: _Part, child: Child, now: float) -> None:
        status = child.poll()
        if status is None:
            limit = self._due(part)
            if self._ends is None and limit is not None and now >= limit:
                _log.error("%s hangs; it is killed", part.name)
                part.heard = now
                child.kill()
            return
        part.child = None
        if self._ends is not None:
            return
        if status in _ENDED:
            self.stop(now, status)
            return
        early = part.ready is None or now < part.ready + EARLY
        pause = part.restarts.died(now, early)
        how = f"was killed by signal {-status}" if status < 0 else f"ended with status {status}"
        if pause is None:
            _log.error(
                "%s %s, %d times in %g s: it is given up; what it said before tells why",
                part.name,
                how,
                DEATHS,
                WITHIN,
            )
            self.stop(now, GIVEN_UP)
            return
        anew = " anew, for it died twice before it was up" if part.restarts.fresh else " again"
        _log.error("%s %s; it is started%s", part.name, how, anew)
        part.due = now + pause

    def _close(self, now: float) -> None:
        left = [part.child for part in self._parts if part.child is not None]
        if not left:
            self.status = self._ends
        elif self._kill is not None and now >= self._kill:
            _log.warning("what does not end in %g s is killed", CLOSING)
            self._kill = None
            for child in left:
                child.kill()
