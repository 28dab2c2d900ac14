"""What cards show of their states, and that what did not change is the same value."""

from __future__ import annotations

from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import words
from situ.document.aside import NOTHING
from situ.document.condition import Condition, Group
from situ.document.condition import Test as Question
from situ.document.problem import Problem
from situ.document.rbd import Always, Application, Event, Say, Service, State
from situ_studio import kinds
from situ_studio.canvas.picture import ALWAYS, NEW, exit_of, place_of
from situ_studio.canvas.projection import Projector


def test_a_card_shows_its_state(small: Application) -> None:
    cards = Projector().picture(small).cards
    start = cards["1"]
    assert (start.kind, start.no, start.name) == ("start", "1", "start")
    assert (start.line, start.line_icon) == ("Touch me to begin", "speech")
    assert [e.label for e in start.exits] == ["touched", "human", "30 s"]
    assert start.exits[1].phrase == "hello"
    assert cards["2"].icons == ("speech", "service", "robot")
    assert cards["2"].exits[0].guard == "patients.0 exists"
    assert cards["5"].kind == "end"
    assert cards["always "].kind == "always"


def test_always_is_chips_on_every_card_but_those_that_leave_it_out(small: Application) -> None:
    cards = Projector().picture(small).cards
    assert all(c.chips == ("Home",) for c in cards.values() if c.kind != "always")
    without = replace(small, states=(replace(small.states[0], always=False), *small.states[1:]))
    assert Projector().picture(without).cards["1"].chips == ()


def test_pipes_are_what_leads_to_a_state_that_is_there(small: Application) -> None:
    links = Projector().picture(small).links
    assert ("1", "0", "2") in links
    assert ("1", "timeout", "1") in links
    assert ("always ", "0", "1") in links
    assert not [i for i in links if i[0] == "3" and i[1] in ("2", "3")]
    names = Projector().picture(small).cards["3"]
    assert [(e.short, e.missing) for e in names.exits[2:]] == [("#again", False), ("17", True)]


def test_a_card_is_the_same_value_while_nothing_on_it_changed(small: Application) -> None:
    projector = Projector()
    before = projector.picture(small).cards
    renamed = replace(small.states[1], name="other")
    after = projector.picture(replace(small, states=(small.states[0], renamed, *small.states[2:])))
    assert [u for u in before if after.cards[u] is not before[u]] == ["2"]
    added = replace(small, states=(*small.states, State(no="17")))
    again = projector.picture(added).cards
    # State 3 led to 17, which is there now.
    assert {u for u in before if again[u] != before[u]} == {"3"}


def test_a_problem_marks_its_card_and_errors_outweigh_warnings(small: Application) -> None:
    error = Problem(file="f", code="e", message="m", place=("state", "2", "event", "0"))
    warning = Problem(file="f", severity="warning", code="w", message="m", place=("state", "2"))
    for order in ([error, warning], [warning, error]):
        assert Projector().picture(small, order).cards["2"].mark == "error"


def test_a_problem_of_an_exit_stands_at_that_exit_in_words(small: Application) -> None:
    place = ("state", "2")
    found = [
        Problem(
            file="f", severity="warning", code="w", message="Odd.", place=(*place, "event", "0")
        ),
        Problem(file="f", code="e", message="No.", place=(*place, "event", "0", "action", "1")),
        Problem(file="f", severity="warning", code="s", message="Dull.", place=place),
    ]
    projector = Projector()
    before = projector.picture(small).cards
    cards = projector.picture(small, found).cards
    card = cards["2"]
    assert (card.mark, card.exits[0].mark.sign) == ("error", "error")
    assert card.hint(card.exits[0].id).split("\n")[-2:] == ["No.", "Odd."]
    assert card.hint().split("\n")[-1] == "Dull."
    assert "with an error" in card.spoken()
    assert {exit.mark.sign for exit in card.exits[1:]} <= {""}
    # Others are the very same, and so is this one when the problem is gone.
    assert [uid for uid in cards if cards[uid] is not before[uid]] == ["2"]
    same = projector.picture(small, list(reversed(found))).cards
    assert same["2"] == card
    assert projector.picture(small).cards["2"] == before["2"]


