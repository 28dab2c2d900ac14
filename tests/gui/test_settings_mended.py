"""What is wrong in ``situ.toml``: told at the field that shows it, and mended there at a click."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QPushButton

from situ.document import toml_writing as writing
from situ.document.beside import Toml

Start = Callable[..., Any]
TOML = """[project]
name = "ward"   # as on the door
applications = ["a.rbd.xml"]
langages = ["en"]

[[setting]]
tag = "volume"
type = "numbr"
[[setting]]
tag = "pace"
type = "tet"

[privacy]
private = ["User.**", "bp.**"]
"""
APPLICATION = """<application name="a">
  <state no="1" final="true">
    <backgroundactions><set tag="language">ja</set></backgroundactions>
  </state>
</application>
"""


@pytest.fixture
def used(studio: Start, tmp_path: Path) -> Any:
    (tmp_path / "situ.toml").write_text(TOML)
    (tmp_path / "a.rbd.xml").write_text(APPLICATION)
    made = studio(tmp_path)
    made.window.open_file("situ.toml")
    made.settle()
    made.session.check_now()
    made.settle()
    return made


def form(used: Any) -> Any:
    return used.window.pages.page("situ.toml")


def text(used: Any) -> str:
    return str(used.session.value("situ.toml").text)


def codes(used: Any) -> list[str]:
    used.session.check_now()
    used.settle()
    return [one.code for one in used.session.problems]


def entries(menu: QMenu) -> list[str]:
    return [one.text() for one in menu.actions() if not one.isSeparator()]


def choose(used: Any, menu: QMenu, words: str) -> None:
    QTest.mouseClick(
        menu,
        Qt.MouseButton.LeftButton,
        pos=menu.actionGeometry(next(a for a in menu.actions() if a.text() == words)).center(),
    )
    used.settle()


def test_a_field_with_a_problem_has_a_sign_that_tells_and_mends_it(used: Any) -> None:
    signs, settings = form(used).signs, form(used).sections["settings"].rows
    sign = signs.at(settings.field(1, 0))
    assert sign.toolTip().startswith('No setting is a "tet"; did you mean text?')
    assert sign.accessibleName() == f"Error: {sign.toolTip()}"
    field = settings.field(1, 0)
    middle = sign.mapToGlobal(sign.rect().center()).y()
    assert abs(middle - field.mapToGlobal(field.rect().center()).y()) <= 1
    assert (
        sign.mapToGlobal(sign.rect().topRight()).x()
        <= settings.mapToGlobal(settings.rect().topLeft()).x()
    )
    # An unknown key has no field: the section of its table has the sign.
    unknown = signs.at(form(used).sections["project"])
    assert unknown.accessibleName().startswith("Error: ")
    # By keys: the sign comes before its row; its menu has the mend chosen already.
    field.setFocus()
    form(used).area.ensureWidgetVisible(field)
    used.settle()
    used.key(Qt.Key.Key_Backtab)
    assert QApplication.focusWidget() is sign
    used.key(Qt.Key.Key_Space)
    menu = used.window.mending.shown
    assert entries(menu) == [
        "Make it a text",
        "Mend all 2 of this kind",
        "Show where it is",
    ]
    before = text(used)
    QTest.keyClick(menu, Qt.Key.Key_Return)
    used.settle()
    assert text(used) == before.replace('"tet"', '"text"')
    assert used.session.undo_text == "Make it a text"
    codes(used)
    assert signs.at(field) is None
    assert signs.at(settings.field(0, 0)) is not None
    used.window.actions_.actions["undo"].trigger()
    used.settle()
    assert text(used) == before
    codes(used)
    assert signs.at(field) is not None


def test_what_only_warns_has_a_sign_of_another_shape(used: Any) -> None:
    toml = Toml(text(used).replace('langages = ["en"]', 'languages = ["en", "de"]'))
    used.session.commit("situ.toml", toml, "Add a language")
    codes(used)
    signs, sections = form(used).signs, form(used).sections
    warning = signs.at(sections["languages"].rows.field(1, 0))
    assert warning.accessibleName().startswith("Warning: There are no texts in de yet")
    error = signs.at(sections["settings"].rows.field(1, 0))
    assert warning.icon().cacheKey() != error.icon().cacheKey()


def test_what_a_new_file_takes_away_is_begun_as_one_step(used: Any) -> None:
    toml = Toml(text(used).replace('langages = ["en"]', 'languages = ["en", "de"]'))
    used.session.commit("situ.toml", toml, "Add a language")
    before = codes(used)
    assert "missing-texts" in before
    sign = form(used).signs.at(form(used).sections["languages"].rows.field(1, 0))
    form(used).area.ensureWidgetVisible(sign)
    used.settle()
    used.click(sign)
    choose(used, used.window.mending.shown, "Begin the texts in Deutsch")
    assert used.session.undo_text == "Begin the texts in Deutsch"
    assert "missing-texts" not in codes(used)
    used.window.actions_.actions["undo"].trigger()
    used.settle()
    assert codes(used) == before
    # Two applications without a script: it is begun at the application's row.
    application = '<application name="second" start="1"><state no="1" final="true"/></application>'
    root = used.session.root
    (root / "second.rbd.xml").write_text(application)
    named = used.session.project.applications
    more = [*named, "second.rbd.xml"]
    after = writing.put(used.session.value("situ.toml"), "project", "applications", more)
    used.session.commit("situ.toml", after, "Add an application")
    assert "spds-needed" in codes(used)
    problem = next(one for one in used.session.problems if one.code == "spds-needed")
    used.window.mending.open_at([problem], used.window.mapToGlobal(QPoint(200, 200)))
    used.settle()
    choose(used, used.window.mending.shown, "Begin a script of situations")
    assert "spds-needed" not in codes(used)
    assert used.session.project.spds is not None
    used.window.actions_.actions["undo"].trigger()
    used.settle()
    assert "spds-needed" in codes(used)


def test_all_of_a_kind_in_situ_toml_are_mended_as_one_step(used: Any) -> None:
    before = text(used)
    rows = form(used).sections["settings"].rows
    sign = form(used).signs.at(rows.field(0, 0))
    form(used).area.ensureWidgetVisible(sign)
    used.settle()
    used.click(sign)
    choose(used, used.window.mending.shown, "Mend all 2 of this kind")
    assert 'type = "number"' in text(used)
    assert 'type = "text"' in text(used)
    assert used.session.undo_text == "Mend 2 problems of one kind"
    used.window.actions_.actions["undo"].trigger()
    assert text(used) == before


def test_what_is_told_above_the_form_has_its_mend_there(used: Any) -> None:
    def shown() -> dict[str, QPushButton]:
        return {one.text(): one for one in form(used).told.findChildren(QPushButton)}

    used.click(shown()["and 2 more"])
    buttons = shown()
    assert {'Rename it to "languages"', 'Write "user.**"'} <= buttons.keys()
    used.click(buttons['Rename it to "languages"'])
    assert 'name = "ward"   # as on the door\n' in text(used)
    assert used.session.project.languages == ("en",)
    assert "unknown-key" not in codes(used)
    # That the robot is told to speak another language is mended from the application's side.
    (problem,) = [p for p in used.session.problems if p.code == "language-without-texts"]
    used.window.mending.mend(problem)
    assert used.session.project.languages == ("en", "ja")
    assert used.session.undo_text == "Add ja to the languages"
    used.window.mending.mend(problem)
    assert used.session.project.languages == ("en", "ja")
