"""The example of the paper, drawn by mouse and keys from an empty project (issue 9, done-test).

What things are called is asked of the accessible tree; no value of the studio is used.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractButton, QFileDialog
from tests.gui.drawing.draughtsman import Draughtsman
from tests.gui.test_newcomer import CONTROL

from situ.resources import example
from situ_studio.window.dialogs import Dialogs

DATA = (
    ("transfer.phase", "text", ""),
    ("hand.waving", "", ""),
    ("person.calling", "", ""),
    ("person.direction", "number", "deg"),
    ("sound.slap", "number", "deg"),
    ("speech.acceptable", "", ""),
    ("face.visible", "", ""),
    ("face.direction", "number", "deg"),
    ("robot.stop", "", ""),
)
"""Each with its type, "" where it is the one that data has at first, and its unit."""
NOTES = {
    "": "The demonstration of the paper on situated priorities; (A) to (E) are the parts of its "
    "Fig. 5.",
    "stopped": "Before all that the paper shows: the stop button is pressed, and nobody has "
    "anything, until it is let go.",
    "invited": "(E) Somebody calls and waves: the robot breaks off and goes there, until it has "
    "arrived or can not.",
    "What ends invited": "Who has stopped the robot must not see it drive off again when the "
    "button is let go.",
    "called": "(D) Somebody else calls: the face turns there.",
    "sound": "(C) A slap: a glance there, while the conversation goes on.",
    "accepted": "(B) What was said can be accepted: a nod.",
    "conversation": "(A) Conversation: the face of the speaker is followed.",
}
"""By what each is about; "" is the script."""
MODULES = ("transfer", "face-caller", "gaze-sound", "nod", "converse", "chase-face")


def test_the_conversation_is_drawn_by_hand(
    studio: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = studio().window
    window.resize(1700, 1150)
    window.dialogs = Dialogs(window)
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    me = Draughtsman(window)
    me.answer("conversation")
    me.click("New project")
    me.run("Script of situations")

    # What there is to begin with: the application, and a situation that always holds.
    me.click_card("conversation")
    me.key(Qt.Key.Key_Delete)
    me.twice_on("otherwise")
    me.key(Qt.Key.Key_A, CONTROL)
    me.type("conversation")

    for tag, kind, unit in DATA:
        me.click("Data", QAbstractButton)
        me.type(tag)
        if kind:
            me.pick("Type", kind)
        if unit:
            me.write_into("Unit", unit)
    for name in MODULES:
        me.click("Module", QAbstractButton)
        me.type(name)
        me.write_into("Resources", "base head" if name == "transfer" else "head")
    # By hand: one resource is pulled off, two are new.
    me.click_card("converse")
    me.key(Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    me.key(Qt.Key.Key_Delete)
    for resource in ("speech", "screen"):
        start = me.out("converse")
        me.drag(start, start + QPoint(30, 20))
        me.type(resource)

    # Before all others: the stop button.
    me.pull_to_ground("robot.stop", "conversation", "stopped")

    # (E) Invited.
    me.pull_to_ground("person.calling", "conversation", "invited")
    me.pull("hand.waving", "Condition of invited")
    me.test("person.calling is true", within="5")
    me.test("hand.waving is true", within="2")
    me.pull_to_ground("transfer.phase", "conversation", "invited holds until")
    me.test("transfer.phase exists", "is one of", value="arrived, failed", within="5")
    me.pull("robot.stop", "What ends invited")
    sign = me.drawn("What ends invited")
    me.twice(QPoint(sign.left() + 12, sign.center().y()))
    me.type("any")
    me.click_card("invited")
    me.run("End after")
    me.type("90")
    me.priority("invited", "transfer", 90)

    # (D) Called.
    me.pull_to_ground("person.calling", "conversation", "called")
    me.pull("called", "conversation")
    me.priority("called", "face-caller", 70)
    me.test("person.calling is true", within="5")

    # (C) A slap.
    me.pull_to_ground("sound.slap", "conversation", "sound")
    me.pull("sound", "conversation")
    me.priority("sound", "gaze-sound", 60)
    me.test("sound.slap above 0", "exists", within="1")
    me.click_card("sound")
    me.run("Stay at least")
    me.type("1.5")

    # (B) A nod.
    me.pull_to_ground("speech.acceptable", "conversation", "accepted")
    me.pull("accepted", "conversation")
    me.priority("accepted", "nod", 40)
    me.test("speech.acceptable is true", within="1")
    me.click_card("accepted")
    me.run("Stay at least")
    me.type("1.2")

    # (A) Conversation.
    me.priority("conversation", "converse", 30)
    me.priority("conversation", "chase-face", 20)

    # What the example says to those who read it.
    for card, note in NOTES.items():
        me.note(card, note)

    me.key(Qt.Key.Key_S, CONTROL)
    wanted = example("conversation") / "conversation.spds.xml"
    drawn = tmp_path / "conversation" / "conversation.spds.xml"
    assert drawn.read_text(encoding="utf-8") == wanted.read_text(encoding="utf-8")
