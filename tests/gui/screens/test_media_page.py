"""The rows *media* and *scenarios* of the project, and the page of the media."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from situ.resources import example
from situ_studio.panels.project_tree import MEDIA
from situ_studio.screens.media_rows import DETAIL

Start = Callable[..., Any]
Copy = Callable[[str], Path]
NONE = Qt.KeyboardModifier.NoModifier
COPY = Qt.DropAction.CopyAction


def page(used: Any) -> Any:
    return used.window.pages.page(MEDIA)


def told(used: Any) -> dict[str, str]:
    rows = page(used).list
    return {rows.item(row).text(): rows.item(row).data(DETAIL) for row in range(rows.count())}


def test_a_row_of_the_project_opens_what_it_stands_for(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    tree, bottom = used.window.project_tree.tree, used.window.bottom
    used.click_row(tree, used.row_with(tree, "scenarios"))
    assert (bottom.current, bottom.is_folded) == ("scenarios", False)
    used.click_row(tree, used.row_with(tree, "media"), double=True)
    assert used.window.tabs.chosen_file == MEDIA
    assert page(used).isVisible()
    # By keys too.
    bottom.choose("problems")
    used.window.open_file("reception.rbd.xml")
    used.settle()
    for text in ("scenarios", "media"):
        tree.setFocus()
        tree.setCurrentIndex(used.row_with(tree, text))
        used.key(Qt.Key.Key_Return)
    assert used.window.tabs.chosen_file == MEDIA
    assert bottom.current == "scenarios"


def test_the_page_tells_where_media_are_used_and_leads_there(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.open_file(MEDIA)
    used.settle()
    found = told(used)
    assert found["lobby.png"].startswith("Used in reception: 1 start")
    rows = page(used).list
    assert rows.hasFocus()
    (row,) = rows.findItems("robot.png", Qt.MatchFlag.MatchExactly)
    rows.setCurrentItem(row)
    places = []
    count = len(row.data(DETAIL).split(","))
    for _ in range(count + 1):
        used.key(Qt.Key.Key_Return)
        places.append(used.window.inspector.place)
        used.window.open_file(MEDIA)
        used.settle()
    assert len(set(places)) == count > 1
    assert places[0] == places[-1]
    # Each row is painted with what it shows.
    one, other = (rows.grab(rows.visualItemRect(rows.item(at))).toImage() for at in (0, 1))
    assert one != other


def test_pictures_of_every_shape_begin_at_the_same_place(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.open_file(MEDIA)
    used.settle()
    rows = page(used).list
    picture, ground = rows.viewport().grab().toImage(), used.window.theme.color("panel").rgb()
    begins = set()
    # A sound, a movie, a wide picture, and a square one.
    for row in range(1, 5):
        y = rows.visualRect(rows.indexFromItem(rows.item(row))).center().y()
        begins.add(next(x for x in range(90) if picture.pixel(x, y) != ground))
    assert len(begins) == 1


def test_what_is_brought_is_there_at_once_and_is_dragged_onto_a_screen(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    used = studio(project("reception"))
    used.window.open_file(MEDIA)
    used.settle()
    tree = used.window.project_tree.tree
    picture = (example("reception") / "media" / "robot.png").read_bytes()
    for name in ("ward.png", "garden.png"):
        (tmp_path / name).write_bytes(picture + name.encode())
    used.answers.put("media_file", str(tmp_path / "ward.png"))
    used.click(page(used).add)
    assert told(used)["ward.png"] == "Not used"
    assert page(used).list.currentItem().text() == "ward.png"
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(tmp_path / "garden.png"))])
    at = QPoint(40, 40)
    left = Qt.MouseButton.LeftButton
    enter = QDragEnterEvent(at, COPY, data, left, NONE)
    QApplication.sendEvent(page(used), enter)
    assert enter.isAccepted()
    QApplication.sendEvent(page(used), QDropEvent(QPointF(at), COPY, data, left, NONE))
    used.settle()
    assert page(used).list.currentItem().text() == "garden.png"
    assert used.row_with(tree, "media").isValid()
    # What is no picture, movie or sound is refused in words.
    (tmp_path / "note.txt").write_text("x")
    used.answers.put("media_file", str(tmp_path / "note.txt"))
    used.click(page(used).add)
    assert "note.txt" in used.window.status.said.text()
    # The same data lands on a screen as one from elsewhere would, without a second copy.
    rows = page(used).list
    dragged = rows.mimeData([rows.currentItem()])
    files = len(told(used))
    used.window.open_file("reception.rbd.xml")
    used.window.show_mode("screen")
    used.select("state", "11")
    sheet = used.window.current_view.piece("designer").sheet
    enter = QDragEnterEvent(at, COPY, dragged, left, NONE)
    QApplication.sendEvent(sheet, enter)
    assert enter.isAccepted()
    QApplication.sendEvent(sheet, QDropEvent(QPointF(at), COPY, dragged, left, NONE))
    used.settle()
    made = used.session.document("reception.rbd.xml").state("11").screen.components[-1]
    assert (made.element, made.src) == ("image", "garden.png")
    used.window.open_file(MEDIA)
    used.settle()
    assert len(told(used)) == files
    assert told(used)["garden.png"] == "Used in reception: 11 main menu"


def test_a_project_without_media_says_so(studio: Start, tmp_path: Path) -> None:
    (tmp_path / "situ.toml").write_text('[project]\nname = "bare"\n', encoding="utf-8")
    used = studio(tmp_path)
    used.window.open_file(MEDIA)
    used.settle()
    assert page(used).nothing.isVisible()
    assert not page(used).list.isVisible()
