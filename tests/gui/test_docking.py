"""Panels: they dock, float and close, and come back where they were."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QPoint, QSettings, Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

Start = Callable[..., Any]
Copy = Callable[[str], Path]
LEFT = Qt.MouseButton.LeftButton

AWAY = ("designer", "rehearsal", "moment")
"""Panels that come with what they are about."""


def drag_line(used: Any, at: QPoint, by: QPoint) -> None:
    """Drags the line between two panels that lies at a place of the window."""
    QTest.mousePress(used.window, LEFT, pos=at)
    QTest.mouseMove(used.window, at + by)
    used.settle()
    QTest.mouseRelease(used.window, LEFT, pos=at + by)
    used.settle()


def widen(used: Any, name: str, by: int) -> None:
    """Drags the line at the right of a panel."""
    room = used.window.docks[name].geometry()
    drag_line(used, QPoint(room.right() + 1, room.center().y()), QPoint(by, 0))


def choose(used: Any, name: str, text: str) -> None:
    """An entry of the menu that the right button opens on a panel's header."""
    header = used.window.docks[name].titleBarWidget()
    middle = header.rect().center()
    asked = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, middle, header.mapToGlobal(middle))
    QApplication.sendEvent(header, asked)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    action = next(a for a in menu.actions() if a.text() == text)
    QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(action).center())
    used.settle()


