"""Rules of formats.md in each other's way; every expected line was worked out by hand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tests.decide.conftest import Play

RESOURCES = ("acquire", "abandon", "authority", "mapping", "situation", "condition")
END: dict[str, Any] = {"at": 100, "end": True}
STOP: dict[str, Any] = {"set": {"busy": True}}
GO_ON: dict[str, Any] = {"set": {"busy": False}}
AT = 'x="1" y="1" width="9" height="9"'


def state(no: str, actions: str = "", events: str = "", inside: str = "") -> str:
    return (
        f'<state no="{no}">{inside}<backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def text(name: str, written: str = "") -> str:
    shown = f'<text id="{name}" {AT}>{written or name}</text>'
    return f"<screen><components>{shown}</components></screen>"


def application(name: str, *states: str) -> str:
    return f'<application name="{name}">{"".join(states)}</application>'


def script(situations: str = "", **priorities: int) -> str:
    """A script in which all may ask for everything; the last situation has the priorities."""
    declared = "".join(
        f'<module name="{name}" resources="arm base head screen speech"/>' for name in priorities
    )
    given = "".join(f'<module name="{n}" priority="{p}"/>' for n, p in priorities.items())
    return f'<modules>{declared}</modules>{situations}<situation name="s">{given}</situation>'


def finish(at: float, action: str, name: str | None = None) -> dict[str, Any]:
    named = {} if name is None else {"name": name}
    return {"at": at, "finish": {"action": action, **named}}


def acquire(at: float, module: str, *resources: str, optional: str = "") -> dict[str, Any]:
    asked: dict[str, Any] = {"module": module, "resources": list(resources)}
    if optional:
        asked["optional"] = optional.split()
    return {"at": at, "acquire": asked}


def abandon(at: float, module: str, *resources: str) -> dict[str, Any]:
    return {"at": at, "abandon": {"module": module, "resources": list(resources)}}


NOD = '<robot resource="head" command="nod"/>'
GO = '<event name="go" next="2"/>'


# -- suspension and waiting --------------------------------------------------


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


# -- idle --------------------------------------------------------------------


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


# -- situations --------------------------------------------------------------


def held(name: str, tag: str, **more: str) -> str:
    attributes = "".join(f' {k}="{v}"' for k, v in more.items() if k != "until")
    until = f'<until><data tag="{more["until"]}" is="true"/></until>' if "until" in more else ""
    return (
        f'<situation name="{name}"{attributes}><condition><data tag="{tag}" is="true"/></condition>'
        f"{until}</situation>"
    )


def test_dwell_until_and_limit_in_precedence(play: Play) -> None:
    spds = (
        held("dwells", "d", dwell="4")
        + held("until", "u", until="end", limit="10")
        + held("limited", "l", limit="6")
        + '<situation name="rest"/>'
    )
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"l": True}},  # limited, till 7
        {"at": 2, "set": {"u": True}},  # until, till 12
        {"at": 3, "set": {"d": True, "u": False}},  # dwells, till 7
        {"at": 4, "set": {"d": False}},
        # 7: dwells ends; until still holds; limited has ended at 7 too, and is spent.
        {"at": 9, "set": {"end": True}},  # until ends; limited is spent: rest
        {"at": 10, "set": {"l": False}},
        {"at": 11, "set": {"l": True}},  # limited, till 17
        {"at": 12, "set": {"end": False}},
        {"at": 13, "set": {"u": True}},  # until, till 23; u stays true
        END,
    ]
    trace = play((), lines, spds=spds)
    assert trace.situations() == [
        (0, "rest"), (1, "limited"), (2, "until"), (3, "dwells"), (7, "until"), (9, "rest"),
        (11, "limited"), (13, "until"), (23, "rest"),
    ]  # fmt: skip
    assert trace.lines("situation", since=7)[0] == "7 situation dwells until <situation"


def test_a_limit_and_an_until_of_one_moment(play: Play) -> None:
    """The limit falls due first, so the situation is spent; until changes nothing more."""
    spds = held("a", "x", until="end", limit="5") + '<situation name="rest"/>'
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"x": True}},
        {"at": 6, "set": {"end": True, "x": False}},
        {"at": 7, "set": {"x": True}},
        {"at": 8, "set": {"end": False}},
        END,
    ]
    trace = play((), lines, spds=spds)
    assert trace.situations() == [(0, "rest"), (1, "a"), (6, "rest"), (8, "a"), (13, "rest")]


def test_until_and_condition_in_one_write(play: Play) -> None:
    """It does not begin, and as it was never ended nothing needs to be false first."""
    spds = held("a", "x", until="end") + '<situation name="rest"/>'
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"x": True, "end": True}},
        {"at": 2, "set": {"end": False}},
        {"at": 3, "set": {"x": False}},
        {"at": 4, "set": {"x": True, "end": True}},
        {"at": 5, "set": {"end": False}},
        {"at": 6, "set": {"x": False}},
        {"at": 7, "set": {"x": True}},
        END,
    ]
    # At 4 it is current and ends; x was never false since: it begins again at 7.
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (2, "a"), (4, "rest"), (7, "a"),
    ]  # fmt: skip


def test_a_situation_that_ends_itself_by_what_it_lets_happen(play: Play) -> None:
    """The application is resumed in the situation, and its unnamed event ends that."""
    rbd = state(
        "1", NOD, '<event next="2"><when><data tag="go" is="true"/></when>'
        '<set tag="go">false</set></event>',
    ) + state("2")  # fmt: skip
    situation = (
        '<situation name="going"><condition><data tag="go" is="true"/></condition>'
        '<module name="app" priority="1"/></situation>'
    )
    spds = (
        '<modules><module name="app" resources="head"/></modules>'
        f'{situation}<situation name="rest"/>'
    )
    trace = play(rbd, [{"at": 1, "set": {"go": True}}], spds=spds)
    assert trace.lines(since=1) == [
        "1 data go true scenario v1 <-",
        "1 condition going true <data",
        "1 situation rest going <condition",
        "1 authority head - app <situation",
        "1 resume app [] <authority",
        "1 event app resumed <resume",
        '1 action app 1 robot nod resource="head" <resume',
        '1 mapping head app {"command":"nod","params":{}} <action',
        "1 exit app 1 <resume",
        "1 cancelled app robot nod <exit",
        "1 mapping head app null <cancelled",
        "1 transition app 1 2 - <resume",
        '1 action app 2 set - tag="go" value=false <transition',
        "1 data go false app v2 <action",
        "1 finished app set - ok null <action",
        "1 enter app 2 <transition",
        "1 abandon app [head] <enter",
        "1 authority head app - <abandon",
        "1 condition going false <data",
        "1 situation going rest <condition",
    ]


def test_data_of_a_press_may_suspend_the_application_before_the_press_is_judged(
    play: Play,
) -> None:
    button = f'<button id="b" {AT} event="pressed" tag="busy" value="true">B</button>'
    rbd = state("1", "", '<event name="pressed" next="2"/>',
                f"<screen><components>{button}</components></screen>") + state("2")  # fmt: skip
    trace = play(rbd, [{"at": 1, "use": {"component": "b"}}], pauses="screen")
    assert trace.lines(since=1) == [
        "1 data busy true screen v1 <-",
        "1 condition busy true <data",
        "1 situation calm busy <condition",
        "1 authority screen app - <situation",
        "1 mapping screen - null <authority",
        "1 suspend app [screen] <authority",
        "1 event app pressed <-",
        "1 ignored app pressed suspended <event",
    ]


# -- several applications ----------------------------------------------------


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


# -- optional resources ------------------------------------------------------


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


# -- commands across a hand-over ---------------------------------------------


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


# -- the stack of #back ------------------------------------------------------


def test_back_after_unnamed_events_and_timeouts(play: Play) -> None:
    rbd = (
        state("1", "", GO)
        + state("2", "", "", '<timeout next="3">1</timeout>')
        + state("3", "", '<event next="4"><when><data tag="x" is="1"/></when></event>')
        + state(
            "4", "", '<event name="back" next="#back"><set tag="x">0</set><set tag="in">{x}</set>'
            "</event>",
        )
    )  # fmt: skip
    lines: list[dict[str, Any]] = [
        {"at": 1, "event": "go"},
        {"at": 3, "set": {"x": 1}},
        {"at": 4, "event": "back"},
    ]
    trace = play(rbd, lines)
    assert trace.states() == [(0, "1"), (1, "2"), (2, "3"), (3, "4"), (4, "3")]
    # Its actions belong to the state that it goes to.
    assert [e["state"] for e in trace.of("action")] == ["3", "3"]


def test_back_by_resumed(play: Play) -> None:
    rbd = state("1", "", GO) + state("2", NOD, '<event name="resumed" next="#back"/>')
    lines = [{"at": 1, "event": "go"}, {"at": 2, **STOP}, {"at": 3, **GO_ON}]
    trace = play(rbd, lines, pauses="head")
    assert trace.states() == [(0, "1"), (1, "2"), (3, "1")]


def test_a_refused_back_of_the_state_gives_way_to_always(play: Play) -> None:
    rbd = (
        '<always><expectedevents><event name="back" next="1"/></expectedevents></always>'
        + state("1", "", GO)
        + state("2", "", '<event name="back" next="#back"/>')
    )
    lines = [{"at": 1, "event": "back"}, {"at": 2, "event": "go"}, {"at": 3, "event": "back"}]
    assert play(rbd, lines).states() == [(0, "1"), (1, "1"), (2, "2"), (3, "1")]


# -- live screens ------------------------------------------------------------


def test_a_screen_shown_in_the_step_is_shown_once_more_only_for_what_came_after(
    play: Play,
) -> None:
    rbd = state("1", "", '<event name="go" next="2"><set tag="x">1</set></event>', text("a", "{x}"))
    rbd += state("2", '<set tag="y">1</set>', "", text("b", "{x} {y}"))
    trace = play(rbd, [{"at": 1, "event": "go"}], tags={"x": 0, "y": 0})
    assert trace.lines("screen", since=1) == [
        "1 screen app 2 [b=1 0] <enter",
        "1 screen app 2 [b=1 1] <data",
    ]


def test_a_text_that_changes_and_changes_back_in_one_step_is_not_shown(play: Play) -> None:
    rbd = state("1", "", '<event name="go"><set tag="x">1</set><set tag="x">0</set></event>',
                text("a", "{x}"))  # fmt: skip
    assert play(rbd, [{"at": 1, "event": "go"}], tags={"x": 0}).lines("screen", since=1) == []


def test_a_screen_lost_in_the_step_is_not_shown_live(play: Play) -> None:
    rbd = state("1", "", "", text("a", "{busy}"))
    lines = [{"at": 1, **STOP}, {"at": 2, **GO_ON}]
    trace = play(rbd, lines, pauses="screen")
    assert trace.lines("screen", since=1) == ["2 screen app 1 [a=false] <resume"]


# -- conditions of guards ----------------------------------------------------


def test_a_guards_within_at_its_very_end(play: Play) -> None:
    when = '<when><data tag="x" is="1" within="3"/></when>'
    rbd = state("1", "", f'<event name="go" next="2">{when}</event>') + state("2")
    for at, taken in ((3.999999, True), (4, False)):
        trace = play(rbd, [{"at": 1, "set": {"x": 1}}, {"at": at, "event": "go"}])
        assert (trace.states()[-1][1] == "2") is taken


def test_a_guards_for_at_its_very_beginning(play: Play) -> None:
    when = '<when><data tag="x" is="1" for="3"/></when>'
    rbd = state("1", "", f'<event name="go" next="2">{when}</event>') + state("2")
    for at, taken in ((3.999999, False), (4, True)):
        trace = play(rbd, [{"at": 1, "set": {"x": 1}}, {"at": at, "event": "go"}])
        assert (trace.states()[-1][1] == "2") is taken


def test_an_unnamed_event_whose_within_ends_is_taken_then(play: Play) -> None:
    rbd = state("1", "", '<event next="2"><when><none><data tag="x" exists="true" within="3"/>'
                "</none></when></event>") + state("2")  # fmt: skip
    lines: list[dict[str, Any]] = [{"at": 2, "set": {"x": 1}}, END]
    trace = play(rbd, lines, tags={"x": 0})
    assert trace.lines("transition") == ["5 transition app 1 2 - <data"]


# -- the end of everything ---------------------------------------------------


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
