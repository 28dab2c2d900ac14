"""Runs beside one another in the timeline, and from one difference to the next."""

from __future__ import annotations

import gc
import sys
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEventLoop, QObject, QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QToolButton
from tests.gui.live.test_log import played
from tests.gui.live.test_recordings import PATIENCE, recording, until_shown

from situ.rehearse.comparing import alike
from situ.rehearse.deeds import Deeds
from situ_studio.live.comparing import AGREED, COMMAND, COMMON, START, Compared, Comparing
from situ_studio.live.comparing_projects import RecordedProjects
from situ_studio.live.comparing_strip import ComparingStrip
from situ_studio.live.log import TraceLog
from situ_studio.live.recordings import Recording
from situ_studio.live.timeline.beside import LETTERS
from situ_studio.live.timeline.bookmarks import Bookmark, Bookmarks, beside
from situ_studio.live.timeline.painting import GUTTER
from situ_studio.live.viewing import Viewing
from situ_studio.looks.theme import LIGHT

LEFT = Qt.MouseButton.LeftButton


def until(comparing: Any, ready: Callable[[], bool] | None = None) -> None:
    """Waits until it is known where the runs part."""
    ready = ready or (lambda: bool(comparing.ready))
    loop, late = QEventLoop(), QTimer()
    comparing.changed.connect(lambda: loop.quit() if ready() else None)
    late.setSingleShot(True)
    late.timeout.connect(loop.quit)
    late.start(PATIENCE)
    if not ready():
        loop.exec()
    assert late.isActive(), "it was never known"
    late.stop()


def logged(name: str, script: str, later: float = 0.0) -> TraceLog:
    log = TraceLog()
    log.add([{**event, "t": event["t"] + later} for event in played(name, script)[2]])
    return log


def compared(
    one: TraceLog, other: TraceLog, marks: tuple[tuple[Bookmark, ...], ...] = ((), ()), **how: Any
) -> Comparing:
    comparing = Comparing(Viewing(one), **how)
    own = Compared("a", one, bookmarks=marks[0])
    comparing.add(own, Compared("b", other, bookmarks=marks[1]))
    until(comparing)
    return comparing


def test_from_one_difference_to_the_next_and_back(qt: Any) -> None:
    comparing = compared(
        logged("reception", "known-user.jsonl"), logged("reception", "second-thoughts.jsonl")
    )
    viewing = comparing.viewing
    times = [difference.at[0] for _, difference in comparing.marks]
    assert times == sorted(times)
    assert len(times) > 3
    viewing.seek(0.0)
    ends: list[int] = []
    comparing.ended.connect(ends.append)
    seen = []
    for _ in times:
        comparing.go(1)
        assert comparing.chosen is not None
        seen.append(comparing.chosen)
        assert viewing.t == comparing.chosen[1].at[0]
    assert seen == comparing.marks
    comparing.go(1)
    assert ends == [1]
    for mark in reversed(comparing.marks[:-1]):
        comparing.go(-1)
        assert comparing.chosen == mark
    comparing.go(-1)
    assert ends == [1, -1]
    # From wherever somebody has put the cursor meanwhile.
    viewing.seek(times[2] - 0.1)
    comparing.go(1)
    assert comparing.chosen == comparing.marks[2]
    parting = comparing.parting()
    assert parting is not None
    assert parting.first != parting.second
    comparing.end()


def test_the_process_beside_finds_what_is_found_at_once(qt: Any) -> None:
    logs = [logged("conversation", script) for script in ("fig5.jsonl", "stopped.jsonl")]
    at_once = compared(logs[0], logs[1])
    beside_ = compared(logs[0], logs[1], at_once=0, command=COMMAND)
    assert at_once.marks == beside_.marks != []
    at_once.end()
    beside_.end()


def test_a_process_that_has_gone_is_no_run_without_differences(qt: Any) -> None:
    log, owner = logged("conversation", "fig5.jsonl"), QObject()
    command = (sys.executable, "-c", "raise SystemExit(3)")
    comparing = Comparing(Viewing(log, owner), owner, at_once=0, command=command)
    comparing.add(Compared("a", log), Compared("b", log))
    failed: list[bool] = []
    comparing.failed.connect(lambda: failed.append(True))
    comparing.failed.connect(comparing.changed)
    until(comparing, lambda: bool(failed))
    assert not comparing.ready
    comparing.end()


