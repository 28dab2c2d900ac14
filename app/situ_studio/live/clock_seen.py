"""The writes of ``clock.…`` that somebody has seen in a run: no trace tells them. No Qt."""

from __future__ import annotations

from bisect import bisect_right, insort
from collections.abc import Iterable

from situ.decide.clock import CLOCK
from situ.rehearse.clock import Hidden
from situ_studio.live.moment import Entry, Moment


class ClockSeen:
    """Of one run; ``situ.rehearse.clock`` says what follows from them."""

    def __init__(self) -> None:
        self._tags: dict[str, list[Hidden]] = {}

    def __bool__(self) -> bool:
        return bool(self._tags)

    def add(self, writes: Iterable[Hidden]) -> None:
        """What was seen already is passed over."""
        for one in writes:
            known = self._tags.setdefault(one.tag, [])
            before = known[max(self._count(known, one.t) - 1, 0) :]
            if one not in before[:1]:
                insort(known, one, key=_t)

    def until(self, t: float) -> tuple[Hidden, ...]:
        """Those up to ``t``, in order of their times."""
        found = (one for known in self._tags.values() for one in known[: self._count(known, t)])
        return tuple(sorted(found, key=_t))

    def put(self, moment: Moment, t: float) -> None:
        """Lets a moment's blackboard have what stood there at ``t``."""
        for tag, known in self._tags.items():
            count = self._count(known, t)
            last = known[count - 1] if count else None
            if last is None or last.value is None:
                moment.board.pop(tag, None)
            else:
                moment.board[tag] = Entry(last.value, last.writer, last.t)

    @staticmethod
    def _count(known: list[Hidden], t: float) -> int:
        return bisect_right(known, t, key=_t)


def is_clock(tag: str) -> bool:
    return tag.startswith(CLOCK)


def _t(one: Hidden) -> float:
    return one.t
