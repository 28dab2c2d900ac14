"""What kinds of events there are in a designer's words, and the buttons that choose among them."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from situ_studio.looks.letters import px
from situ_studio.panels.trace import Trace
from situ_studio.wording.language import tr

GROUPS: dict[str, tuple[str, ...]] = {
    "states": ("transition", "enter", "exit", "suspend", "resume", "paused", "resumed"),
    "events": ("event", "ignored"),
    "data": ("data",),
    "situations": ("situation", "condition"),
    "resources": ("acquire", "abandon", "lost", "connected", "authority", "mapping"),
    "actions": ("action", "finished", "cancelled", "screen"),
    "problems": ("warning", "error"),
    "versions": ("deployed",),
}
"""Kinds that are chosen together."""


class TraceKinds(QWidget):
    """The trace with a button for each group of kinds: those that are down are shown, all where
    none is.
    """

    def __init__(self, trace: Trace, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._trace = trace
        names = {
            "states": tr("States"),
            "events": tr("Events"),
            "data": tr("Data"),
            "situations": tr("Situations"),
            "resources": tr("Resources"),
            "actions": tr("Actions"),
            "problems": tr("Problems"),
            "versions": tr("Versions"),
        }
        frame = QFrame()
        frame.setProperty("role", "segments")
        frame.setAccessibleName(tr("Kinds of events that are shown"))
        frame.setFixedHeight(px(28))
        within = QHBoxLayout(frame)
        within.setContentsMargins(1, 1, 1, 1)
        within.setSpacing(0)
        self.buttons: dict[str, QPushButton] = {}
        for group, words in names.items():
            button = QPushButton(words)
            button.setCheckable(True)
            button.setAccessibleName(words)
            button.setToolTip(tr("Only {0}, and what else is chosen here").format(words))
            button.clicked.connect(self._choose)
            self.buttons[group] = button
            within.addWidget(button)
        self._count = QLabel()
        self._count.setProperty("role", "dim")
        line = QHBoxLayout()
        line.setContentsMargins(12, 4, 12, 4)
        line.setSpacing(12)
        line.addWidget(frame)
        line.addWidget(self._count, 1, Qt.AlignmentFlag.AlignRight)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(line)
        column.addWidget(trace, 1)
        self.setFocusProxy(trace)
        trace.read.connect(self._tell)
        self._tell()

    def _choose(self) -> None:
        down = [group for group, button in self.buttons.items() if button.isChecked()]
        self._trace.show_kinds(frozenset(kind for group in down for kind in GROUPS[group]))

    def _tell(self) -> None:
        """How many are shown; a jump to one of another kind shows all."""
        if not self._trace.kinds:
            for button in self.buttons.values():
                button.setChecked(False)
        shown, every = self._trace.model().rowCount(), self._trace.every
        self._count.setText(
            tr("{0} of {1}").format(f"{shown:,}", f"{every:,}") if self._trace.kinds else ""
        )
