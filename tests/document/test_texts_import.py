"""Texts of a project as rows, and translations that come back from a translator."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import polib
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import folder
from situ.document.catalogue import Catalogue, Translation
from situ.document.project import Setting
from situ.document.texts import READING
from situ.document.texts_import import take_in
from situ.document.texts_table import begun, rows
from situ.resources import example

WANTED = {text: Translation(text, where="state 1") for text in ("a", "b {n}", "c")}


def _of(*entries: Translation) -> Catalogue:
    return Catalogue(translations=entries)


def test_every_text_of_a_project_is_a_row_with_its_kind_and_place() -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    found = rows(project)
    assert {row.kind for row in found} == {"shown", "spoken", "heard"}
    home = next(row for row in found if row.text == "Home")
    assert (home.file, home.place) == ("reception.rbd.xml", ("always", "screen", "home"))
    assert {row.file for row in found} == {"reception.rbd.xml", "register.rbd.xml"}
    entry = begun("Repeat", found)
    assert entry.files == (("reception.rbd.xml", ""),)
    assert "always: button repeat" in entry.where


def test_labels_and_choices_of_settings_are_rows_behind_all_others() -> None:
    project, _ = folder.load(example("vitals"))
    assert project is not None
    voice = Setting("voice", "Voice", "choice", ("soft", "1"))
    found = rows(replace(project, settings=(Setting("volume"), voice)))
    told = [(row.file, row.place, row.text, row.where) for row in found if row.kind == "setting"]
    assert told == [
        ("situ.toml", ("setting", "1", "label"), "Voice", "setting voice"),
        ("situ.toml", ("setting", "1", "choices", "0"), "soft", "setting voice: choice"),
    ]
    assert [row.kind for row in found[-2:]] == ["setting"] * 2
    entry = begun("Voice", found)
    assert (entry.where, entry.files) == ("setting voice", (("situ.toml", ""),))


def test_what_came_is_told_apart() -> None:
    mine = _of(Translation("a", "A"), Translation("c", "C"))
    theirs = _of(
        Translation("a", "A"),
        Translation("b {n}", "B"),
        Translation("c", "K"),
        Translation("x", "X"),
    )
    found = take_in(mine, theirs, WANTED, list(WANTED))
    assert (found.same, found.new, found.changed) == (("a",), ("b {n}",), ("c",))
    assert (found.unknown, found.lacking) == (("x",), ("b {n}",))
    assert found.catalogue.used == {"a": "A", "b {n}": "B", "c": "K"}
    assert [e.text for e in found.catalogue.translations] == ["a", "b {n}", "c", "x"]
    assert [e.text for e in found.catalogue.translations if e.obsolete] == ["x"]


def test_what_is_unsure_does_not_drive_out_what_is_sure() -> None:
    mine = _of(Translation("a", "A"))
    fuzzy = ("fuzzy",)
    theirs = _of(Translation("a", "?", flags=fuzzy), Translation("c", "?", flags=fuzzy))
    found = take_in(mine, theirs, WANTED, list(WANTED))
    assert found.unsure == ("a", "c")
    assert found.catalogue.used == {"a": "A"}
    entry = found.catalogue.entry("c")
    assert entry is not None
    assert (entry.said, entry.is_unsure, entry.where) == ("?", True, "state 1")


def test_what_a_translator_confirms_is_used() -> None:
    mine = _of(Translation("a", "A", flags=("fuzzy",), was="o"))
    found = take_in(mine, _of(Translation("a", "A", note="fine")), WANTED, list(WANTED))
    assert found.new == ("a",)
    assert found.catalogue == _of(Translation("a", "A", note="fine"))


def test_what_is_the_same_changes_nothing() -> None:
    mine = _of(Translation("a", "A"))
    found = take_in(mine, _of(Translation("a", "A"), Translation("c")), WANTED, list(WANTED))
    assert found.catalogue is mine
    assert (found.same, found.empty) == (("a",), ("c",))


_ENTRY = st.builds(
    Translation,
    text=st.sampled_from("abcxyz"),
    said=st.sampled_from(("", "1", "2")),
    flags=st.sampled_from(((), ("fuzzy",))),
    obsolete=st.booleans(),
)
_CATALOGUE = st.lists(_ENTRY, max_size=5, unique_by=lambda one: one.text).map(
    lambda found: _of(*found)
)


@settings(max_examples=80)
@given(_CATALOGUE, _CATALOGUE)
def test_no_translation_is_lost_and_every_text_is_told_once(
    mine: Catalogue, theirs: Catalogue
) -> None:
    wanted = {text: Translation(text) for text in "abc"}
    found = take_in(mine, theirs, wanted, list(wanted))
    after = found.catalogue.by_text()
    for one in mine.translations:
        assert (
            not one.said
            or after[one.text].said == one.said
            or one.text
            in (
                *found.changed,
                *found.new,
                *found.unsure,
            )
        )
    lists = (found.new, found.changed, found.same, found.unsure, found.unknown, found.empty)
    told = [text for texts in lists for text in texts]
    assert len(told) == len(set(told))
    assert set(told) >= {e.text for e in theirs.translations if e.said}
    # Taken in once more, nothing is new.
    again = take_in(found.catalogue, theirs, wanted, list(wanted))
    assert again.catalogue == found.catalogue
    assert (again.new, again.changed) == ((), ())


def test_how_words_are_said_is_taken_in_told_and_nothing_of_ours_is_lost() -> None:
    def read_as(word: str, said: str) -> Translation:
        return Translation(word, said, context=READING)

    mine = _of(Translation("a", "A"), read_as("Dr.", "Doctor"), read_as("Mr.", "Mister"))
    theirs = _of(read_as("Dr.", "Dokter"), read_as("Mrs.", "Missis"), read_as("Mr.", "Mister"))
    found = take_in(mine, theirs, WANTED, list(WANTED))
    assert found.readings == ("Dr.", "Mrs.")
    assert found.catalogue.readings == {"Dr.": "Dokter", "Mr.": "Mister", "Mrs.": "Missis"}
    assert found.catalogue.used == {"a": "A"}
    again = take_in(found.catalogue, theirs, WANTED, list(WANTED))
    assert again.readings == ()
    assert again.catalogue is found.catalogue


def test_a_file_of_texts_and_readings_is_parsed_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "situ.toml").write_text('[project]\nlanguages = ["en", "ja"]\n')
    (tmp_path / "texts").mkdir()
    (tmp_path / "texts" / "ja.po").write_text(
        'msgid ""\nmsgstr "Language: ja\\n"\n\nmsgid "a"\nmsgstr "A"\n\n'
        'msgctxt "reading"\nmsgid "Dr."\nmsgstr "Doctor"\n'
    )
    parsed = []

    def parse(*given: Any, **named: Any) -> Any:
        parsed.append(given)
        return pofile(*given, **named)

    pofile = polib.pofile
    monkeypatch.setattr(polib, "pofile", parse)
    project, problems = folder.load(tmp_path)
    assert project is not None
    assert (project.texts["ja"], project.readings["ja"]) == ({"a": "A"}, {"Dr.": "Doctor"})
    assert problems == []
    assert len(parsed) == 1
