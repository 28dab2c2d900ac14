"""The panel of problems: going there, mending, and many at once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton

from situ.document import codec, rbd
from situ_studio.panels.problems import PROBLEM, lines, mend_box

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
        index: QModelIndex = model.index(row, 0)
        if index.data(PROBLEM).mend is not None:
            return index
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


def test_what_to_do_is_read_in_a_second_line_where_the_row_is_too_short(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    used = studio(folder(dead_end))
    rows, index = used.window.problems.list, mendable(used)
    words = index.data(PROBLEM).message
    narrow = rows.visualRect(index).height()
    used.window.resize(2560, 800)
    used.settle()
    wide = rows.visualRect(index).height()
    assert narrow > wide
    assert lines(words, rows.width()) == (words,)
    assert " ".join(lines(words, 500)) == words
    first, rest = lines(words, 200)
    assert words.startswith(first)
    assert rest.endswith("…")


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
    assert used.window.sides.current.no_document.isVisible()
    assert [p.code for p in used.session.problems] == ["malformed-xml"]
    assert used.window.problems.list.isVisible()
    used.key(Qt.Key.Key_S, CONTROL)
    assert used.answers.told == []
    assert (tmp_path / "a.rbd.xml").read_text(encoding="utf-8") == "<application"


def test_where_nothing_is_wrong_the_panel_says_so(studio: Start, tmp_path: Path) -> None:
    (tmp_path / "situ.toml").write_text('[project]\nname = "bare"\n', encoding="utf-8")
    assert studio(tmp_path).window.problems.good.isVisible()


def test_many_problems_are_all_told(
    studio: Start, folder: Callable[..., Path], comes: Callable[..., None]
) -> None:
    states = tuple(
        rbd.State(no=str(n), name="x" * 200, events=(rbd.Event(name="go", next=f"{n}000"),))
        for n in range(1, 151)
    )
    used = studio(folder(rbd.Application(name="many", start="1", states=states)))
    if not used.session.problems:
        comes(used.session.problems_changed)
    used.settle()
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


def test_the_form_shows_a_warning_as_one_and_an_error_as_one_and_mends_at_a_click(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    lost = rbd.Event()
    first = replace(dead_end.states[0], events=(*dead_end.states[0].events, lost))
    used = studio(folder(replace(dead_end, states=(first, dead_end.states[1]))))
    told = used.window.inspector.told
    theme = used.window.theme
    for place, severity in ((("state", "2"), "warning"), (("state", "1", "event", "1"), "error")):
        used.select(*place)
        assert told.isVisible()
        shown = {label.property("severity") for label in told.findChildren(QLabel) if label.text()}
        assert shown == {severity}
        (words,) = [label for label in told.findChildren(QLabel) if label.text()]
        assert words.palette().color(words.foregroundRole()) == theme.color(severity)
        assert words.accessibleName().casefold().startswith(severity)
    used.select("state", "2")
    (button,) = told.findChildren(QPushButton)
    used.click(button)
    assert used.session.document(FILE).state("2").final
    assert not told.isVisible()


def test_of_many_problems_the_first_stand_above_the_form_and_a_button_shows_the_others(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    used = studio(folder(dead_end))
    used.select("state", "2")
    told = used.window.inspector.told
    (found,) = [one for one in used.session.problems if one.place == ("state", "2")]

    def show(count: int, place: tuple[str, ...] = ("state", "2")) -> None:
        told.show_problems(tuple(replace(found, message=f"{n}", place=place) for n in range(count)))
        used.settle()

    def seen() -> list[str]:
        labels = [one for one in told.findChildren(QLabel) if one.text() and one.isVisible()]
        return [one.text() for one in labels]

    def more() -> list[QPushButton]:
        buttons = [one for one in told.findChildren(QPushButton) if one.isVisible()]
        return [one for one in buttons if one.text().startswith("and ")]

    show(2)
    assert (seen(), more()) == (["0", "1"], [])
    show(5)
    (button,) = more()
    assert (seen(), button.text()) == (["0", "1"], "and 3 more")
    button.setFocus()
    used.key(Qt.Key.Key_Space)
    assert (seen(), more()) == (["0", "1", "2", "3", "4"], [])
    # The keyboard is at the mend of the first that was not seen.
    focused = used.window.focusWidget()
    assert focused.text() == found.mend.words
    assert focused.toolTip().endswith("\n2")
    # They stay while this place is shown, and only there.
    show(4)
    assert (seen(), more()) == (["0", "1", "2", "3"], [])
    show(4, ("state", "1"))
    assert seen() == ["0", "1"]
    # On a button a single ampersand is not seen.
    assert found.mend is not None
    mend = replace(found.mend, words="tea & talk")
    told.show_problems((replace(found, mend=mend),))
    used.settle()
    (button,) = told.findChildren(QPushButton)
    assert button.text() == "tea && talk"
    assert button.toolTip() == f"tea & talk\n{found.message}"
    # Where nothing mends them, it goes on to the form.
    told.show_problems(tuple(replace(found, message=f"{n}", mend=None) for n in range(3)))
    used.settle()
    (button,) = more()
    button.setFocus()
    used.key(Qt.Key.Key_Space)
    assert used.window.inspector.form.field("name").hasFocus()


def test_a_long_mend_makes_no_panel_wider_and_short_places_leave_room_for_the_words(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    first, last = dead_end.states
    tag = "user.name-that-nobody-writes-and-that-is-long"
    asks = rbd.Text(id="asks", x=0, y=50, width=90, height=20, text=f"{{{tag}}}")
    assert first.screen is not None
    screen = replace(first.screen, components=(*first.screen.components, asks))
    path = folder(replace(dead_end, states=(replace(first, screen=screen), last)))
    (path / "many.spds.xml").write_text(
        '<spds name="many"><modules><module name="many" resources="screen"/></modules>'
        '<situation name="always"><module name="many" priority="1"/></situation></spds>'
    )
    with (path / "situ.toml").open("a") as toml:
        toml.write('spds = "many.spds.xml"\n')
    used = studio(path)
    dock = used.window.docks["inspector"]
    before = dock.width()
    used.select("state", "1", "screen", "asks")
    (button,) = used.window.inspector.told.findChildren(QPushButton)
    assert tag in button.text()
    assert dock.width() == before
    assert used.window.inspector.rect().contains(
        button.mapTo(used.window.inspector, button.rect().bottomRight())
    )
    # A row: its place is short, and the words begin after it.
    rows = used.window.problems.list
    picture = rows.viewport().grab(rows.visualRect(mendable(used))).toImage()
    middle = range(picture.height() // 4, picture.height() * 3 // 4)
    beside = {picture.pixelColor(x, y).name() for x in range(110, 190) for y in middle}
    assert len(beside) > 1, "nothing is written there"


def test_many_warnings_of_one_kind_hide_no_others_and_are_shown_when_asked_for(
    studio: Start, folder: Callable[..., Path]
) -> None:
    """Thirty states that nothing reaches, and one that nothing leaves."""
    states = tuple(
        rbd.State(no=str(n), events=(rbd.Event(name="go", next="1"),)) for n in range(2, 32)
    )
    used = studio(folder(rbd.Application(name="many", states=(rbd.State(no="1"), *states))))
    rows = used.window.problems.list
    model = rows.model()
    every = [p for p in used.session.problems if p.severity == "warning"]
    alike = [p for p in every if p.code == "unreachable-state"]
    assert len(alike) == 30
    before = model.rowCount()
    shown = {model.index(row, 0).data(PROBLEM) for row in range(before)} - {None}
    assert {p.code for p in shown} == {p.code for p in every}
    assert len([p for p in shown if p.code == "unreachable-state"]) == 3
    used.click_row(rows, used.row_with(rows, "Show 27 more like these"))
    now = [model.index(row, 0).data(PROBLEM) for row in range(model.rowCount())]
    assert [p for p in now if p is not None and p.code == "unreachable-state"] == alike
    fewer = used.row_with(rows, "Show only 3 of these 30")
    rows.setCurrentIndex(fewer)
    rows.setFocus()
    used.key(Qt.Key.Key_Return)
    assert model.rowCount() == before
    # The next problem is a problem: the rows between are stepped over.
    seen = []
    for _ in range(len(shown)):
        used.key(Qt.Key.Key_F8)
        seen.append(rows.currentIndex().data(PROBLEM))
    assert set(seen) == shown


def test_a_module_that_never_wins_is_raised_by_a_click_and_lowered_by_undo(
    studio: Start, folder: Callable[..., Path], dead_end: rbd.Application
) -> None:
    """The application always holds the screen that the module could ask for."""
    first, last = dead_end.states
    path = folder(replace(dead_end, states=(first, replace(last, final=True))))
    (path / "many.spds.xml").write_text(
        '<spds name="many"><modules><module name="many" resources="screen"/>'
        '<module name="alarm" resources="screen"/></modules><situation name="always">'
        '<module name="many" priority="30"/><module name="alarm" priority="20"/>'
        "</situation></spds>"
    )
    with (path / "situ.toml").open("a") as toml:
        toml.write('spds = "many.spds.xml"\n')
    used = studio(path)
    (problem,) = [p for p in used.session.problems if p.code == "never-wins"]
    rows = used.window.problems.list
    index = next(
        rows.model().index(row, 0)
        for row in range(rows.model().rowCount())
        if rows.model().index(row, 0).data(PROBLEM) == problem
    )
    box = mend_box(rows.visualRect(index), problem)
    QTest.mouseClick(rows.viewport(), Qt.MouseButton.LeftButton, pos=box.center())
    used.settle()
    script = "many.spds.xml"
    assert [e.priority for e in used.session.document(script).situations[0].entries] == [30, 31]
    assert used.session.undo_text == 'Raise it to 31 in "always", above "many"'
    assert "never-wins" not in {p.code for p in used.session.problems}
    used.window.actions_.actions["undo"].trigger()
    used.settle()
    assert [e.priority for e in used.session.document(script).situations[0].entries] == [30, 20]
    assert "never-wins" in {p.code for p in used.session.problems}
