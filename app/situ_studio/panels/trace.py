"""Trace: what the robot did that is looked at, one event a row, the last at the bottom."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex
from PySide6.QtGui import QKeyEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from situ.decide.values import in_text
from situ_studio.language import tr
from situ_studio.live.log import TraceLog
from situ_studio.live.log_rows import LogRows
from situ_studio.live.moment import TraceFields
from situ_studio.live.viewing import Viewing
from situ_studio.panels.table import Row, RowsTable
from situ_studio.theme import Theme

_ALWAYS = ("kind", "seq", "t", "cause", "time")
_LOUD = ("transition", "situation", "authority", "error", "warning")


class Trace(RowsTable):
    """Every event of the log that ``viewing`` has. The row that is chosen is where its cursor is,
    either way; while it follows, the end is seen, unless somebody has scrolled elsewhere.
    """

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        titles = (tr("Time"), tr("What"), tr("Because of"), tr("Details"))
        super().__init__(tr("Trace"), titles, (90, 120, 90), theme, parent)
        self.rows.tips = (
            tr("When it happened: by the clock, or in seconds since the robot started."),
            tr("What happened, with its number."),
            tr("The number of what it came from."),
            tr("What is known about it."),
        )
        self._viewing: Viewing | None = None
        self._shown = LogRows(TraceLog(), self._row)
        self._follows = True
        self.chosen.connect(self._seek)
        bar = self.verticalScrollBar()
        bar.rangeChanged.connect(self._on_range)
        bar.sliderMoved.connect(self._on_scrolled)
        bar.actionTriggered.connect(lambda _: self._on_scrolled(bar.sliderPosition()))

    def watch(self, viewing: Viewing) -> None:
        """Shows what that looks at, from now on."""
        self._viewing = viewing
        viewing.exchanged.connect(self._read)
        viewing.moved.connect(self._show_cursor)
        self._read()

    def go_on(self) -> None:
        """The log may have more by now; stays at the end where it was at the end."""
        news = self._shown.news()
        if news is None:
            self._read()
            return
        gone, came = news
        self.rows.drop(gone, self._shown.drop)
        self.rows.add(came, self._shown.take)
        if came:
            self._make_room()
        if came and self._follows:
            self.scrollToBottom()

    def _read(self) -> None:
        assert self._viewing is not None
        self._follows = True
        self._shown = LogRows(self._viewing.log, self._row)
        self.rows.exchange(self._shown)
        self._make_room()
        self.scrollToBottom()

    def _make_room(self) -> None:
        """The last time is the longest: a day stands before it where the run has several."""
        assert self._viewing is not None
        if self._shown:
            self.make_room(0, self._shown[-1].cells[0])

    def _row(self, event: TraceFields) -> Row:
        assert self._viewing is not None
        cause = "" if event["cause"] is None else f"{event['cause']}"
        what = f"{event['seq']} {event['kind']}"
        cells = (self._viewing.written(event["t"]), what, cause, words(event))
        return Row(str(event["seq"]), cells, event["kind"] in _LOUD)

    def _show_cursor(self) -> None:
        viewing = self._viewing
        assert viewing is not None
        self.go_on()
        if viewing.follows:
            self.clearSelection()
            self.setCurrentIndex(QModelIndex())
            self._follows = True
            self.scrollToBottom()
            return
        self._follows = False
        chosen = self.currentIndex().row()
        if chosen < 0 or viewing.log.time(chosen) != viewing.t:
            # The last that has happened by then.
            self.setCurrentIndex(self.rows.index(viewing.log.count(viewing.t) - 1, 0))

    def _seek(self, index: QModelIndex) -> None:
        # The log may have forgotten some of the first since these rows were told.
        chosen = QPersistentModelIndex(index)
        self.go_on()
        if self._viewing is not None and chosen.isValid():
            self._viewing.seek(self._viewing.log.time(chosen.row()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        super().wheelEvent(event)
        self._on_scrolled(self.verticalScrollBar().value())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        super().keyPressEvent(event)
        self._on_scrolled(self.verticalScrollBar().value())

    def _on_scrolled(self, value: int) -> None:
        self._follows = value >= self.verticalScrollBar().maximum()

    def _on_range(self, _: int, end: int) -> None:
        # It may have been hidden, or lower, while events came.
        if self._follows:
            self.verticalScrollBar().setValue(end)


def words(event: TraceFields) -> str:
    """An event's own fields in one line: ``reception: 2 → 3 by clickContinue``."""
    fields = {key: value for key, value in event.items() if key not in _ALWAYS}
    parts = []
    application = fields.pop("application", None)
    if "from" in fields and "to" in fields:
        parts.append(f"{fields.pop('from') or 'nobody'} → {fields.pop('to') or 'nobody'}")
    for key, value in fields.items():
        if value is None or (key == "components"):
            continue
        several = isinstance(value, list) and all(isinstance(one, str) for one in value)
        parts.append(f"{key} {' '.join(value) if several else in_text(value)}")
    return f"{application}: {', '.join(parts)}" if application else ", ".join(parts)
