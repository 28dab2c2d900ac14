"""The forms of the inspector: lists, conditions, priorities, pairs, screens."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFrame, QScrollBar

from situ_studio.edits import places
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.conditions import AddTest

CONTROL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
LEFT = Qt.MouseButton.LeftButton
FILE = "reception.rbd.xml"
SCRIPT = "conversation.spds.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def form(used: Any) -> Any:
    return used.window.inspector.form


def value(used: Any, *place: str, file: str = FILE) -> Any:
    return places.get(used.session.document(file), place)


def test_a_row_opens_its_form_and_back_returns(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "7")
    used.click(form(used).section("actions").rows.row(1))
    assert used.window.inspector.place == ("state", "7", "action", "1")
    assert form(used).kind.name == "service"
    used.click(used.window.inspector._back)
    assert used.window.inspector.place == ("state", "7")


def test_a_state_that_runs_a_part_has_a_form_of_its_own(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "16")
    assert form(used).kind.name == "part"
    assert form(used).field("flow").text() == "register.rbd.xml"
    used.fill(form(used).field("flow"), "learn.rbd.xml")
    assert value(used, "state", "16").flow == "learn.rbd.xml"
    used.fill(form(used).field("flow"), "")
    assert value(used, "state", "16").flow == "learn.rbd.xml"
    used.select("state", "15")
    assert form(used).kind.name == "state"


def test_a_note_without_a_colour_shows_the_usual_one(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("note", "0")
    assert value(used, "note", "0").color == ""
    assert form(used).field("color").currentText() == "The usual"


def test_a_form_too_high_for_its_panel_is_as_wide_as_the_others(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.select("state", "16")
    low = form(used)
    (bar,) = [b for b in used.window.inspector.findChildren(QScrollBar) if b.width() < b.height()]
    width = low.width()
    assert not bar.isVisible()
    used.select("state", "7")
    assert form(used).height() > used.window.inspector.height()
    assert bar.isVisible()
    assert form(used).width() == width

    top = form(used).y()
    QTest.mouseClick(bar, LEFT, pos=QPoint(5, bar.height() - 4))
    assert form(used).y() < top


def test_lines_of_a_long_note_end_before_its_bar_where_panels_come_back_as_they_were(
    studio: Start, project: Copy
) -> None:
    path = project("reception")
    studio(path).window.close()
    note = form(studio(path)).field("note")
    block = note.document().firstBlock().layout()
    room = note.viewport().width() - 2 * note.document().documentMargin()
    assert note.verticalScrollBar().isVisible()
    assert {block.lineAt(at).width() for at in range(block.lineCount())} == {room}


def test_a_field_of_several_lines_stays_in_its_place_where_it_gets_the_focus(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    note, name = form(used).field("note"), form(used).field("name")
    used.click(name)
    before = note.viewport().geometry()
    assert note.grab().toImage().pixelColor(note.width() // 2, 0) == LIGHT.color("line")
    used.click(note)
    assert note.hasFocus()
    assert note.viewport().geometry() == before


def test_rows_are_moved_by_keys(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "7")
    first, second = value(used, "state", "7").actions[:2]
    rows = form(used).section("actions").rows
    rows.row(0).setFocus()
    used.key(Qt.Key.Key_Down, ALT)
    assert value(used, "state", "7").actions[:2] == (second, first)
    assert used.session.undo_text == "Move speech of state 7"
    assert rows.row(1).hasFocus()


def test_rows_are_moved_by_the_mouse(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "7")
    events = value(used, "state", "7").events
    rows = form(used).section("events").rows
    used.window.inspector._scroll.ensureWidgetVisible(rows.row(2))
    used.settle()
    row = rows.row(0)
    start, end = QPoint(12, 12), QPoint(12, rows.row(2).y() - row.y() + rows.row(2).height() - 2)
    QTest.mousePress(row, LEFT, pos=start)
    for step in range(1, 6):
        QTest.mouseMove(row, start + (end - start) * step / 5)
        used.settle()
    QTest.mouseRelease(row, LEFT, pos=end)
    used.settle()
    assert value(used, "state", "7").events == (*events[1:3], events[0], *events[3:])


def test_a_row_is_removed_by_a_key(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "7")
    events = value(used, "state", "7").events
    form(used).section("events").rows.row(0).setFocus()
    used.key(Qt.Key.Key_Delete)
    assert value(used, "state", "7").events == events[1:]
    assert used.session.undo_text == f"Remove event {events[0].name} of state 7"


def test_delete_in_a_form_never_deletes_the_state(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    form(used)._timeout.next.setFocus()
    used.key(Qt.Key.Key_Delete)
    assert value(used, "state", "2") is not None


def test_an_action_is_added_from_the_menu(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    section = form(used).section("actions")
    menu = section.add.menu()
    menu.aboutToShow.emit()
    titles = [a.text() for a in menu.actions()]
    assert "Message" in titles
    assert "Say again" not in titles
    menu.actions()[titles.index("Message")].trigger()
    used.settle()
    assert form(used).kind.name == "message"
    used.fill(form(used).field("topic"), "nurse/help")
    assert value(used, "state", "2").actions[-1].topic == "nurse/help"


def test_values_sent_are_edited_in_place(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "7", "action", "1")
    pairs = form(used).section("params").pairs
    used.fill(pairs.field(0, 1), "{user.first}")
    pairs.add()
    used.settle()
    used.type("room")
    used.key(Qt.Key.Key_Return)
    params = value(used, "state", "7", "action", "1").params
    assert params[0].text == "{user.first}"
    assert params[-1].name == "room"
    used.click(pairs._extra[0])
    assert value(used, "state", "7", "action", "1").params == params[1:]


def test_phrases_are_added(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2", "event", "0")
    before = len(value(used, "state", "2", "event", "0").says)
    form(used).section("says").pairs.add()
    used.settle()
    used.type("carry on")
    used.key(Qt.Key.Key_Return)
    says = value(used, "state", "2", "event", "0").says
    assert [s.text for s in says[before:]] == ["carry on"]


def test_a_condition_is_edited_as_rows(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.open_file(SCRIPT)
    used.select("situation", "sound")
    editor = form(used).section("condition").condition
    box = editor.box(0)
    used.fill(box.within, "2.5")
    used.choose(box.test, "above")
    used.fill(box.value, "30")
    test = value(used, "situation", "sound", "condition", "0", file=SCRIPT)
    assert (test.tag, test.test, test.value, test.within) == ("sound.slap", "above", "30", 2.5)
    assert used.session.problems == []


def test_a_condition_gets_and_loses_tests_and_groups(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.open_file(SCRIPT)
    used.select("situation", "sound")
    editor = form(used).section("until").condition
    editor.add("any")
    used.settle()
    editor.add("test", (0,))
    editor.add("test", (0,))
    used.settle()
    until = value(used, "situation", "sound", file=SCRIPT).until
    assert until.children[0].kind == "any"
    assert len(until.children[0].children) == 2
    editor.box(0, 1).removed.emit()
    editor.box(0, 0).removed.emit()
    used.settle()
    assert value(used, "situation", "sound", file=SCRIPT).until is None


def test_a_group_in_a_group_begins_with_nothing_that_nobody_asked_for(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    used.window.open_file(SCRIPT)
    used.select("situation", "sound")
    editor = form(used).section("until").condition
    before = used.session.document(SCRIPT)

    def until() -> Any:
        return value(used, "situation", "sound", file=SCRIPT).until

    # Groups by keys alone: each is empty, and the cursor at what puts something into it.
    editor.add("any")
    used.settle()
    for down in (2, 4):
        plus = QApplication.focusWidget()
        assert isinstance(plus, AddTest)
        # The button's menu: a test, all, any, none.
        QTimer.singleShot(0, lambda n=down: choose_in_menu(used, n))
        QTest.keyClick(plus, Qt.Key.Key_Space)
        used.settle()
    assert editor.box(0, 0, 0).kind.currentText() == "none of these"
    assert editor.box(0, 0, 0).empty.isVisible()
    # Nothing of that is in the file, where a group without a test is an error.
    assert used.session.document(SCRIPT) is before
    assert used.session.undo_text is None
    editor.add("test", (0, 0, 0))
    used.settle()
    (outer,) = until().children
    assert [outer.kind, outer.children[0].kind] == ["any", "all"]
    (inner,) = outer.children[0].children
    assert inner.kind == "none"
    assert [one.test for one in inner.children] == ["exists"]
    # One that stays empty is forgotten when something else is looked at, not taken along.
    editor.add("any", (0,))
    used.settle()
    assert editor.box(0, 1).empty.isVisible()
    editor.box(0, 0, 0, 0).removed.emit()
    used.settle()
    assert until() is None
    assert editor.box(0, 0).empty.isVisible()
    used.select("situation", "conversation")
    used.select("situation", "sound")
    assert not form(used).section("until").condition.isVisible()
    used.window.actions_.actions["undo"].trigger()
    used.settle()
    assert len(until().children) == 1


def test_a_group_that_is_empty_yet_is_not_taken_along_to_another_document(
    studio: Start, tmp_path: Path
) -> None:
    for name in ("a", "b"):
        (tmp_path / f"{name}.rbd.xml").write_text(
            f'<application name="{name}" start="1"><state no="1" name="One">'
            '<expectedevents><event name="go" next="1"/></expectedevents></state></application>'
        )
    (tmp_path / "situ.toml").write_text(
        '[project]\nname = "ward"\napplications = ["a.rbd.xml", "b.rbd.xml"]\n'
        '[robot]\nadapter = "sim"\n'
    )
    used = studio(tmp_path)
    for file in ("b.rbd.xml", "a.rbd.xml"):
        used.window.open_file(file)
        used.select("state", "1", "event", "0")
    form(used).section("when").condition.add("any")
    used.settle()
    assert form(used).section("when").condition.isVisible()
    # Another edit of the same thing leaves it.
    used.fill(form(used).field("name"), "on")
    used.settle()
    assert form(used).section("when").condition.isVisible()
    used.window.open_file("b.rbd.xml")
    used.settle()
    assert used.window.current_view.selected == (("state", "1", "event", "0"),)
    assert not form(used).section("when").condition.isVisible()


def choose_in_menu(used: Any, down: int) -> None:
    menu = QApplication.activePopupWidget()
    assert menu is not None
    for _ in range(down):
        QTest.keyClick(menu, Qt.Key.Key_Down)
    QTest.keyClick(menu, Qt.Key.Key_Return)


def test_missing_is_a_test_of_its_own(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.open_file(SCRIPT)
    used.select("situation", "sound")
    box = form(used).section("condition").condition.box(0)
    used.choose(box.test, "is missing")
    test = value(used, "situation", "sound", "condition", "0", file=SCRIPT)
    assert (test.test, test.value) == ("exists", "false")
    assert not box.value.isVisible()


def test_what_a_test_or_a_priority_can_not_be_is_said_in_one_line(
    studio: Start, project: Copy
) -> None:
    """Below, where a person looks who typed it, and what was there comes back."""
    used = studio(project("conversation"))
    used.window.open_file(SCRIPT)
    used.select("situation", "sound")
    said = used.window.status.said
    before = used.session.document(SCRIPT)
    box = form(used).section("condition").condition.box(0)
    for field, typed, why in (
        (box.within, "0", "Write a number above 0."),
        (box.hold, "long", "Write a number."),
        (form(used).section("entries").priorities.row(0)[1], "high", "Write a whole number."),
    ):
        used.window.say("")
        used.fill(field, typed)
        assert said.text() == why
    value_of = used.session.document(SCRIPT).situation("sound").condition.children[0]
    heat = replace(value_of, test="above", value="3")
    box.show_test(heat, Vocabulary(data=((heat.tag, "number", ""),)))
    used.window.say("")
    used.fill(box.value, "warm")
    assert said.text() == "Write a number."
    assert used.session.document(SCRIPT) is before


def test_priorities_are_edited_and_added(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.open_file(SCRIPT)
    used.select("situation", "sound")
    editor = form(used).section("entries").priorities
    used.fill(editor.row(0)[1], "65")
    editor.add()
    used.settle()
    used.fill(editor.row(1)[1], "")
    entries = value(used, "situation", "sound", file=SCRIPT).entries
    assert entries[0].priority == 65
    assert entries[1].priority is None


def test_the_screen_is_opened_and_a_component_edited(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    used.click(form(used).section("screen").preview)
    assert used.window.current_view.shown_as == "screen"
    assert form(used).kind.name == "screen"
    components = value(used, "state", "2", "screen").components
    rows = form(used).section("components").rows
    index = next(i for i, c in enumerate(components) if c.element == "button")
    used.click(rows.row(index))
    name = components[index].id
    used.fill(form(used).field("x"), "40.5")
    assert value(used, "state", "2", "screen", name).x == 40.5
    used.fill(form(used).field("id"), "onward")
    assert used.window.inspector.place == ("state", "2", "screen", "onward")


def test_what_must_not_be_empty_goes_back(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "7", "action", "1")
    field = form(used).field("name")
    shown = field.text()
    used.fill(field, "")
    assert field.text() == shown
    assert field.toolTip() == "This can not be left empty."
    assert used.session.undo_text is None


def test_a_speech_of_several_lines_is_one_edit(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2", "action", "0")
    while form(used).kind.name != "speech":
        number = int(used.window.inspector.place[3]) + 1
        used.select("state", "2", "action", str(number))
    field = form(used).field("text")
    used.click(field)
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("Good day.")
    used.key(Qt.Key.Key_Return)
    used.type("Who are you?")
    field.clearFocus()
    used.settle()
    assert value(used, *used.window.inspector.place).text == "Good day.\nWho are you?"
    assert used.session.undo_text == "Change says of speech of state 2"


def test_module_information_has_forms_too(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.open_file("modules.xml")
    assert used.window.current_view.mode == "outline"
    used.select("module", "nod")
    used.fill(form(used).field("resources"), "head, base")
    module = value(used, "module", "nod", file="modules.xml")
    assert module.resources == ("head", "base")


def test_every_field_has_an_accessible_name(studio: Start, project: Copy) -> None:
    from PySide6.QtWidgets import QAbstractButton, QComboBox, QLineEdit, QPlainTextEdit

    used = studio(project("conversation"))
    for file, place in (
        (SCRIPT, ("situation", "invited")),
        ("converse.rbd.xml", ("state", "1")),
        ("modules.xml", ("module", "nod")),
    ):
        used.window.open_file(file)
        used.window.select(place)
        used.settle()
        for kind in (QAbstractButton, QComboBox, QLineEdit, QPlainTextEdit):
            for widget in used.window.findChildren(kind):
                inner = isinstance(widget.parent(), QComboBox)
                if inner or not widget.isVisible() or widget.objectName().startswith("qt_"):
                    continue  # a part of another widget, or Qt's own
                words = getattr(widget, "text", str)()
                assert widget.accessibleName() or words, (place, widget, widget.parent())


def test_a_drop_from_the_palette_makes_a_state_on_the_canvas(studio: Start, project: Copy) -> None:
    from PySide6.QtCore import QMimeData, QPointF
    from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent

    from situ_studio.kinds import MIME

    used = studio(project("reception"))
    port = used.window.current_view.canvas.viewer.viewport()
    count = len(used.session.document(FILE).states)
    data = QMimeData()
    data.setData(MIME, b"state")
    at = QPoint(port.width() - 60, 60)
    action, none = Qt.DropAction.CopyAction, Qt.KeyboardModifier.NoModifier
    for event in (
        QDragEnterEvent(at, action, data, LEFT, none),
        QDragMoveEvent(at, action, data, LEFT, none),
        QDropEvent(QPointF(at), action, data, LEFT, none),
    ):
        QApplication.sendEvent(port, event)
    used.settle()
    document = used.session.document(FILE)
    assert len(document.states) == count + 1
    assert used.window.current_view.selected == (("state", document.states[-1].no),)


def test_a_test_is_edited_in_the_words_of_its_data(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.open_file(SCRIPT)
    # Of a list, what stands in it; as on the canvas.
    place: tuple[str, ...] = ("situation", "invited", "until", "0", "0")
    used.select(*place)
    field = form(used).field("value")
    assert field.text() == "arrived, failed"
    used.fill(field, "arrived, failed, lost")
    assert value(used, *place, file=SCRIPT).value == '["arrived", "failed", "lost"]'
    # Of yes or no, which.
    place = ("situation", "stopped", "condition", "0")
    used.select(*place)
    field = form(used).field("value")
    assert field.currentText() == "yes"
    used.choose(field, "no")
    assert value(used, *place, file=SCRIPT).value == "false"
    assert used.session.undo_text == "Change condition of situation stopped"
    # Of a number, a number with its unit.
    place = ("situation", "sound", "condition", "0")
    used.select(*place)
    used.choose(form(used).field("test"), "above")
    box = form(used).findChild(QFrame, "testBox")
    assert box.unit.text() == "deg"
    used.fill(form(used).field("value"), "loud")
    assert used.window.status.said.text() == "Write a number."
    assert value(used, *place, file=SCRIPT).value == "0"
    used.fill(form(used).field("value"), "2,50")
    assert value(used, *place, file=SCRIPT).value == "2.5"
    assert used.session.problems == []
