"""Files of the script and of module information in the project's tree: another name, deleted."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.test_adding_to_a_project import open_menu, press
from tests.gui.test_application_files import (
    Basket,
    choose,
    dialog,
    do,
    errors,
    key,
    listed,
    on_disk,
    row,
    write,
)

from situ.document import folder
from situ.document.project import Project

CONTROL = Qt.KeyboardModifier.ControlModifier

Start = Callable[..., Any]

TOML = """[project]
name = "ward"
applications = ["a.rbd.xml"]
# which one goes first
spds = "ward.spds.xml"
modules = "modules.xml"
scenarios = "scenarios"

[robot]
adapter = "sim"
"""
A = """<application name="a" start="1">
  <state no="1" name="Hello">
    <backgroundactions><service name="look" url="board:camera/look"/></backgroundactions>
    <expectedevents>
      <event next="2"><when><data tag="situation.name" is="all"/></when></event>
      <event name="ready" next="2"/>
    </expectedevents>
  </state>
  <state no="2" name="Bye" final="true"/>
</application>
"""
SPDS = """<?xml version="1.0" encoding="UTF-8"?>
<spds name="ward">
  <modules>
    <module name="a" resources="screen speech"/>
    <module name="arm" resources="base"/>
  </modules>
  <situation name="all">
    <module name="a" priority="1"/>
    <module name="arm" priority="2"/>
    <module name="camera" priority="3"/>
  </situation>
</spds>
"""
MODULES = """<?xml version="1.0" encoding="UTF-8"?>
<modules>
  <module name="camera" resources="head"/>
  <module name="arm" resources="base"/>
