"""A state whose name says no more than its number is told once, wherever states are told."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtWidgets import QApplication

from situ.document.project import Project
from situ.document.rbd import Application, Event, Screen, State, Text
from situ.document.ready import load_ready
from situ_studio.canvas import gestures
from situ_studio.canvas.projection import Projector
from situ_studio.edits import words
from situ_studio.edits.mentions import Found, mentions
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.finding import find
from situ_studio.finding.search import search
from situ_studio.live.breakpoints import Breakpoints
from situ_studio.looks.theme import LIGHT
from situ_studio.panels.field_making import next_choices

FILE = "talk.rbd.xml"


@pytest.fixture
def talk() -> Application:
    text = Text(id="t", x=1, y=1, width=50, height=9, text="Hello there")
    return Application(
        "talk",
        states=(
            State("1", name="greet", events=(Event("go", next="2"),)),
            State("2", name="state 2", screen=Screen(components=(text,))),
            State("3"),
        ),
    )


def test_it_is_called_state_and_its_number(talk: Application) -> None:
    called = [words.state_words(talk, state.no) for state in talk.states]
    assert called == ["1 greet", "state 2", "state 3"]
    assert words.leads_to(talk, "2") == "state 2"
    hints = [card.hint().split("\n")[0] for card in Projector().picture(talk).cards.values()]
    assert hints == called
    assert [row[3] for row in find.places_of(talk) if len(row[0]) == 2] == called


def test_what_was_done_to_it_names_it_so(talk: Application) -> None:
    _, text = gestures.lead(talk, ("state", "1"), "0", "3")
    assert text == "Lead go of state 1 to state 3"


def test_it_is_found_by_its_number_and_by_the_word(talk: Application) -> None:
    found = [Found(FILE, mention) for mention in mentions(talk)]
    hits = search({FILE: talk}, found, "state 2").hits
    assert ("state 2", "state 2") in [(hit.text, hit.where) for hit in hits]
    (hit,) = search({FILE: talk}, found, "hello").hits
    assert hit.where.startswith("state 2, text t")


def test_what_is_chosen_to_lead_to_says_the_number_alone(talk: Application) -> None:
    states = tuple((state.no, state.name) for state in talk.states)
    known = dict(next_choices(Vocabulary(states=states), "stays"))
    assert (known["1"], known["2"], known["3"]) == ("1 greet", "2", "3")


def test_breakpoints_and_traces_name_it_so(
    qt: QApplication, project: Callable[[str], Path], talk: Application
) -> None:
    whole = Project(root="", name="talk", applications={FILE: talk})
    assert words.running_state(whole, "talk", "2") == "state 2"
    assert words.running_state(whole, "talk", "1") == "1 greet"
    assert words.running_state(None, "talk", "1") == "state 1"
    panel = Breakpoints(LIGHT, lambda name, no: words.running_state(whole, name, no))
    told = {
        "in state 2": {"state": "2"},
        "in 1 greet": {"state": "1"},
        "before it leaves state 2": {"from": "2"},
        "between 1 greet and state 3": {"from": "1", "to": "3"},
    }
    for said, point in told.items():
        assert panel._where({"application": "talk", **point}) == said
    panel.deleteLater()
    # Of a state in a part it is the inner one's name.
    reception = load_ready(project("reception"))
    part = reception.parts["register.rbd.xml"]
    inner = replace(part.states[1], name=f"state {part.states[1].no}")
    part = replace(part, states=(part.states[0], inner, *part.states[2:]))
    reception = replace(reception, parts={**reception.parts, "register.rbd.xml": part})
    no = f"16/{inner.no}"
    assert words.running_state(reception, "reception", no) == f"state {no}"


def test_the_designer_names_it_so_above_and_in_the_strip(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    used = studio(project("reception"))
    window, document = used.window, used.session.document("reception.rbd.xml")
    window.commit(*gestures.rename(document, "5", "state 5"))
    window.current_view.select([("state", "5")])
    used.click(window.tabs.views.button("screen"))
    designer = window.current_view.piece("designer")
    assert designer.crumbs.button("state 5").isVisible()
    model = designer.strip.model()
    shown = {model.index(row).data() for row in range(model.rowCount())}
    assert {"state 5", "4 enter initial 2"} <= shown
