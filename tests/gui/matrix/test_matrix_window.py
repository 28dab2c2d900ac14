"""The matrix in the window: beside the graph, with the window's own commands and panels."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ_studio.matrix.table import Area

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def script(studio: Start, folder: Path) -> Any:
    used = studio(folder)
    used.window.open_file("conversation.spds.xml")
    used.settle()
    return used


def click(used: Any, situation: str, module: str) -> None:
    view = used.window.current_view.piece("matrix")
    index = view.model.index(view.model.grid.row(situation), view.model.modules.index(module))
    view.table.scrollTo(index)
    spot: QPoint = view.table.visualRect(index).center()
    QTest.mouseClick(view.table.viewport(), LEFT, pos=spot)
    used.settle()


def own(used: Any, situation: str) -> dict[str, int | None]:
    return {e.module: e.priority for e in used.window.current_document.situation(situation).entries}


def test_a_cell_is_edited_below_the_graph_and_everything_shows_it(
    studio: Start, project: Copy
) -> None:
    used = script(studio, project("conversation"))
    window = used.window
    used.click(window.tabs.views.button("both"))
    view = window.current_view
    canvas, matrix = view.piece("graph"), view.piece("matrix")
    assert canvas.isVisible()
    assert canvas.mapTo(window, QPoint()).y() < matrix.mapTo(window, QPoint()).y()
    click(used, "sound", "nod")
    assert window.inspector.place == ("situation", "sound")
    assert canvas.selection() == (("situation", "sound"),)
    for keys in ("7", "5"):
        used.type(keys)
    used.key(Qt.Key.Key_Return)
    assert own(used, "sound") == {"gaze-sound": 60, "nod": 75}
    assert window.session.undo_text == "Give nod the priority 75 in sound"
    pills = [canvas.graph.pipe(i).link.priority for i in canvas.graph.links]
    assert 75 in pills
    # The keys of the window's commands are the table's while somebody is in it.
    click(used, "sound", "gaze-sound")
    used.key(Qt.Key.Key_Delete)
    assert own(used, "sound") == {"nod": 75}
    used.key(Qt.Key.Key_D, CONTROL)
    assert own(used, "sound") == {"nod": 75}, "nothing stands above"
    used.key(Qt.Key.Key_F2)
    assert matrix.table.viewport().isAncestorOf(QApplication.focusWidget())
    used.key(Qt.Key.Key_Escape)
    window.actions_.actions["copy"].trigger()
    assert QApplication.clipboard().text() == "\n"
    for _ in range(2):
        used.key(Qt.Key.Key_Z, CONTROL)
    assert own(used, "sound") == {"gaze-sound": 60}
    assert window.session.dirty == []
    canvas.select((("situation", "invited"),))
    canvas.selection_changed.emit((("situation", "invited"),))
    used.settle()
    assert matrix.table.area == Area(*_at(matrix, "invited", "gaze-sound"))
    window.select(("module", "nod"))
    assert matrix.table.heads.chosen == {3}
    # What is supposed is seen in the drawing above, while the strip is.
    matrix.what_if.suppose("sound.slap", 0)
    assert canvas.look.live.situation == "sound"
    assert canvas.look.live.authority["head"] == "gaze-sound"
    window.show_mode("graph")
    assert canvas.look.live is None
    window.show_mode("both")
    matrix.what_if.suppose_nothing()
    assert canvas.look.live is None


def _at(matrix: Any, situation: str, module: str) -> tuple[int, int]:
    return matrix.model.grid.row(situation), matrix.model.modules.index(module)


def test_the_matrix_is_used_with_keys_only(studio: Start, project: Copy) -> None:
    used = script(studio, project("conversation"))
    used.key(Qt.Key.Key_6, CONTROL)
    matrix = used.window.current_view.piece("matrix")
    assert used.window.current_view.shown_as == "matrix"
    assert matrix.table.hasFocus()
    assert matrix.table.area == Area(0, 0)
    used.type("5")
    used.key(Qt.Key.Key_Return)
    assert own(used, "stopped") == {"transfer": 5}
    used.key(Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    names = [s.name for s in used.window.current_document.situations]
    assert names[1:3] == ["called", "invited"]
    used.key(Qt.Key.Key_K, CONTROL)
    used.type("rename")
    used.key(Qt.Key.Key_Return)
    used.type("asked")
    used.key(Qt.Key.Key_Return)
    names = [s.name for s in used.window.current_document.situations]
    assert names[1:3] == ["called", "asked"]
    assert matrix.table.hasFocus()
    used.key(Qt.Key.Key_5, CONTROL)
    canvas = used.window.current_view.piece("graph")
    assert canvas.isAncestorOf(QApplication.focusWidget())
    used.key(Qt.Key.Key_F6)
    assert matrix.table.hasFocus()
    used.key(Qt.Key.Key_F6)
    assert not used.window.current_view.isAncestorOf(QApplication.focusWidget())


def test_a_problem_found_later_is_marked_at_its_cell(
    studio: Start, project: Copy, comes: Callable[[Any], None]
) -> None:
    used = script(studio, project("conversation"))
    used.window.show_mode("matrix")
    click(used, "accepted", "nod")
    for keys in ("2", "0"):
        used.type(keys)
    used.key(Qt.Key.Key_Return)
    used.window.session.check_now()
    used.settle()
    matrix = used.window.current_view.piece("matrix")
    row, column = _at(matrix, "accepted", "nod")
    tip = matrix.model.index(row, column).data(Qt.ItemDataRole.ToolTipRole)
    assert "who asked first would win" in tip
    assert matrix.model.index(row, len(matrix.model.modules) + 1).data() == "tie"


def test_the_context_menu_of_the_cells_has_what_is_done_with_a_range(
    studio: Start, project: Copy
) -> None:
    used = script(studio, project("conversation"))
    used.window.show_mode("matrix")
    click(used, "called", "face-caller")
    used.key(Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    table = used.window.current_view.piece("matrix").table
    QApplication.postEvent(
        table.viewport(),
        QContextMenuEvent(
            QContextMenuEvent.Reason.Mouse,
            table.visualRect(table.currentIndex()).center(),
            table.viewport().mapToGlobal(table.visualRect(table.currentIndex()).center()),
        ),
    )
    used.settle()
    menu = used.window.context_menus.shown
    inside = [a for one in menu.actions() if one.menu() for a in one.menu().actions()]
    texts = [a.text() for a in (*menu.actions(), *inside)]
    wanted = ["Cut", "Copy", "Paste", "Fill down", "Fill to the right", "Clear the cells", "Rename"]
    assert [text for text in wanted if text not in texts] == []
    assert "Duplicate" not in texts
    menu.close()
    used.settle()
    used.window.actions_.actions["cells.fill_down"].trigger()
    assert own(used, "sound") == {"gaze-sound": 60, "face-caller": 70}
    used.window.show_mode("graph")
    assert not used.window.actions_.actions["cells.fill_down"].isEnabled()
