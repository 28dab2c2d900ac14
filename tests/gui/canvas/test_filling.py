"""A large drawing fills while the window answers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ.document.aside import NOTHING
from situ.document.rbd import Application, Event, State
from situ_studio.canvas import filling
from situ_studio.canvas.live import LiveView

MANY = 420


@pytest.fixture
def large() -> Application:
    """A way of many states, 20 in a row, each with a pipe to the next and one to the first."""
    return Application(
        name="large",
        states=tuple(
            State(
                no=str(i),
                name=f"s{i}",
                events=(
                    Event(name="on", next=str(i % MANY + 1)),
                    *([Event(name="no", next="1")] if i % 20 == 0 else []),
                ),
                aside=NOTHING.at((i - 1) % 20 * 230, (i - 1) // 20 * 228),
            )
            for i in range(1, MANY + 1)
        ),
    )


@pytest.fixture
def slow(monkeypatch: pytest.MonkeyPatch, desk: Callable[..., Any], large: Application) -> Any:
    """A desk whose drawing comes a card at a time."""
    monkeypatch.setattr(filling, "SLICE", 0.0)
    made = desk(large)
    assert made.canvas.filling.is_filling
    return made


def let_fill(made: Any, qt: QApplication) -> None:
    while made.canvas.filling.is_filling or made.canvas._piping.is_routing():
        qt.processEvents()


def test_a_large_drawing_is_there_in_the_end(
    slow: Any, qt: QApplication, check: Callable[[Any], None]
) -> None:
    assert len(slow.canvas.graph.cards) < MANY
    let_fill(slow, qt)
    assert list(slow.canvas.graph.cards) == [s.no for s in slow.document.states]
    check(slow)
    pipes = [slow.canvas.graph.pipe(i) for i in slow.canvas.graph.links]
    assert all(p.route.folded or len(p.route.points) > 1 for p in pipes)
    assert slow.edits == []


def test_a_click_a_move_and_a_key_count_while_it_fills(
    slow: Any, qt: QApplication, check: Callable[[Any], None]
) -> None:
    canvas, hand = slow.canvas, slow.hand
    hand.click(hand.body("2"))
    assert canvas.selection() == (("state", "2"),)
    hand.drag(hand.body("3"), hand.body("3") + QPointF(0, 96))
    assert canvas.graph.cards["3"].y == 96
    hand.click(hand.body("2"))
    hand.key(Qt.Key.Key_F2)
    hand.type(canvas._editor, "other")
    QTest.keyClick(canvas._editor, Qt.Key.Key_Return)
    assert canvas.document.states[1].name == "other"
    assert len(slow.edits) == 2
    assert canvas.filling.is_filling
    let_fill(slow, qt)
    check(slow)
    assert canvas.graph.cards["2"].name == "other"


def test_a_change_from_outside_while_it_fills(
    slow: Any, qt: QApplication, check: Callable[[Any], None]
) -> None:
    states = slow.document.states
    kept = tuple(replace(s, name="new") for s in states[10:] if s.no != str(MANY - 1))
    slow.change(replace(slow.document, states=kept))
    assert slow.canvas.filling.is_filling
    qt.processEvents()
    slow.undo()
    slow.redo()
    let_fill(slow, qt)
    check(slow)
    assert len(slow.canvas.graph.cards) == len(kept)


def test_a_small_document_in_its_place_is_there_at_once(
    slow: Any, small: Application, check: Callable[[Any], None]
) -> None:
    slow.change(small)
    assert not slow.canvas.filling.is_filling
    check(slow)


def test_what_is_asked_for_is_put_at_once(
    slow: Any, qt: QApplication, check: Callable[[Any], None]
) -> None:
    canvas = slow.canvas
    far = ("state", str(MANY))
    assert far[1] not in canvas.graph.cards
    canvas.select([far])
    assert canvas.selection() == (far,)
    canvas.select_all()
    assert not canvas.filling.is_filling
    assert len(canvas.selection()) == MANY
    let_fill(slow, qt)
    check(slow)


def test_what_is_seen_comes_first(slow: Any, qt: QApplication) -> None:
    canvas = slow.canvas
    canvas.zoom_to([("state", str(MANY))])
    seen = canvas.viewer.seen()
    wanted = {u for u in canvas.filling.cards if seen.intersects(canvas.card_area(u))}
    before = len(canvas.graph.cards)
    assert len(wanted) > 5
    assert wanted.isdisjoint(canvas.graph.cards)
    while not wanted <= canvas.graph.cards.keys():
        qt.processEvents()
    assert len(canvas.graph.cards) <= before + len(wanted) + 2
    assert canvas.filling.is_filling


def test_the_whole_drawing_fits_before_it_is_filled(slow: Any) -> None:
    assert slow.canvas.extent().height() > MANY / 20 * 200
    slow.canvas.zoom_to_fit()
    assert slow.canvas.viewer.seen().contains(slow.canvas.card_area(str(MANY)))


def test_a_robot_moves_on_while_it_fills(slow: Any, qt: QApplication) -> None:
    slow.canvas.set_live(LiveView(active=frozenset({"2", str(MANY)})))
    let_fill(slow, qt)
    assert slow.canvas.look.live is not None


def test_closing_ends_it(slow: Any, qt: QApplication) -> None:
    slow.canvas.close()
    slow.canvas.deleteLater()
    qt.processEvents()
