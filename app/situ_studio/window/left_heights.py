"""How the left of a low window is shared: the palette scrolls before the outline has few rows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QDockWidget, QStyle

from situ_studio.looks.letters import px
from situ_studio.panels.header import HEIGHT
from situ_studio.window.left_place import DRAWING

if TYPE_CHECKING:
    from situ_studio.window.frame import Frame

ROWS, ROW = 8, 22
"""States that the outline shows where the palette can make room for them; px of each."""


class LeftHeights(QObject):
    """Of one window: gives the palette the room that is left to it, anew where that changes.

    The project takes its rows, the outline ``ROWS`` of its own. Whatever of the two is closed,
    floats or lies elsewhere takes none, and a palette that floats has all that it wants.
    """

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self._frame = frame
        for name in DRAWING:
            dock = frame.docks[name]
            for changed in (dock.visibilityChanged, dock.topLevelChanged, dock.dockLocationChanged):
                changed.connect(self.settle)
        frame.project_tree.tree.model().rowsInserted.connect(self.settle)

    def settle(self) -> None:
        """The window, the project's rows or the place of a panel is another."""
        palette = self._frame.docks["palette"]
        if palette.isFloating():
            self._frame.palette_room.set_room(None)
            return
        rows = {"project": self._frame.project_tree.height_least(), "outline": ROWS * px(ROW)}
        taken = sum(px(HEIGHT) + high for name, high in rows.items() if self._above(name))
        self._frame.palette_room.set_room(self._high() - taken - px(HEIGHT))

    def _high(self) -> int:
        """Px from the toolbar to the status bar, without the lines between panels."""
        frame = self._frame
        others = (frame.menuBar(), frame.toolbar, frame.statusBar())
        line = QStyle.PixelMetric.PM_DockWidgetSeparatorExtent
        lines = len(DRAWING) * frame.style().pixelMetric(line, None, frame)
        return frame.height() - sum(one.height() for one in others) - lines

    def _above(self, name: str) -> bool:
        """Whether a panel takes room of the same edge, and does not share its own as a tab."""
        dock, palette = self._frame.docks[name], self._frame.docks["palette"]
        if dock.isHidden() or dock.isFloating() or self._tabs(dock, palette):
            return False
        return self._area(dock) == self._area(palette)

    def _tabs(self, dock: QDockWidget, palette: QDockWidget) -> bool:
        return dock in self._frame.tabifiedDockWidgets(palette)

    def _area(self, dock: QDockWidget) -> Qt.DockWidgetArea:
        return self._frame.dockWidgetArea(dock)
