"""The whole window as a screen reader walks it: everything has a name, a role and true states."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QLabel, QTreeView

NAME, ROLE = QAccessible.Text.Name, QAccessible.Role
ACTIONABLE = {
    ROLE.Button,
    ROLE.ButtonMenu,
    ROLE.CheckBox,
    ROLE.RadioButton,
    ROLE.ComboBox,
    ROLE.EditableText,
    ROLE.Slider,
    ROLE.SpinBox,
    ROLE.PageTab,
    ROLE.ListItem,
    ROLE.TreeItem,
    ROLE.Link,
    ROLE.MenuItem,
    ROLE.Table,
    ROLE.Tree,
    ROLE.List,
}

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def every(part: Any) -> Iterator[Any]:
    """All that can be seen, outside in."""
    yield part
    for index in range(part.childCount()):
        inner = part.child(index)
        if inner is not None and inner.isValid() and not inner.state().invisible:
            yield from every(inner)


def window(used: Studio) -> Any:
    return QAccessible.queryAccessibleInterface(used.window)


def named(used: Studio, role: Any) -> list[str]:
    return [part.text(NAME) for part in every(window(used)) if part.role() == role]


def nameless(used: Studio) -> list[str]:
    """What can be used and has no name, or only that of its class or of the object."""
    found = []
    for part in every(window(used)):
        name, made = part.text(NAME), part.object()
        cell = part.tableCellInterface()
        # What is in a combo box has its name; a row has one, and cells of it may be empty.
        inside = part.parent() is not None and part.parent().role() == ROLE.ComboBox
        if part.role() not in ACTIONABLE or inside or (cell and cell.columnIndex()):
            continue
        meant = {"", made.objectName(), type(made).__name__} if made is not None else {""}
        if name.strip() in meant:
            found.append(f"{part.role()} {name!r} {made} in {part.parent().text(NAME)!r}")
    return found


def open_without_rows(used: Studio) -> list[str]:
    """Cells that say to be open or closed, and have no rows in them."""
    found = []
    for tree in used.window.findChildren(QTreeView):
        if tree.isVisible():
            for cell in every(QAccessible.queryAccessibleInterface(tree)):
                state, at = cell.state(), cell.tableCellInterface()
                closed = bool(at and at.columnIndex() and state.expandable)
                if closed or (state.expanded and not state.expandable):
                    found.append(cell.text(NAME))
    return found


def test_everything_that_can_be_used_has_a_name(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.current_view.select((("state", "1"),))
    for file in ("converse.rbd.xml", "conversation.spds.xml"):
        used.window.open_file(file)
        for way in used.window.current_view.ways_to_show:
            used.window.show_mode(way)
            used.settle()
            assert nameless(used) == [], f"{file} as {way}"
            assert open_without_rows(used) == [], f"{file} as {way}"


def test_a_rehearsal_has_names_and_none_hides_the_words_of_a_label(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    used.key(Qt.Key.Key_F5)
    assert nameless(used) == []
    hidden = [
        (label.text(), label.accessibleName())
        for label in used.window.findChildren(QLabel)
        if label.isVisible() and label.accessibleName() and label.text()
        if label.text() not in label.accessibleName()
    ]
    assert hidden == []
    used.window.rehearsing.end()


def test_one_of_several_is_heard_as_such_and_rows_say_number_and_signs(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    parts = [part for part in every(window(used)) if part.role() == ROLE.RadioButton]
    down = {part.text(NAME): bool(part.state().checked) for part in parts}
    assert {name: down[name] for name in ("Graph", "Outline", "Problems", "Find")} == {
        "Graph": True,
        "Outline": False,
        "Problems": True,
        "Find": False,
    }
    outline = QAccessible.queryAccessibleInterface(used.window.outline.list)
    rows = [outline.child(i).text(NAME) for i in range(outline.childCount())]
    assert rows[:3] == ["In every state", "1 start, start", "2 intro"]
    assert "16 register, part" in rows


def test_rows_of_the_project_say_what_each_file_is(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    tree = used.window.project_tree.tree
    cells = [part.text(NAME) for part in every(QAccessible.queryAccessibleInterface(tree))]
    assert "converse, application" in cells
    assert "conversation, script" in cells
    used.window.current_view.current_view().viewer.setFocus()
    used.select("state", "2")
    used.key(Qt.Key.Key_Delete)
    cells = [part.text(NAME) for part in every(QAccessible.queryAccessibleInterface(tree))]
    assert any(cell.startswith("converse, application, not saved") for cell in cells)
