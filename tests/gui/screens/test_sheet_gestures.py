"""Rubber band, click through, several at once, and what is told while something is dragged."""

from __future__ import annotations

from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from situ_studio.edits import places
from situ_studio.screens import marks
from situ_studio.screens.devices import DEVICES
from situ_studio.screens.guides import Guide
from situ_studio.screens.hand import Hand
from situ_studio.screens.placing import around, box_of

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CONTROL = Qt.KeyboardModifier.ControlModifier

Page = Any


def test_a_rubber_band_selects_what_it_touches_and_adds_to_it_with_shift(page: Page) -> None:
    sheet = page.sheet
    page.drag(page.at(2, 97), page.at(10, -10))
    assert sheet.selected == ("measure",)
    page.drag(page.at(98, 97), page.at(-10, -10), SHIFT)
    assert sheet.selected == ("measure", "goodbye")
    assert page.selected == tuple(("state", "11", "screen", id) for id in ("measure", "goodbye"))
    page.drag(page.at(49, 2), page.at(1, 20))
    assert sheet.selected == ("question",)
    before = page.document
    QTest.mouseClick(sheet, LEFT, NONE, page.at(50, 50))
    page.settle()
    assert sheet.selected == ()
    assert page.selected == (("state", "11"),)
    assert page.document is before


def test_escape_ends_a_rubber_band_and_a_drag_as_if_they_had_not_begun(page: Page) -> None:
    before = page.document
    page.click("robot")
    QTest.mousePress(page.sheet, LEFT, NONE, page.at(2, 97))
    page.sheet_move(page.at(10, 80), NONE)
    assert page.sheet.selected == ("measure",)
    page.key(Qt.Key.Key_Escape)
    QTest.mouseRelease(page.sheet, LEFT, NONE, page.at(10, 80))
    page.settle()
    assert page.sheet.selected == ("robot",)
    QTest.mousePress(page.sheet, LEFT, NONE, page.middle("robot"))
    page.sheet_move(page.middle("robot") + QPoint(30, 20), NONE)
    page.key(Qt.Key.Key_Escape)
    page.sheet_move(page.middle("robot") + QPoint(50, 20), NONE)
    QTest.mouseRelease(page.sheet, LEFT, NONE, page.middle("robot") + QPoint(50, 20))
    page.settle()
    assert page.document is before
    assert page.sheet.selected == ("robot",)
    page.key(Qt.Key.Key_Escape)
    assert page.sheet.selected == ()


def test_what_lies_below_is_reached_by_alt_and_by_clicking_again(page: Page) -> None:
    sheet = page.sheet
    # Onto each other: the heart, the robot on it.
    page.drag(page.middle("robot"), page.middle("heart") - page.middle("robot"), ALT)
    at = page.middle("heart")

    def click(held: Qt.KeyboardModifier = NONE) -> tuple[str, ...]:
        QTest.mouseClick(sheet, LEFT, held, at)
        page.settle()
        selected: tuple[str, ...] = sheet.selected
        return selected

    QTest.mouseClick(sheet, LEFT, NONE, page.middle("question"))
    assert click() == ("robot",)
    assert click() == ("heart",)
    assert click() == ("robot",)
    assert click(ALT) == ("heart",)
    assert click(ALT) == ("robot",)


def test_a_click_on_one_of_several_selects_it_alone_and_with_shift_takes_it_out(
    page: Page,
) -> None:
    page.click("measure")
    page.click("goodbye", "heart", held=SHIFT)
    assert page.sheet.selected == ("measure", "goodbye", "heart")
    page.click("goodbye", held=SHIFT)
    assert page.sheet.selected == ("measure", "heart")
    page.click("heart")
    assert page.sheet.selected == ("heart",)


def test_several_are_resized_together_by_the_handles_of_what_covers_them(page: Page) -> None:
    page.click("measure")
    page.click("goodbye", held=SHIFT)
    before = {id: box_of(page.component(id)) for id in ("measure", "goodbye")}
    page.drag(page.sheet.handle_at("n").toPoint(), page.at(0, -12), ALT)
    after = {id: box_of(page.component(id)) for id in ("measure", "goodbye")}
    for id in before:
        assert after[id].height == pytest.approx(before[id].height + 12, abs=0.6)
        assert after[id].bottom == pytest.approx(before[id].bottom, abs=0.02)
        assert after[id].x == before[id].x
    assert page.steps[-1] == "Resize measure, goodbye"
    page.drag(page.sheet.handle_at("nw").toPoint(), page.at(20, 0), SHIFT)
    whole = around(box_of(page.component(id)) for id in before)
    old = around(after.values())
    assert whole.width / whole.height == pytest.approx(old.width / old.height, rel=0.01)
    assert whole.right == pytest.approx(old.right, abs=0.02)


