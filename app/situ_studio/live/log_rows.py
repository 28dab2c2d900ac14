"""A trace log as the rows of a table: read where they are looked at, however many there are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import overload

from situ_studio.live.log import TraceLog
from situ_studio.live.moment import TraceFields
from situ_studio.panels.table import Row

KEPT = 1_000
"""Rows that are kept while others are read: more than a screen has."""
GONE = Row("", ("", "", "", ""))
"""Stands where the log has no event any more, until the table is told."""


class LogRows(Sequence[Row]):
    """The events that ``log`` had when it was looked at last; ``news`` says what it has now."""

    def __init__(self, log: TraceLog, row: Callable[[TraceFields], Row]) -> None:
        self._log, self._row = log, row
        self._lanes = log.lanes
        self._gone, self._count = log.gone, len(log)
        self._kept: dict[int, Row] = {}

    def news(self) -> tuple[int, int] | None:
        """How many of the first are not there any more, and how many came; None: another run."""
        log = self._log
        if self._lanes is not log.lanes:
            return None
        gone = min(log.gone - self._gone, self._count)
        return gone, len(log) - (self._count - gone)

    def drop(self, gone: int) -> None:
        """The first are not among the rows any more."""
        self._count -= gone
        self._gone = self._log.gone

    def take(self, came: int) -> None:
        """What came is among the rows."""
        self._count += came
        self._gone = self._log.gone

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, index: int) -> Row: ...

    @overload
    def __getitem__(self, index: slice) -> list[Row]: ...

    def __getitem__(self, index: int | slice) -> Row | list[Row]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(self._count))]
        place = index if index >= 0 else self._count + index
        if not 0 <= place < self._count:
            raise IndexError(index)
        # Rows keep their number when earlier ones go.
        number = place + self._gone
        row = self._kept.get(number)
        if row is None:
            at = number - self._log.gone
            if at < 0 or self._lanes is not self._log.lanes:
                return GONE
            if len(self._kept) >= KEPT:
                self._kept.clear()
            row = self._kept[number] = self._row(self._log[at])
        return row
