"""The last trace events of a running robot, for those who begin to look later."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from functools import lru_cache
from itertools import islice

import msgspec

from situ.decide.trace import TraceEvent

CAPACITY = 20_000
"""Events; older ones are forgotten."""
BYTES = 64_000_000
"""Of all events kept, so that large values do not fill the memory."""
PAGE = 1_000_000
"""Bytes after which ``since`` gives no more at once."""


Line = tuple[int, bytes, float]
"""The seq of an event, its JSON, and the moment it was made (UNIX seconds)."""


class Backlog:
    """A bounded run of events without a gap; each with the moment (UNIX seconds) it was made.

    The newest is always kept, however large it is. begin: the seq of the last event before.
    """

    def __init__(self, capacity: int = CAPACITY, limit: int = BYTES, begin: int = 0) -> None:
        self._begin = begin
        self._kept: deque[Line] = deque()
        self._capacity = capacity
        self._limit = limit
        self._bytes = 0

    @property
    def first(self) -> int:
        """The seq of the oldest event kept; of the next where there is none yet."""
        return self._kept[0][0] if self._kept else self._begin + 1

    @property
    def last(self) -> int:
        """The seq of the newest event; 0 where there was none yet."""
        return self._kept[-1][0] if self._kept else self._begin

    def __iter__(self) -> Iterator[bytes]:
        """The JSON of each event kept, oldest first."""
        return (line for _, line, _ in self._kept)

    def add(self, events: Iterable[TraceEvent], moment: float) -> None:
        for event in events:
            line = _encoder.encode(event)
            self._kept.append((event.seq, line, moment))
            self._bytes += len(line)
        while len(self._kept) > 1 and (
            len(self._kept) > self._capacity or self._bytes > self._limit
        ):
            self._bytes -= len(self._kept.popleft()[1])

    def after(self, seq: int, limit: int) -> list[Line]:
        """The events after ``seq`` as they are kept; only the newest, where ``limit`` bytes are
        not enough."""
        found: list[Line] = []
        size = 0
        for line in reversed(self._kept):
            size += len(line[1])
            if line[0] <= seq or size > limit:
                break
            found.append(line)
        found.reverse()
        return found

    def restore(self, lines: Iterable[Line]) -> None:
        """The events of the run before, up to ``begin`` without a gap; nothing else came yet."""
        self._kept.extend(lines)
        self._bytes = sum(len(line) for _, line, _ in self._kept)

    def since(self, seq: int, limit: int) -> Iterator[bytes]:
        """At most ``limit`` events from ``seq`` on, oldest first, as ``stamped``; at least one
        where there is one, and no more after ``PAGE`` bytes."""
        begin = max(seq - self.first, 0)
        size = 0
        for _, line, moment in islice(self._kept, begin, begin + limit):
            yield _with_time(line, moment)
            size += len(line)
            if size > PAGE:
                return


def stamped(event: TraceEvent, moment: float) -> bytes:
    """The event as in the trace, without newline, with ``time`` (RFC 3339, UTC) at its end."""
    return _with_time(_encoder.encode(event), moment)


def _with_time(line: bytes, moment: float) -> bytes:
    # Every trace event is an object with fields, so its JSON ends in a brace.
    return line[:-1] + b',"time":"%s"}' % time_text(moment).encode()


# All events of a step have one moment, and several may record or follow them.
@lru_cache(maxsize=1)
def time_text(moment: float) -> str:
    """RFC 3339 in UTC with microseconds: ``2026-01-02T03:04:05.678900Z``."""
    # Not by strftime: every event that is recorded or followed has one.
    return datetime.fromtimestamp(moment, UTC).isoformat(timespec="microseconds")[:26] + "Z"


_encoder = msgspec.json.Encoder()
