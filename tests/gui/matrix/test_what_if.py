"""*What if*: values and requests that somebody supposes, and what follows at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QFont, QFontDatabase, QTextCursor, QTextDocument, QTextDocumentFragment
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QMenu
from tests.gui.matrix.conftest import TIED, Desk, read

from situ.document.project import Project
from situ_studio.canvas.live import LiveScript
from situ_studio.looks.theme import FAMILY
from situ_studio.matrix.chips import Chip

Make = Callable[..., Desk]
DOWN = Qt.Orientation.Vertical
HEARD = Qt.ItemDataRole.AccessibleTextRole


def chip(used: Desk, name: str) -> Chip:
    return next(c for c in used.view.what_if.findChildren(Chip) if c.name == name)


def press(used: Desk, name: str) -> None:
    QTest.mouseClick(chip(used, name), Qt.MouseButton.LeftButton, pos=QPoint(12, 12))
    used.settle()


def answer(used: Desk) -> tuple[str, str]:
    strip = used.view.what_if
    plain = QTextDocumentFragment.fromHtml(strip.holders.text()).toPlainText()
    return strip.situation.text(), plain


def marked(used: Desk) -> list[Any]:
    """The situations that are marked as current, or as holding."""
    model = used.view.model
    heard = [model.headerData(row, DOWN, HEARD) for row in range(model.rowCount())]
    return [text for text in heard if "current" in text or "holds" in text]


def open_menu(used: Desk, name: str) -> QMenu:
    """By keys, as who has no mouse does it."""
    chip(used, name).setFocus()
    QTest.keyClick(chip(used, name), Qt.Key.Key_Down)
    used.settle()
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    return menu


def test_a_supposed_value_says_the_situation_and_who_holds_what_at_once(desk: Make) -> None:
    used = desk()
    assert answer(used)[0] == "conversation"
    assert marked(used) == [], "nothing is supposed"
    press(used, "sound.slap")
    assert answer(used) == (
        "sound",
        "head: gaze-sound, speech and screen: converse, base: nobody",
    )
    assert marked(used) == [
        "4 sound, current, its condition holds",
        "6 conversation, its condition holds",
    ]
    press(used, "person.calling")
    assert answer(used)[0] == "called"
    press(used, "hand.waving")
    assert answer(used) == ("invited", "base and head: transfer, speech and screen: nobody")
    press(used, "robot.stop")
    assert answer(used)[0] == "stopped"
    press(used, "robot.stop")
    assert answer(used)[0] == "invited"
    assert used.steps == [], "nothing of it is in the document"


def test_a_holder_stands_in_a_weight_that_the_typeface_has(desk: Make) -> None:
    """Qt smears the letters of a bolder one."""
    used = desk()
    press(used, "sound.slap")
    letters = used.view.what_if.holders
    told = QTextDocument()
    told.setHtml(letters.text())
    cursor = QTextCursor(told)
    cursor.setPosition(told.toPlainText().index("gaze-sound") + 1)
    weight = cursor.charFormat().fontWeight()
    styles = QFontDatabase.styles(FAMILY)
    assert weight > QFont.Weight.Medium
    assert weight in {QFontDatabase.weight(FAMILY, one) for one in styles}


def test_a_robots_situation_is_marked_where_nothing_is_supposed(desk: Make) -> None:
    used = desk()
    used.view.set_live(LiveScript("accepted", frozenset({"accepted", "conversation"})))
    assert marked(used)[0] == "5 accepted, current, its condition holds"
    press(used, "sound.slap")
    assert marked(used)[0].startswith("4 sound, current")
    press(used, "sound.slap")
    assert marked(used)[0].startswith("5 accepted, current")
    used.view.set_live(None)
    assert marked(used) == []


def test_a_change_of_the_script_is_judged_with_what_is_supposed(desk: Make) -> None:
    used = desk()
    press(used, "sound.slap")
    used.click("sound", "nod")
    used.type("99")
    used.key(Qt.Key.Key_Return)
    assert answer(used)[1].startswith("head: nod")
    used.undo()
    assert answer(used)[1].startswith("head: gaze-sound")


def test_true_is_not_one_and_a_condition_that_is_changed_is_judged_anew(desk: Make) -> None:
    text = (
        '<spds name="s"><situation name="{}"><condition><data tag="t" is="{}"/></condition>'
        '</situation><situation name="else"/></spds>'
    )
    used = desk(read(text.format("one", "1")))
    used.view.what_if.suppose("t", True)
    assert answer(used)[0] == "else"
    used.view.what_if.suppose("t", 1)
    assert answer(used)[0] == "one"
    used.open(read(text.format("two", "2")))
    assert answer(used)[0] == "else"
    used.open(read(text.format("uno", "1")))
    assert answer(used)[0] == "uno"


def test_modules_that_do_not_ask_hold_nothing(desk: Make) -> None:
    used = desk()
    press(used, "sound.slap")
    asks = used.view.what_if.asks
    QTest.mouseClick(asks, Qt.MouseButton.LeftButton)
    used.settle()
    press(used, "gaze-sound")
    assert answer(used)[1].startswith("head: chase-face")
    assert asks.shown == "5 of 6 ask"
    press(used, "chase-face")
    assert answer(used)[1] == "speech and screen: converse, base and head: nobody"
    QTest.mouseClick(used.view.what_if.reset, Qt.MouseButton.LeftButton)
    used.settle()
    assert (asks.shown, answer(used)[0]) == ("all ask", "conversation")


def test_a_tie_is_told_with_those_between_whom_the_order_decides(desk: Make) -> None:
    used = desk(TIED)
    press(used, "asked")
    assert answer(used) == ("asked", "head: a tie, nod or chase, base: nobody")


def test_other_values_are_chosen_from_the_menu_or_typed(desk: Make) -> None:
    used = desk(
        read(
            '<spds name="s"><observe><data tag="near" type="number"/>'
            '<data tag="on" type="boolean"/><data tag="wish" type="string"/></observe>'
            '<situation name="close"><condition><data tag="near" below="1.5" for="2"/>'
            '</condition></situation><situation name="off"><condition><data tag="on" is="false"/>'
            '</condition></situation><situation name="served"><condition>'
            '<data tag="wish" is="tea &amp; cake"/></condition></situation>'
            '<situation name="else"/></spds>'
        )
    )
    # In a menu a single ampersand is not seen.
    menu = open_menu(used, "wish")
    assert "tea && cake" in [a.text() for a in menu.actions()]
    menu.close()
    used.settle()
    menu = open_menu(used, "near")
    texts = [a.text() for a in menu.actions() if a.text()]
    assert texts == ["not set", "1.35", "1.65"]
    for _ in range(2):
        QTest.keyClick(menu, Qt.Key.Key_Down)
    QTest.keyClick(menu, Qt.Key.Key_Return)
    used.settle()
    assert chip(used, "near").shown == "near: 1.35"
    assert answer(used)[0] == "close"
    menu = open_menu(used, "near")
    line = menu.findChild(QLineEdit)
    assert isinstance(line, QLineEdit)
    line.setFocus()
    QTest.keyClicks(line, "7")
    QTest.keyClick(line, Qt.Key.Key_Return)
    used.settle()
    assert chip(used, "near").accessibleName() == "near: 7"
    assert answer(used)[0] == "else"
    press(used, "on")
    assert chip(used, "on").shown == "on: false"
    assert answer(used)[0] == "off"


def test_what_the_project_sets_at_the_start_is_so_until_something_else_is_supposed(
    desk: Make, conversation: Project
) -> None:
    conversation.tags["robot.stop"] = True
    conversation.tags["of.nobody"] = 3
    used = desk()
    assert answer(used)[0] == "stopped"
    assert chip(used, "robot.stop").isChecked()
    assert marked(used) == [], "that is the start"
    press(used, "robot.stop")
    assert answer(used)[0] == "conversation"
    assert marked(used) == ["6 conversation, current, its condition holds"]
    press(used, "robot.stop")
    assert marked(used) == []
    assert used.view.what_if.values == {"robot.stop": True}


def test_the_strip_takes_no_more_room_than_there_is(desk: Make) -> None:
    used = desk()
    view = used.view
    for width in (1600, 900, 420, 1600):
        view.resize(width, 420)
        used.settle()
        assert view.width() == width
        beside = view.what_if.holders.y() == view.what_if.data.y()
        assert beside == (width == 1600)
        assert view.what_if.asks.geometry().right() <= width


def test_in_the_least_height_values_and_answer_have_a_line_each_and_cover_nothing(
    desk: Make,
) -> None:
    used = desk()
    view, strip = used.view, used.view.what_if
    press(used, "robot.stop")
    for high in (view.minimumHeight(), 600):
        view.resize(420, high)
        used.settle()
        shown = strip.holders if high == 600 else strip.holders_short
        assert shown.isVisible()
        both = {strip.holders, strip.holders_short}
        assert [one.isVisible() for one in both - {shown}] == [False]
        assert strip.data.geometry().bottom() < shown.geometry().top()
        assert view.sides.geometry().bottom() < strip.geometry().top()
        assert shown.geometry().bottom() < strip.height() <= view.height() - strip.y()
        assert strip.data.height() >= chip(used, "robot.stop").height()
    assert answer(used)[1] == strip.holders_short.text()


def test_a_table_of_values_and_a_list_are_supposed_as_others_are(desk: Make) -> None:
    used = desk(
        read(
            '<spds name="s"><observe><data tag="call" type="object"/>'
            '<data tag="due" type="list"/></observe>'
            '<situation name="called"><condition><data tag="call" exists="true"/></condition>'
            '</situation><situation name="late"><condition><data tag="due" exists="true"/>'
            '</condition></situation><situation name="all"/></spds>'
        )
    )
    press(used, "due")
    assert (used.view.what_if.values, answer(used)[0]) == ({"due": []}, "late")
    press(used, "call")
    assert (used.view.what_if.values, answer(used)[0]) == ({"call": {}, "due": []}, "called")


def test_where_no_situation_looks_at_data_it_says_so_instead_of_an_empty_place(
    desk: Make,
) -> None:
    used = desk(TIED)
    strip = used.view.what_if
    assert not strip.nothing.isVisible()
    used.open(read('<spds name="s"><situation name="all"/></spds>'))
    used.settle()
    assert strip.nothing.isVisible()
    gap = strip.situation.mapTo(strip, QPoint()).x() - strip.nothing.geometry().right()
    assert gap < 64


def test_what_is_supposed_of_data_that_nobody_looks_at_any_more_is_forgotten(desk: Make) -> None:
    used = desk(TIED)
    press(used, "asked")
    used.open(read('<spds name="s"><situation name="all"/></spds>'))
    assert used.view.what_if.values == {}
    assert answer(used) == ("all", "nobody asks")
