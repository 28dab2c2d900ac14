"""The timeline's drawing by itself: hands, keys, and what it says of long and odd runs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QPainter, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.live.test_log import told
from tests.gui.live.test_timeline import LEFT, SHIFT, place

from situ_studio.live.log import TraceLog
from situ_studio.live.timeline import drawing, painting
from situ_studio.live.timeline.axis import TimeAxis
from situ_studio.live.timeline.bookmarks import Bookmarks
from situ_studio.live.timeline.chart import TimelineChart
from situ_studio.live.timeline.cursor import CursorPainter
from situ_studio.live.timeline.drawn import blocks
from situ_studio.live.timeline.painting import NAMED
from situ_studio.live.timeline.panel import Timeline
from situ_studio.live.viewing import Viewing
from situ_studio.looks.theme import LIGHT
from situ_studio.wording.value_words import number

STATES = ("7", "8")


def entered(*times: float) -> list[dict[str, Any]]:
    """One state and the other by turns."""
    return [
        told(seq, t, "enter", application="a", state=STATES[seq % 2])
        for seq, t in enumerate(times, 1)
    ]


@pytest.fixture
def chart(qt: Any) -> Iterator[TimelineChart]:
    """Ten minutes, a state each; 600 px wide and a second each."""
    log = TraceLog()
    log.add(entered(*(60.0 * n for n in range(11))))
    made = TimelineChart(LIGHT, Viewing(log), Bookmarks(), lambda _, state: state)
    made.resize(600 + painting.GUTTER, 120)
    made.show()
    made.show_all()
    made.viewing.seek(30.0)
    made.grab()
    yield made
    made.deleteLater()


def wheel(chart: TimelineChart, at: QPoint, turned: QPoint, held: Any) -> None:
    viewport = chart.viewport()
    event = QWheelEvent(
        QPointF(at),
        QPointF(viewport.mapToGlobal(at)),
        QPoint(),
        turned,
        Qt.MouseButton.NoButton,
        held,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(viewport, event)


def test_what_a_block_says_is_its_whole_length_though_only_a_part_of_it_is_seen(
    chart: TimelineChart, monkeypatch: Any
) -> None:
    asked: list[float] = []

    def watched(lane: Any, start: float, end: float, least: float) -> Any:
        asked.append(end)
        return blocks(lane, start, end, least)

    chart.zoom(0.05)
    monkeypatch.setattr("situ_studio.live.timeline.drawing.blocks", watched)
    assert chart.told_at(place(chart, 30.0, 30)) == "8, from 0.000 s, 60.00 s"
    # A run has a million blocks more: what is not seen is not looked at.
    assert max(asked) <= chart.axis.end


def written(chart: TimelineChart, monkeypatch: Any) -> list[str]:
    """What the chart writes into its blocks and at its upper edge."""
    found: list[str] = []

    def draw(painter: QPainter, *args: Any) -> None:
        found.append(args[-1])
        QPainter.drawText(painter, *args)

    watched = type("Watched", (QPainter,), {"drawText": draw})
    monkeypatch.setattr(drawing, "QPainter", watched)
    chart._changed()
    chart.grab()
    monkeypatch.undo()
    return found


def test_a_block_is_named_where_four_letters_fit_and_says_nothing_where_not(
    chart: TimelineChart, monkeypatch: Any
) -> None:
    chart._painter.state_name = lambda _, state: f"{state} hello"
    assert "7 hello" in written(chart, monkeypatch)
    shortened = set()
    for _ in range(30):
        chart.zoom(1.02)
        shortened |= {words for words in written(chart, monkeypatch) if words.endswith("…")}
    assert shortened
    assert min(map(len, shortened)) > NAMED


def test_without_a_clock_no_time_before_the_run_is_written(
    chart: TimelineChart, monkeypatch: Any
) -> None:
    assert chart.viewing.wall() is None
    chart.axis.start = -300.0
    seen = written(chart, monkeypatch)
    assert "0 s" in seen
    assert not [words for words in seen if words.startswith("-")]


def test_everything_of_a_month_is_seen_at_once(qt: Any) -> None:
    log = TraceLog()
    month = 30 * 86400.0
    log.add(entered(0.0, month))
    chart = TimelineChart(LIGHT, Viewing(log), Bookmarks(), lambda _, state: state)
    chart.resize(800, 120)
    chart.show()
    chart.show_all()
    assert chart.axis.start <= 0.0 < month <= chart.axis.end
    chart.deleteLater()


def test_of_bookmarks_upon_each_other_the_one_that_is_seen_is_gone_to(
    chart: TimelineChart,
) -> None:
    chart.bookmarks.add(100.0, "the first of them, with a long name")
    chart.bookmarks.add(140.0, "the second")
    QTest.mouseClick(chart.viewport(), LEFT, pos=place(chart, 140.0, 10) + QPoint(12, 0))
    assert chart.viewing.t == 140.0


def test_a_cursor_at_a_bookmark_can_be_drawn_away_by_its_line(chart: TimelineChart) -> None:
    chart.bookmarks.add(100.0, "here")
    chart.viewing.seek(100.0)
    viewport, line = chart.viewport(), place(chart, 100.0, 10) + QPoint(2, 0)
    QTest.mousePress(viewport, LEFT, pos=line)
    QTest.mouseMove(viewport, line + QPoint(80, 0))
    QTest.mouseRelease(viewport, LEFT, pos=line + QPoint(80, 0))
    assert abs(chart.viewing.t - chart.axis.t(chart.axis.x(100.0) + 82)) <= 2 * chart.axis.pixel


def test_the_wheel_with_shift_moves_what_is_seen_and_equals_is_a_plus(
    chart: TimelineChart,
) -> None:
    chart.viewing.follow()
    start, seen = chart.axis.start, chart.axis.seen
    wheel(chart, place(chart, 300.0, 40), QPoint(0, -120), SHIFT)
    assert chart.axis.start > start
    assert chart.axis.seen == seen
    # Who looks elsewhere stays there.
    assert not chart.viewing.follows
    QTest.keyClick(chart, Qt.Key.Key_Equal)
    assert chart.axis.seen < seen


def test_what_comes_while_somebody_looks_at_the_past_is_not_drawn_but_that_is_now(
    chart: TimelineChart, monkeypatch: Any
) -> None:
    log, viewing = chart.viewing.log, chart.viewing
    viewing.show(log, lambda: log.lanes.end)
    viewing.seek(30.0)
    chart.zoom(0.2)
    chart.grab()
    drawn: list[int] = []
    take = chart._take_picture

    def watched() -> None:
        drawn.append(log.seq)
        take()

    monkeypatch.setattr(chart, "_take_picture", watched)
    log.add([told(20, 700.0, "enter", application="a", state="7")])
    chart.grab()
    assert drawn == []
    # Another application's row comes all the same.
    log.add([told(21, 701.0, "enter", application="b", state="7")])
    chart._go_on()
    chart.grab()
    assert drawn == [21]
    assert [row.name for row in chart.rows] == ["a", "b"]
    chart.show_all()
    there = place(chart, 701.0, 14)
    picture = chart.viewport().grab().toImage()
    assert picture.pixelColor(there - QPoint(12, 6)) == LIGHT.color("live")


@pytest.mark.parametrize(
    ("value", "words"),
    [(0.25, "0.25"), (1200, "1200"), (65535, "65535"), (1e9, "1e+09"), (-123456.7, "-123457")],
)
def test_numbers_are_written_whole_up_to_a_million(value: float, words: str) -> None:
    assert number(value) == words


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(0.5, "500 ms"), (90, "90 s"), (600, "10 min"), (7200, "2 h"), (30 * 86400, "30 d")],
)
def test_how_much_is_seen_is_told_in_the_unit_that_people_would_take(
    qt: Any, seconds: float, words: str
) -> None:
    timeline = Timeline(LIGHT, Viewing(TraceLog()), lambda _, state: state, lambda _: None)
    timeline.chart.zoom(seconds / timeline.chart.axis.seen)
    assert timeline.seen.text() == words
    timeline.deleteLater()


def test_the_moment_that_is_followed_is_seen_whenever_it_is_drawn(qt: Any) -> None:
    """Its clock goes on from the moment that the rows end at it to the one that they are drawn."""
    viewing, axis = Viewing(TraceLog()), TimeAxis()
    viewing.log.add(entered(0.0, 40.0))
    axis.width = 300.0

    def drawn(end: float) -> QImage:
        viewing.show(viewing.log, lambda: end)
        image = QImage(400, 60, QImage.Format.Format_RGB32)
        image.fill(Qt.GlobalColor.white)
        painter = QPainter(image)
        CursorPainter(axis, LIGHT, viewing).paint(painter, image.size(), ())
        painter.end()
        return image

    axis.end_at(40.0)
    at_once = drawn(40.0)
    blank = QImage(at_once)
    blank.fill(Qt.GlobalColor.white)
    assert at_once != blank
    assert drawn(40.3) == at_once


def test_shift_and_an_arrow_go_a_second_on_or_back_wherever_events_are(
    chart: TimelineChart,
) -> None:
    QTest.keyClick(chart, Qt.Key.Key_Right, SHIFT)
    assert chart.viewing.t == 31.0
    QTest.keyClick(chart, Qt.Key.Key_Left, SHIFT)
    assert chart.viewing.t == 30.0
    QTest.keyClick(chart, Qt.Key.Key_Left)
    assert chart.viewing.t == 0.0