def test_shift_keeps_a_drag_on_one_axis(page: Page) -> None:
    before = page.component("robot")
    page.drag(page.middle("robot"), page.at(-9, 5), SHIFT)
    # Shift and a press add to the selection; what is dragged is what was pressed.
    assert page.component("robot").y == before.y
    assert page.component("robot").x != before.x


def test_while_it_is_dragged_guides_and_even_distances_are_told(page: Page) -> None:
    sheet = page.sheet
    QTest.mousePress(sheet, LEFT, NONE, page.middle("goodbye"))
    page.sheet_move(page.middle("goodbye") + page.at(0.4, -2.6), NONE)
    proposal = sheet.proposal
    # As far below the pictures as they are below the question.
    assert proposal.boxes["goodbye"].y == 68
    assert proposal.boxes["goodbye"].x == 52
    assert 94 in proposal.snap.upright
    told = {(g.across, round(g.length, 2), g.even) for g in proposal.gaps}
    assert (False, 2, True) in told
    assert page.component("goodbye").y == 70
    QTest.mouseRelease(sheet, LEFT, NONE, page.middle("goodbye"))
    page.settle()
    assert page.component("goodbye").y == 68
    assert sheet.proposal is None


def test_the_badge_tells_millimetres_at_ten_inches_and_what_a_touch_sends(page: Page) -> None:
    measure, heart = page.component("measure"), page.component("heart")
    assert marks.measured(box_of(measure), [measure]) == "91 × 33 mm, clickMeasure"
    assert marks.measured(box_of(heart), [heart]) == "65 × 44 mm"
    assert marks.measured(box_of(heart), [heart, measure]) == "65 × 44 mm"
    assert marks.measured(box_of(heart), [heart], DEVICES[1]) == "46 × 29 mm, 7 inch"


def test_what_always_adds_is_seen_and_snapped_to_unless_it_is_hidden(page: Page) -> None:
    page.select("5")
    sheet = page.sheet
    own = {c.id for c in sheet.screen_shown.components}
    above = [c.id for c in sheet.components if c.id not in own]
    assert above
    seen = len(sheet.others(()))
    sheet.show_always(False)
    assert [c.id for c in sheet.components if c.id not in own] == []
    assert len(sheet.others(())) == seen - len(above)
    page.select("7")
    assert not set(above) & {c.id for c in sheet.components}
    sheet.show_always(True)
    assert set(above) <= {c.id for c in sheet.components}


def test_a_component_dropped_on_a_state_without_a_screen_makes_its_screen_in_one_step(
    page: Page,
) -> None:
    before = places.change(page.document, ("state", "11"), screen=None)
    page.commit(before)
    page.settle()
    assert page.drop("text", page.at(50, 50))
    made = page.document.state("11").screen
    assert [c.element for c in made.components] == ["text"]
    page.undo()
    assert page.document == before


def test_a_component_that_is_dropped_is_drawn_to_guides_and_edges_as_one_that_is_moved(
    page: Page,
) -> None:
    page.commit(places.change(page.document, ("state", "11", "screen", "robot"), x=30.37))
    page.settle()
    assert page.drop("button", page.at(50, 50))
    wide = page.components[-1].width
    page.undo()
    assert page.drop("button", page.at(30.37 + 0.45 + wide / 2, 50))
    assert page.components[-1].x == 30.37
    page.undo()
    page.sheet.guides = (Guide("x", 47.63),)
    assert page.drop("button", page.at(47.2, 41.7))
    made = page.components[-1]
    assert made.x + made.width / 2 == pytest.approx(47.63, abs=0.01)


@pytest.mark.parametrize("id", ["question", "robot", "goodbye"])
def test_what_rests_while_one_is_moved_is_painted_as_if_all_were(
    page: Page, id: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    sheet = page.sheet
    QTest.mousePress(sheet, LEFT, NONE, page.middle(id))
    page.sheet_move(page.middle(id) + page.at(5, 6), ALT)
    first = sheet.grab().toImage()
    page.sheet_move(page.middle(id) + page.at(-4, -9), ALT)
    moved = sheet.grab().toImage()
    monkeypatch.setattr(Hand, "moves", False)
    whole = sheet.grab().toImage()
    assert first != whole
    for y in range(0, whole.height(), 3):
        for x in range(0, whole.width(), 3):
            one, other = moved.pixelColor(x, y), whole.pixelColor(x, y)
            for a, b in zip(one.getRgb(), other.getRgb(), strict=True):
                assert abs(a - b) <= 3, (x, y)
    QTest.keyClick(sheet, Qt.Key.Key_Escape)
    QTest.mouseRelease(sheet, LEFT, NONE, page.middle(id))
    monkeypatch.undo()
    page.settle()
    assert not sheet._resting
