"""The steps of docs/tutorial.md and docs/tutorial.ja.md, one function each, by mouse and keys.

A step's docstring is its heading. ``STEPS`` are all of them, in their order. What is pressed and
typed stands here in English; a Japanese pupil does the same in Japanese.
"""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLineEdit
from tests.gui.test_newcomer import CONTROL
from tests.gui.tutorial.pupil import Pupil

SHIFT = Qt.KeyboardModifier.ShiftModifier

TRANSLATED = (
    "Repeat",
    "Blood pressure",
    "START",
    "Put the cuff on your left arm, please. Then touch start.",
    "Hold still, please.",
    "STOP",
    "I am measuring. Please hold still.",
    "{bp.systolic} over {bp.diastolic}",
    "DONE",
    "Your blood pressure is {bp.systolic} over {bp.diastolic}. That is good.",
    "Please stay seated. Your nurse looks at it with you.",
)
"""In the order of the table; a text that stands in several places is translated once."""
AGAIN = 10
"""After so many rows come two whose texts have been translated above."""


def new_project(me: Pupil) -> None:
    """Begin a project"""
    me.look("welcome")
    me.answer("Blood pressure")
    me.click("New project")


def first_state(me: Pupil) -> None:
    """The first state"""
    me.click_card("1 start")
    me.write_into("Name", "ready")
    me.click("It may end here")
    me.click("Speech Hello")
    me.write_over("Says", "Put the cuff on your left arm, please. Then touch start.")
    me.click_card("1 ready")
    me.press("Button")
    me.type("START")
    me.look("first-state")


def screen(me: Pupil) -> None:
    """Its screen"""
    me.click_card("1 ready")
    me.press("Screen")
    me.twice(me.on_sheet(50, 35))
    me.key(Qt.Key.Key_A, CONTROL)
    me.type("Blood pressure")
    me.look("screen")
    me.press("Graph")


def measuring(me: Pupil) -> None:
    """A state that follows"""
    me.follow("1 ready", QPoint(80, 30), "measuring")
    me.press("Text")
    me.type("Hold still, please.", Qt.Key.Key_Tab)
    me.press("Button")
    me.type("STOP")
    me.press("Speech")
    me.type("I am measuring. Please hold still.", Qt.Key.Key_Tab)
    me.look("second-state")


def ask_the_cuff(me: Pupil) -> None:
    """Ask the cuff"""
    me.press("Service")
    me.type("measure", Qt.Key.Key_Tab)
    me.key(Qt.Key.Key_A, CONTROL)
    me.type("board:cuff/measure", Qt.Key.Key_Tab)
    me.click("Add a value")
    me.type("arm", Qt.Key.Key_Tab)
    me.type("left", Qt.Key.Key_Tab)
    for tag, part in (("bp.systolic", "systolic"), ("bp.diastolic", "diastolic")):
        me.click("Add a result")
        me.type(tag, Qt.Key.Key_Tab)
        me.type(part, Qt.Key.Key_Tab)
    me.write_into("When done", "measured")
    me.write_into("If it fails", "notMeasured")
    me.look("service")


def ways(me: Pupil) -> None:
    """Where it leads"""
    me.drag_new("2 measuring", "1 ready")
    me.follow("2 measuring", QPoint(30, -140), "as usual")
    me.drag_new("2 measuring", "1 ready")
    me.follow("2 measuring", QPoint(30, 100), "call the nurse")
    me.click_card("2 measuring")
    me.click("event4 4 call the nurse")
    me.write_into("Event", "measured")
    me.look("ways")


def limit(me: Pupil) -> None:
    """A limit"""
    me.click_card("2 measuring")
    me.click("measured 3 as usual")
    me.menu("Add a test", "A test")
    me.type("bp.systolic", Qt.Key.Key_Tab)
    me.pick("Test", "at most")
    me.write_into("Value", "140")
    me.look("limit")


def answers(me: Pupil) -> None:
    """What the robot answers"""
    _answer(
        me,
        "3 as usual",
        "Your blood pressure is {bp.systolic} over {bp.diastolic}. That is good.",
    )
    me.look("answer")
    _answer(me, "4 call the nurse", "Please stay seated. Your nurse looks at it with you.")


def _answer(me: Pupil, card: str, said: str) -> None:
    me.click_card(card)
    me.press("Text")
    me.type("{bp.systolic} over {bp.diastolic}", Qt.Key.Key_Tab)
    me.press("Button")
    me.type("DONE")
    me.press("Speech")
    me.type(said, Qt.Key.Key_Tab)
    me.drag_new(card, "1 ready")
    _back_after(me, "60")


def _back_after(me: Pupil, seconds: str) -> None:
    me.press("Timeout")
    me.type(seconds)
    me.pick("The timeout leads to", "1 ready")


def nobody_there(me: Pupil) -> None:
    """Nobody is there, or has not understood"""
    me.click_card("2 measuring")
    _back_after(me, "90")
    me.click_card("1 ready")
    me.click("Add a Repeat button to every state")
    me.look("all-states")


def stop(me: Pupil) -> None:
    """What stops the robot"""
    me.run("Script of situations")
    me.press("Data")
    me.type("robot.stop")
    me.pull_to_ground("robot.stop", "otherwise", "stopped")
    me.press("Module")
    me.type("cuff")
    me.click("Resources", QLineEdit)
    me.key(Qt.Key.Key_A, CONTROL)
    me.key(Qt.Key.Key_Delete)
    me.key(Qt.Key.Key_Return)
    me.look("script")


def another_language(me: Pupil) -> None:
    """In Japanese too"""
    me.open_in_tree("texts")
    me.answer(me.other)
    me.click("Add a language…")
    me.key(Qt.Key.Key_Right)
    for row, text in enumerate(TRANSLATED):
        if row == AGAIN:
            me.key(Qt.Key.Key_Down)
            me.key(Qt.Key.Key_Down)
        me.written.append(me.here(text))
        me.key(Qt.Key.Key_Return)
        me.compose(me.there(text))
    me.look("texts")
    me.key(Qt.Key.Key_S, CONTROL)


def rehearse(me: Pupil) -> None:
    """Try it"""
    me.open_in_tree("blood-pressure", 1)
    me.click("Rehearse")
    me.wait(6)
    me.touch("START")
    me.wait(4)
    me.look("rehearsal")
    me.write_into("What Service measure answers", '{"systolic": 152, "diastolic": 95}')
    me.wait(2)
    me.look("nurse")
    me.touch("DONE")
    me.tick("robot.stop")
    me.wait(1)
    me.look("stopped")


def keep(me: Pupil) -> None:
    """Keep it as a test"""
    me.click("Save as a scenario")
    me.type("high pressure", None)
    me.look("scenario")
    me.key(Qt.Key.Key_Return)
    me.key(Qt.Key.Key_F5, SHIFT)
    me.click("Scenarios")
    me.click("Run all")
    me.wait_for_scenarios()
    me.click("Paint")
    me.look("tested")


STEPS = (
    new_project, first_state, screen, measuring, ask_the_cuff, ways, limit, answers,
    nobody_there, stop, another_language, rehearse, keep,
)  # fmt: skip
