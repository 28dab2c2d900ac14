"""Why? and Why not? of what is on the screen of the robot that is rehearsed."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt
from tests.gui.live.test_why import Clicks, seen

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
