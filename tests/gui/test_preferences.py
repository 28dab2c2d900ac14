"""Preferences: what is chosen holds at once, and at the next start."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from situ_studio.commands.preferences import Preferences
from situ_studio.edits import places

CONTROL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def opened(used: Studio) -> Preferences:
    used.key(Qt.Key.Key_Comma, CONTROL)
    (shown,) = used.window.findChildren(Preferences)
    assert isinstance(shown, Preferences)
    assert shown.isVisible()
    return shown


def press(shown: Preferences, text: str, key: Qt.Key, held: Qt.KeyboardModifier) -> None:
    """Gives the command whose row has this text another key, by hand."""
    choose(shown, text)
    target: QWidget = shown.key.focusProxy() or shown.key
    QTest.keyClick(target, key, held)


def choose(shown: Preferences, text: str) -> None:
    shown.list.field.setFocus()
    QTest.keyClick(shown.list.field, Qt.Key.Key_A, CONTROL)
    QTest.keyClicks(shown.list.field, text)
    tree = shown.list.tree
    rows = [r for r in shown._rows.values() if r.text(0) == text]
    assert [r.isHidden() for r in rows] == [False]
    at = tree.visualItemRect(rows[0]).center()
    QTest.mouseClick(tree.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert tree.currentItem() is rows[0]


def close(used: Studio, shown: Preferences) -> None:
    QTest.keyClick(shown.list.tree, Qt.Key.Key_Escape)
    used.settle()
    assert used.window.findChildren(Preferences) == []


def change_name(used: Studio) -> None:
    document = used.session.document("reception.rbd.xml")
    used.window.commit(places.change(document, ("state", "2"), name="elsewhere"), "Rename")
    assert used.session.dirty


def test_another_key_for_save_holds_at_once_in_all_windows_and_at_the_next_start(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    folder = project("reception")
    used = studio(folder)
    other = used.window.windows.open_window()
    shown = opened(used)
    press(shown, "Save", Qt.Key.Key_S, ALT)
    assert shown._rows["save"].text(1) == "Alt+S"
    assert other.actions_.actions["save"].shortcut().toString() == "Alt+S"
    close(used, shown)
    change_name(used)
    used.key(Qt.Key.Key_S, CONTROL)
    assert used.session.dirty
    used.key(Qt.Key.Key_S, ALT)
    assert not used.session.dirty
    again = studio(folder)
    assert again.window is not used.window
    assert again.window.actions_.actions["save"].shortcut().toString() == "Alt+S"


def test_reset_gives_a_command_its_usual_key_again(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    used = studio(project("reception"))
    save = used.window.actions_.actions["save"]
    shown = opened(used)
    assert not shown.reset.isEnabled()
    press(shown, "Save", Qt.Key.Key_S, ALT)
    QTest.mouseClick(shown.reset, Qt.MouseButton.LeftButton)
    assert save.shortcut().toString() == "Ctrl+S"
    assert settings.value("keys/save") is None
    press(shown, "Save", Qt.Key.Key_S, ALT)
    press(shown, "Undo", Qt.Key.Key_U, CONTROL)
    QTest.mouseClick(shown.reset_all, Qt.MouseButton.LeftButton)
    assert save.shortcut().toString() == "Ctrl+S"
    assert used.window.actions_.actions["undo"].shortcut().toString() == "Ctrl+Z"
    close(used, shown)


def test_a_key_that_another_command_has_is_refused_and_told(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    shown = opened(used)
    press(shown, "Save", Qt.Key.Key_D, CONTROL)
    assert shown.told.text() == "Ctrl+D is the key of “Duplicate”: give that another one first."
    assert shown.key.keySequence().toString() == "Ctrl+S"
    assert used.window.actions_.actions["save"].shortcut().toString() == "Ctrl+S"
    press(shown, "Duplicate", Qt.Key.Key_D, ALT)
    press(shown, "Save", Qt.Key.Key_D, CONTROL)
    assert used.window.actions_.actions["save"].shortcut().toString() == "Ctrl+D"
    choose(shown, "Duplicate")
    QTest.mouseClick(shown.reset, Qt.MouseButton.LeftButton)
    assert shown.told.text() == "Ctrl+D is the key of “Save”: give that another one first."
    assert used.window.actions_.actions["duplicate"].shortcut().toString() == "Alt+D"
    close(used, shown)


@pytest.mark.parametrize(
    ("key", "held", "told"),
    [
        (Qt.Key.Key_S, Qt.KeyboardModifier.NoModifier, "S alone writes or moves"),
        (Qt.Key.Key_F, ALT, "Alt+F opens a menu"),
        (Qt.Key.Key_Left, CONTROL, "Ctrl+Left moves the selected cards"),
    ],
)
def test_keys_of_texts_menus_and_canvases_are_refused(
    studio: Start, key: Qt.Key, held: Qt.KeyboardModifier, told: str
) -> None:
    used = studio()
    shown = opened(used)
    press(shown, "Save", key, held)
    assert shown.told.text().startswith(told)
    assert used.window.actions_.actions["save"].shortcut().toString() == "Ctrl+S"
    close(used, shown)


def test_a_key_of_the_table_is_only_of_the_command_that_a_person_gave_it(
    studio: Start, settings: QSettings
) -> None:
    settings.setValue("keys/save", "Ctrl+Z")
    used = studio()
    assert used.window.actions_.actions["save"].shortcut().toString() == "Ctrl+Z"
    assert used.window.actions_.actions["undo"].shortcuts() == []


def test_the_field_that_finds_anything_tells_its_key(studio: Start, settings: QSettings) -> None:
    settings.setValue("keys/find", "Ctrl+P")
    assert studio().window.search_keys.text() == "Ctrl P"


def test_colours_and_language_are_chosen_in_the_preferences(
    studio: Start, project: Copy, settings: QSettings
) -> None:
    used = studio(project("reception"))
    shown = opened(used)
    shown.colours.setFocus()
    QTest.keyClick(shown.colours, Qt.Key.Key_End)
    assert used.window.theme.name == "dark"
    assert settings.value("theme") == "dark"
    shown.language.setFocus()
    QTest.keyClick(shown.language, Qt.Key.Key_Down)
    used.settle()
    assert settings.value("language") == "en"
