"""Saving, and files that other programs change."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtTest import QSignalSpy

from situ.document.folder import load
from situ_studio.files.conflict import ConflictDialog

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
    assert spy.count() or spy.wait(20_000)
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
    assert spy.count() or spy.wait(20_000)
    used.settle()
    assert used.window.notice.isVisible()
    assert used.session.document(FILE).state("2").name == "mine"
    used.answers.put("conflict", "theirs")
    used.click(used.window.notice.buttons[0])
    assert not used.window.notice.isVisible()
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
    assert used.window.notice.isVisible()
    assert FILE in used.window.notice.words.text()
    assert used.session.dirty == [FILE]
    (folder / FILE).rmdir()
    (folder / FILE).write_bytes(kept)
    used.answers.put("conflict", "mine")
    used.click(used.window.notice.buttons[0])
    assert used.session.dirty == []
    assert not used.window.notice.isVisible()


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
    used.session.reconciling.keep_mine(FILE)
    used.key(Qt.Key.Key_S, CONTROL)
    assert (folder / FILE).read_bytes() == there


def test_mended_in_a_text_editor_it_can_be_changed(studio: Start, project: Copy) -> None:
    folder = project("reception")
    broken(folder)
    used = studio(folder)
    spy = QSignalSpy(used.session.changed)
    elsewhere(folder, ' nme="x"', "")
    assert spy.count() or spy.wait(20_000)
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
    assert spy.count() or spy.wait(20_000)
    used.settle()
    assert used.session.document(FILE) is before
    assert used.window.notice.isVisible()
    assert "nme" in used.window.notice.words.text()
    rename(used, "mine")
    used.answers.put("conflict", "cancel")
    used.key(Qt.Key.Key_S, CONTROL)
    assert b"nme" in (folder / FILE).read_bytes()


# -- both changed ----------------------------------------------------------------------------


def test_changes_at_different_places_are_shown_in_words_and_both_kept(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    elsewhere(folder, 'no="1" name="start"', 'no="1" name="begin"')
    used.answers.put("conflict", "both")
    used.key(Qt.Key.Key_S, CONTROL)
    (found,) = used.answers.conflicts
    assert ["intro → mine" in change.text for change in found.my_changes] == [True]
    assert ["start → begin" in change.text for change in found.their_changes] == [True]
    text = (folder / FILE).read_text(encoding="utf-8")
    assert 'name="mine"' in text
    assert 'name="begin"' in text
    assert used.session.dirty == []
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.document(FILE).state("1").name == "start"
    assert used.session.document(FILE).state("2").name == "mine"


def test_what_fits_together_no_more_is_not_joined(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    document = used.session.document(FILE)
    leading = next(s for s in document.states for e in s.events if e.next == "2")
    used.select("state", "2")
    used.key(Qt.Key.Key_Delete)
    assert used.session.document(FILE).state("2") is None
    assert leading.no != "9"
    elsewhere(folder, "</application>", '<state no="99"><timeout next="2">5</timeout></state>'
              "</application>")  # fmt: skip
    assert used.session.reconciling.differing(FILE).both is None


def test_a_file_that_is_gone_is_told_and_written_again_where_one_wants_that(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    spy = QSignalSpy(used.session.changed_on_disk)
    (folder / FILE).unlink()
    assert spy.count() or spy.wait(20_000)
    used.settle()
    assert "is gone" in used.window.notice.words.text()
    used.answers.put("conflict", "cancel")
    used.key(Qt.Key.Key_S, CONTROL)
    assert not (folder / FILE).exists()
    assert used.answers.conflicts[0].gone
    used.answers.put("conflict", "mine")
    used.key(Qt.Key.Key_S, CONTROL)
    assert 'name="mine"' in (folder / FILE).read_text(encoding="utf-8")


def test_the_question_shows_both_sides_and_gives_the_chosen_answer(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    elsewhere(folder, 'no="1" name="start"', 'no="1" name="begin"')
    for answer in ("both", "theirs", "mine", "cancel"):
        dialog = ConflictDialog(used.session.reconciling.differing(FILE), used.window)
        dialog.show()
        assert "intro → mine" in dialog.mine.item(0).text()
        assert "start → begin" in dialog.theirs.item(0).text()
        used.click(dialog.buttons[answer])
        assert dialog.answer == answer
        dialog.deleteLater()
    elsewhere(folder, 'name="intro"', 'name="theirs"')
    dialog = ConflictDialog(used.session.reconciling.differing(FILE), used.window)
    assert "both" not in dialog.buttons
    assert "partly the same things" in dialog.words.text()
    dialog.deleteLater()


# -- the folder ------------------------------------------------------------------------------


def test_a_read_only_file_is_told_and_a_copy_goes_elsewhere(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    folder = project("reception")
    (folder / FILE).chmod(0o444)
    used = studio(folder)
    rename(used, "mine")
    used.key(Qt.Key.Key_S, CONTROL)
    notice = used.window.notice
    assert "read-only" in notice.words.text()
    assert 'name="mine"' not in (folder / FILE).read_text(encoding="utf-8")
    used.answers.put("new_folder", str(tmp_path / "copies"))
    used.click(notice.buttons[1])
    assert used.session.root == tmp_path / "copies" / "reception"
    assert used.session.dirty == []
    rename(used, "again")
    used.key(Qt.Key.Key_S, CONTROL)
    assert 'name="again"' in (used.session.root / FILE).read_text(encoding="utf-8")
    assert (used.session.root / "media").is_dir() == (folder / "media").is_dir()


def test_a_folder_that_was_renamed_is_found_again_with_everything_undone_and_not_saved(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    spy = QSignalSpy(used.session.folder_gone)
    folder.rename(tmp_path / "moved")
    assert spy.count() or spy.wait(20_000)
    used.settle()
    notice = used.window.notice
    assert str(folder) in notice.words.text()
    used.answers.put("project", str(tmp_path / "moved"))
    used.click(notice.buttons[1])
    assert not notice.isVisible()
    used.key(Qt.Key.Key_S, CONTROL)
    assert 'name="mine"' in (tmp_path / "moved" / FILE).read_text(encoding="utf-8")
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.document(FILE).state("2").name == "intro"


def test_a_folder_that_is_gone_is_written_anew_as_a_copy(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    spy = QSignalSpy(used.session.folder_gone)
    shutil.rmtree(folder)
    assert spy.count() or spy.wait(20_000)
    used.settle()
    used.answers.put("new_folder", str(tmp_path / "saved"))
    used.click(used.window.notice.buttons[2])
    project_there, problems = load(tmp_path / "saved" / "reception")
    assert project_there is not None
    assert not [p for p in problems if p.severity == "error"]
    state = project_there.applications[FILE].state("2")
    assert state is not None
    assert state.name == "mine"


def test_a_document_that_another_program_adds_to_the_project_comes_and_goes_with_it(
    studio: Start, project: Copy
) -> None:
    folder = project("reception")
    used = studio(folder)
    rename(used, "mine")
    (folder / "more.rbd.xml").write_text('<application name="more"><state no="1"/></application>')
    toml = (folder / "situ.toml").read_text()
    assert f'"{FILE}"' in toml
    spy = QSignalSpy(used.session.listed)
    (folder / "situ.toml").write_text(toml.replace(f'"{FILE}"', f'"{FILE}", "more.rbd.xml"'))
    assert spy.count() or spy.wait(20_000)
    used.settle()
    assert "more.rbd.xml" in used.session.files
    assert used.session.dirty == [FILE]
    assert used.session.document(FILE).state("2").name == "mine"
    used.window.open_file("more.rbd.xml")
    used.select("state", "1")
    used.fill(used.window.inspector.form.field("name"), "new")
    used.key(Qt.Key.Key_S, CONTROL)
    spy = QSignalSpy(used.session.listed)
    (folder / "situ.toml").write_text(toml)
    assert spy.count() or spy.wait(20_000)
    used.settle()
    assert "more.rbd.xml" not in used.window.tabs.files()
    assert used.session.undo_text == "Rename state 2"
