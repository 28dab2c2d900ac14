"""A trace log as the rows of a table: read where they are looked at, however many there are."""

from __future__ import annotations

from array import array
from bisect import bisect_left
from collections.abc import Callable, Collection, Sequence
from typing import overload

from situ_studio.live.log import TraceLog
from situ_studio.live.moment import TraceFields
from situ_studio.panels.table import Row

KEPT = 1_000
"""Rows that are kept while others are read: more than a screen has."""
GONE = Row("", ("", "", "", ""))
"""Stands where the log has no event any more, until the table is told."""


class LogRows(Sequence[Row]):
    """The events that ``log`` had when it was looked at last; ``news`` says what it has now.

    kinds: only events of these are among the rows; none: all are.
    """

    def __init__(
        self,
        log: TraceLog,
        row: Callable[[TraceFields], Row],
        kinds: Collection[str] = (),
    ) -> None:
        self._log, self._row, self._kinds = log, row, kinds
        self._lanes = log.lanes
        # Events keep their number when earlier ones go.
        self._gone, self._end = log.gone, log.gone + len(log)
        self._numbers = self._among(self._gone) if kinds else None
        self._kept: dict[int, Row] = {}

    def news(self) -> tuple[int, int] | None:
        """How many of the first are not there any more, and how many came; None: another run."""
        log = self._log
        if self._lanes is not log.lanes:
            return None
        if self._numbers is not None:
            gone = bisect_left(self._numbers, log.gone)
            return gone, len(self._among(max(self._end, log.gone)))
        gone = min(log.gone - self._gone, len(self))
        return gone, len(log) - (len(self) - gone)

    def drop(self, gone: int) -> None:
        """The first are not among the rows any more."""
        if self._numbers is not None:
            del self._numbers[:gone]
        self._gone = self._log.gone
        self._end = max(self._end, self._gone)

    def take(self, came: int) -> None:
        """What came is among the rows."""
        if self._numbers is not None:
            self._numbers.extend(self._among(self._end)[:came])
        self._end = self._log.gone + len(self._log)

    def _among(self, number: int) -> array[int]:
        """The numbers of those that are rows, from that one on."""
        gone = self._log.gone
        found = self._log.of_kinds(self._kinds, number - gone)
        return array("L", (gone + place for place in found)) if gone else found

    def forget(self) -> None:
        """Rows are worked out anew: their words may be others now."""
        self._kept.clear()

    def place(self, row: int) -> int:
        """Where the log has the event of a row; below 0 where it has it no more."""
        return self._number(row) - self._log.gone

    def before(self, count: int) -> int:
        """The last row of the first ``count`` events of the log; -1 where there is none."""
        number = count + self._log.gone
        if self._numbers is not None:
            return bisect_left(self._numbers, number) - 1
        return min(number - self._gone, len(self)) - 1

    def row_at(self, place: int) -> int | None:
        """The row of the event at that place; None where it is none of the rows."""
        row = self.before(place + 1)
        return row if row >= 0 and self.place(row) == place else None

    def _number(self, row: int) -> int:
        return self._gone + row if self._numbers is None else self._numbers[row]

    def __len__(self) -> int:
        return self._end - self._gone if self._numbers is None else len(self._numbers)

    @overload
    def __getitem__(self, index: int) -> Row: ...

    @overload
    def __getitem__(self, index: slice) -> list[Row]: ...

    def __getitem__(self, index: int | slice) -> Row | list[Row]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        at = index if index >= 0 else len(self) + index
        if not 0 <= at < len(self):
            raise IndexError(index)
        number = self._number(at)
        row = self._kept.get(number)
        if row is None:
            place = number - self._log.gone
            if place < 0 or self._lanes is not self._log.lanes:
                return GONE
            if len(self._kept) >= KEPT:
                self._kept.clear()
            row = self._kept[number] = self._row(self._log[place])
        return row
