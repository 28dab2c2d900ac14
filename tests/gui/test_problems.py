"""The panel of problems: going there, mending, and many at once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtTest import QTest

from situ.document import codec, rbd
from situ_studio.panels.problems import PROBLEM, mend_box

CONTROL = Qt.KeyboardModifier.ControlModifier
FILE = "many.rbd.xml"

Start = Callable[..., Any]


@pytest.fixture
def folder(tmp_path: Path) -> Callable[[rbd.Application], Path]:
    """``folder(application)``: a project with that application."""

    def make(application: rbd.Application) -> Path:
        (tmp_path / FILE).write_bytes(codec.write(application))
        toml = f'[project]\nname = "many"\napplications = ["{FILE}"]\n'
        (tmp_path / "situ.toml").write_text(toml, encoding="utf-8")
        return tmp_path

    return make


@pytest.fixture
def dead_end() -> rbd.Application:
    """State 2 has no way out, and does not say that this is meant."""
    go = rbd.Event(name="go", next="2")
    button = rbd.Button(id="b", x=10, y=10, width=40, height=20, event="go", text="Go")
    first = rbd.State(no="1", name="a", events=(go,), screen=rbd.Screen(components=(button,)))
    return rbd.Application(name="many", start="1", states=(first, rbd.State(no="2", name="b")))


def mendable(used: Any) -> QModelIndex:
    model = used.window.problems.list.model()
    for row in range(model.rowCount()):
        if model.index(row, 0).data(PROBLEM).mend is not None:
            return model.index(row, 0)  # type: ignore[no-any-return]
    raise AssertionError("no problem has a mend")


def test_a_mend_is_one_click_and_one_step(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    used = studio(folder(dead_end))
    rows = used.window.problems.list
    index = mendable(used)
    problem = index.data(PROBLEM)
    count = len(used.session.problems)
    box = mend_box(rows.visualRect(index), problem)
    assert rows.viewport().rect().contains(box)
    QTest.mouseClick(rows.viewport(), Qt.MouseButton.LeftButton, pos=box.center())
    used.settle()
    assert used.session.document(FILE).state("2").final
    assert used.session.undo_text == problem.mend.words
    assert len(used.session.problems) == count - 1
    used.window.actions_.actions["undo"].trigger()
    used.settle()
    assert len(used.session.problems) == count


def test_a_mend_is_done_by_the_keyboard(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    used = studio(folder(dead_end))
    rows = used.window.problems.list
    rows.setFocus()
    rows.setCurrentIndex(mendable(used))
    used.key(Qt.Key.Key_Return, CONTROL)
    assert used.session.document(FILE).state("2").final


def test_a_mend_whose_place_has_changed_says_so(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    used = studio(folder(dead_end))
    problem = mendable(used).data(PROBLEM)
    used.select("state", "2")
    used.click(used.window.inspector.form.field("final"))
    step = used.session.undo_text
    used.window.problems.mend_asked.emit(problem)
    assert used.session.undo_text == step
    assert "changed meanwhile" in used.window.status.said.text()


def test_a_project_without_a_document_says_so(studio: Start, tmp_path: Path) -> None:
    toml = '[project]\nname = "bare"\napplications = ["a.rbd.xml"]\n'
    (tmp_path / "situ.toml").write_text(toml, encoding="utf-8")
    (tmp_path / "a.rbd.xml").write_text("<application", encoding="utf-8")
    used = studio(tmp_path)
    assert used.window.no_document.isVisible()
    assert [p.code for p in used.session.problems] == ["malformed-xml"]
    assert used.window.problems.list.isVisible()
    used.key(Qt.Key.Key_S, CONTROL)
    assert used.answers.told == []
    assert (tmp_path / "a.rbd.xml").read_text(encoding="utf-8") == "<application"


def test_where_nothing_is_wrong_the_panel_says_so(studio: Start, tmp_path: Path) -> None:
    (tmp_path / "situ.toml").write_text('[project]\nname = "bare"\n', encoding="utf-8")
    assert studio(tmp_path).window.problems.good.isVisible()


def test_many_problems_are_all_told(studio: Start, folder: Callable[..., Path]) -> None:
    states = tuple(
        rbd.State(no=str(n), name="x" * 200, events=(rbd.Event(name="go", next=f"{n}000"),))
        for n in range(1, 151)
    )
    used = studio(folder(rbd.Application(name="many", start="1", states=states)))
    model = used.window.problems.list.model()
    errors = [p for p in used.session.problems if p.severity == "error"]
    assert len(errors) == 150
    assert model.rowCount() == len(used.session.problems)
    assert used.window.status.errors.text() == "150"
    rows = used.window.problems.list
    last = model.index(149, 0).data(PROBLEM)
    used.click_row(rows, model.index(149, 0))
    assert used.window.inspector.place[:2] == last.place[:2]
    # The list stays where it was.
    assert rows.currentIndex().data(PROBLEM) == last
    assert rows.viewport().rect().intersects(rows.visualRect(rows.currentIndex()))
    # A long name makes no panel wider than it is.
    assert used.window.docks["inspector"].width() < 300
    assert used.window.docks["project"].width() < 250
