"""What somebody who does not see the window is told at once, wherever the focus is."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible, QAccessibleEvent
from PySide6.QtTest import QSignalSpy, QTest
from tests.gui.conftest import PATIENCE

CONTROL = Qt.KeyboardModifier.ControlModifier
NAME = QAccessible.Text.Name

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]
Rows = Callable[[Any], list[str]]


@pytest.fixture
def rows() -> Rows:
    """``rows(teller)``: grows by each row that it tells from then on."""

    def listen(teller: Any) -> list[str]:
        told: list[str] = []

        def notify(event: QAccessibleEvent) -> None:
            assert event.type() == QAccessible.Event.Focus
            view = QAccessible.queryAccessibleInterface(event.object())
            told.append(view.child(event.child()).text(NAME))

        teller.notify = notify
        return told

    return listen


def hears(used: Studio) -> list[str]:
    """Grows by each announcement from now on."""
    told: list[str] = []
    used.window.status.announcements.told.connect(told.append)
    return told


def test_steps_are_told_by_their_names_and_when_they_are_taken_back(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    told = hears(used)
    canvas = used.window.current_view.current_view()
    canvas.viewer.setFocus()
    used.select("state", "14")
    used.key(Qt.Key.Key_D, CONTROL)
    assert told.pop(0).startswith("Duplicate state 14")
    told.clear()
    used.key(Qt.Key.Key_Z, CONTROL)
    assert told.pop(0).startswith("Taken back: Duplicate state 14")


def test_in_a_window_that_is_made_anew_a_step_is_told_there_alone(
    studio: Start, project: Copy, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The window before is gone; the session is the same."""
    faults: list[BaseException] = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: faults.append(error))
    used = studio(project("reception"))
    windows = used.window.windows
    for language in ("ja", "en"):
        gone = QSignalSpy(used.window.destroyed)
        windows.choose_language(language)
        assert gone.wait(PATIENCE)
        (used.window,) = windows.windows
    used.settle()
    told = hears(used)
    used.select("state", "14")
    used.window.commands.delete()
    used.window.actions_.actions["undo"].trigger()
    used.settle()
    assert "Taken back: Delete state 14" in told[-1]
    assert faults == []


