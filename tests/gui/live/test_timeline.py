"""The timeline: what happened on one axis of time, and hands and keys that move its cursor."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.live.test_link import connect
from tests.gui.live.test_recordings import opened

import situ
from situ_studio.live.timeline.painting import GUTTER

LEFT = Qt.MouseButton.LeftButton
SHIFT = Qt.KeyboardModifier.ShiftModifier


def shown(studio: Any, where: Path, file: Path, name: str, script: str) -> tuple[Any, Any]:
    """A window whose timeline shows what was recorded of that scenario."""
    it, _ = opened(studio, where, file, name, script)
    it.window.bottom.choose("timeline")
    it.settle()
    return it, it.window.robot.timeline


def place(chart: Any, t: float, y: int = 100) -> QPoint:
    return QPoint(round(chart.axis.x(t)) + GUTTER, y)


def test_a_recorded_run_is_seen_whole_and_hands_move_the_cursor_through_it(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    it, timeline = shown(
        studio, project("conversation"), tmp_path / "run.mcap", "conversation", "fig5.jsonl"
    )
    chart, viewing = timeline.chart, it.window.robot.follower.viewing
    viewport, axis = chart.viewport(), chart.axis
    start, end = viewing.span
    assert axis.start <= start < end <= axis.end
    kinds = [(row.kind, row.name) for row in chart.rows]
    assert ("state", "converse") in kinds
    assert ("situation", "") in kinds
    assert ("resource", "head") in kinds
    # A click puts the cursor there: to half a px.
    there = place(chart, end / 2, 30)
    QTest.mouseClick(viewport, LEFT, pos=there)
    assert abs(viewing.t - end / 2) <= axis.pixel
    # So does a drag along the edge: it follows the hand, not further than there is something.
    edge = place(chart, end / 4, 8)
    QTest.mousePress(viewport, LEFT, pos=edge)
    QTest.mouseMove(viewport, edge + QPoint(60, 0))
    assert abs(viewing.t - (end / 4 + 60 * axis.pixel)) <= axis.pixel
    QTest.mouseMove(viewport, QPoint(viewport.width() + 90, 8))
    assert viewing.t == end
    QTest.mouseRelease(viewport, LEFT, pos=edge)
    # A drag elsewhere moves what is seen, not the cursor.
    before, t = axis.start, viewing.t
    QTest.mousePress(viewport, LEFT, pos=place(chart, end / 2, 40))
    QTest.mouseMove(viewport, place(chart, end / 2, 40) + QPoint(-30, 0))
    QTest.mouseRelease(viewport, LEFT, pos=place(chart, end / 2, 40))
    assert abs(axis.start - (before + 30 * axis.pixel)) < axis.pixel
    assert viewing.t == t
    # The wheel sees less time; what is under it stays.
    at = QPointF(place(chart, end / 2, 40))
    about, seen = axis.t(at.x() - GUTTER), axis.seen
    QApplication.sendEvent(
        viewport,
        QWheelEvent(
            at,
            QPointF(viewport.mapToGlobal(at.toPoint())),
            QPoint(),
            QPoint(0, 120),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        ),
    )
    assert axis.seen < seen
    assert abs(axis.t(at.x() - GUTTER) - about) < 1e-6
    it.click(timeline.whole)
    assert axis.start <= start < end <= axis.end
    # A block says what it is, and since when.
    lane = viewing.log.lanes.situation
    sound = lane.value.index("sound")
    middle = (lane.t[sound] + lane.t[sound + 1]) / 2
    row = next(n for n, (kind, _) in enumerate(kinds) if kind == "situation")
    y = 24 + sum(r.height for r in chart.rows[:row]) + 10 - chart.verticalScrollBar().value()
    told = chart.told_at(place(chart, middle, y))
    assert told.startswith("sound, from ")
    state = chart.told_at(place(chart, end, 30) - QPoint(3, 0))
    assert state.startswith("5 garden, from ")


def test_keys_go_through_a_run_event_by_event_and_every_view_follows(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path, until: Any
) -> None:
    it, timeline = shown(
        studio, project("reception"), tmp_path / "run.mcap", "reception", "known-user.jsonl"
    )
    chart, viewing = timeline.chart, it.window.robot.follower.viewing
    start, end = viewing.span
    timeline.setFocus()
    assert chart.hasFocus()
    it.key(Qt.Key.Key_End)
    assert viewing.t == end
    it.key(Qt.Key.Key_Home)
    assert viewing.t == start
    it.key(Qt.Key.Key_Right)
    first = viewing.t
    assert first == viewing.log.time(viewing.log.count(start))
    it.key(Qt.Key.Key_Left)
    assert viewing.t == start
    it.key(Qt.Key.Key_Right, SHIFT)
    assert viewing.t == start + 1
    it.click(timeline.step)
    assert viewing.t > start + 1
    it.click(timeline.back)
    assert viewing.t <= start + 1
    # Seen closely, the cursor is brought into sight wherever it goes.
    for _ in range(12):
        it.key(Qt.Key.Key_Plus)
    assert chart.axis.seen < (end - start) / 10
    it.key(Qt.Key.Key_End)
    assert chart.axis.start <= end <= chart.axis.end
    canvas = it.window.views[it.window.current_file].canvas
    entered = viewing.log.now.applications["reception"].entered
    assert canvas.look.live.counts == entered
    it.key(Qt.Key.Key_Home)
    assert sum(canvas.look.live.counts.values()) == 1 < sum(entered.values())
    it.key(Qt.Key.Key_Space)
    assert viewing.follows
    # At the end of a run that is over nothing is drawn again and again.
    for timer in chart.findChildren(QTimer):
        if timer.isActive():
            until(timer.timeout, lambda timer=timer: not timer.isActive())
    # What is drawn as a curve is chosen.
    timeline.choices.aboutToShow.emit()
    choices = {action.text(): action for action in timeline.choices.actions()}
    assert set(choices) == set(viewing.log.lanes.data)
    name = sorted(choices)[0]
    was = any(row.name == name for row in chart.rows if row.kind == "data")
    choices[name].trigger()
    assert any(row.name == name for row in chart.rows if row.kind == "data") is not was
    picture = chart.grab()
    it.window.choose_theme("dark")
    it.settle()
    assert chart.grab().toImage() != picture.toImage()


def test_of_a_robot_the_end_is_followed_until_somebody_looks_back(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    it.window.bottom.choose("timeline")
    it.settle()
    timeline, viewing = it.window.robot.timeline, it.window.robot.follower.viewing
    chart = timeline.chart
    until(link.moment_changed, lambda: link.log.now.situation == "conversation")
    with situ.connect(there.endpoint, module="gaze-sound", resources=["head"]) as board:
        board.set("sound.slap", 40)
        until(link.moment_changed, lambda: link.log.now.situation == "sound")
        # Rows come by themselves.
        until(chart.marked, lambda: any(row.name == "sound.slap" for row in chart.rows))
        assert viewing.follows
        assert chart.axis.start < viewing.t <= chart.axis.end + 0.1
        it.click(timeline.pause)
        assert not viewing.follows
        t, start = viewing.t, chart.axis.start
        board.set("sound.slap", 50)
        until(link.moment_changed, lambda: link.log.now.board["sound.slap"].value == 50)
        it.settle()
        assert (viewing.t, chart.axis.start) == (t, start)
        assert viewing.moment().board["sound.slap"].value == 40
        it.click(timeline.pause)
        assert viewing.follows
        assert viewing.moment().board["sound.slap"].value == 50
    it.window.robot.disconnect_robot()
    assert not timeline.isVisible()
