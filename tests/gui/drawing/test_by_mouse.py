"""What is pointed at is what is worked on, whatever was worked on before."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from tests.gui.drawing.applications import ApplicationDrawer

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def test_a_card_is_chosen_after_what_one_of_its_ways_does(studio: Start, project: Copy) -> None:
    """What is done on a way has its pipe selected; a click on the card is the card again."""
    used = studio(project("reception"))
    me = ApplicationDrawer(used.window)
    used.select("state", "4", "event", "0")
    me.press("Set value")
    assert used.window.inspector.place == ("state", "4", "event", "0", "action", "0")
    assert me.canvas.selection() == (("state", "4", "event", "0"),)
    assert len(me.canvas.viewer.selected_pipes()) == 1
    me.click_state("4")
    assert used.window.inspector.place == ("state", "4")


def test_a_card_is_chosen_after_one_of_its_rows(studio: Start, project: Copy) -> None:
    """An event that leads nowhere has no pipe, but a row on the card."""
    used = studio(project("reception"))
    me = ApplicationDrawer(used.window)
    me.click_state("4")
    me.press("Event")
    place = used.window.inspector.place
    assert me.canvas.selection() == (place,)
    assert me.canvas.viewer.selected_pipes() == []
    me.click_state("4")
    assert used.window.inspector.place == ("state", "4")
