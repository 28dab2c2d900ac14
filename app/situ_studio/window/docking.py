"""The panels round the documents: where they are, and how they come back there."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, QEvent, QObject, QSettings, Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QWidget

from situ_studio.panels.header import TitleBar

PANELS, FOLDED = "panels", "panels_folded"
"""Where the settings keep them."""


class Docking(QObject):
    """The docks of one window, by name in ``docks``.

    They are hidden as a whole where no project is shown, and come back as they were: shown or
    closed, docked or floating, of the size that they had. ``sized`` says that a person, now or
    some time before, has given them their sizes.
    """

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.docks: dict[str, QDockWidget] = {}
        self.sized = False
        self._shown = False
        self._first = QByteArray()
        self._before = QByteArray()
        self._pressed: list[tuple[int, int]] = []

    def add(
        self, name: str, title: str, panel: QWidget, header: TitleBar, area: Qt.DockWidgetArea
    ) -> None:
        """One more panel, with a header by which it is dragged."""
        dock = QDockWidget(title, self._window)
        dock.setObjectName(name)
        dock.setWidget(panel)
        dock.setTitleBarWidget(header)
        self._window.addDockWidget(area, dock)
        self.docks[name] = dock

    def begin(self) -> None:
        """Once all of them and the toolbars are there: so they lie at first. Hides them."""
        self._first = self._before = self._window.saveState()
        self.hide()

    # -- with a project and without ---------------------------------------------------

    def hide(self) -> None:
        """Hides them until ``show``."""
        if self._shown:
            self._shown = False
            self._before = self._window.saveState()
        for dock in self.docks.values():
            dock.hide()

    def show(self) -> None:
        """Shows them as they were before ``hide``."""
        if not self._shown:
            self._shown = True
            if not self._window.restoreState(self._before):
                self.reset()

    def reset(self) -> None:
        """All of them where they lie at first, none closed, none floating."""
        self.sized = False
        if self._shown:
            self._window.restoreState(self._first)
        else:
            self._before = self._first

    # -- from one time to the next ------------------------------------------------------

    def restore(self, settings: QSettings) -> None:
        """They will be where they were the last time, when they are shown."""
        kept = settings.value(PANELS)
        if isinstance(kept, QByteArray):
            self._before, self.sized = kept, True

    def keep(self, settings: QSettings) -> None:
        """Keeps where they are for the next time."""
        if self._shown:
            settings.setValue(PANELS, self._window.saveState())
        elif self._before != self._first:
            settings.setValue(PANELS, self._before)

    # -- what a person does with the mouse ----------------------------------------------

    def watch(self, event: QEvent) -> None:
        """Is told what comes to the window itself: there the lines between panels are dragged."""
        if event.type() == QEvent.Type.MouseButtonPress:
            self._pressed = self._sizes()
        elif event.type() == QEvent.Type.MouseButtonRelease and self._pressed != self._sizes():
            self.sized = True

    def _sizes(self) -> list[tuple[int, int]]:
        return [(d.width(), d.height()) for d in self.docks.values()]
