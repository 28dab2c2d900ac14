"""Why? and Why not? are asked within three clicks of anything on any view, and by keys."""

from __future__ import annotations

from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu
from tests.gui.live.test_why import FLOW, SCRIPT, Clicks, replayed, seen

SHIFT = Qt.KeyboardModifier.ShiftModifier

__all__ = ["replayed"]


@pytest.fixture
def invited(replayed: Any) -> Any:
    """The moment at which the robot has been called away."""
    it, events = replayed()
    then = next(e for e in events if e["kind"] == "situation" and e["to"] == "invited")
    it.window.robot.follower.viewing.seek(then["t"])
    it.settle()
    return it, events


def middle_of(sheet: Any, one: Any) -> QPoint:
    x, y = one.x + one.width / 2, one.y + one.height / 2
    return QPoint(round(sheet.width() * x / 100), round(sheet.height() * y / 100))


def title(it: Any) -> str:
    return str(it.window.why.panel.title.text())


def test_of_cells_rows_and_columns_of_the_matrix(invited: Any) -> None:
    it, _ = invited
    window = it.window
    window.open_file(SCRIPT)
    window.show_mode("matrix")
    it.settle()
    matrix = window.current_view.current_view()
    table, modules = matrix.table, matrix.model.modules
    rows = [line.situation.name for line in matrix.model.grid.lines]

    def ask(widget: Any, at: QPoint, words: str) -> None:
        hand = Clicks(it)
        hand.menu(widget, at)
        hand.choose(window.context_menus.shown, words)
        assert hand.count == 2

    cell = table.model().index(rows.index("called"), modules.index("chase-face"))
    ask(table.viewport(), table.visualRect(cell).center(), "Why not?")
    assert title(it) == "Why does chase-face not hold head?"
    assert any("no priority" in words for words in seen(it))
    # The cell beside it is another module, though the same situation is selected.
    other = table.model().index(rows.index("called"), modules.index("transfer"))
    ask(table.viewport(), table.visualRect(other).center(), "Why?")
    assert "transfer" in title(it)
    # By keys.
    table.setFocus()
    table.setCurrentIndex(cell)
    it.key(Qt.Key.Key_F7, SHIFT)
    assert title(it) == "Why does chase-face not hold head?"
    # Heads are asked of what they name, whatever was selected before.
    heads = table.heads
    middle = heads.sectionViewportPosition(modules.index("nod")) + 12
    ask(heads.viewport(), QPoint(middle, heads.height() // 2), "Why not?")
    assert title(it) == "Why does nod not hold head?"
    sides = table.rows
    at = sides.sectionViewportPosition(rows.index("stopped")) + 8
    ask(sides.viewport(), QPoint(20, at), "Why not?")
    assert title(it) == "Why is stopped not the situation?"
    ask(
        sides.viewport(),
        QPoint(20, sides.sectionViewportPosition(rows.index("invited")) + 8),
        "Why?",
    )
    assert seen(it)[-1].startswith("situation invited")
    # Who holds a resource when all ask.
    holders = matrix.sides.holders
    grid = matrix.model.grid
    column = len(modules) + list(grid.resources).index("head")
    place = holders.model().index(0, column)
    ask(holders.viewport(), holders.visualRect(place).center(), "Why?")
    assert "head" in title(it)


def test_of_what_lies_on_a_screen_and_of_the_outline(invited: Any) -> None:
    it, _ = invited
    window = it.window
    viewing = window.robot.follower.viewing
    window.open_file(FLOW)
    it.settle()
    # A button means its event: what it did last, or what keeps it from doing anything now.
    it.select("state", "1")
    window.show_mode("split")
    it.settle()
    sheet = window.beside.sheet
    flow = it.session.document(FLOW)
    components = flow.state("1").screen.components
    index = next(n for n, one in enumerate(components) if getattr(one, "event", None))
    button = components[index]
    hand = Clicks(it)
    hand.menu(sheet, middle_of(sheet, button))
    hand.choose(window.context_menus.shown, "Why not?")
    assert hand.count == 2
    assert title(it).startswith("Why does converse not leave 1")
    assert button.event in title(it)
    viewing.seek(viewing.span[1])
    sheet.setFocus()
    it.key(Qt.Key.Key_F7)
    assert f"by {button.event}" in seen(it)[-1] or "enters 1" in seen(it)[-1]
    # The outline's rows have the same menu.
    window.show_mode("outline")
    it.select("state", "2")
    it.settle()
    twin = window.current_view.twin
    hand = Clicks(it)
    hand.menu(twin.tree.viewport(), twin.tree.visualRect(twin.tree.currentIndex()).center())
    hand.choose(window.context_menus.shown, "Why not?")
    assert hand.count == 2
    assert title(it).startswith("Why is converse not in 2")


def test_of_bars_and_rows_why_they_are_not_others(invited: Any) -> None:
    it, events = invited
    window = it.window
    robot, viewing = window.robot, window.robot.follower.viewing
    then = viewing.t
    chart = robot.timeline.chart
    window.bottom.choose("timeline")
    it.settle()
    chart.show_all()
    it.settle()
    x = int(chart.axis.x(then + 0.05)) + chart.viewport().width() - int(chart.axis.width)
    tops = {(row.kind, row.name): int(top) + row.height // 2 for row, top in chart._tops()}
    for row, words, said in (
        (("resource", "head"), "Why not chase-face?", "Why does chase-face not hold head?"),
        (("situation", ""), "Why is called not the situation?", "Why is called not the situation?"),
        (("state", "converse"), None, "Why does converse not"),
    ):
        window.bottom.choose("timeline")
        it.settle()
        hand = Clicks(it)
        hand.menu(chart.viewport(), QPoint(x, tops[row]))
        menu = window.why.menus.shown
        if words is None:
            words = next(a.text() for a in menu.actions() if a.text().startswith("Why not"))
        hand.choose(menu, words)
        assert hand.count == 2
        assert title(it).startswith(said)
    # A datum: the situations that look at it. An event of the trace: what it is about.
    window.bottom.choose("blackboard")
    it.settle()
    hand = Clicks(it)
    hand.row_menu(robot.blackboard, "sound.slap")
    hand.choose(window.why.menus.shown, "Why is sound not the situation?")
    assert title(it) == "Why is sound not the situation?"
    window.bottom.choose("trace")
    it.settle()
    gave = next(e for e in events if e["kind"] == "abandon" and e["module"] == "nod")
    hand = Clicks(it)
    hand.row_menu(robot.trace, str(gave["seq"]))
    hand.choose(window.why.menus.shown, "Why does nod not hold head?")
    assert hand.count == 2
    assert title(it) == "Why does nod not hold head?"


def test_by_keys_of_the_panel_that_has_the_keyboard(invited: Any) -> None:
    it, _ = invited
    window = it.window
    robot = window.robot
    window.bottom.choose("authority")
    it.settle()
    table = robot.authority
    row = next(n for n, one in enumerate(table.rows.rows) if one.key == "head")
    table.setFocus()
    table.setCurrentIndex(table.rows.index(row, 0))
    it.key(Qt.Key.Key_F7, SHIFT)
    menu = window.why.menus.shown
    assert menu.isVisible()
    choose(it, menu, "Why not nod?")
    assert title(it) == "Why does nod not hold head?"
    window.bottom.choose("timeline")
    it.settle()
    robot.timeline.chart.setFocus()
    it.key(Qt.Key.Key_F7)
    menu = window.why.menus.shown
    below = next(a.menu() for a in menu.actions() if a.text() == "Situation")
    assert isinstance(below, QMenu)
    choose(it, below, "Why?")
    assert seen(it)[-1].startswith("situation invited")
    menu.close()
    it.settle()


def choose(it: Any, menu: QMenu, words: str) -> None:
    """By the keyboard alone: what is written there, then Enter."""
    action = next(a for a in menu.actions() if a.text() == words)
    if not menu.isVisible():
        menu.popup(it.window.mapToGlobal(it.window.rect().center()))
    menu.setActiveAction(action)
    it.settle()
    QTest.keyClick(menu, Qt.Key.Key_Return)
    it.settle()
