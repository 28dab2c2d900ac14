"""Places and changes: pure functions on documents."""

from __future__ import annotations

import pytest

from situ.document import codec, folder
from situ.document.check import check
from situ.document.condition import Condition, Group
from situ.document.condition import Test as Check
from situ.document.rbd import Application, Button, Event, Screen, Speech, State, Timeout
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ.resources import example
from situ_studio import kinds
from situ_studio.commands.insert import NotHere, insert
from situ_studio.edits import changes, places, words


@pytest.fixture
def application() -> Application:
    return Application(
        name="small",
        start="1",
        states=(
            State(
                no="1",
                name="start",
                timeout=Timeout(30, next="2"),
                screen=Screen(
                    components=(Button(id="ok", x=0, y=0, width=10, height=10, event="clickOk"),)
                ),
                actions=(Speech(text="hello"),),
                events=(
                    Event(name="a", next="2"),
                    Event(name="b", when=Condition((Check("x", "is", "1"),))),
                ),
            ),
            State(no="2", name="end", events=(Event(name="back", next="1"),)),
        ),
    )


@pytest.fixture
def script() -> Spds:
    return Spds(
        name="small",
        observe=(Observed("hand.waving"),),
        modules=(Declaration("nod", ("head",)), Declaration("talk", ("speech",))),
        situations=(
            Situation(
                "waving",
                extends="always",
                condition=Condition(
                    (Group("any", (Check("hand.waving", "is", "true"),)), Check("x", "is", "1"))
                ),
                entries=(Entry("nod", 5),),
            ),
            Situation("always", entries=(Entry("talk", 3), Entry("nod", 1))),
        ),
    )


def test_a_place_leads_to_its_value(application: Application) -> None:
    state = application.states[0]
    assert places.get(application, ()) is application
    assert places.get(application, ("state", "1")) is state
    assert places.get(application, ("state", "1", "event", "1")) is state.events[1]
    assert places.get(application, ("state", "1", "timeout")) is state.timeout
    assert places.get(application, ("state", "1", "screen", "ok")).event == "clickOk"
    assert places.get(application, ("state", "1", "event", "1", "when", "0")).tag == "x"
    for nowhere in (("state", "9"), ("state", "1", "event", "7"), ("x",), ("state",)):
        assert places.get(application, nowhere) is None


def test_the_nearest_place_is_the_longest_that_is_there() -> None:
    document = Application(name="a", states=(State(no="1"),))
    assert places.nearest(document, ("state", "1", "event", "4")) == ("state", "1")
    assert places.nearest(document, ("state", "9")) == ()


def test_a_change_keeps_everything_off_its_way(application: Application) -> None:
    place = ("state", "1", "event", "0")
    after = places.change(application, place, name="c")
    assert isinstance(after, Application)
    assert after.states[0].events[0].name == "c"
    assert after.states[1] is application.states[1]
    assert after.states[0].screen is application.states[0].screen


def test_nothing_takes_a_member_or_an_optional_value_away(application: Application) -> None:
    after = places.put(application, ("state", "1", "event", "0"), None)
    after = places.put(after, ("state", "1", "timeout"), None)
    state = places.get(after, ("state", "1"))
    assert [e.name for e in state.events] == ["b"]
    assert state.timeout is None


def test_a_new_number_is_followed_everywhere(application: Application) -> None:
    after, place = changes.set_field(application, ("state", "2"), "no", "end")
    assert place == ("state", "end")
    assert isinstance(after, Application)
    start = after.states[0]
    assert start.timeout is not None
    assert (start.timeout.next, start.events[0].next) == ("end", "end")
    after, _ = changes.set_field(after, ("state", "1"), "no", "0")
    assert isinstance(after, Application)
    assert after.start == "0"


def test_a_name_that_is_taken_is_refused(application: Application, script: Spds) -> None:
    with pytest.raises(ValueError, match="2 is taken already"):
        changes.set_field(application, ("state", "1"), "no", "2")
    with pytest.raises(ValueError, match="always is taken already"):
        changes.set_field(script, ("situation", "waving"), "name", "always")


def test_names_of_a_script_are_followed_everywhere(script: Spds) -> None:
    after, _ = changes.set_field(script, ("situation", "always"), "name", "usual")
    after, _ = changes.set_field(after, ("module", "nod"), "name", "bow")
    after, place = changes.set_field(after, ("data", "hand.waving"), "tag", "hand.up")
    assert place == ("data", "hand.up")
    assert isinstance(after, Spds)
    assert after.situations[0].extends == "usual"
    assert [e.module for s in after.situations for e in s.entries] == ["bow", "talk", "bow"]
    assert places.get(after, ("situation", "waving", "condition", "0", "0")).tag == "hand.up"