def test_a_panel_closed_from_its_header_stays_closed_the_next_time(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    choose(used, "palette", "Close")
    assert not used.window.docks["palette"].isVisible()
    used.window.close()
    again = studio(used.session.root)
    assert not again.window.docks["palette"].isVisible()
    assert again.window.docks["outline"].isVisible()


def test_another_project_in_the_window_leaves_the_panels_as_they_are(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.window.docks["outline"].toggleViewAction().trigger()
    used.window.open_project(project("conversation"))
    used.settle()
    assert not used.window.docks["outline"].isVisible()
    used.window.welcoming.show()
    used.settle()
    assert not any(dock.isVisible() for dock in used.window.docks.values())
    used.window.welcoming.leave()
    used.settle()
    assert not used.window.docks["outline"].isVisible()
    assert used.window.docks["project"].isVisible()


def test_what_was_closed_before_the_welcome_page_is_kept_when_the_studio_ends_there(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.window.docks["outline"].toggleViewAction().trigger()
    used.window.welcoming.show()
    used.window.close()
    again = studio(used.session.root)
    assert not again.window.docks["outline"].isVisible()
    assert again.window.docks["project"].isVisible()


def test_a_width_that_a_person_gave_outlasts_the_window_and_its_size(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    before = used.window.docks["project"].width()
    widen(used, "project", 60)
    assert used.window.docks["project"].width() == before + 60
    used.window.resize(1500, 900)
    used.settle()
    assert used.window.docks["project"].width() == before + 60
    used.window.close()
    again = studio(used.session.root)
    assert again.window.docks["project"].width() == before + 60


def test_a_panel_floats_by_a_double_click_and_does_so_the_next_time(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    dock = used.window.docks["inspector"]
    QTest.mouseDClick(dock.titleBarWidget(), LEFT, pos=dock.titleBarWidget().rect().center())
    used.settle()
    assert dock.isFloating()
    used.window.close()
    again = studio(used.session.root).window.docks["inspector"]
    assert again.isFloating()
    assert again.isVisible()


def test_a_floating_panel_lies_where_it_lay_when_it_docks_again(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    dock = used.window.docks["inspector"]
    before = dock.geometry()
    choose(used, "inspector", "Float")
    assert dock.isFloating()
    choose(used, "inspector", "Dock again")
    assert not dock.isFloating()
    assert dock.geometry() == before


def test_window_and_panel_of_a_screen_that_is_gone_come_back_on_one_that_is_there(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.window.docks["inspector"].setFloating(True)
    used.window.docks["inspector"].move(6000, 4000)
    used.window.move(5000, 3000)
    used.settle()
    used.window.close()
    again = studio(used.session.root).window
    there = QGuiApplication.primaryScreen().availableGeometry()
    assert there.contains(again.docks["inspector"].geometry().topLeft())
    assert there.contains(again.geometry().topLeft())


def test_reset_layout_puts_every_panel_where_it_lies_at_first(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    first = {name: dock.geometry() for name, dock in window.docks.items()}
    widen(used, "project", 80)
    window.docks["inspector"].setFloating(True)
    window.docks["outline"].close()
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, window.docks["palette"])
    used.click(window.bottom.button("problems"))
    assert window.bottom.is_folded
    window.actions_.actions["reset_layout"].trigger()
    used.settle()
    assert {name: dock.geometry() for name, dock in window.docks.items()} == first
    assert all(d.isVisible() for n, d in window.docks.items() if n not in AWAY)


def test_what_is_folded_below_stays_so_and_unfolds_to_the_height_that_it_had(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    bottom, dock = used.window.bottom, used.window.docks["bottom"]
    edge = QPoint(dock.geometry().center().x(), dock.geometry().top() - 1)
    drag_line(used, edge, QPoint(0, -50))
    high = dock.height()
    assert high > 132
    used.click(bottom.button("problems"))
    used.click(bottom.button("problems"))
    assert dock.height() == high
    used.click(bottom.button("problems"))
    used.window.close()
    assert studio(used.session.root).window.bottom.is_folded


def test_another_panel_below_is_as_high_as_a_person_made_the_one_before(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    bottom, dock = used.window.bottom, used.window.docks["bottom"]
    used.click(bottom.button("problems"))
    used.click(bottom.button("problems"))
    edge = QPoint(dock.geometry().center().x(), dock.geometry().top() - 1)
    drag_line(used, edge, QPoint(0, -150))
    high = dock.height()
    for name in ("find", "problems", "scenarios", "find"):
        used.click(bottom.button(name))
        assert dock.height() == high
    used.click(used.window.status.errors)
    assert dock.height() == high


def test_tabs_below_that_have_no_room_are_in_a_menu_and_the_chosen_one_is_always_seen(
    studio: Start, project: Copy
) -> None:
    used = studio(project("conversation"))
    bottom = used.window.bottom
    for name in bottom.names:
        bottom.set_shown(name, True)
    used.settle()
    assert all(bottom.button(name).isVisible() for name in bottom.names)
    assert not bottom.more.isVisible()
    used.window.resize(800, 700)
    used.settle()
    tabs = [name for name in bottom.names if bottom.button(name).isVisible()]
    assert tabs == list(bottom.names[: len(tabs)])
    assert all(bottom.button(name).width() >= 64 for name in tabs)
    assert "find" not in tabs
    used.click(bottom.more)
    (menu,) = (one for one in bottom.findChildren(QMenu) if one.isVisible())
    assert len(menu.actions()) == len(bottom.names) - len(tabs)
    wanted = menu.actions()[-1]
    assert wanted.text() == "Find"
    QTest.mouseClick(menu, Qt.MouseButton.LeftButton, pos=menu.actionGeometry(wanted).center())
    used.settle()
    assert bottom.current == "find"
    assert bottom.button("find").isVisible()
    assert bottom.button("problems").isVisible()
    used.window.resize(1280, 800)
    used.settle()
    assert all(bottom.button(name).isVisible() for name in bottom.names)
    assert not bottom.more.isVisible()


def test_a_layout_that_can_not_be_read_is_the_first_one(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    settings.setValue("panels", QByteArray(b"of another program"))
    window = studio(project("reception")).window
    assert all(d.isVisible() for n, d in window.docks.items() if n not in AWAY)
    assert window.docks["project"].width() == 208


def test_the_first_start_keeps_no_layout_before_a_project_was_open(
    studio: Start, settings: QSettings
) -> None:
    studio().window.close()
    assert settings.value("panels") is None


def test_the_panel_below_keeps_its_height_when_something_is_looked_for(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    high = used.window.docks["bottom"].height()
    used.key(Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    assert used.window.bottom.current == "find"
    assert used.window.docks["bottom"].height() == high
