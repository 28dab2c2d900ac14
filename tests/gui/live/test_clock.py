"""What the robot's clock said is known, though no trace tells it: live, recorded and rehearsed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from tests.gui.live.test_link import connect, rows
from tests.gui.live.test_recordings import until_shown
from tests.gui.live.test_why import seen
from tests.rehearse.recorded_robot import Recorded, recorder

from situ.blackboard.client import connect as operator
from situ.decide import inputs
from situ.document.ready import load_ready
from situ.rehearse.clock import Hidden
from situ_studio.live.clock_seen import ClockSeen
from situ_studio.live.log import TraceLog
from situ_studio.rehearsing.course import Course

SHIFT = Qt.KeyboardModifier.ShiftModifier
SECOND = 1_000_000
FLOW = """<application name="app"><state no="1"><expectedevents>
<event name="go" next="2"><when><data tag="clock.time" is="25:00"/></when></event>
</expectedevents></state><state no="2" final="true"/></application>"""


def made(folder: Path) -> Path:
    """A project whose way out waits for a time that never comes."""
    folder.mkdir()
    (folder / "app.rbd.xml").write_text(FLOW)
    (folder / "situ.toml").write_text('[project]\nname = "p"\napplications = ["app.rbd.xml"]\n')
    return folder


def ask(it: Any) -> str:
    it.window.open_file("app.rbd.xml")
    it.select("state", "1", "event", "0")
    it.window.views["app.rbd.xml"].current_view().setFocus()
    it.key(Qt.Key.Key_F7, SHIFT)
    return seen(it)[0]


def test_writes_that_were_seen_stand_in_order_and_once_each() -> None:
    clock = ClockSeen()
    first, second = (Hidden(t, "clock.time", f"08:0{t:.0f}", "situ") for t in (1.0, 2.0))
    gone = Hidden(3.0, "clock.note", None, "ann")
    clock.add([second, gone])
    clock.add([second, first, gone])
    assert clock.until(9.0) == (first, second, gone)
    assert clock.until(1.5) == (first,)
    log = TraceLog()
    log.keep_clock([first, second, gone])
    assert log.now.board["clock.time"].value == "08:02"
    log.clock.put(log.now, 1.0)
    assert log.now.board["clock.time"].value == "08:01"
    log.clock.put(log.now, 0.0)
    assert "clock.time" not in log.now.board


def test_a_running_robot_is_asked_with_its_clock_which_goes_on(
    studio: Callable[..., Any], tmp_path: Path, robot: Any, until: Any
) -> None:
    there = robot(made(tmp_path / "p"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: "clock.time" in link.log.now.board)
    shown = link.log.now.board["clock.time"].value
    with operator(there.endpoint, role="operator") as board:
        board.publish("go")
        until(link.moment_changed, lambda: any(e["kind"] == "ignored" for e in link.log))
        assert f"clock.time is 25:00: it was “{shown}”, set at " in ask(it)
        assert seen(it)[0].endswith((" by situ", " by project"))
        # Whoever sets something there, no trace tells it; and the robot's time does not go back.
        _, end = it.window.robot.follower.viewing.span
        board.set("clock.note", "early")
        until(link.moment_changed, lambda: "clock.note" in link.log.now.board)
        assert it.window.robot.follower.viewing.span[1] >= end
    it.window.robot.follower.refresh()
    table = rows(it.window.robot.blackboard)
    assert table["clock.note"][1] == "early"
    assert table["clock.time"][1] == shown
    it.window.robot.disconnect_robot()


def test_a_recording_tells_the_clock_by_its_inputs_also_where_it_begins_later(
    studio: Callable[..., Any], tmp_path: Path
) -> None:
    folder = made(tmp_path / "p")
    first, second = tmp_path / "first.mcap", tmp_path / "second.mcap"
    run = Recorded(folder, recorder(first, folder))
    run.at(SECOND, inputs.Set({"clock.time": "08:30"}, "situ"))
    later = Recorded(folder, recorder(second, folder), state=run.robot.snapshot())
    for one in (run, later):
        one.at(2 * SECOND, inputs.Raise("go"))
        one.at(3 * SECOND, inputs.Set({"clock.time": "08:31"}, "situ"))
        one.at(4 * SECOND, inputs.Raise("go"))
        one.recorder.close()
    it = studio(folder)
    viewing = it.window.robot.follower.viewing
    for file in (first, second):
        it.window.robot.open_recording(file)
        until_shown(it)
        for t, said in ((2.0, "08:30"), (4.0, "08:31")):
            viewing.seek(t)
            if file == first:
                assert f"clock.time is 25:00: it was “{said}”" in ask(it)
            assert rows(it.window.robot.blackboard)["clock.time"][1] == said
    assert "clock.time" not in viewing.log.at(0.0).board


def test_the_clock_of_a_rehearsal_is_what_was_set() -> None:
    course = Course(load_ready(Path(__file__).parents[3] / "examples" / "conversation"))
    course.give(inputs.Set({"clock.time": "08:30", "spo2": 97}, "scenario"))
    assert course.log.clock.until(9.0) == (Hidden(0.0, "clock.time", "08:30", "scenario"),)
