"""A picture, a movie or a sound is asked for before what shows it is there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPointF, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu
from tests.gui.screens.conftest import Table

from situ.resources import example
from situ_studio.kinds import IMAGE

LEFT = Qt.MouseButton.LeftButton


def picker(used: Any) -> Any:
    return used.window.media_choice.picker


def rows(used: Any) -> list[str]:
    found = picker(used).list
    return [found.item(row).text() for row in range(found.count())]


@pytest.fixture
def step(table: Table) -> Iterator[Callable[[], str]]:
    """The name of the last step; whatever was asked is no longer there in the end."""
    yield lambda: str(table.used.session.undo_text)
    assert picker(table.used) is None


def test_a_dropped_picture_is_asked_for_and_lies_where_it_was_dropped(
    table: Table, step: Callable[[], str]
) -> None:
    count, before = len(table.components), step()
    assert table.drop("image", table.at(50, 50))
    assert "robot.png" in rows(table.used)
    assert "chime.wav" not in rows(table.used)
    assert len(table.components) == count
    assert step() == before
    for row in range(picker(table.used).list.count()):
        item = picker(table.used).list.item(row)
        if item.text() == "robot.png":
            at = picker(table.used).list.visualItemRect(item).center()
            QTest.mouseClick(picker(table.used).list.viewport(), LEFT, pos=at)
            break
    table.settle()
    made = table.components[-1]
    assert (made.element, made.src) == ("image", "robot.png")
    assert (made.x + made.width / 2, made.y + made.height / 2) == (50, 50)
    # As wide as high on the robot's screen, as the picture is.
    assert made.width * 1280 == made.height * 800
    assert table.used.window.inspector.place == ("state", "11", "screen", made.id)
    assert [p for p in table.used.session.problems if p.code == "missing-media"] == []
    # It is one step, and arrows move what was dropped.
    table.used.key(Qt.Key.Key_Left)
    assert table.components[-1].x < made.x
    for _ in range(2):
        table.used.window.actions_.actions["undo"].trigger()
        table.settle()
    assert (len(table.components), step()) == (count, before)


def test_escape_leaves_nothing(table: Table, step: Callable[[], str]) -> None:
    before, last = table.document, step()
    assert table.drop("movie", table.at(40, 40))
    assert rows(table.used) == ["Import a file…", "From data…", "clip.webm"]
    table.used.key(Qt.Key.Key_Escape)
    assert picker(table.used) is None
    assert table.document is before
    assert step() == last
    # The same where an import is given up, and by a click beside it.
    table.drop("movie", table.at(40, 40))
    table.used.answers.put("media_file", None)
    table.used.key(Qt.Key.Key_Up)
    table.used.key(Qt.Key.Key_Up)
    table.used.key(Qt.Key.Key_Return)
    table.drop("movie", table.at(40, 40))
    picker(table.used).close()
    table.settle()
    assert table.document is before
    # Where none can be, nothing is asked.
    table.used.select()
    table.used.window.commands.insert("image")
    assert picker(table.used) is None
    assert table.used.window.status.said.text() == "Select a state first, then add the image."


def test_a_picture_from_elsewhere_is_brought_along(table: Table, tmp_path: Path) -> None:
    source = tmp_path / "My Nurse.PNG"
    source.write_bytes((example("reception") / "media" / "robot.png").read_bytes() + b" ")
    table.used.answers.put("media_file", str(source))
    table.drop("image", table.at(50, 50))
    first = picker(table.used).list.item(0)
    assert first.text() == "Import a file…"
    at = picker(table.used).list.visualItemRect(first).center()
    QTest.mouseClick(picker(table.used).list.viewport(), LEFT, pos=at)
    table.settle()
    assert table.components[-1].src == "my-nurse.png"
    assert (table.used.session.root / "media" / "my-nurse.png").is_file()


def test_by_keys_from_the_menu_it_is_typed_to_filter_and_filled_in(table: Table) -> None:
    table.used.window.actions_.actions["insert.image"].trigger()
    table.settle()
    table.used.type("LOB")
    assert rows(table.used) == ["Import a file…", "lobby.png"]
    table.used.key(Qt.Key.Key_Return)
    assert table.components[-1].src == "lobby.png"
    form = table.used.window.inspector.form
    assert QApplication.focusWidget() is form.field("src")
    # Sounds are asked for in the same way.
    table.used.select("state", "11")
    table.used.window.actions_.actions["insert.sound"].trigger()
    table.settle()
    assert rows(table.used) == ["Import a file…", "From data…", "chime.wav"]
    table.used.key(Qt.Key.Key_Return)
    assert table.document.state("11").actions[-1].src == "chime.wav"


def test_what_no_file_is_can_be_typed(table: Table) -> None:
    for typed in ("{patient.photo}", "https://x.test/a.png", "still-to-come.png"):
        table.drop("image", table.at(50, 50))
        table.used.type(typed)
        assert rows(table.used) == ["Import a file…", f"Use {typed}"]
        table.used.key(Qt.Key.Key_Return)
        assert table.components[-1].src == typed


def test_data_that_names_a_picture_is_offered_not_asked_for_as_a_file(table: Table) -> None:
    used = table.used
    table.drop("image", table.at(50, 50))
    # By the row that leads there, and typed to filter: data of this project, none of the robot's.
    for row in range(picker(used).list.count()):
        if picker(used).list.item(row).text() == "From data…":
            at = picker(used).list.visualItemRect(picker(used).list.item(row)).center()
    QTest.mouseClick(picker(used).list.viewport(), LEFT, pos=at)
    assert "{user.name}" in rows(used)
    assert not [one for one in rows(used) if "/" in one]
    used.type("user.")
    assert all("user." in one for one in rows(used)[1:])
    used.type("na")
    # Half a name is nothing that could be used.
    assert rows(used) == ["Import a file…", "{user.name}"]
    used.key(Qt.Key.Key_Return)
    made = table.components[-1]
    assert made.src == "{user.name}"
    # Asked again, the data stands there, whether there are pictures in the project or not.
    for name in (used.session.root / "media").iterdir():
        name.unlink()
    used.window.media_choice.change(("state", "11", "screen", made.id), "src")
    used.settle()
    assert picker(used).list.currentItem().text() == "{user.name}"
    assert "{patients}" in rows(used)
    used.key(Qt.Key.Key_Down)
    used.key(Qt.Key.Key_Return)
    after = table.components[-1].src
    assert after.startswith("{")
    assert after != "{user.name}"
    # A name that is data in part can be used as it is, or written over.
    used.window.media_choice.change(("state", "11", "screen", made.id), "src")
    used.settle()
    used.key(Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    used.type("people/{patient.id}.png")
    used.key(Qt.Key.Key_Return)
    used.window.media_choice.change(("state", "11", "screen", made.id), "src")
    used.settle()
    assert picker(used).list.currentItem().text() == "Use people/{patient.id}.png"
    used.key(Qt.Key.Key_Escape)


def test_enter_or_a_double_click_on_a_picture_asks_for_another(table: Table) -> None:
    used = table.used
    used.select("state", "2")
    sheet, of = table.sheet, ("state", "2", "screen", "robot")
    used.select(*of)
    sheet.setFocus()
    used.key(Qt.Key.Key_Return)
    assert picker(used).list.currentItem().text() == "robot.png"
    used.type("sorry")
    used.key(Qt.Key.Key_Return)
    state = table.document.state("2")
    (robot,) = [c for c in state.screen.components if c.id == "robot"]
    assert robot.src == "sorry.png"
    at = table.at(robot.x + robot.width / 2, robot.y + robot.height / 2)
    QTest.mouseClick(sheet, LEFT, pos=at)
    QTest.mouseDClick(sheet, LEFT, pos=at)
    used.settle()
    assert picker(used).list.currentItem().text() == "sorry.png"
    used.key(Qt.Key.Key_Escape)
    assert table.document.state("2") is state


def test_a_picture_that_is_dropped_onto_a_card_is_asked_for_too(table: Table) -> None:
    canvas = table.used.window.current_view.canvas
    area = canvas.card_area(next(iter(canvas.selected_uids())))
    canvas.drop_kind(IMAGE, area.topLeft() + QPointF(40, 12))
    table.settle()
    table.used.type("lobby")
    table.used.key(Qt.Key.Key_Return)
    assert table.components[-1].src == "lobby.png"


def test_what_the_form_adds_finds_free_room_as_what_is_pressed_does(table: Table) -> None:
    """Under *Components* of the screen's form, and in the palette: the same component."""
    used = table.used
    made = []
    for by_form in (True, False):
        if by_form:
            used.select("state", "11", "screen")
            button = used.window.inspector.form.section("components").add
            chosen = menu_entry(button, "Button")
            used.click(button)
            assert chosen == ["Button"]
        else:
            used.click(used.window.palette_.item("button"))
        made.append(table.components[-1])
        used.window.actions_.actions["undo"].trigger()
        used.settle()
    assert made[0] == made[1]
    assert used.session.redo_text == "Add button to state 11"


def menu_entry(button: Any, text: str) -> list[str]:
    """Chooses an entry of a button's menu by the arrow keys once it is open; what it chose."""
    chosen: list[str] = []

    def choose() -> None:
        menu = QApplication.activePopupWidget()
        assert isinstance(menu, QMenu)
        while menu.activeAction() is None or menu.activeAction().text() != text:
            QTest.keyClick(menu, Qt.Key.Key_Down)
        chosen.append(menu.activeAction().text())
        QTest.keyClick(menu, Qt.Key.Key_Return)

    button.menu().aboutToShow.connect(lambda: QTimer.singleShot(0, choose))
    return chosen
