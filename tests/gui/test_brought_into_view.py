"""What is selected is seen in the view that one changes to."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def test_a_priority_is_seen_in_graph_and_matrix_when_both_are_shown(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    window = used.window
    window.open_file("conversation.spds.xml")
    used.settle()
    place = ("situation", "conversation", "entry", "0")
    used.select(*place)
    used.click(window.tabs.views.button("both"))
    view = window.current_view
    table = view.piece("matrix").table
    assert view.selected == (place,)
    row = table.visualRect(table.currentIndex())
    assert table.viewport().rect().contains(row)
    assert table.currentIndex().row() == 5
    assert view.canvas.viewer.seen().contains(view.canvas._area_of((place,)))


def test_a_card_is_seen_when_one_comes_from_the_outline(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    window.open_file("reception.rbd.xml")
    used.settle()
    view = window.current_view
    used.click(window.tabs.views.button("outline"))
    used.select("state", "13")
    used.click(window.tabs.views.button("graph"))
    assert view.canvas.viewer.seen().contains(view.canvas.card_area("13"))
