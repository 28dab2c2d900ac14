"""formats.md, *Speech heard*."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from situ.decide.inputs import Finish, Raise, Set, Start
from situ.decide.robot import Robot

if TYPE_CHECKING:
    from tests.decide.conftest import Build, Play

YES = '<event name="clickYes" next="2"><say>Yes, please!</say><say>go on</say></event>'
RESOURCES = ("acquire", "abandon", "authority", "mapping")


def state(no: str, events: str = "", actions: str = "") -> str:
    return (
        f'<state no="{no}"><backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def heard(at: float, text: str, confidence: float = 0.9) -> dict[str, Any]:
    return {"at": at, "set": {"heard": {"text": text, "confidence": confidence}}}


def listening(robot: Robot) -> list[str]:
    value = robot.board.look("listen")
    assert isinstance(value, list)
    return value


# -- the tag listen ----------------------------------------------------------


def test_the_phrases_of_the_events_expected_stand_at_listen(build: Build) -> None:
    rbd = state("1", YES + '<event name="no" next="2"><say>{word}</say></event>') + state("2")
    robot = Robot(build(rbd, tags={"word": "never"}))
    robot.step(Start(), 0)
    assert listening(robot) == ["Yes, please!", "go on", "never"]
    robot.step(Raise("clickYes"), 1)
    assert listening(robot) == []


def test_phrases_of_always_are_listened_for_too_and_none_twice(build: Build) -> None:
    always = (
        '<always><expectedevents><event name="home" next="1"><say>home</say></event>'
        '<event name="other"><say>go on</say></event></expectedevents></always>'
    )
    robot = Robot(build(always + state("1", YES) + state("2")))
    robot.step(Start(), 0)
    assert listening(robot) == ["Yes, please!", "go on", "home"]


def test_phrases_are_listened_for_from_the_end_of_the_states_speech(build: Build) -> None:
    robot = Robot(build(state("1", YES, "<speech>A</speech><speech>B</speech>") + state("2")))
    robot.step(Start(), 0)
    assert listening(robot) == []
    robot.step(Finish("speech"), 1)
    assert listening(robot) == []
    robot.step(Finish("speech"), 2)
    assert listening(robot) == ["Yes, please!", "go on"]


def test_with_bargein_they_are_from_its_start(build: Build) -> None:
    robot = Robot(build(state("1", YES, '<speech bargein="true">A</speech>') + state("2")))
    robot.step(Start(), 0)
    assert listening(robot) == ["Yes, please!", "go on"]


def test_a_suspended_application_listens_for_nothing(build: Build) -> None:
    spds = """<modules><module name="app" resources="speech"/></modules>
      <situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
      <situation name="calm"><module name="app" priority="1"/></situation>"""
    rbd = state("1", YES, '<speech bargein="true">A</speech>') + state("2")
    robot = Robot(build(rbd, spds))
    robot.step(Start(), 0)
    robot.step(Set({"busy": True}, "m"), 1)
    assert listening(robot) == []
    robot.step(Set({"busy": None}, "m"), 2)
    assert listening(robot) == ["Yes, please!", "go on"]


def test_nor_while_suspended_after_its_speech(play: Play) -> None:
    rbd = state("1", YES, '<speech>A</speech><robot resource="head" command="nod"/>') + state("2")
    lines = [
        {"at": 1, "finish": {"action": "speech"}},
        {"at": 2, "set": {"busy": True}},
        heard(3, "go on"),
        {"at": 4, "set": {"busy": False}},
        heard(5, "go on"),
    ]
    trace = play(rbd, lines, pauses="speech head")
    assert trace.lines("event") == [
        "4 event app resumed <resume",
        "5 event app clickYes <data",
    ]


def test_phrases_are_in_the_language_spoken(build: Build) -> None:
    texts = {"ja": {"Yes, please!": "はい", "go on": "続けて"}}
    project = build(
        state("1", YES) + state("2"), languages=("en", "ja"), texts=texts, tags={"language": "ja"}
    )
    robot = Robot(project)
    robot.step(Start(), 0)
    assert listening(robot) == ["はい", "続けて"]


# -- what is heard -----------------------------------------------------------


@pytest.mark.parametrize("text", ["Yes, please!", "yes please", "YES PLEASE.", "Go on", " go  on?"])
def test_a_text_equal_but_for_case_and_punctuation_is_that_event(play: Play, text: str) -> None:
    trace = play(state("1", YES) + state("2"), [heard(1, text)])
    assert trace.lines("event", "transition") == [
        "1 event app clickYes <data",
        "1 transition app 1 2 clickYes <event",
    ]


@pytest.mark.parametrize(
    ("confidence", "event"), [(0.5, "clickYes"), (1, "clickYes"), (0.49, "notunderstood")]
)
def test_a_text_counts_from_half_confidence_on(play: Play, confidence: float, event: str) -> None:
    trace = play(state("1", YES) + state("2"), [heard(1, "go on", confidence)])
    assert trace.lines("event") == [f"1 event app {event} <data"]


@pytest.mark.parametrize("text", ["go", "go on please", "no", ""])
def test_what_fits_no_phrase_is_not_understood(play: Play, text: str) -> None:
    rbd = state("1", YES + '<event name="notunderstood" next="3"/>') + state("2") + state("3")
    assert play(rbd, [heard(1, text)]).lines("event", "transition") == [
        "1 event app notunderstood <data",
        "1 transition app 1 3 notunderstood <event",
    ]


def test_a_phrase_whose_when_does_not_hold_is_heard_and_ignored(play: Play) -> None:
    rbd = state(
        "1",
        '<event name="go" next="2"><when><data tag="x" is="1"/></when><say>go on</say></event>',
    ) + state("2")
    assert play(rbd, [heard(1, "go on")]).lines("event", "ignored") == [
        "1 event app go <data",
        "1 ignored app go guard <event",
    ]


def test_without_a_confidence_a_text_counts(play: Play) -> None:
    line = {"at": 1, "set": {"heard": {"text": "go on"}}}
    assert play(state("1", YES) + state("2"), [line]).lines("event") == [
        "1 event app clickYes <data"
    ]


@pytest.mark.parametrize(
    ("value", "events"),
    [
        ("go on", []),
        ({"confidence": 1}, []),
        ({"text": 5}, []),
        ({"text": "go on", "confidence": "high"}, ["notunderstood"]),
    ],
)
def test_what_is_no_utterance_is_not_heard(play: Play, value: object, events: list[str]) -> None:
    trace = play(state("1", YES) + state("2"), [{"at": 1, "set": {"heard": value}}])
    assert [e["name"] for e in trace.of("event")] == events


def test_while_listen_is_empty_nothing_is_heard(play: Play) -> None:
    rbd = state("1", YES, "<speech>A</speech>") + state("2")
    trace = play(rbd, [heard(1, "go on")])
    assert trace.lines("event", "ignored") == []


def test_the_same_word_can_be_heard_twice(play: Play) -> None:
    rbd = state("1", '<event name="more"><say>more</say><add tag="n">1</add></event>')
    trace = play(rbd, [heard(1, "more"), heard(2, "more")])
    assert trace.values("n") == [1, 2]


def test_each_application_whose_phrase_fits_gets_its_event(play: Play) -> None:
    one = '<application name="{}">{}</application>'
    rbd = [
        one.format("a", state("1", '<event name="x"><say>yes</say></event>')),
        one.format("b", state("1", '<event name="y"><say>Yes!</say></event>')),
        one.format("c", state("1", '<event name="z"><say>no</say></event>')),
        one.format("d", state("1", '<event name="notunderstood"/>')),
    ]
    spds = (
        "<modules>"
        + "".join(f'<module name="{name}" resources=""/>' for name in "abcd")
        + '</modules><situation name="s">'
        + "".join(f'<module name="{name}" priority="1"/>' for name in "abcd")
        + "</situation>"
    )
    assert play(rbd, [heard(1, "yes")], spds=spds).lines("event") == [
        "1 event a x <data",
        "1 event b y <data",
    ]
    # None fits: each that expects phrases is told.
    assert play(rbd, [heard(1, "what")], spds=spds).lines("event") == [
        "1 event a notunderstood <data",
        "1 event b notunderstood <data",
        "1 event c notunderstood <data",
    ]
