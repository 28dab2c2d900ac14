"""Order, copies and context menus of components; by keys, between states and projects."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from PySide6.QtCore import QMimeData, QPoint, Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication
from PySide6.QtWidgets import QApplication

from situ.document.codec import write
from situ_studio.commands.component_commands import MIME

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

Table = Any


def ids(table: Table, no: str = "11") -> list[str]:
    return [c.id for c in table.document.state(no).screen.components]


def menu_at(table: Table, at: QPoint) -> list[str]:
    """What the context menu there offers, without its submenus' insides."""
    where = table.sheet.mapToGlobal(at)
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, where)
    QApplication.sendEvent(table.sheet, event)
    shown = table.used.window.context_menus.shown
    assert shown is not None
    texts = [a.text() for a in shown.actions() if not a.isSeparator()]
    shown.close()
    table.used.settle()
    return texts


def test_the_order_of_components_is_changed_by_keys_as_one_step(table: Table) -> None:
    before = write(table.document)
    assert ids(table) == ["question", "heart", "robot", "measure", "goodbye"]
    table.click("heart")
    table.used.key(Qt.Key.Key_BracketRight, CONTROL)
    assert ids(table) == ["question", "robot", "heart", "measure", "goodbye"]
    assert table.used.session.undo_text == "Bring heart forward"
    table.used.key(Qt.Key.Key_BracketRight, CONTROL | SHIFT)
    assert ids(table)[-1] == "heart"
    table.used.key(Qt.Key.Key_BracketLeft, CONTROL)
    assert ids(table)[-2] == "heart"
    table.used.key(Qt.Key.Key_BracketLeft, CONTROL | SHIFT)
    assert ids(table)[0] == "heart"
    assert table.sheet.selected == ("heart",)
    for _ in range(4):
        table.used.key(Qt.Key.Key_Z, CONTROL)
    assert write(table.document) == before


def test_components_are_copied_cut_pasted_and_duplicated_not_their_state(table: Table) -> None:
    states = len(table.document.states)
    table.click("measure")
    table.click("goodbye", held=SHIFT)
    table.used.key(Qt.Key.Key_D, CONTROL)
    assert ids(table)[-2:] == ["measure2", "goodbye2"]
    assert table.sheet.selected == ("measure2", "goodbye2")
    assert table.component("measure2").x == table.component("measure").x + 3
    assert table.used.session.undo_text == "Duplicate 2 components"
    table.used.key(Qt.Key.Key_X, CONTROL)
    assert ids(table) == ["question", "heart", "robot", "measure", "goodbye"]
    # Onto another state, where the ids and the places are free.
    table.used.select("state", "1")
    table.sheet.setFocus()
    before = ids(table, "1")
    table.used.key(Qt.Key.Key_V, CONTROL)
    assert ids(table, "1") == [*before, "measure2", "goodbye2"]
    assert table.used.window.current_view.selected[0] == ("state", "1", "screen", "measure2")
    assert len(table.document.states) == states
    table.used.key(Qt.Key.Key_C, CONTROL)
    table.used.key(Qt.Key.Key_V, CONTROL)
    assert ids(table, "1")[-2:] == ["measure3", "goodbye3"]


def test_cut_takes_away_only_what_is_copied(table: Table) -> None:
    elsewhere = ids(table, "1")
    table.used.window.select_all(
        (("state", "11", "screen", "measure"), ("state", "1", "screen", elsewhere[0]))
    )
    table.used.settle()
    table.used.window.commands.components.cut()
    assert ids(table) == ["question", "heart", "robot", "goodbye"]
    assert ids(table, "1") == elsewhere


def test_in_another_project_they_are_the_same_and_missing_pictures_are_named(
    table: Table, studio: Any, project: Any, tmp_path: Path
) -> None:
    table.click("heart")
    table.click("measure", held=SHIFT)
    table.used.key(Qt.Key.Key_C, CONTROL)
    copied = [table.component("heart"), table.component("measure")]
    assert "measure.png" in QGuiApplication.clipboard().text()
    shutil.rmtree(tmp_path / "reception")
    path = project("reception")
    (path / "media" / "measure.png").unlink()
    other = type(table)(studio(path))
    other.used.select("state", "1")
    other.sheet.setFocus()
    other.used.key(Qt.Key.Key_V, CONTROL)
    pasted = other.document.state("1").screen.components[-2:]
    assert list(pasted) == copied
    said = other.used.window.status.said.text()
    assert said == "Pasted. This project does not have measure.png: copy the files too."


def test_without_a_state_nothing_is_pasted_and_it_is_said_why(table: Table) -> None:
    table.click("heart")
    table.used.key(Qt.Key.Key_C, CONTROL)
    before = table.document
    table.used.window.select(())
    table.used.window.current_view.current_view().setFocus()
    table.used.key(Qt.Key.Key_V, CONTROL)
    assert table.document is before
    said = table.used.window.status.said.text()
    assert said == "Select a state first, then paste the components."


def test_components_that_can_not_be_read_are_not_pasted_and_it_is_said(table: Table) -> None:
    table.click("measure")
    table.used.key(Qt.Key.Key_C, CONTROL)
    copied = QGuiApplication.clipboard().mimeData().data(MIME).data()
    before = table.document
    for damaged in (b"", copied[: len(copied) // 2], b"<application name='c'/>"):
        data = QMimeData()
        data.setData(MIME, damaged)
        QGuiApplication.clipboard().setMimeData(data)
        table.used.window.say("")
        table.used.key(Qt.Key.Key_V, CONTROL)
        said = "The components on the clipboard can not be read: copy them again."
        assert table.used.window.status.said.text() == said
    assert table.document is before
    assert table.used.session.undo_text is None


def test_a_component_and_the_ground_have_context_menus_of_their_own(table: Table) -> None:
    table.click("heart")
    offered = menu_at(table, table.middle("measure"))
    assert table.sheet.selected == ("measure",)
    assert {"Cut", "Copy", "Duplicate", "Delete", "Order", "Align"} <= set(offered)
    assert "Connect one after the other" not in offered
    offered = menu_at(table, table.at(50, 50))
    assert table.sheet.selected == ()
    assert "Paste" in offered
    assert "Cut" not in offered
    table.click("heart")
    table.used.key(Qt.Key.Key_F10, SHIFT)
    shown = table.used.window.context_menus.shown
    assert "Order" in [a.text() for a in shown.actions()]
    shown.close()
    table.used.settle()


def test_in_the_designer_the_same_keys_and_menus_are_of_its_components(
    table: Table,
) -> None:
    table.used.window.show_mode("screen")
    table.used.settle()
    table.sheet = table.used.window.commands.components.sheet
    assert table.sheet.isVisible()
    table.click("measure")
    offered = menu_at(table, table.middle("measure"))
    assert {"Cut", "Copy", "Duplicate", "Delete", "Order", "Align"} <= set(offered)
    table.used.key(Qt.Key.Key_C, CONTROL)
    table.used.key(Qt.Key.Key_V, CONTROL)
    assert ids(table)[-1] == "measure2"
    assert table.sheet.selected == ("measure2",)
    table.used.key(Qt.Key.Key_BracketLeft, CONTROL | SHIFT)
    assert ids(table)[0] == "measure2"
    table.used.key(Qt.Key.Key_F2)
    table.used.type("Pulse")
    table.used.key(Qt.Key.Key_Return)
    assert table.component("measure2").text == "Pulse"
    table.used.key(Qt.Key.Key_A, CONTROL)
    assert list(table.sheet.selected) == ids(table)
