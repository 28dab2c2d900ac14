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

Page = Any
Table = Any


def double(page: Page, at: QPoint) -> None:
    QTest.mouseClick(page.sheet, LEFT, pos=at)
    QTest.mouseDClick(page.sheet, LEFT, pos=at)
    page.settle()


def test_a_double_click_opens_the_text_in_its_box_and_enter_takes_it_as_one_step(
    page: Page,
) -> None:
    double(page, page.middle("measure"))
    field = page.sheet.writing.field
    assert field.hasFocus()
    box = page.sheet.area(page.sheet.own()["measure"]).toRect()
    assert (field.geometry().center() - box.center()).manhattanLength() <= 2
    assert field.document().defaultTextOption().alignment() == Qt.AlignmentFlag.AlignHCenter
    page.type("Pulse")
    assert page.component("measure").text == "MEASURE"
    page.key(Qt.Key.Key_Return)
    assert page.component("measure").text == "Pulse"
    assert page.steps[-1] == "Change text of measure"
    assert page.sheet.hasFocus()
    assert page.sheet.writing.field is None
    assert page.sheet.selected == ("measure",)
    page.undo()
    assert page.component("measure").text == "MEASURE"


def test_f2_opens_it_escape_leaves_what_was_and_leaving_it_takes_it(page: Page) -> None:
    before = page.document
    page.click("question")
    page.key(Qt.Key.Key_F2)
    page.type("nothing")
    page.key(Qt.Key.Key_Escape)
    assert page.document is before
    assert page.sheet.selected == ("question",)
    page.key(Qt.Key.Key_F2)
    page.key(Qt.Key.Key_End)
    page.key(Qt.Key.Key_Return, SHIFT)
    page.type("Choose.")
    page.click("heart")
    assert page.component("question").text == "What would you like to do?\nChoose."
    assert page.sheet.selected == ("heart",)
    # A button has one line.
    page.click("measure")
    page.key(Qt.Key.Key_F2)
    page.key(Qt.Key.Key_Return, SHIFT)
    assert page.sheet.writing.field is None
    assert page.component("measure").text == "MEASURE"


def test_letters_begin_another_text_and_a_picture_has_none(page: Page) -> None:
    before = page.document
    page.click("heart")
    page.type("x")
    assert page.sheet.writing.field is None
    page.click("goodbye")
    page.type("B")
    page.type("ye")
    page.key(Qt.Key.Key_Tab)
    assert page.component("goodbye").text == "Bye"
    page.undo()
    assert page.document == before


def test_an_input_method_begins_another_text_too(page: Page) -> None:
    page.click("goodbye")
    QCoreApplication.sendEvent(page.sheet, QInputMethodEvent())
    assert page.sheet.writing.field is None
    begun = QInputMethodEvent()
    begun.setCommitString("さようなら")
    QCoreApplication.sendEvent(page.sheet, begun)
    page.key(Qt.Key.Key_Return)
    assert page.component("goodbye").text == "さようなら"


def test_undo_and_save_take_what_is_being_written_first(table: Table) -> None:
    table.click("goodbye")
    table.used.type("B")
    table.used.type("ye")
    table.used.window.commands.save()
    assert table.component("goodbye").text == "Bye"
    assert not table.used.session.dirty


def test_a_brace_offers_tags_that_are_filtered_as_typed_and_taken_by_enter_or_tab(
    page: Page,
) -> None:
    page.sheet.offer_tags(("language", "patients", "user.name"))
    page.click("question")
    page.key(Qt.Key.Key_F2)
    page.key(Qt.Key.Key_End)
    page.type(" {")
    tags = page.sheet.writing.field.tags
    assert tags.offered == ["language", "patients", "user.name"]
    page.type("NA")
    assert tags.offered == ["user.name"]
    page.key(Qt.Key.Key_Tab)
    assert not tags.is_open
    assert page.sheet.writing.field.toPlainText() == "What would you like to do? {user.name}"
    page.type(" {pat")
    page.key(Qt.Key.Key_Escape)
    assert not tags.is_open
    page.key(Qt.Key.Key_Return)
    assert page.component("question").text == "What would you like to do? {user.name} {pat"


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


def test_in_a_list_the_entry_is_offered_first_and_an_empty_label_is_the_entry(page: Page) -> None:
    page.sheet.offer_tags(("patients",))
    page.drop("list", page.at(50, 50))
    made = page.components[-1].id
    page.sheet.open(made)
    page.type("{")
    assert page.sheet.writing.field.tags.offered == ["item", "patients"]
    page.key(Qt.Key.Key_Return)
    page.type("!")
    page.key(Qt.Key.Key_Return)
    assert page.component(made).label == "{item}!"
    page.sheet.open(made)
    page.key(Qt.Key.Key_Delete)
    page.key(Qt.Key.Key_Return)
    assert page.component(made).label == "{item}"


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
