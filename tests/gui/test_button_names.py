"""A new button is called after its words, so that the drawing says what a person reads on it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt

from situ.document import rbd
from situ_studio import kinds
from situ_studio.edits import places
from situ_studio.edits.changes import set_field
from situ_studio.edits.edit import Place

PLACE: Place = ("state", "1", "screen", "button1")
NEW = kinds.BUTTON.make("button1")


def state(*components: rbd.Component, events: tuple[rbd.Event, ...] = ()) -> rbd.State:
    return rbd.State(no="1", name="", screen=rbd.Screen(components=components), events=events)


def written(application: rbd.Application, words: str) -> tuple[str, str | None]:
    """The button's id and event, when these words have been written on it."""
    after, place = set_field(application, PLACE, "text", words)
    button = places.get(after, place)
    assert button.text == words
    return button.id, button.event


@pytest.mark.parametrize(
    ("words", "id"),
    [
        ("START", "start"),
        ("Call the nurse", "callTheNurse"),
        ("Please do not touch this", "pleaseDoNot"),
        ("Don't know", "dontKnow"),
        ("SPO2", "spo2"),
        ("はじめる", "はじめる"),
    ],
)
def test_a_new_button_is_called_after_its_words(words: str, id: str) -> None:
    event = f"click{id[0].upper()}{id[1:]}"
    assert written(rbd.Application(name="", states=(state(NEW),)), words) == (id, event)


@pytest.mark.parametrize("words", ["", "→", "{user.name}", "1"])
def test_words_that_make_no_name_leave_the_one_it_has(words: str) -> None:
    assert written(rbd.Application(name="", states=(state(NEW),)), words) == (
        "button1",
        "clickButton1",
    )


def test_a_button_whose_event_is_expected_keeps_its_name() -> None:
    expects = (rbd.Event(name="clickButton1"),)
    here = rbd.Application(name="", states=(state(NEW, events=expects),))
    everywhere = rbd.Application(name="", always=rbd.Always(events=expects), states=(state(NEW),))
    for application in (here, everywhere):
        assert written(application, "START") == ("button1", "clickButton1")


@pytest.mark.parametrize("own", [{"event": "goOn"}, {"event": None}])
def test_an_event_that_a_person_chose_stays(own: dict[str, Any]) -> None:
    application = rbd.Application(name="", states=(state(replace(NEW, **own)),))
    assert written(application, "START") == ("button1", own["event"])


def test_a_name_that_is_taken_where_it_is_shown_is_not_given_twice() -> None:
    start = replace(NEW, id="start", event="clickGo")
    go = replace(NEW, id="go", event="clickStart")
    always = rbd.Always(screen=rbd.Screen(components=(start,)))
    for application in (
        rbd.Application(name="", states=(state(NEW, start),)),
        rbd.Application(name="", states=(state(NEW, go),)),
        rbd.Application(name="", always=always, states=(state(NEW),)),
    ):
        assert written(application, "START") == ("button1", "clickButton1")


def test_in_every_state_no_state_may_have_the_name() -> None:
    always = rbd.Always(screen=rbd.Screen(components=(NEW,)))
    home = replace(NEW, id="home", event="clickHome")
    application = rbd.Application(name="", always=always, states=(state(home),))
    after, place = set_field(application, ("always", "screen", "button1"), "text", "Home")
    assert place[-1] == "button1"
    after, place = set_field(application, ("always", "screen", "button1"), "text", "Back")
    assert place[-1] == "back"
    assert places.get(after, place).event == "clickBack"


def test_what_is_written_on_the_screen_names_it_and_it_stays_selected(
    studio: Callable[..., Any], project: Callable[[str], Path]
) -> None:
    used = studio(project("reception"))
    window = used.window
    window.open_file("reception.rbd.xml")
    window.show_mode("screen")
    used.select("state", "9")
    window.commands.insert("button")
    used.settle()
    (place,) = window.current_view.selected
    assert place == ("state", "9", "screen", "button1")
    sheet = window.current_view.piece("designer").shown.sheet
    assert sheet.writing.begin("button1")
    used.type("Next step")
    used.key(Qt.Key.Key_Return)
    assert window.current_view.selected == (("state", "9", "screen", "nextStep"),)
    assert places.get(window.current_document, (*place[:-1], "nextStep")).event == "clickNextStep"
    used.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert places.get(window.current_document, place).text == "OK"
