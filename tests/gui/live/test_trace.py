"""The trace as a table: every event of the log, and the chosen row is where the cursor is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from tests.gui.live.test_log import played
from tests.gui.live.test_timeline import shown

from situ_studio.live.log import TraceLog
from situ_studio.live.viewing import Viewing
from situ_studio.panels.trace import Trace
from situ_studio.theme import LIGHT


def seqs(trace: Any) -> list[int]:
    """As the view has them, by its model."""
    model = trace.model()
    return [int(model.index(n, 1).data().split()[0]) for n in range(model.rowCount())]


def test_the_table_has_every_event_that_the_log_keeps_and_no_other(qt: Any) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(limit=20, block=10)
    viewing = Viewing(log)
    trace = Trace(LIGHT)
    trace.watch(viewing)
    for n in range(0, len(events), 7):
        log.add(events[n : n + 7])
        trace.go_on()
        assert seqs(trace) == [event["seq"] for event in log]
    assert len(log) < len(events)
    # More came than are kept since it was looked at last.
    log.add({**event, "seq": event["seq"] + len(events)} for event in events)
    trace.go_on()
    assert seqs(trace) == [event["seq"] for event in log]
    # Another run begins anew.
    log.clear()
    log.add(events[:5])
    trace.go_on()
    assert seqs(trace) == [1, 2, 3, 4, 5]
    other = TraceLog()
    other.add(events)
    viewing.show(other)
    assert len(seqs(trace)) == len(events)
    trace.deleteLater()


def test_the_chosen_row_is_where_the_cursor_is_either_way(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, _ = shown(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    trace, viewing = it.window.robot.trace, it.window.robot.follower.viewing
    it.window.bottom.choose("trace")
    it.settle()
    log = viewing.log
    viewing.seek(log.time(len(log) // 2))
    chosen = trace.currentIndex().row()
    assert log.time(chosen) == viewing.t
    assert trace.visualRect(trace.currentIndex()).intersects(trace.viewport().rect())
    # Of several at one moment the one that was clicked stays chosen.
    first = log.earlier(log.time(len(log) - 1))
    assert first < len(log) - 1
    it.click_row(trace, trace.model().index(first, 0))
    assert viewing.t == log.time(first)
    assert trace.currentIndex().row() == first
    # By keys too, and the cursor goes along.
    it.key(Qt.Key.Key_Up)
    it.key(Qt.Key.Key_Return)
    assert viewing.t == log.time(first - 1)
    viewing.follow()
    assert not trace.currentIndex().isValid()
