"""Rules of formats.md in each other's way: several applications and modules want the same.

Every expected line was worked out by hand.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tests.decide.in_short import (
    END,
    GO,
    NOD,
    abandon,
    acquire,
    application,
    script,
    state,
    text,
)

if TYPE_CHECKING:
    from tests.decide.conftest import Play


# -- several applications -----------------------------------------------------


def test_one_applications_event_takes_what_the_other_needs_for_its_own(play: Play) -> None:
    """Both get ``go``: a takes the head away, so b is suspended when its turn comes."""
    rbd = [
        application("a", state("1", "", GO), state("2", NOD)),
        application("b", state("1", NOD, GO), state("2")),
    ]
    trace = play(rbd, [{"at": 1, "event": "go"}], spds=script(a=2, b=1))
    assert trace.lines(since=1) == [
        "1 event a go <-",
        "1 exit a 1 <event",
        "1 transition a 1 2 go <event",
        "1 enter a 2 <transition",
        "1 acquire a [head] <enter",
        "1 authority head b a <acquire",
        "1 mapping head a null <authority",
        "1 suspend b [head] <authority",
        "1 cancelled b robot nod <suspend",
        '1 action a 2 robot nod resource="head" <enter',
        '1 mapping head a {"command":"nod","params":{}} <action',
        "1 event b go <-",
        "1 ignored b go suspended <event",
    ]


def test_one_applications_event_gives_the_other_what_it_waits_for(play: Play) -> None:
    """b is resumed before its own ``go`` is judged, and takes it."""
    rbd = [
        application("a", state("1", NOD, GO), state("2")),
        application("b", state("1", NOD, GO), state("2")),
    ]
    trace = play(rbd, [{"at": 1, "event": "go"}], spds=script(a=2, b=1))
    assert trace.lines("event", "resume", "transition", "action", "ignored", since=1) == [
        "1 event a go <-",
        "1 transition a 1 2 go <event",
        "1 resume b [] <authority",
        "1 event b resumed <resume",
        '1 action b 1 robot nod resource="head" <resume',
        "1 event b go <-",
        "1 transition b 1 2 go <event",
    ]


def test_a_screen_is_handed_over_and_back(play: Play) -> None:
    rbd = [
        application(
            "a",
            state("1", "", GO, text("one")),
            state("2", "", '<event name="go" next="1"/>', "<screen/>"),
        ),
        application("b", state("1", "", "", text("two", "Two {x}"))),
    ]
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"x": 1}},
        {"at": 2, "event": "go", "application": "a"},
        {"at": 3, "set": {"x": 2}},
        {"at": 4, "event": "go", "application": "a"},
        {"at": 5, "set": {"x": 3}},
    ]
    trace = play(rbd, lines, spds=script(a=2, b=1))
    assert trace.lines("screen", "mapping", "authority", "suspend", "resume") == [
        "0 authority screen - a <acquire",
        "0 screen a 1 [one=one] <enter",
        "0 mapping screen a [one=one] <screen",
        "0 suspend b [screen] <acquire",
        "2 authority screen a b <abandon",
        "2 mapping screen b null <authority",
        "2 screen a 2 [] <enter",
        "2 resume b [] <authority",
        "2 screen b 1 [two=Two 1] <resume",
        "2 mapping screen b [two=Two 1] <screen",
        "3 screen b 1 [two=Two 2] <data",
        "3 mapping screen b [two=Two 2] <screen",
        "4 authority screen b a <acquire",
        "4 mapping screen a null <authority",
        "4 suspend b [screen] <authority",
        "4 screen a 1 [one=one] <enter",
        "4 mapping screen a [one=one] <screen",
    ]


def test_with_equal_priority_who_shows_keeps_the_screen(play: Play) -> None:
    rbd = [
        application("a", state("1", "", GO), state("2", "", "", text("a"))),
        application("b", state("1", "", "", text("b"))),
    ]
    trace = play(rbd, [{"at": 1, "event": "go"}], spds=script(a=1, b=1))
    assert trace.lines("authority", "suspend") == [
        "0 authority screen - b <acquire",
        "1 suspend a [screen] <acquire",
    ]


def test_an_unnamed_event_of_one_looks_at_the_state_of_the_other(play: Play) -> None:
    rbd = [
        application("a", state("1", "", GO), state("2")),
        application(
            "b",
            state(
                "1", "", '<event next="2"><when><data tag="application/a.state" is="2"/></when>'
                '</event><event name="go" next="3"/>',
            ),
            state("2", "", '<event name="go" next="4"/>'), state("3"), state("4"),
        ),
    ]  # fmt: skip
    trace = play(rbd, [{"at": 1, "event": "go"}], spds=script(a=1, b=1))
    # a goes to 2; the unnamed event comes before b's own ``go``.
    assert trace.states("b") == [(0, "1"), (1, "2"), (1, "4")]
    assert trace.lines("transition")[1] == "1 transition b 1 2 - <enter"


def test_finish_may_name_the_application(play: Play) -> None:
    game = '<launch program="game"/>'
    rbd = [application("a", state("1", game)), application("b", state("1", game))]
    lines = [
        {"at": 1, "finish": {"action": "launch", "application": "b"}},
        {"at": 2, "finish": {"action": "launch"}},
        {"at": 3, "finish": {"action": "launch", "application": "b"}},
    ]
    trace = play(rbd, lines, spds=script(a=1, b=1))
    assert trace.lines("finished", "warning") == [
        "1 finished b launch game ok null <-",
        "2 finished a launch game ok null <-",
        "3 warning no launch is running <-",
    ]


def test_a_resume_names_the_authority_that_it_waited_for(play: Play) -> None:
    """At the same step ``screen`` goes elsewhere, later by name."""
    rbd = state("1", NOD)
    lines = [
        acquire(1, "m", "head"),
        acquire(2, "n", "screen", "base"),
        acquire(3, "o", "base"),
        abandon(4, "o", "base"),
        abandon(5, "m", "head"),
    ]
    spds = script(
        '<situation name="t"><condition><data tag="x" is="1"/></condition>'
        '<module name="app" priority="1"/><module name="n" priority="1"/></situation>',
        app=1, m=2, n=1, o=4,
    )  # fmt: skip
    lines[4:] = [{"at": 5, "set": {"x": 1}}]
    lines[3:4] = []
    trace = play(rbd, lines, spds=spds)
    assert trace.lines("authority", "resume", since=5) == [
        "5 authority base o n <situation",
        "5 authority head m app <situation",
        "5 authority screen - n <situation",
        "5 resume app [] <authority^1",
    ]


# -- optional resources -------------------------------------------------------


def test_an_optional_resource_that_comes_later_serves_the_next_state(play: Play) -> None:
    wave = '<robot resource="arm" command="wave" optional="true"/>'
    rbd = state("1", wave, GO) + state("2", wave)
    lines = [
        acquire(0, "m", "arm"),
        {"at": 0, "event": "again"},
        abandon(1, "m", "arm"),
        {"at": 2, "event": "go"},
    ]
    trace = play(rbd, lines, spds=script(app=1, m=2), tags={})
    assert trace.lines("action", "cancelled", "authority", "acquire") == [
        "0 acquire app [] [arm] <enter",
        "0 authority arm - app <acquire",
        '0 action app 1 robot wave resource="arm" <enter',
        "0 acquire m [arm] <-",
        "0 authority arm app m <acquire",
        "0 cancelled app robot wave <authority",
        "1 authority arm m app <abandon",
        '2 action app 2 robot wave resource="arm" <enter',
    ]


def test_an_optional_resource_is_given_up_with_the_required_ones(play: Play) -> None:
    rbd = state("1", '<robot resource="arm" command="wave" optional="true"/>' + NOD)
    lines = [acquire(1, "m", "head"), abandon(2, "m", "head")]
    trace = play(rbd, lines, spds=script(app=1, m=2))
    assert trace.lines("authority", "cancelled", "action", since=1) == [
        "1 authority arm app - <acquire",
        "1 authority head app m <acquire",
        "1 cancelled app robot wave <suspend",
        "1 cancelled app robot nod <suspend",
        "2 authority arm - app <abandon",
        "2 authority head m app <abandon",
        '2 action app 1 robot nod resource="head" <resume',
    ]


# -- commands across a hand-over ----------------------------------------------


def stream(at: float, module: str, value: Any, valid: float) -> dict[str, Any]:
    made = {"module": module, "resource": "head", "value": value, "for": valid}
    return {"at": at, "command": made}


def test_a_stream_takes_the_head_between_two_states(play: Play) -> None:
    rbd = (
        state("1", NOD, GO)
        + state("2", "", '<event name="go" next="3"/>')
        + state("3", '<robot resource="head" command="shake"/>')
    )
    lines = [
        acquire(0, "m", "head"),
        stream(0.5, "m", "a", 1),
        {"at": 1, "event": "go"},
        stream(1.25, "m", "b", 1),
        {"at": 2, "event": "go"},
        END,
    ]
    trace = play(rbd, lines, spds=script(app=2, m=1))
    assert trace.lines("mapping", "authority", "action", since=0.1) == [
        "1 mapping head app null <cancelled",
        "1 authority head app m <abandon",
        '1 mapping head m "a" <authority',
        '1.25 mapping head m "b" <-',
        "2 authority head m app <acquire",
        "2 mapping head app null <authority",
        '2 action app 3 robot shake resource="head" <enter',
        '2 mapping head app {"command":"shake","params":{}} <action',
    ]


def test_a_command_that_ends_at_the_moment_of_the_hand_over(play: Play) -> None:
    """The validity falls due first, so nothing of it is taken over."""
    lines = [
        acquire(0, "m", "head"),
        acquire(0, "n", "head"),
        stream(1, "n", "a", 2),
        abandon(3, "m", "head"),
        stream(4, "n", "b", 1),
        acquire(4, "m", "head"),
        END,
    ]
    trace = play((), lines, spds=script(m=2, n=1))
    assert trace.lines("mapping") == [
        '4 mapping head n "b" <-',
        "4 mapping head m null <authority",
    ]


def test_two_states_that_use_the_same_keep_authority_and_change_the_command(play: Play) -> None:
    rbd = state("1", NOD, GO) + state("2", NOD)
    lines = [acquire(0, "m", "head"), stream(0, "m", "m", 50), {"at": 1, "event": "go"}]
    trace = play(rbd, lines, spds=script(app=2, m=1))
    assert trace.lines("mapping", "authority", since=1) == [
        "1 mapping head app null <cancelled",
        '1 mapping head app {"command":"nod","params":{}} <action',
    ]


# -- the end of everything ----------------------------------------------------


def test_a_lost_module_hands_over_to_a_suspended_application(play: Play) -> None:
    lines = [
        acquire(1, "m", "head"),
        stream(1, "m", 1, 50),
        {"at": 2, "lost": {"module": "m"}},
        stream(3, "m", 2, 50),
        acquire(4, "m", "head"),
    ]
    trace = play(state("1", NOD), lines, spds=script(app=1, m=2))
    assert trace.lines("lost", "authority", "mapping", "resume", "suspend", since=1) == [
        "1 authority head app m <acquire",
        "1 mapping head m null <authority",
        "1 suspend app [head] <authority",
        "1 mapping head m 1 <-",
        "2 lost m [head] <-",
        "2 authority head m app <lost",
        "2 mapping head app null <authority",
        "2 resume app [] <authority",
        '2 mapping head app {"command":"nod","params":{}} <action',
        "4 authority head app m <acquire",
        "4 mapping head m 2 <authority",
        "4 suspend app [head] <authority",
    ]
