"""The applications of a project in its form: made new, taken from the folder, put in order, taken
away, and the state in which each starts.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu

from situ.document import folder
from situ.document.check import check, merge
from situ.document.rbd import Screen, Speech, Text

Start = Callable[..., Any]
APPLICATION = (
    '<application name="{0}" start="1"><state no="1" name="Hello"><timeout next="2">5</timeout>'
    "<backgroundactions><speech>Hello</speech></backgroundactions></state>"
    '<state no="2" name="Bye" final="true"/></application>'
)

SCREEN = Screen(components=(Text(id="t", x=10, y=10, width=80, height=20, text="Good night"),))


@pytest.fixture
def used(studio: Start, tmp_path: Path) -> Any:
    """A project of one application, with two more in its folder, of which one is broken."""
    (tmp_path / "situ.toml").write_text(
        '[project]\nname = "ward"\napplications = ["a.rbd.xml"]\n[robot]\nadapter = "sim"\n'
    )
    (tmp_path / "a.rbd.xml").write_text(APPLICATION.format("a"))
    (tmp_path / "flows").mkdir()
    (tmp_path / "flows" / "b.rbd.xml").write_text(APPLICATION.format("b"))
    (tmp_path / "broken.rbd.xml").write_text("<application")
    made = studio(tmp_path)
    made.window.open_file("situ.toml")
    made.settle()
    return made


def form(used: Any) -> Any:
    return used.window.pages.page("situ.toml")


def rows(used: Any) -> Any:
    return form(used).applications.rows


def shown(used: Any) -> list[list[str]]:
    """Name, file and start of each."""
    return [
        [
            rows(used).field(row, 0).text(),
            rows(used).field(row, 1).text(),
            rows(used).field(row, 2).currentText(),
        ]
        for row in range(len(rows(used)))
    ]


def plus(used: Any, words: str) -> None:
    """Adds by the mouse what a menu offers with these words."""
    button = form(used).applications.plus
    form(used).area.ensureWidgetVisible(button)
    used.settle()
    used.click(button)
    menu: QMenu = used.window.findChildren(QMenu)[-1]
    action = next(one for one in menu.actions() if one.text() == words)
    QTest.mouseClick(menu, Qt.MouseButton.LeftButton, pos=menu.actionGeometry(action).center())
    used.settle()


def undo(used: Any) -> None:
    used.window.actions_.actions["undo"].trigger()
    used.settle()


def test_a_file_of_the_folder_becomes_an_application_with_its_priority(
    used: Any, tmp_path: Path
) -> None:
    before = used.session.value("situ.toml")
    assert shown(used) == [["a", "a.rbd.xml", "1 Hello"]]
    plus(used, "flows/b.rbd.xml")
    assert [row[:2] for row in shown(used)] == [["a", "a.rbd.xml"], ["b", "flows/b.rbd.xml"]]
    assert used.session.undo_text == "Add application b"
    # Of several a script says which goes first: it comes with the second, and nothing is wrong.
    used.session.check_now()
    assert [p.code for p in used.session.problems if p.severity == "error"] == []
    assert used.window.project_tree.tree.model() is not None
    undo(used)
    assert used.session.value("situ.toml") == before
    assert used.session.files == ["a.rbd.xml"]
    used.window.actions_.actions["redo"].trigger()
    used.window.actions_.actions["save"].trigger()
    used.settle()
    project, read = folder.load(tmp_path)
    assert project is not None
    assert list(project.applications) == ["a.rbd.xml", "flows/b.rbd.xml"]
    assert [p for p in merge(read, check(project)) if p.severity == "error"] == []
    # One that is there has priority, so a third gets one too.
    (tmp_path / "c.rbd.xml").write_text(APPLICATION.format("c"))
    plus(used, "c.rbd.xml")
    used.session.check_now()
    assert [p.code for p in used.session.problems if p.severity == "error"] == []
    plus(used, "broken.rbd.xml")
    assert len(used.session.project.applications) == 3
    assert used.window.status.said.text().startswith("broken.rbd.xml can not be read: ")
    assert "malformed-xml" not in used.window.status.said.text()
    # One that went while the menu was open.
    form(used).applications.plus.click()
    used.settle()
    (tmp_path / "broken.rbd.xml").unlink()
    menu = used.window.findChildren(QMenu)[-1]
    gone = next(one for one in menu.actions() if one.text() == "broken.rbd.xml")
    QTest.mouseClick(menu, Qt.MouseButton.LeftButton, pos=menu.actionGeometry(gone).center())
    used.settle()
    assert "broken.rbd.xml: cannot be read" in used.window.status.said.text()
    assert len(used.session.project.applications) == 3


def test_a_new_application_is_named_opened_and_gone_after_undo(used: Any, tmp_path: Path) -> None:
    used.answers.put("name", "Night round")
    plus(used, "New application…")
    assert used.window.current_file == "night-round.rbd.xml"
    assert used.window.current_document.name == "night-round"
    used.session.check_now()
    assert [p.code for p in used.session.problems if p.severity == "error"] == []
    # It may speak and show something without another step in the script.
    first = used.window.current_document
    (state,) = first.states
    says = replace(state, actions=(Speech(text="Good night"),), screen=SCREEN)
    used.window.commit(replace(first, states=(says,)), "Speak", used.window.current_file)
    used.session.check_now()
    assert [p.code for p in used.session.problems if p.severity == "error"] == []
    undo(used)
    used.window.open_file("situ.toml")
    used.settle()
    assert shown(used)[1] == ["night-round", "night-round.rbd.xml", "1 start"]
    used.window.actions_.actions["save"].trigger()
    project, read = folder.load(tmp_path)
    assert project is not None
    assert list(project.applications) == ["a.rbd.xml", "night-round.rbd.xml"]
    assert read == []
    undo(used)
    assert used.session.files == ["a.rbd.xml"]
    assert used.window.sides.current.tabs.files().count("night-round.rbd.xml") == 0
    used.answers.put("name", "a")
    plus(used, "New application…")
    assert used.window.status.said.text() == "a is there already."
    assert list(used.session.project.applications) == ["a.rbd.xml"]


def test_order_start_and_removal_are_one_step_each(used: Any) -> None:
    plus(used, "flows/b.rbd.xml")
    used.click(rows(used).buttons(1)[0])
    used.settle()
    assert list(used.session.project.applications) == ["flows/b.rbd.xml", "a.rbd.xml"]
    start = rows(used).field(0, 2)
    used.choose(start, "2 Bye")
    used.key(Qt.Key.Key_Return)
    assert used.session.document("flows/b.rbd.xml").start == "2"
    assert used.session.undo_text == "Start in 2 Bye"
    # What is taken away keeps what was changed in it: undo brings it back as it was.
    used.click(rows(used).buttons(0)[-1])
    used.settle()
    assert [row[1] for row in shown(used)] == ["a.rbd.xml"]
    assert used.session.undo_text == "Remove flows/b.rbd.xml"
    assert used.session.files[0] == "a.rbd.xml"
    assert "flows/b.rbd.xml" not in used.session.files
    undo(used)
    assert used.session.document("flows/b.rbd.xml").start == "2"
    undo(used)
    assert used.session.document("flows/b.rbd.xml").start == "1"


def test_a_file_that_is_not_there_is_told_in_its_row_and_taken_out(used: Any) -> None:
    text = used.session.value("situ.toml").text.replace('"a.rbd.xml"', '"a.rbd.xml", "no.rbd.xml"')
    used.session.commit("situ.toml", type(used.session.value("situ.toml"))(text), "By hand")
    used.session.check_now()
    used.settle()
    assert shown(used)[1][:2] == ["not there", "no.rbd.xml"]
    sign = form(used).signs.at(rows(used).field(1, 0))
    assert sign.toolTip() == "There is no file no.rbd.xml: add it, or take it out here"
    (problem,) = sign.problems
    used.window.mending.mend(problem)
    used.settle()
    assert [row[1] for row in shown(used)] == ["a.rbd.xml"]
