"""What a screen reader hears of one thing: its role, its name, and what became of it."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QAccessible, QColor
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QLabel,
    QLineEdit,
    QVBoxLayout,
    QWidget,
)
from tests.gui.conftest import PATIENCE
from tests.gui.live.test_comparing import until
from tests.gui.live.test_field import recorded
from tests.gui.live.test_recordings import opened, until_shown
from tests.gui.test_announcing import hears

from situ_studio.assistive.heard_as import hear_as
from situ_studio.assistive.tab_order import stops
from situ_studio.commands.shortcuts import KeyList
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.conditions import GroupBox
from situ_studio.panels.rows import RowWidget
from situ_studio.panels.table import Row, RowsTable
from situ_studio.panels.test_box import TestBox
from situ_studio.screens.sample_table import SampleTable
from situ_studio.widgets.layouts import clear
from situ_studio.widgets.named_box import NamedBox

Start = Callable[..., Any]
Copy = Callable[[str], Path]
NAME, DESCRIPTION = QAccessible.Text.Name, QAccessible.Text.Description
ROLE = QAccessible.Role
SHIFT = Qt.KeyboardModifier.ShiftModifier
CONTROL = Qt.KeyboardModifier.ControlModifier


def heard(widget: QWidget) -> Any:
    return QAccessible.queryAccessibleInterface(widget)


def labels(widget: QWidget) -> list[str]:
    """What readers call it by, where Qt tells what is chosen in it as its name."""
    found = heard(widget).relations(QAccessible.RelationFlag.Label)
    return [label.text(NAME) for label, _ in found]


def around(widget: QWidget) -> list[str]:
    """The named groups that it is in, the inner ones first; a reader tells those anew entered."""
    found = []
    part = heard(widget).parent()
    while part is not None:
        if part.role() in (ROLE.Grouping, ROLE.Client) and part.text(NAME):
            found.append(part.text(NAME))
        part = part.parent()
    return found


def shown_in(holder: QWidget, *widgets: QWidget) -> None:
    column = QVBoxLayout(holder)
    for widget in widgets:
        column.addWidget(widget)
    holder.show()
    QApplication.processEvents()


def test_a_combo_box_is_called_by_its_name_or_by_the_label_beside_it(qt: QApplication) -> None:
    window = QWidget()
    alone, labelled, words = NamedBox(), NamedBox(), QLabel("Leads to")
    alone.setAccessibleName("Test")
    labelled.setAccessibleName("Leads to")
    words.setBuddy(labelled)
    shown_in(window, alone, words, labelled)
    assert labels(alone) == ["Test"]
    alone.setAccessibleName("Value")
    assert labels(alone) == ["Value"]
    assert labels(labelled) == ["Leads to"]
    assert [one.text() for one in window.findChildren(QLabel) if one.isVisible()] == ["Leads to"]
    window.close()
    window.deleteLater()


def test_what_is_filled_anew_keeps_no_label_of_a_box_that_is_gone(qt: QApplication) -> None:
    window = QWidget()
    column = QVBoxLayout(window)
    window.show()
    for name in ("Test", "Value", "Leads to"):
        clear(column)
        box = NamedBox()
        box.setAccessibleName(name)
        column.addWidget(box)
        QApplication.processEvents()
    for _ in ("boxes", "labels"):
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    assert [one.text() for one in window.findChildren(QLabel)] == ["Leads to"]
    window.close()
    window.deleteLater()


def test_a_widget_is_heard_as_what_it_is_said_to_be_and_does_that(qt: QApplication) -> None:
    pressed: list[bool] = []
    made = QWidget()
    made.setAccessibleName("Speech")
    hear_as(made, ROLE.Button, lambda widget: pressed.append(widget is made))
    made.show()
    assert (heard(made).role(), heard(made).text(NAME)) == (ROLE.Button, "Speech")
    actions = heard(made).actionInterface()
    actions.doAction("Press")
    assert pressed == [True]
    assert heard(made).valueInterface() is None
    assert heard(made).textInterface() is None
    made.close()
    made.deleteLater()


def cells(view: QAbstractItemView) -> list[str]:
    """What is heard of a table's cells, row by row."""
    table = heard(view)
    every = [table.child(at) for at in range(table.childCount())]
    return [part.text(NAME) for part in every if part.tableCellInterface() is not None]


