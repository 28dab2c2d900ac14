"""The files beside the documents, ``situ.toml`` and the texts: edited, undone, saved, kept and
joined as documents are.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtTest import QSignalSpy
from PySide6.QtWidgets import QApplication

from situ.document import catalogue
from situ.document.beside import Toml
from situ.document.catalogue import Catalogue, Translation
from situ_studio.project.session import Session

Copy = Callable[[str], Path]
JA, DE, TOML = "texts/ja.po", "texts/de.po", "situ.toml"


@pytest.fixture
def folder(project: Copy) -> Path:
    return project("reception")


@pytest.fixture
def session(qt: QApplication, folder: Path) -> Session:
    made = Session()
    made.open(folder)
    return made


def said(session: Session, text: str, to: str, file: str = JA) -> None:
    """Translates one text, as one step."""
    value = session.value(file)
    assert isinstance(value, Catalogue)
    entry = value.entry(text) or Translation(text)
    after = catalogue.with_entries(value, {text: catalogue.translated(entry, to)})
    assert session.commit(file, after, f"Translate {text}")


def written(session: Session, old: str, new: str) -> None:
    """Changes the text of ``situ.toml``, as one step."""
    value = session.value(TOML)
    assert isinstance(value, Toml)
    assert old in value.text
    assert session.commit(TOML, Toml(value.text.replace(old, new)), "Change the project")


def used(session: Session, language: str, text: str) -> str | None:
    assert session.project is not None
    return session.project.texts.get(language, {}).get(text)


def test_a_translation_is_a_step_that_is_undone_and_saved(session: Session, folder: Path) -> None:
    before = (folder / JA).read_text()
    said(session, "Home", "玄関")
    assert used(session, "ja", "Home") == "玄関"
    assert session.dirty == [JA]
    session.undo()
    assert (used(session, "ja", "Home"), session.dirty) == ("最初へ", [])
    session.redo()
    session.save()
    assert session.dirty == []
    # One translation is one line of the file.
    after = (folder / JA).read_text()
    changed = [
        two for one, two in zip(before.splitlines(), after.splitlines(), strict=True) if one != two
    ]
    assert changed == ['msgstr "玄関"']


def test_a_step_through_documents_and_texts_is_one(session: Session) -> None:
    application = session.document("reception.rbd.xml")
    texts = session.value(JA)
    assert application is not None
    assert isinstance(texts, Catalogue)
    from situ_studio.edits import places

    other = places.change(application, ("state", "1"), name="other")
    changed = {"reception.rbd.xml": other, JA: Catalogue()}
    assert session.commit_all(changed, "Both")
    assert session.dirty == ["reception.rbd.xml", JA]
    session.undo()
    assert session.dirty == []


def test_what_the_project_consists_of_follows_its_settings(session: Session, folder: Path) -> None:
    written(session, 'name = "reception"', 'name = "front desk" # ours')
    assert session.project is not None
    assert session.project.name == "front desk"
    session.save()
    assert 'name = "front desk" # ours\n' in (folder / TOML).read_text()
    session.undo()
    assert session.project.name == "reception"


def test_texts_of_a_new_language_are_begun_and_found_again(session: Session, folder: Path) -> None:
    written(session, '["en", "ja"]', '["en", "ja", "de"]')
    assert session.value(DE) is None
    assert session.commit(DE, catalogue.empty("reception", "de"), "Begin")
    said(session, "Home", "Anfang", DE)
    session.save()
    assert (folder / DE).exists()
    written(session, ', "de"]', "]")
    assert used(session, "de", "Home") is None
    session.undo()
    assert used(session, "de", "Home") == "Anfang"
    other = Session()
    other.open(folder)
    assert used(other, "de", "Home") == "Anfang"


def test_texts_that_can_not_be_read_are_not_written_over(session: Session, folder: Path) -> None:
    (folder / JA).write_text("no texts at all")
    session.open(folder)
    assert session.is_incomplete(JA)
    assert not session.commit(JA, Catalogue(), "Begin")
    session.save()
    assert (folder / JA).read_text() == "no texts at all"


def test_texts_changed_by_another_program_are_read_anew(session: Session, folder: Path) -> None:
    said(session, "Home", "玄関")
    session.save()
    text = (folder / JA).read_text()
    (folder / JA).write_text(text.replace('"もう一度"', '"再び"'))
    session.disk.look()
    assert (used(session, "ja", "Repeat"), session.dirty) == ("再び", [])
    # What was there before comes back step by step.
    session.undo()
    assert (used(session, "ja", "Home"), used(session, "ja", "Repeat")) == ("玄関", "もう一度")
    session.undo()
    assert used(session, "ja", "Home") == "最初へ"


def test_texts_changed_here_and_there_are_told_and_joined(session: Session, folder: Path) -> None:
    said(session, "Home", "玄関")
    text = (folder / JA).read_text()
    (folder / JA).write_text(text.replace('"もう一度"', '"再び"'))
    spy = QSignalSpy(session.changed_on_disk)
    session.disk.look()
    assert spy.count() == 1
    assert session.reconciling.conflicts() == [JA]
    found = session.reconciling.differing(JA)
    assert [c.text for c in found.my_changes] == ["in ja, “Home”: “最初へ” → “玄関”"]
    assert {c.text for c in found.their_changes} >= {"in ja, “Repeat”: “もう一度” → “再び”"}
    session.reconciling.take_both(JA)
    assert (used(session, "ja", "Home"), used(session, "ja", "Repeat")) == ("玄関", "再び")
    session.save()
    assert session.reconciling.conflicts() == []


def test_settings_changed_here_and_there_are_told_in_words(session: Session, folder: Path) -> None:
    written(session, 'name = "reception"', 'name = "mine"')
    text = (folder / TOML).read_text()
    (folder / TOML).write_text(text.replace('name = "reception"', 'name = "theirs"'))
    session.disk.look()
    assert session.project is not None
    assert session.project.name == "mine"
    found = session.reconciling.differing(TOML)
    assert [c.text for c in found.their_changes] == ["project's name “reception” → “theirs”"]
    assert found.both is None
    session.reconciling.take_theirs(TOML)
    assert (session.project.name, session.dirty) == ("theirs", [])


def test_problems_of_the_settings_are_those_of_what_stands_there_now(session: Session) -> None:
    written(session, "[tags]", '[tags]\n"Bad tag" = 1')
    session.check_now()
    (problem,) = [p for p in session.problems if p.code == "bad-tag"]
    assert session.file_of(problem) == TOML
    session.undo()
    session.check_now()
    assert "bad-tag" not in {p.code for p in session.problems}


def test_a_copy_has_what_was_changed_beside_the_documents(session: Session, tmp_path: Path) -> None:
    said(session, "Home", "玄関")
    (tmp_path / "away").mkdir()
    session.save_copy(tmp_path / "away")
    assert session.dirty == []
    assert "玄関" in (tmp_path / "away" / "reception" / JA).read_text()


def test_translations_that_were_not_saved_are_brought_back(
    studio: Callable[..., Any], folder: Path, settings: QSettings
) -> None:
    first = studio(folder)
    said(first.session, "Home", "玄関")
    first.window.recovery.keep()
    first.window.recovery._lock.unlock()
    first.window.recovery._file = first.window.recovery._lock = None
    second = studio(folder)
    assert JA in second.window.recovered.words.text()
    second.click(second.window.recovered.buttons[0])
    assert used(second.session, "ja", "Home") == "玄関"
    assert second.session.dirty == [JA]
