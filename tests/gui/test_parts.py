"""Parts in the studio: into them and back, making one of some states, and adding one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from situ import cli
from situ.document.rbd import Always
from situ_studio.kinds import MIME
from situ_studio.panels.lists import ICON

ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
LEFT = Qt.MouseButton.LeftButton
RECEPTION, REGISTER = "reception.rbd.xml", "register.rbd.xml"
Start = Callable[..., Any]


TOML = """[project]
name = "reception"
applications = ["reception.rbd.xml"]
"""
OUTER = """<application name="reception" xmlns:ed="urn:situ:editor">
  <state no="1" name="start" ed:x="0" ed:y="0"><timeout next="2">5</timeout></state>
  <state no="2" name="menu" ed:x="230" ed:y="0"><timeout next="11">5</timeout></state>
  <state no="11" name="measure" ed:x="460" ed:y="0"><timeout next="12">5</timeout></state>
  <state no="12" name="SPO2" ed:x="690" ed:y="0"><timeout next="13">5</timeout></state>
  <state no="13" name="register" ed:x="690" ed:y="228">
    <flow src="register.rbd.xml"/>
    <expectedevents><event name="done" next="1"/></expectedevents>
  </state>
</application>
"""
INNER = """<application name="register" xmlns:ed="urn:situ:editor">
  <state no="1" name="ask" ed:x="0" ed:y="0"><timeout next="2">5</timeout></state>
  <state no="2" name="known" final="true" ed:x="230" ed:y="0"/>
</application>
"""


@pytest.fixture
def used(studio: Start, tmp_path: Path) -> Any:
    root = tmp_path / "reception"
    root.mkdir()
    for file, text in (("situ.toml", TOML), (RECEPTION, OUTER), (REGISTER, INNER)):
        (root / file).write_text(text)
    return studio(root)


def holder(used: Any) -> str:
    document = used.session.document(RECEPTION)
    found: str = next(s.no for s in document.states if s.flow == REGISTER)
    return found


def on_card(used: Any, no: str, across: float = 90, down: float = 100) -> QPoint:
    """Px of a state's card in the shown graph, brought into view."""
    canvas = used.window.current_view.canvas
    used.window.select(("state", no))
    canvas.zoom_to([("state", no)])
    used.settle()
    area = canvas.card_area(no)
    at: QPoint = canvas.viewer.mapFromScene(QPointF(area.left() + across, area.top() + down))
    return at


def double_click(used: Any, no: str) -> None:
    port = used.window.current_view.canvas.viewer.viewport()
    at = on_card(used, no, 30, 70)
    QTest.mouseClick(port, LEFT, pos=at)
    QTest.mouseDClick(port, LEFT, pos=at)
    used.settle()


def crumbs(used: Any) -> Any:
    return used.window.crumbs


def test_a_double_click_on_a_part_goes_into_it_in_the_same_tab(used: Any) -> None:
    window = used.window
    tabs = window.tabs.files()
    double_click(used, holder(used))
    assert window.current_file == REGISTER
    assert window.tabs.chosen_file == RECEPTION
    assert window.tabs.files() == tabs
    assert crumbs(used).isVisible()
    assert crumbs(used).button("reception").isVisible()


def test_a_click_on_its_name_above_leads_back_to_what_was_selected_and_seen(used: Any) -> None:
    window, no = used.window, holder(used)
    double_click(used, no)
    view = window.views[RECEPTION]
    looking = view.canvas.looking()
    used.click(crumbs(used).button("reception"))
    assert window.current_file == RECEPTION
    assert not crumbs(used).isVisible()
    assert view.selected == (("state", no),)
    assert view.canvas.looking() == looking


def test_keys_lead_into_the_part_and_back(used: Any) -> None:
    window = used.window
    used.select("state", holder(used))
    window.current_view.current_view().setFocus()
    used.key(Qt.Key.Key_Right, ALT)
    assert window.current_file == REGISTER
    assert window.current_view.canvas.viewer.hasFocus()
    used.key(Qt.Key.Key_Left, ALT)
    assert window.current_file == RECEPTION
    assert window.current_view.canvas.viewer.hasFocus()


def test_the_names_above_are_reached_by_tab_and_pressed_by_space(used: Any) -> None:
    double_click(used, holder(used))
    button = crumbs(used).button("reception")
    assert button.focusPolicy() & Qt.FocusPolicy.TabFocus
    button.setFocus()
    used.key(Qt.Key.Key_Space)
    assert used.window.current_file == RECEPTION


