"""Saving, and files that other programs change."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtTest import QSignalSpy

CONTROL = Qt.KeyboardModifier.ControlModifier
FILE = "reception.rbd.xml"

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def rename(used: Any, name: str) -> None:
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), name)


def elsewhere(folder: Path, old: str, new: str) -> str:
    """Another program changes the application; its text."""
    text = (folder / FILE).read_text(encoding="utf-8").replace(old, new)
    (folder / FILE).write_text(text, encoding="utf-8")
    return text


def test_a_file_changed_on_disk_is_read_anew_where_nothing_is_lost(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    used = studio(folder)
    spy = QSignalSpy(used.session.changed)
    elsewhere(folder, 'name="intro"', 'name="hello"')
    assert spy.count() or spy.wait(5000)
    used.settle()
    assert used.session.document(FILE).state("2").name == "hello"
    assert used.session.dirty == []
    assert "read anew" in used.window.status.said.text()
    used.window.actions_.actions["undo"].trigger()
    assert used.session.document(FILE).state("2").name == "intro"


def test_a_change_on_disk_is_told_where_there_are_changes_here(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    spy = QSignalSpy(used.session.changed_on_disk)
    elsewhere(folder, 'name="intro"', 'name="theirs"')
    assert spy.count() or spy.wait(5000)
    used.settle()
    assert used.window.notice.isVisible()
    assert used.session.document(FILE).state("2").name == "mine"
    used.click(used.window.notice.buttons[0])
    assert used.session.document(FILE).state("2").name == "theirs"
    assert used.session.dirty == []
    used.window.actions_.actions["undo"].trigger()
    assert used.session.document(FILE).state("2").name == "mine"


def test_saving_over_a_change_on_disk_asks_first(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    theirs = elsewhere(folder, 'name="intro"', 'name="theirs"')
    used.answers.put("conflict", "cancel")
    used.key(Qt.Key.Key_S, CONTROL)
    assert (folder / FILE).read_text(encoding="utf-8") == theirs
    used.answers.put("conflict", "mine")
    used.key(Qt.Key.Key_S, CONTROL)
    assert 'name="mine"' in (folder / FILE).read_text(encoding="utf-8")
    assert used.session.dirty == []


def test_what_can_not_be_written_is_told_and_stays_changed(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    kept = (folder / FILE).read_bytes()
    (folder / FILE).unlink()
    (folder / FILE).mkdir()
    used.answers.put("conflict", "mine")
    used.key(Qt.Key.Key_S, CONTROL)
    assert len(used.answers.told) == 1
    assert FILE in used.answers.told[0]
    assert used.session.dirty == [FILE]
    (folder / FILE).rmdir()
    (folder / FILE).write_bytes(kept)


def test_closing_asks_to_save(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    used.answers.put("unsaved", "cancel")
    used.window.close()
    assert used.window.isVisible()
    used.answers.put("unsaved", "save")
    used.window.close()
    assert not used.window.isVisible()
    assert 'name="mine"' in (folder / FILE).read_text(encoding="utf-8")


def test_what_is_being_typed_is_saved_too(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    used.select("state", "2")
    field = used.window.inspector.form.field("name")
    used.click(field)
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("typed")
    used.key(Qt.Key.Key_S, CONTROL)
    assert 'name="typed"' in (folder / FILE).read_text(encoding="utf-8")


def test_comments_and_notes_of_others_survive_an_edit(studio: Start, project: Copy) -> None:
    folder = project("reception")
    elsewhere(folder, '<state no="2"', '<!-- from the pilot study -->\n  <state no="2"')
    used = studio(folder)
    rename(used, "hello")
    used.key(Qt.Key.Key_S, CONTROL)
    assert "<!-- from the pilot study -->" in (folder / FILE).read_text(encoding="utf-8")


def broken(folder: Path) -> bytes:
    """A file with an error that costs a part of the document: an attribute nobody knows."""
    text = elsewhere(folder, '<state no="2" name="intro"', '<state no="2" name="intro" nme="x"')
    assert 'nme="x"' in text
    return text.encode()


def test_a_file_with_reading_errors_is_shown_and_never_saved_over(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    there = broken(folder)
    used = studio(folder)
    assert used.window.incomplete.isVisible()
    assert FILE in used.window.incomplete.words.text()
    assert used.session.problems
    rename(used, "changed")
    assert used.session.document(FILE).state("2").name == "intro"
    assert used.window.inspector.form.field("name").text() == "intro"
    assert "not changed" in used.window.status.said.text()
    used.click(used.window.palette_.item("state"))
    assert used.session.undo_text is None
    used.session.keep_mine(FILE)
    used.key(Qt.Key.Key_S, CONTROL)
    assert (folder / FILE).read_bytes() == there


def test_mended_in_a_text_editor_it_can_be_changed(studio: Start, project: Copy) -> None:
    folder = project("reception")
    broken(folder)
    used = studio(folder)
    spy = QSignalSpy(used.session.changed)
    elsewhere(folder, ' nme="x"', "")
    assert spy.count() or spy.wait(5000)
    used.settle()
    assert not used.window.incomplete.isVisible()
    assert used.session.problems == []
    rename(used, "changed")
    assert used.session.document(FILE).state("2").name == "changed"


def test_a_change_on_disk_with_errors_is_not_taken(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    before = used.session.document(FILE)
    spy = QSignalSpy(used.session.changed_on_disk)
    broken(folder)
    assert spy.count() or spy.wait(5000)
    used.settle()
    assert used.session.document(FILE) is before
    assert used.window.notice.isVisible()
    assert "nme" in used.window.notice.words.text()
    rename(used, "mine")
    used.answers.put("conflict", "cancel")
    used.key(Qt.Key.Key_S, CONTROL)
    assert b"nme" in (folder / FILE).read_bytes()
