"""Files of applications in the project's tree: another name, deleted, another one like it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent, QInputMethodEvent
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication
from tests.gui.test_adding_to_a_project import open_menu, press
from tests.gui.test_language import choose as speak
from tests.gui.test_recovery import crash

from situ.document import folder
from situ.document.check import check, merge
from situ_studio.panels.lists import PLACE
from situ_studio.views.showing import show_beside

Start = Callable[..., Any]
Copy = Callable[[str], Path]

TOML = """[project]
name = "ward"
applications = ["a.rbd.xml", "night.rbd.xml"]
spds = "ward.spds.xml"
scenarios = "scenarios"
languages = ["en", "ja"]

[robot]
adapter = "sim"
"""
A = """<application name="a" start="1">
  <state no="1" name="Hello">
    <expectedevents>
      <event name="ready" next="2"><when><data tag="application/night.state" is="1"/></when></event>
    </expectedevents>
  </state>
  <state no="2" name="Round"><flow src="turn.rbd.xml"/>
    <expectedevents><event name="done" next="1"/></expectedevents>
  </state>
</application>
"""
NIGHT = """<application name="night" start="1">
  <state no="1" name="Night">
    <timeout next="2">5</timeout>
    <backgroundactions><speech>Good night</speech></backgroundactions>
  </state>
  <state no="2" name="Bye" final="true"/>
</application>
"""
TURN = '<application name="turn" start="1"><state no="1" name="Turn" final="true"/></application>\n'
SPDS = """<spds name="ward">
  <modules>
    <module name="a" resources="screen speech"/>
    <module name="night" resources="screen speech"/>
  </modules>
  <situation name="all">
    <module name="a" priority="1"/><module name="night" priority="2"/>
  </situation>
</spds>
"""
PO = """msgid ""
msgstr ""
"Content-Type: text/plain; charset=UTF-8\\n"

#: night.rbd.xml
msgid "Good night"
msgstr "おやすみなさい"
"""
SCENARIO = (
    '{"at": 1, "event": "ready", "application": "night"}\n'
    '{"at": 2, "expect": {"kind": "enter", "state": "night"}}\n'
    '{"at":3,"expect":{"kind":"authority","resource":"speech","to":"night"}}\n'
    '{"at": 4, "end": true}\n'
)


class Basket:
    """A waste basket that keeps what was thrown into it; a full one takes nothing."""

    def __init__(self) -> None:
        self.held: dict[str, bytes] = {}
        self.full = False

    def __call__(self, file: Path) -> bool:
        if self.full:
            return False
        self.held[file.name] = file.read_bytes()
        file.unlink()
        return True


@pytest.fixture
def ward(studio: Start, tmp_path: Path) -> Any:
    for name, text in {
        "situ.toml": TOML,
        "a.rbd.xml": A,
        "night.rbd.xml": NIGHT,
        "turn.rbd.xml": TURN,
        "ward.spds.xml": SPDS,
        "texts/ja.po": PO,
        "scenarios/first.jsonl": SCENARIO,
    }.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    used = studio(tmp_path)
    used.basket = used.session.throw_away = Basket()
    return used


def row(used: Any, file: str) -> Any:
    tree = used.window.project_tree.tree
    top = tree.model().index(0, 0)
    rows = [tree.model().index(at, 0, top) for at in range(tree.model().rowCount(top))]
    return next(index for index in rows if index.data(PLACE) == file)


def choose(used: Any, file: str) -> None:
    """Clicks a row, which then has the focus."""
    used.click_row(used.window.project_tree.tree, row(used, file))
    used.window.project_tree.tree.setFocus()
    used.settle()


def dialog(used: Any) -> Any:
    found = used.window.document_files.dialog
    assert found is not None, used.window.status.said.text()
    return found


def key(used: Any, key: Qt.Key) -> None:
    """A key to what has the focus in the question, which a person's desktop has in front."""
    asked = dialog(used)
    QTest.keyClick(asked.focusWidget() or asked, key)
    QApplication.processEvents()


