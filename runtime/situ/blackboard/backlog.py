"""The last trace events of a running robot, for those who begin to look later."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from itertools import islice

import msgspec

from situ.decide.trace import TraceEvent

CAPACITY = 20_000
"""Events; older ones are forgotten."""


class Backlog:
    """A bounded run of events without a gap; each with the moment (UNIX seconds) it was made."""

    def __init__(self, capacity: int = CAPACITY) -> None:
        self._kept: deque[tuple[TraceEvent, float]] = deque(maxlen=capacity)

    @property
    def first(self) -> int:
        """The seq of the oldest event kept; 1 where there is none yet."""
        return self._kept[0][0].seq if self._kept else 1

    @property
    def last(self) -> int:
        """The seq of the newest event; 0 where there is none yet."""
        return self._kept[-1][0].seq if self._kept else 0

    def add(self, events: Iterable[TraceEvent], moment: float) -> None:
        for event in events:
            self._kept.append((event, moment))

    def since(self, seq: int, limit: int) -> Iterator[bytes]:
        """At most ``limit`` events from ``seq`` on, oldest first, as ``stamped``."""
        begin = max(seq - self.first, 0)
        for event, moment in islice(self._kept, begin, begin + limit):
            yield stamped(event, moment)


def stamped(event: TraceEvent, moment: float) -> bytes:
    """The event as in the trace, without newline, with ``time`` (RFC 3339, UTC) at its end."""
    # Every trace event is an object with fields, so its JSON ends in a brace.
    return _encoder.encode(event)[:-1] + b',"time":"%s"}' % time_text(moment).encode()


def time_text(moment: float) -> str:
    """RFC 3339 in UTC with microseconds: ``2026-01-02T03:04:05.678900Z``."""
    at = datetime.fromtimestamp(moment, UTC)
    return f"{at:%Y-%m-%dT%H:%M:%S}.{at.microsecond:06d}Z"


_encoder = msgspec.json.Encoder()
