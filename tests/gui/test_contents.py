"""The values that an open project consists of, exchanged without a window."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication

from situ.document import beside, folder
from situ.document.beside import Beside, Toml
from situ.document.folder import PROJECT_FILE
from situ.document.rbd import Application, State
from situ.errors import UsageError
from situ_studio.project.contents import Contents
from situ_studio.project.folder_watch import FolderWatch

FILE = "reception.rbd.xml"
SCENARIO = "scenarios/known-user.jsonl"
FR = """msgid ""
msgstr ""
"Content-Type: text/plain; charset=UTF-8\\n"

msgid "Home"
msgstr "Accueil"
"""
Opened = tuple[Contents, list[str]]


@pytest.fixture
def disk(qt: QApplication) -> Iterator[FolderWatch]:
    window = QObject()
    yield FolderWatch(window)
    # What looks at the folder goes with the window.
    del window


@pytest.fixture
def opened(disk: FolderWatch, project: Callable[[str], Path]) -> Opened:
    """The example reception, and which files beside its documents were taken from disk."""
    found, _ = folder.load(project("reception"))
    assert found is not None
    taken: list[str] = []

    def on_taken(file: str, before: Beside | None, after: Beside | None) -> None:
        if after is not before:
            taken.append(file)

    contents = Contents(found, disk, on_taken)
    disk.begin(contents.root, contents.files, beside.files(found))
    contents.read_beside()
    return contents, taken


def longer(contents: Contents) -> Application:
    document = contents.need(FILE)
    assert isinstance(document, Application)
    return replace(document, states=(*document.states, State(no="99")))


def test_what_was_read_is_dirty_until_the_very_same_value_is_back(opened: Opened) -> None:
    contents, _ = opened
    before = contents.need(FILE)
    assert contents.changed == []
    contents.exchange(FILE, longer(contents))
    assert contents.changed == [FILE]
    assert not contents.is_as_read(FILE)
    contents.exchange(FILE, before)
    assert contents.changed == []
    assert contents.is_as_read(FILE)


def test_a_document_that_was_taken_away_lies_in_the_folder_until_that_is_decided(
    opened: Opened,
) -> None:
    contents, _ = opened
    before = contents.need(FILE)
    contents.exchange(FILE, None)
    assert FILE not in contents.files
    assert contents.removed == [FILE]
    with pytest.raises(UsageError):
        contents.need(FILE)
    contents.exchange(FILE, before)
    assert contents.removed == []
    contents.exchange(FILE, None)
    contents.let_go(FILE)
    assert contents.removed == []


def test_what_is_equal_on_disk_stays_the_very_object_that_it_is_here(opened: Opened) -> None:
    contents, taken = opened
    assert PROJECT_FILE in taken
    before = contents.beside[PROJECT_FILE]
    taken.clear()
    contents.read_beside()
    assert taken == []
    assert contents.beside[PROJECT_FILE] is before
    path = contents.root / PROJECT_FILE
    path.write_text(path.read_text() + "# more\n")
    contents.read_beside(kept=[PROJECT_FILE])
    assert contents.beside[PROJECT_FILE] is before
    contents.read_beside()
    assert taken == [PROJECT_FILE]
    assert contents.changed == []


def test_a_list_that_lacks_what_is_not_saved_is_not_taken(opened: Opened) -> None:
    contents, _ = opened
    other = replace(contents.project, applications={})
    contents.exchange(FILE, longer(contents))
    before = contents.project
    assert contents.adopt(other) is None
    assert contents.project is before


def test_a_list_that_is_taken_keeps_the_values_that_are_here(opened: Opened) -> None:
    contents, _ = opened
    there = contents.need(FILE)
    assert isinstance(there, Application)
    read_anew = replace(contents.project, applications={FILE: replace(there)}, name="another")
    assert contents.adopt(read_anew) == set()
    assert contents.document(FILE) is there
    assert contents.project.name == "another"
    assert contents.adopt(replace(contents.project, applications={})) == {FILE}
    assert contents.changed == []


def test_the_texts_of_a_language_that_is_not_saved_yet_are_read_anew_too(opened: Opened) -> None:
    contents, _ = opened
    toml, texts = contents.beside[PROJECT_FILE], contents.root / "texts" / "fr.po"
    assert isinstance(toml, Toml)
    texts.write_text(FR)
    more = toml.text.replace('languages = ["en", "ja"]', 'languages = ["en", "ja", "fr"]')
    contents.exchange(PROJECT_FILE, Toml(more))
    assert contents.project.texts["fr"] == {"Home": "Accueil"}
    texts.write_text(FR.replace("Accueil", "Retour"))
    on_disk, _ = folder.load(contents.root)
    assert on_disk is not None
    assert contents.adopt(on_disk) == set()
    contents.read_beside(kept=contents.changed)
    assert contents.project.texts["fr"] == {"Home": "Retour"}
    assert contents.changed == [PROJECT_FILE]


def test_a_scenario_that_is_a_value_here_is_looked_at_on_disk_whatever_was_read_anew_beside_it(
    opened: Opened, disk: FolderWatch
) -> None:
    contents, _ = opened
    told: list[str] = []
    disk.changed.connect(told.append)
    contents.attend([SCENARIO])
    contents.read_beside()
    path = contents.root / SCENARIO
    path.write_text(path.read_text() + "\n")
    disk.look()
    assert told == [SCENARIO]


def test_the_project_has_the_name_that_its_settings_say(opened: Opened) -> None:
    contents, _ = opened
    toml = contents.beside[PROJECT_FILE]
    assert isinstance(toml, Toml)
    listing = contents.listing
    contents.exchange(PROJECT_FILE, Toml(toml.text.replace('name = "reception"', 'name = "door"')))
    assert contents.project.name == "door"
    assert contents.listing != listing
    assert contents.changed == [PROJECT_FILE]