def test_a_problem_that_comes_with_a_step_is_told_once_and_that_none_is_left(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    told = hears(used)
    used.window.current_view.current_view().viewer.setFocus()
    used.select("state", "15")
    used.key(Qt.Key.Key_Delete)
    used.window.session.check_now()
    used.settle()
    problems = " ".join(told)
    assert "Delete state 15. Warning, 6 show names: This button raises “clickNo”" in problems
    assert problems.count("Warning, ") == 1
    assert " more" in problems
    told.clear()
    used.select("state", "1")
    used.key(Qt.Key.Key_Right, CONTROL)
    used.window.session.check_now()
    used.settle()
    assert told == ["Move state 1"]
    told.clear()
    used.key(Qt.Key.Key_Z, CONTROL)
    used.key(Qt.Key.Key_Z, CONTROL)
    used.window.session.check_now()
    used.settle()
    assert told[-1].endswith("No problems")


def test_of_a_project_that_is_opened_it_is_told_how_many_problems_it_has(
    studio: Start, project: Copy
) -> None:
    """Also where another one is open: none of them is new."""
    used = studio(project("reception"))
    told = hears(used)
    other = project("conversation")
    file = other / "converse.rbd.xml"
    file.write_text(file.read_text(encoding="utf-8").replace('next="2"', 'next="99"', 1))
    used.session.open(other)
    used.settle()
    assert " ".join(told).count(" error") == 1
    assert "Error, " not in " ".join(told)


def test_what_the_status_bar_says_in_passing_is_told(studio: Start) -> None:
    used = studio()
    told = hears(used)
    used.window.say("Saved.")
    used.settle()
    assert told == ["Saved"]


def test_why_a_priority_is_refused_is_told(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    told = hears(used)
    used.window.open_file("conversation.spds.xml")
    used.window.show_mode("matrix")
    used.settle()
    used.window.current_view.current_view().setFocus()
    used.type("x")
    used.key(Qt.Key.Key_Return)
    assert told == ["A priority is a whole number or none, not “x”"]
    used.key(Qt.Key.Key_Escape)


def test_what_becomes_of_the_link_is_told_and_not_each_second_of_it(studio: Start) -> None:
    used = studio()
    told = hears(used)
    for words, live in (("live, 12 ms behind", "true"), ("live, 9 ms behind", "true")):
        used.window.status.show_link("link", words, live)
        used.settle()
    used.window.status.show_link("unlink", "lost 2 s ago", "lost")
    used.settle()
    assert told == ["live, 12 ms behind", "lost 2 s ago"]


def test_who_listens_hears_an_announcement_as_a_notification(
    studio: Start, listening: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ_studio.assistive.announcing.QSysInfo.kernelType", lambda: "linux")
    used = studio()
    announcements = used.window.status.announcements
    told: list[Any] = []
    announcements.notify = lambda event: told.append(
        (event.type(), event.accessibleInterface().role(), event.accessibleInterface().text(NAME))
    )
    announcements.pause.setInterval(0)
    announcements.tell("One.")
    announcements.tell("Two.")
    used.settle()
    role = QAccessible.Role.Notification
    assert told == [(QAccessible.Event.ObjectShow, role, "One. Two")]


def test_where_no_notifications_are_heard_an_announcement_is_sent(
    studio: Start, listening: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ_studio.assistive.announcing.QSysInfo.kernelType", lambda: "winnt")
    used = studio()
    announcements = used.window.status.announcements
    told: list[Any] = []
    announcements.notify = lambda event: told.append((event.type(), event.message()))
    announcements.pause.setInterval(0)
    announcements.tell("One.")
    used.settle()
    assert told == [(QAccessible.Event.Announcement, "One")]


def test_commands_that_are_typed_for_are_heard_row_by_row(
    studio: Start, project: Copy, listening: None, rows: Rows
) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_K, CONTROL)
    told = rows(used.window.finder.current_row)
    used.type("reh")
    assert told[-1] == "Rehearse F5"
    used.key(Qt.Key.Key_Down)
    assert told[-1] == "Step in the rehearsal only while you rehearse"
    used.key(Qt.Key.Key_Escape)


def test_what_can_follow_is_heard_row_by_row(
    studio: Start, project: Copy, listening: None, rows: Rows
) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.current_view()
    canvas.viewer.setFocus()
    used.select("state", "3")
    used.key(Qt.Key.Key_E, CONTROL)
    menu = canvas.menu
    told = rows(menu.current_row)
    QTest.keyClick(menu.field, Qt.Key.Key_Down)
    used.settle()
    assert told == ["New state that says something"]
    QTest.keyClicks(menu.field, "16")
    used.settle()
    assert " ".join(told[-1].split()) == "16 register"
    QTest.keyClick(menu.field, Qt.Key.Key_Escape)
    used.settle()


def test_what_was_found_is_heard_row_by_row(
    studio: Start, project: Copy, listening: None, rows: Rows
) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_F, CONTROL)
    panel = used.window.finding.panel
    told = rows(panel.current_row)
    used.type("greeting")
    used.key(Qt.Key.Key_Down)
    assert told
    assert told[-1] == panel.list.currentIndex().data(Qt.ItemDataRole.AccessibleTextRole)


def test_what_the_robot_says_in_a_rehearsal_is_told_and_can_be_read(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    told = hears(used)
    # However slow this machine is, the robot still says it.
    used.window.rehearsing.clock = lambda: 0.0
    used.key(Qt.Key.Key_F5)
    hello = "“Hello. I am glad to see you. Shall we talk a little?”"
    assert f"The robot says {hello}" in told
    words = QAccessible.queryAccessibleInterface(used.window.rehearsing.desk.says.words)
    assert words.text(NAME) == hello
    assert words.text(QAccessible.Text.Description) == "What the robot says"
    used.window.rehearsing.end()


def test_who_comes_to_a_tree_hears_its_current_row(
    studio: Start, project: Copy, listening: None, rows: Rows
) -> None:
    used = studio(project("conversation"))
    used.window.current_view.current_view().viewer.setFocus()
    tree = used.window.project_tree.tree
    told = rows(tree)
    tree.setFocus()
    used.settle()
    # Qt says of rows within others, where it is asked what is selected, another one.
    assert told == ["converse, application"]
