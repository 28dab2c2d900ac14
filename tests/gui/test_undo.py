"""Undo and redo: selection and view come back, and several documents are one step."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPointF, Qt

from situ_studio.commands.menus import Actions
from situ_studio.edits import places
from situ_studio.window.panels_side import PanelsSide

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def test_undo_and_redo_bring_back_where_the_canvas_looked(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.canvas
    used.select("state", "1")
    canvas.look_at((0.8, -40.0, -40.0))
    used.key(Qt.Key.Key_Right, CONTROL)
    canvas.look_at((1.5, 900.0, 700.0))
    used.key(Qt.Key.Key_Z, CONTROL)
    assert canvas.looking() == (0.8, -40.0, -40.0)
    canvas.look_at((1.5, 900.0, 700.0))
    used.key(Qt.Key.Key_Z, CONTROL | SHIFT)
    assert canvas.looking() == (0.8, -40.0, -40.0)


def test_what_redo_selects_is_brought_into_view(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    canvas = used.window.current_view.canvas
    used.select("state", "1")
    canvas.look_at((1.0, 4000.0, 4000.0))
    used.window.actions_.actions["duplicate"].trigger()
    used.settle()
    (new,) = used.window.current_view.selected
    used.key(Qt.Key.Key_Z, CONTROL)
    used.key(Qt.Key.Key_Z, CONTROL | SHIFT)
    assert used.window.current_view.selected == (new,)
    card = canvas.card_area(canvas.graph.cards and canvas._find(new)[0])
    assert canvas.viewer.seen().contains(QPointF(card.center()))


def test_a_step_over_several_documents_is_taken_back_as_one(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    session = used.session
    files = ("reception.rbd.xml", "register.rbd.xml")
    before = {f: session.document(f) for f in files}
    after = {f: places.change(before[f], (), name=f"{before[f].name}-two") for f in files}
    assert session.commit_all(after, "Rename two")
    assert session.undo_text == "Rename two"
    used.key(Qt.Key.Key_Z, CONTROL)
    assert all(session.document(f) is before[f] for f in files)
    assert session.undo_text is None
    used.key(Qt.Key.Key_Z, CONTROL | SHIFT)
    assert all(session.document(f) is after[f] for f in files)
    assert used.window.current_file == "reception.rbd.xml"


def test_an_edit_is_told_to_files_and_commands_once(
    studio: Start, project: Copy, monkeypatch: pytest.MonkeyPatch
) -> None:
    used = studio(project("reception"))
    window = used.window
    used.select("state", "2")
    told: list[str] = []

    def count(what: type, name: str) -> None:
        there = getattr(what, name)

        def counted(one: object) -> None:
            told.append(name)
            there(one)

        monkeypatch.setattr(what, name, counted)

    count(PanelsSide, "settle_files")
    count(Actions, "refresh")
    shown = window.current_file
    after = places.change(window.current_document, ("state", "2"), name="hello there")
    window.commit(after, "Rename state 2")
    assert sorted(told) == ["refresh", "settle_files"]
    assert window.actions_.actions["undo"].isEnabled()
    # As much for a document that is not shown.
    window.open_file("modules.xml")
    told.clear()
    again = places.change(after, ("state", "2"), name="hello")
    window.commit(again, "Rename state 2", shown)
    assert sorted(told) == ["refresh", "settle_files"]
