"""What stands at the left of a window: project, outline and palette, or one panel instead."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow

DRAWING = ("project", "outline", "palette")
"""Docks that make room."""


class LeftPlace:
    """Of one window. order: docks that may stand there, one at a time, the first that is wanted."""

    def __init__(
        self, window: QMainWindow, docks: Mapping[str, QDockWidget], order: tuple[str, ...]
    ) -> None:
        self._window, self._docks, self._order = window, docks, order
        self._wanted: set[str] = set()
        self._shown: str | None = None
        self._away: tuple[str, ...] = ()

    def want(self, name: str, wanted: bool) -> None:
        """It shall stand there, or need not any more."""
        (self._wanted.add if wanted else self._wanted.discard)(name)
        self._settle()

    def release(self, name: str) -> None:
        """It stands elsewhere now, by a person's hand, and is seen there."""
        self._wanted.discard(name)
        self._settle(elsewhere=name)

    def _settle(self, elsewhere: str = "") -> None:
        first = next((name for name in self._order if name in self._wanted), None)
        for name in self._order:
            if name in self._wanted and name != first:
                self._docks[name].hide()
        if first == self._shown:
            return
        before, self._shown = self._shown, first
        docks = self._docks
        if before is None:
            self._away = tuple(name for name in DRAWING if not docks[name].isHidden())
        leaving = self._away if before is None else (before,)
        wide = max((docks[name].width() for name in leaving), default=0)
        for name in leaving:
            if name != elsewhere:
                docks[name].hide()
        for name in self._away if first is None else (first,):
            docks[name].show()
        if first is not None and wide:
            self._window.resizeDocks([docks[first]], [wide], Qt.Orientation.Horizontal)
