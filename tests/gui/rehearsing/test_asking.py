"""Why? and Why not? of what is on the screen of the robot that is rehearsed."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt
from tests.gui.live.test_why import Clicks, seen
from tests.gui.rehearsing.test_taking import edit

from situ.decide import inputs

SHIFT = Qt.KeyboardModifier.ShiftModifier


def test_of_a_button_of_the_rehearsed_robot_within_three_clicks(desk: Any) -> None:
    used = desk("conversation")
    it, window = used.studio, used.window
    screen = used.desk.screen_
    yes = screen.place_of(next(t for t in screen.targets if t.words == "YES")).toPoint()
    hand = Clicks(it)
    hand.menu(screen, yes)
    words = "Why does converse not leave 1 hello by clickYes?"
    assert [a.text() for a in window.why.menus.shown.actions()] == ["Why?", "", words]
    hand.choose(window.why.menus.shown, words)
    assert hand.count == 2
    assert window.why.panel.title.text() == words
    # Touched, it did something: the question beside it is what.
    used.touch("YES")
    assert used.state == "2"
    hand = Clicks(it)
    hand.menu(screen, screen.rect().bottomLeft())
    hand.choose(window.why.menus.shown, "Why?")
    assert hand.count == 2
    assert seen(it)[-1] == "converse enters 2 sleep"
    # By keys: where the arrows are.
    screen.setFocus()
    it.key(Qt.Key.Key_Down)
    assert screen.current is not None
    it.key(Qt.Key.Key_F7, SHIFT)
    assert window.why.panel.title.text().startswith("Why does converse not")
    screen.setFocus()
    it.key(Qt.Key.Key_F7)
    assert seen(it)


def test_while_an_edit_is_not_taken_in_what_runs_is_asked(desk: Any) -> None:
    used = desk("conversation")
    it, window = used.studio, used.window
    side, menus = window.why, window.why.menus
    used.side.running.give(inputs.Set({"spo2": 97}, "scenario"))
    # The robot runs what was drawn before: its states are called as they were then.
    state = it.session.document("converse.rbd.xml").states[0]
    edit(used, 0, name="welcome", events=())
    hand = Clicks(it)
    hand.menu(used.desk.screen_, used.desk.screen_.rect().bottomLeft())
    hand.choose(menus.shown, "Why?")
    assert seen(it)[-1] == "converse enters 1 hello (the start)"
    yes = next(t for t in used.desk.screen_.targets if t.words == "YES")
    hand.menu(used.desk.screen_, used.desk.screen_.place_of(yes).toPoint())
    words = "Why does converse not leave 1 hello by clickYes?"
    hand.choose(menus.shown, words)
    assert side.panel.title.text() == words
    assert side.panel.links
    # What was done at the desk, who sits there did.
    window.bottom.choose("blackboard")
    it.settle()
    hand.row_menu(window.robot.blackboard, "spo2")
    hand.choose(menus.shown, "Why?")
    assert seen(it) == ["you set spo2 to 97 (from outside)"]
    # Taken in, it is what is asked.
    edit(used, 0, events=state.events)
    used.side.take_in()
    used.side.hurry()
    it.settle()
    assert side.project == used.side.running.course.project
    hand.menu(used.desk.screen_, used.desk.screen_.rect().bottomLeft())
    hand.choose(menus.shown, "Why?")
    assert seen(it)[-1].startswith("converse enters 1 welcome")
    # Of before that, what ran before.
    turned = side._viewing.log.lanes.deployed[-1].t
    assert [
        side.project_at(t).applications["converse.rbd.xml"].states[0].name
        for t in (turned - 0.001, turned)
    ] == ["hello", "welcome"]
