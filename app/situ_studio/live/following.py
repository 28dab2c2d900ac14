"""Follow mode: the drawings keep in view where the robot is, while somebody wants it."""

from __future__ import annotations

from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary, WeakSet

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QApplication
from shiboken6 import isValid

from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.edits.edit import Place

if TYPE_CHECKING:
    from situ_studio.views.document_view import DocumentView
    from situ_studio.window.main_window import MainWindow

KEPT = "follow_robot"
"""Where the settings keep whether it is wanted."""


class FollowMode(QObject):
    """Of one window. A drawing is moved when the robot goes elsewhere, never while it stays: who
    looks around meanwhile is left alone, and so is whose hand is on the mouse. One that is hidden
    when the robot goes is moved as it is shown again.
    """

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.on = window.settings.value(KEPT, True, bool) is True
        self._seen: WeakKeyDictionary[DocumentView, tuple[Place, ...]] = WeakKeyDictionary()
        self._hidden: WeakSet[DocumentView] = WeakSet()

    def toggle(self) -> None:
        self.on = not self.on
        self._window.settings.setValue(KEPT, self.on)
        self._seen.clear()
        if self.on:
            self._window.robot.follower.refresh()
        self._window.actions_.refresh()

    def bring(self, view: DocumentView, live: LiveView | LiveScript | None) -> None:
        """To be told what a view shows of the robot."""
        places, canvas = _here(live), view.canvas
        if places == self._seen.get(view) or QApplication.mouseButtons().value:
            return
        if not self.on or canvas is None:
            return
        self._seen[view] = places
        if canvas.isVisible():
            canvas.bring_into_view(places)
        else:
            self._hidden.add(view)
            canvas.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show:
            # Once it has its size.
            QTimer.singleShot(0, self, self._bring_hidden)
        return super().eventFilter(watched, event)

    def _bring_hidden(self) -> None:
        """Those that are shown again."""
        for view in [one for one in self._hidden if isValid(one) and one.canvas.isVisible()]:
            self._hidden.discard(view)
            view.canvas.removeEventFilter(self)
            if self.on:
                view.canvas.bring_into_view(self._seen.get(view, ()))


def _here(live: LiveView | LiveScript | None) -> tuple[Place, ...]:
    if isinstance(live, LiveView):
        return tuple(("state", no) for no in sorted(live.active))
    if isinstance(live, LiveScript) and live.situation is not None:
        return (("situation", live.situation),)
    return ()
