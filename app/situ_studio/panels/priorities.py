"""A situation's priorities: its own are fields, those taken over stand pale below."""

from __future__ import annotations

from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from situ.document.spds import Entry, Situation, Spds
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.help.help_topics import explain
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice, Number
from situ_studio.widgets.icon_widgets import Elided, IconButton, IconLabel
from situ_studio.widgets.layouts import clear, rule


class PrioritiesEditor(QFrame):
    """One row a module; tells the entries anew, with words for the step."""

    changed = Signal(object, str)
    refused = Signal(str)
    """Why what was typed is not taken."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "box")
        self._entries: tuple[Entry, ...] = ()
        self._vocabulary = Vocabulary()
        self._shape: Any = None
        self._inherited: Any = None
        self._rows: list[tuple[Choice, Number]] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(1, 1, 1, 1)
        column.setSpacing(0)
        self._own, self._others = QVBoxLayout(), QVBoxLayout()
        column.addLayout(self._own)
        column.addLayout(self._others)

    def show_value(
        self, theme: Theme, script: Spds, situation: Situation, vocabulary: Vocabulary
    ) -> None:
        self._entries, self._vocabulary = situation.entries, vocabulary
        own = {e.module for e in situation.entries}
        every = script.priorities(situation)
        inherited = tuple(
            sorted(((m, p) for m, p in every.items() if m not in own), key=lambda pair: -pair[1])
        )
        # Apart: who writes into a row goes on there while what is taken over becomes less.
        shape = (theme.name, len(situation.entries))
        if shape != self._shape:
            self._shape = shape
            self._rebuild(theme, len(situation.entries))
        if (shape, inherited) != self._inherited:
            self._inherited = (shape, inherited)
            self._show_inherited(theme, inherited)
        for (module, priority), entry in zip(self._rows, situation.entries, strict=True):
            module.offer(tuple((m, m) for m in vocabulary.modules))
            module.show_value(entry.module)
            priority.show_value(entry.priority)
            holder = module.parentWidget()
            assert holder is not None
            holder.setAccessibleName(self.tr("Priority of {0}").format(entry.module))
        self.setVisible(bool(situation.entries or inherited))

    def row(self, index: int) -> tuple[Choice, Number]:
        return self._rows[index]

    def add(self) -> None:
        """A priority for the first module that has none here yet."""
        own = {e.module for e in self._entries}
        free = [m for m in self._vocabulary.modules if m not in own]
        if free:
            made = (*self._entries, Entry(free[0], 10))
            self.changed.emit(made, self.tr("Add a priority for {0}").format(free[0]))
            if self._rows:
                self._rows[-1][0].setFocus(Qt.FocusReason.OtherFocusReason)

    def _rebuild(self, theme: Theme, count: int) -> None:
        clear(self._own)
        self._rows = []
        for index in range(count):
            holder, line = self._line(theme, "module", self._own)
            module = Choice(theme)
            module.setAccessibleName(self.tr("Module"))
            module.committed.connect(lambda v, i=index: self._change(i, module=v))
            line.addWidget(module, 1)
            priority = Number(whole=True)
            priority.setPlaceholderText(self.tr("none"))
            priority.setAccessibleName(self.tr("Priority"))
            explain(module, "entry", "module")
            explain(priority, "entry", "priority")
            priority.setFixedWidth(px(56))
            priority.committed.connect(lambda v, i=index: self._change(i, priority=v))
            priority.refused.connect(self.refused)
            line.addWidget(priority)
            remove = IconButton(theme, "close", self.tr("Remove"), "text3", 12)
            remove.setFixedSize(px(18), px(18))
            remove.clicked.connect(lambda _=False, i=index: self._remove(i))
            line.addWidget(remove)
            self._own.addWidget(holder)
            self._rows.append((module, priority))

    def _show_inherited(self, theme: Theme, inherited: tuple[tuple[str, int], ...]) -> None:
        clear(self._others)
        for name, number in inherited:
            holder, line = self._line(theme, "text3", self._others)
            line.addWidget(Elided(name, "dim"), 1)
            words = QLabel(self.tr("taken over"))
            words.setProperty("role", "hint")
            line.addWidget(words)
            value = QLabel(str(number))
            value.setProperty("role", "dim")
            value.setFixedWidth(px(32))
            value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            line.addWidget(value)
            line.addSpacing(4)
            self._others.addWidget(holder)

    def _line(self, theme: Theme, tint: str, among: QVBoxLayout) -> tuple[QWidget, QHBoxLayout]:
        if among.count() or (among is self._others and self._own.count()):
            among.addWidget(rule())
        holder = QWidget()
        holder.setFixedHeight(px(34))
        line = QHBoxLayout(holder)
        line.setContentsMargins(7, 0, 6, 0)
        line.setSpacing(7)
        line.addWidget(IconLabel(theme, "module", tint, 15))
        return holder, line

    def _change(self, index: int, **fields: Any) -> None:
        entry = replace(self._entries[index], **fields)
        every = (*self._entries[:index], entry, *self._entries[index + 1 :])
        self.changed.emit(every, self.tr("Change the priority of {0}").format(entry.module))

    def _remove(self, index: int) -> None:
        gone = self._entries[index].module
        every = (*self._entries[:index], *self._entries[index + 1 :])
        self.changed.emit(every, self.tr("Remove the priority of {0}").format(gone))
