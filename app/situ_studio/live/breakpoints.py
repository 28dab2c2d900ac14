"""Breakpoints: where the connected robot pauses, who set it, one a row."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QWidget

from situ_studio.language import tr
from situ_studio.panels.table import Row, RowsTable
from situ_studio.theme import Theme

Breakpoint = dict[str, Any]
"""As the tag ``debugger.breakpoints`` has it."""


class Breakpoints(RowsTable):
    """state_name: what a designer calls an application's state. Delete takes a row's away."""

    removed = Signal(int)
    """Its number."""

    def __init__(
        self, theme: Theme, state_name: Callable[[str, str], str], parent: QWidget | None = None
    ) -> None:
        titles = (tr("No."), tr("The robot pauses"), tr("Application"), tr("Set by"))
        super().__init__(tr("Breakpoints"), titles, (50, 320, 160), theme, parent)
        self.rows.tips = (
            tr("The breakpoint's number; green where something waits at it"),
            tr("A click goes there, Delete takes the breakpoint away"),
            tr("Which application pauses"),
            tr("The operator who set it"),
        )
        self._state_name = state_name

    def show_breakpoints(self, every: Sequence[Breakpoint], stopped: frozenset[int]) -> None:
        """stopped: those at which something waits now."""
        self.rows.show([self._row(one, one["id"] in stopped) for one in every])

    def _row(self, one: Breakpoint, stopped: bool) -> Row:
        cells = (
            str(one["id"]),
            self._where(one),
            one.get("application") or tr("all"),
            str(one["writer"]).removeprefix("operator:"),
        )
        return Row(str(one["id"]), cells, stopped)

    def _where(self, one: Breakpoint) -> str:
        def name(state: str) -> str:
            return self._state_name(one.get("application") or "", state)

        if one.get("situation") is not None:
            said = tr("in situation {0}").format(one["situation"])
        elif one.get("state") is not None:
            said = tr("in state {0}").format(name(one["state"]))
        elif one.get("to") is None:
            said = tr("before it leaves state {0}").format(name(one["from"]))
        elif one.get("from") is None:
            said = tr("before it comes to state {0}").format(name(one["to"]))
        else:
            said = tr("between state {0} and state {1}").format(name(one["from"]), name(one["to"]))
        if one.get("when"):
            said += " " + tr("(with a condition)")
        return said

    def event(self, event: QEvent) -> bool:
        ours = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Delete
        if ours and event.type() == QEvent.Type.ShortcutOverride:
            # Else what is selected in the drawing would be deleted.
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        row = self.currentIndex().row()
        if event.key() == Qt.Key.Key_Delete and row >= 0:
            self.removed.emit(int(self.rows.rows[row].key))
        else:
            super().keyPressEvent(event)
