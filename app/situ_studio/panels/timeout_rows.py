"""A timeout in the form of its state."""

from __future__ import annotations

from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QGridLayout,
    QLabel,
    QWidget,
)

from situ.document import rbd
from situ.document.words import numbered
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.help.help_topics import explain
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import (
    Choice,
    Flag,
    Number,
)
from situ_studio.panels.subject import LABEL, MARGIN
from situ_studio.wording.language import translated


class TimeoutRows(QWidget):
    """A timeout in the form of its state: seconds; where they are set, where it leads, and how."""

    changed = Signal(object)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._timeout: rbd.Timeout | None = None
        grid = QGridLayout(self)
        grid.setContentsMargins(MARGIN, 0, MARGIN, 4)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(4)
        grid.setColumnMinimumWidth(0, px(LABEL))
        label = QLabel(self.tr("Timeout"))
        label.setProperty("role", "label")
        label.setFixedWidth(px(LABEL))
        grid.addWidget(label, 0, 0)
        self.seconds = Number(unit=translated("s"), above=True)
        self.seconds.setPlaceholderText(self.tr("none"))
        self.seconds.setAccessibleName(self.tr("Timeout"))
        label.setBuddy(self.seconds)
        grid.addWidget(self.seconds, 0, 1)
        self._then = QLabel(self.tr("then to"))
        self._then.setProperty("role", "label")
        grid.addWidget(self._then, 1, 0)
        self.next = Choice(theme)
        self.next.setAccessibleName(self.tr("The timeout leads to"))
        grid.addWidget(self.next, 1, 1)
        self.idle = Flag(theme, self.tr("only when idle"))
        grid.addWidget(self.idle, 2, 1)
        grid.setColumnStretch(1, 1)
        for widget, name in (
            (label, "seconds"),
            (self.seconds, "seconds"),
            (self._then, "next"),
            (self.next, "next"),
            (self.idle, "idle"),
        ):
            explain(widget, "timeout", name)
        self.seconds.set_help(self.seconds.toolTip())
        self.seconds.committed.connect(self._on_seconds)
        self.next.committed.connect(lambda v: self._change(next=v))
        self.idle.committed.connect(lambda v: self._change(idle=v))

    def show_value(self, timeout: rbd.Timeout | None, vocabulary: Vocabulary) -> None:
        self._timeout = timeout
        self.seconds.show_value(timeout.seconds if timeout is not None else None)
        self.next.offer(
            (
                (None, self.tr("raises the event timeout")),
                *((no, numbered(no, name)) for no, name in vocabulary.states),
                (rbd.AGAIN, self.tr("the same state, anew")),
                (rbd.BACK, self.tr("back to where it came from")),
            )
        )
        for widget in (self._then, self.next, self.idle):
            widget.setVisible(timeout is not None)
        if timeout is not None:
            self.next.show_value(timeout.next)
            self.idle.show_value(timeout.idle)

    def _on_seconds(self, seconds: float | None) -> None:
        if seconds is None:
            self.changed.emit(None)
        elif self._timeout is None:
            self.changed.emit(rbd.Timeout(seconds))
        else:
            self._change(seconds=seconds)

    def _change(self, **fields: Any) -> None:
        if self._timeout is not None:
            self.changed.emit(replace(self._timeout, **fields))
