"""The trace as a table: every event of the log, and the chosen row is where the cursor is."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QStyle
from tests.gui.live.test_log import played
from tests.gui.live.test_timeline import shown

from situ_studio.live.log import TraceLog
from situ_studio.live.recordings import Recording
from situ_studio.live.viewing import Viewing
from situ_studio.panels.trace import Trace, words
from situ_studio.theme import LIGHT

FONT = Qt.ItemDataRole.FontRole


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


def whole(table: Any, column: int) -> bool:
    """Whether that column has room for the words of every row."""
    model, metrics = table.model(), QFontMetrics(table.model().index(0, 0).data(FONT))
    words = [model.index(n, column).data() for n in range(model.rowCount())]
    margin = 2 * (table.style().pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin) + 1)
    widest = max(metrics.horizontalAdvance(text) for text in words)
    return bool(words) and widest + margin <= table.columnWidth(column)


def test_times_are_the_clocks_of_all_other_views_and_never_cut(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    begun = datetime(2026, 3, 28, 23, 59, 50)
    log = TraceLog()
    log.add({**e, "time": (begun + timedelta(seconds=e["t"])).isoformat()} for e in events)
    it = studio(project("conversation"))
    window = it.window
    robot, viewing = window.robot, window.robot.follower.viewing
    robot.follower.show_recording(Recording(Path("run.mcap"), "conversation", False, {}, log))
    for name in ("trace", "why"):
        window.bottom.choose(name)
    it.settle()
    times = [robot.trace.model().index(n, 0).data() for n in range(len(log))]
    assert times == [viewing.written(event["t"]) for event in log]
    # The run went on after midnight.
    assert times[-1].startswith("2026-03-29 00:0")
    assert whole(robot.trace, 0)
    window.bottom.choose("trace")
    robot.trace.setFocus()
    it.click_row(robot.trace, robot.trace.model().index(len(log) - 1, 0))
    it.key(Qt.Key.Key_F7)
    panel = window.why.panel
    assert panel.links
    assert whole(panel.table, 0)


def test_several_of_a_kind_are_names_in_a_row() -> None:
    event: Any = {"kind": "abandon", "seq": 1, "t": 0.0, "cause": None, "module": "transfer"}
    assert words({**event, "resources": ["base", "head"]}) == (
        "module transfer, resources base head"
    )
