"""What a screen reader says at once, wherever the focus is: what was done, found or went wrong.

Readers on Linux say a notification that comes into sight; the announcements that Qt has besides
reach those of other systems only (Orca knows them since version 45).
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import cycle

from PySide6.QtCore import QObject, QSysInfo, QTimer, Signal
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QAccessibleEvent
from PySide6.QtWidgets import QAbstractItemView, QWidget

from situ_studio.assistive.heard_as import hear_as

PAUSE = 600
"""Milliseconds until a reader is told: Orca drops what comes with many other events at once."""
AT_ONCE = 4
"""Announcements that are kept: a reader asks for the words when it comes to them."""


class Announcements(QWidget):
    """Tells them when the focus has settled, which would cut them short. It is never seen."""

    told = Signal(str)
    """That was told, whether anybody listens or not."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.notify: Callable[[QAccessibleEvent], None] = QAccessible.updateAccessibility
        self._notes = cycle([_Note(self) for _ in range(AT_ONCE)])
        self._waiting: list[str] = []
        self._spoken: list[str] = []
        self._settled = soon(self, self._tell)
        self.pause = soon(self, self._speak)
        self.pause.setInterval(PAUSE)
        self.hide()

    def tell(self, text: str) -> None:
        """Once, after what happens now; what is told in the same moment is told as one."""
        if text and text not in self._waiting:
            self._waiting.append(text)
            self._settled.start()

    def _tell(self) -> None:
        text = ". ".join(one.rstrip(".") for one in self._waiting)
        self._waiting.clear()
        self.told.emit(text)
        if QAccessible.isActive():
            self._spoken.append(text)
            if not self.pause.isActive():
                self.pause.start()

    def _speak(self) -> None:
        text = ". ".join(self._spoken)
        self._spoken.clear()
        if QSysInfo.kernelType() != "linux":
            self.notify(QAccessibleAnnouncementEvent(self, text))
            return
        note = next(self._notes)
        note.setAccessibleName(text)
        self.notify(QAccessibleEvent(note, QAccessible.Event.ObjectShow))


def announce(near: QWidget, text: str) -> None:
    """Tells it in the window in which ``near`` is, if that has announcements."""
    announcements = near.window().findChild(Announcements)
    if announcements is not None:
        announcements.tell(text)


class _Note(QWidget):
    """Has the words of one announcement."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        hear_as(self, QAccessible.Role.Notification)


class CurrentRow(QObject):
    """Tells the current row of a view also while the focus is in the field that filters it.

    The view keeps its model.
    """

    def __init__(self, view: QAbstractItemView) -> None:
        super().__init__(view)
        self.notify: Callable[[QAccessibleEvent], None] = QAccessible.updateAccessibility
        self._view = view
        self._settled = soon(self, self._tell)
        view.selectionModel().currentChanged.connect(lambda now, before: self._settled.start())

    def _tell(self) -> None:
        # What has the focus tells its rows itself.
        if not self._view.hasFocus():
            tell_row(self._view, self.notify)


def tell_row(
    view: QAbstractItemView,
    notify: Callable[[QAccessibleEvent], None] = QAccessible.updateAccessibility,
) -> None:
    """Tells the current row now, as one that has the focus."""
    if not QAccessible.isActive() or not view.isVisible() or not view.currentIndex().isValid():
        return
    heard = QAccessible.queryAccessibleInterface(view)
    row = heard.focusChild()
    if row is not None:
        event = QAccessibleEvent(view, QAccessible.Event.Focus)
        event.setChild(heard.indexOfChild(row))
        notify(event)


def soon(parent: QObject, what: Callable[[], None]) -> QTimer:
    """Does it when all that happens now is done."""
    timer = QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(0)
    timer.timeout.connect(what)
    return timer
