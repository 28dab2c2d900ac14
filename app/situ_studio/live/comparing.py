"""Runs beside the one that is looked at: how they are lined up, and where they part."""

from __future__ import annotations

import logging
import time
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from enum import Enum, auto

from msgspec import Struct
from msgspec.structs import replace
from PySide6.QtCore import QObject, QTimer, Signal

from situ.document.project import Project
from situ.rehearse.comparing import Alike, Difference, alike
from situ.rehearse.deeds import Deeds
from situ.rehearse.parting import Parting, told
from situ.rehearse.telling import Teller
from situ_studio.live.log import TraceLog
from situ_studio.live.moment import TraceFields
from situ_studio.live.recordings import Recording
from situ_studio.live.timeline.bookmarks import Bookmark
from situ_studio.live.viewing import Viewing
from situ_studio.processes.worker import Worker, module

SLICE = 0.012
"""Seconds of looking at a time."""
PIECE = 200
"""Events between two looks at the clock."""
AT_ONCE = 600
"""Deeds of two runs that are put beside one another in less than a person notices."""
COMMAND = module("situ_studio.live.comparing_process")
_log = logging.getLogger("situ.studio")


class Way(Enum):
    """Ways to line up that are no bookmark, whatever one is called: at the start, at the first
    thing that both did, where they last agreed."""

    START = auto()
    COMMON = auto()
    AGREED = auto()


START, COMMON, AGREED = Way


class Compared(Struct, frozen=True):
    """A run beside. project: what ran, for the names of states; None: not known. recording: where
    it comes from; None: from a robot, or a rehearsal.
    """

    name: str
    log: TraceLog
    project: Project | None = None
    bookmarks: tuple[Bookmark, ...] = ()
    recording: Recording | None = None


class Gathering:
    """What a robot did by its log, as far as it was looked through."""

    def __init__(self, log: TraceLog) -> None:
        self.log = log
        self.deeds = Deeds()
        self._lanes, self._taken = log.lanes, 0

    @property
    def is_whole(self) -> bool:
        """Whether the log has nothing that was not looked at."""
        log = self.log
        return self._lanes is log.lanes and self._taken == len(log) + log.gone

    def go_on(self, count: int) -> bool:
        """Looks through so many events more; False where there are no more."""
        log = self.log
        if self._lanes is not log.lanes:
            # The robot was started again: it is another run.
            self.deeds, self._lanes, self._taken = Deeds(), log.lanes, log.gone
        begin = max(self._taken - log.gone, 0)
        end = min(begin + count, len(log))
        for place in range(begin, end):
            self.deeds.add(log[place])
        self._taken = end + log.gone
        return end < len(log)


