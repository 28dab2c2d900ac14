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

from situ_studio.live.log import KINDS, TraceLog
from situ_studio.live.recordings import Recording
from situ_studio.live.viewing import Viewing
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.trace import CAUSE, Trace, kind_words
from situ_studio.panels.trace_kinds import GROUPS

FONT = Qt.ItemDataRole.FontRole


def seqs(trace: Any) -> list[int]:
    """As the view has them, by its rows."""
    return [int(row.key) for row in trace.rows.rows]


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


def test_every_kind_has_a_designers_word_and_one_button() -> None:
    assert set(kind_words()) == set(KINDS)
    assert len(set(kind_words().values())) == len(KINDS)
    assert sorted(kind for kinds in GROUPS.values() for kind in kinds) == sorted(KINDS)


def test_of_some_kinds_the_table_has_those_alone_as_they_come_and_go(qt: Any) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    log = TraceLog(limit=20, block=10)
    viewing = Viewing(log)
    trace = Trace(LIGHT)
    trace.watch(viewing)
    wanted = frozenset(GROUPS["situations"] + GROUPS["data"])

    def those() -> list[int]:
        return [event["seq"] for event in log if event["kind"] in wanted]

    trace.show_kinds(wanted)
    for n in range(0, len(events), 7):
        log.add(events[n : n + 7])
        trace.go_on()
        assert seqs(trace) == those()
    assert those()
    assert len(log) < len(events)
    # More came than are kept since it was looked at last.
    log.add({**event, "seq": event["seq"] + len(events)} for event in events)
    trace.go_on()
    assert seqs(trace) == those()
    trace.show_kinds(frozenset())
    assert seqs(trace) == [event["seq"] for event in log]
    trace.deleteLater()


def test_rows_are_in_a_designers_words_and_what_they_came_from_is_a_click_away(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, _ = shown(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    window = it.window
    events = list(window.robot.follower.viewing.log)
    trace, viewing = window.robot.trace, window.robot.follower.viewing
    buttons = window.robot.kinds.buttons
    window.bottom.choose("trace")
    it.settle()
    log = viewing.log
    went = next(e for e in events if e["kind"] == "transition")
    cause = next(e for e in events if e["seq"] == went["cause"])
    row, place = log.place(went["seq"]), log.place(cause["seq"])
    cells = trace.rows.rows[row].cells
    assert cells[1] == "Transition"
    assert cells[CAUSE] == f"Event, {viewing.written(cause['t'])}"
    assert cells[3] == "converse goes from 1 hello to 2 sleep by clickYes"
    first = next(n for n, e in enumerate(log) if e["cause"] is None and e["t"] > 0)
    assert trace.rows.rows[first].cells[CAUSE] == "from outside"
    # A click on what it came from goes there; anywhere else on the row to the event itself.
    it.click_row(trace, trace.model().index(row, CAUSE))
    assert trace.currentIndex().row() == place
    assert viewing.t == cause["t"]
    it.click_row(trace, trace.model().index(row, 3))
    assert trace.currentIndex().row() == row
    it.click_row(trace, trace.model().index(first, CAUSE))
    assert trace.currentIndex().row() == first
    # By keys: to that cell, and Enter.
    trace.setCurrentIndex(trace.model().index(row, CAUSE))
    it.key(Qt.Key.Key_Return)
    assert trace.currentIndex().row() == place
    # Only transitions and the like; a row is the event that it shows.
    it.click(buttons["states"])
    assert {events[log.place(seq)]["kind"] for seq in seqs(trace)} <= set(GROUPS["states"])
    count = trace.model().rowCount()
    assert window.robot.kinds._count.text() == f"{count} of {len(log)}"
    shown_row = seqs(trace).index(went["seq"])
    it.click_row(trace, trace.model().index(shown_row, 0))
    assert viewing.t == went["t"]
    # What the cursor has come to is the last of them by then.
    viewing.seek(went["t"] + 0.001)
    assert seqs(trace)[trace.currentIndex().row()] >= went["seq"]
    # What it came from is none of these: all are shown, and it is the current row.
    it.click_row(trace, trace.model().index(shown_row, CAUSE))
    assert not buttons["states"].isChecked()
    assert trace.currentIndex().row() == place
    assert seqs(trace) == [event["seq"] for event in log]


def test_the_place_of_a_seq_and_events_of_some_kinds_are_found_whatever_is_missing() -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    for some in (events, events[3::3], events[:7], events[:8], [*events[:5], *events[9:]], []):
        log = TraceLog(block=4)
        log.add(some)
        there = {event["seq"]: place for place, event in enumerate(log)}
        for seq in range(-1, len(events) + 3):
            assert log.place(seq) == there.get(seq)
        for place, event in enumerate(log):
            assert log.kind(place) == event["kind"]
        for kinds in (("data",), ("enter", "exit"), KINDS):
            wanted = [place for place, event in enumerate(log) if event["kind"] in kinds]
            assert list(log.of_kinds(kinds)) == wanted
            assert list(log.of_kinds(kinds, 3)) == [place for place in wanted if place >= 3]
    log.add([{**events[0], "seq": 10_000, "t": 1e6, "kind": "of another time"}])
    assert log.kind(0) == ""
