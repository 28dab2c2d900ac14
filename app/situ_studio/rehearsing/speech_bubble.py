"""What the robot says in a rehearsal, and for how long still; whether it is heard here."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent, QShowEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from situ.decide.step import SECOND
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.rehearsing.course import Speaking
from situ_studio.widgets.icon_widgets import IconLabel

HIGH = 3
"""px of the bar that tells how much has been said."""


class SpeechBubble(QFrame):
    """``sound_asked``: somebody wants to hear it, or not any longer. ``unsounded``: it begins to
    say that, and it is not heard here."""

    sound_asked = Signal(object)
    unsounded = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._said: float | None = None
        self.setProperty("role", "box")
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 7, 8, 5)
        column.setSpacing(3)
        top = QHBoxLayout()
        top.setSpacing(8)
        self._icon = IconLabel(theme, "speech", "text3", 16)
        top.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignTop)
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setAccessibleDescription(self.tr("What the robot says"))
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        top.addWidget(self.words, 1)
        column.addLayout(top)
        bottom = QHBoxLayout()
        self.left = QLabel()
        self.left.setProperty("role", "label")
        self.left.setAccessibleDescription(self.tr("How long it still says that"))
        bottom.addWidget(self.left, 1)
        self.sound = Flag(theme, self.tr("Sound"))
        self.sound.setToolTip(self.tr("Hear what the robot says, at 1 ×"))
        self.sound.committed.connect(self.sound_asked)
        bottom.addWidget(self.sound)
        column.addLayout(bottom)
        self.unheard = QLabel()
        self.unheard.setProperty("role", "refused")
        self.unheard.setWordWrap(True)
        self.unheard.setTextFormat(Qt.TextFormat.PlainText)
        self.unheard.hide()
        column.addWidget(self.unheard)
        self.show_speaking(None, 0)

    def show_speaking(self, speaking: Speaking | None, now: int) -> None:
        """now: the rehearsal's time, µs."""
        text = f"“{speaking.text}”" if speaking is not None else self.tr("The robot says nothing")
        self._said, left = None, ""
        if speaking is not None and speaking.began is not None and speaking.until is not None:
            whole, remaining = speaking.until - speaking.began, max(speaking.until - now, 0)
            self._said = 1 - remaining / whole
            left = self.tr("{0:.1f} s left").format(remaining / SECOND)
        if text != self.words.text():
            self.words.setText(text)
            self.words.setProperty("role", "" if speaking is not None else "words")
            self.words.style().polish(self.words)
            self._icon.set_icon("speech", "accent" if speaking is not None else "text3")
            if speaking is not None and not self.sound.isChecked():
                self.unsounded.emit(self.tr("The robot says {0}").format(text))
        self.left.setText(left)
        self.update()

    def show_unheard(self, why: str) -> None:
        """Why nothing is heard; nothing where it is."""
        self.unheard.setText(why)
        self.unheard.setVisible(bool(why))

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        # Most of what is said has room: what stands below it does not jump.
        self.words.setMinimumHeight(2 * self.words.fontMetrics().lineSpacing())

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._said is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("accent"))
        wide = (self.width() - 12) * self._said
        painter.drawRoundedRect(QRectF(6, self.height() - HIGH - 1, wide, HIGH), 1.5, 1.5)
        painter.end()
