"""The plus beside *Project*, and the sections of the project's form as Ctrl+K finds them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu
from tests.gui.test_newcomer import CONTROL

from situ_studio.project_form.form import ProjectForm
from situ_studio.project_form.found import sections

Start = Callable[..., Any]


def open_menu() -> QMenu:
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    return menu


def press(used: Any, text: str) -> None:
    """An entry of the menu that is open, by the arrow keys."""
    menu = open_menu()
    texts = [one.text() for one in menu.actions() if one.isVisible()]
    assert text in texts, texts
    while menu.activeAction() is None or menu.activeAction().text() != text:
        QTest.keyClick(menu, Qt.Key.Key_Down)
    QTest.keyClick(menu, Qt.Key.Key_Return)
    used.settle()


def test_a_project_is_added_to_where_its_documents_are_listed(
    studio: Start, tmp_path: Path
) -> None:
    used = studio()
    used.answers.put("new_folder", str(tmp_path))
    used.answers.put("name", "ward")
    used.click(used.window.welcome.new)
    used.click(used.window.project_menu.button)
    press(used, "Script of situations")
    assert used.window.tabs.chosen_file == "ward.spds.xml"

    # From a row, by the other button: an application more. There is a script already.
    tree = used.window.project_tree.tree
    at = QPoint(30, 30)
    asked = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, tree.viewport().mapToGlobal(at))
    QApplication.sendEvent(tree.viewport(), asked)
    assert "Script of situations" not in [a.text() for a in open_menu().actions() if a.isVisible()]
    used.answers.put("name", "night")
    press(used, "New application…")
    assert used.window.tabs.chosen_file == "night.rbd.xml"
    used.click(used.window.project_menu.button)
    used.answers.put("name", "ja")
    press(used, "Language…")
    assert used.session.project.languages == ("en", "ja")

    # What has a title in the form is found by it, and the form is there.
    for place, title, _ in sections():
        used.key(Qt.Key.Key_K, CONTROL)
        used.type(title)
        used.key(Qt.Key.Key_Return)
        form = used.window.findChild(ProjectForm)
        focus = QApplication.focusWidget()
        shown = [*form.sections.values(), form.readings]
        section = next(one for one in shown if one.title.text() == title)
        assert focus is not None
        assert section.isAncestorOf(focus), place
        assert not focus.visibleRegion().isEmpty(), place
    assert {title for _, title, _ in sections()} == {one.title.text() for one in shown}