def test_a_removed_state_takes_what_led_to_it(application: Application) -> None:
    after = changes.remove(application, (("state", "2"), ("state", "1", "action", "0")))
    assert isinstance(after, Application)
    (state,) = after.states
    assert [e.name for e in state.events] == ["b"]
    assert state.timeout is None
    assert state.actions == ()


def test_the_start_falls_to_the_first_state_left(application: Application) -> None:
    after = changes.remove(application, (("state", "1"),))
    assert isinstance(after, Application)
    assert after.start_no == "2"


@pytest.mark.parametrize(
    "kind", [*kinds.ACTIONS, *kinds.COMPONENTS, kinds.EVENT], ids=lambda k: k.name
)
def test_what_is_inserted_into_a_state_can_be_found_and_saved(kind: kinds.Kind) -> None:
    if kind is kinds.REPEAT:
        return
    document = Application(name="a", states=(State(no="1"),))
    after, place, text = insert(document, kind, ("state", "1"))
    assert isinstance(places.get(after, place), kind.value)
    assert text == f"Add {kind.title.lower()} to state 1"
    read, problems = codec.read(codec.write(after), "a.rbd.xml")
    assert read == after
    assert problems == []


def test_an_action_needs_a_state(application: Application) -> None:
    with pytest.raises(NotHere, match="Select a state first"):
        insert(application, kinds.SPEECH, ())


def test_an_event_takes_only_what_uses_no_resource(application: Application) -> None:
    event = ("state", "1", "event", "0")
    _, place, _ = insert(application, kinds.SET, event)
    assert place == (*event, "action", "0")
    _, place, _ = insert(application, kinds.SPEECH, event)
    assert place == ("state", "1", "action", "1")


def test_a_new_situation_stands_before_the_last(script: Spds) -> None:
    after, place, _ = insert(script, kinds.SITUATION, ())
    assert isinstance(after, Spds)
    assert [s.name for s in after.situations] == ["waving", place[1], "always"]
    assert after.situations[1].condition is not None
    _, place, _ = insert(script, kinds.CONDITION, ("situation", "waving"))
    assert place == ("situation", "waving", "condition", "2")


def test_places_are_said_in_words(application: Application, script: Spds) -> None:
    said = words.place_words
    assert said(application, ("state", "1", "event", "0")) == "event a of state 1"
    assert said(application, ("state", "1", "action", "0")) == "speech of state 1"
    assert said(application, ("state", "1", "screen", "ok")) == "button ok of state 1"
    assert said(application, ("state", "1", "screen")) == "the screen of state 1"
    assert said(script, ("situation", "waving")) == "situation waving"


def test_a_situation_is_said_in_words(script: Spds) -> None:
    said = words.situation_words(script, script.situations[0])
    assert said.startswith("This holds while hand.waving is true and x is 1.")
    assert "It goes before all others." in said
    assert "nod and talk may move the robot" in said


def test_a_situation_is_said_in_whole_sentences() -> None:
    """What ends it is told, each test has its verb, and one mover stands in no order."""
    hot = Condition((Check("heat", "above", "30"), Check("heat", "atmost", "40")))
    script = Spds(
        name="ward",
        modules=(Declaration("nod", ("head",)),),
        situations=(
            Situation(
                "hot",
                condition=hot,
                until=Condition((Check("door", "is", "true"),)),
                entries=(Entry("nod", 1),),
            ),
            Situation("always"),
        ),
    )
    assert words.situation_words(script, script.situations[0]) == (
        "This holds while heat is above 30 and heat is at most 40. "
        "Once current it stays until door is true. It goes before all others. "
        "nod may move the robot."
    )


def test_every_problem_of_a_broken_example_has_a_place_that_is_there() -> None:
    project, _ = folder.load(example("reception"))
    assert project is not None
    file, document = next(iter(project.applications.items()))
    for state in document.states:
        for index, event in enumerate(state.events):
            place = ("state", state.no, "event", str(index))
            broken = places.change(document, place, next="nowhere")
            changed = project.__class__(
                root=project.root,
                name="x",
                applications={file: broken},
            )
            found = [p for p in check(changed) if p.code == "unknown-state"] or check(changed)
            assert any(places.get(broken, p.place) is not None and p.place for p in found), event
