"""Find in the project, find usages, and another name everywhere."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt

from situ.document import rbd
from situ_studio.edits.mentions import Found, mentions
from situ_studio.finding.search import search
from situ_studio.panels.lists import PLACE

CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def rows(used: Studio) -> list[tuple[str, str]]:
    """Text and place of every row of the panel."""
    model = used.window.finding.panel.list.model()
    indices = [model.index(row, 0) for row in range(model.rowCount())]
    return [(i.data(PLACE).text, i.data(PLACE).where) for i in indices]


def test_a_text_is_found_in_every_document_and_enter_goes_there(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("touch your name")
    assert any("speech" in where and "state 8 names" in where for _, where in rows(used))
    used.key(Qt.Key.Key_Return)
    assert used.window.current_view.selected[0][:2] == ("state", "8")
    files = set()
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("clickConfirm")
    for _, where in rows(used):
        files.add(where.partition(":")[0])
    assert files == {"reception", "register"}


def test_f3_goes_from_place_to_place_round_the_end(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("clickConfirm")
    count = len(rows(used))
    assert used.window.finding.panel.count.text() == f"{count} places"
    seen = []
    used.key(Qt.Key.Key_Return)
    for _ in range(count):
        seen.append((used.window.current_file, used.window.current_view.selected))
        used.key(Qt.Key.Key_F3)
    assert (used.window.current_file, used.window.current_view.selected) == seen[0]
    assert {file for file, _ in seen} == {"reception.rbd.xml", "register.rbd.xml"}
    used.key(Qt.Key.Key_F3, SHIFT)
    assert (used.window.current_file, used.window.current_view.selected) == seen[-1]


def test_what_is_found_follows_an_edit(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("marmalade")
    assert rows(used) == []
    assert used.window.finding.panel.count.text() == "Nothing in this project has that."
    used.select("state", "2")
    used.fill(used.window.inspector.form.field("name"), "marmalade")
    assert [text for text, _ in rows(used)] == ["2 marmalade"]


def test_of_very_many_places_the_first_are_shown_and_all_are_counted() -> None:
    every = tuple(rbd.State(no=str(n), name=f"ward {n}") for n in range(1, 1001))
    application = rbd.Application(name="large", states=every)
    found = (Found("a.rbd.xml", m) for m in mentions(application))
    hits = search({"a.rbd.xml": application}, found, "ward", most=20)
    assert hits.count == 1000
    assert [h.text for h in hits.hits[:2]] == ["1 ward 1", "2 ward 2"]
    assert len(hits.hits) == 20


def test_escape_goes_back_to_the_drawing(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    used.key(Qt.Key.Key_F, CONTROL)
    assert used.window.finding.panel.field.hasFocus()
    used.key(Qt.Key.Key_Escape)
    assert used.window.current_view.canvas.viewer.hasFocus()


def test_usages_of_an_event_are_where_it_is_raised_and_expected(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    used.select("state", "8", "screen", "names")
    used.key(Qt.Key.Key_F, CONTROL | SHIFT)
    used.type("userNameSelected")
    used.key(Qt.Key.Key_Return)
    assert used.window.finding.panel.query == "event: userNameSelected"
    assert rows(used) == [
        ("userNameSelected", "reception: state 8 names, list names: sends"),
        ("userNameSelected", "reception: state 8 names, event userNameSelected"),
    ]


def test_the_inspector_finds_usages_too(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    assert not used.window.inspector.usages.isVisible()
    used.select("state", "8", "event", "0")
    used.click(used.window.inspector.usages)
    used.type("state: 9")
    used.key(Qt.Key.Key_Return)
    assert used.window.finding.panel.query == "state: 9"
    assert ("9 save profile", "reception: state 9 save profile") in rows(used)


def test_usages_of_a_state_are_those_of_its_document(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "2")
    used.key(Qt.Key.Key_F, CONTROL | SHIFT)
    assert used.window.finding.panel.query == "state: 2"
    assert {where.partition(":")[0] for _, where in rows(used)} == {"reception"}
    assert rows(used)[-1][0] == "2 intro" or ("2 intro", "reception: state 2 intro") in rows(used)


def test_an_event_is_renamed_in_every_document_as_one_step(studio: Start, project: Copy) -> None:
    folder = project("reception")
    used = studio(folder)
    before = {f: used.session.document(f) for f in used.session.files}
    used.select("state", "3", "screen", "confirm")
    used.answers.put("name", "clickFine")
    used.key(Qt.Key.Key_F2, SHIFT)
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("event: clickConfirm")
    assert rows(used) == []
    assert used.session.undo_text == "Rename event clickConfirm to clickFine"
    assert set(used.session.dirty) == {"reception.rbd.xml", "register.rbd.xml"}
    said = used.window.status.said.text()
    assert "places follow." in said
    assert "scenarios/new-user.jsonl" in said
    used.window.actions_.actions["undo"].trigger()
    assert all(used.session.document(f) is before[f] for f in before)
    assert used.session.undo_text is None


def test_a_name_that_is_used_already_is_refused_in_one_line(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "8", "event", "0")
    name = used.session.document("reception.rbd.xml").state("8").events[0].name
    assert name != "clickYes"
    used.answers.put("name", "clickYes")
    used.key(Qt.Key.Key_F2, SHIFT)
    assert used.session.undo_text is None
    said = used.window.status.said.text()
    assert said == "There is an event clickYes already: choose another name."


def test_what_a_note_says_is_found(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("nobody has these initials")
    ((text, where),) = rows(used)
    assert text.startswith("The way is the same when nobody has these initials")
    assert where == "reception: a note"
    used.key(Qt.Key.Key_Return)
    assert used.window.current_view.selected == (("note", "0"),)


NOTED = """<application name="ward" start="1">
  <!-- Drawn with the night nurses. -->
  <!-- Whoever waits here is tired. -->
  <state no="1" name="Hello">
    <screen><components>
      <!-- Large enough for cold fingers. -->
      <button id="go" x="10" y="10" width="30" height="20" event="go">Go</button>
      <!-- Nothing below this one. -->
    </components></screen>
    <expectedevents>
      <!-- Asked for by the night nurses. -->
      <event name="go" next="1"/>
    </expectedevents>
  </state>
  <ed:frame xmlns:ed="urn:situ:editor" title="Night rounds"
            x="2000" y="1500" width="400" height="200"/>
  <!-- The end of the night. -->
