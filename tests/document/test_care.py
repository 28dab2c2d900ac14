"""Care with what is said: what the lints must find, and what they must leave alone.

The other care lints stand in test_care_screen.py, test_care_people.py and test_care_script.py.
"""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.document.care_projects import (
    BUTTON,
    END,
    MORNING,
    TOUCHED,
    WIDE,
    always,
    app,
    mended,
    places,
    state,
    told,
    whole,
)

from situ.decide.trace import TraceEvent, to_fields
from situ.document.care_speech import literal
from situ.document.project import Project
from situ.document.spoken import estimate
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate

LATER = '<event name="timeout" next="2"><when><data tag="n" above="3"/></when></event>'

# -- a speech and its timeout ----------------------------------------------------


@pytest.mark.parametrize(
    ("timeout", "acts", "is_told"),
    [
        ('<timeout next="2">2.5</timeout>', MORNING, True),
        ('<timeout next="2">2.8</timeout>', MORNING, False),
        ('<timeout next="#again">2.5</timeout>', MORNING, True),
        # It stands still while the robot speaks.
        ('<timeout next="2" idle="true">2.5</timeout>', MORNING, False),
        # Two speeches queue; nothing said takes no time.
        ('<timeout next="2">5</timeout>', MORNING + MORNING, True),
        ('<timeout next="2">0.2</timeout>', "<speech>  </speech>", False),
        # A value may be of one letter, and a sound of no length.
        ('<timeout next="2">1.2</timeout>', "<speech>Hello {user.name}.</speech>", False),
        ('<timeout next="2">0.9</timeout>', "<speech>Hello {user.name}.</speech>", True),
        ('<timeout next="2">1</timeout>', '<sound src="http://a/b.ogg"/>', False),
        ('<timeout next="2">0.8</timeout>', "<speech>おはよう</speech>", True),
        ("", MORNING, False),
    ],
)
def test_a_speech_that_its_timeout_cuts_off_is_told(timeout: str, acts: str, is_told: bool) -> None:
    project = whole(state(acts=acts, rest=timeout) + END)
    assert bool(told(project, "speech-over-timeout")) is is_told


@pytest.mark.parametrize(
    ("events", "is_told"),
    [
        ("", False),
        ('<event name="timeout" next="2"/>', True),
        # It only counts, or may: the state is not surely left.
        ('<event name="timeout"><add tag="n">1</add></event>', False),
        (LATER, False),
        (LATER + '<event name="other"/><event name="timeout" next="#again"/>', True),
    ],
)
def test_a_timeout_that_raises_an_event_cuts_off_where_that_leaves(
    events: str, is_told: bool
) -> None:
    project = whole(state(acts=MORNING, events=events, rest="<timeout>1</timeout>") + END)
    assert bool(told(project, "speech-over-timeout")) is is_told


def test_the_timeout_of_always_cuts_off_too_and_its_mend_is_made_there() -> None:
    shared = always(rest='<timeout next="2">2</timeout>')
    project = whole(shared + state(acts=MORNING) + END)
    (problem,) = told(project, "speech-over-timeout")
    assert problem.place == ("state", "1", "action", "0")
    assert "the timeout of every state" in problem.message
    after = mended(project, problem)
    assert told(after, "speech-over-timeout") == []
    assert after.applications["a0.rbd.xml"].always.timeout.idle  # type: ignore[union-attr]
    apart = state(acts=MORNING, attributes='always="false"')
    assert told(whole(shared + apart + END), "speech-over-timeout") == []


def test_a_speech_is_as_long_as_in_the_language_that_takes_longest() -> None:
    one = app(
        state(acts="<speech>Good morning</speech>", rest='<timeout next="2">2</timeout>') + END
    )
    texts = {"de": {"Good morning": "Einen wunderschönen guten Morgen wünsche ich"}}
    assert told(whole(one), "speech-over-timeout") == []
    languages: dict[str, Any] = {"languages": ("en", "de"), "texts": texts}
    assert told(whole(one, **languages), "speech-over-timeout") != []
    fixed = app(
        state(acts='<speech lang="en">Good morning</speech>', rest='<timeout next="2">2</timeout>')
        + END
    )
    assert told(whole(fixed, **languages), "speech-over-timeout") == []


@pytest.mark.parametrize(
    ("rate", "is_told"), [(100, False), (50, True), ("slow", False), (True, False), (1, False)]
)
def test_a_slow_voice_takes_longer(rate: Any, is_told: bool) -> None:
    one = app(state(acts=MORNING, rest='<timeout next="2">3</timeout>') + END)
    project = whole(one, tags={"speech.rate": rate})
    assert bool(told(project, "speech-over-timeout")) is is_told