def test_a_run_that_nobody_looks_at_is_not_kept_for_the_project_that_was_read_of_it(
    qt: Any,
) -> None:
    owner, loop, late = QObject(), QEventLoop(), QTimer()
    projects = RecordedProjects(owner, (sys.executable, "-c", "raise SystemExit(3)"))
    projects.read.connect(loop.quit)
    late.setSingleShot(True)
    late.timeout.connect(loop.quit)
    run = Recording(Path("a.mcap"), "reception", False, {}, TraceLog())
    assert projects.of(run) is None
    late.start(PATIENCE)
    loop.exec()
    assert late.isActive(), "it was never read"
    kept = weakref.ref(run.log)
    del run
    gc.collect()
    assert kept() is None


def test_runs_are_lined_up_at_the_start_what_both_did_a_bookmark_or_where_they_agreed(
    qt: Any,
) -> None:
    one = logged("reception", "known-user.jsonl", later=3.0)
    # It stood for 100 s with nothing to compare.
    other = TraceLog()
    fields = {"kind": "warning", "seq": 1, "t": 0.0, "cause": None, "message": "", "where": ""}
    other.add([fields])
    _, _, events = played("reception", "second-thoughts.jsonl")
    other.add([{**event, "seq": event["seq"] + 1, "t": event["t"] + 100.0} for event in events])
    marks = (
        (Bookmark(5.0, "door"), Bookmark(6.0, "mine"), Bookmark(7.0, "start")),
        (Bookmark(9.0, "door"), Bookmark(17.0, "start")),
    )
    comparing = compared(one, other, marks)
    assert comparing.way == COMMON
    assert comparing.shifts == [97.0]
    comparing.line_up(START)
    assert comparing.shifts == [-3.0]
    assert comparing.bookmarks() == ["door", "start"]
    comparing.line_up("door")
    assert comparing.shifts == [4.0]
    # Whatever it is called.
    comparing.line_up("start")
    assert comparing.shifts == [10.0]
    comparing.line_up(AGREED)
    comparing.viewing.seek(0.0)
    for _, difference in comparing.marks:
        comparing.go(1)
        assert comparing.shifts == [difference.agreed[1] - difference.agreed[0]]
    assert len({difference.agreed for _, difference in comparing.marks}) > 2
    comparing.end()


def test_what_came_meanwhile_to_a_run_that_goes_on_is_compared_too(qt: Any) -> None:
    _, _, events = played("conversation", "fig5.jsonl")
    whole, grows = logged("conversation", "fig5.jsonl"), TraceLog()
    grows.add(events[:40])
    comparing = compared(grows, whole)
    before = list(comparing.marks)
    assert before
    grows.add(events[40:])
    comparing.go(1)
    until(comparing)
    assert comparing.marks == []
    # Started again, it is another run.
    grows.clear()
    grows.add(events[:40])
    comparing.go(1)
    until(comparing)
    assert comparing.marks == before
    comparing.end()


@pytest.fixture
def beneath(studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path) -> Any:
    """A window that shows a recording, and the file of another."""
    where = project("reception")
    it = studio(where)
    files = []
    for name, script in (("monday", "known-user.jsonl"), ("tuesday", "second-thoughts.jsonl")):
        _, _, events = played("reception", script)
        files.append(recording(tmp_path / f"{name}.mcap", events, where))
    marks = Bookmarks()
    marks.open(beside(files[1]))
    marks.add(2.0, "door")
    it.answers.put("recording", files[0])
    it.window.commands.open_recording()
    until_shown(it)
    it.window.bottom.choose("timeline")
    it.settle()
    return it, files[1]


