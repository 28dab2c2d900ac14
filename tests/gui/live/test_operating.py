"""An operator's hand in the editor, on a real robot: a process of its own, over real sockets."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QToolButton
from tests.gui.test_announcing import hears

from situ.blackboard.client import connect as operator
from situ.blackboard.protocol import LEASE
from situ_studio.live.link import not_asked
from situ_studio.live.setting_dialog import Setting

CONTROL = Qt.KeyboardModifier.ControlModifier


def connect(it: Any, endpoint: str, until: Any) -> Any:
    link = it.window.robot.link
    it.answers.put("robot", endpoint)
    it.window.setFocus()
    it.key(Qt.Key.Key_R, CONTROL)
    until(link.moment_changed, lambda: link.connected and "converse" in link.log.now.applications)
    return link


def button(it: Any, command: str) -> Any:
    found = it.window.toolbar.widgetForAction(it.window.actions_.actions[command])
    assert isinstance(found, QToolButton)
    return found


def kinds(link: Any, kind: str) -> list[Any]:
    return [event for event in link.log if event["kind"] == kind]


def test_breakpoints_pause_the_robot_where_they_are_shown_and_hands_lead_it_on(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    assert not window.actions_.actions["operate.break"].isVisible()
    link = connect(it, there.endpoint, until)

    def now() -> Any:
        return link.log.now.applications["converse"]

    def live() -> Any:
        window.robot.follower.refresh()
        return window.views[window.current_file].canvas.look.live

    def painted(token: str) -> int:
        """Pixels of a colour that the graph shows now."""
        it.settle()
        image = window.current_view.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
        pixel = window.theme.color(token).rgb().to_bytes(4, sys.byteorder)
        return bytes(image.constBits()).count(pixel)

    bare, calm = painted("error"), painted("warning")
    # F9 on a state: it stands on the card, with who did it in the trace, and stops the robot there.
    it.select("state", "3")
    it.key(Qt.Key.Key_F9)
    until(link.moment_changed, lambda: bool(link.log.now.breakpoints))
    assert live().breakpoints == {"3"}
    assert painted("error") > bare
    told = [e for e in kinds(link, "data") if e["tag"] == "debugger.breakpoints"]
    assert told[-1]["writer"].startswith("operator:")
    window.actions_.actions["operate.goto"].trigger()
    until(link.moment_changed, lambda: now().paused)
    assert now().state == "3"
    assert live().paused == {"3"}
    assert painted("warning") > calm
    status = window.operating.waiting
    assert status.isVisible()
    assert status.text() == "converse is paused at 3 glad, at breakpoint 1"
    # Sent elsewhere it stays paused there, goes on by a press, and is stopped by another.
    it.select("state", "2")
    window.actions_.actions["operate.goto"].trigger()
    until(link.moment_changed, lambda: now().state == "2")
    it.settle()
    it.click(button(it, "operate.resume"))
    until(link.moment_changed, lambda: not now().paused)
    assert not status.isVisible()
    it.settle()
    it.click(button(it, "operate.pause"))
    until(link.moment_changed, lambda: now().paused)
    assert status.text() == "converse is paused at 2 sleep"
    # A step with something that waits.
    it.select("state", "2", "event", "0")
    event = it.session.document(window.current_file).state("2").events[0]
    it.answers.put("raising", event.name)
    window.actions_.actions["operate.raise"].trigger()
    until(link.moment_changed, lambda: not it.answers.waiting["raising"])
    it.answers.put("setting", Setting("spo2", 97))
    window.actions_.actions["operate.set"].trigger()
    until(link.moment_changed, lambda: "spo2" in link.log.now.board)
    assert link.log.now.board["spo2"].value == 97
    assert now().state == "2"
    it.settle()
    it.click(button(it, "operate.step"))
    until(link.moment_changed, lambda: now().state == event.next)
    assert now().paused
    assert kinds(link, "event")[-1]["writer"].startswith("operator:")
    # The same key takes the breakpoint away; one on a transition stands where it leaves.
    it.select("state", "3")
    it.key(Qt.Key.Key_F9)
    until(link.moment_changed, lambda: not link.log.now.breakpoints)
    it.select("state", "2", "event", "0")
    it.key(Qt.Key.Key_F9)
    until(link.moment_changed, lambda: bool(link.log.now.breakpoints))
    assert link.log.now.breakpoints[0]["from"] == "2"
    assert link.log.now.breakpoints[0]["to"] == event.next
    assert live().breakpoints == {"2"}
    # Each is listed in words; a click leads there, Delete takes it away.
    panel = window.operating.panel.table
    assert panel.rows.rows[0].cells[1] == "between 2 sleep and 3 glad"
    window.bottom.choose("breakpoints")
    it.settle()
    it.select("state", "5")
    it.click_row(panel, panel.model().index(0, 0))
    assert window.current_view.selected == (("state", "2"),)
    panel.setFocus()
    it.key(Qt.Key.Key_Delete)
    until(link.moment_changed, lambda: not link.log.now.breakpoints)
    assert not it.session.dirty
    # One on a situation stands on the script's graph.
    window.go_to("conversation.spds.xml", ("situation", "sound"))
    it.settle()
    it.key(Qt.Key.Key_F9)
    until(link.moment_changed, lambda: bool(link.log.now.breakpoints))
    assert live().breakpoints == {"sound"}
    window.actions_.actions["operate.clear"].trigger()
    until(link.moment_changed, lambda: not link.log.now.breakpoints)
    assert live().breakpoints == frozenset()
    window.robot.disconnect_robot()
    assert not status.isVisible()


def test_a_pause_and_a_breakpoint_that_stops_are_told_once_each(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    actions, told = it.window.actions_.actions, hears(it)

    def now() -> Any:
        return link.log.now.applications["converse"]

    def pauses() -> list[str]:
        it.settle()
        return [words for one in told for words in one.split(". ") if "paused" in words]

    actions["operate.pause"].trigger()
    until(link.moment_changed, lambda: now().paused)
    first = f"converse is paused at {it.window.robot.state_name('converse', now().state)}"
    assert pauses() == [first]
    # What else comes to be known of a robot that waits is no news of that.
    it.select("state", "3")
    actions["operate.break"].trigger()
    until(link.moment_changed, lambda: bool(link.log.now.breakpoints))
    assert pauses() == [first]
    # Nor is that it goes on, which a hand did.
    actions["operate.resume"].trigger()
    until(link.moment_changed, lambda: not now().paused)
    actions["operate.goto"].trigger()
    until(link.moment_changed, lambda: now().stopped is not None)
    assert pauses() == [first, "converse is paused at 3 glad, at breakpoint 1"]
    it.window.robot.disconnect_robot()
    assert len(pauses()) == 2


def test_what_the_robot_refuses_is_said_in_words(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    connect(it, there.endpoint, until)
    operating, said = it.window.operating, it.window.status.said
    it.answers.put("setting", Setting("situation", 3))
    operating.set_value()
    until(operating.refused, lambda: "situation" in said.text())
    # There is nothing to be judged next.
    operating.pause()
    until(it.window.robot.link.moment_changed, lambda: operating.is_paused)
    it.window.actions_.actions["operate.step"].trigger()
    until(operating.refused, lambda: "paused" not in said.text() and "converse" in said.text())
    it.window.robot.disconnect_robot()


def test_nobody_who_rehearses_pauses_or_leads_the_robot_by_mistake(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    actions = window.actions_.actions
    hands = [actions[name] for name in sorted(actions) if name.startswith("operate.")]
    until(link.moment_changed, lambda: button(it, "operate.pause").isVisible())
    window.rehearsing.clock = lambda: 0.0
    it.key(Qt.Key.Key_F5)
    assert link.connected
    assert not button(it, "operate.pause").isVisible()
    # That a robot is connected is told all the same.
    follower, status = window.robot.follower, window.status.link
    assert status.text() == f"rehearsing, 0.0 s; {link.state.project} is connected"
    it.select("state", "3")
    it.key(Qt.Key.Key_F9)
    assert not [hand.text() for hand in hands if hand.isVisible() or hand.isEnabled()]
    # The robot is as it was, and is led again where it is what is seen.
    actions["rehearse.end"].trigger()
    it.settle()
    assert not kinds(link, "pause")
    assert not link.log.now.breakpoints
    it.click(button(it, "operate.pause"))
    until(link.moment_changed, lambda: link.log.now.applications["converse"].paused)
    # So is that it waits for somebody, while other things are looked at.
    it.key(Qt.Key.Key_F5)
    follower.refresh()
    assert status.text() == f"rehearsing, 0.0 s; converse of {link.state.project} is paused"
    window.robot.disconnect_robot()
    follower.refresh()
    assert status.text() == "rehearsing, 0.0 s"
    actions["rehearse.end"].trigger()


def test_what_a_lost_robot_was_asked_for_is_never_done_by_the_one_that_comes_back(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    window, actions, operating = it.window, it.window.actions_.actions, it.window.operating
    refusals: list[str] = []
    operating.refused.connect(refusals.append)
    operating.pause()
    # What is answered comes after all that was asked before it: the pause is, too.
    answered: list[Any] = []
    link.ask_modules(window, answered.append)
    link.set(window, {"first": 1}, refusals.append)
    until(
        link.moment_changed,
        lambda: operating.is_paused and "first" in link.log.now.board and bool(answered),
    )
    # It is dead, and nobody has noticed: each hand is still there.
    there.kill()
    assert link.connected
    it.select("state", "3")
    actions["operate.goto"].trigger()
    actions["operate.step"].trigger()
    actions["operate.raise"].trigger()
    it.answers.put("setting", Setting("spo2", 97))
    actions["operate.set"].trigger()
    again = robot(there.project, there.endpoint, "another")
    until(operating.refused, lambda: len(refusals) == 4)
    assert all("robot was lost" in said or "connection was lost" in said for said in refusals)
    assert window.status.said.text() == refusals[-1]
    until(link.state_changed, lambda: link.connected)
    until(link.moment_changed, lambda: "converse" in link.log.now.applications)
    # A request that is answered comes after all that were sent before it.
    asked: list[Any] = []
    link.set(window, {"last": 1}, refusals.append)
    link.ask_modules(window, asked.append)
    until(link.moment_changed, lambda: "last" in link.log.now.board and bool(asked))
    assert "spo2" not in link.log.now.board
    assert not [one for one in kinds(link, "transition") if one.get("writer")]
    assert link.log.now.applications["converse"].state == "1"
    assert len(refusals) == 4
    # What a question was about when the robot died is none of the next one's either.
    answer = window.dialogs.setting

    def meanwhile(*asked: Any) -> Any:
        again.kill()
        until(link.state_changed, lambda: not link.connected)
        robot(there.project, there.endpoint, "a third")
        until(link.state_changed, lambda: link.connected)
        return answer(*asked)

    window.dialogs.setting = meanwhile
    it.answers.put("setting", Setting("spo2", 97))
    operating.set_value()
    assert len(refusals) == 5
    assert refusals[-1] == window.status.said.text() == not_asked()
    link.set(window, {"last": 2}, refusals.append)
    until(link.moment_changed, lambda: "last" in link.log.now.board)
    assert "spo2" not in link.log.now.board
    window.robot.disconnect_robot()


def test_a_window_that_stood_still_has_lost_nothing_and_carries_out_what_a_hand_asks_then(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    states: list[str] = []
    refusals: list[str] = []
    link.state_changed.connect(lambda: states.append(link.state.kind))
    it.window.operating.refused.connect(refusals.append)
    it.select("state", "3")

    def gone_to() -> list[str]:
        return [one["to"] for one in kinds(link, "transition") if one.get("writer")]

    # For longer than a module is believed it hears and says nothing, and the robot goes on.
    begun, count = link.clock(), 0
    with operator(there.endpoint, role="operator") as board:
        while link.clock() < begun + 1.5 * LEASE:
            count += 1
            board.set("spo2", count)
    it.window.actions_.actions["operate.goto"].trigger()
    until(link.moment_changed, lambda: gone_to() == ["3"])
    assert link.log.now.board["spo2"].value == count
    assert states == []
    # For so long that nobody believes in it any more: it is taken up again, and done once.
    inner = link._link
    clock = inner.clock
    inner.clock = lambda: clock() + 60.0
    it.select("state", "2")
    it.window.actions_.actions["operate.goto"].trigger()
    until(link.moment_changed, lambda: gone_to() == ["3", "2"])
    until(link.state_changed, lambda: link.connected)
    asked: list[Any] = []
    link.ask_modules(it.window, asked.append)
    until(link.moment_changed, lambda: bool(asked))
    assert gone_to() == ["3", "2"]
    assert refusals == []
    assert [event["seq"] for event in link.log] == list(range(1, len(link.log) + 1))
    it.window.robot.disconnect_robot()


def test_what_was_not_answered_when_a_robot_was_left_is_no_matter_of_the_next_ones(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    refusals: list[str] = []
    it.window.operating.refused.connect(refusals.append)
    there.kill()
    assert link.connected
    it.window.operating.pause()
    it.window.robot.disconnect_robot()
    other = robot(there.project, state="another")
    connect(it, other.endpoint, until)
    other.kill()
    until(link.state_changed, lambda: link.state.kind == "lost")
    it.settle()
    assert refusals == []
    it.window.robot.disconnect_robot()


def test_the_cursor_of_a_lost_robot_stays_where_its_time_had_come_to(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    link = connect(it, there.endpoint, until)
    viewing = it.window.robot.follower.viewing
    # It is quiet for a minute.
    clock = link.clock
    link.clock = lambda: clock() + 59.0
    before = viewing.t
    assert before > link.log.now.t + 58.0
    there.kill()
    until(link.state_changed, lambda: link.state.kind == "lost")
    stood = viewing.t
    assert viewing.follows
    assert stood >= before
    assert viewing.span[1] == stood
    it.settle()
    assert viewing.t == stood
    # Who looks at the past is told that it is lost all the same.
    viewing.seek(before - 1.0)
    words = it.window.status.link.text()
    assert words.startswith("replaying ")
    assert "; robot: lost " in words
    viewing.follow()
    # Nor does it go when nobody looks for the robot any more; the next one's time is its own.
    it.window.robot.disconnect_robot()
    assert viewing.t == stood
    robot(there.project, there.endpoint, "another")
    link.clock = clock
    connect(it, there.endpoint, until)
    assert viewing.t < 58.0
    it.window.robot.disconnect_robot()
