"""The clock of a rehearsal: its time, pause and step, how fast it goes, and the start again."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from situ_studio.looks.theme import Theme
from situ_studio.panels.tabs import Segments
from situ_studio.widgets.icon_widgets import IconButton

PACES = (1, 10)


class ClockBar(QWidget):
    """``pace_asked``: how often as fast as the clock on the wall; 0 is a pause."""

    pace_asked = Signal(int)
    step_asked = Signal()
    restart_asked = Signal()
    save_asked = Signal()
    """What was done shall become a scenario."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pace = 1
        self._last = 1
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(4)
        self.pause = IconButton(theme, "pause", self.tr("Pause"), "text", 16)
        self.pause.clicked.connect(self._on_pause)
        line.addWidget(self.pause)
        self.step = IconButton(theme, "step", self.tr("Go to what happens next"), "text", 16)
        self.step.clicked.connect(self.step_asked)
        line.addWidget(self.step)
        self.restart = IconButton(theme, "repeat", self.tr("From the start"), "text", 16)
        self.restart.clicked.connect(self.restart_asked)
        line.addWidget(self.restart)
        words = self.tr("Save as a scenario")
        self.save = IconButton(theme, "scenarios", words, "text", 16)
        self.save.clicked.connect(self.save_asked)
        line.addWidget(self.save)
        line.addStretch(1)
        self.time = QLabel()
        self.time.setProperty("role", "medium")
        self.time.setAccessibleDescription(self.tr("Time of the rehearsal"))
        line.addWidget(self.time)
        line.addSpacing(8)
        segments = tuple((str(pace), "", f"{pace} ×") for pace in PACES)
        self.paces = Segments(theme, segments, self.tr("How fast"))
        self.paces.chosen.connect(lambda name: self.pace_asked.emit(int(name)))
        line.addWidget(self.paces)
        self.show_pace(1)

    def show_pace(self, pace: int) -> None:
        self._pace = pace
        if pace:
            self._last = pace
            self.paces.show_choice(str(pace))
            self.pause.show_icon("pause", self.tr("Pause"))
        else:
            self.pause.show_icon("play", self.tr("Go on"))

    def show_time(self, seconds: float) -> None:
        minutes, rest = divmod(int(seconds * 10), 600)
        self.time.setText(f"{minutes}:{rest / 10:04.1f}")

    def _on_pause(self) -> None:
        self.pace_asked.emit(0 if self._pace else self._last)