</modules>
"""
SCENARIO = (
    '{"at":0,"expect":{"kind":"situation","to":"all"}}\n'
    '{"at":1,"acquire":{"module":"camera","resources":["head"]}}\n'
    '{"at":2,"event":"ready","application":"a"}\n'
    '{"at":3,"end":true}\n'
)


@pytest.fixture
def ward(studio: Start, tmp_path: Path) -> Any:
    for name, text in {
        "situ.toml": TOML,
        "a.rbd.xml": A,
        "ward.spds.xml": SPDS,
        "modules.xml": MODULES,
        "scenarios/first.jsonl": SCENARIO,
    }.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    used = studio(tmp_path)
    used.basket = used.session.throw_away = Basket()
    return used


def read(root: Path) -> Project:
    project, _ = folder.load(root)
    assert project is not None
    return project


def test_a_script_gets_another_name_as_one_step_that_undo_takes_back_after_saving_too(
    ward: Any, tmp_path: Path
) -> None:
    before = on_disk(tmp_path)
    choose(ward, "ward.spds.xml")
    tabs = ward.window.tabs.files()
    ward.select("situation", "all")
    ward.window.project_tree.tree.setFocus()
    ward.key(Qt.Key.Key_F2)
    assert dialog(ward).windowTitle() == "Rename script"
    write(ward, "病棟")
    assert listed(dialog(ward).list) == [
        "ward.spds.xml: becomes 病棟.spds.xml",
        "ward.spds.xml: the script is called 病棟 in it",
        "situ.toml: which file is its script",
    ]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.undo_text == "Rename script ward"
    assert on_disk(tmp_path) == before
    # The tab goes along, with what was selected in it.
    assert ward.window.tabs.files() == [f.replace("ward.spds", "病棟.spds") for f in tabs]
    assert ward.window.current_file == "病棟.spds.xml"
    assert ward.window.current_view.selected == (("situation", "all"),)
    do(ward, "save")
    assert ward.basket.held == {"ward.spds.xml": SPDS.encode()}
    assert ward.session.dirty == []
    after = on_disk(tmp_path)
    assert after.keys() == before.keys() - {"ward.spds.xml"} | {"病棟.spds.xml"}
    assert after["situ.toml"].decode() == TOML.replace("ward.spds.xml", "病棟.spds.xml")
    assert after["病棟.spds.xml"].decode() == SPDS.replace('name="ward"', 'name="病棟"')
    assert errors(tmp_path) == []
    do(ward, "undo")
    assert ward.window.tabs.files() == tabs
    assert ward.window.current_file == "ward.spds.xml"
    do(ward, "save")
    assert {**on_disk(tmp_path), "settings.ini": b""} == {**before, "settings.ini": b""}
    # What is read anew has what was saved.
    ward.session.open(tmp_path)
    assert ward.session.dirty == []
    assert ward.session.project.spds.name == "ward"


def test_a_script_keeps_its_own_name_where_only_its_file_gets_another(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "ward.spds.xml")
    ward.key(Qt.Key.Key_F2)
    too = dialog(ward).too
    assert too.text() == "The script itself is called so too"
    write(ward, "first")
    QTest.mouseClick(too, Qt.MouseButton.LeftButton, pos=QPoint(8, too.height() // 2))
    QTest.mouseClick(dialog(ward).rename, Qt.MouseButton.LeftButton)
    ward.settle()
    do(ward, "save")
    assert read(tmp_path).spds_file == "first.spds.xml"
    assert (tmp_path / "first.spds.xml").read_text() == SPDS
    # Its own name alone: no file goes.
    choose(ward, "first.spds.xml")
    ward.key(Qt.Key.Key_F2)
    too = dialog(ward).too
    assert too.text() == "The script is called so too, not ward"
    QTest.mouseClick(too, Qt.MouseButton.LeftButton, pos=QPoint(8, too.height() // 2))
    assert listed(dialog(ward).list) == ["first.spds.xml: the script is called first in it"]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    do(ward, "save")
    script = read(tmp_path).spds
    assert script is not None
    assert script.name == "first"
    assert [*ward.basket.held] == ["ward.spds.xml"]


def test_module_information_gets_another_name_which_is_that_of_its_file_alone(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "modules.xml")
    ward.key(Qt.Key.Key_F2)
    asked = dialog(ward)
    assert asked.windowTitle() == "Rename module information"
    assert not asked.too.isVisible()
    for name, why in (
        ("night.rbd", "Files of applications and scripts end so: choose another name."),
        ("modules", "Write another name."),
        ("a.rbd", "Files of applications and scripts end so: choose another name."),
    ):
        write(ward, name)
        assert asked.why.text() == why
        assert not asked.rename.isEnabled()
    write(ward, "parts")
    assert listed(asked.list) == [
        "modules.xml: becomes parts.xml",
        "situ.toml: which file is its module information",
    ]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.undo_text == "Rename module information modules"
    do(ward, "save")
    assert read(tmp_path).modules_file == "parts.xml"
    assert (tmp_path / "parts.xml").read_text() == MODULES
    assert ward.basket.held == {"modules.xml": MODULES.encode()}
    do(ward, "undo")
    do(ward, "save")
    assert read(tmp_path).modules_file == "modules.xml"
    assert not (tmp_path / "parts.xml").exists()


def test_what_names_what_a_script_declares_is_told_before_it_is_deleted(
    ward: Any, tmp_path: Path
) -> None:
    before = on_disk(tmp_path)
    choose(ward, "ward.spds.xml")
    ward.key(Qt.Key.Key_Delete)
    assert dialog(ward).list.accessibleName() == "Still refers to what stands in it"
    # What the module information declares too, and the application, need no script.
    assert listed(dialog(ward).list) == [
        "a.rbd.xml: 1 place that asks for the situation",
        "scenarios/first.jsonl: 1 line of the scenario",
    ]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.undo_text == "Delete script ward"
    assert "ward.spds.xml" not in ward.window.tabs.files()
    assert ward.session.project.spds is None
    assert on_disk(tmp_path) == before
    do(ward, "undo")
    assert ward.session.dirty == []
    assert ward.window.current_file == "ward.spds.xml"
    do(ward, "redo")
    do(ward, "save")
    assert ward.basket.held == {"ward.spds.xml": SPDS.encode()}
    assert (tmp_path / "situ.toml").read_text() == TOML.replace('spds = "ward.spds.xml"\n', "")
    ward.session.open(tmp_path)
    assert ward.session.files == ["a.rbd.xml", "modules.xml"]
    assert ward.session.project.spds_file is None
    # There can be another one.
    ward.window.actions_.refresh()
    assert ward.window.actions_.actions["begin_script"].isVisible()


def test_of_module_information_it_is_told_who_names_what_it_alone_declares(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "modules.xml")
    ward.key(Qt.Key.Key_Delete)
    assert dialog(ward).windowTitle() == "Delete module information"
    assert listed(dialog(ward).list) == [
        "a.rbd.xml: 1 place that names a module declared in it",
        "ward.spds.xml: 1 place that names a module declared in it",
        "scenarios/first.jsonl: 1 line of the scenario",
    ]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert "modules.xml" not in ward.session.files
    do(ward, "undo")
    assert ward.session.dirty == []
    do(ward, "redo")
    do(ward, "save")
    assert ward.basket.held == {"modules.xml": MODULES.encode()}
    assert read(tmp_path).modules_file is None
    do(ward, "undo")
    do(ward, "save")
    assert (tmp_path / "modules.xml").read_text() == MODULES
    assert errors(tmp_path) == []


def test_a_project_with_several_applications_keeps_its_script(ward: Any) -> None:
    choose(ward, "a.rbd.xml")
    do(ward, "duplicate_application")
    choose(ward, "ward.spds.xml")
    ward.key(Qt.Key.Key_Delete)
    assert ward.window.document_files.dialog is None
    assert ward.window.status.said.text() == (
        "A project with several applications needs its script: it says which one goes first."
    )
    assert "ward.spds.xml" in ward.session.files


def test_a_row_of_a_script_offers_another_name_and_to_be_deleted_and_no_second_one(
    ward: Any,
) -> None:
    tree = ward.window.project_tree.tree
    choose(ward, "a.rbd.xml")
    at = tree.visualRect(row(ward, "ward.spds.xml")).center()
    mouse, glob = QContextMenuEvent.Reason.Mouse, tree.viewport().mapToGlobal(at)
    QApplication.sendEvent(tree.viewport(), QContextMenuEvent(mouse, at, glob))
    offered = [one.text() for one in open_menu().actions() if one.isVisible()]
    assert offered[:2] == ["Rename file…", "Delete file…"]
    assert "Duplicate application" not in offered
    press(ward, "Delete file…")
    assert dialog(ward).windowTitle() == "Delete script"
    key(ward, Qt.Key.Key_Escape)
    ward.settle()
    # Of the document that is shown, by its name among all commands.
    ward.window.open_file("ward.spds.xml")
    ward.window.current_view.current_view().setFocus()
    ward.key(Qt.Key.Key_K, CONTROL)
    ward.type("rename file")
    ward.key(Qt.Key.Key_Return)
    assert dialog(ward).name.text() == "ward"
    key(ward, Qt.Key.Key_Escape)
    ward.settle()
    ward.key(Qt.Key.Key_K, CONTROL)
    ward.type("duplicate application")
    ward.key(Qt.Key.Key_Return)
    assert ward.window.status.said.text() == (
        "Duplicate application: a project has one script, and one file with module information"
    )


def test_while_a_name_is_typed_scenarios_are_read_once_and_again_when_it_is_agreed(
    ward: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    reads: list[str] = []
    disk = ward.session.disk
    whole = disk.read

    def counted(file: str) -> bytes:
        reads.append(file)
        data: bytes = whole(file)
        return data

    monkeypatch.setattr(disk, "read", counted)
    choose(ward, "a.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    for name in ("b", "bc", "bcd"):
        write(ward, name)
        assert "scenarios/first.jsonl: 1 line of the scenario" in listed(dialog(ward).list)
    assert reads == ["scenarios/first.jsonl"]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert reads.count("scenarios/first.jsonl") > 1
    assert ward.session.undo_text == "Rename application a"
