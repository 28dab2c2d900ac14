"""The screen beside the graph is changed with mouse and keys."""

from __future__ import annotations

from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from situ.document.codec import write

LEFT = Qt.MouseButton.LeftButton
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

Page = Any
Table = Any


def test_a_component_goes_where_it_is_dragged_as_one_step_and_undo_gives_the_bytes_back(
    table: Table,
) -> None:
    one = table.components[-1]
    bytes_before = write(table.document)
    table.drag(table.middle(one.id), table.at(-7, -12), ALT)
    moved = table.component(one.id)
    assert abs(moved.x - (one.x - 7)) < 0.5
    assert abs(moved.y - (one.y - 12)) < 0.5
    assert (moved.width, moved.height) == (one.width, one.height)
    assert table.used.window.inspector.place == ("state", "11", "screen", one.id)
    assert table.used.session.undo_text == f"Move {one.id}"
    table.used.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert write(table.document) == bytes_before


def test_a_press_without_a_way_changes_nothing(page: Page) -> None:
    before = page.document
    page.click(page.components[-1].id)
    assert page.document is before


def test_what_is_dragged_beyond_the_edge_stays_on_the_screen(page: Page) -> None:
    one = page.components[-1]
    page.drag(page.middle(one.id), page.at(300, 300), ALT)
    moved = page.component(one.id)
    assert moved.x + moved.width == pytest.approx(100)
    assert moved.y + moved.height == pytest.approx(100)


def test_a_handle_makes_it_larger(page: Page) -> None:
    one = page.components[-1]
    page.click(one.id)
    page.drag(page.sheet.handle_at("nw").toPoint(), page.at(-5, -5), ALT)
    grown = page.component(one.id)
    assert grown.width > one.width + 3
    assert grown.height > one.height + 3
    assert grown.x + grown.width == pytest.approx(one.x + one.width, abs=0.02)
    assert page.steps[-1] == f"Resize {one.id}"


def test_arrows_move_by_one_percent_and_by_ten_with_shift(page: Page) -> None:
    one = page.components[-1]
    page.click(one.id)
    page.key(Qt.Key.Key_Up)
    assert page.component(one.id).y == pytest.approx(one.y - 1)
    page.key(Qt.Key.Key_Up, SHIFT)
    assert page.component(one.id).y == pytest.approx(one.y - 11)


def test_delete_takes_the_component_away_and_leaves_its_state(page: Page) -> None:
    one = page.components[-1]
    count = len(page.components)
    page.click(one.id)
    page.key(Qt.Key.Key_Delete)
    assert len(page.components) == count - 1
    assert all(c.id != one.id for c in page.components)


def test_cut_with_a_component_selected_leaves_its_state(table: Table) -> None:
    states = len(table.document.states)
    *others, one = table.components
    table.used.click(table.sheet, table.middle(one.id))
    table.used.key(Qt.Key.Key_X, Qt.KeyboardModifier.ControlModifier)
    assert len(table.document.states) == states
    assert list(table.components) == others


def test_shift_adds_to_the_selection_and_they_move_together(page: Page) -> None:
    first, second = page.components[-2:]
    page.click(first.id)
    page.click(second.id, held=SHIFT)
    page.key(Qt.Key.Key_Up)
    assert page.component(first.id).y == pytest.approx(first.y - 1)
    assert page.component(second.id).y == pytest.approx(second.y - 1)


def test_enter_goes_to_the_form_of_the_component(table: Table) -> None:
    one = table.components[-1]
    table.used.click(table.sheet, table.middle(one.id))
    table.used.key(Qt.Key.Key_Return)
    focus = table.used.window.focusWidget()
    assert table.used.window.inspector.isAncestorOf(focus)


def test_a_component_from_the_palette_lies_where_it_was_dropped_and_is_selected(
    table: Table,
) -> None:
    count = len(table.components)
    assert table.drop("button", table.at(50, 50))
    assert len(table.components) == count + 1
    made = table.components[-1]
    assert made.element == "button"
    assert abs(made.x + made.width / 2 - 50) <= 1
    assert abs(made.y + made.height / 2 - 50) <= 1
    assert table.used.window.inspector.place == ("state", "11", "screen", made.id)


def test_what_is_no_component_is_not_taken(page: Page) -> None:
    before = page.document
    assert not page.drop("speech", page.at(50, 50))
    assert page.document is before


def test_align_in_the_menu_is_of_the_components_while_some_are_selected(table: Table) -> None:
    first, second = table.components[-2:]
    table.used.click(table.sheet, table.middle(first.id))
    QTest.mouseClick(table.sheet, LEFT, SHIFT, table.middle(second.id))
    table.used.settle()
    table.used.key(Qt.Key.Key_Up)
    table.used.window.actions_.refresh()
    actions = table.used.window.actions_.actions
    assert not actions["distribute.across"].isEnabled()
    actions["align.left"].trigger()
    assert table.component(first.id).x == table.component(second.id).x == min(first.x, second.x)


def test_delete_in_the_menu_takes_the_component_away_not_its_state(table: Table) -> None:
    one, states = table.components[-1], len(table.document.states)
    table.used.select("state", "11", "screen", one.id)
    table.used.window.show_mode("graph")
    table.used.window.actions_.actions["delete"].trigger()
    assert len(table.document.states) == states
    assert all(c.id != one.id for c in table.components)