def test_within_three_clicks_it_is_said_where_two_recordings_part(beneath: Any) -> None:
    it, other = beneath
    robot = it.window.robot
    side, chart = robot.comparing, robot.timeline.chart
    comparing, strip = side.comparing, side.strip
    assert not strip.isVisible()
    assert not it.window.actions_.actions["recording.next_difference"].isEnabled()
    # Compare, With a recording …
    it.answers.put("recording", other)
    opener = next(b for b in robot.timeline.findChildren(QToolButton) if b.menu() is side.menu)
    QTimer.singleShot(0, lambda: QTest.keyClick(side.menu, Qt.Key.Key_Down))
    QTimer.singleShot(0, lambda: QTest.keyClick(side.menu, Qt.Key.Key_Return))
    QTest.mouseClick(opener, LEFT)
    until(comparing)
    it.settle()
    assert strip.isVisible()
    assert "monday.mcap" in strip.runs.text()
    assert "tuesday.mcap" in strip.runs.text()
    # Each row of the other run is right below ours.
    rows = [(row.kind, row.name, row.run) for row in chart.rows if row.kind != "data"]
    assert rows[:2] == [("state", "reception", 0), ("state", "reception", 1)]
    assert {run for *_, run in rows} == {0, 1}
    # What its states are called is read beside the window.
    until(comparing, lambda: comparing.others[0].project is not it.session.project)
    # Its bookmark stands in its own rows.
    assert [mark.name for mark in chart.beside[0].bookmarks] == ["door"]
    # Next difference; all views are there.
    for _ in range(4):
        QTest.mouseClick(strip.next, LEFT)
    it.settle()
    assert robot.follower.viewing.t == 20.0
    assert "of 6" in strip.count.text()
    assert strip.first.text().startswith("A, ")
    assert "nothing of that" in strip.first.text()
    assert "5 verify initials to 3 enter initial 1 by clickNo" in strip.second.text()
    live = it.window.views["reception.rbd.xml"].canvas.look.live
    assert live.active == {"6"}
    # What a row below says is of that run.
    axis, run = chart.axis, chart.beside[0]
    y = next(round(top) for row, top in chart._tops() if row.run == 1 and row.kind == "state") + 8
    at = QPoint(round(axis.x(15.0 - run.shift)) + 132, y)
    assert "enter initial" in chart.told_at(at)
    assert chart.row_at(at) is None
    it.window.commands.next_difference(-1)
    assert robot.follower.viewing.t < 20.0


def test_the_other_run_is_swapped_with_ours_at_the_same_moment_and_let_go_of(beneath: Any) -> None:
    it, other = beneath
    robot = it.window.robot
    side, viewing = robot.comparing, robot.follower.viewing
    comparing = side.comparing
    side.compare_with(other)
    until(comparing)
    for _ in range(4):
        it.window.commands.next_difference(1)
    shift = comparing.shifts[0]
    QTest.mouseClick(side.strip.swap, LEFT)
    until(comparing)
    it.settle()
    assert robot.recording.path == other
    assert viewing.t == 20.0 + shift
    assert comparing.own.name == "tuesday.mcap"
    assert [one.name for one in comparing.others] == ["monday.mcap"]
    assert [mark.name for mark in comparing.own.bookmarks] == ["door"]
    QTest.mouseClick(side.strip.close_, LEFT)
    it.settle()
    assert not side.strip.isVisible()
    assert {row.run for row in robot.timeline.chart.rows} == {0}
    # What was looked at before is offered again.
    side.menu.aboutToShow.emit()
    offered = [action.text() for action in side.menu.actions()]
    assert offered[1] == "With monday.mcap"
    side.menu.actions()[1].trigger()
    until(comparing)
    assert comparing.marks
    it.window.commands.close_recording()
    assert not comparing.goes


def test_a_recording_is_compared_with_the_rehearsal_that_was_looked_at_before(
    beneath: Any,
) -> None:
    it, other = beneath
    window, side = it.window, it.window.robot.comparing
    window.commands.close_recording()
    window.rehearsing.clock = lambda: 0.0
    window.commands.rehearse()
    it.settle()
    side.compare_with(other)
    until(side.comparing)
    it.settle()
    assert [one.name for one in (side.comparing.own, *side.comparing.others)] == [
        "the rehearsal",
        "tuesday.mcap",
    ]
    assert window.docks["bottom"].height() >= window.height() * 2 // 5
    marks = list(side.comparing.marks)
    assert marks
    window.commands.next_difference(1)
    it.settle()
    assert window.docks["bottom"].height() >= window.height() * 2 // 5
    # The other way round.
    it.answers.put("recording", other)
    window.commands.open_recording()
    until_shown(it)
    assert not side.comparing.goes
    side.menu.aboutToShow.emit()
    offered = {action.text(): action for action in side.menu.actions()}
    offered["With the rehearsal"].trigger()
    until(side.comparing)
    assert {turned(one) for _, one in side.comparing.marks} == {one.at for _, one in marks}
    window.commands.close_recording()
    window.commands.end_rehearsal()


def turned(one: Any) -> tuple[float, float]:
    return one.at[1], one.at[0]


