"""Rules of formats.md in each other's way: suspension, waiting and idle timeouts.

Every expected line was worked out by hand.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tests.decide.in_short import (
    END,
    GO,
    GO_ON,
    NOD,
    STOP,
    abandon,
    acquire,
    finish,
    script,
    state,
    text,
)

if TYPE_CHECKING:
    from tests.decide.conftest import Play


# -- suspension and waiting ---------------------------------------------------


def test_a_chain_of_waits_is_taken_up_where_it_was_cut(play: Play) -> None:
    rbd = state(
        "1",
        '<speech wait="true">A</speech><robot resource="head" command="nod" wait="true"/>'
        '<set tag="x">1</set>',
    )
    lines = [
        {"at": 1, **STOP},
        {"at": 2, **GO_ON},
        finish(3, "speech"),
        {"at": 4, **STOP},
        {"at": 5, **GO_ON},
        finish(6, "robot"),
    ]
    trace = play(rbd, lines, pauses="speech head")
    assert trace.lines("action", "cancelled", "finished") == [
        '0 action app 1 speech - text="A" <enter',
        "1 cancelled app speech - <suspend",
        '2 action app 1 speech - text="A" <resume',
        "3 finished app speech - ok null <-",
        '3 action app 1 robot nod resource="head" <finished',
        "4 cancelled app robot nod <suspend",
        '5 action app 1 robot nod resource="head" <resume',
        "6 finished app robot nod ok null <-",
        '6 action app 1 set - tag="x" value=1 <finished',
        "6 finished app set - ok null <action",
    ]


def test_the_moment_of_a_timeout_comes_before_the_suspension_of_that_moment(play: Play) -> None:
    rbd = state("1", NOD, inside='<timeout next="2">5</timeout>') + state("2", NOD)
    trace = play(rbd, [{"at": 5, **STOP}], pauses="head")
    assert trace.lines("enter", "suspend", since=5) == [
        "5 enter app 2 <transition",
        "5 suspend app [head] <authority",
    ]


def test_resumed_with_repeat_says_everything_once(play: Play) -> None:
    rbd = state(
        "1", "<speech>A</speech><speech>B</speech>", '<event name="resumed"><repeat/></event>'
    )
    lines = [
        finish(1, "speech"),
        {"at": 2, **STOP},
        {"at": 3, **GO_ON},
        finish(4, "speech"),
        finish(5, "speech"),
        finish(6, "speech"),
    ]
    trace = play(rbd, lines, pauses="speech")
    assert trace.lines("action", "warning", since=2) == [
        '3 action app 1 speech - text="A" <event',
        '4 action app 1 speech - text="B" <finished',
        "6 warning no speech is running <-",
    ]


def test_repeat_while_suspended_is_ignored(play: Play) -> None:
    rbd = state("1", "<speech>A</speech>", '<event name="r"><repeat/></event>')
    lines = [{"at": 1, **STOP}, {"at": 2, "event": "r"}, {"at": 3, **GO_ON}]
    trace = play(rbd, lines, pauses="speech")
    assert len(trace.of("action")) == 2
    assert trace.lines("ignored") == ["2 ignored app r suspended <event"]


def test_what_a_transition_raised_waits_while_its_state_is_entered_suspended(play: Play) -> None:
    rbd = state("1", "", '<event name="go" next="2"><message topic="t" done="sent"/></event>')
    rbd += state("2", NOD, '<event name="sent" next="3"/>') + state("3")
    lines = [
        acquire(0, "m", "head"),
        {"at": 1, "event": "go"},
        abandon(2, "m", "head"),
    ]
    trace = play(rbd, lines, spds=script(app=1, m=2))
    assert trace.lines("event", "enter", "suspend", "resume", "action", "cancelled", since=1) == [
        "1 event app go <-",
        '1 action app 2 message - topic="t" value=null <transition',
        "1 enter app 2 <transition",
        "1 suspend app [head] <acquire",
        "2 resume app [] <authority",
        "2 event app resumed <resume",
        '2 action app 2 robot nod resource="head" <resume',
        "2 event app sent <finished",
        "2 cancelled app robot nod <exit",
        "2 enter app 3 <transition",
    ]


def test_a_finish_of_what_was_cut_off_finds_nothing(play: Play) -> None:
    lines = [{"at": 1, **STOP}, finish(2, "robot", "nod"), {"at": 3, **GO_ON}, finish(4, "robot")]
    trace = play(state("1", NOD), lines, pauses="head")
    assert trace.lines("warning", "finished") == [
        "2 warning no robot nod is running <-",
        "4 finished app robot nod ok null <-",
    ]


def test_automatic_finishes_count_from_when_an_action_began_again(play: Play) -> None:
    lines = [{"at": 1, **STOP}, {"at": 2.5, **GO_ON}, END]
    trace = play(state("1", "<speech>A</speech>"), lines, pauses="speech", auto_finish=2)
    assert trace.lines("finished") == ["4.5 finished app speech - ok null <action"]


def test_an_automatic_finish_goes_on_with_the_chain_before_the_timeout_of_its_moment(
    play: Play,
) -> None:
    rbd = state(
        "1", '<launch program="p" wait="true"/><launch program="q"/>',
        inside='<timeout next="2">2</timeout>',
    ) + state("2")  # fmt: skip
    trace = play(rbd, [{"at": 2, "end": True}], auto_finish=2)
    assert trace.lines(since=2) == [
        "2 finished app launch p ok null <action",
        "2 action app 1 launch q <finished",
        "2 exit app 1 <enter",
        "2 cancelled app launch q <exit",
        "2 transition app 1 2 timeout <enter",
        "2 enter app 2 <transition",
    ]


def test_more_that_changes_while_suspended_does_not_suspend_again(play: Play) -> None:
    rbd = state("1", NOD + "<speech>A</speech>")
    lines = [
        acquire(1, "m", "head"),
        acquire(2, "n", "speech"),
        abandon(3, "m", "head"),
        abandon(4, "n", "speech"),
    ]
    trace = play(rbd, lines, spds=script(app=1, m=2, n=3))
    assert trace.lines("suspend", "resume", "cancelled") == [
        "1 suspend app [head speech] <authority^1",
        "1 cancelled app robot nod <suspend",
        "1 cancelled app speech - <suspend",
        "4 resume app [] <authority",
    ]


def test_suspended_and_resumed_within_one_moment(play: Play) -> None:
    """Two steps of one moment: what was cut off begins again at once."""
    lines = [{"at": 1, **STOP}, {"at": 1, **GO_ON}]
    trace = play(state("1", NOD, inside='<timeout next="1">5</timeout>'), [*lines, {
        "at": 6, "end": True}], pauses="head")  # fmt: skip
    assert trace.lines("suspend", "resume", "action", "transition", since=1) == [
        "1 suspend app [head] <authority",
        "1 resume app [] <authority",
        '1 action app 1 robot nod resource="head" <resume',
        "5 transition app 1 1 timeout <resume",
        '5 action app 1 robot nod resource="head" <enter',
    ]


def test_a_service_that_ends_while_suspended_sets_its_results_at_once(play: Play) -> None:
    rbd = state(
        "1",
        '<speech>A</speech><service name="s" url="http://x/" done="got">'
        '<result tag="r"/></service>',
        '<event next="2"><when><data tag="r" exists="true"/></when></event>',
    ) + state("2", "", '<event name="got"><set tag="late">1</set></event>')
    lines = [
        {"at": 1, **STOP},
        {"at": 2, "finish": {"action": "service", "result": 1}},
        {"at": 3, **GO_ON},
    ]
    trace = play(rbd, lines, pauses="speech")
    assert trace.lines("data", "transition", "event", since=2) == [
        '2 data service/s {"ok":true,"status":null,"error":null} app v1 <finished',
        "2 data r 1 app v1 <finished",
        "3 data busy false scenario v2 <-",
        "3 event app resumed <resume",
        # Speech and screen begin with the resume; then unnamed before what was raised.
        "3 transition app 1 2 - <resume",
        "3 event app got <finished",
        "3 data late 1 app v1 <action",
    ]


def test_a_state_without_timeout_gets_none_by_a_suspension(play: Play) -> None:
    rbd = state("1", "", GO, '<timeout next="3">3</timeout>') + state("2", NOD) + state("3")
    lines = [{"at": 1, "event": "go"}, {"at": 2, **STOP}, {"at": 3, **GO_ON}, END]
    trace = play(rbd, lines, pauses="head")
    assert trace.states() == [(0, "1"), (1, "2")]


# -- idle ---------------------------------------------------------------------


def test_an_idle_timeout_falls_due_only_when_nobody_does_anything(play: Play) -> None:
    """Speech, then touches, then a suspension, then a heard word, then nothing."""
    rbd = state(
        "1",
        '<speech bargein="true">A</speech>',
        '<event name="yes"><say>yes</say></event>',
        '<timeout next="2" idle="true">3</timeout>' + text("t"),
    ) + state("2", "", "", "<screen/>")
    lines = [
        finish(2, "speech"),  # counts from 2
        {"at": 4, "touch": True},  # from 4
        {"at": 6, **STOP},  # one second left
        {"at": 10, **GO_ON},  # due at 11
        {"at": 10.5, "set": {"heard": {"text": "what", "confidence": 1}}},  # from 10.5
        {"at": 13, "set": {"heard": {"text": "yes", "confidence": 0.1}}},  # from 13
        END,
    ]
    trace = play(rbd, lines, pauses="speech screen")
    assert trace.lines("transition", "event") == [
        "10 event app resumed <resume",
        "10.5 event app notunderstood <data",
        "13 event app notunderstood <data",
        "16 transition app 1 2 timeout <resume",
    ]


def test_an_idle_timeout_that_raises_its_event_and_is_answered_by_a_repeat(play: Play) -> None:
    rbd = state(
        "1",
        "<speech>A</speech>",
        '<event name="timeout" next="2"><when><data tag="n" atleast="2"/></when></event>'
        '<event name="timeout"><add tag="n">1</add><repeat/></event>',
        '<timeout idle="true">4</timeout>',
    ) + state("2")
    trace = play(rbd, [END], auto_finish=1)
    # 1 said, 5 asked again, 6 said, 10 again, 11 said, 15 given up.
    assert trace.lines("event", "transition") == [
        "5 event app timeout <enter",
        "10 event app timeout <enter",
        "15 event app timeout <enter",
        "15 transition app 1 2 timeout <event",
    ]
    assert trace.of("transition")[0]["event"] == "timeout"
