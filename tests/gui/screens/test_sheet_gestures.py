"""Rubber band, click through, several at once, and what is told while something is dragged."""

from __future__ import annotations

from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from situ_studio import places
from situ_studio.screens import marks
from situ_studio.screens.placing import around, box_of

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CONTROL = Qt.KeyboardModifier.ControlModifier

Table = Any


def test_a_rubber_band_selects_what_it_touches_and_adds_to_it_with_shift(table: Table) -> None:
    sheet = table.sheet
    table.drag(table.at(2, 97), table.at(10, -10))
    assert sheet.selected == ("measure",)
    table.drag(table.at(98, 97), table.at(-10, -10), SHIFT)
    assert sheet.selected == ("measure", "goodbye")
    assert table.used.window.current_view.selected == tuple(
        ("state", "11", "screen", id) for id in ("measure", "goodbye")
    )
    table.drag(table.at(49, 2), table.at(1, 20))
    assert sheet.selected == ("question",)
    before = table.document
    QTest.mouseClick(sheet, LEFT, NONE, table.at(50, 50))
    table.used.settle()
    assert sheet.selected == ()
    assert table.used.window.inspector.place == ("state", "11")
    assert table.document is before


def test_escape_ends_a_rubber_band_and_a_drag_as_if_they_had_not_begun(table: Table) -> None:
    before = table.document
    table.click("robot")
    QTest.mousePress(table.sheet, LEFT, NONE, table.at(2, 97))
    table.sheet_move(table.at(10, 80), NONE)
    assert table.sheet.selected == ("measure",)
    table.used.key(Qt.Key.Key_Escape)
    QTest.mouseRelease(table.sheet, LEFT, NONE, table.at(10, 80))
    table.used.settle()
    assert table.sheet.selected == ("robot",)
    QTest.mousePress(table.sheet, LEFT, NONE, table.middle("robot"))
    table.sheet_move(table.middle("robot") + QPoint(30, 20), NONE)
    table.used.key(Qt.Key.Key_Escape)
    table.sheet_move(table.middle("robot") + QPoint(50, 20), NONE)
    QTest.mouseRelease(table.sheet, LEFT, NONE, table.middle("robot") + QPoint(50, 20))
    table.used.settle()
    assert table.document is before
    assert table.sheet.selected == ("robot",)
    table.used.key(Qt.Key.Key_Escape)
    assert table.sheet.selected == ()


def test_what_lies_below_is_reached_by_alt_and_by_clicking_again(table: Table) -> None:
    sheet = table.sheet
    # Onto each other: the heart, the robot on it.
    table.drag(table.middle("robot"), table.middle("heart") - table.middle("robot"), ALT)
    at = table.middle("heart")

    def click(held: Qt.KeyboardModifier = NONE) -> tuple[str, ...]:
        QTest.mouseClick(sheet, LEFT, held, at)
        table.used.settle()
        selected: tuple[str, ...] = sheet.selected
        return selected

    QTest.mouseClick(sheet, LEFT, NONE, table.middle("question"))
    assert click() == ("robot",)
    assert click() == ("heart",)
    assert click() == ("robot",)
    assert click(ALT) == ("heart",)
    assert click(ALT) == ("robot",)


def test_a_click_on_one_of_several_selects_it_alone_and_with_shift_takes_it_out(
    table: Table,
) -> None:
    table.click("measure")
    table.click("goodbye", "heart", held=SHIFT)
    assert table.sheet.selected == ("measure", "goodbye", "heart")
    table.click("goodbye", held=SHIFT)
    assert table.sheet.selected == ("measure", "heart")
    table.click("heart")
    assert table.sheet.selected == ("heart",)


def test_several_are_resized_together_by_the_handles_of_what_covers_them(table: Table) -> None:
    table.click("measure")
    table.click("goodbye", held=SHIFT)
    before = {id: box_of(table.component(id)) for id in ("measure", "goodbye")}
    table.drag(table.sheet.handle_at("n").toPoint(), table.at(0, -12), ALT)
    after = {id: box_of(table.component(id)) for id in ("measure", "goodbye")}
    for id in before:
        assert after[id].height == pytest.approx(before[id].height + 12, abs=0.6)
        assert after[id].bottom == pytest.approx(before[id].bottom, abs=0.02)
        assert after[id].x == before[id].x
    assert table.used.session.undo_text == "Resize measure, goodbye"
    table.drag(table.sheet.handle_at("nw").toPoint(), table.at(20, 0), SHIFT)
    whole = around(box_of(table.component(id)) for id in before)
    old = around(after.values())
    assert whole.width / whole.height == pytest.approx(old.width / old.height, rel=0.01)
    assert whole.right == pytest.approx(old.right, abs=0.02)


def test_shift_keeps_a_drag_on_one_axis(table: Table) -> None:
    before = table.component("robot")
    table.drag(table.middle("robot"), table.at(-9, 5), SHIFT)
    # Shift and a press add to the selection; what is dragged is what was pressed.
    assert table.component("robot").y == before.y
    assert table.component("robot").x != before.x


def test_while_it_is_dragged_guides_and_even_distances_are_told(table: Table) -> None:
    sheet = table.sheet
    QTest.mousePress(sheet, LEFT, NONE, table.middle("goodbye"))
    table.sheet_move(table.middle("goodbye") + table.at(0.4, -2.6), NONE)
    proposal = sheet.proposal
    # As far below the pictures as they are below the question.
    assert proposal.boxes["goodbye"].y == 68
    assert proposal.boxes["goodbye"].x == 52
    assert 94 in proposal.snap.upright
    told = {(g.across, round(g.length, 2), g.even) for g in proposal.gaps}
    assert (False, 2, True) in told
    assert table.component("goodbye").y == 70
    QTest.mouseRelease(sheet, LEFT, NONE, table.middle("goodbye"))
    table.used.settle()
    assert table.component("goodbye").y == 68
    assert sheet.proposal is None


def test_the_badge_tells_millimetres_at_ten_inches_and_what_a_touch_sends(table: Table) -> None:
    measure, heart = table.component("measure"), table.component("heart")
    assert marks.measured(box_of(measure), [measure]) == "91 × 33 mm, clickMeasure"
    assert marks.measured(box_of(heart), [heart]) == "65 × 44 mm"
    assert marks.measured(box_of(heart), [heart, measure]) == "65 × 44 mm"


def test_what_always_adds_is_seen_and_snapped_to_unless_it_is_hidden(table: Table) -> None:
    table.used.select("state", "5")
    sheet = table.sheet
    own = {c.id for c in sheet.screen_shown.components}
    above = [c.id for c in sheet.components if c.id not in own]
    assert above
    seen = len(sheet.others(()))
    sheet.show_always(False)
    assert [c.id for c in sheet.components if c.id not in own] == []
    assert len(sheet.others(())) == seen - len(above)
    table.used.select("state", "7")
    assert not set(above) & {c.id for c in sheet.components}
    sheet.show_always(True)
    assert set(above) <= {c.id for c in sheet.components}


def test_a_component_dropped_on_a_state_without_a_screen_makes_its_screen_in_one_step(
    table: Table,
) -> None:
    before = places.change(table.document, ("state", "11"), screen=None)
    table.used.window.commit(before, "Take the screen away")
    table.used.settle()
    assert table.drop("text", table.at(50, 50))
    made = table.document.state("11").screen
    assert [c.element for c in made.components] == ["text"]
    table.used.key(Qt.Key.Key_Z, CONTROL)
    assert table.document == before