def test_three_runs_stand_below_one_another_and_differences_lead_through_all_of_them(
    beneath: Any, tmp_path: Path
) -> None:
    it, other = beneath
    side, chart = it.window.robot.comparing, it.window.robot.timeline.chart
    comparing, viewing = side.comparing, it.window.robot.follower.viewing
    events = played("reception", "walked-away.jsonl")[2]
    third = recording(tmp_path / "wednesday.mcap", events, it.session.root)
    side.compare_with(other)
    until(comparing)
    side.compare_with(third)
    until(comparing, lambda: len(comparing.others) == 2 and comparing.ready)
    it.settle()
    states = [(row.name, row.run) for row in chart.rows if row.kind == "state"]
    assert states == [("reception", 0), ("reception", 1), ("reception", 2)]
    assert "C: wednesday.mcap" in side.strip.runs.text()
    # Ours is compared with each: what parts from either is gone to, in the order of time.
    assert {run for run, _ in comparing.marks} == {0, 1}
    assert {mark.run for mark in chart.differences} == {1, 2}
    # Any of them can be the one that the others are compared with: they trade places.
    names = ["monday.mcap", "tuesday.mcap", "wednesday.mcap"]
    for chosen in (None, 1, 0, 1):
        if chosen is not None:
            viewing.seek(14.0)
            t = viewing.t + comparing.shifts[chosen]
            it.click(side.strip.swap)
            offered = side.strip.shown.actions()
            assert [one.text()[0] for one in offered] == ["B", "C"]
            assert offered[chosen].text().endswith(names[chosen + 1])
            it.click(side.strip.shown, side.strip.shown.actionGeometry(offered[chosen]).center())
            assert viewing.t == t
            until(comparing, lambda: len(comparing.others) == 2 and comparing.ready)
            names[0], names[chosen + 1] = names[chosen + 1], names[0]
        assert [one.name for one in (comparing.own, *comparing.others)] == names
        assert it.window.robot.recording.path.name == names[0]
        log = viewing.log
        parts = sorted(
            (found.at[0], run, found.at[1])
            for run, one in enumerate(comparing.others)
            for found in alike(deeds(log), deeds(one.log)).differences
        )
        assert len(parts) > 6
        viewing.seek(0.0)
        for at, run, theirs in parts:
            it.window.commands.next_difference(1)
            # Ours may have ended before the other did what it did not.
            assert viewing.t == min(at, log.lanes.end)
            assert side.strip.second.text().startswith(f"{LETTERS[run + 1]}, ")
            assert comparing.chosen[1].at == (at, theirs)
    # Another can be added until the letters end; let go of, ours is alone.
    assert side.can_compare()
    QTest.mouseClick(side.strip.close_, LEFT)
    it.settle()
    assert {row.run for row in chart.rows} == {0}


def deeds(log: TraceLog) -> Deeds:
    found = Deeds()
    for event in log:
        found.add(event)
    return found


def test_a_run_beside_that_is_no_recording_can_not_be_shown_by_all_views(qt: Any) -> None:
    one, other = (logged("conversation", name) for name in ("fig5.jsonl", "stopped.jsonl"))
    comparing = Comparing(Viewing(one))
    strip = ComparingStrip(LIGHT, comparing, str)
    asked: list[int] = []
    strip.swap_asked.connect(asked.append)
    own, beside_ = Compared("a", one), Compared("the robot", other)
    comparing.add(own, beside_)
    until(comparing)
    assert not strip.swap.isEnabled()
    assert "none is a recording" in strip.swap.toolTip()
    comparing.add(own, replace(beside_, recording=Recording(Path("b"), "", False, {}, other)))
    until(comparing)
    assert strip.swap.isEnabled()
    QTest.mouseClick(strip.swap, LEFT)
    assert [action.isEnabled() for action in strip.shown.actions()] == [False, True]
    strip.shown.actions()[1].trigger()
    assert asked == [1]
    strip.shown.close()
    comparing.end()
    strip.deleteLater()


def test_runs_are_lined_up_at_a_bookmark_that_was_added_meanwhile(beneath: Any) -> None:
    it, other = beneath
    side = it.window.robot.comparing
    comparing, marks = side.comparing, it.window.robot.timeline.bookmarks
    side.compare_with(other)
    until(comparing)
    assert comparing.bookmarks() == []
    marks.add(5.0, "door")
    side.strip.menu.aboutToShow.emit()
    next(one for one in side.strip.menu.actions() if "door" in one.text()).trigger()
    assert comparing.shifts == [-3.0]