def test_a_tab_keeps_how_far_in_it_was_and_the_tree_still_opens_the_parts_own(used: Any) -> None:
    window = used.window
    double_click(used, holder(used))
    window.tabs.choose(REGISTER)
    used.settle()
    assert not crumbs(used).isVisible()
    window.tabs.choose(RECEPTION)
    used.settle()
    assert window.current_file == REGISTER
    tree = window.project_tree.tree
    used.click_row(tree, used.row_with(tree, "reception").siblingAtRow(0))
    window.open_file(RECEPTION)
    assert window.current_file == RECEPTION
    assert window.tabs.chosen_file == RECEPTION


def test_closing_the_parts_own_tab_leaves_it_shown_in_the_other(used: Any) -> None:
    window = used.window
    double_click(used, holder(used))
    window.tabs.choose(REGISTER)
    used.settle()
    while window.tabs.files() != [RECEPTION]:
        window.tabs.choose(window.tabs.files()[-1])
        window.open_files.close_chosen()
        used.settle()
    assert window.current_file == REGISTER
    assert crumbs(used).isVisible()
    assert window.current_view.canvas.viewer.isVisible()


# -- making one --------------------------------------------------------------------


def choose_states(used: Any, *numbers: str) -> None:
    view = used.window.current_view
    view.select(tuple(("state", no) for no in numbers))
    view.current_view().setFocus()
    used.window.panels.settle_selection()
    used.settle()


def command(used: Any, id: str) -> None:
    action = used.window.actions_.actions[id]
    used.window.actions_.refresh()
    assert action.isEnabled()
    action.trigger()
    used.settle()


MEASURE = ("11", "12")
"""Two states into which one way leads."""


def test_selected_states_become_a_part_in_one_step(used: Any) -> None:
    window, before = used.window, used.session.document(RECEPTION)
    choose_states(used, *MEASURE)
    used.answers.put("name", "Vital signs")
    command(used, "part.make")
    document = used.session.document(RECEPTION)
    assert document.state("11").flow == "vital-signs.rbd.xml"
    assert document.state("12") is None
    assert window.current_view.selected == (("state", "11"),)
    assert used.session.undo_text == "Make a part: Vital signs"
    row = used.row_with(window.project_tree.tree, "vital-signs •")
    assert row.data(ICON) == ("part", "part")
    used.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert used.session.document(RECEPTION) is before
    assert used.session.document("vital-signs.rbd.xml") is None
    with pytest.raises(AssertionError):
        used.row_with(window.project_tree.tree, "vital-signs")
    used.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier | SHIFT)
    assert used.session.document(RECEPTION) is document


