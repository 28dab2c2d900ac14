"""Problems where they are: going there, menus of mends, all of a kind, accepted warnings."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QAccessible, QContextMenuEvent, QHelpEvent
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication, QMenu, QToolTip

from situ.document import codec
from situ.document.beside import Toml
from situ_studio.edits import places
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.lists import MARKS
from situ_studio.panels.problems import PROBLEM
from situ_studio.problems.alike_mending import AlikeMending

CONTROL = Qt.KeyboardModifier.ControlModifier
PATIENCE = 20_000
FILE = "ward.rbd.xml"
SCRIPT = "ward.spds.xml"

APPLICATION = """<application name="ward">
  <state no="1" name="Hello">
    <timeout next="11" idle="true">30</timeout>
    <screen>
      <components>
        <button id="tea" x="10" y="10" width="30" height="2" event="tea">Tea</button>
        <button id="coffee" x="50" y="10" width="30" height="2" event="coffee">Coffee</button>
        <text id="pale" x="10" y="50" width="80" height="20" size="9" color="#9aa5b8">Pale</text>
      </components>
    </screen>
    <expectedevents>
      <event name="tea" next="2"/>
    </expectedevents>
  </state>
  <state no="2" name="Tea"/>
</application>
"""
SPDS = """<spds name="ward">
  <modules>
    <module name="ward" resources="screen speech"/>
    <module name="look" resources="head"/>
    <module name="nod" resources="head"/>
  </modules>
  <situation name="day">
    <module name="ward" priority="1"/>
    <module name="look" priority="5"/>
    <module name="nod" priority="5"/>
  </situation>
</spds>
"""
TOML = f"""[project]
name = "ward"
applications = ["{FILE}"]
spds = "{SCRIPT}"
languages = ["en", "ja", "de"]

[tags]
"robot.name" = "Situ"
"dose" = "1"

[[setting]]
tag = "volume"
type = "numbr"

[[setting]]
tag = "dose"
type = "numbr"
"""
PO = """msgid ""
msgstr "Content-Type: text/plain; charset=UTF-8\\n"

