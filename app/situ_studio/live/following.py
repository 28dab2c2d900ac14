"""Follow mode: the drawings keep in view where the robot is, while somebody wants it."""

from __future__ import annotations

from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from PySide6.QtWidgets import QApplication

from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.edits.edit import Place

if TYPE_CHECKING:
    from situ_studio.views.document_view import DocumentView
    from situ_studio.window.main_window import MainWindow

KEPT = "follow_robot"
"""Where the settings keep whether it is wanted."""


class FollowMode:
    """Of one window. A drawing is moved when the robot goes elsewhere, never while it stays: who
    looks around meanwhile is left alone, and so is whose hand is on the mouse.
    """

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self.on = window.settings.value(KEPT, True, bool) is True
        self._seen: WeakKeyDictionary[DocumentView, tuple[Place, ...]] = WeakKeyDictionary()

    def toggle(self) -> None:
        self.on = not self.on
        self._window.settings.setValue(KEPT, self.on)
        self._seen.clear()
        self._window.actions_.refresh()

    def bring(self, view: DocumentView, live: LiveView | LiveScript | None) -> None:
        """To be told what a view shows of the robot."""
        places = _here(live)
        if places == self._seen.get(view) or QApplication.mouseButtons().value:
            return
        self._seen[view] = places
        if self.on and places and view.canvas is not None and view.canvas.isVisible():
            view.canvas.bring_into_view(places)


def _here(live: LiveView | LiveScript | None) -> tuple[Place, ...]:
    if isinstance(live, LiveView):
        return tuple(("state", no) for no in sorted(live.active))
    if isinstance(live, LiveScript) and live.situation is not None:
        return (("situation", live.situation),)
    return ()
