"""Copies: within a document, to others, between projects and views."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication

from situ.document import codec, drawing, folder, rbd
from situ.document.aside import NOTHING
from situ.document.drawing import Note
from situ.document.rbd import Application, Event, State, Timeout
from situ.resources import example
from situ_studio.canvas import gestures
from situ_studio.copying import copies

CONTROL = Qt.KeyboardModifier.ControlModifier

Studio = Any
Start = Callable[..., Studio]
Copy = Callable[[str], Path]


def at(x: float, y: float) -> Any:
    return NOTHING.at(x, y)


SMALL = Application(
    name="small",
    states=(
        State(
            no="1",
            name="one",
            timeout=Timeout(seconds=30, next="1"),
            events=(Event(name="go", next="2"), Event(name="far", next="3"), Event(next="3")),
            aside=at(0, 0),
        ),
        State(no="2", name="two", events=(Event(name="back", next="1"),), aside=at(230, 0)),
        State(no="3", name="three", events=(Event(name="again", next="#again"),), aside=at(0, 228)),
    ),
)
BOTH = (("state", "1"), ("state", "2"))


def nexts(application: Application, no: str) -> list[str | None]:
    state = application.state(no)
    assert state is not None
    return [e.next for e in state.events]


def test_duplicates_lead_to_each_other_and_where_the_originals_do() -> None:
    after, text, made = copies.duplicate(SMALL, BOTH)
    assert text == "Duplicate 2 states"
    assert made == (("state", "4"), ("state", "5"))
    assert nexts(after, "4") == ["5", "3", "3"]
    assert nexts(after, "5") == ["4"]
    assert after.states[3].timeout == Timeout(seconds=30, next="4")
    assert after.states[3].aside.position == (32.0, 32.0)
    assert after.states[:3] == SMALL.states
    assert after.start_no == "1"


def test_a_paste_elsewhere_leads_to_nothing_that_only_has_the_number() -> None:
    other = Application(name="other", states=(State(no="3", name="another three"),))
    after, text, made = copies.paste(other, copies.fragment(SMALL, BOTH), (100, 50))
    assert text == "Paste 2 states"
    assert made == (("state", "4"), ("state", "5"))
    # The event that led to 3 waits for another target; the unnamed one would be an error.
    assert nexts(after, "4") == ["5", None]
    assert [s.aside.position for s in after.states[1:]] == [(100, 50), (330, 50)]


def test_what_was_cut_keeps_its_numbers_and_place() -> None:
    copied = copies.fragment(SMALL, BOTH)
    left, _ = gestures.delete(SMALL, BOTH)
    after, _, made = copies.paste(left, copied, copies.corner(copied), same=True)
    assert made == BOTH
    assert nexts(after, "1") == ["2", "3", "3"]
    assert [s.aside.position for s in after.states[1:]] == [(0, 0), (230, 0)]


def test_notes_and_frames_are_copied_with_the_states_and_alone() -> None:
    noted = drawing.add(SMALL, Note(x=500, y=40, width=100, height=60, text="mind the gap"))
    copied = copies.fragment(noted, (("state", "2"), ("note", "0")))
    assert copies.counted(copied) == "2 things"
    after, _, made = copies.paste(noted, copied, (0, 1000), same=True)
    assert made == (("state", "4"), ("note", "1"))
    assert [(n.x, n.y) for n in drawing.drawn(after)] == [(500, 40), (270, 1040)]
    only = copies.fragment(noted, (("note", "0"),))
    assert copies.counted(only) == "1 note"
    after, text, made = copies.duplicate(noted, (("note", "0"),))
    assert (text, made) == ("Duplicate a note", (("note", "1"),))


def test_a_note_that_stands_before_a_state_in_the_file_is_not_copied_with_it() -> None:
    data = codec.write(drawing.add(SMALL, Note(x=1, y=2, width=100, height=60, text="hello")))
    read, _ = codec.read(data, "small")
    assert isinstance(read, Application)
    for state in read.states:
        assert drawing.drawn(copies.fragment(read, (("state", state.no),))) == ()


@settings(max_examples=20, deadline=None)
@given(st.data())
def test_any_states_of_an_example_go_by_text_into_another_and_are_the_same(
    data: st.DataObject,
) -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    whole = project.applications["reception.rbd.xml"]
    numbers = data.draw(st.lists(st.sampled_from([s.no for s in whole.states]), min_size=1))
    chosen = [("state", no) for no in dict.fromkeys(numbers)]
    copied, problems = codec.read(codec.write(copies.fragment(whole, chosen)), "clipboard")
    assert isinstance(copied, Application)
    assert [p for p in problems if p.severity == "error"] == []
    after, _, made = copies.paste(Application(name="x"), copied, (0, 0))
    new = {old.no: place[1] for old, place in zip(copied.states, made, strict=True)}
    for old, pasted in zip(copied.states, after.states, strict=True):
        assert pasted.no == new[old.no]
        blank: dict[str, Any] = {"no": "", "events": (), "timeout": None}
        assert replace(pasted, **blank) == replace(old, **blank)
        for event in pasted.events:
            assert event.next is None or event.next.startswith("#") or event.next in new.values()


# -- in the window -----------------------------------------------------------------------


def test_a_cut_and_a_paste_by_keys_leave_the_states_where_they_were(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    before = used.session.document("reception.rbd.xml")
    used.select("state", "13")
    used.key(Qt.Key.Key_X, CONTROL)
    assert used.session.document("reception.rbd.xml").state("13") is None
    assert used.session.undo_text == "Cut state 13"
    used.key(Qt.Key.Key_V, CONTROL)
    after = used.session.document("reception.rbd.xml")
    assert after.state("13") == before.state("13")
    assert after.state("13").aside.position == before.state("13").aside.position
    assert used.session.undo_text == "Paste state 13"
    assert used.window.current_view.selected == (("state", "13"),)
    used.key(Qt.Key.Key_Z, CONTROL)
    used.key(Qt.Key.Key_Z, CONTROL)
    assert used.session.document("reception.rbd.xml") is before


def test_states_go_to_another_document_of_the_project(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.select("state", "3")
    used.key(Qt.Key.Key_C, CONTROL)
    assert used.window.status.said.text() == "1 state copied"
    used.window.open_file("register.rbd.xml")
    used.settle()
    used.window.current_view.current_view().setFocus()
    used.key(Qt.Key.Key_V, CONTROL)
    register = used.session.document("register.rbd.xml")
    ((_, no),) = used.window.current_view.selected
    assert register.state(no).name == "enter initial 1"
    assert all(e.next is None for e in register.state(no).events)


def test_what_another_project_lacks_is_said_in_one_line(
    studio: Start, project: Copy, tmp_path: Path
) -> None:
    source = studio(project("reception"))
    source.window.current_view.canvas.select([("state", "16"), ("state", "2")])
    source.key(Qt.Key.Key_C, CONTROL)
    source.window.close()
    target = studio(project("conversation"))
    target.window.current_view.current_view().setFocus()
    target.key(Qt.Key.Key_V, CONTROL)
    names = {p[1] for p in target.window.current_view.selected}
    pasted = target.session.document("converse.rbd.xml")
    assert {pasted.state(no).name for no in names} == {"register", "intro"}
    said = target.window.status.said.text()
    assert said.startswith("Pasted. This project does not have ")
    assert "register.rbd.xml" in said
    assert "chime.wav" in said or ".png" in said or ".svg" in said


def test_the_outline_copies_and_pastes_too(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.show_mode("outline")
    used.select("state", "3")
    used.window.current_view.twin.tree.setFocus()
    used.key(Qt.Key.Key_C, CONTROL)
    used.key(Qt.Key.Key_V, CONTROL)
    after = used.session.document("reception.rbd.xml")
    ((_, no),) = used.window.current_view.selected
    assert after.state(no).name == "enter initial 1"
    assert [e.next for e in after.state(no).events] == [e.next for e in after.state("3").events]
    used.key(Qt.Key.Key_D, CONTROL)
    assert len(used.session.document("reception.rbd.xml").states) == len(after.states) + 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "There are no states on the clipboard"),
        ("hello", "There are no states on the clipboard"),
        ("<spds name='x'/>", "There are no states on the clipboard"),
        ("<application name='x'><state name='no number'/></application>", "has errors"),
    ],
)
def test_junk_is_refused_in_one_line(studio: Start, project: Copy, text: str, said: str) -> None:
    used = studio(project("reception"))
    QGuiApplication.clipboard().setText(text)
    used.window.current_view.current_view().setFocus()
    used.key(Qt.Key.Key_V, CONTROL)
    assert used.session.undo_text is None
    assert said in used.window.status.said.text()
    assert "\n" not in used.window.status.said.text()


def test_text_that_is_an_application_is_pasted(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    text = codec.write(Application(name="x", states=(rbd.State(no="9", name="typed"),))).decode()
    QGuiApplication.clipboard().setText(text)
    used.window.current_view.current_view().setFocus()
    used.key(Qt.Key.Key_V, CONTROL)
    ((_, no),) = used.window.current_view.selected
    assert used.session.document("reception.rbd.xml").state(no).name == "typed"
