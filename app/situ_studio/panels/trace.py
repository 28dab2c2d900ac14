"""Trace: what the connected robot did, one event a row, the last at the bottom."""

from __future__ import annotations

from PySide6.QtGui import QKeyEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from situ.decide.values import in_text
from situ_studio.language import tr
from situ_studio.live.moment import TraceFields
from situ_studio.panels.table import Row, RowsTable
from situ_studio.theme import Theme

LIMIT = 2_000
"""Rows shown; the log keeps more."""

_ALWAYS = ("kind", "seq", "t", "cause", "time")
_LOUD = ("transition", "situation", "authority", "error", "warning")


class Trace(RowsTable):
    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        titles = (tr("Time"), tr("What"), tr("Because of"), tr("Details"))
        super().__init__(tr("Trace"), titles, (90, 120, 90), theme, parent)
        self.rows.tips = (
            tr("When it happened, since the robot started."),
            tr("What happened, with its number."),
            tr("The number of what it came from."),
            tr("What is known about it."),
        )
        self._follows = True
        bar = self.verticalScrollBar()
        bar.rangeChanged.connect(self._on_range)
        bar.sliderMoved.connect(self._on_scrolled)
        bar.actionTriggered.connect(lambda _: self._on_scrolled(bar.sliderPosition()))

    def show_all(self, events: list[TraceFields]) -> None:
        """Begins anew with these events."""
        self._follows = True
        self.rows.show([_row(event) for event in events[-LIMIT:]])
        self.scrollToBottom()

    def add(self, events: list[TraceFields]) -> None:
        """Adds events; stays at the end where it was at the end."""
        self.rows.append([_row(event) for event in events], LIMIT)
        if self._follows:
            self.scrollToBottom()

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


def _row(event: TraceFields) -> Row:
    cause = "" if event["cause"] is None else f"{event['cause']}"
    cells = (f"{event['t']:.3f} s", f"{event['seq']} {event['kind']}", cause, words(event))
    return Row(str(event["seq"]), cells, event["kind"] in _LOUD)


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
        parts.append(f"{key} {in_text(value)}")
    return f"{application}: {', '.join(parts)}" if application else ", ".join(parts)