def write(used: Any, text: str) -> None:
    """Writes over the name, by an input method, as one does in Japanese."""
    asked = dialog(used)
    asked.name.selectAll()
    key(used, Qt.Key.Key_Delete)
    written = QInputMethodEvent()
    written.setCommitString(text)
    QApplication.sendEvent(asked.focusWidget(), written)
    QApplication.processEvents()


def listed(rows: Any) -> list[str]:
    return [rows.item(at).text() for at in range(rows.count())]


def do(used: Any, command: str) -> None:
    used.window.actions_.actions[command].trigger()
    used.settle()


def on_disk(root: Path) -> dict[str, bytes]:
    """The project's files. What the studio keeps in its own, which lie here too, may be written at
    any moment.
    """
    every = {p.relative_to(root).as_posix(): p for p in root.rglob("*") if p.is_file()}
    own = ("recovery/", "settings.ini")
    return {file: path.read_bytes() for file, path in every.items() if not file.startswith(own)}


def errors(root: Path) -> list[str]:
    project, read = folder.load(root)
    assert project is not None
    return [str(p) for p in merge(read, check(project)) if p.severity == "error"]


def test_another_name_is_followed_everywhere_as_one_step_and_reaches_the_disk_when_it_is_saved(
    ward: Any, tmp_path: Path
) -> None:
    before = on_disk(tmp_path)
    choose(ward, "night.rbd.xml")
    assert ward.window.tabs.chosen_file == "night.rbd.xml"
    ward.select("state", "1")
    tabs = ward.window.tabs.files()
    ward.window.project_tree.tree.setFocus()
    ward.key(Qt.Key.Key_F2)
    asked = dialog(ward)
    assert not asked.rename.isEnabled()
    write(ward, "夜")
    assert listed(asked.list) == [
        "night.rbd.xml: becomes 夜.rbd.xml",
        "night.rbd.xml: the application is called 夜 in it",
        "a.rbd.xml: 1 place that names it as a module",
        "ward.spds.xml: 2 places that name it as a module",
        "scenarios/first.jsonl: 2 lines of the scenario",
        "situ.toml: the list of applications",
        "texts/ja.po: where its texts stand",
    ]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.undo_text == "Rename application night"
    assert on_disk(tmp_path) == before
    # The tab goes along, with what was selected in it.
    assert ward.window.tabs.files() == [f.replace("night", "夜") for f in tabs]
    assert ward.window.tabs.chosen_file == "夜.rbd.xml"
    assert ward.window.current_view.selected == (("state", "1"),)
    do(ward, "save")
    assert ward.basket.held == {"night.rbd.xml": before["night.rbd.xml"]}
    after = on_disk(tmp_path)
    assert after.keys() == before.keys() - {"night.rbd.xml"} | {"夜.rbd.xml"}
    assert errors(tmp_path) == []
    assert not any(
        b"night.rbd" in data or b'"night"' in data
        for f, data in after.items()
        if f != "scenarios/first.jsonl"
    )
    lines = [json.loads(one) for one in after["scenarios/first.jsonl"].splitlines()]
    assert lines[0]["application"] == "夜"
    # A state of that name is none of its business.
    assert lines[1]["expect"]["state"] == "night"
    assert lines[2]["expect"]["to"] == "夜"
    assert after["scenarios/first.jsonl"].decode() == SCENARIO.replace(
        '"application": "night"', '"application": "夜"'
    ).replace('"to":"night"', '"to":"夜"')
    assert ward.session.dirty == []
    do(ward, "undo")
    assert ward.window.tabs.files() == tabs
    assert ward.window.tabs.chosen_file == "night.rbd.xml"
    do(ward, "save")
    assert "夜.rbd.xml" in ward.basket.held
    again = on_disk(tmp_path)
    assert again.keys() == before.keys()
    assert again["scenarios/first.jsonl"] == before["scenarios/first.jsonl"]
    assert b"night" in again["night.rbd.xml"]
    assert errors(tmp_path) == []


