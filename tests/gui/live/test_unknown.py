"""What is not known of a run: said in the status bar, hatched in the timeline, told on cards."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QRect
from PySide6.QtGui import QImage
from tests.gui.live.test_log import played, told
from tests.gui.live.test_recordings import came, recording, until_shown

from situ.resources import examples
from situ_studio.live import recordings
from situ_studio.live.log import Gap, TraceLog
from situ_studio.live.recordings import ReadingRecording
from situ_studio.live.timeline import gaps
from situ_studio.live.timeline.axis import TimeAxis
from situ_studio.live.timeline.painting import EDGE, GUTTER


@settings(max_examples=60, deadline=None)
@given(st.sets(st.integers(1, 80), min_size=1), st.integers(1, 9))
def test_every_event_up_to_the_last_is_there_or_is_counted_as_unknown(
    seqs: set[int], block: int
) -> None:
    log = TraceLog(limit=20, block=block)
    log.add([told(seq, seq / 10) for seq in sorted(seqs)])
    assert len(log) + sum(gap.count for gap in log.unknown) == max(seqs)
    for gap in log.gaps:
        there = [event["seq"] for event in log if event["t"] in (gap.t, gap.to)]
        assert there[-1] - there[0] - 1 == gap.count or len(there) == 1
        assert gap.to > log.lanes.start
    assert bool(log.lacks) == (log[0]["seq"] > 1)


def test_a_gap_is_seen_however_short_and_not_where_it_is_not() -> None:
    axis = TimeAxis()
    axis.start, axis.seen, axis.width = 10.0, 10.0, 100.0
    assert gaps.seen(axis, Gap(12.0, 14.0, 3)) == (20.0, 40.0)
    assert gaps.seen(axis, Gap(12.0, 12.0, 3)) == (17.0, 20.0)
    assert gaps.seen(axis, Gap(-math.inf, 11.0, 3)) == (0.0, 10.0)
    assert gaps.seen(axis, Gap(-math.inf, 9.0, 3)) is None
    assert gaps.seen(axis, Gap(21.0, 22.0, 3)) is None
    assert gaps.words(Gap(0.0, 1.0, 12_345)) == "12,345 events are not known"


def test_a_run_that_is_not_known_whole_says_so_where_it_is_looked_at(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    where = project("reception")
    events = played("reception", "known-user.jsonl")[2]
    entered = [n for n, event in enumerate(events) if event["kind"] == "enter"]
    # It was met late, and some events in the middle never came.
    first, hole = entered[1], entered[3]
    lacking = [event for n, event in enumerate(events) if n >= first and n not in (hole, hole + 1)]
    it = studio(where)

    def look(name: str, events: list[dict[str, Any]]) -> Any:
        it.answers.put("recording", recording(tmp_path / name, events, where))
        it.window.commands.open_recording()
        until_shown(it)
        it.window.bottom.choose("timeline")
        it.settle()
        return it.window.robot.follower.viewing

    def hatched(start: float, end: float) -> int:
        """Pixels of the colour of what is not known, between two moments."""
        chart = it.window.robot.timeline.chart
        left, right = (round(chart.axis.x(t)) + GUTTER for t in (start, end))
        area = QRect(left + 1, EDGE, max(right - left - 1, 1), chart.viewport().height() - EDGE)
        image = chart.viewport().grab(area).toImage().convertToFormat(QImage.Format.Format_RGB32)
        pixel = it.window.theme.color("text3").rgb().to_bytes(4, sys.byteorder)
        return bytes(image.constBits()).count(pixel)

    viewing = look("whole.mcap", events)
    status, chart = it.window.status.link, it.window.robot.timeline.chart
    assert "known since" not in status.text()
    assert "missed" not in status.text()
    assert hatched(*viewing.span) == 0
    viewing = look("lacking.mcap", lacking)
    assert f", known since {viewing.begun}" in status.text()
    assert ", 2 events missed" in status.text()
    (gap,) = viewing.log.gaps
    start = viewing.span[0]
    chart.axis.start = start - 5.0
    chart.set_theme(it.window.theme)
    assert hatched(start - 4.0, start) > 50
    assert hatched(gap.t - 3.0, gap.to) > 0
    middle = QPoint(round(chart.axis.x((gap.t + gap.to) / 2)) + GUTTER, EDGE + 8)
    assert chart.told_at(middle) == "2 events are not known"
    # How often the robot came to a state counts from there on only, and its card says so.
    viewing.seek(viewing.span[1])
    live = it.window.views["reception.rbd.xml"].canvas.look.live
    assert live.since == viewing.begun


def test_a_second_run_in_one_file_is_told_and_not_mixed_with_the_first(
    qt: Any, tmp_path: Path
) -> None:
    events = played("conversation", "fig5.jsonl")[2]
    # The second is longer: what of it has a higher seq is none of the first.
    second = [{**event, "seq": n, "kind": "lost"} for n, event in enumerate(events * 2, 1)]
    reading = ReadingRecording()
    where = Path(examples()["conversation"])
    reading.start(recording(tmp_path / "run.mcap", [*events, *second], where))
    (read,) = came(reading)
    assert [event["seq"] for event in read.log] == [event["seq"] for event in events]
    assert read.notice() == "run.mcap holds another run behind this one, which is not shown."
    reading.start(recording(tmp_path / "run.mcap", events, where))
    (read,) = came(reading)
    assert read.notice() == ""


def test_a_recording_of_more_events_than_are_kept_says_that_its_beginning_is_not_shown(
    qt: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recordings, "TraceLog", lambda: TraceLog(limit=100, block=20))
    reading = ReadingRecording()
    events = [told(n, n / 10) for n in range(1, 301)]
    where = Path(examples()["conversation"])
    reading.start(recording(tmp_path / "run.mcap", events, where))
    (read,) = came(reading)
    assert read.log.gone > 0
    assert f"the first {read.log.gone} are not shown" in read.notice()


def test_lines_are_taken_up_to_where_another_run_begins() -> None:
    log = TraceLog()
    lines = [msgspec.json.encode(told(seq, 1.0)) for seq in (1, 2, 2, 3, 1, 4)]
    assert not log.add_lines(lines)
    assert [event["seq"] for event in log] == [1, 2, 3]
    assert log.add_lines([msgspec.json.encode(told(4, 1.0))])