</application>
"""
SITUATION = """<spds name="ward">
  <modules><module name="ward" resources="screen"/></modules>
  <!-- Nobody at night but the nurses. -->
  <situation name="all"><module name="ward" priority="1"/></situation>
</spds>
"""


def test_frames_and_what_is_noted_on_anything_are_found_and_shown(
    studio: Start, tmp_path: Path
) -> None:
    (tmp_path / "situ.toml").write_text(
        '[project]\nname = "ward"\napplications = ["ward.rbd.xml"]\nspds = "ward.spds.xml"\n'
        '[robot]\nadapter = "sim"\n'
    )
    (tmp_path / "ward.rbd.xml").write_text(NOTED)
    (tmp_path / "ward.spds.xml").write_text(SITUATION)
    used = studio(tmp_path)
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("night")
    assert rows(used) == [
        ("The end of the night.", "ward: note"),
        (
            "Drawn with the night nurses. Whoever waits here is tired.",
            "ward: state 1 Hello: note",
        ),
        ("Asked for by the night nurses.", "ward: state 1 Hello, event go: note"),
        ("Night rounds", "ward: the frame Night rounds: title"),
        ("Nobody at night but the nurses.", "ward: situation all: note"),
    ]
    for text, selected in (
        ("night nurses. asked", ("state", "1", "event", "0")),
        ("night rounds", ("frame", "0")),
        ("nobody night", ("situation", "all")),
        ("tired", ("state", "1")),
        ("cold fingers", ("state", "1", "screen", "go")),
        ("nothing below", ("state", "1", "screen")),
    ):
        used.fill(used.window.finding.panel.field, text)
        assert used.window.current_view.selected == (selected,), text
        if selected[0] == "frame":
            # It lies far from all else, and is seen now.
            canvas = used.window.current_view.canvas
            seen = canvas.viewer.mapToScene(canvas.viewer.viewport().rect()).boundingRect()
            assert seen.contains(2200, 1600)
    # What is written on a thing now is found at once.
    used.window.fill_in(("state", "1"), "note")
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("Rested by now")
    used.key(Qt.Key.Key_Tab)
    used.key(Qt.Key.Key_F, CONTROL)
    used.type("rested")
    assert rows(used) == [("Rested by now", "ward: state 1 Hello: note")]
