"""A rehearsal that runs: its course, and the pace at which its time goes on."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal

from situ.decide import inputs
from situ.decide.step import SECOND
from situ_studio.live.moment import TraceFields
from situ_studio.rehearsing.course import MILLISECOND, Course, Version

TICK = 40
"""Milliseconds between two looks at the clock."""
LONGEST = 0.5
"""Seconds that may lie between two of them: a computer that slept does not rush ahead."""


class Running(QObject):
    """A course in its time. clock: seconds that go on; pace: how often as fast, 0 stands still."""

    went = Signal(list)
    """What happened: events, perhaps none, for time goes on too."""
    begun = Signal()
    """``course`` is another one, from its start."""
    turned = Signal()
    """The course goes on with another version of the project."""
    paced = Signal()
    """``pace`` is another one."""

    def __init__(
        self, version: Version, clock: Callable[[], float], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._clock = clock
        self._at = clock()
        self.pace = 1
        self.course = Course(version.project, version.files)
        self._runs = version.project
        self._ticks = QTimer(self)
        self._ticks.setInterval(TICK)
        self._ticks.timeout.connect(self.catch_up)
        self._ticks.start()

    @property
    def seconds(self) -> float:
        """The rehearsal's time."""
        return self.course.now / SECOND

    def begin(self, version: Version) -> None:
        """From the start, with this version of the project."""
        self._at = self._clock()
        self.course = Course(version.project, version.files)
        self._runs = version.project
        self.begun.emit()
        self._tell()

    def stop(self) -> None:
        """Its time does not go on any more."""
        self._ticks.stop()

    def set_pace(self, pace: int) -> None:
        self.catch_up()
        if pace == self.pace:
            return
        self.pace = pace
        if pace:
            self._ticks.start()
        else:
            self._ticks.stop()
        self.paced.emit()

    def catch_up(self) -> None:
        """Comes to the present."""
        now = self._clock()
        passed, self._at = min(now - self._at, LONGEST), now
        if self.pace and passed > 0:
            self.course.advance(self.course.now + _whole(passed * self.pace))
            self._tell()

    def step(self) -> None:
        """Stands still at what happens next."""
        self.set_pace(0)
        due = self.course.due
        if due is not None:
            self.course.advance(-(-due // MILLISECOND) * MILLISECOND)
        self._tell()

    def give(self, given: inputs.AnyInput) -> None:
        """Somebody does something now."""
        self._do(lambda: self.course.give(given))

    def take_in(self, version: Version) -> None:
        """It goes on with another version, as after a deploy."""
        self._do(lambda: self.course.take_in(version))

    def hurry(self) -> None:
        """What waits to be taken in is, at once."""
        self._do(self.course.hurry)

    def go_back(self) -> None:
        """What ran before runs again."""
        self._do(self.course.go_back)

    def _do(self, does: Callable[[], None]) -> None:
        self.catch_up()
        does()
        self._tell()

    def _tell(self) -> None:
        came: list[TraceFields] = self.course.take()
        if self.course.project is not self._runs:
            self._runs = self.course.project
            self.turned.emit()
        self.went.emit(came)


def _whole(seconds: float) -> int:
    """µs, whole milliseconds of them: what was done is written down in these."""
    return round(seconds * 1000) * MILLISECOND
