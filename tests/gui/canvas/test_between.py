"""An existing card that is dragged onto a pipe goes in between: by the mouse, with a hint."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QPointF, Qt

from situ.document.aside import NOTHING
from situ.document.rbd import Application, Event, State

ALT = Qt.KeyboardModifier.AltModifier
Check = Callable[[Any], None]


@pytest.fixture
def made(desk: Callable[..., Any]) -> Any:
    """1 leads to 2, far to the right; 3 and the end 4 lie below, 5 leads to 2."""
    states = (
        State(no="1", name="a", events=(Event(name="go", next="2"),), aside=NOTHING.at(0, 0)),
        State(no="2", name="b", aside=NOTHING.at(690, 0)),
        State(no="3", name="c", aside=NOTHING.at(0, 300)),
        State(no="4", name="d", final=True, aside=NOTHING.at(230, 300)),
        State(no="5", name="e", events=(Event(name="on", next="2"),), aside=NOTHING.at(460, 450)),
    )
    return desk(Application(name="line", states=states))


def begin(made: Any, uid: str, held: Any = Qt.KeyboardModifier.NoModifier) -> QPointF:
    """Drags a card onto the middle of the pipe from 1 to 2, and holds it there."""
    hand = made.hand
    goal = hand.on_pipe(hand.pipe("1", "0"))
    start = hand.header(uid)
    hand.press(start, held)
    for step in range(1, 6):
        hand.move(start + (goal - start) * (step / 5), held)
        hand.settle()
    return goal  # type: ignore[no-any-return]


def hint(made: Any) -> bool:
    item = made.canvas._between._hint
    return item is not None and not item.path().isEmpty()


def test_a_card_dropped_on_a_pipe_is_put_in_between_in_one_step(made: Any, check: Check) -> None:
    said: list[str] = []
    made.canvas.status.connect(said.append)
    goal = begin(made, "3")
    assert hint(made)
    assert said == ["State 3 goes in between here. Alt: it is only moved."]
    made.hand.release(goal)
    assert said[1:] == [""]
    assert made.edits == ["Insert state 3"]
    assert made.document.state("1").events[0].next == "3"
    assert [e.next for e in made.document.state("3").events] == ["2"]
    assert made.document.state("3").aside.position != (0, 300)
    assert not hint(made)
    check(made)
    made.undo()
    assert made.document.state("3").aside.position == (0, 300)
    check(made)


def test_who_leads_on_already_gets_no_second_way(made: Any, check: Check) -> None:
    made.hand.release(begin(made, "5"))
    assert made.document.state("1").events[0].next == "5"
    assert [e.next for e in made.document.state("5").events] == ["2"]
    check(made)


def test_with_alt_it_is_only_moved_also_where_alt_comes_late(made: Any, check: Check) -> None:
    goal = begin(made, "3", ALT)
    assert not hint(made)
    made.hand.release(goal, ALT)
    goal = begin(made, "5")
    assert hint(made)
    made.hand.move(goal + QPointF(1, 0), ALT)
    made.hand.settle()
    assert not hint(made)
    made.hand.release(goal, ALT)
    assert made.edits == ["Move state 3", "Move state 5"]
    assert made.document.state("1").events[0].next == "2"
    check(made)


def test_escape_puts_it_back_where_it_was(made: Any, check: Check) -> None:
    goal = begin(made, "3")
    made.hand.key(Qt.Key.Key_Escape)
    assert not hint(made)
    made.hand.release(goal)
    assert made.edits == []
    check(made)


@pytest.mark.parametrize("uid", ["1", "2", "4"])
def test_the_ends_of_the_pipe_and_a_meant_end_are_only_moved(
    made: Any, check: Check, uid: str
) -> None:
    goal = begin(made, uid)
    assert not hint(made)
    made.hand.release(goal)
    assert made.edits == [f"Move state {uid}"]
    check(made)


def test_a_card_that_passes_over_a_pipe_is_only_moved(made: Any, check: Check) -> None:
    begin(made, "3")
    beyond = QPointF(400, 600)
    made.hand.move(beyond)
    made.hand.settle()
    assert not hint(made)
    made.hand.release(beyond)
    assert made.edits == ["Move state 3"]
    check(made)


def test_the_pipe_that_somebody_else_takes_away_meanwhile_takes_no_card(
    made: Any, check: Check
) -> None:
    goal = begin(made, "3")
    first = made.document.states[0]
    made.change(
        Application(
            name="line",
            states=(State(no="1", name="a", aside=first.aside), *made.document.states[1:]),
        )
    )
    made.hand.release(goal)
    assert [e.next for e in made.document.state("3").events] == []
    check(made)
