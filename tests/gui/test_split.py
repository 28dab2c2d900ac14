"""The split view: the screen of the selected state beside the graph."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from situ_studio.views.table import VIEWS

CONTROL = Qt.KeyboardModifier.ControlModifier

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def split(studio: Start, folder: Path) -> Any:
    used = studio(folder)
    used.click(used.window.tabs.views.button("split"))
    return used


def at(sheet: Any, x: float, y: float) -> QPoint:
    """A place of the screen, from percents of it."""
    return QPoint(round(sheet.width() * x / 100), round(sheet.height() * y / 100))


def test_the_screen_follows_the_selection_and_says_what_is_spoken(
    studio: Start, project: Copy
) -> None:
    used = split(studio, project("reception"))
    view = used.window.current_view
    assert view.canvas.isVisible()
    assert used.window.beside.title.text() == "1 start"
    used.click_row(used.window.outline.list, used.row_with(used.window.outline.list, "main menu"))
    assert used.window.beside.title.text() == "11 main menu"
    assert used.window.beside.texts == [
        "What would you like to do? I can measure, or we say goodbye."
    ]
    used.window.select(())
    assert used.window.beside.title.text() == "11 main menu"


def test_the_screen_shows_a_change_as_it_is_made(studio: Start, project: Copy) -> None:
    used = split(studio, project("reception"))
    used.select("state", "11")
    sheet = used.window.beside.sheet
    before = sheet.grab().toImage()
    used.fill(used.window.inspector.form.field("name"), "services")
    assert used.window.beside.title.text() == "11 services"
    assert sheet.grab().toImage() == before
    component = used.session.document("reception.rbd.xml").state("11").screen.components[0]
    used.select("state", "11", "screen", component.id)
    used.fill(used.window.inspector.form.field("x"), "40")
    assert sheet.grab().toImage() != before


def test_a_click_on_the_screen_selects_what_lies_there(studio: Start, project: Copy) -> None:
    used = split(studio, project("reception"))
    used.select("state", "11")
    sheet = used.window.beside.sheet
    state = used.session.document("reception.rbd.xml").state("11")
    button = next(c for c in state.screen.components if getattr(c, "event", None))
    middle = at(sheet, button.x + button.width / 2, button.y + button.height / 2)
    used.click(sheet, middle)
    assert used.window.inspector.place == ("state", "11", "screen", button.id)
    used.click(sheet, at(sheet, 1, 99))
    assert used.window.inspector.place == ("state", "11")


def test_only_applications_have_screens_beside_them(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    button = used.window.tabs.views.button("split")
    assert button.isVisible()
    used.window.open_file("conversation.spds.xml")
    used.settle()
    assert not button.isVisible()
    used.window.show_mode("split")
    assert used.window.current_view.shown_as == "graph"


def test_split_graph_and_outline_by_their_keys(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    view = used.window.current_view
    shown = []
    for key in (Qt.Key.Key_3, Qt.Key.Key_2, Qt.Key.Key_3, Qt.Key.Key_1):
        used.key(key, CONTROL)
        shown.append((view.shown_as, view.canvas.isVisible()))
        assert used.window.tabs.views.button(view.shown_as).isChecked()
    assert shown == [("split", True), ("outline", False), ("split", True), ("graph", True)]
    assert used.window.beside is None


def test_the_line_between_graph_and_screen_stays_where_it_was_dragged(
    studio: Start, project: Copy
) -> None:
    used = split(studio, project("reception"))
    view = used.window.current_view
    line = view.room.handle(1)
    middle = line.rect().center()
    QTest.mousePress(line, Qt.MouseButton.LeftButton, pos=middle)
    QTest.mouseMove(line, middle - QPoint(60, 0))
    QTest.mouseRelease(line, Qt.MouseButton.LeftButton, pos=middle - QPoint(60, 0))
    dragged = [view.canvas.width(), view.piece("screen").width()]
    assert view.shares == {"split": dragged}
    for key in (Qt.Key.Key_2, Qt.Key.Key_3):
        used.key(key, CONTROL)
    assert [view.canvas.width(), view.piece("screen").width()] == dragged


def test_every_view_of_the_table_can_be_shown_by_its_key(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    for file in ("conversation.spds.xml", "modules.xml", "conversation.rbd.xml"):
        if used.session.document(file) is None:
            continue
        used.window.open_file(file)
        for view in VIEWS:
            action = used.window.actions_.actions[f"view.{view.name}"]
            assert action.isEnabled() == (view.name in used.window.current_view.ways_to_show)
            used.key(Qt.Key(ord(view.key[-1])), CONTROL)
            if action.isEnabled():
                assert used.window.current_view.shown_as == view.name
