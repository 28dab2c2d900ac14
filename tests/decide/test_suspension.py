"""formats.md, *SPDS*: an application that does not hold all that its state uses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.decide.conftest import Play

RESOURCES = ("acquire", "abandon", "authority", "mapping", "situation", "condition")
END: dict[str, Any] = {"at": 100, "end": True}
STOP: dict[str, Any] = {"set": {"busy": True}}
GO_ON: dict[str, Any] = {"set": {"busy": False}}
SCREEN = """<screen><components><text id="t" x="1" y="1" width="1" height="1">T</text></components>
</screen>"""


def state(no: str, actions: str = "", events: str = "", inside: str = "") -> str:
    return (
        f'<state no="{no}">{inside}<backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def finish(at: float, action: str, name: str | None = None) -> dict[str, Any]:
    named = {} if name is None else {"name": name}
    return {"at": at, "finish": {"action": action, **named}}


EVERYTHING = (
    '<speech done="said">A</speech><robot resource="head" command="nod" done="nodded"/>'
    '<launch program="p" done="closed"/>'
)


# -- becoming suspended ------------------------------------------------------


def test_while_it_does_not_hold_all_it_is_suspended(play: Play) -> None:
    spds = """<modules><module name="app" resources="speech head"/>
      <module name="m" resources="head"/></modules><situation name="s">
      <module name="m" priority="2"/><module name="app" priority="1"/></situation>"""
    lines = [{"at": 1, "acquire": {"module": "m", "resources": ["head"]}}]
    assert play(state("1", EVERYTHING), lines, spds=spds).lines(since=1) == [
        "1 acquire m [head] <-",
        "1 authority head app m <acquire",
        "1 mapping head m null <authority",
        "1 authority speech app - <acquire",
        "1 mapping speech - null <authority",
        "1 suspend app [head speech] <authority^1",
        "1 cancelled app speech - <suspend",
        "1 cancelled app robot nod <suspend",
    ]


def test_a_state_that_uses_nothing_is_never_suspended(play: Play) -> None:
    trace = play(state("1", "<set tag='x'>1</set>"), [{"at": 1, **STOP}], pauses="head")
    assert trace.of("suspend") == []


def test_whether_it_is_suspended_stands_on_the_blackboard(play: Play) -> None:
    rbd = [
        f'<application name="app">{state("1", "<speech>A</speech>")}</application>',
        """<application name="b"><state no="1"><expectedevents><event next="2"><when>
        <data tag="application/app.suspended" is="true"/></when></event></expectedevents></state>
        <state no="2"><expectedevents><event next="1"><when>
        <data tag="application/app.suspended" is="false"/></when></event></expectedevents></state>
        </application>""",
    ]
    spds = """<modules><module name="app" resources="speech"/><module name="b" resources=""/>
      </modules><situation name="busy"><condition><data tag="busy" is="true"/></condition>
      <module name="b" priority="1"/></situation><situation name="calm">
      <module name="app" priority="1"/><module name="b" priority="1"/></situation>"""
    trace = play(rbd, [{"at": 1, **STOP}, {"at": 2, **GO_ON}], spds=spds)
    assert trace.states("b") == [(0, "1"), (1, "2"), (2, "1")]
    assert trace.lines("transition") == [
        "1 transition b 1 2 - <suspend",
        "2 transition b 2 1 - <resume",
    ]


# -- while suspended ---------------------------------------------------------


def test_services_and_launches_run_on_and_their_events_wait(play: Play) -> None:
    rbd = state(
        "1",
        '<speech>A</speech><service name="s" url="http://x/" done="got"><result tag="r"/></service>'
        '<launch program="p" done="closed"/>',
        '<event name="got" next="2"/>',
    ) + state("2", "<speech>B</speech>", '<event name="closed"><set tag="x">1</set></event>')
    lines = [
        {"at": 1, **STOP},
        {"at": 2, "finish": {"action": "service", "result": 5}},
        finish(3, "launch"),
        {"at": 4, **GO_ON},
    ]
    trace = play(rbd, lines, pauses="speech")
    assert trace.lines("finished", "event", "data", "transition", "ignored", since=2) == [
        "2 finished app service s ok 5 <-",
        '2 data service/s {"ok":true,"status":null,"error":null} app v1 <finished',
        "2 data r 5 app v1 <finished",
        "3 finished app launch p ok null <-",
        "4 data busy false scenario v2 <-",
        "4 event app resumed <resume",
        "4 event app got <finished^1",
        "4 transition app 1 2 got <event",
        "4 event app closed <finished",
        "4 data x 1 app v1 <action",
        "4 finished app set - ok null <action",
    ]


def test_any_other_event_is_ignored(play: Play) -> None:
    rbd = state("1", "<speech>A</speech>", '<event name="go" next="2"/>') + state("2")
    lines = [{"at": 1, **STOP}, {"at": 2, "event": "go"}, {"at": 3, **GO_ON}]
    trace = play(rbd, lines, pauses="speech")
    assert trace.lines("ignored") == ["2 ignored app go suspended <event"]
    assert trace.states() == [(0, "1")]


def test_it_judges_no_unnamed_event(play: Play) -> None:
    when = '<when><data tag="x" is="1"/></when>'
    rbd = state("1", "<speech>A</speech>", f'<event next="2">{when}</event>') + state("2")
    lines = [{"at": 1, **STOP}, {"at": 2, "set": {"x": 1}}, {"at": 3, **GO_ON}]
    assert play(rbd, lines, pauses="speech").lines("transition") == [
        "3 transition app 1 2 - <resume"
    ]
    lines[2:2] = [{"at": 2.5, "set": {"x": 2}}]
    assert play(rbd, lines, pauses="speech").states() == [(0, "1")]


def test_the_event_timeout_waits_for_the_resume_too(play: Play) -> None:
    """Its clock stands still; the fifth second comes after the resume."""
    rbd = state(
        "1", "<speech>A</speech>", '<event name="timeout" next="2"/>',
        '<timeout>5</timeout>',
    ) + state("2")  # fmt: skip
    trace = play(rbd, [{"at": 4, **STOP}, {"at": 9, **GO_ON}, END], pauses="speech")
    assert trace.states() == [(0, "1"), (10, "2")]


def test_nothing_new_begins_while_suspended(play: Play) -> None:
    """What waits behind a service that ends meanwhile begins with the resume."""
    rbd = state(
        "1", '<service name="s" url="http://x/" wait="true"/><set tag="x">1</set><speech>A</speech>'
    )
    lines = [{"at": 1, **STOP}, finish(2, "service"), {"at": 3, **GO_ON}]
    trace = play(rbd, lines, pauses="speech")
    assert trace.lines("action", since=1) == [
        '3 action app 1 set - tag="x" value=1 <resume',
        '3 action app 1 speech - text="A" <resume',
    ]


def test_what_an_event_began_goes_on_with_the_resume_of_a_state_entered_suspended(
    play: Play,
) -> None:
    rbd = state(
        "1",
        "",
        '<event name="go" next="2"><service name="s" url="http://x/" wait="true"/>'
        '<set tag="x">1</set></event>',
    ) + state("2", '<speech>A</speech><set tag="y">1</set>')
    lines: list[dict[str, Any]] = [
        {"at": 1, "event": "go"},
        finish(2, "service"),
        {"at": 3, **GO_ON},
    ]
    trace = play(rbd, lines, pauses="speech", tags={"busy": True})
    assert trace.lines("action", since=2) == [
        '3 action app 2 set - tag="x" value=1 <resume',
        '3 action app 2 speech - text="A" <resume',
        '3 action app 2 set - tag="y" value=1 <resume',
    ]


# -- resuming ----------------------------------------------------------------


def test_resumed_comes_first_then_the_screen_then_what_was_cancelled(play: Play) -> None:
    rbd = state("1", EVERYTHING, inside=f'<timeout next="2">5</timeout>{SCREEN}') + state("2")
    lines = [{"at": 1, **STOP}, {"at": 3, **GO_ON}, {"at": 6, "end": True}]
    trace = play(rbd, lines, pauses="speech head screen")
    assert trace.lines(since=3, but=("authority",)) == [
        "3 data busy false scenario v2 <-",
        "3 condition busy false <data",
        "3 situation busy calm <condition",
        "3 resume app [] <authority",
        "3 event app resumed <resume",
        "3 screen app 1 [t=T] <resume",
        "3 mapping screen app [t=T] <screen",
        '3 action app 1 speech - text="A" <resume',
        '3 mapping speech app {"text":"A","lang":null} <action',
        '3 action app 1 robot nod resource="head" <resume',
        '3 mapping head app {"command":"nod","params":{}} <action',
    ]
    # The timeout goes on: one of its five seconds had passed.
    trace = play(rbd, [*lines[:2], END], pauses="speech head screen")
    assert trace.lines("transition") == ["7 transition app 1 2 timeout <resume"]


def test_what_had_ended_is_not_repeated(play: Play) -> None:
    rbd = state("1", '<speech>A</speech><speech>B</speech><robot resource="head" command="nod"/>')
    lines = [
        finish(1, "speech"),
        finish(1, "robot"),
        {"at": 2, **STOP},
        {"at": 3, **GO_ON},
    ]
    trace = play(rbd, lines, pauses="speech head")
    assert trace.lines("action", since=2) == ['3 action app 1 speech - text="B" <resume']


def test_what_waited_for_the_voice_waits_again_in_its_place(play: Play) -> None:
    rbd = state("1", '<speech>A</speech><sound src="b.ogg"/><speech>C</speech>')
    lines = [
        {"at": 1, **STOP},
        {"at": 2, **GO_ON},
        *(finish(3 + i, action) for i, action in enumerate(("speech", "sound"))),
    ]
    trace = play(rbd, lines, pauses="speech")
    assert trace.lines("action") == [
        '0 action app 1 speech - text="A" <enter',
        '2 action app 1 speech - text="A" <resume',
        '3 action app 1 sound - src="b.ogg" <finished',
        '4 action app 1 speech - text="C" <finished',
    ]


def test_what_waits_for_an_action_begun_again_waits_on(play: Play) -> None:
    rbd = state("1", '<robot resource="head" command="nod" wait="true"/><set tag="x">1</set>')
    lines = [{"at": 1, **STOP}, {"at": 2, **GO_ON}, finish(3, "robot")]
    trace = play(rbd, lines, pauses="head")
    assert trace.lines("action", since=2) == [
        '2 action app 1 robot nod resource="head" <resume',
        '3 action app 1 set - tag="x" value=1 <finished',
    ]


def test_texts_are_filled_in_anew(play: Play) -> None:
    rbd = state("1", "<speech>{x}</speech>")
    lines = [{"at": 1, **STOP}, {"at": 2, "set": {"x": "new"}}, {"at": 3, **GO_ON}]
    trace = play(rbd, lines, pauses="speech", tags={"x": "old"})
    assert [e["text"] for e in trace.of("action")] == ["old", "new"]


# -- the event resumed -------------------------------------------------------


def test_resumed_is_never_ignored(play: Play) -> None:
    lines = [{"at": 1, **STOP}, {"at": 2, **GO_ON}]
    trace = play(state("1", "<speech>A</speech>"), lines, pauses="speech")
    assert trace.lines("event", "ignored") == ["2 event app resumed <resume"]
    guarded = '<event name="resumed" next="1"><when><data tag="x" is="1"/></when></event>'
    trace = play(state("1", "<speech>A</speech>", guarded), lines, pauses="speech")
    assert trace.lines("event", "ignored") == ["2 event app resumed <resume"]


def test_without_next_its_actions_run_and_the_resume_goes_on(play: Play) -> None:
    rbd = state("1", "<speech>A</speech>", '<event name="resumed"><add tag="n">1</add></event>')
    lines = [{"at": 1, **STOP}, {"at": 2, **GO_ON}]
    assert play(rbd, lines, pauses="speech").lines(since=2, but=RESOURCES)[1:] == [
        "2 resume app [] <authority",
        "2 event app resumed <resume",
        '2 action app 1 add - tag="n" value=1 <event',
        "2 data n 1 app v1 <action",
        "2 finished app add - ok null <action",
        '2 action app 1 speech - text="A" <resume',
    ]


def test_an_expected_event_may_leave_the_state_instead(play: Play) -> None:
    rbd = state(
        "1",
        '<speech>A</speech><launch program="p"/>',
        '<event name="resumed" next="2"/>',
        SCREEN,
    ) + state("2", "<speech>B</speech>")
    lines = [{"at": 1, **STOP}, {"at": 2, **GO_ON}]
    trace = play(rbd, lines, pauses="speech screen")
    assert trace.lines(since=2, but=RESOURCES)[1:] == [
        "2 resume app [] <authority",
        "2 event app resumed <resume",
        "2 exit app 1 <event",
        "2 cancelled app launch p <exit",
        "2 transition app 1 2 resumed <event",
        "2 enter app 2 <transition",
        # The kept screen is shown again.
        "2 screen app 2 [t=T] <enter",
        '2 action app 2 speech - text="B" <enter',
    ]


def test_always_may_answer_resumed(play: Play) -> None:
    rbd = (
        '<always><expectedevents><event name="resumed" next="2"/></expectedevents></always>'
        + state("1", "<speech>A</speech>")
        + state("2")
    )
    trace = play(rbd, [{"at": 1, **STOP}, {"at": 2, **GO_ON}], pauses="speech")
    assert trace.states() == [(0, "1"), (2, "2")]


# -- entered suspended -------------------------------------------------------


def test_a_state_entered_without_its_resources_is_entered_suspended(play: Play) -> None:
    spds = """<modules><module name="app" resources="speech head screen"/>
      <module name="m" resources="head"/></modules><situation name="s">
      <module name="m" priority="2"/><module name="app" priority="1"/></situation>"""
    rbd = state("1", "<speech>A</speech>", '<event name="go" next="2"><set tag="x">1</set></event>')
    rbd += state(
        "2",
        '<set tag="y">1</set><robot resource="head" command="nod"/>',
        inside='<timeout next="1">5</timeout>' + SCREEN,
    )
    lines: list[dict[str, Any]] = [
        {"at": 0, "acquire": {"module": "m", "resources": ["head"]}},
        {"at": 1, "event": "go"},
        {"at": 3, "abandon": {"module": "m", "resources": ["head"]}},
        {"at": 9, "end": True},
    ]
    trace = play(rbd, lines, spds=spds)
    assert trace.lines(since=1)[:19] == [
        "1 event app go <-",
        "1 exit app 1 <event",
        "1 cancelled app speech - <exit",
        "1 mapping speech app null <cancelled",
        "1 transition app 1 2 go <event",
        '1 action app 2 set - tag="x" value=1 <transition',
        "1 data x 1 app v1 <action",
        "1 finished app set - ok null <action",
        "1 enter app 2 <transition",
        "1 acquire app [head screen] <enter",
        "1 authority speech app - <acquire",
        "1 suspend app [head screen] <acquire",
        "3 abandon m [head] <-",
        "3 authority head m app <abandon",
        "3 authority screen - app <abandon",
        "3 resume app [] <authority",
        "3 event app resumed <resume",
        "3 screen app 2 [t=T] <resume",
        "3 mapping screen app [t=T] <screen",
    ]
    assert trace.lines("action", "transition", since=3) == [
        '3 action app 2 set - tag="y" value=1 <resume',
        '3 action app 2 robot nod resource="head" <resume',
        "8 transition app 2 1 timeout <resume",
        '8 action app 1 speech - text="A" <enter',
    ]


def test_at_the_start_too(play: Play) -> None:
    trace = play(
        state("1", "<speech>A</speech>"), [{"at": 1, **GO_ON}], pauses="speech", tags={"busy": True}
    )
    assert trace.lines("enter", "suspend", "resume", "action") == [
        "0 enter app 1 <-",
        "0 suspend app [speech] <acquire",
        "1 resume app [] <authority",
        '1 action app 1 speech - text="A" <resume',
    ]


@pytest.mark.parametrize("times", [2, 5])
def test_it_may_be_suspended_again_and_again(play: Play, times: int) -> None:
    rbd = state("1", "<speech>A</speech>", inside='<timeout next="2">10</timeout>') + state("2")
    lines = [{"at": t, **(GO_ON if t % 2 == 0 else STOP)} for t in range(1, 2 * times + 1)]
    trace = play(rbd, [*lines, END], pauses="speech")
    assert len(trace.of("action")) == times + 1
    assert trace.states()[-1] == (10 + times, "2")
