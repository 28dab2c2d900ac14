"""Breakpoints with conditions, in parts, kept per project: on a real robot."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QSettings, Qt
from tests.gui.live.test_link import connect

from situ.blackboard.client import connect as operator
from situ.document import codec, when_text
from situ.document.condition import Condition, Group
from situ.document.condition import Test as One
from situ.document.export import deployable, without_editor
from situ.document.rbd import Event
from situ.document.ready import load_ready
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.live.breaking import MOST, KeptBreakpoints, everywhere, points_at
from situ_studio.live.breakpoints import Breakpoints
from situ_studio.live.conditions_sought import SoughtConditions
from situ_studio.live.setting_dialog import Setting
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.conditions import GroupBox
from situ_studio.panels.test_box import TestBox

SHIFT = Qt.KeyboardModifier.ShiftModifier
FLOW, PART = "reception.rbd.xml", "register.rbd.xml"

CONDITIONS = (
    Condition((One("a.b", "is", "true"),)),
    Condition((One("word", "is", 'say "<no>" & go'), One("n", "above", "3", within=2.0))),
    Condition((Group("any", (One("a", "exists", "true"), Group("none", (One("b", "is", "1"),)))),)),
)


@pytest.mark.parametrize("condition", CONDITIONS)
def test_a_condition_is_read_as_it_was_written(condition: Condition) -> None:
    assert when_text.read(when_text.write(condition)) == condition


def test_what_is_kept_of_a_project_stands_once_and_only_so_many_projects(tmp_path: Path) -> None:
    settings = QSettings(str(tmp_path / "kept.ini"), QSettings.Format.IniFormat)
    kept = KeptBreakpoints(settings)
    assert kept.of("a") == []
    kept.add("a", {"situation": "s"})
    kept.add("a", {"situation": "s", "when": "<x/>"})
    assert KeptBreakpoints(settings).of("a") == [{"situation": "s", "when": "<x/>"}]
    kept.remove("a", {"situation": "s"})
    assert kept.of("a") == []
    for number in range(MOST + 1):
        kept.add(f"p{number}", {"situation": "s"})
    assert kept.of("p0") == []
    assert kept.of("p1") != []
    settings.setValue("breakpoints", "{")
    assert kept.of("p1") == []


def test_a_place_in_a_part_means_every_state_that_runs_it(project: Callable[[str], Path]) -> None:
    whole = load_ready(project("reception"))
    part = whole.parts[PART]
    assert points_at(whole, PART, part, ("state", "2")) == [
        {"application": "reception", "state": "16/2"}
    ]
    event = part.state("2").events[0]  # type: ignore[union-attr]
    (point,) = points_at(whole, PART, part, ("state", "2", "event", "0"))
    assert (point["from"], point["to"]) == ("16/2", f"16/{event.next}")


def run_twice(where: Path) -> Path:
    """The part runs in another state of the application, too."""
    flow = where / FLOW
    text = flow.read_text()
    state = text[text.index('  <state no="16"') :]
    state = state[: state.index("</state>") + len("</state>\n")]
    flow.write_text(text.replace(state, state + state.replace('no="16"', 'no="17"')))
    return where


def test_a_place_of_a_part_is_the_same_in_every_state_that_runs_it(
    project: Callable[[str], Path],
) -> None:
    whole = load_ready(run_twice(project("reception")))
    at = {"application": "reception", "from": "16/2", "to": "16/3"}
    beside = {"application": "reception", "from": "17/2", "to": "17/3"}
    assert everywhere(whole, at) == everywhere(whole, beside) == [at, beside]
    own = {"application": "reception", "state": "3"}
    assert everywhere(whole, own) == [own]
    assert everywhere(whole, {"situation": "quiet"}) == [{"situation": "quiet"}]
    gone = {"application": "reception", "state": "99/2"}
    assert everywhere(whole, gone) == [gone]


def field_of_the_condition(it: Any, until: Any) -> Any:
    """Once it can be written: a robot that a slow machine has lost meanwhile is found again."""
    window, editor = it.window, it.window.operating.panel.condition
    it.settle()

    def shown() -> bool:
        found = [box for box in editor.findChildren(TestBox) if box.tag.isVisible()]
        return window.robot.link.connected and bool(found)

    until(window.robot.link.state_changed, shown)
    return editor.box(0).tag


def test_a_condition_in_a_part_is_that_of_its_place_in_every_state_that_runs_it(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(run_twice(project("reception")))
    it = studio(there.project)
    window, link = it.window, it.window.robot.link
    link.connect_robot(there.endpoint)
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    window.open_file(PART)
    it.select("state", "3")
    # Of a machine that was slow to open the file the robot may have thought that it is gone.
    until(link.state_changed, lambda: link.connected)
    it.key(Qt.Key.Key_F9)
    until(link.moment_changed, lambda: len(link.log.now.breakpoints) == 2)
    it.select("state", "2")
    it.key(Qt.Key.Key_F9, SHIFT)

    def standing() -> dict[str, str | None]:
        return {one["state"]: one.get("when") for one in link.log.now.breakpoints}

    def both(when: str) -> dict[str, str | None]:
        return {"16/2": when, "17/2": when, "16/3": None, "17/3": None}

    until(link.moment_changed, lambda: standing().get("17/2") is not None)
    when = standing()["17/2"]
    assert when is not None
    until(link.moment_changed, lambda: standing() == both(when))
    it.fill(field_of_the_condition(it, until), "robot.stop")
    when = '<data tag="robot.stop" exists="true"/>'
    until(link.moment_changed, lambda: standing() == both(when))
    until(link.moment_changed, lambda: len(link.log.now.breakpoints) == 4)
    window.robot.disconnect_robot()


def test_a_breakpoint_with_a_condition_pauses_only_while_it_holds_and_is_kept(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("reception"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    window.open_file(PART)
    it.select("state", "2")
    # Of a machine that was slow to open the file the robot may have thought that it is gone.
    until(link.state_changed, lambda: link.connected)
    it.key(Qt.Key.Key_F9, SHIFT)
    until(link.moment_changed, lambda: any(b.get("when") for b in link.log.now.breakpoints))
    until(link.moment_changed, lambda: len(link.log.now.breakpoints) == 1)
    panel = window.operating.panel
    assert panel.isVisible()
    (standing,) = link.log.now.breakpoints
    assert standing["state"] == "16/2"
    # It is shown on the part's own card, and on the one that runs it.
    window.robot.follower.refresh()
    assert window.views[PART].canvas.look.live.breakpoints == {"2"}
    window.open_file(FLOW)
    window.robot.follower.refresh()
    assert window.views[FLOW].canvas.look.live.breakpoints == {"16"}
    # The condition is edited as a guard is.
    it.fill(field_of_the_condition(it, until), "robot.stop")
    until(
        link.moment_changed,
        lambda: (
            [b["when"] for b in link.log.now.breakpoints]
            == ['<data tag="robot.stop" exists="true"/>']
        ),
    )
    it.settle()
    assert panel.table.rows.rows[0].cells[1].endswith("while robot.stop exists")
    now = link.log.now.applications["reception"]

    def go() -> None:
        window.open_file(PART)
        it.select("state", "2")
        window.actions_.actions["operate.goto"].trigger()

    go()
    until(link.moment_changed, lambda: now.state == "16/2")
    assert not now.paused
    it.answers.put("setting", Setting("robot.stop", False))
    window.actions_.actions["operate.set"].trigger()
    until(link.moment_changed, lambda: "robot.stop" in link.log.now.board)
    go()
    until(link.moment_changed, lambda: now.paused)
    assert window.operating.waiting.text().startswith("reception is paused at 16/2 last name")
    window.robot.follower.refresh()
    assert window.views[PART].canvas.look.live.paused == {"2"}
    # What can not be judged at a moment is not offered.
    it.settle()
    assert panel.condition.box(0).within.isVisible()
    assert not panel.condition.box(0).hold.isVisible()
    window.robot.disconnect_robot()
    # Another robot has none: those of this project are offered, and nothing is set unasked.
    there.stop()
    other = robot(there.project, state="other")
    connect(it, other.endpoint, until)
    until(link.moment_changed, lambda: "reception" in link.log.now.applications)
    window.bottom.choose("breakpoints")
    it.settle()
    assert link.log.now.breakpoints == ()
    assert panel.table.rows.rows[0].cells[3] == "not on this robot"
    it.click(panel.again)
    until(link.moment_changed, lambda: bool(link.log.now.breakpoints))
    it.settle()
    assert link.log.now.breakpoints[0]["when"] == '<data tag="robot.stop" exists="true"/>'
    assert not panel.again.isVisible()
    # Taken away, it is not offered again.
    panel.table.setFocus()
    panel.table.setCurrentIndex(panel.table.rows.index(0, 0))
    it.key(Qt.Key.Key_Delete)
    until(link.moment_changed, lambda: not link.log.now.breakpoints)
    it.settle()
    assert panel.table.rows.rows == []
    window.robot.disconnect_robot()


def test_of_conditions_given_faster_than_the_robot_answers_the_last_one_stands_alone(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: "converse" in link.log.now.applications)
    it.select("state", "5")
    it.key(Qt.Key.Key_F9, SHIFT)
    until(link.moment_changed, lambda: any(b.get("when") for b in link.log.now.breakpoints))
    until(link.moment_changed, lambda: len(link.log.now.breakpoints) == 1)
    it.settle()
    panel = window.operating.panel
    it.fill(panel.condition.box(0).tag, "face.direction")
    # By keys, each of which is another condition; what was typed stands, whatever the robot tells.
    it.choose(panel.condition.box(0).test, "above")
    it.fill(panel.condition.box(0).value, "20")
    it.choose(panel.condition.box(0).test, "below")
    it.fill(panel.condition.box(0).value, "-20")
    when = '<data tag="face.direction" below="-20"/>'

    def stand() -> list[str | None]:
        return [one.get("when") for one in link.log.now.breakpoints]

    until(link.moment_changed, lambda: stand() == [when])
    # Nothing else was on its way: what is asked next is answered after all that was.
    answered: list[Any] = []
    link.ask_modules(window, answered.append)
    until(link.moment_changed, lambda: bool(answered))
    assert stand() == [when]
    assert panel.condition.box(0).value.text() == "-20"
    window.robot.disconnect_robot()


def test_a_condition_goes_to_the_robot_when_the_one_before_stands_and_only_the_last() -> None:
    asked: list[tuple[int, Condition | None]] = []

    def exchange(one: dict[str, Any], condition: Condition | None) -> set[int]:
        asked.append((one["id"], condition))
        return {one["id"]}

    def standing(number: int, condition: Condition | None) -> dict[str, Any]:
        made = {"id": number, "situation": "quiet"}
        return made if condition is None else {**made, "when": when_text.write(condition)}

    sought, first = SoughtConditions(), standing(1, None)
    for condition in CONDITIONS:
        sought.want(first, condition, exchange)
        assert sought.of(first) == condition
    assert asked == [(1, CONDITIONS[0])]
    both = [first, standing(2, CONDITIONS[0])]
    sought.told(both, exchange)
    assert asked == [(1, CONDITIONS[0])]
    sought.told(both[1:], exchange)
    assert asked[1:] == [(2, CONDITIONS[2])]
    assert sought.of(both[1]) == CONDITIONS[2]
    last = standing(3, CONDITIONS[2])
    sought.told([last], exchange)
    assert len(asked) == 2
    # Another operator's is shown as it stands, and so is what a refusal or an end leaves.
    other = standing(4, CONDITIONS[0])
    assert sought.of(other) == CONDITIONS[0]
    sought.want(last, None, exchange)
    sought.forget()
    assert sought.of(last) == CONDITIONS[2]
    sought.want(last, None, exchange)
    sought.told([], exchange)
    assert sought.of(last) == CONDITIONS[2]
    assert len(asked) == 4


def test_a_condition_wanted_where_the_robot_refused_a_breakpoint_is_wanted_no_longer(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    until(link.moment_changed, lambda: "converse" in link.log.now.applications)
    file = window.current_file
    flow = it.session.document(file)
    new = replace(flow.states[1], no="77", events=(Event("back", next="1"),), screen=None)
    leads = replace(flow.states[1], events=(*flow.states[1].events, Event("on", next="77")))
    states = (flow.states[0], leads, *flow.states[2:], new)
    it.session.commit(file, replace(flow, states=states), "Add a state")
    it.settle()
    it.select("state", "77")
    it.key(Qt.Key.Key_F9, SHIFT)
    until(window.operating.refused, lambda: "77" in window.status.said.text())
    # Once the robot has the state, it may be set there as anywhere.
    files = deployable(load_ready(there.project))
    files[file] = codec.write(without_editor(it.session.document(file)))
    with operator(there.endpoint, role="operator") as board:
        board.deploy(files, "situ.toml", force_after=0)
    until(link.came, lambda: any(e["kind"] == "deployed" for e in link.log))
    it.select("state", "77")
    it.key(Qt.Key.Key_F9)
    until(link.moment_changed, lambda: len(link.log.now.breakpoints) == 1)
    it.settle()
    it.select("state", "2")
    it.key(Qt.Key.Key_F9)
    until(link.moment_changed, lambda: any(b["state"] == "2" for b in link.log.now.breakpoints))
    found = {one["state"]: one.get("when") for one in link.log.now.breakpoints}
    assert found == {"77": None, "2": None}
    window.robot.disconnect_robot()


def test_a_group_begun_for_one_breakpoint_is_not_the_next_ones(qt: Any) -> None:
    panel = Breakpoints(LIGHT, lambda application, state: state)
    every = [{"id": 1, "situation": "quiet"}, {"id": 2, "situation": "loud"}]
    panel.show_breakpoints(every, frozenset(), (), Vocabulary())
    panel.table.setCurrentIndex(panel.table.rows.index(0, 0))
    panel.condition.add("any")
    assert panel.condition.findChildren(GroupBox)
    assert panel.condition.isVisibleTo(panel)
    panel.table.setCurrentIndex(panel.table.rows.index(1, 0))
    assert not panel.condition.isVisibleTo(panel)
    panel.table.setCurrentIndex(panel.table.rows.index(0, 0))
    assert not panel.condition.isVisibleTo(panel)
    panel.deleteLater()


def test_a_group_goes_with_the_breakpoint_for_which_it_was_begun(qt: Any) -> None:
    panel = Breakpoints(LIGHT, lambda application, state: state)
    quiet, loud = {"id": 1, "situation": "quiet"}, {"id": 2, "situation": "loud"}
    panel.show_breakpoints([quiet, loud], frozenset(), (), Vocabulary())
    panel.table.setCurrentIndex(panel.table.rows.index(0, 0))
    panel.condition.add("any")
    # What else the robot tells leaves it, also where the breakpoint gets another number.
    third = {"id": 3, "situation": "third"}
    again = {"id": 4, "situation": "quiet"}
    panel.show_breakpoints([third, loud, again], frozenset(), (), Vocabulary())
    assert panel.condition.findChildren(GroupBox)
    assert panel.condition.isVisibleTo(panel)
    # Another operator takes it away, and sets one there anew.
    panel.show_breakpoints([third, loud], frozenset(), (), Vocabulary())
    assert not panel.condition.isVisibleTo(panel)
    panel.show_breakpoints([third, loud, {**again, "id": 5}], frozenset(), (), Vocabulary())
    assert panel.current == {**again, "id": 5}
    assert not panel.condition.isVisibleTo(panel)
    panel.deleteLater()
