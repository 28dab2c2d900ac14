"""formats.md, *Events*."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from situ.decide import machine, trace
from situ.decide.inputs import Raise, Start
from situ.decide.robot import Robot

if TYPE_CHECKING:
    from tests.decide.conftest import Build, Play

RESOURCES = ("acquire", "abandon", "authority", "mapping")


def state(no: str, events: str = "", actions: str = "") -> str:
    return (
        f'<state no="{no}"><backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def when(test: str) -> str:
    return f"<when><data {test}/></when>"


X_IS_1 = when('tag="x" is="1"')
D_EXISTS = when('tag="d" exists="true"')
D_NEAR = when('tag="d" below="1.5"')
FAR = when('tag="far" above="5"')

# -- which event is taken ----------------------------------------------------


def test_the_first_whose_name_matches_and_whose_when_holds_is_taken(play: Play) -> None:
    rbd = state(
        "1",
        f'<event name="other" next="2"/><event name="go" next="3">{X_IS_1}</event>'
        '<event name="go" next="4"/><event name="go" next="5"/>',
    ) + "".join(state(no) for no in "2345")
    assert play(rbd, [{"at": 1, "event": "go"}], tags={"x": 1}).states()[-1] == (1, "3")
    assert play(rbd, [{"at": 1, "event": "go"}], tags={"x": 2}).states()[-1] == (1, "4")


def test_the_states_events_are_tried_before_those_of_always(play: Play) -> None:
    always = '<always><expectedevents><event name="go" next="3"/></expectedevents></always>'
    two = f'<event name="go" next="2">{X_IS_1}</event>'
    rbd = always + state("1", two) + state("2") + state("3")
    assert play(rbd, [{"at": 1, "event": "go"}], tags={"x": 1}).states()[-1] == (1, "2")
    assert play(rbd, [{"at": 1, "event": "go"}]).states()[-1] == (1, "3")


def test_a_transition_is_told_step_by_step(play: Play) -> None:
    trace = play(state("1", '<event name="go" next="2"/>') + state("2"), [{"at": 1, "event": "go"}])
    assert trace.lines() == [
        "0 enter app 1 <-",
        "1 event app go <-",
        "1 exit app 1 <event",
        "1 transition app 1 2 go <event",
        "1 enter app 2 <transition",
    ]


def test_a_when_sees_what_the_same_event_brought(play: Play) -> None:
    rbd = state("1", f'<event name="go" next="2">{X_IS_1}</event>', "") + state("2") + state("3")
    trace = play(rbd, [{"at": 1, "set": {"x": 1}}, {"at": 1, "event": "go"}])
    assert trace.states()[-1] == (1, "2")


# -- what nobody accepts -----------------------------------------------------


def test_an_event_nobody_accepts_is_dropped_and_traced_as_ignored(play: Play) -> None:
    rbd = state("1", f'<event name="go" next="2">{X_IS_1}</event>') + state("2")
    lines = [
        {"at": 1, "event": "go"},
        {"at": 2, "event": "gone"},
        {"at": 3, "set": {"x": 1}},
    ]
    trace = play(rbd, lines)
    assert trace.lines("event", "ignored", "transition") == [
        "1 event app go <-",
        "1 ignored app go guard <event",
        "2 event app gone <-",
        "2 ignored app gone unexpected <event",
    ]


def test_an_event_while_suspended_is_ignored(play: Play) -> None:
    rbd = state("1", '<event name="go" next="2"/>', "<speech>A</speech>") + state("2")
    lines = [{"at": 1, "set": {"busy": True}}, {"at": 2, "event": "go"}]
    assert play(rbd, lines, pauses="speech").lines(since=2) == [
        "2 event app go <-",
        "2 ignored app go suspended <event",
    ]


# -- unnamed -----------------------------------------------------------------

NEAR = f'<event next="2">{D_NEAR}</event>'


def test_an_event_without_name_is_taken_as_soon_as_its_when_holds(play: Play) -> None:
    lines = [{"at": 1, "set": {"d": 2}}, {"at": 2, "set": {"d": 1}}]
    assert play(state("1", NEAR) + state("2"), lines).lines(since=1) == [
        "1 data d 2 scenario v1 <-",
        "2 data d 1 scenario v2 <-",
        "2 exit app 1 <data",
        "2 transition app 1 2 - <data",
        "2 enter app 2 <transition",
    ]


def test_an_event_without_name_that_holds_at_entry_is_caused_by_the_enter(play: Play) -> None:
    trace = play(state("1", NEAR) + state("2"), [], tags={"d": 1})
    assert trace.lines("enter", "exit", "transition") == [
        "0 enter app 1 <-",
        "0 exit app 1 <enter",
        "0 transition app 1 2 - <enter",
        "0 enter app 2 <transition",
    ]


def test_its_cause_is_no_write_that_another_states_event_looks_at(play: Play) -> None:
    rbd = state("1", NEAR, '<set tag="far">1</set>') + state("2", f'<event next="1">{FAR}</event>')
    trace = play(rbd, [], tags={"d": 1})
    assert trace.lines("transition") == ["0 transition app 1 2 - <enter"]


def test_an_event_without_name_and_when_is_taken_at_once(play: Play) -> None:
    rbd = state("1", '<event next="2"><set tag="x">1</set></event>', '<set tag="y">1</set>')
    assert play(rbd + state("2"), []).lines("data", "enter") == [
        "0 enter app 1 <-",
        "0 data y 1 app v1 <action",
        "0 data x 1 app v1 <action",
        "0 enter app 2 <transition",
    ]


def test_the_first_event_without_name_that_holds_is_taken_also_that_of_always(play: Play) -> None:
    shared = f'<event next="3">{D_EXISTS}</event>'
    rbd = (
        f"<always><expectedevents>{shared}</expectedevents></always>"
        + state("1", NEAR)
        + '<state no="2" always="false"/><state no="3" always="false"/>'
    )
    assert play(rbd, [{"at": 1, "set": {"d": 1}}]).states()[-1] == (1, "2")
    assert play(rbd, [{"at": 1, "set": {"d": 5}}]).states()[-1] == (1, "3")


def test_a_refused_event_without_name_gives_way_to_the_next(play: Play) -> None:
    rbd = state("1", f'<event next="#back"/>{NEAR}') + state("2")
    assert play(rbd, [{"at": 1, "set": {"d": 1}}]).states() == [(0, "1"), (1, "2")]


# -- internal ----------------------------------------------------------------


def test_an_event_without_next_is_internal(play: Play) -> None:
    rbd = (
        '<state no="1"><timeout next="2">3</timeout><expectedevents><event name="go">'
        '<set tag="x">1</set></event></expectedevents></state><state no="2"/>'
    )
    trace = play(rbd, [{"at": 2, "event": "go"}, {"at": 9, "end": True}])
    assert trace.lines(since=1) == [
        "2 event app go <-",
        '2 action app 1 set - tag="x" value=1 <event',
        "2 data x 1 app v1 <action",
        "2 finished app set - ok null <action",
        "3 exit app 1 <enter",
        "3 transition app 1 2 timeout <enter",
        "3 enter app 2 <transition",
    ]


def test_actions_of_an_internal_event_are_cancelled_with_the_state(play: Play) -> None:
    rbd = state(
        "1", '<event name="go"><launch program="p"/></event><event name="end" next="2"/>'
    ) + state("2")
    trace = play(rbd, [{"at": 1, "event": "go"}, {"at": 2, "event": "end"}])
    assert trace.lines("action", "cancelled") == [
        "1 action app 1 launch p <event",
        "2 cancelled app launch p <exit",
    ]


# -- repeat ------------------------------------------------------------------

REPEAT = '<event name="again"><repeat/></event>'


def test_repeat_cancels_a_speech_still_running_and_says_the_speeches_once_more(play: Play) -> None:
    rbd = state(
        "1",
        REPEAT,
        '<speech done="a">A</speech><robot resource="head" command="nod"/><speech done="b">B'
        '</speech><set tag="x">1</set>',
    )
    lines = [
        {"at": 1, "finish": {"action": "speech"}},
        {"at": 2, "event": "again"},
        {"at": 3, "finish": {"action": "speech"}},
        {"at": 4, "finish": {"action": "speech"}},
        {"at": 5, "finish": {"action": "speech"}},
    ]
    trace = play(rbd, lines)
    assert trace.lines("action", "cancelled", "event", "warning", since=1) == [
        '1 action app 1 speech - text="B" <finished',
        "1 event app a <finished",
        "2 event app again <-",
        "2 cancelled app speech - <event",
        '2 action app 1 speech - text="A" <event',
        '3 action app 1 speech - text="B" <finished',
        "3 event app a <finished",
        "4 event app b <finished",
        "5 warning no speech is running <-",
    ]


def test_repeat_speaks_again_after_the_end_and_fills_in_anew(play: Play) -> None:
    rbd = state("1", REPEAT, '<speech wait="true">{x}</speech><set tag="y">1</set>')
    lines = [
        {"at": 1, "finish": {"action": "speech"}},
        {"at": 2, "set": {"x": "new"}},
        {"at": 2, "event": "again"},
        {"at": 3, "finish": {"action": "speech"}},
    ]
    trace = play(rbd, lines, tags={"x": "old"})
    assert [(e["t"], e.get("text")) for e in trace.of("action")] == [
        (0, "old"), (1, None), (2, "new"),
    ]  # fmt: skip


def test_repeat_leaves_a_speech_alone_whose_time_has_not_come(play: Play) -> None:
    rbd = state("1", REPEAT, '<launch program="p" wait="true"/><speech>A</speech>')
    lines = [{"at": 1, "event": "again"}, {"at": 2, "finish": {"action": "launch"}}]
    trace = play(rbd, lines)
    assert trace.lines("action", since=1) == ['2 action app 1 speech - text="A" <finished']


def test_repeat_takes_its_turn_among_the_actions_of_its_event(play: Play) -> None:
    rbd = state(
        "1",
        '<event name="again"><set tag="x">2</set><repeat/><set tag="x">3</set></event>',
        "<speech>{x}</speech>",
    )
    trace = play(rbd, [{"at": 1, "event": "again"}], tags={"x": 1})
    assert [e.get("text", e.get("value")) for e in trace.of("action")] == ["1", 2, "2", 3]


def test_repeat_does_not_count_the_timeout_anew(play: Play) -> None:
    rbd = (
        '<state no="1"><timeout next="2">3</timeout><backgroundactions><speech>A</speech>'
        f"</backgroundactions><expectedevents>{REPEAT}</expectedevents></state>{state('2')}"
    )
    trace = play(rbd, [{"at": 2, "event": "again"}, {"at": 9, "end": True}])
    assert trace.states() == [(0, "1"), (3, "2")]


def test_repeat_says_nothing_where_the_state_has_no_speech(play: Play) -> None:
    rbd = state("1", '<event name="go" next="2"/>', "<speech>A</speech>") + state("2", REPEAT)
    trace = play(rbd, [{"at": 1, "event": "go"}, {"at": 2, "event": "again"}])
    assert trace.lines(since=2) == ["2 event app again <-"]


# -- again and back ----------------------------------------------------------


def test_again_enters_the_state_anew(play: Play) -> None:
    rbd = state("1", '<event name="go" next="#again"/>', '<set tag="x">1</set>')
    assert play(rbd, [{"at": 1, "event": "go"}]).lines(since=1) == [
        "1 event app go <-",
        "1 exit app 1 <event",
        "1 transition app 1 1 go <event",
        "1 enter app 1 <transition",
        '1 action app 1 set - tag="x" value=1 <enter',
        "1 data x 1 app v2 <action",
        "1 finished app set - ok null <action",
    ]


BACK = '<event name="back" next="#back"/>'


def to(*numbers: str) -> str:
    return "".join(f'<event name="to{no}" next="{no}"/>' for no in numbers)


MAZE = "".join(
    state(no, to("1", "2", "3", "4") + BACK + '<event name="anew" next="#again"/>') for no in "1234"
)


@pytest.mark.parametrize(
    ("events", "visited"),
    [
        ("to2 back", "121"),
        ("to2 to3 back back", "12321"),
        ("to2 to3 to2 back", "12323"),
        ("to2 to3 to2 back back back", "1232321"),
        ("to2 to2 back back", "12221"),
        # With nothing on the stack it is refused; in the start state the stack is emptied.
        ("back", "1"),
        ("to2 to3 to1 back", "1231"),
        ("to2 to3 to1 to4 back back", "123141"),
        # ``#again`` leaves the stack as it is.
        ("to2 to3 anew back", "12332"),
        ("to2 anew anew back", "12221"),
        ("to2 to3 to4 back to4 back back", "12343432"),
    ],
)
def test_back_goes_to_the_state_from_which_this_one_was_entered(
    play: Play, events: str, visited: str
) -> None:
    lines = [{"at": i, "event": name} for i, name in enumerate(events.split(), 1)]
    assert "".join(no for _, no in play(MAZE, lines).states()) == visited


@pytest.mark.parametrize("actions", ["", "<launch program='x'/>"])
def test_of_a_thousand_ways_back_the_oldest_is_forgotten(build: Build, actions: str) -> None:
    # By the short way and the long one.
    states = "".join(state(no, to("2", "3") + BACK, actions) for no in "123")
    robot = Robot(build(states))
    robot.step(Start(), 0)
    for number in range(machine.DEEPEST + 1):
        robot.step(Raise("to3" if number % 2 else "to2"), 1)
    for _ in range(machine.DEEPEST):
        robot.step(Raise("back"), 2)
    # Not in 1, from where it came first.
    assert robot.expected()["app"].state == "2"
    events, _ = robot.step(Raise("back"), 3)
    assert [event.reason for event in events if isinstance(event, trace.Ignored)] == ["guard"]


def test_back_with_nothing_on_the_stack_is_refused_like_a_guard(play: Play) -> None:
    assert play(MAZE, [{"at": 1, "event": "back"}]).lines(since=1) == [
        "1 event app back <-",
        "1 ignored app back guard <event",
    ]
    rbd = state("1", BACK + '<event name="back" next="2"/>') + state("2")
    assert play(rbd, [{"at": 1, "event": "back"}]).states()[-1] == (1, "2")


# -- who gets it -------------------------------------------------------------

TWO = [
    f'<application name="a">{state("1", to("2"))}{state("2")}</application>',
    f'<application name="b">{state("1", to("2"))}{state("2")}</application>',
]
BOTH = """<modules><module name="a" resources=""/><module name="b" resources=""/></modules>
  <situation name="s"><module name="a" priority="1"/><module name="b" priority="2"/></situation>"""


def test_an_event_without_application_goes_to_every_application_in_order(play: Play) -> None:
    trace = play(TWO, [{"at": 1, "event": "to2"}], spds=BOTH)
    assert trace.lines(since=1) == [
        "1 event a to2 <-",
        "1 exit a 1 <event",
        "1 transition a 1 2 to2 <event",
        "1 enter a 2 <transition",
        "1 event b to2 <-",
        "1 exit b 1 <event",
        "1 transition b 1 2 to2 <event",
        "1 enter b 2 <transition",
    ]


def test_an_event_with_application_goes_to_that_one(play: Play) -> None:
    trace = play(TWO, [{"at": 1, "event": "to2", "application": "b"}], spds=BOTH)
    assert [e["application"] for e in trace.of("event")] == ["b"]
