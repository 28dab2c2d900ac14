"""The bookmarks' menu of a timeline: added with a name, found again, removed."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QMenu, QWidget

from situ.errors import UsageError
from situ_studio.live.timeline.bookmarks import Bookmark, Bookmarks
from situ_studio.live.timeline.chart import TimelineChart
from situ_studio.wording.language import said

Ask = Callable[[str], str | None]
"""Asks a person for a name, with the usual one; None: nobody wants it."""


class Marking(QObject):
    """``menu`` has all that can be done with the bookmarks of what ``chart`` shows."""

    refused = Signal(str)
    """What could not be kept: why, in one line."""

    def __init__(self, chart: TimelineChart, bookmarks: Bookmarks, ask: Ask, top: QWidget) -> None:
        super().__init__(top)
        self._chart, self._viewing = chart, chart.viewing
        self._bookmarks, self._ask = bookmarks, ask
        self.menu = QMenu(top)
        self.menu.aboutToShow.connect(self._fill)
        chart.mark_asked.connect(self.add)

    def add(self) -> None:
        """At the cursor, which stays there."""
        self._viewing.pause()
        t = self._viewing.t
        there = self._bookmarks.at(t)
        name = self._ask(there.name if there is not None else self._chart.clock(t))
        if name is not None:
            self._try(lambda: self._bookmarks.add(t, name))

    def _fill(self) -> None:
        menu, t = self.menu, self._viewing.t
        menu.clear()
        menu.addAction(self.tr("Add a bookmark here… (B)")).triggered.connect(self.add)
        here = self._bookmarks.at(t)
        remove = menu.addAction(self.tr("Remove the bookmark here"))
        remove.setEnabled(here is not None)
        if here is not None:
            remove.triggered.connect(lambda: self._try(lambda: self._bookmarks.remove(here)))
        menu.addSeparator()
        if not self._bookmarks.every:
            menu.addAction(self.tr("There are no bookmarks yet")).setEnabled(False)
        for mark in self._bookmarks.every:
            # An & would be taken for the key of the entry.
            words = f"{self._chart.clock(mark.t)}   {mark.name}".replace("&", "&&")
            menu.addAction(words).triggered.connect(lambda _=False, mark=mark: self._go(mark))

    def _go(self, mark: Bookmark) -> None:
        self._viewing.seek(mark.t)

    def _try(self, change: Callable[[], None]) -> None:
        try:
            change()
        except UsageError as error:
            self.refused.emit(said(str(error)))
