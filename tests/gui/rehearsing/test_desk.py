"""The rehearsal desk in a window: one key starts it, and hands do what the world does."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QPushButton

from situ.decide import inputs
from situ.decide.step import SECOND
from situ.rehearse.scenario import load
from situ.rehearse.suite import play
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.lists import COUNT
from situ_studio.rehearsing.robot_screen import RobotScreen
from situ_studio.rehearsing.saving import SavingScenario
from situ_studio.screens.shown import Content

SHIFT = Qt.KeyboardModifier.ShiftModifier


def test_one_key_rehearses_and_a_click_on_the_screen_goes_on(desk: Any) -> None:
    used = desk("conversation")
    assert used.desk.isVisible()
    assert used.state == "1"
    assert used.glowing() == {"1"}
    used.touch("YES")
    assert used.state == "2"
    assert used.glowing() == {"2"}
    assert "Did you sleep well?" in used.desk.says.words.text()

    # What people may say is offered; said, it is heard once the robot has spoken.
    used.go_on(6)
    button = next(b for b in used.desk.findChildren(QPushButton) if b.text() == "“not so well”")
    used.studio.click(button)
    assert used.state == "4"

    # All live views show it.
    told = used.window.robot.trace.rows.rows
    assert any("not so well" in cell for row in told for cell in row.cells)

    # Shift+F5 ends it, and the drawing is as drawn.
    used.studio.key(Qt.Key.Key_F5, SHIFT)
    assert used.side.running is None
    assert not used.desk.isVisible()
    assert used.glowing() == set()
    assert used.window.docks["inspector"].isVisible()


def test_what_people_may_say_for_several_events_is_offered_once(
    studio: Callable[..., Any], project: Callable[[str], Path], rehearsed: Any
) -> None:
    where = project("conversation")
    file = where / "converse.rbd.xml"
    text = file.read_text(encoding="utf-8")
    said = "<say>yes</say><say>tea &amp; cake</say>"
    file.write_text(text.replace("<say>not now</say>", said), encoding="utf-8")
    used = rehearsed(studio(where))
    assert used.state == "1"
    offered = [b for b in used.desk.findChildren(QPushButton) if b.text() == "“yes”"]
    assert [b.toolTip() for b in offered] == ["A person says that: clickYes, clickNo"]
    # On a button a single ampersand is not seen.
    assert [b for b in used.desk.findChildren(QPushButton) if b.text() == "“tea && cake”"]


def test_an_inspector_that_was_closed_stays_closed_after_a_rehearsal(
    studio: Callable[..., Any], project: Callable[[str], Path], rehearsed: Any
) -> None:
    made = studio(project("conversation"))
    made.window.docks["inspector"].hide()
    used = rehearsed(made)
    assert used.desk.isVisible()
    made.key(Qt.Key.Key_F5, SHIFT)
    assert not used.desk.isVisible()
    assert not made.window.docks["inspector"].isVisible()


def test_the_robots_screen_is_as_large_in_a_low_window_as_in_a_high_one(desk: Any) -> None:
    used = desk("reception")
    sizes = set()
    # A bar that took room would make the screen lower, and would not be needed any more.
    for height in (600, 800, 1600):
        used.window.resize(1280, height)
        used.studio.settle()
        sizes.add(used.desk.screen_.size().toTuple())
    assert len(sizes) == 1


def test_data_is_turned_by_switch_and_slider(desk: Any) -> None:
    used = desk("conversation")
    course = used.side.running.course
    waving = used.desk.dials["hand.waving"]
    used.desk.ensureWidgetVisible(waving)
    used.studio.click(waving.flag, QPoint(8, waving.flag.height() // 2))
    assert course.look("hand.waving") is True
    turned = used.desk.dials["person.direction"]
    used.desk.ensureWidgetVisible(turned)
    turned.slider.setFocus()
    used.studio.key(Qt.Key.Key_End)
    assert course.look("person.direction") == 180
    assert turned.value.text() == "180°"
    used.desk.ensureWidgetVisible(used.desk.other)
    used.studio.fill(used.desk.other, "weather.tomorrow = 3")
    assert course.look("weather.tomorrow") == 3
    assert used.desk.other.text() == ""


def test_a_word_that_is_typed_is_written_once(desk: Any) -> None:
    used = desk("conversation")
    course, row = used.side.running.course, used.desk.dials["transfer.phase"]
    row.choice.addItem("guiding")
    used.desk.ensureWidgetVisible(row)
    # Typed whole, it is both chosen and typed; what is not among the entries is only typed.
    for word in ("guiding", "waiting"):
        used.studio.fill(row.choice.lineEdit(), word)
        assert course.look("transfer.phase") == word
    assert [one.does for one in course.done] == [
        inputs.Set({"transfer.phase": word}, "scenario") for word in ("guiding", "waiting")
    ]


def test_modules_ask_give_back_and_are_lost(desk: Any) -> None:
    used = desk("conversation")
    moment = used.window.robot.follower.viewing.moment
    row = used.desk.modules["transfer"]
    used.desk.ensureWidgetVisible(row)
    used.studio.click(row.asks)
    assert set(moment().asking["transfer"]) == set(row.resources)
    used.studio.click(row.asks)
    assert not moment().asking.get("transfer")
    used.studio.click(row.asks)
    used.studio.click(row.lose)
    assert not moment().asking.get("transfer")
    assert not row.asks.isChecked()


def test_the_clock_pauses_steps_and_goes_ten_times_as_fast(desk: Any) -> None:
    used = desk("conversation")
    running, clock = used.side.running, used.desk.clock
    used.go_on(1)
    assert running.course.now == 1 * SECOND
    used.studio.click(clock.pause)
    used.go_on(5)
    assert running.course.now == 1 * SECOND
    used.studio.click(clock.step)
    assert used.side.running.course.pending == []  # the speech has ended: that was next
    stepped = running.course.now
    used.studio.click(clock.paces.button("10"))
    used.go_on(1)
    assert running.course.now == stepped + 10 * SECOND
    used.studio.click(clock.restart)
    assert running.course.now == 0
    assert used.state == "1"


def test_it_is_typed_into_the_robots_screen(desk: Any) -> None:
    used = desk("reception")
    used.touch("English")
    used.go_on(12)
    used.touch("CONTINUE")
    assert used.state == "3"
    used.touch("initial")
    assert used.desk.screen_.field.isVisible()
    used.studio.type("J")
    used.studio.key(Qt.Key.Key_Return)
    course = used.side.running.course
    assert course.look("user.initial.x") == "J"


def test_keys_reach_every_row_also_of_two_that_say_the_same(qt: Any) -> None:
    people = [("Smith", 1), ("Smith", 2), ("Jones", 3)]
    items = [{"label": label, "value": value} for label, value in people]
    place = {"x": 5, "y": 5, "width": 60, "height": 80, "size": 6}
    screen = RobotScreen(LIGHT)
    screen.resize(400, 300)
    screen.show_content(Content(({"id": "who", "type": "list", "items": items, **place},)), None)
    used: list[Any] = []
    screen.used.connect(lambda _, value: used.append(value))
    for _ in people:
        QTest.keyClick(screen, Qt.Key.Key_Down)
        QTest.keyClick(screen, Qt.Key.Key_Return)
    assert used == [1, 2, 3]
    screen.deleteLater()


def test_what_a_service_answers_is_given(desk: Any) -> None:
    used = desk("reception")
    running, shown = used.side.running, used.desk
    running.give(inputs.Touch())
    for event in ("Continue", "Confirm", "Confirm", "Confirm", "Yes"):
        running.give(inputs.Raise(f"click{event}"))
    used.studio.settle()
    (answer,) = (
        line for line in shown.findChildren(QLineEdit) if "answers" in line.accessibleName()
    )
    shown.ensureWidgetVisible(answer)
    used.studio.fill(answer, '{"names": []}', Qt.Key.Key_Tab)
    well = [
        button
        for button in shown.findChildren(QPushButton)
        if button.text() == "Ends well" and "findPatients" in button.accessibleName()
    ]
    shown.ensureWidgetVisible(well[0])
    used.studio.click(well[0])
    assert used.state == "14"  # nobody has these initials


def test_what_the_robot_waits_for_is_above_what_is_said_and_answered_as_in_the_scenarios(
    desk: Any,
) -> None:
    used = desk("vitals")
    used.go_on(1)
    shown, running = used.desk, used.side.running
    running.give(inputs.Touch())
    running.give(inputs.Use("room", 12))
    running.give(inputs.Use("pin", "1234"))
    used.studio.settle()
    (answer,) = (line for line in shown.findChildren(QLineEdit) if "login" in line.accessibleName())
    phrases = [b for b in shown.findChildren(QPushButton) if b.text().startswith("“")]
    lowest = answer.mapTo(shown, QPoint(0, answer.height())).y()
    assert lowest <= min(button.mapTo(shown, QPoint(0, 0)).y() for button in phrases)
    # It is seen at once, and short phrases share a line.
    assert lowest <= shown.viewport().height()
    assert len({button.y() for button in phrases}) < len(phrases)
    used.studio.click(answer)
    used.studio.key(Qt.Key.Key_Return)
    assert used.side.running.course.look("user.name") == "Jack Nilsen"


def test_after_an_edit_it_is_offered_to_start_again(desk: Any) -> None:
    used = desk("conversation")
    used.touch("YES")
    assert not used.desk.notice.again.isVisible()
    used.studio.select("state", "1")
    used.studio.key(Qt.Key.Key_F2)
    used.studio.type("hi")
    used.studio.key(Qt.Key.Key_Return)
    assert used.desk.notice.again.isVisible()
    used.studio.click(used.desk.notice.again)
    assert used.state == "1"
    assert used.side.running.course.project is used.studio.session.project
    assert not used.desk.notice.again.isVisible()


def test_what_was_done_is_saved_as_a_scenario_with_what_shall_happen_again(desk: Any) -> None:
    used = desk("conversation")
    used.go_on(1)
    used.touch("YES")
    used.studio.click(used.desk.clock.save)
    (saving,) = used.window.findChildren(SavingScenario)
    assert not saving.keep.isEnabled()
    QTest.keyClicks(saving.name, "fig5")
    assert not saving.keep.isEnabled()  # there is one of that name
    assert saving.why.text()
    QTest.keyClick(saving.name, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClicks(saving.name, "slept well")
    before = len(saving.expected)
    first = saving.list.item(0)
    assert first.checkState() == Qt.CheckState.Checked
    saving.list.setCurrentItem(first)
    QTest.keyClick(saving.list, Qt.Key.Key_Space)
    assert len(saving.expected) == before - 1
    used.studio.click(saving.keep)
    project = used.side.running.course.project
    file = Path(project.root, "scenarios", "slept well.jsonl")
    _, played = play(project, file.name, load(file, ["converse"]))
    assert played.well
    assert played.expectations == before - 1
    kinds = [type(line.does).__name__ for line in load(file)]
    assert "Use" in kinds
    assert kinds[-1] == "End"
    # The project's tree knows of it, and comes to know of the first one.
    rows = used.window.project_tree.tree.model()
    assert in_tree(rows) == str(len(list(file.parent.iterdir())))
    shutil.rmtree(file.parent)
    used.window.project_tree.show_project(project, used.studio.session.files)
    assert in_tree(rows) is None
    used.studio.click(used.desk.clock.save)
    (saving,) = [one for one in used.window.findChildren(SavingScenario) if one.isVisible()]
    QTest.keyClicks(saving.name, "anew")
    used.studio.click(saving.keep)
    assert in_tree(rows) == "1"


def in_tree(rows: Any) -> str | None:
    """The number at the scenarios' row."""
    top = rows.index(0, 0)
    last = rows.index(rows.rowCount(top) - 1, 0, top)
    return str(last.data(COUNT)) if last.data() == "scenarios" else None


def test_a_project_with_errors_is_not_rehearsed(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    root = project("conversation")
    file = root / "converse.rbd.xml"
    file.write_text(file.read_text().replace('next="2"', 'next="77"', 1))
    made = studio(root)
    made.key(Qt.Key.Key_F5)
    assert made.window.rehearsing.running is None
    assert made.window.bottom.current == "problems"


def test_what_was_rehearsed_when_the_window_closed_is_not_there_the_next_time(
    studio: Callable[..., Any], project: Callable[[str], Path], rehearsed: Any
) -> None:
    root = project("conversation")
    first = rehearsed(studio(root))
    assert first.desk.isVisible()
    first.window.close()
    again = studio(root).window
    assert not again.docks["rehearsal"].isVisible()
    assert again.docks["inspector"].isVisible()
