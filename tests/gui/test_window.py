"""The window: open, look, edit, undo, save."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from situ.errors import UsageError
from situ_studio.main import create_window

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def test_a_project_opens_with_a_tab_for_each_document(studio: Start, project: Copy) -> None:
    window = studio(project("conversation")).window
    assert window.tabs.files() == ["converse.rbd.xml", "conversation.spds.xml"]
    assert window.windowTitle() == "conversation — Situ Studio"
    assert window.current_file == "converse.rbd.xml"


def test_the_project_tree_opens_a_document_that_has_no_tab(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    tree = used.window.project_tree.tree
    used.click_row(tree, used.row_with(tree, "modules"))
    assert used.window.current_file == "modules.xml"
    assert "modules.xml" in used.window.tabs.files()


def test_of_a_place_that_is_not_there_nothing_is_selected(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.window.open_file("modules.xml")
    used.select("module", "nod", "requires", "99")
    assert used.window.current_view.selected == (("module", "nod"),)
    used.select("state", "1")
    assert used.window.current_view.selected == ()
    assert not used.window.actions_.actions["next_exit"].isEnabled()


def test_the_outline_selects_everywhere(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    outline = used.window.outline.list
    used.click_row(outline, used.row_with(outline, "names"))
    assert used.window.current_view.selected == (("state", "8"),)
    assert used.window.inspector.place == ("state", "8")
    assert used.window.status.selection.text() == "1 state selected"


def test_a_state_is_renamed_in_the_inspector(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), "hello there")
    document = used.session.document("reception.rbd.xml")
    assert document.state("2").name == "hello there"
    assert used.session.undo_text == "Rename state 2"
    outline = used.window.outline.list
    assert used.row_with(outline, "hello there").isValid()


def test_a_field_left_by_escape_changes_nothing(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    field = used.window.inspector.form.field("name")
    used.fill(field, "something", end=Qt.Key.Key_Escape)
    assert field.text() == "intro"
    assert used.session.undo_text is None


def test_a_new_number_is_followed_by_every_transition(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("no"), "hello")
    document = used.session.document("reception.rbd.xml")
    assert document.state("2") is None
    start = document.state("1")
    assert "hello" in {e.next for e in start.events}
    assert "2" not in {e.next for s in document.states for e in s.events}
    assert used.window.current_view.selected == (("state", "hello"),)


def test_a_number_that_is_taken_is_refused_with_words(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    field = used.window.inspector.form.field("no")
    used.fill(field, "3")
    assert field.toolTip() == "3 is taken already."
    assert field.text() == "2"
    assert used.session.undo_text is None


def test_a_state_is_renamed_in_the_outline_view(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.click(used.window.tabs.views.button("outline"))
    twin = used.window.current_view.twin
    index = used.row_with(twin.tree, "intro", column=1)
    used.click_row(twin.tree, index, double=True)
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("welcome")
    used.key(Qt.Key.Key_Return)
    assert used.session.document("reception.rbd.xml").state("2").name == "welcome"
    assert used.row_with(twin.tree, "welcome", column=1).isValid()


def test_undo_and_redo_bring_document_and_selection_back(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    before = used.session.document("reception.rbd.xml")
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("no"), "hello")
    after = used.session.document("reception.rbd.xml")
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.document("reception.rbd.xml") is before
    assert used.window.current_view.selected == (("state", "2"),)
    assert used.session.dirty == []
    used.key(Qt.Key.Key_Z, CONTROL | SHIFT)
    assert used.session.document("reception.rbd.xml") is after
    assert used.window.current_view.selected == (("state", "hello"),)


def test_undo_in_a_field_takes_the_edit_back_once_it_is_one(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    field = used.window.inspector.form.field("name")
    used.fill(field, "hello")
    assert field.hasFocus()
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.document("reception.rbd.xml").state("2").name == "intro"
    assert field.text() == "intro"


def test_saving_an_unchanged_example_changes_no_byte(studio: Start, project: Copy) -> None:
    for name in ("reception", "conversation"):
        folder = project(name)
        before = {f: f.read_bytes() for f in folder.rglob("*.xml")}
        used = studio(folder)
        for file in used.session.files:
            used.session.reconciling.keep_mine(file)
        used.session.save()
        assert {f: f.read_bytes() for f in folder.rglob("*.xml")} == before


def test_saving_writes_one_line_for_one_field(studio: Start, project: Copy) -> None:
    folder = project("reception")
    file = folder / "reception.rbd.xml"
    before = file.read_text(encoding="utf-8").splitlines()
    used = studio(folder)
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), "hello")
    assert used.window.windowTitle() == "reception* — Situ Studio"
    used.key(Qt.Key.Key_S, CONTROL)
    after = file.read_text(encoding="utf-8").splitlines()
    changed = [(a, b) for a, b in zip(before, after, strict=True) if a != b]
    assert len(changed) == 1
    assert changed[0][1] == changed[0][0].replace('name="intro"', 'name="hello"')
    assert used.session.dirty == []
    assert used.window.windowTitle() == "reception — Situ Studio"
    assert used.window.status.saved.text().startswith("Saved ")


def test_an_event_and_its_timeout_are_added_in_the_inspector(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    count = len(used.session.document("reception.rbd.xml").state("2").events)
    used.click(used.window.inspector.form.section("events").add)
    assert used.window.inspector.place == ("state", "2", "event", str(count))
    used.fill(used.window.inspector.form.field("name"), "waved")
    used.choose(used.window.inspector.form.field("next"), "5 verify initials")
    event = used.session.document("reception.rbd.xml").state("2").events[count]
    assert (event.name, event.next) == ("waved", "5")
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("timeout"), "12.5")
    assert used.session.document("reception.rbd.xml").state("2").timeout.seconds == 12.5


def test_a_wrong_number_is_refused_and_put_back(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    field = used.window.inspector.form.field("timeout")
    shown = field.text()
    used.fill(field, "-3")
    assert field.toolTip() == "Write a number above 0."
    used.window.inspector.form.field("name").setFocus()
    assert field.text() == shown
    assert used.session.undo_text is None


def test_a_dangling_next_is_a_problem_and_a_click_selects_it(studio: Start, project: Copy) -> None:
    folder = project("reception")
    file = folder / "reception.rbd.xml"
    text = file.read_text(encoding="utf-8")
    assert 'next="14"' in text
    file.write_text(text.replace('next="14"', 'next="77"', 1), encoding="utf-8")
    used = studio(folder)
    problems = used.window.problems.list
    assert problems.model().rowCount() == 1
    assert "77" in problems.model().index(0, 0).data()
    assert used.window.status.errors.text() == "1"
    used.click_row(problems, problems.model().index(0, 0))
    assert used.window.inspector.place[0] == "state"
    assert len(used.window.inspector.place) > 2


def test_problems_come_and_go_with_edits(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    assert used.session.problems == []
    used.select("state", "2", "event", "0")
    from situ_studio.edits import places

    broken = places.change(
        used.session.document("reception.rbd.xml"), ("state", "2", "event", "0"), next="99"
    )
    used.window.commit(broken, "Lead event to nowhere")
    used.settle()
    assert [p.severity for p in used.session.problems] == ["error"]
    assert used.window.bottom.button("problems").accessibleName() == "Problems 1"
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.problems == []


def test_the_command_palette_runs_a_command(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_K, CONTROL)
    assert used.window.finder.isVisible()
    used.type("dark")
    used.key(Qt.Key.Key_Return)
    assert not used.window.finder.isVisible()
    assert used.window.theme.name == "dark"


def test_the_command_palette_finds_a_state_by_what_it_says(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_K, CONTROL)
    used.type("learn user")
    used.key(Qt.Key.Key_Return)
    assert used.window.current_view.selected == (("state", "15"),)


def test_escape_closes_the_command_palette(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.click(used.window.search)
    assert used.window.finder.isVisible()
    used.key(Qt.Key.Key_Escape)
    assert not used.window.finder.isVisible()


def test_the_theme_is_kept_for_the_next_time(studio: Start, project: Copy, settings: Any) -> None:
    used = studio(project("reception"), theme="light")
    used.window.actions_.actions["theme.dark"].trigger()
    used.settle()
    assert used.window.palette().window().color().name() == "#1b1f27"
    assert settings.value("theme") == "dark"
    again = studio(None, theme=None)
    assert again.window.theme.name == "dark"


def test_geometry_comes_back(studio: Start, project: Copy, settings: Any) -> None:
    used = studio(project("reception"))
    used.window.docks["palette"].hide()
    used.window.resize(800, 560)
    used.settle()
    used.window.close()
    again = create_window(used.session.root, settings)
    try:
        assert (again.width(), again.height()) == (800, 560)
    finally:
        again.deleteLater()
        QApplication.processEvents()


def test_a_palette_item_is_inserted_by_a_press(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    count = len(used.session.document("reception.rbd.xml").state("2").actions)
    used.click(used.window.palette_.item("set"))
    state = used.session.document("reception.rbd.xml").state("2")
    assert len(state.actions) == count + 1
    assert used.window.inspector.place == ("state", "2", "action", str(count))


def test_an_action_without_a_state_is_refused_with_words(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.click(used.window.palette_.item("speech"))
    assert used.session.undo_text is None
    assert used.window.status.said.text() == "Select a state first, then add the speech."


def test_a_state_that_runs_a_part_takes_no_actions_of_its_own(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "16")
    used.click(used.window.palette_.item("speech"))
    assert used.session.undo_text is None
    said = "State 16 runs register.rbd.xml: add the speech there."
    assert used.window.status.said.text() == said
    used.click(used.window.palette_.item("event"))
    assert used.window.inspector.place == ("state", "16", "event", "3")
    used.click(used.window.palette_.item("set"))
    assert used.window.inspector.place == ("state", "16", "event", "3", "action", "0")


def test_a_project_opens_with_its_parts_beside_it(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    assert used.window.tabs.files() == ["reception.rbd.xml", "register.rbd.xml"]
    tree = used.window.project_tree.tree
    used.click_row(tree, used.row_with(tree, "register"))
    assert used.window.current_file == "register.rbd.xml"
    outline = used.window.outline.list
    assert used.row_with(outline, "verify name").isValid()


def test_delete_takes_a_state_and_what_leads_to_it(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.show_mode("outline")
    used.select("state", "14")
    used.window.actions_.actions["delete"].trigger()
    document = used.session.document("reception.rbd.xml")
    assert document.state("14") is None
    assert not [e for s in document.states for e in s.events if e.next == "14"]
    used.window.actions_.actions["undo"].trigger()
    assert used.session.dirty == []


def test_a_project_that_is_none_is_one_line(tmp_path: Path, qt: QApplication) -> None:
    with pytest.raises(UsageError, match="no such file"):
        create_window(tmp_path / "nowhere")


def test_tabs_close_but_for_the_last(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    used.key(Qt.Key.Key_W, CONTROL)
    assert used.window.tabs.files() == ["conversation.spds.xml"]
    used.key(Qt.Key.Key_W, CONTROL)
    assert used.window.tabs.files() == ["conversation.spds.xml"]
    assert used.window.current_file == "conversation.spds.xml"


def test_the_lower_panels_fold_and_unfold(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    bottom = used.window.bottom
    high = used.window.documents.height()
    used.click(bottom.button("problems"))
    assert bottom.is_folded
    assert used.window.documents.height() > high
    used.click(used.window.status.errors)
    assert not bottom.is_folded


def test_a_panel_that_was_hidden_comes_back_from_the_menu(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    dock = used.window.docks["inspector"]
    dock.toggleViewAction().trigger()
    assert not dock.isVisible()
    dock.toggleViewAction().trigger()
    assert dock.isVisible()


def test_only_what_a_document_can_take_is_offered(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    actions = used.window.actions_.actions
    assert actions["insert.speech"].isVisible()
    assert not actions["insert.situation"].isVisible()
    used.window.open_file("conversation.spds.xml")
    used.settle()
    assert not actions["insert.speech"].isVisible()
    used.click(used.window.palette_.item("situation"))
    script = used.session.document("conversation.spds.xml")
    assert [s.name for s in script.situations][-2:] == ["situation", "conversation"]
    assert used.window.inspector.place == ("situation", "situation")


def test_the_outline_is_filtered(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_O, CONTROL | SHIFT)
    used.type("name")
    rows = used.window.outline.list.model()
    assert {"show names", "names"} <= {rows.index(r, 0).data() for r in range(rows.rowCount())}
    assert "intro" not in {rows.index(r, 0).data() for r in range(rows.rowCount())}
