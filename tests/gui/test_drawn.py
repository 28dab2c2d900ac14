"""Notes and frames in the window: palette, outline and form, and what is kept in the file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt

from situ.document.drawing import drawn

FILE = "reception.rbd.xml"
CONTROL = Qt.KeyboardModifier.ControlModifier
Start = Callable[..., Any]
Copy = Callable[[str], Path]


@pytest.fixture
def used(studio: Start, project: Copy) -> Any:
    return studio(project("reception"))


def beside(used: Any) -> tuple[Any, ...]:
    return drawn(used.session.document(FILE))


def test_a_note_from_the_palette_is_written_at_once_and_saved(used: Any) -> None:
    used.click(used.window.palette_.item("note"))
    used.type("Ask the ward")
    used.key(Qt.Key.Key_Return, CONTROL)
    assert beside(used)[-1].text == "Ask the ward"
    outline = used.window.outline.list
    assert used.row_with(outline, "Ask the ward").isValid()
    used.key(Qt.Key.Key_S, CONTROL)
    assert b">Ask the ward</ed:note>" in (used.session.root / FILE).read_bytes()


def test_the_outline_lists_frames_and_selects_them(used: Any) -> None:
    window = used.window
    outline = window.outline.list
    used.click_row(outline, used.row_with(outline, "Vital signs"))
    assert window.current_view.selected == (("frame", "0"),)
    assert window.current_view.canvas.selection() == (("frame", "0"),)
    assert window.inspector.place == ("frame", "0")
    assert window.status.selection.text() == "1 frame selected"


def test_the_form_changes_title_colour_and_size(used: Any) -> None:
    form = used.window.inspector
    used.select("frame", "0")
    used.fill(form.form.field("title"), "Measuring")
    assert beside(used)[1].title == "Measuring"
    used.choose(form.form.field("color"), "Violet")
    assert beside(used)[1].color == "#5d4bb0"
    used.window.fill_in(("frame", "0"))
    assert used.session.undo_text == "Change colour of the frame Measuring"
    assert used.window.current_view.selected == (("frame", "0"),)


def test_a_frame_from_the_menu_goes_round_the_selected_states(used: Any) -> None:
    window = used.window
    window.current_view.select((("state", "1"), ("state", "2")))
    window.panels.settle_selection()
    window.actions_.refresh()
    window.actions_.actions["insert.frame"].trigger()
    used.settle()
    used.type("Welcome")
    used.key(Qt.Key.Key_Return)
    frame = beside(used)[-1]
    first = used.session.document(FILE).state("1").aside.position
    assert frame.title == "Welcome"
    assert (frame.x, frame.y) == (first[0] - 24, first[1] - 44)


def test_a_note_is_added_in_the_outline_twin_too(used: Any) -> None:
    used.key(Qt.Key.Key_2, CONTROL)
    assert used.window.current_view.mode == "outline"
    used.click(used.window.palette_.item("note"))
    assert used.window.inspector.place == ("note", "1")
    used.type("For the night")
    used.key(Qt.Key.Key_Tab)
    assert beside(used)[-1].text == "For the night"
