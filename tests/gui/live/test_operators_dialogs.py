"""What an operator raises and sets is offered: what is expected, what is known, in its type."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QWidget
from tests.gui.live.test_operating import connect, kinds

from situ.decide.expected import Expectation, ExpectedEvent
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.live.raising_dialog import Offer, RaisingDialog, offers
from situ_studio.live.setting_dialog import Setting, SettingDialog, value_of
from situ_studio.window.dialogs import Dialogs

LEFT = Qt.MouseButton.LeftButton
KNOWN = Vocabulary(
    tags=("human.near", "robot.battery", "user.name"),
    data=(
        ("human.near", "boolean", ""),
        ("robot.battery", "number", "%"),
        ("user.name", "text", ""),
        ("way", "list", ""),
    ),
)


def opened(dialog: Any) -> Any:
    dialog.show()
    dialog.activateWindow()
    assert QTest.qWaitForWindowExposed(dialog)
    return dialog


def complete(line: QLineEdit, typed: str) -> list[str]:
    """Types, takes the first word that is offered, by keys; what was offered."""
    line.setFocus()
    QTest.keyClicks(line, typed)
    completer = line.completer()
    popup = completer.popup()
    assert popup is not None
    assert popup.isVisible()
    model = completer.completionModel()
    found = [model.index(row, 0).data() for row in range(model.rowCount())]
    QTest.keyClick(popup, Qt.Key.Key_Down)
    QTest.keyClick(popup, Qt.Key.Key_Return)
    return found


def expectation(*events: ExpectedEvent) -> Expectation:
    return Expectation("1", "", 0, False, False, events)


def test_what_would_be_taken_now_is_offered_first_of_the_application_that_is_worked_in() -> None:
    no = ExpectedEvent("no", (), False, ("volume is above 3",))
    yes = ExpectedEvent("yes", ("yes", "sure", "yes"), True, ())
    expected = {
        "a": expectation(no, yes),
        "b": expectation(ExpectedEvent("no", (), True, ()), ExpectedEvent("go", (), True, ())),
    }
    heard = Offer("yes", "“yes”, “sure”")
    assert offers(expected, "a") == [heard, Offer("no", "not now: volume is above 3")]
    assert offers(expected, None) == [Offer("no", ""), heard, Offer("go", "")]


def test_an_event_is_taken_from_the_list_or_completed_by_mouse_and_by_keys(over: QWidget) -> None:
    offered = [Offer("yes", "“sure”"), Offer("no", "")]
    dialog = opened(RaisingDialog(offered, "", ("help", "yes", "zero"), over))
    assert not dialog.raise_button.isEnabled()
    assert dialog.list.accessibleName()
    assert dialog.line.accessibleName()
    rect = dialog.list.visualItemRect(dialog.list.item(1))
    QTest.mouseClick(dialog.list.viewport(), LEFT, pos=rect.center())
    assert dialog.event_name == "no"
    QTest.keyClick(dialog.list, Qt.Key.Key_Up)
    assert dialog.event_name == "yes"
    assert dialog.raise_button.isEnabled()
    # Any other that the project names; Return takes the word, and only then the dialog.
    dialog.line.clear()
    assert complete(dialog.line, "he") == ["help"]
    assert dialog.event_name == "help"
    assert dialog.isVisible()
    QTest.keyClick(dialog.line, Qt.Key.Key_Return)
    assert dialog.result() == RaisingDialog.DialogCode.Accepted
    dialog.deleteLater()
    bare = RaisingDialog([], "", (), over)
    assert "Nothing is expected now" in [label.text() for label in bare.findChildren(QLabel)]
    bare.deleteLater()


def test_a_value_is_given_in_the_input_of_its_type(over: QWidget) -> None:
    now = {"robot.battery": 80, "lamp": True}
    dialog = opened(SettingDialog(KNOWN, now, over))
    assert not dialog.set_button.isEnabled()
    assert complete(dialog.tag, "hum") == ["human.near"]
    assert dialog.choice.isVisible()
    assert not dialog.value.isVisible()
    assert dialog.setting == Setting("human.near", True)
    QTest.keyClick(dialog.choice, Qt.Key.Key_Down)
    assert dialog.setting == Setting("human.near", False)
    # A number has its unit, and is nothing else.
    dialog.tag.clear()
    assert complete(dialog.tag, "batt") == ["robot.battery"]
    assert dialog.unit.text() == "%"
    assert dialog.told.text() == "It is 80 now."
    QTest.keyClicks(dialog.value, "full")
    assert dialog.told.text() == "Write a number."
    assert not dialog.set_button.isEnabled()
    dialog.value.clear()
    QTest.keyClicks(dialog.value, "40")
    assert dialog.setting == Setting("robot.battery", 40)
    # What the project says nothing of is as it is now.
    dialog.tag.clear()
    assert complete(dialog.tag, "la") == ["lamp"]
    assert dialog.choice.isVisible()
    assert all(one.accessibleName() for one in (dialog.tag, dialog.value, dialog.choice))
    QTest.mouseClick(dialog.set_button, LEFT, pos=QPoint(5, 5))
    assert dialog.result() == SettingDialog.DialogCode.Accepted
    dialog.deleteLater()


def test_the_robot_is_asked_what_it_expects_and_gets_what_was_taken(
    studio: Callable[..., Any], project: Callable[[str], Path], robot: Any, until: Any
) -> None:
    there = robot(project("conversation"))
    it = studio(there.project)
    window = it.window
    link = connect(it, there.endpoint, until)
    window.dialogs = Dialogs(window)
    taken: list[str] = []

    def take() -> None:
        dialog = QApplication.activeModalWidget()
        if not isinstance(dialog, RaisingDialog):
            return
        patience.stop()
        rect = dialog.list.visualItemRect(dialog.list.item(0))
        QTest.mouseClick(dialog.list.viewport(), LEFT, pos=rect.center())
        taken.append(dialog.event_name)
        QTest.mouseClick(dialog.raise_button, LEFT)

    patience = QTimer(window)
    patience.timeout.connect(take)
    patience.start(0)
    window.actions_.actions["operate.raise"].trigger()
    until(link.moment_changed, lambda: any(e["writer"] and taken for e in kinds(link, "event")))
    last = kinds(link, "event")[-1]
    assert last["name"] == taken[0]
    assert last["writer"].startswith("operator:")
    window.robot.disconnect_robot()


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("", None, None),
        (" 40", None, 40),
        ("true", None, True),
        ("hello you", None, "hello you"),
        ('["a"]', "list", ["a"]),
        ("40", "text", "40"),
    ],
)
def test_a_typed_value_is_what_it_looks_like_or_its_type(text: str, kind: Any, value: Any) -> None:
    assert value_of(text, kind) == value


@pytest.mark.parametrize(("text", "kind"), [("a", "number"), ("1", "list"), ("[]", "object")])
def test_what_is_not_of_the_type_is_no_value(text: str, kind: Any) -> None:
    with pytest.raises(ValueError, match=re.escape(text)):
        value_of(text, kind)
