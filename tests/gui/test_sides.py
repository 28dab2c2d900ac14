"""Two documents side by side in one window: groups of tabs, and which of them commands go to."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.conftest import Studio

from situ_studio.views.showing import showing

CONTROL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton
SCRIPT = "conversation.spds.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def two(studio: Start, project: Copy) -> Any:
    """The application at the left and the right, where its tab is the only one."""
    used = studio(project("conversation"))
    used.key(Qt.Key.Key_Backslash, CONTROL)
    return used


def open_in(used: Any) -> list[list[str]]:
    return [group.tabs.files() for group in used.window.sides.groups]


def drag_tab(used: Any, bar: Any, to: QPoint) -> None:
    """Drags the chosen tab to a point of the screen."""
    start = bar.tabRect(bar.currentIndex()).center()
    QTest.mousePress(bar, LEFT, pos=start)
    end = bar.mapFromGlobal(to)
    for step in range(1, 6):
        QTest.mouseMove(bar, start + (end - start) * step / 5)
    used.settle()
    used.landing = used.window.sides._landing.isVisible()
    QTest.mouseRelease(bar, LEFT, pos=end)
    used.settle()


def test_commands_and_the_inspector_follow_the_side_that_has_the_focus(
    studio: Start, project: Copy
) -> None:
    used = two(studio, project)
    window = used.window
    left, right = window.sides.groups
    application = right.current_file
    assert application == left.current_file
    assert left.current_view is not right.current_view
    assert right.current_view.canvas.isVisible()
    assert left.current_view.canvas.isVisible()
    window.open_file(SCRIPT)
    used.key(Qt.Key.Key_2, CONTROL)
    assert (left.current_view.shown_as, right.current_view.shown_as) == ("graph", "outline")
    used.click(left.current_view.canvas.viewer.viewport(), QPoint(5, 5))
    assert window.sides.current is left
    assert window.current_file == application
    assert left.tabs.bar.property("aside") is False
    assert right.tabs.bar.property("aside") is True
    used.select("state", "2")
    assert window.inspector.place == ("state", "2")
    # A form is filled in for the side that was used last.
    used.fill(window.inspector.form.field("name"), "rest")
    assert used.session.document(application).state("2").name == "rest"
    used.click_row(right.current_view.twin.tree, right.current_view.twin.model.index(0, 0))
    assert window.current_file == SCRIPT
    used.key(Qt.Key.Key_Z, CONTROL)
    assert window.sides.current is left, "what is undone is shown where it is open"


def test_a_document_that_is_open_at_both_sides_is_the_same_in_both(
    studio: Start, project: Copy
) -> None:
    used = two(studio, project)
    left, right = used.window.sides.groups
    used.key(Qt.Key.Key_2, CONTROL)
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), "rest")
    assert used.row_with(right.current_view.twin.tree, "rest", 1).isValid()
    named = [node.name() for node in left.current_view.canvas.graph.all_nodes()]
    assert "rest" in named


def test_a_tab_is_dragged_to_the_right_half_and_back(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    sides = used.window.sides
    application = used.window.current_file
    used.window.open_file(SCRIPT)
    used.settle()
    middle = sides.mapToGlobal(QPoint(sides.width() // 4, sides.height() // 2))
    drag_tab(used, used.window.tabs.bar, middle)
    assert not used.landing
    assert len(open_in(used)) == 1
    right = sides.mapToGlobal(QPoint(sides.width() * 3 // 4, sides.height() // 2))
    drag_tab(used, used.window.tabs.bar, right)
    assert used.landing
    assert SCRIPT not in open_in(used)[0]
    assert open_in(used)[1] == [SCRIPT]
    assert used.window.current_file == SCRIPT
    assert sides.groups[0].current_file == application
    assert abs(sides.groups[0].width() - sides.groups[1].width()) < 10
    # Its side goes with the last tab.
    drag_tab(used, used.window.tabs.bar, middle)
    assert len(open_in(used)) == 1
    assert SCRIPT in open_in(used)[0]
    assert used.window.current_file == SCRIPT
    assert used.window.current_view.canvas.viewer.hasFocus()


def test_a_tab_that_is_moved_within_its_strip_lands_nowhere_else(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    used.window.resize(1000, 700)
    used.settle()
    sides, bar = used.window.sides, used.window.tabs.bar
    end = bar.mapToGlobal(QPoint(bar.width() - 5, bar.height() // 2))
    assert sides.mapFromGlobal(end).x() > sides.width() // 2
    file = used.window.current_file
    drag_tab(used, bar, end)
    assert not used.landing
    assert not sides._landing.isVisible()
    assert open_in(used)[0][-1] == file


def test_the_left_side_can_be_closed_too_and_tells_what_it_told(
    studio: Start, project: Copy
) -> None:
    used = two(studio, project)
    left, right = used.window.sides.groups
    used.window.notice.ask("Something to know.")
    used.click(left.current_view.canvas.viewer.viewport(), QPoint(5, 5))
    while used.window.sides.current is left:
        used.key(Qt.Key.Key_W, CONTROL)
    assert used.window.sides.groups == [right]
    assert used.window.notice.isVisible()
    assert right.isAncestorOf(used.window.notice)


def test_the_only_strip_keeps_its_last_tab(studio: Start, project: Copy) -> None:
    used = two(studio, project)
    for _ in range(9):
        used.key(Qt.Key.Key_W, CONTROL)
    assert [len(files) for files in open_in(used)] == [1]
    assert used.window.current_view is not None


def test_a_language_that_is_chosen_leaves_both_sides_as_they_were(
    studio: Start, project: Copy
) -> None:
    used = two(studio, project)
    used.window.open_file(SCRIPT)
    used.window.show_mode("outline")
    used.settle()
    used.window.sides.set_sizes((300, 500))
    used.settle()
    before = showing(used.window)
    windows = used.window.windows
    windows.choose_language("ja")
    QApplication.processEvents()
    after = Studio(windows.windows[0])
    after.settle()
    shown = showing(after.window)
    windows.choose_language("en")
    QApplication.processEvents()
    assert shown.groups == before.groups
    assert shown.current == before.current == 1
    assert shown.widths == before.widths
