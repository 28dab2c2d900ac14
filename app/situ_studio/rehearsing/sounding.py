"""The robot's voice in a rehearsal: heard on this computer, while time goes as on the wall."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable

from PySide6.QtCore import QObject, Signal

from situ.document.texts import read_out
from situ_studio.live.moment import TraceFields
from situ_studio.rehearsing.course import Course, Speaking
from situ_studio.texts.listening import Listening


class Sounding(QObject):
    """Off until somebody wants it. voice: who speaks.

    A text that has not been heard to its end is, before the next; one that was cut off is silent.
    """

    told = Signal(str)
    """Why nothing is heard, in a line; nothing where all is well."""
    ended = Signal()
    """Nothing is said any longer, and nothing waits."""

    def __init__(self, voice: Listening, parent: QObject) -> None:
        super().__init__(parent)
        self.on = False
        self._voice = voice
        self._waiting: deque[tuple[Speaking, str]] = deque()
        voice.failed.connect(self.told)
        voice.changed.connect(self._go_on)

    @property
    def talks(self) -> bool:
        """Whether something is being said."""
        return self._voice.going

    def turn(self, on: bool) -> None:
        """On or off."""
        self.on = on and self._voice.can
        self.told.emit("" if not on or self.on else self._missing())

    def begin(self, course: Course | None) -> None:
        """What the robot says just now is heard, and nothing else; None: nothing."""
        self.silence()
        if self.on and course is not None:
            self._say(course)

    def take(self, events: Iterable[TraceFields], course: Course) -> None:
        """The rehearsal has gone on, at the pace of the clock on the wall."""
        if not self.on:
            return
        ended: set[int] = set()
        began = False
        for event in events:
            if event["kind"] == "finished":
                ended.add(event["seq"])
            elif event["kind"] == "mapping" and event["resource"] == "speech":
                began = event["value"] is not None
                if not began and event["cause"] not in ended:
                    self.silence()
        if began:
            self._say(course)

    def silence(self) -> None:
        """At once, and nothing is said later."""
        self._waiting.clear()
        self._voice.end()

    def _say(self, course: Course) -> None:
        speaking = course.speaking
        if speaking is not None:
            words = course.project.readings.get(speaking.language, {})
            self._waiting.append((speaking, read_out(speaking.text, words, speaking.language)))
            self._go_on()

    def _go_on(self) -> None:
        if self._waiting and not self._voice.going:
            one, text = self._waiting.popleft()
            self.told.emit("")
            self._voice.say(text, one.language, one.volume, one.rate)
        elif not self._voice.going:
            self.ended.emit()

    def _missing(self) -> str:
        return self.tr("espeak-ng is not installed on this computer, so the robot is not heard.")