# -- repeating -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("screen", "acts", "events", "is_told"),
    [
        (BUTTON, MORNING, TOUCHED, True),
        ("", MORNING, '<event name="yes" next="2"><say>yes</say></event>', True),
        (BUTTON, MORNING, TOUCHED + '<event name="pardon"><repeat/></event>', False),
        (BUTTON, MORNING, TOUCHED + '<event name="pardon" next="#again"/>', False),
        (BUTTON, MORNING, TOUCHED + '<event name="pardon" next="1"/>', False),
        # Nothing is said, or nobody is asked.
        (BUTTON, "", TOUCHED, False),
        (BUTTON, MORNING, '<event name="other" next="2"/>', False),
        (BUTTON, MORNING, '<event name="click"/>', False),
        # Any touch goes on: nothing need be understood.
        ('<screen touched="click"/>', MORNING, TOUCHED, False),
        (
            '<screen touched="wave"/>',
            MORNING,
            '<event name="w" next="2"><say>w</say></event>',
            True,
        ),
    ],
)
def test_a_question_that_cannot_be_heard_again_is_told(
    screen: str, acts: str, events: str, is_told: bool
) -> None:
    project = whole(state(screen, acts, events) + END)
    assert bool(told(project, "no-repeat")) is is_told


def test_a_repeat_of_always_serves_where_always_does() -> None:
    shared = always(events='<event name="pardon"><repeat/></event>')
    asks = state(BUTTON, MORNING, TOUCHED)
    assert told(whole(shared + asks + END), "no-repeat") == []
    apart = state(BUTTON, MORNING, TOUCHED, attributes='always="false"')
    assert places(whole(shared + apart + END), "no-repeat") == [("state", "1")]


def test_all_questions_of_an_application_are_told_at_once() -> None:
    many = "".join(state(BUTTON, MORNING, TOUCHED, no=f"q{n}") for n in range(6))
    (problem,) = told(whole(many + END), "no-repeat")
    assert "q0, q1, q2, q3 and 2 more" in problem.message


def test_a_part_may_be_served_by_what_holds_it() -> None:
    part = app(state(BUTTON, MORNING, TOUCHED) + END, "part")
    flow = '<state no="1"><flow src="part1.rbd.xml"/></state>'
    repeats = always(events='<event name="pardon"><repeat/></event>')
    assert told(whole(repeats + flow, part), "no-repeat") == []
    assert [p.file for p in told(whole(flow, part), "no-repeat")] == ["nowhere/part1.rbd.xml"]


def test_a_file_that_is_read_alone_and_ends_may_be_a_part() -> None:
    asks = state(BUTTON, MORNING, TOUCHED)
    alone = Project(root="x", name="a", applications={"a.rbd.xml": app(asks + END)})
    assert told(alone, "no-repeat") == []
    round_ = state(events='<event name="click" next="1"/>', no="2")
    alone = Project(root="x", name="a", applications={"a.rbd.xml": app(asks + round_)})
    assert len(told(alone, "no-repeat")) == 1


# -- languages -------------------------------------------------------------------


def test_a_language_without_a_voice_is_told_where_the_project_speaks() -> None:
    languages = ("en", "pt-BR", "xx")
    (problem,) = told(whole(state(acts=MORNING), languages=languages), "language-without-voice")
    assert '"xx"' in problem.message
    assert problem.file == "nowhere/situ.toml"
    assert told(whole(state(BUTTON), languages=languages), "language-without-voice") == []


def test_a_speech_in_a_language_without_a_voice_is_told() -> None:
    acts = '<speech lang="xx-YY">a</speech><speech lang="pt_BR">a</speech><speech>a</speech>'
    project = whole(state(acts=acts))
    assert places(project, "language-without-voice") == [("state", "1", "action", "0")]


@pytest.mark.parametrize(
    ("value", "is_told"),
    [("mi", True), ("en", False), ("{choice}", False), ("", False), ("3", False), ('"mi"', True)],
)
def test_a_language_that_the_project_does_not_have_is_told(value: str, is_told: bool) -> None:
    button = f"<button id='b' {WIDE} tag='language' value='{value}'>x</button>"
    acts = f'<set tag="language">{value}</set><set tag="other">mi</set>'
    project = whole(state(button, acts), languages=("en",))
    both = [("state", "1", "action", "0"), ("state", "1", "screen", "b")]
    assert sorted(places(project, "language-without-texts")) == (both if is_told else [])
    assert told(whole(state(button, acts)), "language-without-texts") == []


# -- laws ------------------------------------------------------------------------

TEXTS = st.text("ab  日あ,{}\n.é", max_size=12)


@given(st.lists(TEXTS, max_size=4), TEXTS)
def test_a_speech_is_never_estimated_longer_than_with_any_value(
    pieces: list[str], value: str
) -> None:
    plain = [piece.replace("{", "").replace("}", "") for piece in pieces]
    least = literal("{user.name}".join(plain))
    assert estimate(least) <= estimate(value.join(plain))


@settings(max_examples=40, deadline=None)
@given(st.integers(1, 12), st.integers(2, 30), st.booleans())
def test_what_is_told_is_what_a_run_cuts_off(words: int, tenths: int, idle: bool) -> None:
    said = " ".join(["word"] * words)
    timeout = f'<timeout next="2" idle="{str(idle).lower()}">{tenths / 10}</timeout>'
    project = whole(state(acts=f"<speech>{said}</speech>", rest=timeout) + END)
    events: list[TraceEvent] = []
    lines = scenario.parse(b'{"at":60,"end":true}\n', "s.jsonl", ["a"])
    # Ends come before timeouts of the same moment.
    simulate(project, lines, auto_finish=round(estimate(said), 6), tell=events.extend)
    cut = any(to_fields(event)["kind"] == "cancelled" for event in events)
    assert bool(told(project, "speech-over-timeout")) is cut