class Comparing(QObject):
    """The run that ``viewing`` looks at and those beside it.

    shifts: how far each one's clock is ahead of ours, lined up by ``way``. marks: where they part,
    as (number of the run beside, difference) by our time. chosen: which of them is told about.
    """

    changed = Signal()
    ended = Signal(int)
    """A search went to the end and found none further; the number is 1 forward, -1 back."""
    failed = Signal()
    """The process beside the window has gone, and it is not known where the runs part."""

    def __init__(
        self,
        viewing: Viewing,
        parent: QObject | None = None,
        at_once: int = AT_ONCE,
        command: Sequence[str] = COMMAND,
    ) -> None:
        super().__init__(parent)
        self.viewing = viewing
        self.own: Compared | None = None
        self.others: list[Compared] = []
        self.shifts: list[float] = []
        self.way: Way | str = COMMON
        self.marks: list[tuple[int, Difference]] = []
        self.chosen: tuple[int, Difference] | None = None
        self._at = 0.0
        self._at_once, self._command = at_once, tuple(command)
        self._gathered: list[Gathering] = []
        self._found: list[Alike | None] = []
        self._workers: list[Worker] = []
        self._wanted = 0
        self._slices = QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(self._go_on)

    @property
    def goes(self) -> bool:
        """Whether there are runs beside."""
        return bool(self.others)

    @property
    def ready(self) -> bool:
        """Whether ``marks`` are all there are."""
        return self.goes and all(one is not None for one in self._found)

    def add(self, own: Compared, other: Compared) -> None:
        """Puts ``other`` below the run that is looked at, which is ``own``."""
        self.own = own
        self.others.append(other)
        self.shifts.append(0.0)
        if not self._gathered:
            self._gathered.append(Gathering(own.log))
        self._gathered.append(Gathering(other.log))
        self._found = [None for _ in self.others]
        self._slices.start()
        self._line_up()
        self.changed.emit()

    def end(self) -> None:
        """There are no runs beside any more."""
        self._slices.stop()
        for worker in self._workers:
            worker.end()
            worker.deleteLater()
        self.own, self.chosen, self._wanted = None, None, 0
        self.others, self.shifts, self.marks = [], [], []
        self._gathered, self._found, self._workers = [], [], []
        self.changed.emit()

    def know(self, log: TraceLog, project: Project | None) -> None:
        """That project ran there; where it is None, nothing more is known of it."""
        if project is None:
            return

        def known(one: Compared) -> Compared:
            return replace(one, project=project) if one.log is log else one

        self.own = known(self.own) if self.own is not None else None
        self.others = [known(one) for one in self.others]
        self.changed.emit()

    # -- lining up -----------------------------------------------------------------------

    def line_up(self, way: Way | str) -> None:
        """START, COMMON, AGREED, or the name of a bookmark that the runs have."""
        self.way = way
        self._line_up()
        self.changed.emit()

    def mark(self, bookmarks: Sequence[Bookmark]) -> None:
        """The run that is looked at has those bookmarks now."""
        if self.own is not None:
            self.own = replace(self.own, bookmarks=tuple(bookmarks))
            self._line_up()
            self.changed.emit()

    def bookmarks(self) -> list[str]:
        """The names of those at which every run beside can be lined up."""
        own = self.own.bookmarks if self.own is not None else ()
        names = [{mark.name for mark in other.bookmarks} for other in self.others]
        return [mark.name for mark in own if all(mark.name in one for one in names)]

    def _line_up(self) -> None:
        self.shifts = [self._shift(run) for run in range(len(self.others))]

    def _shift(self, run: int) -> float:
        own, other = self.own, self.others[run]
        assert own is not None
        start = _start(other.log) - _start(own.log)
        found = self._found[run]
        if self.way == AGREED and self.chosen is not None and self.chosen[0] == run:
            agreed = self.chosen[1].agreed
            return agreed[1] - agreed[0]
        if self.way in (COMMON, AGREED):
            common = found.common if found is not None else None
            return start if common is None else common[1] - common[0]
        marks = [
            [mark.t for mark in every if mark.name == self.way]
            for every in (own.bookmarks, other.bookmarks)
        ]
        return marks[1][0] - marks[0][0] if all(marks) else start

    # -- from difference to difference ---------------------------------------------------

    def go(self, by: int) -> None:
        """To the next difference, or the one before: ``by`` is 1 or -1. The cursor goes there; at
        once, or when it is known where."""
        if not self.goes:
            return
        self._wanted = by
        if not all(one.is_whole for one in self._gathered):
            self._found = [None for _ in self.others]
            self._slices.start()
        elif self.ready:
            self._jump()

    def parting(self) -> Parting | None:
        """What each robot did at the difference that is told about."""
        if self.chosen is None or self.own is None:
            return None
        run, difference = self.chosen
        runs = (self.own, self.others[run])
        one, other = (Teller(each.project) for each in runs)
        return told(difference, (one, other), (_events(runs[0].log), _events(runs[1].log)))

    def _jump(self) -> None:
        by, self._wanted = self._wanted, 0
        t = self.viewing.t
        if self.chosen in self.marks and t == self._at:
            place = self.marks.index(self.chosen) + by
        else:
            times = [difference.at[0] for _, difference in self.marks]
            place = bisect_right(times, t) if by > 0 else bisect_left(times, t) - 1
        if not 0 <= place < len(self.marks):
            self.ended.emit(by)
            return
        self.chosen = self.marks[place]
        self._line_up()
        self.viewing.seek(self.chosen[1].at[0])
        self._at = self.viewing.t
        self.changed.emit()

    # -- finding them --------------------------------------------------------------------

    def _go_on(self) -> None:
        end = time.perf_counter() + SLICE
        while time.perf_counter() < end:
            if not any(one.go_on(PIECE) for one in self._gathered):
                self._slices.stop()
                self._align()
                return

    def _align(self) -> None:
        own, *others = (one.deeds for one in self._gathered)
        for run, other in enumerate(others):
            if own.count + other.count <= self._at_once:
                self._take(run, alike(own, other))
            else:
                self._worker(run).ask((own, other))

    def _worker(self, run: int) -> Worker:
        while len(self._workers) <= run:
            number = len(self._workers)
            worker = Worker(self._command, self)
            worker.answered.connect(lambda found, number=number: self._take(number, found))
            worker.said.connect(lambda said: _log.error("Comparing failed: %s", said))
            worker.gone.connect(self.failed)
            self._workers.append(worker)
        return self._workers[run]

    def _take(self, run: int, found: Alike) -> None:
        self._found[run] = found
        if not self.ready:
            return
        every = [
            (number, difference)
            for number, one in enumerate(self._found)
            for difference in (one.differences if one is not None else ())
        ]
        self.marks = sorted(every, key=lambda mark: (mark[1].at[0], mark[0]))
        if self.chosen not in self.marks:
            self.chosen = None
        self._line_up()
        self.changed.emit()
        if self._wanted:
            self._jump()


def _start(log: TraceLog) -> float:
    return log.time(0) if len(log) else 0.0


def _events(log: TraceLog) -> Callable[[int], TraceFields]:
    """An event by its seq."""
    return lambda seq: log[bisect_left(log, seq, key=lambda event: event["seq"])]
