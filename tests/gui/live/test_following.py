"""What the drawings show of a robot: where it is, in parts too, how often; and follow mode."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAccessible, QImage
from PySide6.QtTest import QSignalSpy, QTest
from tests.gui.live.test_log import played
from tests.gui.live.test_recordings import opened

from situ.document.project import Project
from situ_studio.canvas import counted
from situ_studio.canvas.live import LiveView
from situ_studio.live import follower
from situ_studio.live.log import TraceLog
from situ_studio.live.views import live_part, live_view, runs_of
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.table import Row, RowsTable

NAME, DESCRIPTION = QAccessible.Text.Name, QAccessible.Text.Description
PART = "register.rbd.xml"


def logged(name: str, script: str) -> tuple[Project, TraceLog, list[dict[str, Any]]]:
    project, _, events = played(name, script)
    log = TraceLog()
    log.add(events)
    return project, log, events


def test_a_parts_own_graph_shows_what_runs_in_it() -> None:
    project, log, events = logged("reception", "new-user.jsonl")
    part, runs = project.parts[PART], runs_of(project)
    ((name, before),) = runs[PART]
    assert (name, before) == ("reception", "16/")
    glowed: set[str] = set()
    for t in sorted({event["t"] for event in events}):
        now = log.at(t)
        view = live_part(part, now, runs[PART], t)
        came = [e for e in events if e["t"] <= t and e["kind"] == "enter"]
        mine = [e["state"].removeprefix(before) for e in came if e["state"].startswith(before)]
        assert view.counts == Counter(mine)
        inside = came[-1]["state"].startswith(before)
        assert view.active == ({mine[-1]} if inside else set())
        glowed |= view.active
        assert {way.state for way in view.taken} <= {state.no for state in part.states}
        assert sum(view.transitions.values()) <= sum(view.counts.values())
    assert len(glowed) > 2


def test_a_state_that_runs_a_part_lasts_as_long_as_the_part() -> None:
    project, log, events = logged("reception", "new-user.jsonl")
    (begun,) = [e["t"] for e in events if e["kind"] == "enter" and e["state"] == "16"]
    (left,) = [e["t"] for e in events if e["kind"] == "exit" and e["state"] == "16"]
    (file,) = project.applications
    moment = log.at(left - 0.01).applications["reception"]
    view = live_view(project.applications[file], moment, left - 0.01)
    assert view.active == {"16"}
    assert view.entered["16"] == left - 0.01 - begun
    after = live_view(project.applications[file], log.now.applications["reception"], log.now.t)
    assert after.times["16"] == left - begun


def test_how_often_the_time_ran_out_counts_for_each_state() -> None:
    project, log, events = logged("reception", "nobody-answers.jsonl")
    (file,) = project.applications
    view = live_view(project.applications[file], log.now.applications["reception"], log.now.t)
    over = [e["from"] for e in events if e["kind"] == "transition" and e.get("timeout")]
    assert over
    assert view.gave_up == Counter(over)


def test_the_drawing_moves_along_until_that_is_switched_off(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, events = opened(studio, project("reception"), file, "reception", "new-user.jsonl")
    window = it.window
    viewing, canvas = window.robot.follower.viewing, window.current_view.canvas
    canvas.set_zoom(1.0)
    entered = {e["state"]: e["t"] for e in events if e["kind"] == "enter"}

    def seen(no: str) -> bool:
        it.settle()
        uid, _ = canvas._find(("state", no))
        return bool(canvas.viewer.seen().contains(canvas.card_area(uid)))

    for no in ("11", "2", "16"):
        viewing.seek(entered[no])
        assert seen(no)
    # Who looks elsewhere while it stays there is left alone.
    canvas.bring_into_view([("state", "2")])
    viewing.seek(entered["16"] + 0.01)
    assert seen("2")
    assert not seen("16")
    # What is known of a state is read where the hand rests on its card.
    hint = canvas.graph.nodes[canvas._find(("state", "16"))[0]].view.toolTip()
    assert "The robot is here, since 0 s." in hint
    assert "It came here 1×." in hint
    # And heard, as it is now.
    root = QAccessible.queryAccessibleInterface(canvas.viewer)
    heard = {root.child(n).text(NAME): root.child(n) for n in range(root.childCount())}
    register = next(one for name, one in heard.items() if "register" in name)
    assert "The robot is here, since 0 s." in register.text(DESCRIPTION)
    # Its own graph shows where in the part it is.
    window.open_file(PART)
    viewing.seek(entered["16/2"])
    it.settle()
    assert window.current_view.canvas.look.live.active == {"2"}
    assert "The robot is here" in register.text(DESCRIPTION)
    viewing.seek(entered["11"])
    assert "The robot is here" not in register.text(DESCRIPTION)
    window.open_file(window.session.files[0])
    button = window.toolbar.widgetForAction(window.actions_.actions["follow"])
    assert button.isChecked()
    it.click(button)
    assert not button.isChecked()
    canvas.bring_into_view([("state", "2")])
    viewing.seek(entered["11"])
    assert seen("2")
    assert not seen("11")
    it.click(button)
    viewing.seek(entered["10"])
    viewing.seek(entered["11"])
    assert seen("11")


def test_a_drawing_that_was_hidden_while_the_robot_went_shows_where_it_is(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, events = opened(studio, project("reception"), file, "reception", "new-user.jsonl")
    window = it.window
    flow, viewing = window.current_file, window.robot.follower.viewing
    canvas = window.current_view.canvas
    canvas.set_zoom(1.0)
    entered = {e["state"]: e["t"] for e in events if e["kind"] == "enter"}

    def sees(no: str) -> bool:
        it.settle()
        uid, _ = canvas._find(("state", no))
        return bool(canvas.viewer.seen().contains(canvas.card_area(uid)))

    viewing.seek(entered["2"])
    assert sees("2")
    # Another tab, and the same one as a table.
    window.open_file(PART)
    it.settle()
    viewing.seek(entered["11"])
    assert not sees("11")
    window.open_file(flow)
    assert sees("11")
    window.show_mode("outline")
    it.settle()
    viewing.seek(entered["16"])
    window.show_mode("graph")
    assert sees("16")
    # Who has looked elsewhere since is left alone, also in a tab that is chosen again.
    canvas.bring_into_view([("state", "2")])
    window.open_file(PART)
    it.settle()
    window.open_file(flow)
    assert sees("2")
    assert not sees("16")
    # Nor is it moved while that is not wanted; wanted again, it is at once.
    button = window.toolbar.widgetForAction(window.actions_.actions["follow"])
    window.open_file(PART)
    it.settle()
    viewing.seek(entered["11"])
    it.click(button)
    window.open_file(flow)
    assert sees("2")
    assert not sees("11")
    it.click(button)
    assert sees("11")


def test_what_came_before_a_hand_moved_the_cursor_is_drawn_with_it_and_not_once_more(
    studio: Callable[..., Any],
    project: Callable[[str], Path],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Else each frame of a scrub is drawn twice while events come."""
    # A frame is over as soon as the loop turns.
    monkeypatch.setattr(follower, "FRAME", 0)
    file = tmp_path / "run.mcap"
    it, _ = opened(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    robot = it.window.robot
    drawn = QSignalSpy(robot.follower.refreshed)
    robot.link.moment_changed.emit()
    robot.follower.viewing.seek(3.0)
    it.settle()
    assert drawn.count() == 1
    robot.link.moment_changed.emit()
    it.settle()
    assert drawn.count() == 2
    it.window.commands.close_recording()


def test_how_long_the_robot_is_in_a_state_is_told_as_how_long_it_was_in_others() -> None:
    view = LiveView(active=frozenset({"1"}), entered={"1": 2706.14}, times={"2": 2706.14})
    assert counted.told(view, "1") == "The robot is here, since 45.1 min."
    assert counted.told(view, "2") == "It was here for 45.1 min in all."


def test_a_card_says_that_its_application_is_suspended(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, events = opened(studio, project("conversation"), file, "conversation", "stopped.jsonl")
    window = it.window
    viewing, view = window.robot.follower.viewing, window.current_view
    begins = next(e for e in events if e["kind"] == "suspend")["t"]

    def painted() -> int:
        """Pixels of the colour that calls for attention."""
        it.settle()
        image = view.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
        pixel = window.theme.color("warning").rgb().to_bytes(4, sys.byteorder)
        return bytes(image.constBits()).count(pixel)

    def hint() -> str:
        (no,) = view.canvas.look.live.active
        uid, _ = view.canvas._find(("state", no))
        return str(view.canvas.graph.nodes[uid].view.toolTip())

    viewing.seek(begins - 0.01)
    calm = painted()
    assert "suspended" not in hint()
    viewing.seek(begins)
    assert painted() > calm
    assert "It is suspended: it does not hold what this state uses." in hint()
    viewing.seek(next(e for e in events if e["kind"] == "resume")["t"])
    assert painted() == calm
    assert "suspended" not in hint()


def test_of_two_drawings_of_one_application_both_move_along(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, events = opened(studio, project("reception"), file, "reception", "new-user.jsonl")
    window = it.window
    it.key(Qt.Key.Key_Backslash, Qt.KeyboardModifier.ControlModifier)
    it.settle()
    canvases = [group.current_view.canvas for group in window.sides.groups]
    assert len(canvases) == 2
    for canvas in canvases:
        canvas.set_zoom(1.0)
    entered = {e["state"]: e["t"] for e in events if e["kind"] == "enter"}
    for no in ("11", "2", "16"):
        window.robot.follower.viewing.seek(entered[no])
        it.settle()
        for canvas in canvases:
            uid, _ = canvas._find(("state", no))
            assert canvas.viewer.seen().contains(canvas.card_area(uid)), no


def test_a_row_that_is_pressed_twice_is_chosen_once(qt: Any) -> None:
    table = RowsTable("Things", ("Thing",), (), LIGHT)
    told: list[str] = []
    table.when_chosen(told.append)
    table.rows.show([Row("a", ("A",)), Row("b", ("B",))])
    table.resize(QSize(200, 120))
    table.show()
    at = table.visualRect(table.rows.index(1, 0)).center()
    QTest.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=at)
    QTest.mouseDClick(table.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert told == ["b"]
    QTest.keyClick(table, Qt.Key.Key_Return)
    assert told == ["b", "b"]
    table.close()
    table.deleteLater()


def test_the_current_situation_is_heard(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    file = tmp_path / "run.mcap"
    it, events = opened(studio, project("conversation"), file, "conversation", "fig5.jsonl")
    window = it.window
    window.open_file("conversation.spds.xml")
    canvas = window.current_view.canvas
    root = QAccessible.queryAccessibleInterface(canvas.viewer)
    parts = [root.child(n) for n in range(root.childCount())]
    then = next(e for e in events if e["kind"] == "situation" and e["to"] == "invited")
    window.robot.follower.viewing.seek(then["t"])
    told = [one.text(NAME) for one in parts if "current situation" in one.text(DESCRIPTION)]
    assert len(told) == 1
    assert "invited" in told[0]