def test_of_many_problems_a_tip_tells_the_first(small: Application) -> None:
    many = [Problem(file="f", code="e", message=f"{n}.", place=("state", "2")) for n in range(9)]
    card = Projector().picture(small, many).cards["2"]
    assert card.hint().split("\n")[-5:] == ["0.", "1.", "2.", "3.", "…"]


def test_places_and_exits_are_each_other_s_reverse(small: Application) -> None:
    cards = Projector().picture(small).cards
    for card in cards.values():
        assert exit_of(card.place) is None
        assert place_of(card.uid, NEW, card) == card.place
        for leaving in card.exits:
            assert exit_of(place_of(card.uid, leaving.id, card)) == leaving.id


def test_a_card_without_speech_says_what_it_does() -> None:
    states = (
        State(no="1", actions=(Service(name="find", url="http://x"),)),
        State(no="2", flow="part.rbd.xml"),
        State(no="3", name="", events=(Event(next="1", says=(Say("go"),)),)),
    )
    cards = Projector().picture(Application(name="a", states=states)).cards
    assert (cards["1"].line, cards["1"].line_icon) == ("find", "service")
    assert (cards["2"].kind, cards["2"].line) == ("part", "part.rbd.xml")
    assert cards["3"].name == "state 3"
    assert cards["3"].exits[0].label == "at once"


def test_conditions_in_words() -> None:
    both = Condition(
        (
            Question("a", "is", "true", within=5),
            Group("any", (Question("b", "below", "1.5"), Question("c", "exists", "false"))),
            Group("none", (Question("d", "in", '["x", "y"]', hold=0.5),)),
        )
    )
    assert words.condition(both) == (
        "a is true, within 5 s and (b below 1.5 or c is missing)"
        " and (none of: d is one of x, y, for 0.5 s)"
    )
    assert words.condition(Condition((Question("list", "isnot", "[]"),))) == "list is not [ ]"


def test_an_action_has_the_icon_on_its_card_that_it_has_in_the_palette() -> None:
    every = tuple(kind.make("") for kind in kinds.ACTIONS)
    made = Projector().picture(Application("a", states=(State("1", actions=every),)))
    assert made.cards["1"].icons == tuple(kind.icon for kind in kinds.ACTIONS)


NUMBERS = st.sampled_from(["1", "2", "3"])
STATES = st.builds(
    State,
    no=NUMBERS,
    name=st.sampled_from([None, "a"]),
    always=st.booleans(),
    events=st.lists(
        st.builds(Event, name=st.just("e"), next=st.none() | NUMBERS | st.just("9")), max_size=2
    ).map(tuple),
    aside=st.sampled_from([NOTHING, NOTHING.at(8, 16)]),
)
HOME = Always(events=(Event(name="home", next="1"), Event(name="up", next="2")))


@settings(max_examples=60, deadline=None)
@given(
    states=st.lists(STATES, min_size=3, max_size=5),
    moments=st.lists(
        st.tuples(
            st.lists(st.integers(0, 4), max_size=4),
            st.sampled_from([None, HOME, replace(HOME, events=HOME.events[:1])]),
            st.sampled_from([None, "1", "3"]),
            st.sampled_from([(), ("1",), ("2", "always")]),
            st.dictionaries(NUMBERS, st.just((4.0, 4.0)) | st.just((0.0, 8.0))),
        ),
        min_size=2,
        max_size=5,
    ),
)
def test_a_picture_is_the_same_whatever_was_shown_before(
    states: list[State], moments: list[tuple[Any, ...]]
) -> None:
    projector = Projector()
    for chosen, always, start, faulty, places in moments:
        document = Application(
            name="any",
            start=start,
            always=always,
            states=tuple(states[i % len(states)] for i in chosen),
        )
        problems = [
            Problem(file="f", code="c", message="m", place=(no,) if no == ALWAYS else ("state", no))
            for no in faulty
        ]
        assert projector.picture(document, problems, places) == Projector().picture(
            document, problems, places
        )