def test_a_name_that_is_taken_or_none_is_told_before_anything_happens(
    ward: Any, tmp_path: Path
) -> None:
    (tmp_path / "there.rbd.xml").write_text("whatever")
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    asked = dialog(ward)
    for name, why in (
        ("night", "Write another name."),
        ("a", "There is a file a.rbd.xml already: choose another name."),
        ("A", "There is a file A.rbd.xml already: choose another name."),
        ("there", "There is a file there.rbd.xml already: choose another name."),
        ("x/y", 'A name has no / \\ : * ? " < > | { } in it and begins with no dot.'),
        ("", "Write a name."),
    ):
        write(ward, name)
        assert asked.why.text() == why
        assert not asked.rename.isEnabled()
        assert listed(asked.list) == []
        key(ward, Qt.Key.Key_Return)
        assert dialog(ward) is asked
    # A file of that name may be there and the module not, and the other way round.
    write(ward, "b")
    QTest.mouseClick(asked.too, Qt.MouseButton.LeftButton, pos=QPoint(8, asked.too.height() // 2))
    assert listed(asked.list) == [
        "night.rbd.xml: becomes b.rbd.xml",
        "situ.toml: the list of applications",
        "texts/ja.po: where its texts stand",
    ]
    key(ward, Qt.Key.Key_Escape)
    ward.settle()
    assert not ward.session.undo_text
    assert ward.window.document_files.dialog is None


def test_a_part_takes_the_states_that_run_it_along(ward: Any, tmp_path: Path) -> None:
    ward.window.open_file("a.rbd.xml")
    ward.select("state", "2")
    ward.window.parts.enter()
    assert ward.window.parts.way == ("a.rbd.xml", "turn.rbd.xml")
    # The command is about the document that is shown.
    do(ward, "rename_file")
    write(ward, "tour")
    assert listed(dialog(ward).list) == [
        "turn.rbd.xml: becomes tour.rbd.xml",
        "turn.rbd.xml: the application is called tour in it",
        "a.rbd.xml: 1 state that runs it",
    ]
    QTest.mouseClick(dialog(ward).rename, Qt.MouseButton.LeftButton)
    ward.settle()
    assert ward.session.document("a.rbd.xml").states[1].flow == "tour.rbd.xml"
    assert ward.window.parts.way == ("a.rbd.xml", "tour.rbd.xml")
    assert ward.window.current_file == "tour.rbd.xml"
    do(ward, "save")
    assert errors(tmp_path) == []
    assert not (tmp_path / "turn.rbd.xml").exists()


def test_what_still_refers_to_a_file_is_told_before_it_is_deleted_and_undo_brings_it_back(
    ward: Any, tmp_path: Path
) -> None:
    before = on_disk(tmp_path)
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    asked = dialog(ward)
    assert listed(asked.list) == [
        "a.rbd.xml: 1 place that names it as a module",
        "ward.spds.xml: 2 places that name it as a module",
        "scenarios/first.jsonl: 2 lines of the scenario",
    ]
    key(ward, Qt.Key.Key_Escape)
    ward.settle()
    assert not ward.session.undo_text
    ward.window.project_tree.tree.setFocus()
    ward.key(Qt.Key.Key_Delete)
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.undo_text == "Delete application night"
    assert "night.rbd.xml" not in ward.session.files
    assert "night.rbd.xml" not in ward.window.tabs.files()
    assert on_disk(tmp_path) == before
    do(ward, "undo")
    assert ward.session.dirty == []
    do(ward, "redo")
    do(ward, "save")
    assert ward.basket.held == {"night.rbd.xml": before["night.rbd.xml"]}
    assert ward.session.dirty == []
    # Also after saving, and then it is written again.
    do(ward, "undo")
    assert list(ward.session.project.applications) == ["a.rbd.xml", "night.rbd.xml"]
    do(ward, "save")
    assert errors(tmp_path) == []
    assert on_disk(tmp_path).keys() == before.keys()
    # The last one stays.
    for file in ("night.rbd.xml", "a.rbd.xml"):
        choose(ward, file)
        ward.key(Qt.Key.Key_Delete)
        if file == "night.rbd.xml":
            key(ward, Qt.Key.Key_Return)
            ward.settle()
    said = ward.window.status.said.text()
    assert said == "It is the only application: a project has at least one."
    choose(ward, "turn.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    assert listed(dialog(ward).list) == ["a.rbd.xml: 1 state runs it, and will have nothing to run"]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.dirty[-1] == "turn.rbd.xml"
    do(ward, "undo")
    assert "turn.rbd.xml" not in ward.session.dirty


def test_what_is_not_saved_goes_along_and_what_can_not_be_written_loses_nothing(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "night.rbd.xml")
    ward.select("state", "2")
    ward.window.open_file("night.rbd.xml")
    ward.select("state", "1")
    do(ward, "delete")
    unsaved = ward.session.document("night.rbd.xml")
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.document("late.rbd.xml").states == unsaved.states
    # Something stands in the way: the old file stays until the new one is there.
    (tmp_path / "late.rbd.xml").mkdir()
    do(ward, "save")
    assert (tmp_path / "night.rbd.xml").read_text() == NIGHT
    assert "late.rbd.xml" in ward.session.dirty
    (tmp_path / "late.rbd.xml").rmdir()
    # Another program wrote the old file meanwhile: nothing is asked, and it is not thrown away.
    (tmp_path / "night.rbd.xml").write_text(NIGHT.replace("Bye", "Good bye"))
    ward.session.disk.look()
    ward.settle()
    assert ward.window.notice.about != "night.rbd.xml"
    do(ward, "save")
    assert (tmp_path / "late.rbd.xml").is_file()
    assert "Good bye" in (tmp_path / "night.rbd.xml").read_text()
    told = "night.rbd.xml could not go into the waste basket: it stays in the folder."
    assert ward.window.status.said.text() == told
    assert ward.session.dirty == []
    # Nor is one for which there is no basket.
    ward.basket.full = True
    choose(ward, "late.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    do(ward, "save")
    assert (tmp_path / "late.rbd.xml").is_file()
    assert ward.session.dirty == []


def test_a_file_with_errors_or_changed_on_disk_keeps_its_name(ward: Any, tmp_path: Path) -> None:
    choose(ward, "night.rbd.xml")
    ward.select("state", "2")
    do(ward, "delete")
    (tmp_path / "night.rbd.xml").write_text(NIGHT.replace("Bye", "Good bye"))
    ward.window.project_tree.tree.setFocus()
    ward.key(Qt.Key.Key_F2)
    assert ward.window.document_files.dialog is None
    said = ward.window.status.said.text()
    assert said == "Another program changed night.rbd.xml: decide first which one stays."
    (tmp_path / "turn.rbd.xml").write_text(
        '<application name="turn"><state no="1" x="y"/></application>'
    )
    ward.session.open(tmp_path)
    for key in (Qt.Key.Key_F2, Qt.Key.Key_Delete):
        choose(ward, "turn.rbd.xml")
        ward.key(key)
        assert ward.window.document_files.dialog is None
        said = ward.window.status.said.text()
        assert said.startswith("turn.rbd.xml has errors: mend them first")


def test_the_menu_of_a_row_is_about_that_row_by_mouse_and_by_key(ward: Any) -> None:
    choose(ward, "a.rbd.xml")
    tree = ward.window.project_tree.tree
    at = tree.visualRect(row(ward, "night.rbd.xml")).center()
    mouse, keys = QContextMenuEvent.Reason.Mouse, QContextMenuEvent.Reason.Keyboard
    glob = tree.viewport().mapToGlobal(at)
    QApplication.sendEvent(tree.viewport(), QContextMenuEvent(mouse, at, glob))
    press(ward, "Duplicate application")
    assert ward.session.undo_text == "Duplicate application night"
    (copy,) = [f for f in ward.session.files if "night-2" in f]
    assert ward.session.document(copy).name == "night-2"
    assert ward.session.document(copy).states == ward.session.document("night.rbd.xml").states
    assert ward.window.current_file == copy
    ward.session.check_now()
    assert [p.code for p in ward.session.problems if p.severity == "error"] == []
    do(ward, "undo")
    assert copy not in ward.session.files
    choose(ward, "a.rbd.xml")
    QApplication.sendEvent(tree, QContextMenuEvent(keys, QPoint(1, 1), tree.mapToGlobal(QPoint())))
    press(ward, "Rename file…")
    assert dialog(ward).name.text() == "a"
    key(ward, Qt.Key.Key_Escape)
    ward.settle()
    # Once a menu is left, it is about the row that has the focus again.
    QApplication.sendEvent(tree.viewport(), QContextMenuEvent(mouse, at, glob))
    open_menu().close()
    ward.settle()
    tree.setFocus()
    ward.key(Qt.Key.Key_F2)
    assert dialog(ward).name.text() == "a"
    key(ward, Qt.Key.Key_Escape)
    ward.settle()
    # A row that is no document has none of it.
    at = tree.visualRect(row(ward, "texts")).center()
    glob = tree.viewport().mapToGlobal(at)
    QApplication.sendEvent(tree.viewport(), QContextMenuEvent(mouse, at, glob))
    menu = open_menu()
    assert "Delete file…" not in [one.text() for one in menu.actions()]
    menu.close()
    ward.settle()


def test_after_a_crash_another_name_is_offered_again_in_all_files(
    ward: Any, studio: Start, tmp_path: Path
) -> None:
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    crash(ward)
    used = studio(tmp_path)
    used.session.throw_away = Basket()
    used.click(used.window.recovered.buttons[0])
    used.session.check_now()
    assert [p.message for p in used.session.problems if p.severity == "error"] == []
    do(used, "save")
    assert errors(tmp_path) == []
    found, _ = folder.load(tmp_path)
    assert found is not None
    assert list(found.applications) == ["a.rbd.xml", "late.rbd.xml"]
    assert '"application": "late"' in (tmp_path / "scenarios" / "first.jsonl").read_text()
    assert used.session.throw_away.held == {"night.rbd.xml": NIGHT.encode()}
    assert not (tmp_path / "night.rbd.xml").exists()


def test_what_another_program_writes_while_a_name_is_asked_for_is_not_written_over(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    (tmp_path / "ward.spds.xml").write_text(SPDS.replace('priority="1"', 'priority="7"'))
    ward.session.disk.look()
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    do(ward, "save")
    assert '<module name="a" priority="7"/>' in (tmp_path / "ward.spds.xml").read_text()
    assert errors(tmp_path) == []


def test_a_scenario_is_one_of_the_values_here_only_once_a_name_in_it_was_changed(
    ward: Any, tmp_path: Path
) -> None:
    scenario = tmp_path / "scenarios" / "first.jsonl"
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    key(ward, Qt.Key.Key_Escape)
    ward.settle()
    scenario.write_text(SCENARIO.replace('"at": 4', '"at": 5'))
    ward.session.disk.look()
    assert ward.session.undo_text is None
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    do(ward, "save")
    written = scenario.read_text()
    assert '"at": 5' in written
    assert '"application": "late"' in written
    # From then on it is read anew like a document.
    scenario.write_text(written.replace('"at": 5', '"at": 6'))
    ward.session.disk.look()
    said = ward.window.status.said.text()
    assert said == "scenarios/first.jsonl was changed by another program: read anew."
    assert ward.session.undo_text == "Take scenarios/first.jsonl from disk"


def test_scenarios_are_played_with_the_new_name_before_it_is_saved(
    ward: Any, tmp_path: Path
) -> None:
    scenario = tmp_path / "scenarios" / "first.jsonl"
    scenario.write_text('{"at": 1, "event": "ready", "application": "night"}\n')
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    do(ward, "scenarios.run")
    run = ward.window.scenarios.run_
    if len(run.ran) < len(run.files):
        assert QSignalSpy(run.ended).wait(20000)
    assert [(one.played.unreadable, one.played.well) for one in run.ran] == [(None, True)]
    assert '"night"' in scenario.read_text()


def test_a_new_name_that_begins_with_the_old_one_is_put_once(ward: Any, tmp_path: Path) -> None:
    scenario = tmp_path / "scenarios" / "first.jsonl"
    scenario.write_text('{"at": 1, "expect": {"tag": "application/night.state"}}\n')
    # No tag of a document may be called so.
    (tmp_path / "a.rbd.xml").write_text(A.replace("application/night.state", "rounds"))
    ward.session.open(tmp_path)
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "night.late")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    do(ward, "save")
    assert '"application/night.late.state"' in scenario.read_text()


def test_a_file_is_deleted_though_another_program_took_a_file_away_that_is_open(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "turn.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    (tmp_path / "ward.spds.xml").unlink()
    do(ward, "save")
    assert [*ward.basket.held] == ["turn.rbd.xml"]
    assert ward.session.dirty == []


def test_what_was_deleted_stays_away_when_another_program_writes_beside_it(
    ward: Any, tmp_path: Path
) -> None:
    for file in ("night.rbd.xml", "turn.rbd.xml"):
        choose(ward, file)
        ward.key(Qt.Key.Key_Delete)
        key(ward, Qt.Key.Key_Return)
        ward.settle()
    dirty = ward.session.dirty
    (tmp_path / "texts" / "ja.po").write_text(PO.replace("おやすみなさい", "おやすみ"))
    ward.session.disk.look()
    assert ward.session.files == ["a.rbd.xml", "ward.spds.xml"]
    assert ward.session.dirty == dirty
    assert ward.session.project.texts["ja"] == {"Good night": "おやすみ"}
    do(ward, "save")
    assert sorted(ward.basket.held) == ["night.rbd.xml", "turn.rbd.xml"]
    assert ward.session.dirty == []


def test_what_was_taken_off_the_list_stays_off_when_another_program_writes_beside_it(
    ward: Any, tmp_path: Path
) -> None:
    ward.window.pages.applications.remove("night.rbd.xml")
    (tmp_path / "texts" / "ja.po").write_text(PO + "\n#\n")
    ward.session.disk.look()
    assert "night.rbd.xml" not in ward.session.files
    do(ward, "undo")
    assert "night.rbd.xml" in ward.session.files
    assert ward.session.dirty == []


def test_a_copy_of_the_project_has_nothing_of_what_was_deleted(ward: Any, tmp_path: Path) -> None:
    choose(ward, "turn.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    ward.session.save_copy(tmp_path.with_name(f"{tmp_path.name}-copies"))
    assert not (ward.session.root / "turn.rbd.xml").exists()
    assert ward.session.dirty == []
    # Where it was copied from it stays, and undo has it again here.
    assert (tmp_path / "turn.rbd.xml").read_text() == TURN
    do(ward, "undo")
    assert ward.session.dirty == ["turn.rbd.xml"]
    do(ward, "save")
    assert errors(ward.session.root) == []


def test_what_was_deleted_and_is_added_again_stays_in_the_folder_when_it_is_taken_off_the_list(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    ward.window.pages.applications.add("night.rbd.xml")
    do(ward, "save")
    ward.window.pages.applications.remove("night.rbd.xml")
    do(ward, "save")
    assert ward.basket.held == {}
    assert (tmp_path / "night.rbd.xml").is_file()


def test_a_file_that_is_not_yet_in_the_waste_basket_is_not_written_over(
    ward: Any, tmp_path: Path
) -> None:
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    key(ward, Qt.Key.Key_Return)
    choose(ward, "turn.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "night")
    told = "There is a file night.rbd.xml already: choose another name."
    assert dialog(ward).why.text() == told
    # One that is renamed may have its own name again.
    write(ward, "tour")
    key(ward, Qt.Key.Key_Return)
    choose(ward, "tour.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "turn")
    assert dialog(ward).why.text() == ""
    key(ward, Qt.Key.Key_Return)
    do(ward, "save")
    # Once it is in the basket, its name is free.
    assert [*ward.basket.held] == ["night.rbd.xml"]
    choose(ward, "turn.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "night")
    assert dialog(ward).why.text() == ""
    key(ward, Qt.Key.Key_Escape)


def test_a_scenario_that_is_no_text_stays_as_it_is_and_what_is_unsaved_is_kept(
    ward: Any, studio: Start, tmp_path: Path
) -> None:
    scenario = tmp_path / "scenarios" / "first.jsonl"
    data = SCENARIO.encode() + b'{"at": 9, "say": "\xe4"}\n'
    scenario.write_bytes(data)
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    assert not [one for one in listed(dialog(ward).list) if "scenario" in one]
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    crash(ward)
    used = studio(tmp_path)
    used.session.throw_away = Basket()
    used.click(used.window.recovered.buttons[0])
    do(used, "save")
    assert "late.rbd.xml" in used.session.files
    assert scenario.read_bytes() == data


@pytest.mark.parametrize(
    ("linked", "why"),
    [
        (False, "scenarios/second.jsonl: cannot be read: Is a directory"),
        (True, "second.jsonl is not in this project."),
    ],
)
def test_beside_a_scenario_that_can_not_be_read_or_lies_elsewhere_no_file_goes(
    ward: Any, tmp_path: Path, tmp_path_factory: Any, linked: bool, why: str
) -> None:
    scenario = tmp_path / "scenarios" / "second.jsonl"
    if linked:
        elsewhere = tmp_path_factory.mktemp("elsewhere") / "second.jsonl"
        elsewhere.write_text(SCENARIO)
        scenario.symlink_to(elsewhere)
    else:
        scenario.mkdir()
    choose(ward, "night.rbd.xml")
    ward.key(Qt.Key.Key_Delete)
    assert ward.window.document_files.dialog is None
    assert ward.window.status.said.text() == why
    ward.key(Qt.Key.Key_F2)
    write(ward, "late")
    assert dialog(ward).why.text() == why
    assert not dialog(ward).rename.isEnabled()
    key(ward, Qt.Key.Key_Escape)
    assert ward.session.undo_text is None


def test_undo_of_a_deletion_shows_the_file_where_and_as_it_was(ward: Any) -> None:
    window = ward.window
    window.open_file("night.rbd.xml")
    window.show_mode("outline")
    ward.select("state", "2")
    tabs, chosen = window.tabs.files(), window.current_view.selected
    assert tabs[-1] != "night.rbd.xml"
    do(ward, "delete_file")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert "night.rbd.xml" not in window.tabs.files()
    do(ward, "undo")
    assert window.tabs.files() == tabs
    assert window.current_file == "night.rbd.xml"
    assert window.current_view.shown_as == "outline"
    assert window.current_view.selected == chosen == (("state", "2"),)
    # What is looked at instead stays as it is when the file goes again.
    do(ward, "redo")
    shown = window.current_file
    assert shown is not None
    assert window.tabs.files() == [file for file in tabs if file != "night.rbd.xml"]
    do(ward, "undo")
    assert window.tabs.files() == tabs
    assert window.current_file == "night.rbd.xml"


def test_undo_of_a_deletion_shows_a_part_within_its_application_and_the_other_side_again(
    ward: Any,
) -> None:
    window = ward.window
    window.open_file("a.rbd.xml")
    ward.select("state", "2")
    window.parts.enter()
    do(ward, "delete_file")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert window.parts.way == ("a.rbd.xml",)
    do(ward, "undo")
    assert window.parts.way == ("a.rbd.xml", "turn.rbd.xml")
    assert window.current_file == "turn.rbd.xml"
    # The only tab of the right side.
    window.open_file("night.rbd.xml")
    show_beside(window, "night.rbd.xml", moved=True)
    ward.settle()
    assert [group.tabs.files() for group in window.sides.groups][1:] == [["night.rbd.xml"]]
    do(ward, "delete_file")
    key(ward, Qt.Key.Key_Return)
    ward.settle()
    assert len(window.sides.groups) == 1
    do(ward, "undo")
    assert [group.tabs.files() for group in window.sides.groups][1:] == [["night.rbd.xml"]]
    assert window.current_file == "night.rbd.xml"


def test_tabs_go_along_with_undo_in_another_language_too(ward: Any) -> None:
    tabs = ward.window.tabs.files()
    ward.window.open_file("night.rbd.xml")
    for command in ("rename_file", "delete_file"):
        do(ward, command)
        if command == "rename_file":
            write(ward, "late")
        key(ward, Qt.Key.Key_Return)
        ward.settle()
        assert "night.rbd.xml" not in ward.window.tabs.files()
        ward = speak(ward, "日本語" if command == "rename_file" else "English")
        do(ward, "undo")
        assert ward.window.tabs.files() == tabs
        assert ward.window.current_file == "night.rbd.xml"
