"""formats.md, *Timeouts*."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.decide.conftest import Play

END: dict[str, Any] = {"at": 100, "end": True}


def state(no: str, timeout: str = "", actions: str = "", events: str = "", screen: str = "") -> str:
    return (
        f'<state no="{no}">{timeout}{screen}<backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def finish(at: float, action: str = "speech") -> dict[str, Any]:
    return {"at": at, "finish": {"action": action}}


def test_a_timeout_leaves_the_state_after_its_seconds(play: Play) -> None:
    trace = play(state("1", '<timeout next="2">2.5</timeout>') + state("2"), [END])
    assert trace.lines(since=1) == [
        "2.5 exit app 1 <enter",
        "2.5 transition app 1 2 timeout <enter",
        "2.5 enter app 2 <transition",
    ]
    assert trace.one("transition")["timeout"] is True
    assert trace.one("transition")["event"] is None


def test_an_event_that_comes_before_stops_it(play: Play) -> None:
    rbd = state("1", '<timeout next="2">3</timeout>', events='<event name="go" next="3"/>')
    trace = play(rbd + state("2") + state("3"), [{"at": 2, "event": "go"}, END])
    assert trace.states() == [(0, "1"), (2, "3")]


def test_each_entry_counts_anew(play: Play) -> None:
    rbd = state("1", '<timeout next="2">3</timeout>', events='<event name="go" next="#again"/>')
    trace = play(rbd + state("2"), [{"at": 2, "event": "go"}, END])
    assert trace.states() == [(0, "1"), (2, "1"), (5, "2")]


def test_an_internal_event_does_not_stop_it(play: Play) -> None:
    rbd = state("1", '<timeout next="2">3</timeout>', events='<event name="go"/>')
    assert play(rbd + state("2"), [{"at": 2, "event": "go"}, END]).states()[-1] == (3, "2")


def test_the_shortest_timeout_is_a_microsecond_so_that_time_goes_on(play: Play) -> None:
    rbd = state("1", '<timeout next="2">0.0000001</timeout>') + state("2")
    assert play(rbd, [END]).states() == [(0, "1"), (0.000001, "2")]


# -- without next ------------------------------------------------------------


def test_without_next_it_raises_timeout_and_counts_anew(play: Play) -> None:
    rbd = state("1", "<timeout>2</timeout>", events='<event name="timeout"><add tag="n">1</add>'
                '</event>')  # fmt: skip
    trace = play(rbd, [{"at": 5, "end": True}])
    assert trace.lines("event", "data") == [
        "2 event app timeout <enter",
        "2 data n 1 app v1 <action",
        "4 event app timeout <enter",
        "4 data n 2 app v2 <action",
    ]


def test_the_event_timeout_can_be_guarded_counted_and_answered(play: Play) -> None:
    rbd = state(
        "1",
        "<timeout>2</timeout>",
        events='<event name="timeout" next="2"><when><data tag="n" atleast="2"/></when></event>'
        '<event name="timeout"><add tag="n">1</add></event>',
    )
    assert play(rbd + state("2"), [END]).states() == [(0, "1"), (6, "2")]


def test_a_timeout_nobody_answers_is_ignored_and_counts_anew(play: Play) -> None:
    trace = play(state("1", "<timeout>2</timeout>"), [{"at": 4, "end": True}])
    assert trace.lines(since=1) == [
        "2 event app timeout <enter",
        "2 ignored app timeout unexpected <event",
        "4 event app timeout <enter",
        "4 ignored app timeout unexpected <event",
    ]


# -- again and back ----------------------------------------------------------


def test_a_timeout_may_enter_its_state_anew(play: Play) -> None:
    trace = play(state("1", '<timeout next="#again">2</timeout>'), [{"at": 5, "end": True}])
    assert trace.states() == [(0, "1"), (2, "1"), (4, "1")]


def test_a_timeout_may_go_back(play: Play) -> None:
    rbd = (
        state("1", events='<event name="go" next="2"/>')
        + state("2", events='<event name="go" next="3"/>')
        + state("3", '<timeout next="#back">2</timeout>')
    )
    trace = play(rbd, [{"at": 1, "event": "go"}, {"at": 2, "event": "go"}, END])
    assert trace.states() == [(0, "1"), (1, "2"), (2, "3"), (4, "2")]


def test_a_timeout_that_can_not_go_back_is_refused_and_counts_anew(play: Play) -> None:
    trace = play(state("1", '<timeout next="#back">2</timeout>'), [{"at": 5, "end": True}])
    assert trace.lines(since=1) == [
        "2 ignored app timeout guard <enter",
        "4 ignored app timeout guard <enter",
    ]


# -- suspension --------------------------------------------------------------


def test_it_stands_still_while_suspended_and_then_goes_on(play: Play) -> None:
    rbd = state("1", '<timeout next="2">3</timeout>', "<speech>A</speech>") + state("2")
    lines = [{"at": 2, "set": {"busy": True}}, {"at": 12, "set": {"busy": False}}, END]
    trace = play(rbd, lines, pauses="speech")
    assert trace.lines("resume", "exit", "transition", "enter", since=3) == [
        "12 resume app [] <authority",
        "13 exit app 1 <resume",
        "13 transition app 1 2 timeout <resume",
        "13 enter app 2 <transition",
    ]


def test_of_a_state_entered_suspended_it_begins_with_the_resume(play: Play) -> None:
    rbd = state("1", '<timeout next="2">3</timeout>', "<speech>A</speech>") + state("2")
    lines = [{"at": 5, "set": {"busy": False}}, END]
    trace = play(rbd, lines, pauses="speech", tags={"busy": True})
    assert trace.lines("suspend", "transition") == [
        "0 suspend app [speech] <acquire",
        "8 transition app 1 2 timeout <resume",
    ]


# -- idle --------------------------------------------------------------------

IDLE = '<timeout next="2" idle="true">3</timeout>'
SCREEN = """<screen><components><button id="b" x="1" y="1" width="1" height="1">B</button>
<input id="in" x="1" y="1" width="1" height="1" tag="x" kind="text"/></components></screen>"""


def test_idle_stands_still_while_the_state_speaks_and_counts_anew_from_the_end(play: Play) -> None:
    rbd = state("1", IDLE, "<speech>A</speech>") + state("2")
    assert play(rbd, [finish(7), END]).states() == [(0, "1"), (10, "2")]


def test_idle_waits_for_all_speeches_in_a_row(play: Play) -> None:
    rbd = state("1", IDLE, "<speech>A</speech><speech>B</speech>") + state("2")
    assert play(rbd, [finish(2), finish(9), END]).states() == [(0, "1"), (12, "2")]


def test_idle_counts_anew_from_a_speech_that_comes_later(play: Play) -> None:
    rbd = state("1", IDLE, '<launch program="p" wait="true"/><speech>A</speech>') + state("2")
    trace = play(rbd, [finish(2, "launch"), finish(9), END])
    assert trace.states() == [(0, "1"), (12, "2")]


def test_idle_is_not_stopped_by_a_sound(play: Play) -> None:
    rbd = state("1", IDLE, '<sound src="a.ogg"/>') + state("2")
    assert play(rbd, [END]).states() == [(0, "1"), (3, "2")]


@pytest.mark.parametrize(
    "given",
    [
        {"touch": True},
        {"use": {"component": "b"}},
        {"use": {"component": "in", "value": "a"}},
        {"set": {"heard": {"text": "no such phrase", "confidence": 0.9}}},
    ],
)
def test_idle_counts_anew_from_every_touch_typing_and_utterance(
    play: Play, given: dict[str, Any]
) -> None:
    rbd = state("1", IDLE, "", '<event name="a"><say>yes</say></event>', SCREEN) + state("2")
    trace = play(rbd, [{"at": 2, **given}, END])
    assert trace.states() == [(0, "1"), (5, "2")]
    assert trace.lines("transition") == ["5 transition app 1 2 timeout <enter"]


@pytest.mark.parametrize("given", [{"event": "a"}, {"set": {"x": "a"}}])
def test_idle_does_not_count_anew_from_a_scenarios_event(play: Play, given: dict[str, Any]) -> None:
    rbd = state("1", IDLE, "", '<event name="a"/>', SCREEN) + state("2")
    assert play(rbd, [{"at": 2, **given}, END]).states() == [(0, "1"), (3, "2")]


def test_a_timeout_that_is_not_idle_minds_no_touch_and_no_speech(play: Play) -> None:
    rbd = state("1", '<timeout next="2">3</timeout>', "<speech>A</speech>", "", SCREEN)
    assert play(rbd + state("2"), [{"at": 2, "touch": True}, END]).states()[-1] == (3, "2")


def test_a_touch_while_the_state_speaks_does_not_start_an_idle_timeout(play: Play) -> None:
    rbd = state("1", IDLE, "<speech>A</speech>", "", SCREEN) + state("2")
    assert play(rbd, [{"at": 1, "touch": True}, finish(9), END]).states()[-1] == (12, "2")


def test_repeat_stops_an_idle_timeout_until_it_is_said(play: Play) -> None:
    rbd = state("1", IDLE, "<speech>A</speech>", '<event name="r"><repeat/></event>') + state("2")
    trace = play(rbd, [finish(1), {"at": 3, "event": "r"}, finish(9), END])
    assert trace.states() == [(0, "1"), (12, "2")]


def test_idle_goes_on_when_an_optional_speech_loses_its_voice(play: Play) -> None:
    rbd = state("1", IDLE, '<speech optional="true">A</speech>') + state("2")
    spds = """<modules><module name="app" resources="speech"/>
      <module name="m" resources="speech"/></modules>
      <situation name="s"><module name="m" priority="2"/><module name="app" priority="1"/>
      </situation>"""
    lines = [{"at": 5, "acquire": {"module": "m", "resources": ["speech"]}}, END]
    assert play(rbd, lines, spds=spds).states() == [(0, "1"), (8, "2")]


def test_idle_after_a_suspension_waits_for_the_speech_that_began_again(play: Play) -> None:
    rbd = state("1", IDLE, "<speech>A</speech>") + state("2")
    lines = [
        {"at": 2, "set": {"busy": True}},
        {"at": 10, "set": {"busy": False}},
        finish(20),
        END,
    ]
    assert play(rbd, lines, pauses="speech").states() == [(0, "1"), (23, "2")]


def test_idle_goes_on_after_a_suspension_where_nothing_is_said(play: Play) -> None:
    rbd = state("1", IDLE, "<speech>A</speech>") + state("2")
    lines = [
        finish(1),
        {"at": 3, "set": {"busy": True}},
        {"at": 10, "set": {"busy": False}},
        END,
    ]
    # Two of its three seconds had passed.
    assert play(rbd, lines, pauses="speech").states() == [(0, "1"), (11, "2")]


def test_idle_without_next_counts_anew_after_its_event(play: Play) -> None:
    rbd = state(
        "1",
        '<timeout idle="true">3</timeout>',
        "<speech>A</speech>",
        '<event name="timeout"><repeat/></event>',
    )
    trace = play(rbd, [finish(1), finish(6), END | {"at": 9}])
    assert [e["t"] for e in trace.of("event", name="timeout")] == [4, 9]
