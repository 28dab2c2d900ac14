"""Texts that are written where they stand on the screen, and tags that ``{`` completes."""

from __future__ import annotations

from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtGui import QInputMethodEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ_studio.panels.fields import Line, Paragraph

LEFT = Qt.MouseButton.LeftButton
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

Table = Any


def double(table: Table, at: QPoint) -> None:
    QTest.mouseClick(table.sheet, LEFT, pos=at)
    QTest.mouseDClick(table.sheet, LEFT, pos=at)
    table.used.settle()


def test_a_double_click_opens_the_text_in_its_box_and_enter_takes_it_as_one_step(
    table: Table,
) -> None:
    double(table, table.middle("measure"))
    field = table.sheet.writing.field
    assert field.hasFocus()
    box = table.sheet.area(table.sheet.own()["measure"]).toRect()
    assert (field.geometry().center() - box.center()).manhattanLength() <= 2
    assert field.document().defaultTextOption().alignment() == Qt.AlignmentFlag.AlignHCenter
    table.used.type("Pulse")
    assert table.component("measure").text == "MEASURE"
    table.used.key(Qt.Key.Key_Return)
    assert table.component("measure").text == "Pulse"
    assert table.used.session.undo_text == "Change text of measure"
    assert table.sheet.hasFocus()
    assert table.sheet.writing.field is None
    assert table.sheet.selected == ("measure",)
    table.used.key(Qt.Key.Key_Z, CONTROL)
    assert table.component("measure").text == "MEASURE"


def test_f2_opens_it_escape_leaves_what_was_and_leaving_it_takes_it(table: Table) -> None:
    before = table.document
    table.click("question")
    table.used.key(Qt.Key.Key_F2)
    table.used.type("nothing")
    table.used.key(Qt.Key.Key_Escape)
    assert table.document is before
    assert table.sheet.selected == ("question",)
    table.used.key(Qt.Key.Key_F2)
    table.used.key(Qt.Key.Key_End)
    table.used.key(Qt.Key.Key_Return, SHIFT)
    table.used.type("Choose.")
    table.click("heart")
    assert table.component("question").text == "What would you like to do?\nChoose."
    assert table.sheet.selected == ("heart",)
    # A button has one line.
    table.click("measure")
    table.used.key(Qt.Key.Key_F2)
    table.used.key(Qt.Key.Key_Return, SHIFT)
    assert table.sheet.writing.field is None
    assert table.component("measure").text == "MEASURE"


def test_letters_begin_another_text_and_a_picture_has_none(table: Table) -> None:
    before = table.document
    table.click("heart")
    table.used.type("x")
    assert table.sheet.writing.field is None
    table.click("goodbye")
    table.used.type("B")
    table.used.type("ye")
    table.used.key(Qt.Key.Key_Tab)
    assert table.component("goodbye").text == "Bye"
    table.used.key(Qt.Key.Key_Z, CONTROL)
    assert table.document == before


def test_an_input_method_begins_another_text_too(table: Table) -> None:
    table.click("goodbye")
    begun = QInputMethodEvent()
    begun.setCommitString("さようなら")
    QCoreApplication.sendEvent(table.sheet, begun)
    table.used.key(Qt.Key.Key_Return)
    assert table.component("goodbye").text == "さようなら"


def test_undo_and_save_take_what_is_being_written_first(table: Table) -> None:
    table.click("goodbye")
    table.used.type("B")
    table.used.type("ye")
    table.used.window.commands.save()
    assert table.component("goodbye").text == "Bye"
    assert not table.used.session.dirty


def test_a_brace_offers_tags_that_are_filtered_as_typed_and_taken_by_enter_or_tab(
    table: Table,
) -> None:
    table.click("question")
    table.used.key(Qt.Key.Key_F2)
    table.used.key(Qt.Key.Key_End)
    table.used.type(" {")
    tags = table.sheet.writing.field.tags
    assert {"user.name", "patients"} <= set(tags.offered)
    table.used.type("name")
    assert set(tags.offered) >= {"user.name"}
    assert "patients" not in tags.offered
    chosen = tags.offered[0]
    table.used.key(Qt.Key.Key_Tab)
    assert not tags.is_open
    assert table.sheet.writing.field.toPlainText() == f"What would you like to do? {{{chosen}}}"
    table.used.type(" {pat")
    table.used.key(Qt.Key.Key_Escape)
    assert not tags.is_open
    table.used.key(Qt.Key.Key_Return)
    assert table.component("question").text.endswith(f"{{{chosen}}} {{pat")


@pytest.mark.parametrize("made", [Line, Paragraph])
def test_a_field_of_a_form_completes_tags_as_the_screen_does(qt: QApplication, made: Any) -> None:
    field = made()
    field.complete_tags(("patients", "user.initials", "user.name"))
    field.show()
    field.activateWindow()
    field.setFocus()
    assert QTest.qWaitForWindowActive(field)
    QTest.keyClicks(field, "Hello {user")
    tags = field.tags
    assert tags.offered == ["user.initials", "user.name"]
    # The keys of a person go to the list, which hands on what it does not take.
    popup = QApplication.activePopupWidget()
    assert popup is not None
    QTest.keyClick(popup, Qt.Key.Key_Down)
    QTest.keyClick(popup, Qt.Key.Key_Return)
    text = field.text() if isinstance(field, Line) else field.toPlainText()
    assert text == "Hello {user.name}"
    QTest.keyClicks(field, "!")
    assert not tags.is_open
    field.close()
    field.deleteLater()


def test_in_the_inspector_a_brace_offers_the_tags_of_the_project(table: Table) -> None:
    table.click("question")
    table.used.key(Qt.Key.Key_Return)
    field = QApplication.focusWidget()
    assert isinstance(field, Paragraph)
    table.used.key(Qt.Key.Key_End)
    table.used.type(" {user.n")
    assert field.tags is not None
    assert "user.name" in field.tags.offered
    table.used.key(Qt.Key.Key_Return)
    table.used.key(Qt.Key.Key_Return, CONTROL)
    assert table.component("question").text == "What would you like to do? {user.name}"
