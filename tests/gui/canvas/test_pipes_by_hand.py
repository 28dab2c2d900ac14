"""Pipes of an application that a hand draws, pulls elsewhere or cuts, and what can follow."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from situ.document.rbd import Application, Event

SHIFT = Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
Make = Callable[..., Any]
Check = Callable[[Any], None]


@pytest.fixture
def made(desk: Make, small: Application) -> Any:
    return desk(small)


# -- pipes ----------------------------------------------------------------------------


def test_from_exit_to_card_connects(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("1", "0"), hand.body("4"))
    assert made.edits == ["Lead touched of state 1 to 4 no user"]
    assert made.document.states[0].events[0].next == "4"
    check(made)


def test_from_exit_to_its_own_card_is_a_loop_but_not_by_accident(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("4", "0"), hand.exit("4", "0") + QPointF(-14, 4))
    assert made.edits == []
    hand.drag(hand.exit("4", "0"), hand.body("4"))
    assert made.document.states[3].events[0].next == "4"
    check(made)


def test_the_plus_makes_a_new_event(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("5", "new"), hand.body("1"))
    assert made.edits == ["Add event1 of state 5 to 1 start"]
    assert made.document.states[4].events == (Event(name="event1", next="1"),)
    check(made)


def test_a_pipe_pulled_to_another_card_leads_there(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.on_pipe(hand.pipe("2", "0")), hand.body("5"))
    assert made.edits == ["Lead returned of state 2 to 5 end"]
    check(made)


def test_a_click_on_a_pipe_selects_its_event_and_takes_nothing_off(made: Any, check: Check) -> None:
    hand = made.hand
    hand.click(hand.on_pipe(hand.pipe("2", "0")))
    assert made.canvas.selection() == (("state", "2", "event", "0"),)
    assert made.edits == []
    check(made)


def test_a_click_on_an_exit_selects_its_event(made: Any) -> None:
    hand = made.hand
    hand.click(hand.exit("2", "timeout"))
    assert made.canvas.selection() == (("state", "2", "timeout"),)
    hand.click(hand.exit("3", "2"))
    assert made.canvas.selection() == (("state", "3", "event", "2"),)
    assert hand.card("3").row == "2"


def test_a_second_click_on_a_row_selects_its_event(made: Any) -> None:
    hand = made.hand
    row = hand.card("3").scenePos() + QPointF(150, 63 + 36)
    hand.click(row)
    assert made.canvas.selection() == (("state", "3"),)
    hand.click(row)
    assert made.canvas.selection() == (("state", "3", "event", "2"),)


def test_delete_takes_the_selected_event(made: Any, check: Check) -> None:
    hand = made.hand
    hand.click(hand.on_pipe(hand.pipe("2", "0")))
    hand.key(Qt.Key.Key_Delete)
    assert made.edits == ["Delete returned of state 2"]
    check(made)


def test_escape_puts_a_pulled_pipe_back(made: Any, check: Check) -> None:
    hand = made.hand
    start = hand.on_pipe(hand.pipe("2", "0"))
    hand.press(start)
    for step in (10, 30, 60):
        hand.move(start + QPointF(0, step))
    assert made.canvas.viewer.busy()
    hand.key(Qt.Key.Key_Escape)
    assert not made.canvas.viewer.busy()
    hand.release(start + QPointF(0, 60))
    assert made.edits == []
    check(made)


def test_a_pipe_over_a_card_does_not_drag_the_card(made: Any, check: Check) -> None:
    """A port that reaches over another card is the port's."""
    hand = made.hand
    made.change(
        replace(
            made.document,
            states=tuple(
                replace(s, aside=s.aside.at(176 - 4, 30)) if s.no == "2" else s
                for s in made.document.states
            ),
        )
    )
    hand.card("2").setZValue(3)
    hand.drag(hand.exit("1", "1"), hand.body("4"))
    assert made.edits == ["Lead human of state 1 to 4 no user"]
    check(made)


def test_alt_and_shift_cut_pipes(made: Any, check: Check) -> None:
    hand = made.hand
    straight = hand.pipe("1", "0").route.points
    assert len(straight) == 2
    x = (straight[0][0] + straight[1][0]) / 2 + 12
    hand.drag(QPointF(x, 30), QPointF(x, 150), ALT | SHIFT)
    assert made.document.states[0].events[0].next is None
    check(made)


# -- what can follow -------------------------------------------------------------------


def test_an_exit_dropped_on_the_ground_asks_what_follows(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.exit("4", "0"), QPointF(480, 500))
    menu = made.canvas.menu
    labels = [menu.list.item(i).text() for i in range(menu.list.count())]
    assert labels[0] == "New state"
    assert "3 names" in labels
    check(made)
    hand.type(menu.field, "question")
    assert menu.list.item(0).text() == "New question with Yes and No"
    QTest.keyClick(menu.field, Qt.Key.Key_Return)
    hand.settle()
    assert made.edits == ["Add state 6 after state 4"]
    state = made.document.state("6")
    assert state.aside.position == (480, 440)
    assert made.document.states[3].events[0].next == "6"
    assert made.canvas.selection() == (("state", "6"),)
    check(made)


def test_a_name_that_nothing_has_is_offered_as_a_new_state(made: Any, check: Check) -> None:
    made.hand.drag(made.hand.exit("4", "0"), QPointF(480, 500))
    menu = made.canvas.menu
    made.hand.type(menu.field, "names")
    offered = [menu.list.item(i).text() for i in range(menu.list.count())]
    assert offered == ["3 names", "New state “names”"]
    made.hand.type(menu.field, " again")
    QTest.keyClick(menu.field, Qt.Key.Key_Return)
    made.hand.settle()
    assert made.edits == ["Add state 6 after state 4"]
    assert made.document.state("6").name == "names again"
    assert made.document.states[3].events[0].next == "6"
    check(made)


def test_the_menu_of_what_follows_is_seen_whole(made: Any) -> None:
    made.canvas.move(200, 200)
    made.hand.drag(made.hand.exit("4", "0"), QPointF(520, 560))
    menu = made.canvas.menu
    assert menu.screen().availableGeometry().contains(menu.geometry())
    menu.close()


def test_escape_in_the_menu_leaves_the_old_pipe(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.on_pipe(hand.pipe("2", "0")), QPointF(480, 500))
    QTest.keyClick(made.canvas.menu.field, Qt.Key.Key_Escape)
    hand.settle()
    assert made.edits == []
    assert made.canvas.menu is None
    check(made)


def test_stay_here_disconnects(made: Any, check: Check) -> None:
    hand = made.hand
    hand.drag(hand.on_pipe(hand.pipe("2", "0")), QPointF(480, 500))
    hand.type(made.canvas.menu.field, "stay")
    QTest.keyClick(made.canvas.menu.field, Qt.Key.Key_Return)
    hand.settle()
    assert made.edits == ["Disconnect returned of state 2"]
    check(made)


# -- folded pipes -----------------------------------------------------------------------------


def test_a_chip_leads_to_its_state_and_alt_draws_the_pipe(made: Any) -> None:
    hand = made.hand
    pipe = hand.pipe("2", "timeout")
    assert pipe.route.folded
    hand.click(hand.on_pipe(pipe))
    assert made.canvas.selection() == (("state", "1"),)
    hand.click(hand.on_pipe(pipe), ALT)
    assert not hand.pipe("2", "timeout").route.folded
    assert made.edits == []
