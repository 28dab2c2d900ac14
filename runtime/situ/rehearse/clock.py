"""What ``clock.…`` said in a run, which no trace tells (formats.md, *Trace*).

A write of it is known where somebody has seen it: a recording has it among its inputs, who follows
a robot hears of it. What was written between those that were seen, and before and after them,
follows from what the clock on the wall said at the events: that is UTC, and how far the robot's own
time is from it shows at every write that was seen. Where that is another at the two ends of a
stretch, and farther than ``FAR`` before the first that was seen or after the last, it is not known.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping
from datetime import UTC, datetime, timedelta
from itertools import groupby, pairwise
from typing import Any, NamedTuple

from msgspec import Struct

from situ.decide.clock import CLOCK, DATE, TIME, WEEKDAY, tags_at
from situ.decide.inputs import Set
from situ.decide.priorities import RUNTIME
from situ.rehearse import recorded

FAR = 86_400.0
"""Seconds for which the robot's own time is taken to be as far from UTC as where that was seen."""
PROJECT = "project"
"""Who has written what stands at the start (formats.md, *Trace*)."""
ZONES = timedelta(minutes=15)
"""By which time zones differ."""
LATE = timedelta(minutes=2)
"""A write may be later than its minute, and the clock on the wall may be set meanwhile."""
MINUTE = timedelta(minutes=1)

Fields = dict[str, Any]
"""A trace event as it stands in a trace."""


class Hidden(Struct, frozen=True):
    """A write of what the runtime keeps, which no trace tells; t: seconds."""

    t: float
    tag: str
    value: Any
    writer: str


class Given:
    """What a recording's inputs tell of it, piece by piece."""

    def __init__(self) -> None:
        self._stood: dict[str, Any] = {}
        self._by = RUNTIME

    def take(self, piece: recorded.Piece) -> list[Hidden]:
        """The writes that a piece tells. What stood there before the first step is told with that.
        Raises UsageError for a snapshot that is damaged.
        """
        if isinstance(piece, recorded.Heading):
            self._stood, self._by = piece.tags, PROJECT
        if isinstance(piece, recorded.Snapshot):
            self._stood, self._by = recorded.board_of(piece.state), RUNTIME
        if not isinstance(piece, recorded.Taken):
            return []
        stood, self._stood = self._stood, {}
        given = piece.given
        told, writer = (given.tags, given.writer) if isinstance(given, Set) else ({}, "")
        return [
            Hidden(piece.t, tag, value, by)
            for values, by in ((stood, self._by), (told, writer))
            for tag, value in values.items()
            if tag.startswith(CLOCK)
        ]


def followed(events: Iterable[Fields], seen: Iterable[Hidden]) -> list[Hidden]:
    """All writes of ``clock.…`` that are known, in order of their times; a value None: from then on
    it is not known. events: of the run, in order; seen: the writes that somebody has seen.
    """
    known = sorted(seen, key=lambda one: one.t)
    wall = _Wall(events)
    anchors = list(_anchors(known, wall)) if wall.told else []
    if not anchors:
        return known
    found = [*_before(wall, anchors[0]), *_after(wall, anchors[-1])]
    for one, other in pairwise(anchors):
        if one.zone == other.zone:
            found += _minutes(wall, one, other)
        else:
            found += (*_unknown(min(one.t + 60, other.t)), *_said(other.t, tags_at(other.minute)))
    every = {(one.t, one.tag): one for one in (*found, *known)}
    return sorted(every.values(), key=lambda one: one.t)


class _Wall:
    """What the clock on the wall said at times of the trace, in UTC."""

    def __init__(self, events: Iterable[Fields]) -> None:
        self.told: list[tuple[float, datetime]] = []
        for event in events:
            at = _read(event.get("time"))
            if at is not None:
                self.told.append((event["t"], at))

    def at(self, t: float) -> datetime:
        near, at = self._near(bisect_right(self.told, t, key=lambda one: one[0]))
        return at + timedelta(seconds=t - near)

    def when(self, at: datetime) -> float:
        """The time of the trace at which it said that, or something later for the first time."""
        behind = bisect_right(self.told, at, key=lambda one: one[1])
        near, then = self._near(behind)
        t = near + (at - then).total_seconds()
        return round(min([t, *(later for later, _ in self.told[behind : behind + 1])]), 6)

    def _near(self, behind: int) -> tuple[float, datetime]:
        return self.told[max(behind - 1, 0)]


class _Anchor(NamedTuple):
    """At ``t`` the clock said ``minute``, of the robot's own time, which is UTC and ``zone``."""

    t: float
    minute: datetime
    zone: timedelta


def _anchors(seen: list[Hidden], wall: _Wall) -> Iterator[_Anchor]:
    date: str | None = None
    for t, group in groupby(seen, key=lambda one: one.t):
        # What stands at the start, it has from the project.
        written = {one.tag: one.value for one in group if one.writer in (RUNTIME, PROJECT)}
        date = written.get(DATE, date)
        minute = _read(f"{date} {written.get(TIME)}")
        if minute is None:
            continue
        apart = minute - _minute(wall.at(t))
        zone = round(apart / ZONES) * ZONES
        if abs(apart - zone) <= LATE:
            yield _Anchor(t, minute, zone)


def _before(wall: _Wall, first: _Anchor) -> Iterator[Hidden]:
    """As far back as ``FAR``: there the clock says something already."""
    begins = max(wall.told[0][0], first.t - FAR)
    minute = _minute(wall.at(begins) + first.zone)
    if begins < first.t and minute < first.minute:
        yield from _said(begins, tags_at(minute))
        yield from _minutes(wall, _Anchor(begins, minute, first.zone), first)


def _after(wall: _Wall, last: _Anchor) -> Iterator[Hidden]:
    """As far on as ``FAR``."""
    ends = min(wall.told[-1][0], last.t + FAR)
    yield from _minutes(
        wall, last, _Anchor(ends, _minute(wall.at(ends) + last.zone) + MINUTE, last.zone)
    )
    if ends < wall.told[-1][0]:
        yield from _unknown(ends)


def _minutes(wall: _Wall, after: _Anchor, to: _Anchor) -> Iterator[Hidden]:
    """What is written at each full minute between the two."""
    minute, t = after.minute, after.t
    while (following := minute + MINUTE) < to.minute:
        # The clock on the wall may have been set meanwhile.
        t = min(max(t, wall.when(following - after.zone)), to.t)
        # What it passed over when it was set ahead, by decades on a robot that begins at 1970, is
        # never written.
        said = _minute(wall.at(t) + after.zone)
        following = max(following, min(said, to.minute - MINUTE))
        before, now = tags_at(minute), tags_at(following)
        yield from _said(t, {tag: now[tag] for tag in now if now[tag] != before[tag]})
        minute = following


def _unknown(t: float) -> Iterator[Hidden]:
    return _said(t, dict.fromkeys((TIME, DATE, WEEKDAY)))


def _said(t: float, values: Mapping[str, str | None]) -> Iterator[Hidden]:
    for tag, value in values.items():
        yield Hidden(t, tag, value, RUNTIME)


def _read(written: Any) -> datetime | None:
    """In UTC where it says how far it is from that; None where it is none: a trace may come from
    anywhere."""
    try:
        at = datetime.fromisoformat(written)
        return at if at.tzinfo is None else at.astimezone(UTC).replace(tzinfo=None)
    except (ValueError, TypeError, OverflowError):
        return None


def _minute(at: datetime) -> datetime:
    return at.replace(second=0, microsecond=0)
