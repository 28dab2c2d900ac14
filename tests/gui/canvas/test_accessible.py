"""Cards in the accessible tree: screen readers find them as children of the drawing."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtGui import QAccessible

from situ.document.rbd import Application
from situ_studio.canvas.script import ScriptCanvas


def test_cards_are_children_of_the_drawing(desk: Callable[..., Any], small: Application) -> None:
    made = desk(small)
    viewer = QAccessible.queryAccessibleInterface(made.canvas.viewer)
    assert viewer.childCount() == 6
    cards = [viewer.child(i) for i in range(6)]
    names = [c.text(QAccessible.Text.Name) for c in cards]
    assert names == ["In every state", "1 start", "2 look", "3 names", "4 no user", "5 end"]
    assert cards[1].text(QAccessible.Text.Description) == (
        "Touch me to begin; touched leads to 2; human leads to 2; 30 s leads to 1"
    )
    corner = made.canvas.viewer.viewport().mapToGlobal(
        made.hand.pixel(made.hand.card("2").scenePos())
    )
    assert (cards[2].rect().topLeft() - corner).manhattanLength() <= 2
    made.canvas.select([("state", "2")])
    assert [bool(c.state().selected) for c in cards] == [False, False, True, False, False, False]


def test_a_card_that_is_gone_is_not_valid(desk: Callable[..., Any], small: Application) -> None:
    made = desk(small)
    viewer = QAccessible.queryAccessibleInterface(made.canvas.viewer)
    card = viewer.child(5)
    assert card.isValid()
    made.canvas.select([("state", "5")])
    made.canvas.delete_selection()
    assert not card.isValid()
    assert viewer.childCount() == 5
    assert viewer.child(5) is None


def test_script_nodes_too(desk: Callable[..., Any]) -> None:
    from situ.document.spds import Situation, Spds

    made = desk(Spds(name="s", situations=(Situation("talk"),)), ScriptCanvas)
    card = QAccessible.queryAccessibleInterface(made.canvas.viewer).child(0)
    assert card.text(QAccessible.Text.Name) == "talk"
    assert card.text(QAccessible.Text.Description) == "situation; number 1; always"
