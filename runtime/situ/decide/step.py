"""What the cores share while a step is carried out: time, timers, trace and effects."""

from __future__ import annotations

import heapq
from typing import Any

from msgspec import Struct

from situ.decide.effects import AnyEffect
from situ.decide.trace import Failed, TraceEvent, Warned

SECOND = 1_000_000
"""Microseconds; time is whole microseconds everywhere in ``decide``."""

# What falls due at one moment is done in this order (formats.md, *Time and steps*).
TEST, HOLD, VALIDITY, FINISH, TIMEOUT, DEPLOY = range(6)


def microseconds(seconds: float) -> int:
    return round(seconds * SECOND)


def duration(seconds: float) -> int:
    """A length of time in whole µs. It is never 0: what starts now falls due later, so time goes
    on however short a timeout is.
    """
    return max(1, round(seconds * SECOND))


class Timer(Struct, frozen=True, array_like=True, order=True, gc=False):
    """Something that falls due: at ``due``, in ``rank``'s order, the earlier started first.

    ``owner`` and ``token`` tell whose it is; one whose token its owner no longer
    knows is stale and dropped unseen.
    """

    due: int
    rank: int
    started: int
    order: int
    owner: str
    token: int


class StepState(Struct):
    now: int = 0
    seq: int = 0
    timers: list[Timer] = []
    made: int = 0


class Step:
    """The time, the timers, and what this step has traced and asked for so far.

    now: µs; seconds: the same as traces have it. seq: of the last event. A new event takes
    ``seq + 1``; where every microsecond counts it is made and appended on the spot.
    """

    __slots__ = ("effects", "events", "made", "now", "seconds", "seq", "timers")

    def __init__(self) -> None:
        self.now = self.seq = self.made = 0
        self.seconds = 0.0
        self.timers: list[Timer] = []
        self.events: list[TraceEvent] = []
        self.effects: list[AnyEffect] = []

    @property
    def state(self) -> StepState:
        return StepState(self.now, self.seq, self.timers, self.made)

    @state.setter
    def state(self, state: StepState) -> None:
        self.now, self.seconds = state.now, state.now / SECOND
        self.seq, self.timers, self.made = state.seq, state.timers, state.made

    def begin(self, now: int) -> None:
        self.now = now
        self.seconds = now / SECOND
        self.events = []
        self.effects = []

    def trace(self, kind: type[TraceEvent], cause: int | None, *fields: Any, **more: Any) -> int:
        """Appends an event; gives its seq. ``fields`` are those after ``cause``, in order."""
        self.seq = seq = self.seq + 1
        self.events.append(kind(seq, self.seconds, cause, *fields, **more))
        return seq

    def warn(self, cause: int | None, message: str, where: str) -> int:
        return self.trace(Warned, cause, message, where)

    def error(self, cause: int | None, message: str, where: str) -> int:
        return self.trace(Failed, cause, message, where)

    def at(self, due: int, rank: int, owner: str, token: int, started: int | None = None) -> None:
        """Sets a timer; timers are never taken back, their owner's token goes stale."""
        self.made += 1
        since = self.now if started is None else started
        heapq.heappush(self.timers, Timer(due, rank, since, self.made, owner, token))
