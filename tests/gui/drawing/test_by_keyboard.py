"""A form is filled in from the keyboard from its first field to its last."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton
from tests.gui.drawing.forms import FormFiller, called
from tests.gui.test_newcomer import CONTROL

from situ.document.condition import Condition
from situ.document.condition import Test as Question
from situ.document.rbd import Timeout
from situ_studio.edits import places
from situ_studio.edits.notes import note_of

Start = Callable[..., Any]
Copy = Callable[[str], Path]
TAB = Qt.Key.Key_Tab


def test_what_gets_another_name_is_gone_on_with(studio: Start, project: Copy) -> None:
    """A component's id and a state's number are written, and Tab goes to the next field."""
    used = studio(project("reception"))
    me = FormFiller(used.window)
    used.select("state", "4")
    me.click("Text")
    me.fill({"Text": "Good morning", "Id": "greeting"})
    assert called(me.focus()) == "X"
    assert used.window.inspector.place == ("state", "4", "screen", "greeting")
    me.key(Qt.Key.Key_Z, CONTROL)
    assert used.window.inspector.place == ("state", "4", "screen", "text1")
    me.click("State")
    me.fill({"Name": "end", "Number": "done"})
    assert called(me.focus()) == "Timeout"
    assert used.window.inspector.place == ("state", "done")


@pytest.mark.parametrize("kind", ["Speech", "Robot"])
def test_what_is_being_written_outlasts_what_a_check_finds(
    studio: Start, project: Copy, kind: str, comes: Callable[[Any], None]
) -> None:
    """Every edit is checked a moment later; by then somebody writes into the next field."""
    used = studio(project("reception"))
    me = FormFiller(used.window)
    used.select("state", "4")
    QTest.mouseClick(me.widget(kind, QAbstractButton), Qt.MouseButton.LeftButton)
    QTest.keyClicks(me.focus(), "wait")
    comes(used.session.problems_changed)
    me.type("ing", TAB)
    action = used.session.document("reception.rbd.xml").state("4").actions[-1]
    assert "waiting" in (getattr(action, "text", ""), getattr(action, "resource", ""))


def test_what_was_begun_elsewhere_is_not_written_into_another(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    me = FormFiller(used.window)
    used.select("state", "4")
    me.press_in_form("Timeout")
    me.type("7", None)
    used.window.select(("state", "5"))
    me.key(TAB)
    application = used.session.document("reception.rbd.xml")
    assert "7" not in {str(state.timeout and state.timeout.seconds) for state in application.states}


def test_letters_choose_however_slowly_they_are_typed(studio: Start, project: Copy) -> None:
    """By the beginning, or by a word; what is chosen is one step, and Esc leaves what was."""
    used = studio(project("reception"))
    me = FormFiller(used.window)

    def leads_to() -> str:
        return str(used.session.document("reception.rbd.xml").state("4").events[0].next)

    def again() -> Any:
        used.select("state", "4", "event", "0")
        return me.in_form("Leads to")[0]

    before, steps = leads_to(), used.session.undo_text
    box = again()
    box.setFocus()
    for letter in "16":
        me.type(letter, None)
    assert box.currentText().startswith("16 ")
    assert (leads_to(), used.session.undo_text) == (before, steps)
    me.key(Qt.Key.Key_Escape)
    assert box.currentText().startswith(f"{before} ")
    me.type("names", None)
    chosen = box.currentText().partition(" ")[0]
    me.key(TAB)
    assert leads_to() == chosen != before
    me.key(Qt.Key.Key_Z, CONTROL)
    assert (leads_to(), used.session.undo_text) == (before, steps)


def test_a_test_is_written_from_its_tag_to_its_value(studio: Start, project: Copy) -> None:
    """The value has a field only where the test needs one."""
    used = studio(project("reception"))
    me = FormFiller(used.window)
    used.select("state", "4", "event", "0")
    me.menu_in_form("Add a test", "A test")
    me.fill({"Tag": "visits", "Test": "at least", "Value": "3"})
    condition = used.session.document("reception.rbd.xml").state("4").events[0].when
    assert condition == Condition((Question("visits", "atleast", "3"),))


def test_a_note_is_written_beside_what_it_is_about(studio: Start, project: Copy) -> None:
    """As a comment, which goes again when it is taken back."""
    used = studio(project("reception"))
    me = FormFiller(used.window)
    file = used.session.root / "reception.rbd.xml"
    before = file.read_text(encoding="utf-8")
    for place in ((), ("state", "4"), ("state", "4", "event", "0"), ("always",)):
        used.window.select(place)
        me.press_in_form("Note")
        me.write(me.focus(), "Ask -- the ward,  every week")
        me.key(TAB)
        told = note_of(places.get(used.session.document(file.name), place))
        assert told == "Ask – the ward, every week"
    me.key(Qt.Key.Key_S, CONTROL)
    assert file.read_text(encoding="utf-8").count("<!-- Ask – the ward, every week -->") == 4
    while used.session.undo_text is not None:
        me.key(Qt.Key.Key_Z, CONTROL)
    me.key(Qt.Key.Key_S, CONTROL)
    assert file.read_text(encoding="utf-8") == before


def test_a_timeout_is_written_from_its_seconds_to_its_end(studio: Start, project: Copy) -> None:
    """Where it leads has a field only where there is one."""
    used = studio(project("reception"))
    me = FormFiller(used.window)
    me.click("State")
    me.fill({"Timeout": "30", "The timeout leads to": "1 start", "only when idle": True})
    made = used.session.document("reception.rbd.xml").states[-1]
    assert made.timeout == Timeout(30, "1", idle=True)