def test_a_cell_of_a_table_is_heard_with_the_head_of_its_column(qt: QApplication) -> None:
    """Who goes down a table hears its cells, and a head only where the column is another."""
    window = QWidget()
    rows = RowsTable("Trace", ("Time", "What", "Because of"), (90, 120), LIGHT)
    rows.rows.show([Row("1", ("12 s", "State entered", ""))])
    keys = KeyList()
    keys.add("File", "Save", "Ctrl+S")
    sample = SampleTable("patients", ("name", "room"), [{"name": "Ana"}])
    shown_in(window, rows, keys, sample)
    # An empty cell says nothing.
    assert cells(rows) == ["Time: 12 s", "What: State entered", ""]
    # A heading, and what stands below it, say what they are.
    assert cells(keys.tree) == ["File", "", "Save", "Keys: Ctrl+S"]
    assert cells(sample)[0] == "name: Ana"
    sample.edit(sample.model().index(1, 1))
    (editor,) = sample.viewport().findChildren(QLineEdit)
    QTest.keyClicks(editor, "12")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    QApplication.processEvents()
    assert cells(sample)[3] == "room: 12"
    window.close()
    window.deleteLater()


def test_a_row_of_the_outline_says_which_it_is_and_heads_the_rest(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.window.open_file("reception.rbd.xml")
    used.window.show_mode("outline")
    used.select("state", "14")
    said = cells(used.window.current_view.current_view().tree)
    at = said.index("Name: no user")
    assert said[at - 1] == "14"
    assert any(words.startswith("Leads to: ") for words in said[at:])


def test_the_fields_of_a_condition_are_heard_with_what_they_are_about(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    used.window.open_file("conversation.spds.xml")
    used.select("situation", "invited")
    form = used.window.inspector.form
    first, second, third = form.findChildren(TestBox)[:3]
    assert around(first.within)[:2] == ["Test of person.calling", "Holds when"]
    assert around(second.within)[:2] == ["Test of hand.waving", "Holds when"]
    assert labels(first.test) == ["Test"]
    (group,) = form.findChildren(GroupBox)
    assert around(third.value)[:3] == ["Test of transfer.phase", "any of these", "Until"]
    assert labels(group.kind) == ["Group"]


def test_a_row_of_a_form_is_a_button_that_opens(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "7")
    row = used.window.inspector.form.findChildren(RowWidget)[0]
    assert heard(row).role() == ROLE.Button
    heard(row).actionInterface().doAction("Press")
    used.settle()
    assert used.window.current_view.selected == (("state", "7", "action", "0"),)


def test_where_a_component_is_moved_to_is_told_and_what_it_is_level_with(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.window.open_file("reception.rbd.xml")
    used.window.show_mode("screen")
    used.select("state", "5", "screen", "yes")
    told = hears(used)
    used.window.current_view.current_view().setFocus()
    used.key(Qt.Key.Key_Right)
    assert told.pop().startswith("Move yes. 7 % from the left, 70 % from the top; 91 × 33 mm, ")
    used.key(Qt.Key.Key_Down, CONTROL)
    assert "Resize yes. 7 % from the left, 70 % from the top; 91 × 34 mm" in told[-1]
    used.key(Qt.Key.Key_Left, SHIFT)
    assert "0 % from the left" in told[-1]
    assert "at the left edge of the screen; upper edge level with Button NO" in told[-1]


def test_the_timeline_tells_in_words_where_a_key_takes_its_cursor(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    ours, other = recorded(tmp_path, "reception", "known-user.jsonl", "second-thoughts.jsonl")
    used.window.robot.open_recording(ours)
    until_shown(used)
    used.window.bottom.choose("timeline")
    timeline, viewing = used.window.robot.timeline, used.window.robot.follower.viewing
    assert (heard(timeline.chart).role(), heard(timeline.chart).text(NAME)) == (
        ROLE.Slider,
        "Timeline",
    )
    timeline.chart.setFocus()
    about = heard(timeline.chart).text(DESCRIPTION)
    assert about.startswith(viewing.written(viewing.t))
    viewing.seek(9.0)
    # A reader would tell each change of it, beside what is told.
    assert heard(timeline.chart).text(DESCRIPTION) == about
    timeline.bookmarks.add(12.0, "asked")
    told = hears(used)
    used.key(Qt.Key.Key_PageDown)
    now = viewing.written(12.0)
    at = viewing.moment().applications["reception"].state
    state = used.window.robot.state_name("reception", at)
    assert told == [f"{now}, bookmark asked, reception: {state}"]
    told.clear()
    used.click(timeline.back)
    assert told[-1].startswith(viewing.written(viewing.t))
    told.clear()
    # What somebody else moves is told by who moves it.
    viewing.seek(9.0)
    used.settle()
    assert told == []
    used.window.robot.comparing.compare_with(other)
    until(used.window.robot.comparing.comparing)
    viewing.seek(0.0)
    used.window.commands.next_difference(1)
    used.settle()
    assert told[-1].startswith("1 of ")
    assert ". B, " in told[-1]


def test_the_answer_to_why_is_told(studio: Start, project: Copy, tmp_path: Path) -> None:
    used = studio(project("reception"))
    (ours,) = recorded(tmp_path, "reception", "known-user.jsonl")
    used.window.robot.open_recording(ours)
    until_shown(used)
    used.window.robot.follower.viewing.seek(16.0)
    used.select("state", "2")
    told = hears(used)
    used.window.commands.ask_why()
    panel = used.window.why.panel
    used.settle()
    assert panel.links
    assert panel.title.text() in told[-1]
    assert panel.links[panel.table.currentIndex().row()].words.strip() in told[-1]


def test_another_situation_is_told_while_it_is_followed(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    rehearsing = used.window.rehearsing
    rehearsing.clock = lambda: 0.0
    told = hears(used)
    more = QSignalSpy(used.window.status.announcements.told)

    def until_told(words: str) -> None:
        # Events are gathered for a frame before they are shown.
        while words not in " ".join(told):
            assert more.wait(PATIENCE), told

    rehearsing.rehearse()
    used.settle()
    until_told("Situation conversation")
    dial = rehearsing.desk.dials["robot.stop"]
    dial.flag.setFocus()
    used.key(Qt.Key.Key_Space)
    until_told("Situation stopped")
    rehearsing.end()


def test_who_goes_to_another_moment_is_told_its_situation_by_no_news(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used, _ = opened(
        studio, project("conversation"), tmp_path / "run.mcap", "conversation", "fig5.jsonl"
    )
    viewing, told = used.window.robot.follower.viewing, hears(used)
    seen = set()
    for t in (1.0, 4.2, 1.0):
        viewing.seek(t)
        used.settle()
        seen.add(viewing.moment().situation)
    assert seen == {"conversation", "accepted"}
    assert not [words for words in told if "Situation" in words]
    used.window.commands.close_recording()


def test_a_dial_tells_its_value_with_its_unit(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    rehearsing = used.window.rehearsing
    rehearsing.clock = lambda: 0.0
    rehearsing.rehearse()
    used.settle()
    dial = rehearsing.desk.dials["person.direction"]
    told = hears(used)
    dial.slider.setFocus()
    used.key(Qt.Key.Key_Right)
    assert heard(dial.slider).role() == ROLE.Slider
    assert heard(dial.slider).text(DESCRIPTION) == dial.value.text()
    assert dial.value.text() in told
    assert ringed(dial.slider, used.window.theme.accent)
    rehearsing.end()


def test_of_the_robots_screen_an_arrow_tells_where_it_leads_alone(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    rehearsing = used.window.rehearsing
    rehearsing.clock = lambda: 0.0
    rehearsing.rehearse()
    used.settle()
    screen = rehearsing.desk.screen_
    assert "Hello. I am glad to see you" in heard(screen).text(DESCRIPTION)
    screen.setFocus()
    used.key(Qt.Key.Key_Down)
    assert heard(screen).text(DESCRIPTION) == screen.targets[0].words
    rehearsing.end()


def test_what_scrolls_is_no_stop_where_something_in_it_is(studio: Start, project: Copy) -> None:
    """It lies beside all that it holds: read line by line, Tab went round in it."""
    used = studio(project("conversation"))
    rehearsing = used.window.rehearsing
    rehearsing.clock = lambda: 0.0
    rehearsing.rehearse()
    used.settle()
    desk = rehearsing.desk
    every = stops(desk)
    assert desk not in every
    tops = [one.mapTo(desk.widget(), one.rect().center()).y() for one in every]
    assert all(below > above - 16 for above, below in pairwise(tops))
    rehearsing.end()


def ringed(widget: QWidget, colour: str) -> bool:
    """Whether its edge, as it is painted now, has that colour."""
    painted = widget.grab().toImage()
    # Above, where nothing of a slider's track is.
    middle = painted.width() // 2
    return any(painted.pixelColor(middle, y) == QColor(colour) for y in range(3))


def test_what_paints_itself_shows_that_it_has_the_keyboard(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    accent = used.window.theme.accent
    (ours,) = recorded(tmp_path, "reception", "known-user.jsonl")
    used.select("state", "7")
    row = used.window.inspector.form.findChildren(RowWidget)[0]
    used.window.robot.open_recording(ours)
    until_shown(used)
    used.window.bottom.choose("timeline")
    chart = used.window.robot.timeline.chart
    for widget, painted in ((row, row), (chart, chart.viewport())):
        assert not ringed(painted, accent)
        widget.setFocus()
        used.settle()
        assert ringed(painted, accent), widget
