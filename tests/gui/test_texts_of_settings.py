"""What the robot's page of settings shows stands in the table of all texts, as other texts do."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.test_mending import row_of
from tests.gui.test_texts_table import CONTROL, JA, JAPANESE, SHIFT, at, go, page, said, table

from situ.document import catalogue, folder
from situ_studio.texts.model import CELL, STATE, WHAT, WRITTEN

Start = Callable[..., Any]
TOML = """\
[project]
name = "ward"
applications = ["ward.rbd.xml"]
languages = ["en", "ja"]

# Asked for by the night shift.
[[setting]]
tag = "broken"
label = "Broken"
type = "tet"

[[setting]]
tag = "voice"
label = "Voice" # of the robot
type = "choice"
choices = ["soft", "loud"]
"""
APPLICATION = """\
<application name="ward"><state no="1" final="true"><backgroundactions>
<speech>Hello</speech></backgroundactions></state></application>
"""
PO = 'msgid "Hello"\nmsgstr "こんにちは"\n\nmsgid "Voice"\nmsgstr "声"\n'


@pytest.fixture
def used(studio: Start, tmp_path: Path) -> Any:
    """A ward with two settings, one of them with an error, and its texts open."""
    files = {"situ.toml": TOML, "ward.rbd.xml": APPLICATION, JA: PO}
    for name, text in files.items():
        path = tmp_path / "ward" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    made = studio(tmp_path / "ward")
    made.key(Qt.Key.Key_7, CONTROL)
    return made


def toml(used: Any) -> str:
    return str(used.session.value("situ.toml").text)


def write_over(used: Any, text: str, wanted: str) -> None:
    """Types another text as written into the cell of one."""
    go(used, at(used, text, WRITTEN))
    used.key(Qt.Key.Key_F2)
    used.key(Qt.Key.Key_A, CONTROL)
    used.type(wanted)
    used.key(Qt.Key.Key_Return)


def test_labels_and_choices_are_translated_behind_all_other_texts(used: Any) -> None:
    model = table(used).model()
    texts = [model.index(row, WRITTEN).data() for row in range(model.rowCount())]
    assert texts == ["Hello", "Voice", "soft", "loud"]
    places = [[at(used, text, column).data() for column in (STATE, WHAT)] for text in texts[1:3]]
    assert places == [["Setting voice", "Label"], ["Setting voice", "Choice"]]
    used.click(page(used).kinds.button("setting"))
    assert {row.kind for row in table(used).texts.shown} == {"setting"}
    assert "2 missing" in page(used).counts.text()
    go(used, at(used, "soft"))
    used.type("Y")
    used.type("wa")
    used.key(Qt.Key.Key_Return)
    assert said(used, "soft") == "Ywa"
    assert used.session.dirty == [JA]


def test_a_label_is_changed_in_situ_toml_as_one_step_and_keeps_its_translation(used: Any) -> None:
    write_over(used, "Voice", "How it speaks")
    assert toml(used) == TOML.replace('"Voice"', '"How it speaks"')
    assert used.session.dirty == ["situ.toml", JA]
    assert used.session.undo_text == "Change the text “Voice”"
    cell = at(used, "How it speaks").data(CELL)
    assert (cell.text, cell.standing, cell.was) == ("声", "unsure", "Voice")
    for held, wanted in ((CONTROL, TOML), (CONTROL | SHIFT, toml(used))):
        used.key(Qt.Key.Key_Z, held)
        assert toml(used) == wanted
        assert used.window.tabs.chosen_file == "texts"
    # What was done to it elsewhere is shown where it was done.
    used.window.pages.go_to_field("situ.toml", ("project", "name"))
    used.type("s")
    used.key(Qt.Key.Key_Return)
    used.window.open_file("texts")
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.window.tabs.chosen_file == "situ.toml"


def test_a_choice_is_changed_among_its_others_and_stays_a_choice_of_its_own(used: Any) -> None:
    write_over(used, "soft", "low")
    assert toml(used) == TOML.replace('"soft"', '"low"')
    for wrong in ("loud", "low, high"):
        write_over(used, "low", wrong)
        assert "Choices differ from each other" in used.window.status.said.text()
    assert toml(used) == TOML.replace('"soft"', '"low"')
    # Several cells at once are one step.
    QApplication.clipboard().setText("Speech\nquiet\nnoisy\n")
    go(used, at(used, "Voice", WRITTEN))
    used.key(Qt.Key.Key_V, CONTROL)
    (setting,) = used.session.project.settings
    assert (setting.label, setting.choices) == ("Speech", ("quiet", "noisy"))
    used.key(Qt.Key.Key_Z, CONTROL)
    assert toml(used) == TOML.replace('"soft"', '"low"')


def test_a_press_on_its_place_goes_to_its_field_and_a_problem_to_its_cell(used: Any) -> None:
    view = table(used)
    for text, column in (("Voice", 0), ("loud", 3)):
        used.window.open_file("texts")
        index = at(used, text, STATE)
        view.scrollTo(index)
        middle = view.visualRect(index).center()
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=middle)
        used.settle()
        assert used.window.tabs.chosen_file == "situ.toml"
        form = used.window.pages.page("situ.toml")
        # The first one has an error: it is no setting of the project, and a row of the form.
        assert form.sections["settings"].rows.field(1, column).hasFocus()
    used.session.check_now()
    missing = [p for p in used.session.problems if p.code == "missing-text"]
    assert [p.place[2:] for p in missing] == [("choices", "0"), ("choices", "1")]
    used.click_row(used.window.problems.list, row_of(used, missing[1]))
    assert used.window.tabs.chosen_file == "texts"
    assert view.currentIndex() == at(used, "loud", JAPANESE)


def test_a_translator_gets_them_and_what_comes_back_is_taken(used: Any, tmp_path: Path) -> None:
    out = tmp_path / "out.po"
    used.answers.put("translations_to", str(out))
    used.click(page(used).give_out)
    value, _ = catalogue.read(out.read_bytes(), "out.po")
    assert value is not None
    assert [one.text for one in value.translations] == ["Hello", "Voice", "soft", "loud"]
    came = out.read_text().replace('msgid "loud"\nmsgstr ""', 'msgid "loud"\nmsgstr "大きい声"')
    out.write_text(came)
    used.answers.put("translations_from", str(out))
    used.click(page(used).take_in)
    ((words, _),) = used.answers.details_told
    assert words == "日本語 from out.po: 1 new, 2 the same as before, 1 not translated."
    used.key(Qt.Key.Key_S, CONTROL)
    project, _ = folder.load(tmp_path / "ward")
    assert project is not None
    assert project.texts["ja"] == {"Hello": "こんにちは", "Voice": "声", "loud": "大きい声"}
