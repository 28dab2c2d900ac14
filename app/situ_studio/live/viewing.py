"""What every live view shows: one trace log and a cursor in it.

The log is the connected robot's, a recording's or a rehearsal's: the views can not tell. While the
cursor follows, it is at the end, wherever that goes; put elsewhere, it stays while events come.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from datetime import datetime, time, timedelta

from PySide6.QtCore import QObject, Signal

from situ_studio.live.log import TraceLog
from situ_studio.live.moment import Moment


class Viewing(QObject):
    """t is seconds of the trace. end: when the log's end is, for one that goes on by itself.

    grows: whether the log that is looked at does.
    """

    exchanged = Signal()
    """``log`` is another one."""
    moved = Signal()
    """The cursor is elsewhere, or follows now, or does not any more."""

    def __init__(self, log: TraceLog, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.log = log
        self._end: Callable[[], float] = self._last
        self._cursor: float | None = None
        self.grows = False
        self._begun: tuple[object, datetime | None] = (None, None)

    def show(self, log: TraceLog, end: Callable[[], float] | None = None) -> None:
        """Another log, from its end."""
        self.log = log
        self._end = end or self._last
        self._cursor = None
        self.grows = end is not None
        self.exchanged.emit()
        self.moved.emit()

    @property
    def follows(self) -> bool:
        """Whether the cursor is at the end and stays there."""
        return self._cursor is None

    @property
    def t(self) -> float:
        """Where the cursor is: the first moment that is kept where its own is not any more."""
        start, end = self.span
        return end if self._cursor is None else min(max(self._cursor, start), end)

    @property
    def span(self) -> tuple[float, float]:
        """From the first moment that can be looked at to the last."""
        return (self.log.lanes.start, max(self._end(), self.log.lanes.start))

    def moment(self) -> Moment:
        """The robot at the cursor. Not to be changed."""
        return self.log.now if self._cursor is None else self.log.at(self.t)

    def wall(self) -> datetime | None:
        """What the clock on the wall, as of here, said at 0 of the trace; None where it does not
        tell.
        """
        log = self.log
        if self._begun[0] is not log.lanes:
            if not len(log):
                return None
            written, begun = log[0].get("time"), None
            if isinstance(written, str):
                # Recordings may come from anywhere.
                with suppress(ValueError, OverflowError):
                    begun = datetime.fromisoformat(written).astimezone()
                    begun -= timedelta(seconds=log.time(0))
            self._begun = (log.lanes, begun)
        return self._begun[1]

    def clock(self) -> str:
        """What that clock said at the cursor; seconds of the trace where it does not tell."""
        return self._second(self.t)

    def _second(self, t: float) -> str:
        at = self._wall_at(t)
        return f"{t:.1f} s" if at is None else self._day(at) + at.strftime("%H:%M:%S")

    def written(self, t: float, finest: bool = True) -> str:
        """A moment by the clock on the wall, or in seconds of the trace. finest: to the ms, with
        its day where the run has several; else as short as can be, midnight as the day that begins.
        """
        at = self._wall_at(t)
        if at is None:
            seconds = f"{t:.3f}"
            return f"{seconds if finest else seconds.rstrip('0').rstrip('.')} s"
        if finest:
            return self._day(at) + at.strftime("%H:%M:%S.%f")[:-3]
        if at.time() == time():
            return at.strftime("%Y-%m-%d")
        return at.strftime("%H:%M:%S.%f").rstrip("0").rstrip(".")

    def _wall_at(self, t: float) -> datetime | None:
        begun = self.wall()
        with suppress(OverflowError):
            return None if begun is None else begun + timedelta(seconds=t)
        return None

    def _day(self, at: datetime) -> str:
        """The day, to be written before the time, where that alone would not tell."""
        first, last = map(self._wall_at, self.span)
        if first is None or last is None or first.date() == last.date() == at.date():
            return ""
        return at.strftime("%Y-%m-%d ")

    @property
    def begun(self) -> str:
        """Since when the run is known, to the second."""
        return self._second(self.log.lanes.start)

    def seek(self, t: float) -> None:
        """Puts the cursor there, as far as there is something."""
        start, end = self.span
        to = min(max(t, start), end)
        if to != self._cursor:
            self._cursor = to
            self.moved.emit()

    def follow(self) -> None:
        """To the end, and with it."""
        if self._cursor is not None:
            self._cursor = None
            self.moved.emit()

    def pause(self) -> None:
        """The cursor stays where it is, whatever comes."""
        if self._cursor is None:
            self._cursor = self.t
            self.moved.emit()

    def step(self, by: int) -> None:
        """To the event after, or before: ``by`` is 1 or -1."""
        log = self.log
        if not len(log):
            return
        if by > 0:
            after = log.count(self.t)
            if after < len(log):
                self.seek(log.time(after))
        else:
            # The last event that is earlier than the cursor.
            before = log.earlier(self.t)
            self.seek(log.time(before - 1) if before else log.lanes.start)

    def _last(self) -> float:
        return self.log.lanes.end
