"""The tabs of documents: dragged, closed, opened again, walked along, and when there are many."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QContextMenuEvent, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
LEFT, MIDDLE = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton
NONE = Qt.KeyboardModifier.NoModifier

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def middle_of(used: Any, file: str) -> QPoint:
    tabs = used.window.tabs
    room: QRect = tabs.bar.tabRect(tabs.files().index(file))
    return room.center()


def drag(used: Any, file: str, to: QPoint) -> None:
    """Drags a tab with the left button."""
    bar, at = used.window.tabs.bar, middle_of(used, file)
    QTest.mousePress(bar, LEFT, pos=at)
    for step in range(1, 6):
        QTest.mouseMove(bar, at + (to - at) * step / 5)
        used.settle()
    QTest.mouseRelease(bar, LEFT, pos=to)
    used.settle()


def open_menu() -> QMenu:
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    return menu


def pick(used: Any, text: str) -> None:
    """An entry of the menu that is open."""
    menu = open_menu()
    action = next(a for a in menu.actions() if a.text() == text)
    QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(action).center())
    used.settle()


def three(studio: Start, project: Copy) -> Any:
    used = studio(project("reception"))
    used.window.open_file("modules.xml")
    used.settle()
    return used


def with_parts(folder: Path, count: int) -> list[str]:
    """The example with so many parts more; their files."""
    text = (folder / "register.rbd.xml").read_text(encoding="utf-8")
    files = [f"a-part-with-a-name-{number}.rbd.xml" for number in range(count)]
    for file in files:
        (folder / file).write_text(text, encoding="utf-8")
    main = folder / "reception.rbd.xml"
    states = "".join(
        f'<state no="{100 + number}"><flow src="{file}"/></state>'
        for number, file in enumerate(files)
    )
    old = main.read_text(encoding="utf-8")
    main.write_text(old.replace("</application>", f"{states}</application>"), encoding="utf-8")
    return files


def test_a_tab_is_dragged_to_another_place(studio: Start, project: Copy) -> None:
    used = three(studio, project)
    drag(used, "modules.xml", middle_of(used, "reception.rbd.xml") - QPoint(20, 0))
    assert used.window.tabs.files() == ["modules.xml", "reception.rbd.xml", "register.rbd.xml"]
    assert used.window.current_file == "modules.xml"


def test_control_tab_walks_along_the_tabs_as_they_lie(studio: Start, project: Copy) -> None:
    used = three(studio, project)
    drag(used, "modules.xml", middle_of(used, "reception.rbd.xml") - QPoint(20, 0))
    walked = []
    for _ in range(3):
        used.key(Qt.Key.Key_Tab, CONTROL)
        walked.append(used.window.current_file)
    assert walked == ["reception.rbd.xml", "register.rbd.xml", "modules.xml"]
    used.key(Qt.Key.Key_Backtab, CONTROL | SHIFT)
    assert used.window.current_file == "register.rbd.xml"


def test_the_middle_button_closes_the_tab_under_it(studio: Start, project: Copy) -> None:
    used = three(studio, project)
    QTest.mouseClick(used.window.tabs.bar, MIDDLE, NONE, middle_of(used, "register.rbd.xml"))
    used.settle()
    assert used.window.tabs.files() == ["reception.rbd.xml", "modules.xml"]
    assert used.window.current_file == "modules.xml"


def test_the_middle_button_does_not_close_the_last_tab(studio: Start, project: Copy) -> None:
    used = three(studio, project)
    for file in ("register.rbd.xml", "modules.xml", "reception.rbd.xml"):
        QTest.mouseClick(used.window.tabs.bar, MIDDLE, NONE, middle_of(used, file))
        used.settle()
    assert used.window.tabs.files() == ["reception.rbd.xml"]


def test_closed_tabs_come_back_where_they_were_the_last_one_first(
    studio: Start, project: Copy
) -> None:
    used = three(studio, project)
    action = used.window.actions_.actions["reopen_tab"]
    assert not action.isEnabled()
    used.window.tabs.choose("register.rbd.xml")
    used.key(Qt.Key.Key_W, CONTROL)
    used.key(Qt.Key.Key_W, CONTROL)
    assert used.window.tabs.files() == ["reception.rbd.xml"]
    used.key(Qt.Key.Key_T, CONTROL | SHIFT)
    assert used.window.current_file == "modules.xml"
    used.key(Qt.Key.Key_T, CONTROL | SHIFT)
    assert used.window.tabs.files() == ["reception.rbd.xml", "register.rbd.xml", "modules.xml"]
    assert used.window.current_file == "register.rbd.xml"
    used.window.actions_.refresh()
    assert not action.isEnabled()


def test_what_is_not_saved_has_a_dot_until_it_is(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    bar = used.window.tabs.bar
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), "hello")
    assert [bar.tabText(0), bar.tabText(1)] == ["reception •", "register"]
    assert bar.tabToolTip(0) == "reception.rbd.xml, not saved"
    used.key(Qt.Key.Key_S, CONTROL)
    assert bar.tabText(0) == "reception"


def test_the_menu_of_a_tab_closes_the_others(studio: Start, project: Copy) -> None:
    used = three(studio, project)
    bar = used.window.tabs.bar
    at = middle_of(used, "register.rbd.xml")
    asked = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, bar.mapToGlobal(at))
    QApplication.sendEvent(bar, asked)
    pick(used, "Close the others")
    assert used.window.tabs.files() == ["register.rbd.xml"]
    assert used.window.current_file == "register.rbd.xml"


def test_many_documents_are_listed_and_all_of_them_can_be_reached(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    assert not studio(folder).window.tabs.all.isVisible()
    files = with_parts(folder, 9)
    used = studio(folder)
    tabs = used.window.tabs
    assert tabs.views.isVisible()
    assert tabs.views.geometry().right() < tabs.width()
    used.click(tabs.all)
    listed = [a.text() for a in open_menu().actions()]
    assert len(listed) == 11
    pick(used, "a-part-with-a-name-8")
    assert used.window.current_file == files[8]
    room = tabs.bar.tabRect(tabs.bar.currentIndex())
    assert 0 <= room.left() < room.right() <= tabs.bar.width()


def test_an_ampersand_in_a_name_is_seen_in_tabs_and_menus_and_found(
    studio: Start, project: Copy
) -> None:
    """None of them makes a mnemonic of it."""
    folder, file = project("reception"), "tea&cake.rbd.xml"
    main = folder / "reception.rbd.xml"
    (folder / file).write_bytes((folder / "register.rbd.xml").read_bytes())
    state = '<state no="100"><flow src="tea&amp;cake.rbd.xml"/></state></application>'
    written = main.read_text(encoding="utf-8").replace("</application>", state)
    main.write_text(written, encoding="utf-8")
    used = studio(folder)
    window, tabs = used.window, used.window.tabs
    window.open_file(file)
    index = tabs.files().index(file)
    assert QKeySequence.mnemonic(tabs.bar.tabText(index)).isEmpty()
    document = window.session.document(file)
    after = replace(document, name="Tea &cake")
    window.session.commit(file, after, "Rename it Tea &cake")
    used.settle()
    tabs._show_all()
    assert open_menu().actions()[index].iconText() == "tea&cake •"
    open_menu().close()
    undo = window.actions_.actions["undo"]
    assert QKeySequence.mnemonic(undo.text()).isEmpty()
    assert undo.iconText() == "Undo: Rename it Tea &cake"
    assert undo.iconText() in [found.text for found in window.commands.everything()]
