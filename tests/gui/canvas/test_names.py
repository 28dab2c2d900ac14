"""Names on cards: whole as long as may be, and told apart by their ends where they are cut."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from situ.document.aside import NOTHING
from situ.document.problem import Problem
from situ.document.rbd import Application, Event, State
from situ_studio.canvas.card_texts import full_texts

WARNING = Problem(
    file="a", severity="warning", code="c", message="m", place=("state", "250"), mend=None
)


def shown(desk: Callable[..., Any], name: str) -> tuple[str, bool]:
    """What the card of state 250, which has a warning, shows of its name."""
    first = State(no="1", aside=NOTHING.at(230, 0))
    on = (Event(name="go", next="1"),)
    state = State(no="250", name=name, events=on, aside=NOTHING.at(0, 0))
    made = desk(Application(name="a", states=(first, state)))
    made.canvas.show_document(made.document, [WARNING])
    made.canvas.set_zoom(0.8)
    card = made.hand.card("250")
    assert card.face.mark == "warning"
    label = full_texts(card.face)[0]["name"]
    return label._text.text(), label.cut


def test_a_name_is_whole_beside_a_number_and_a_warning(desk: Callable[..., Any]) -> None:
    assert shown(desk, "ask resident 250") == ("ask resident 250", False)


def test_a_name_too_long_for_a_card_keeps_its_end(desk: Callable[..., Any]) -> None:
    words, cut = shown(desk, "ask the resident in the garden room 17")
    assert cut
    assert words.startswith("ask")
    assert words.endswith("17")