msgid "Tea"
msgstr "お茶"
"""

Start = Callable[..., Any]


@pytest.fixture
def ward(studio: Start, tmp_path: Path) -> Any:
    (tmp_path / FILE).write_text(APPLICATION, encoding="utf-8")
    (tmp_path / SCRIPT).write_text(SPDS, encoding="utf-8")
    (tmp_path / "situ.toml").write_text(TOML, encoding="utf-8")
    (tmp_path / "texts").mkdir()
    for language in ("ja", "de"):
        (tmp_path / "texts" / f"{language}.po").write_text(PO, encoding="utf-8")
    return studio(tmp_path)


def problem(used: Any, code: str, *place: str) -> Any:
    found = [p for p in used.session.problems if p.code == code and p.place[: len(place)] == place]
    assert found, (code, place, [(p.code, p.place) for p in used.session.problems])
    return found[0]


def row_of(used: Any, wanted: Any) -> Any:
    """The row of the list with that problem, which is current and has the focus then."""
    rows = used.window.problems.list
    model = rows.model()
    (index,) = [
        model.index(row, 0)
        for row in range(model.rowCount())
        if model.index(row, 0).data(PROBLEM) == wanted
    ]
    rows.setFocus()
    rows.setCurrentIndex(index)
    return index


def entries(menu: QMenu) -> list[str]:
    return [action.text() for action in menu.actions() if not action.isSeparator()]


def choose(used: Any, menu: QMenu, text: str) -> None:
    """Goes down to an entry by keys, and takes it."""
    (wanted,) = [action for action in menu.actions() if action.text() == text]
    for _ in menu.actions():
        if menu.activeAction() == wanted:
            break
        QTest.keyClick(menu, Qt.Key.Key_Down)
    assert menu.activeAction() == wanted
    QTest.keyClick(menu, Qt.Key.Key_Return)
    used.settle()


def codes(used: Any) -> list[str]:
    return [p.code for p in used.session.problems]


def test_a_problem_is_shown_where_it_can_be_seen(ward: Any) -> None:
    """A click on a row: a component on its screen, a priority in the script, a text in its cell,
    a setting in its field."""
    window = ward.window
    assert window.current_view.shown_as == "graph"
    wanted = problem(ward, "small-target", "state", "1", "screen", "coffee")
    rows = window.problems.list
    ward.click_row(rows, row_of(ward, wanted))
    assert window.current_view.shown_as == "split"
    assert window.current_view.selected == (("state", "1", "screen", "coffee"),)
    assert window.beside.sheet.selected == ("coffee",)

    tie = problem(ward, "tie")
    ward.click_row(rows, row_of(ward, tie))
    assert window.current_file == SCRIPT
    assert window.current_view.selected == (("situation", "day", "entry", "2"),)

    (in_german,) = [
        p
        for p in ward.session.problems
        if p.code == "missing-text" and "de.po" in p.message and p.place[-1:] == ("coffee",)
    ]
    ward.click_row(rows, row_of(ward, in_german))
    assert window.tabs.chosen_file == "texts"
    table = window.sides.current.documents.currentWidget().table
    index = table.currentIndex()
    assert table.texts.language(index.column()) == "de"
    assert index.siblingAtColumn(index.column() - 2).data() == "Coffee"

    second = [p for p in ward.session.problems if p.code == "bad-value"][1]
    ward.click_row(rows, row_of(ward, second))
    assert window.tabs.chosen_file == "situ.toml"
    form = window.sides.current.documents.currentWidget()
    field = form.sections["settings"].rows.field(1, 2)
    assert field.hasFocus()
    assert not field.visibleRegion().isEmpty()
    # An edit that is not saved has moved what stands below it.
    toml = ward.session.value("situ.toml")
    moved = Toml(toml.text.replace("[tags]", "[robot]\nadaptr = 'sim'\n\n[tags]"))
    ward.session.commit("situ.toml", moved, "Choose an adapter")
    ward.settle()
    form.sections["tags"].setFocus()
    second = [p for p in ward.session.problems if p.code == "bad-value"][1]
    ward.click_row(rows, row_of(ward, second))
    assert field.hasFocus()
    ward.click_row(rows, row_of(ward, problem(ward, "unknown-key")))
    assert form.sections["robot"].isAncestorOf(QApplication.focusWidget()) or (
        form.sections["robot"].hasFocus()
    )


def test_the_outline_stays_where_somebody_works_in_it(ward: Any) -> None:
    ward.window.show_mode("outline")
    wanted = problem(ward, "small-target", "state", "1", "screen", "coffee")
    ward.click_row(ward.window.problems.list, row_of(ward, wanted))
    assert ward.window.current_view.shown_as == "outline"
    assert ward.window.current_view.selected == (("state", "1", "screen", "coffee"),)


def test_what_is_selected_is_mended_by_keys(ward: Any) -> None:
    """Ctrl+. offers the mends of a component; the first is chosen already."""
    window = ward.window
    ward.select("state", "1", "screen", "pale")
    before = ward.session.document(FILE)
    ward.key(Qt.Key.Key_Period, CONTROL)
    menu = window.mending.shown
    below = {action.text() for action in menu.actions()}
    assert any("hard to read" in text for text in below), below
    assert len(below) == 3
    QTest.keyClick(menu, Qt.Key.Key_Escape)
    ward.settle()
    # Of many problems the menu has the first, and leads to the rest.
    ward.select("state", "1")
    ward.key(Qt.Key.Key_Period, CONTROL)
    menu = window.mending.shown
    assert len(entries(menu)) == 9
    window.bottom.choose("find")
    choose(ward, menu, f"{len(window.mending.here()) - 8} more in the list of problems")
    assert window.bottom.current == "problems"
    assert window.problems.list.hasFocus()
    # One problem: what can be done stands in the menu itself.
    window.current_view.current_view().setFocus()
    ward.select("state", "1", "timeout")
    ward.key(Qt.Key.Key_Period, CONTROL)
    menu = window.mending.shown
    assert entries(menu) == ['Lead to state "1"', "Show where it is"]
    QTest.keyClick(menu, Qt.Key.Key_Return)
    ward.settle()
    assert ward.session.document(FILE).state("1").timeout.next == "1"
    assert "dangling-next" not in codes(ward)
    window.actions_.actions["undo"].trigger()
    assert ward.session.document(FILE) is before


def test_all_of_a_kind_are_one_step_from_a_rows_menu(ward: Any) -> None:
    window = ward.window
    rows = window.problems.list
    before = ward.session.document(FILE)
    wanted = problem(ward, "small-target")
    index = row_of(ward, wanted)
    at = rows.visualRect(index).center()
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, rows.viewport().mapToGlobal(at))
    QApplication.sendEvent(rows.viewport(), event)
    menu = window.mending.shown
    choose(ward, menu, "Mend all 2 of this kind")
    assert "small-target" not in codes(ward)
    after = ward.session.document(FILE).state("1").screen.components
    assert all(c.height > 5 for c in after[:2])
    assert ward.session.undo_text == "Mend 2 problems of one kind"
    window.actions_.actions["undo"].trigger()
    ward.settle()
    assert ward.session.document(FILE) is before
    assert codes(ward).count("small-target") == 2


@pytest.fixture
def large(ward: Any) -> Any:
    """The same, planned by another process as in a large project."""
    ward.window.mending.plan_with(AlikeMending(ward.window.mending, large=0))
    return ward


def told(used: Any, answered: Any) -> str:
    """What the window says once the process has answered, or ended."""
    spy = QSignalSpy(answered)
    assert spy.wait(PATIENCE)
    used.settle()
    return str(used.window.status.said.text())


def test_in_a_large_project_all_of_a_kind_are_mended_beside_the_window(large: Any) -> None:
    """It is shown that it goes on, and is one step; the window is in use meanwhile."""
    window, session = large.window, large.session
    before = session.document(FILE)
    window.mending.mend_alike("small-target")
    assert [work.words for work in window.status.work.going] == ["Mending all problems of one kind"]
    assert session.document(FILE) is before
    assert told(large, window.mending.alike.planned) == "2 problems mended."
    assert window.status.work.going == []
    assert "small-target" not in codes(large)
    assert session.undo_text == "Mend 2 problems of one kind"
    # What was not mended is the very same.
    assert session.document(FILE).states[1] is before.states[1]
    window.actions_.actions["undo"].trigger()
    assert session.document(FILE) is before


def test_what_was_planned_for_another_project_is_not_done(large: Any) -> None:
    window, session = large.window, large.session
    window.mending.mend_alike("small-target")
    renamed = places.change(session.document(FILE), ("state", "2"), name="Milk")
    window.commit(renamed, "Rename")
    said = told(large, window.mending.alike.planned)
    assert said == "The project has changed meanwhile: nothing was mended."
    assert session.document(FILE) is renamed
    # And what is cancelled is done by nobody.
    window.mending.mend_alike("small-target")
    window.status.work.cancel()
    assert window.status.work.going == []
    large.settle()
    assert session.document(FILE) is renamed


def test_a_process_that_ends_early_mends_nothing_and_it_is_said(large: Any) -> None:
    window, session = large.window, large.session
    command = (sys.executable, "-c", "import sys; sys.stdin.buffer.read(1)")
    window.mending.plan_with(AlikeMending(window.mending, large=0, command=command))
    before = session.document(FILE)
    window.mending.mend_alike("small-target")
    said = told(large, window.mending.alike.gone)
    assert said == "These could not be mended: its process ended early. Nothing was changed."
    assert window.status.work.going == []
    assert session.document(FILE) is before


def test_a_warning_is_accepted_and_told_again_after_undo(ward: Any) -> None:
    window = ward.window
    before = ward.session.document(SCRIPT)
    row_of(ward, problem(ward, "tie"))
    ward.key(Qt.Key.Key_F10, Qt.KeyboardModifier.ShiftModifier)
    menu = window.mending.shown
    assert entries(menu)[0] == 'Give "nod" the priority 6 in "day"'
    choose(ward, menu, "Accept this warning")
    assert "tie" not in codes(ward)
    assert b'ed:accept="tie"' in codec.write(ward.session.document(SCRIPT))
    window.actions_.actions["undo"].trigger()
    ward.settle()
    assert ward.session.document(SCRIPT) is before
    assert "tie" in codes(ward)
    # An error can not be accepted.
    row_of(ward, problem(ward, "dangling-next"))
    ward.key(Qt.Key.Key_Period, CONTROL)
    menu = window.mending.shown
    assert "Accept this warning" not in entries(menu)
    QTest.keyClick(menu, Qt.Key.Key_Escape)
    ward.settle()


def test_components_with_problems_are_marked_on_the_screen_and_in_its_list(ward: Any) -> None:
    """With words for the pointer, and for those who hear them."""
    window = ward.window
    ward.select("state", "1")
    window.show_mode("screen")
    ward.settle()
    designer = window.current_view.piece("designer")
    sheet, layers = designer.sheet, designer.side.layers
    pale = [p.message for p in ward.session.problems if p.place[-1:] == ("pale",)]
    assert list(sheet.problems.areas()) == ["tea", "coffee", "pale"]
    sign = sheet.problems.areas()["pale"]
    assert sheet.area(sheet.own()["pale"]).intersects(sign)
    seen = sheet.grab().toImage()
    inside = sign.toRect()
    wanted = LIGHT.color("warning")
    off = {
        max(
            abs(wanted.red() - one.red()),
            abs(wanted.green() - one.green()),
            abs(wanted.blue() - one.blue()),
        )
        for x in range(inside.left(), inside.right())
        for y in range(inside.top(), inside.bottom())
        for one in [seen.pixelColor(x, y)]
    }
    # Its lines are smoothed where they lie between two px.
    assert min(off) < 16
    at = sign.center().toPoint()
    QApplication.sendEvent(sheet, QHelpEvent(QEvent.Type.ToolTip, at, sheet.mapToGlobal(at)))
    assert set(QToolTip.text().split("\n")) == set(pale)
    QToolTip.hideText()
    row = layers.model().index(layers.ids.index("pale"), 0)
    assert row.data(MARKS) == (("warning", "warning"),)
    assert set(row.data(Qt.ItemDataRole.ToolTipRole).split("\n")) == set(pale)
    assert f"Warning: {pale[0]}" in row.data(Qt.ItemDataRole.AccessibleTextRole)
    heard = QAccessible.queryAccessibleInterface(sheet).child(2)
    assert f"Warning: {pale[0]}" in heard.text(QAccessible.Text.Description)
    # What is mended is marked no more.
    box = 'x="10" y="10" width="80" height="40"'
    text = f'<text id="pale" {box} size="9">Hi</text>'
    screen = f"<screen><components>{text}</components></screen>"
    state = f'<state no="1" final="true">{screen}</state>'
    whole = f'<application name="ward">{state}</application>'.replace("Hi", "Tea")
    window.commit(codec.read(whole.encode(), FILE)[0], "Mend it")
    ward.settle()
    assert sheet.problems.areas() == {}
    assert layers.model().index(layers.ids.index("pale"), 0).data(MARKS) == ()


def test_the_context_menu_of_a_component_has_its_problems(ward: Any) -> None:
    window = ward.window
    ward.select("state", "1", "screen", "tea")
    window.show_mode("split")
    ward.settle()
    sheet = window.beside.sheet
    at = sheet.area(sheet.selected_boxes()["tea"]).center().toPoint()
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, sheet.mapToGlobal(at))
    QApplication.sendEvent(sheet, event)
    menu = window.context_menus.shown
    first = menu.actions()[0]
    assert first.text() == "Problems"
    assert "Make it 12 mm large" in _inside(first.menu())
    QTest.keyClick(menu, Qt.Key.Key_Escape)
    ward.settle()
    # What has no problem has no such entry, and Ctrl+. says so.
    ward.select("state", "2")
    assert window.mending.here() == []
    window.context_menus.open(("state", "2"), at)
    assert "Problems" not in entries(window.context_menus.shown)
    QTest.keyClick(window.context_menus.shown, Qt.Key.Key_Escape)
    ward.settle()
    ward.key(Qt.Key.Key_Period, CONTROL)
    assert window.mending.shown is None
    assert window.status.said.text() == "What is selected has no problem."


def _inside(menu: QMenu) -> list[str]:
    """The entries of a menu and of those in it."""
    found = []
    for action in menu.actions():
        below = action.menu()
        found += _inside(below) if isinstance(below, QMenu) else [action.text()]
    return found


def test_the_sign_on_a_pipe_opens_the_mends_of_its_priority(ward: Any) -> None:
    window = ward.window
    window.open_file(SCRIPT)
    ward.settle()
    canvas = window.current_view.piece("graph")
    place = ("situation", "day", "entry", "2")
    pipes = map(canvas.graph.pipe, canvas.graph.links)
    pipe = next(one for one in pipes if one.link.place == place)
    viewer = canvas.viewer
    at = viewer.mapFromScene(pipe.sign_area().center())
    QTest.mouseClick(viewer.viewport(), Qt.MouseButton.LeftButton, pos=at)
    ward.settle()
    assert window.current_view.selected == (place,)
    choose(ward, window.mending.shown, 'Give "nod" the priority 6 in "day"')
    assert "tie" not in codes(ward)
    pipes = map(canvas.graph.pipe, canvas.graph.links)
    assert all(one.sign_area().isEmpty() for one in pipes)