def test_a_part_that_was_made_is_saved_and_the_project_has_no_errors(
    used: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    choose_states(used, *MEASURE)
    used.answers.put("name", "vitals")
    command(used, "part.make")
    command(used, "save")
    root = used.session.root
    assert (root / "vitals.rbd.xml").exists()
    assert used.session.dirty == []
    used.session.check_now()
    assert [p for p in used.session.problems if p.severity == "error"] == []
    assert cli.main(["check", str(root)]) == 0
    capsys.readouterr()


def test_undo_inside_of_a_new_part_leads_back_out_of_it(used: Any) -> None:
    choose_states(used, *MEASURE)
    used.answers.put("name", "vitals")
    command(used, "part.make")
    double_click(used, "11")
    assert used.window.current_file == "vitals.rbd.xml"
    command(used, "undo")
    assert used.window.current_file == RECEPTION
    assert not crumbs(used).isVisible()


def test_states_that_are_no_part_are_refused_in_one_line(used: Any) -> None:
    before = used.session.document(RECEPTION)
    choose_states(used, "2", "13")
    command(used, "part.make")
    assert "A part begins in one state" in used.window.status.said.text()
    assert used.session.document(RECEPTION) is before


def test_a_new_part_that_was_not_saved_comes_back_after_a_crash(used: Any, studio: Start) -> None:
    choose_states(used, *MEASURE)
    used.answers.put("name", "vitals")
    command(used, "part.make")
    recovery = used.window.recovery
    recovery.keep()
    # As a process that is killed: its lock goes with it, its file stays.
    recovery._lock.unlock()
    recovery._file = recovery._lock = None
    part = used.session.document("vitals.rbd.xml")
    again = studio(used.session.root)
    again.click(again.window.recovered.buttons[0])
    assert again.session.document("vitals.rbd.xml") == part
    assert again.session.document(RECEPTION).state("11").flow == "vitals.rbd.xml"
    assert sorted(again.session.dirty) == [RECEPTION, "vitals.rbd.xml"]


def test_a_part_is_dissolved_to_what_it_was_made_of(used: Any) -> None:
    before = used.session.document(RECEPTION)
    choose_states(used, *MEASURE)
    used.answers.put("name", "vitals")
    command(used, "part.make")
    command(used, "part.dissolve")
    after = used.session.document(RECEPTION)
    assert {s.no: s for s in after.states} == {s.no: s for s in before.states}
    places = {s.no: s.aside.position for s in after.states}
    assert places == {s.no: s.aside.position for s in before.states}
    assert used.session.undo_text == "Dissolve part vitals"


def test_a_part_that_can_not_be_dissolved_says_why(used: Any) -> None:
    before = used.session.document(RECEPTION)
    part = used.session.document(REGISTER)
    used.session.commit(REGISTER, replace(part, always=Always()), "Add what every state has")
    used.select("state", holder(used))
    command(used, "part.dissolve")
    assert "has something in every state" in used.window.status.said.text()
    assert used.session.document(RECEPTION) is before


# -- adding one --------------------------------------------------------------------


def drop(used: Any, kind: str, at: QPoint) -> None:
    data = QMimeData()
    data.setData(MIME, kind.encode())
    port = used.window.current_view.canvas.viewer.viewport()
    none, action = Qt.KeyboardModifier.NoModifier, Qt.DropAction.CopyAction
    for event in (
        QDragEnterEvent(at, action, data, LEFT, none),
        QDragMoveEvent(at, action, data, LEFT, none),
        QDropEvent(QPointF(at), action, data, LEFT, none),
    ):
        QApplication.sendEvent(port, event)
    used.settle()


def test_a_part_from_the_palette_runs_the_one_that_is_chosen(used: Any) -> None:
    used.answers.put("part", "register")
    used.click(used.window.palette_.item("part"))
    document = used.session.document(RECEPTION)
    made = document.states[-1]
    assert (made.name, made.flow) == ("register", REGISTER)
    assert made.aside.position is not None
    assert used.window.current_view.selected == (("state", made.no),)


def test_a_part_dropped_on_a_pipe_goes_between_and_a_new_name_is_a_new_part(used: Any) -> None:
    canvas = used.window.current_view.canvas
    on_card(used, "2")
    links = [i for i in canvas.graph.links if i[0] == "2" and i[2] != "2"]
    link, spot = next(
        (link, at)
        for link in links
        for part in (0.5, 0.4, 0.6, 0.3, 0.7, 0.2)
        if canvas.place_at(at := canvas.graph.pipe(link).path().pointAtPercent(part))
        == canvas.link_place(link)
    )
    canvas.viewer.look_at(spot)
    used.answers.put("part", "Small talk")
    drop(used, "part", canvas.viewer.mapFromScene(spot))
    document = used.session.document(RECEPTION)
    made = document.states[-1]
    assert made.flow == "small-talk.rbd.xml"
    assert [(e.name, e.next) for e in made.events] == [("done", link[2])]
    assert used.session.document("small-talk.rbd.xml").states[0].name == "start"
    assert document.state("2").timeout.next == made.no
    assert used.session.undo_text == "Add part Small talk"


def test_an_application_that_runs_this_one_is_no_part_of_it(used: Any) -> None:
    double_click(used, holder(used))
    before = used.session.document(REGISTER)
    used.answers.put("part", "reception")
    used.click(used.window.palette_.item("part"))
    assert used.session.document(REGISTER) is before
    assert "can not be a part of it" in used.window.status.said.text()


def test_the_scenarios_that_name_states_of_a_new_part_are_told(used: Any, tmp_path: Path) -> None:
    folder = tmp_path / "reception" / "scenarios"
    folder.mkdir()
    for name, state in (("measured", "12"), ("registered", "13/1"), ("began", "1")):
        line = '{"at":2,"expect":{"kind":"enter","state":"STATE"}}\n'.replace("STATE", state)
        (folder / f"{name}.jsonl").write_text(line)
    choose_states(used, *MEASURE)
    used.answers.put("name", "vitals")
    command(used, "part.make")
    said = used.window.status.said.text()
    assert said == "vitals is a part now; in scenarios its states are 11/… from here: measured."
