"""Trace: what the robot did that is looked at, one event a row, the last at the bottom."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from situ.rehearse.telling import Teller
from situ_studio.live.log import TraceLog
from situ_studio.live.log_rows import LogRows
from situ_studio.live.moment import TraceFields
from situ_studio.live.viewing import Viewing
from situ_studio.looks.theme import Theme
from situ_studio.panels.table import Row, RowsTable
from situ_studio.wording.language import said, tr

_LOUD = ("transition", "situation", "authority", "error", "warning")
CAUSE = 2
"""The column of what an event came from."""


class Trace(RowsTable):
    """Every event of the log that ``viewing`` has. The row that is chosen is where its cursor is,
    either way; while it follows, the end is seen, unless somebody has scrolled elsewhere.

    ``kinds``: only events of these are shown; none: all are. ``teller`` tells an event.
    """

    read = Signal()
    """Other rows, or more of them."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        titles = (tr("Time"), tr("What"), tr("Because of"), tr("Details"))
        super().__init__(tr("Trace"), titles, (90, 120, 170), theme, parent)
        self.rows.tips = (
            tr("When it happened: by the clock, or in seconds since the robot started."),
            tr("What kind of event it is."),
            tr("What it came from, and when: a click goes there."),
            tr("What happened."),
        )
        self.kinds: frozenset[str] = frozenset()
        self.teller: Callable[[TraceFields], Teller] = lambda _: Teller()
        self._words = kind_words()
        self._viewing: Viewing | None = None
        self._shown = LogRows(TraceLog(), self._row)
        self._follows = True
        self.chosen.connect(self._on_chosen)
        self.setMouseTracking(True)
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

    @property
    def every(self) -> int:
        """How many events there are, shown or not."""
        return len(self._viewing.log) if self._viewing is not None else 0

    def show_kinds(self, kinds: frozenset[str]) -> None:
        """Only events of these; none: all of them."""
        self.kinds = kinds
        self._read()
        self._show_cursor()

    def retell(self) -> None:
        """What events are told by is another."""
        self._shown.forget()
        self.viewport().update()

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
        if came or gone:
            self.read.emit()
        if came and self._follows:
            self.scrollToBottom()

    def _read(self) -> None:
        assert self._viewing is not None
        self._follows = True
        self._shown = LogRows(self._viewing.log, self._row, self.kinds)
        self.rows.exchange(self._shown)
        self._make_room()
        self.scrollToBottom()
        self.read.emit()

    def _make_room(self) -> None:
        """The last time is the longest: a day stands before it where the run has several."""
        assert self._viewing is not None
        if self._shown:
            time = self._shown[-1].cells[0]
            self.make_room(0, time)
            self.make_room(CAUSE, tr("{0}, {1}").format(max(self._words.values(), key=len), time))

    def _row(self, event: TraceFields) -> Row:
        viewing, teller = self._viewing, self.teller(event)
        assert viewing is not None
        log, cause, link = viewing.log, event["cause"], -1
        place = log.place(cause) if cause is not None else None
        if place is not None:
            kind = self._words.get(log.kind(place), "")
            because = tr("{0}, {1}").format(kind, viewing.written(log.time(place)))
            link = CAUSE
        elif cause is None:
            because = said(teller.origin(event))
        else:
            because = tr("not kept any more")
        what = self._words.get(event["kind"], str(event["kind"]))
        cells = (viewing.written(event["t"]), what, because, said(teller.tell(event)))
        return Row(str(event["seq"]), cells, event["kind"] in _LOUD, link=link)

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
        # The last that has happened by then.
        row, chosen = self._shown.before(viewing.log.count(viewing.t)), self.currentIndex().row()
        then = viewing.log.time(self._shown.place(row)) if row >= 0 else None
        if chosen < 0 or viewing.log.time(self._shown.place(chosen)) != then:
            self.setCurrentIndex(self.rows.index(row, 0))

    def _on_chosen(self, index: QModelIndex) -> None:
        # The log may have forgotten some of the first since these rows were told.
        chosen = QPersistentModelIndex(index)
        self.go_on()
        if self._viewing is None or not chosen.isValid():
            return
        log, place = self._viewing.log, self._shown.place(chosen.row())
        cause = log.place(log[place]["cause"]) if self._is_link(index) else None
        self._go_to(place if cause is None else cause)

    def _go_to(self, place: int) -> None:
        """The cursor goes to an event, and that is the current row, whatever kinds are shown."""
        viewing = self._viewing
        assert viewing is not None
        if self._shown.row_at(place) is None:
            self.show_kinds(frozenset())
        viewing.seek(viewing.log.time(place))
        row = self._shown.row_at(place)
        if row is not None and row != self.currentIndex().row():
            self.setCurrentIndex(self.rows.index(row, 0))

    def _is_link(self, index: QModelIndex) -> bool:
        return index.isValid() and self.rows.rows[index.row()].link == index.column()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        over = self._is_link(self.indexAt(event.position().toPoint()))
        shape = Qt.CursorShape.PointingHandCursor if over else Qt.CursorShape.ArrowCursor
        self.viewport().setCursor(shape)

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


def kind_words() -> dict[str, str]:
    """Each kind of event in a designer's words."""
    return {
        "data": tr("Data"),
        "condition": tr("Condition"),
        "situation": tr("Situation"),
        "acquire": tr("Request"),
        "abandon": tr("Given back"),
        "lost": tr("Module lost"),
        "connected": tr("Module connected"),
        "authority": tr("Authority"),
        "mapping": tr("Command"),
        "event": tr("Event"),
        "ignored": tr("Event ignored"),
        "exit": tr("State left"),
        "enter": tr("State entered"),
        "transition": tr("Transition"),
        "screen": tr("Screen"),
        "action": tr("Action begins"),
        "finished": tr("Action ends"),
        "cancelled": tr("Action cancelled"),
        "suspend": tr("Suspended"),
        "resume": tr("Goes on"),
        "paused": tr("Paused"),
        "resumed": tr("No longer paused"),
        "deployed": tr("Version"),
        "warning": tr("Warning"),
        "error": tr("Error"),
    }