def test_another_run_that_is_opened_is_seen_whole_whatever_was_beside_the_one_before(
    beneath: Any,
) -> None:
    it, other = beneath
    side, chart = it.window.robot.comparing, it.window.robot.timeline.chart
    side.compare_with(other)
    until(side.comparing)
    # Lined up so that it ends long after ours.
    it.window.robot.timeline.bookmarks.add(900.0, "door")
    side.comparing.line_up("door")
    chart.show_all()
    assert chart.axis.end > 900.0
    it.answers.put("recording", other)
    it.window.commands.open_recording()
    until_shown(it)
    start, end = chart.viewing.span
    assert chart.axis.start == start < end < chart.axis.end
    assert chart.axis.seen < 1.1 * (end - start)


def test_no_more_runs_are_offered_than_there_are_letters(beneath: Any) -> None:
    it, other = beneath
    side = it.window.robot.comparing
    side.compare_with(other)
    until(side.comparing)
    side.menu.aboutToShow.emit()
    assert side.menu.actions()[0].isEnabled()
    (one,) = side.comparing.others
    while len(side.comparing.others) + 1 < len(LETTERS):
        side.comparing.add(side.comparing.own, one)
    side.menu.aboutToShow.emit()
    assert not side.menu.actions()[0].isEnabled()
    assert side.menu.actions()[-1].isEnabled()


def test_a_bookmark_of_the_other_run_is_drawn_in_its_own_rows_only(beneath: Any) -> None:
    it, other = beneath
    side, chart = it.window.robot.comparing, it.window.robot.timeline.chart
    side.compare_with(other)
    until(side.comparing)
    it.settle()
    run = chart.beside[0]
    x = round(run.axis.x(2.0)) + GUTTER

    def drawn() -> dict[int, bytes]:
        """What is drawn at its place, by run: the first row of each."""
        image = chart.viewport().grab().toImage()
        tops = {row.run: round(top) for row, top in reversed(chart._tops()) if row.kind == "state"}
        columns = {
            which: [image.pixel(x + across, top + down) for across in (-1, 0, 1) for down in (8, 9)]
            for which, top in tops.items()
        }
        return {which: repr(column).encode() for which, column in columns.items()}

    it.window.robot.follower.viewing.seek(9.0)
    with_it = drawn()
    run.bookmarks = ()
    chart.set_theme(it.window.theme)
    without = drawn()
    assert with_it[0] == without[0]
    assert with_it[1] != without[1]


def test_a_robot_that_goes_on_is_compared_with_a_recording(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    robot: Any,
    request: pytest.FixtureRequest,
    tmp_path: Path,
) -> None:
    wait = request.getfixturevalue("until")
    there = robot(project("reception"))
    it = studio(there.project)
    window, link = it.window, it.window.robot.link
    link.connect_robot(there.endpoint)
    wait(link.moment_changed, lambda: "reception" in link.log.now.applications)
    side, comparing = window.robot.comparing, window.robot.comparing.comparing
    events = played("reception", "known-user.jsonl")[2]
    side.compare_with(recording(tmp_path / "monday.mcap", events, there.project))
    until(comparing)
    assert (comparing.own.name, comparing.own.log) == ("the robot", link.log)
    assert window.robot.follower.viewing.follows
    # The robot stands where it began; the other went on.
    before = list(comparing.marks)
    assert before
    link.publish(window, "noSuchEvent", "reception", lambda why: None)
    wait(link.came, lambda: any(e["kind"] == "event" for e in link.log))
    window.robot.follower.viewing.seek(0.0)
    comparing.go(1)
    until(comparing, lambda: comparing.ready and comparing.chosen is not None)
    assert comparing.parting() is not None
    # The robot's clock goes on meanwhile, and both runs stay in the timeline.
    assert {row.run for row in window.robot.timeline.chart.rows} >= {0, 1}
    window.robot.disconnect_robot()


def test_reading_the_other_run_is_cancelled_or_refused_and_all_stays(
    beneath: Any, tmp_path: Path
) -> None:
    it, other = beneath
    side = it.window.robot.comparing
    side.compare_with(other)
    it.window.status.work.cancel()
    assert not side.comparing.goes
    side.compare_with(tmp_path / "gone.mcap")
    assert "gone.mcap" in it.answers.told[0]
    assert not side.comparing.goes
    assert it.window.status.work.going == []
