"""The matrix in use: real keys and mouse, as in a spreadsheet."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QMimeData, QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QPushButton
from tests.gui.matrix.conftest import TIED, Desk, read

from situ.document.project import Project
from situ.document.spds import Spds
from situ_studio.matrix.table import Area

Make = Callable[..., Desk]
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
TIP = Qt.ItemDataRole.ToolTipRole
HEARD = Qt.ItemDataRole.AccessibleTextRole
ENTER, TAB, DELETE, ESCAPE = Qt.Key.Key_Return, Qt.Key.Key_Tab, Qt.Key.Key_Delete, Qt.Key.Key_Escape
UP, DOWN, LEFT, RIGHT = Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Left, Qt.Key.Key_Right


def own(script: Spds, situation: str) -> dict[str, int | None]:
    found = script.situation(situation)
    assert found is not None
    return {entry.module: entry.priority for entry in found.entries}


def clipboard() -> Any:
    return QGuiApplication.clipboard()


# -- what is shown -----------------------------------------------------------------


def test_cells_say_own_and_taken_over_priorities_and_who_holds_what(desk: Make) -> None:
    used = desk()
    assert used.text("invited", "transfer") == "90"
    assert used.text("sound", "converse") == "30"
    assert used.said_of("sound", "converse", TIP) == "Taken over from conversation."
    assert used.text("stopped", "converse") == ""
    holders = [used.text("sound", one) for one in ("base", "head", "speech", "screen")]
    assert holders == ["nobody", "gaze-sound", "converse", "converse"]
    assert used.text("invited", "base") == used.text("invited", "head") == "transfer"
    heard = used.said_of("sound", "converse", HEARD)
    assert heard == "priority of converse in sound: 30, taken over from conversation"
    assert used.said_of("sound", "head", HEARD) == "head in sound, when all ask: gaze-sound"
    assert used.said_of("stopped", "nod", HEARD) == "priority of nod in stopped: nothing"


def test_ties_what_is_taken_away_and_modules_that_never_win_are_told(desk: Make) -> None:
    used = desk(TIED, problems=True)
    assert used.text("asked", "head") == "tie"
    assert (
        used.said_of("asked", "nod", HEARD) == "priority of nod in asked: 20, tie, with a problem"
    )
    assert "who asked first" in used.said_of("asked", "nod", TIP)
    assert used.said_of("asked", "chase", HEARD).endswith("20, taken over from all, tie")
    assert "nod, chase" in used.said_of("asked", "head", TIP)
    assert used.text("quiet", "chase") == "none"
    assert used.said_of("quiet", "chase", TIP).startswith("Taken away here: chase can hold nothing")
    assert used.text("quiet", "head") == "nobody"
    heads = [used.view.model.headerData(c, Qt.Orientation.Horizontal, HEARD) for c in range(3)]
    assert heads == ["nod", "chase", "idle, with a problem"]
    tip = used.view.model.headerData(2, Qt.Orientation.Horizontal, TIP)
    assert "can never hold authority" in tip


def test_a_shadowed_situation_is_marked_at_its_name(desk: Make) -> None:
    used = desk(
        read(
            '<spds name="s"><situation name="first"><condition><data tag="t" is="1"/></condition>'
            '</situation><situation name="second"><condition><data tag="t" is="1"/></condition>'
            '</situation><situation name="last"/></spds>'
        ),
        problems=True,
    )
    model, down = used.view.model, Qt.Orientation.Vertical
    never = ["never current" in model.headerData(row, down, TIP) for row in range(3)]
    assert never == [False, True, False]
    assert model.headerData(1, down, HEARD) == "2 second, with a problem"
    assert model.headerData(2, down, HEARD) == "3 last"


def test_modules_of_the_module_information_have_a_column_where_they_use_a_resource(
    desk: Make, conversation: Project
) -> None:
    used = desk()
    assert conversation.spds is not None
    declared = tuple(m.name for m in conversation.spds.modules)
    assert used.view.model.modules == declared, "detectors use nothing"


# -- keys ---------------------------------------------------------------------------


def test_typing_writes_over_a_cell_and_enter_and_tab_go_on(desk: Make) -> None:
    used = desk()
    used.click("sound", "nod")
    used.type("45")
    used.key(ENTER)
    assert own(used.document, "sound") == {"gaze-sound": 60, "nod": 45}
    assert used.steps == ["Give nod the priority 45 in sound"]
    assert used.area() == Area(*used.at("accepted", "nod"))
    used.type("7")
    used.key(TAB)
    assert own(used.document, "accepted") == {"nod": 7}
    assert used.area() == Area(*used.at("accepted", "converse"))
    used.type("8")
    used.key(LEFT)
    assert own(used.document, "accepted") == {"nod": 7, "converse": 8}
    used.key(ENTER, SHIFT)
    assert used.area() == Area(*used.at("sound", "nod"))


def test_f2_opens_a_cell_with_its_text_and_arrows_move_in_it_then(desk: Make) -> None:
    used = desk()
    used.click("invited", "transfer")
    used.key(Qt.Key.Key_F2)
    editor = QApplication.focusWidget()
    assert isinstance(editor, QLineEdit)
    assert editor.text() == "90"
    used.key(RIGHT)
    used.type("1")
    used.key(LEFT)
    assert editor.text() == "901"
    used.key(ESCAPE)
    assert used.steps == []
    assert own(used.document, "invited") == {"transfer": 90}


def test_a_cell_left_as_it_was_changes_nothing_also_where_it_is_taken_over(desk: Make) -> None:
    used = desk()
    used.click("sound", "converse")
    used.key(Qt.Key.Key_F2)
    used.key(ENTER)
    assert used.steps == []
    used.click("sound", "converse")
    used.type("30")
    used.key(ENTER)
    assert own(used.document, "sound") == {"gaze-sound": 60, "converse": 30}


def test_a_bad_text_stays_in_its_cell_with_a_sentence_until_it_is_mended(desk: Make) -> None:
    used = desk()
    used.click("sound", "nod")
    used.type("high")
    used.key(ENTER)
    editor = QApplication.focusWidget()
    assert isinstance(editor, QLineEdit)
    assert editor.text() == "high"
    sentence = used.table.sentence
    assert sentence.isVisible()
    assert sentence.text() == "A priority is a whole number or none, not “high”."
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("6")
    used.key(ENTER)
    assert not sentence.isVisible()
    assert own(used.document, "sound")["nod"] == 6


def test_delete_takes_an_override_back_and_says_how_what_is_taken_over_is_taken_away(
    desk: Make,
) -> None:
    used = desk()
    used.click("sound", "gaze-sound")
    used.key(DELETE)
    assert own(used.document, "sound") == {}
    assert used.steps == ["Clear gaze-sound in sound"]
    used.click("sound", "converse")
    used.key(DELETE)
    assert len(used.steps) == 1
    assert used.said[-1] == "This is taken over from conversation: type none to take it away here."
    used.type("none")
    used.key(ENTER)
    assert own(used.document, "sound") == {"converse": None}
    assert used.text("sound", "speech") == "nobody"
    used.click("sound", "converse")
    used.key(DELETE)
    assert used.text("sound", "converse") == "30"


def test_shift_and_arrows_take_a_range_which_delete_clears_as_one_step(desk: Make) -> None:
    used = desk()
    used.click("called", "face-caller")
    for key in (DOWN, DOWN, RIGHT, RIGHT):
        used.key(key, SHIFT)
    assert used.area() == Area(*used.at("called", "face-caller"), 3, 3)
    names = [("situation", name) for name in ("called", "sound", "accepted")]
    assert used.chosen[-1] == tuple(names)
    used.key(DELETE)
    assert used.steps == ["Clear 9 priorities"]
    assert [own(used.document, name[1]) for name in names] == [{}, {}, {}]


def test_tab_goes_from_the_last_cell_on_to_what_stands_beside(desk: Make) -> None:
    used = desk()
    last = used.at("conversation", used.view.model.modules[-1])
    used.table.choose(Area(*last))
    used.key(TAB)
    assert QApplication.focusWidget() is not used.table


def test_an_arrow_leads_to_the_holders_and_back(desk: Make) -> None:
    used = desk()
    used.click("sound", "chase-face")
    used.key(RIGHT)
    holders = used.view.sides.holders
    assert QApplication.focusWidget() is holders
    assert holders.currentIndex().data() == "nobody"
    used.key(RIGHT)
    assert holders.currentIndex().data() == "gaze-sound"
    used.type("5")
    assert used.steps == [], "who holds is not typed"
    used.key(LEFT)
    used.key(LEFT)
    assert QApplication.focusWidget() is used.table
    assert used.area() == Area(*used.at("sound", "chase-face"))


# -- filling and the clipboard -------------------------------------------------------------


def test_control_d_fills_down_and_control_r_to_the_right(desk: Make) -> None:
    used = desk()
    used.click("called", "face-caller")
    used.key(DOWN, SHIFT)
    used.key(DOWN, SHIFT)
    used.key(Qt.Key.Key_D, CONTROL)
    rows = ("called", "sound", "accepted")
    assert [own(used.document, name).get("face-caller") for name in rows] == [70, 70, 70]
    assert len(used.steps) == 1
    used.click("invited", "face-caller")
    used.key(Qt.Key.Key_R, CONTROL)
    assert own(used.document, "invited") == {"transfer": 90, "face-caller": 90}
    used.click("sound", "transfer")
    used.key(Qt.Key.Key_D, CONTROL)
    assert len(used.steps) == 2, "there is nothing above"


def test_the_handle_in_the_corner_fills_the_cells_that_it_is_dragged_over(desk: Make) -> None:
    used = desk()
    used.click("invited", "transfer")
    row, column = used.at("invited", "transfer")
    corner = used.table.visualRect(used.view.model.index(row, column)).bottomRight()
    used.drag(used.table.viewport(), corner, used.point(row + 2, column))
    assert own(used.document, "called") == {"face-caller": 70, "transfer": 90}
    assert own(used.document, "sound") == {"gaze-sound": 60, "transfer": 90}
    assert used.area() == Area(row, column, 3, 1)
    assert used.steps == ["Fill 3 priorities"]


def test_the_handle_repeats_a_range_also_where_it_ends_in_its_midst(desk: Make) -> None:
    used = desk()
    row, column = used.at("called", "transfer")
    used.click("called", "transfer")
    used.type("3")
    used.key(ENTER)
    used.table.choose(Area(row - 1, column, 2, 1))
    corner = used.table.visualRect(used.view.model.index(row, column)).bottomRight()
    used.drag(used.table.viewport(), corner, used.point(row + 3, column))
    rows = ("invited", "called", "sound", "accepted", "conversation")
    assert [own(used.document, name).get("transfer") for name in rows] == [90, 3, 90, 3, 90]
    assert used.steps[-1] == "Fill 5 priorities"


def test_what_is_pasted_once_into_a_larger_range_is_what_is_told_and_selected(desk: Make) -> None:
    used = desk()
    clipboard().setText("1\t2\n3\t4\n")
    row, column = used.at("invited", "nod")
    used.table.choose(Area(row, column, 3, 2))
    used.key(Qt.Key.Key_V, CONTROL)
    assert used.steps == ["Paste 4 priorities"]
    assert used.area() == Area(row, column, 2, 2)
    # Where nothing was copied nothing happens.
    clipboard().clear()
    used.key(Qt.Key.Key_V, CONTROL)
    assert used.said[-1] == "There is nothing to paste."
    assert len(used.steps) == 1


def test_a_range_travels_by_the_clipboard_as_text_and_as_a_table(desk: Make) -> None:
    used = desk()
    used.click("accepted", "converse")
    used.key(DOWN, SHIFT)
    used.key(RIGHT, SHIFT)
    used.key(Qt.Key.Key_C, CONTROL)
    assert clipboard().text() == "30\t20\n30\t20\n"
    assert clipboard().mimeData().html().count("<td>") == 4
    used.click("invited", "nod")
    used.key(Qt.Key.Key_V, CONTROL)
    assert own(used.document, "invited") == {"transfer": 90, "nod": 30, "converse": 20}
    assert own(used.document, "called") == {"face-caller": 70, "nod": 30, "converse": 20}
    assert used.steps == ["Paste 4 priorities"]
    used.click("conversation", "converse")
    used.key(Qt.Key.Key_X, CONTROL)
    assert own(used.document, "conversation") == {"chase-face": 20}
    assert clipboard().text() == "30\n"


def test_what_a_spreadsheet_copied_is_pasted_all_of_it_or_nothing(desk: Make) -> None:
    used = desk()
    mime = QMimeData()
    mime.setText("a page about 1 and 2")
    mime.setHtml("<table><tr><td>1</td><td>none</td></tr></table>")
    clipboard().setMimeData(mime)
    used.click("sound", "nod")
    used.key(Qt.Key.Key_V, CONTROL)
    assert own(used.document, "sound") == {"gaze-sound": 60, "nod": 1, "converse": None}
    clipboard().setText("5\thigh\r\n")
    before = used.document
    used.key(Qt.Key.Key_V, CONTROL)
    assert used.document is before
    assert used.said[-1] == ("converse of sound: A priority is a whole number or none, not “high”.")
    assert used.table.sentence.isVisible()


# -- situations and modules -----------------------------------------------------------------


def names(used: Desk) -> list[str]:
    return [situation.name for situation in used.document.situations]


def test_a_situation_goes_up_and_down_by_alt_and_arrows_and_by_its_grip(desk: Make) -> None:
    used = desk()
    used.click("sound", "nod")
    used.key(UP, ALT)
    assert names(used)[2:4] == ["sound", "called"]
    assert used.area() == Area(*used.at("sound", "nod")), "the cell goes along"
    used.key(DOWN, ALT)
    assert names(used)[2:4] == ["called", "sound"]
    header = used.table.rows
    grip = header.area_of(4)
    start = QPoint(10, grip.center().y())
    used.drag(header.viewport(), start, QPoint(10, header.area_of(1).top() + 3))
    assert names(used) == ["stopped", "accepted", "invited", "called", "sound", "conversation"]


def test_a_double_click_on_a_header_renames_and_what_takes_over_follows(desk: Make) -> None:
    used = desk()
    header = used.table.rows
    spot = header.area_of(5).center()
    QTest.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    QTest.mouseDClick(header.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    used.type("talk")
    used.key(ENTER)
    assert names(used)[-1] == "talk"
    found = used.document.situation("sound")
    assert found is not None
    assert found.extends == "talk"
    heads = used.table.heads
    spot = heads.area_of(3).center()
    QTest.mouseClick(heads.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    assert used.chosen[-1] == (("module", "nod"),)
    QTest.mouseDClick(heads.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    used.type("transfer")
    used.key(ENTER)
    assert used.said[-1] == "transfer is taken already."
    heads.edit_name(3)
    used.type("bow")
    used.key(ENTER)
    assert own(used.document, "accepted") == {"bow": 40}
    assert used.chosen[-1] == (("module", "bow"),)


def test_situations_and_modules_are_added_and_named_at_once(desk: Make) -> None:
    used = desk()
    for kind, name in (("situation", "alarm"), ("module", "siren")):
        button = used.view.findChild(QPushButton, f"add_{kind}")
        assert isinstance(button, QPushButton)
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)
        used.settle()
        used.type(name)
        used.key(ENTER)
    assert names(used)[-2:] == ["alarm", "conversation"]
    assert used.view.model.modules[-1] == "siren"


def test_a_script_without_situations_or_modules_says_what_to_add(desk: Make) -> None:
    used = desk(read('<spds name="s"/>'))
    assert used.view.sides.hint.text() == "There is no situation yet: add one."
    used.view.add_situation()
    used.key(ENTER)
    assert used.view.sides.hint.text() == "There is no module yet: add one."
    spot = used.table.rows.area_of(0).center()
    QTest.mouseClick(used.table.rows.viewport(), Qt.MouseButton.LeftButton, pos=spot)
    assert used.chosen[-1] == (("situation", "situation"),)
    used.view.add_module()
    used.key(ENTER)
    assert used.view.sides.hint.text() == ""
    used.table.choose(Area(0, 0))
    used.type("3")
    used.key(ENTER)
    assert own(used.document, "situation") == {"module": 3}


def test_what_is_selected_elsewhere_is_shown_without_being_told(desk: Make) -> None:
    used = desk()
    used.click("sound", "nod")
    used.chosen.clear()
    used.view.select((("situation", "invited", "entry", "0"),))
    assert used.area() == Area(*used.at("invited", "transfer"))
    used.view.select((("module", "converse"),))
    assert used.table.cells.columns == {4}
    used.view.select((("resource", "head"),))
    assert used.table.cells.columns == {7}
    assert used.chosen == []


# -- all together ---------------------------------------------------------------------------

BIG = "\n".join(
    [
        '<spds name="big"><modules>',
        *(f'<module name="module{m}" resources="head"/>' for m in range(30)),
        "</modules>",
        *(
            f'<situation name="s{s}"><condition><data tag="t{s}" is="true"/></condition>'
            f'<module name="module{s % 30}" priority="{s}"/></situation>'
            for s in range(40)
        ),
        '<situation name="else"/></spds>',
    ]
)


def test_a_priority_that_is_selected_elsewhere_is_the_cell_where_typing_goes(desk: Make) -> None:
    """In the same row too, where another cell was the current one."""
    used = desk()
    used.click("sound", "converse")
    sound = next(one for one in used.document.situations if one.name == "sound")
    modules = [entry.module for entry in sound.entries]
    place = ("situation", "sound", "entry", str(modules.index("gaze-sound")))
    used.view.select((place,))
    used.settle()
    row, column = used.at("sound", "gaze-sound")
    assert used.area() == Area(row, column)
    # The situation alone: the cell stays.
    used.view.select((("situation", "sound"),))
    assert used.area() == Area(row, column)


def test_names_and_holders_stay_where_they_are_while_the_cells_are_scrolled(desk: Make) -> None:
    used = desk(read(BIG))
    holders, header = used.view.sides.holders, used.table.rows
    before = (header.x(), holders.x())
    assert used.view.width() == 900
    assert holders.geometry().right() < 900
    used.table.choose(Area(0, 0))
    used.key(Qt.Key.Key_End)
    assert used.area() == Area(0, 29)
    assert used.table.visualRect(used.table.currentIndex()).right() <= used.table.viewport().width()
    for _ in range(35):
        used.key(DOWN)
    assert used.table.verticalScrollBar().value() == holders.verticalScrollBar().value() > 0
    assert (header.x(), holders.x()) == before


def test_any_edits_taken_back_lead_to_the_script_that_was_there(desk: Make) -> None:
    """A walk by keys, always the same one; Qt's tester of models looks on."""
    used = desk(TIED)
    dice = random.Random(7)
    arrows = (UP, DOWN, LEFT, RIGHT)

    def typing() -> None:
        used.type(dice.choice(("5", "-3", "none", "20", "0")))
        used.key(dice.choice((ENTER, TAB)))

    def taking() -> None:
        for _ in range(dice.randrange(3)):
            used.key(dice.choice((DOWN, RIGHT)), SHIFT)

    moves: tuple[Callable[[], None], ...] = (
        lambda: used.key(dice.choice(arrows)),
        typing,
        taking,
        lambda: used.key(DELETE),
        lambda: used.key(dice.choice((Qt.Key.Key_D, Qt.Key.Key_R)), CONTROL),
        lambda: used.key(dice.choice((Qt.Key.Key_C, Qt.Key.Key_X)), CONTROL),
        lambda: used.key(Qt.Key.Key_V, CONTROL),
        lambda: used.key(dice.choice((UP, DOWN)), ALT),
        used.view.add_module,
        lambda: used.undo() if used.steps and len(used.done) > 1 else None,
    )
    clipboard().clear()
    used.table.choose(Area(0, 0))
    for _ in range(70):
        used.table.setFocus()
        dice.choice(moves)()
        if isinstance(QApplication.focusWidget(), QLineEdit):
            used.key(ESCAPE)
    assert len(used.done) > 5
    last = used.document
    count = len(used.done) - 1
    for _ in range(count):
        used.undo()
    assert used.document is TIED
    for _ in range(count):
        used.redo()
    assert used.document is last
