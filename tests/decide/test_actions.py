"""formats.md, *Actions*."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tests.decide.conftest import Play

RESOURCES = ("acquire", "abandon", "authority", "mapping")
GO = '<event name="go" next="2"/>'


def state(no: str, actions: str, events: str = "") -> str:
    return (
        f'<state no="{no}"><backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def finish(at: float, action: str, name: str | None = None, **more: Any) -> dict[str, Any]:
    named = {} if name is None else {"name": name}
    return {"at": at, "finish": {"action": action, **named, **more}}


# -- order, wait, done and failed --------------------------------------------


def test_actions_run_in_document_order_without_waiting(play: Play) -> None:
    rbd = state("1", '<speech>A</speech><launch program="p"/><set tag="x">1</set>')
    assert play(rbd, []).lines("action") == [
        '0 action app 1 speech - text="A" <enter',
        "0 action app 1 launch p <enter",
        '0 action app 1 set - tag="x" value=1 <enter',
    ]


@pytest.mark.parametrize(("ok", "event"), [(True, "well"), (False, "badly")])
def test_those_after_a_wait_start_when_it_has_ended_before_its_event_is_judged(
    play: Play, ok: bool, event: str
) -> None:
    rbd = state(
        "1",
        '<launch program="p" wait="true" done="well" failed="badly"/><set tag="x">1</set>',
        '<event name="well" next="2"/><event name="badly" next="2"/>',
    )
    trace = play(rbd + '<state no="2"/>', [finish(2, "launch", ok=ok)])
    assert trace.lines("action", since=0)[0] == "0 action app 1 launch p <enter"
    assert trace.lines(since=2) == [
        f"2 finished app launch p {'ok' if ok else 'failed'} null <-",
        '2 action app 1 set - tag="x" value=1 <finished',
        "2 data x 1 app v1 <action",
        "2 finished app set - ok null <action",
        f"2 event app {event} <finished^1",
        "2 exit app 1 <event",
        f"2 transition app 1 2 {event} <event",
        "2 enter app 2 <transition",
    ]


def test_waits_follow_each_other(play: Play) -> None:
    rbd = state(
        "1",
        '<launch program="a" wait="true"/><launch program="b"/><launch program="c" wait="true"/>'
        '<launch program="d"/>',
    )
    lines = [finish(1, "launch", "a"), finish(2, "launch", "b"), finish(3, "launch", "c")]
    assert [(e["t"], e["name"]) for e in play(rbd, lines).of("action")] == [
        (0, "a"), (1, "b"), (1, "c"), (3, "d"),
    ]  # fmt: skip


def test_done_is_raised_when_it_ends_well_and_failed_when_badly(play: Play) -> None:
    rbd = state("1", '<launch program="p" done="well" failed="badly"/>')
    assert play(rbd, [finish(1, "launch")]).lines("event") == ["1 event app well <finished"]
    trace = play(rbd, [finish(1, "launch", ok=False, error="no")])
    assert trace.lines("finished", "event") == [
        '1 finished app launch p failed "no" <-',
        "1 event app badly <finished",
    ]


def test_what_still_runs_is_cancelled_without_event_when_the_state_is_left(play: Play) -> None:
    rbd = state(
        "1",
        '<speech done="d" failed="f">A</speech><robot resource="head" command="nod" failed="f"/>'
        '<service name="s" url="http://x/" failed="f"/><launch program="p" failed="f"/>'
        '<launch program="q" wait="true"/><set tag="x">1</set>',
        GO,
    )
    trace = play(rbd + '<state no="2"/>', [{"at": 1, "event": "go"}])
    assert trace.lines(since=1, but=RESOURCES) == [
        "1 event app go <-",
        "1 exit app 1 <event",
        "1 cancelled app speech - <exit",
        "1 cancelled app robot nod <exit",
        "1 cancelled app service s <exit",
        "1 cancelled app launch p <exit",
        "1 cancelled app launch q <exit",
        "1 transition app 1 2 go <event",
        "1 enter app 2 <transition",
    ]


def test_a_service_or_launch_with_keep_outlives_its_state(play: Play) -> None:
    rbd = state(
        "1",
        '<service name="s" url="http://x/" keep="true" done="got"><result tag="r"/></service>'
        '<launch program="p" keep="true" done="closed"/>',
        GO,
    ) + state("2", "", '<event name="got" next="1"/>')
    lines = [
        {"at": 1, "event": "go"},
        finish(2, "launch"),
        finish(3, "service", result=7),
    ]
    trace = play(rbd, lines)
    assert trace.lines("cancelled") == []
    assert trace.lines("event", "ignored", "data", "transition", since=2) == [
        "2 event app closed <finished",
        "2 ignored app closed unexpected <event",
        '3 data service/s {"ok":true,"status":null,"error":null} app v1 <finished',
        "3 data r 7 app v1 <finished",
        "3 event app got <finished",
        "3 transition app 2 1 got <event",
    ]


def test_what_waits_behind_a_kept_action_is_dropped_with_its_state(play: Play) -> None:
    rbd = state("1", '<launch program="p" keep="true" wait="true"/><set tag="x">1</set>', GO)
    trace = play(rbd + '<state no="2"/>', [{"at": 1, "event": "go"}, finish(2, "launch")])
    assert trace.lines("action", since=1) == []


# -- what they use -----------------------------------------------------------


def test_speech_and_sound_use_speech_and_a_robot_its_resource(play: Play) -> None:
    rbd = state("1", '<sound src="a.ogg"/><robot resource="base" command="goto"/>')
    assert play(rbd, []).lines("acquire") == ["0 acquire app [base speech] <enter"]
    assert play(state("1", "<speech>A</speech>"), []).lines("acquire") == [
        "0 acquire app [speech] <enter"
    ]


def test_services_launches_and_messages_use_no_resource(play: Play) -> None:
    rbd = state(
        "1",
        '<service name="s" url="http://x/"/><launch program="p"/><message topic="t"/>'
        '<set tag="x">1</set><clear tag="x"/>',
    )
    assert play(rbd, []).lines("acquire", "authority") == []


# -- optional ----------------------------------------------------------------

ONE_HEAD = """<modules><module name="app" resources="head speech screen"/>
  <module name="m" resources="head speech"/></modules>
  <situation name="s"><module name="m" priority="2"/><module name="app" priority="1"/></situation>
"""
OPTIONAL = (
    '<robot resource="head" command="nod" optional="true" wait="true" done="d" failed="f"/>'
    '<set tag="x">1</set>'
)
TAKE = {"acquire": {"module": "m", "resources": ["head"]}}
GIVE = {"abandon": {"module": "m", "resources": ["head"]}}


def test_an_optional_action_never_suspends_where_its_resource_is_not_held(play: Play) -> None:
    rbd = state("1", "", GO) + state("2", OPTIONAL)
    trace = play(rbd, [{"at": 0, **TAKE}, {"at": 1, "event": "go"}], spds=ONE_HEAD)
    assert trace.lines(since=1)[3:] == [
        "1 enter app 2 <transition",
        "1 acquire app [] [head] <enter",
        "1 cancelled app robot nod <enter",
        '1 action app 2 set - tag="x" value=1 <cancelled',
        "1 data x 1 app v1 <action",
        "1 finished app set - ok null <action",
    ]


def test_an_optional_action_whose_resource_is_lost_is_cancelled_for_good(play: Play) -> None:
    trace = play(state("1", OPTIONAL), [{"at": 1, **TAKE}, {"at": 2, **GIVE}], spds=ONE_HEAD)
    assert trace.lines(since=1) == [
        "1 acquire m [head] <-",
        "1 authority head app m <acquire",
        "1 mapping head m null <authority",
        "1 cancelled app robot nod <authority",
        '1 action app 1 set - tag="x" value=1 <cancelled',
        "1 data x 1 app v1 <action",
        "1 finished app set - ok null <action",
        "2 abandon m [head] <-",
        "2 authority head m app <abandon",
    ]


def test_an_optional_action_is_not_begun_again_after_a_suspension(play: Play) -> None:
    rbd = state(
        "1",
        '<robot resource="head" command="nod" optional="true" wait="true" failed="f"/>'
        "<speech>A</speech>",
    )
    lines = [{"at": 1, "set": {"busy": True}}, {"at": 2, "set": {"busy": False}}]
    trace = play(rbd, lines, pauses="head speech")
    assert trace.lines("action", "cancelled", "resume", "event") == [
        '0 action app 1 robot nod resource="head" <enter',
        "1 cancelled app robot nod <suspend",
        "2 resume app [] <authority",
        "2 event app resumed <resume",
        '2 action app 1 speech - text="A" <resume',
    ]


def test_after_a_lost_optional_speech_the_next_takes_its_turn(play: Play) -> None:
    rbd = state("1", '<speech optional="true">A</speech><sound src="b.ogg" optional="true"/>')
    lines = [{"at": 1, "acquire": {"module": "m", "resources": ["speech"]}}]
    trace = play(rbd, lines, spds=ONE_HEAD)
    assert trace.lines("action", "cancelled") == [
        '0 action app 1 speech - text="A" <enter',
        "1 cancelled app speech - <authority",
        "1 cancelled app sound - <cancelled",
    ]


# -- the voice ---------------------------------------------------------------


def test_speeches_and_sounds_queue_and_are_filled_in_when_their_turn_comes(play: Play) -> None:
    rbd = state(
        "1",
        '<speech done="said">One</speech><sound src="a.ogg"/><speech>Three {x}</speech>'
        '<set tag="x">1</set>',
    )
    lines = [finish(1, "speech"), {"at": 2, "set": {"x": 2}}, finish(3, "sound")]
    trace = play(rbd, lines)
    assert trace.lines("action", "finished", "event") == [
        '0 action app 1 speech - text="One" <enter',
        '0 action app 1 set - tag="x" value=1 <enter',
        "0 finished app set - ok null <action",
        "1 finished app speech - ok null <-",
        '1 action app 1 sound - src="a.ogg" <finished',
        "1 event app said <finished",
        "3 finished app sound - ok null <-",
        '3 action app 1 speech - text="Three 2" <finished',
    ]


def test_a_speech_that_waits_for_its_turn_is_dropped_with_its_state(play: Play) -> None:
    rbd = state("1", "<speech>One</speech><speech>Two</speech>", GO) + state("2", "")
    trace = play(rbd, [{"at": 1, "event": "go"}])
    assert trace.lines("action", "cancelled") == [
        '0 action app 1 speech - text="One" <enter',
        "1 cancelled app speech - <exit",
    ]


def test_a_wait_on_a_queued_speech_is_a_wait_for_its_end(play: Play) -> None:
    rbd = state("1", '<speech>A</speech><speech wait="true">B</speech><set tag="x">1</set>')
    trace = play(rbd, [finish(1, "speech"), finish(2, "speech")])
    assert [(e["t"], e["action"]) for e in trace.of("action")] == [
        (0, "speech"), (1, "speech"), (2, "set"),
    ]  # fmt: skip


def test_the_voices_of_two_applications_do_not_queue_behind_each_other(play: Play) -> None:
    one = '<application name="{}">{}</application>'
    say = state("1", '<speech optional="true">A</speech>')
    spds = """<modules><module name="a" resources="speech"/><module name="b" resources="speech"/>
      </modules><situation name="s"><module name="a" priority="2"/>
      <module name="b" priority="1"/></situation>"""
    trace = play([one.format("a", say), one.format("b", say)], [], spds=spds)
    assert trace.lines("action", "cancelled") == [
        '0 action a 1 speech - text="A" <enter',
        "0 cancelled b speech - <enter",
    ]


def test_speech_speaks_the_language_of_the_tag_unless_lang_says_otherwise(play: Play) -> None:
    rbd = state("1", '<speech>Hello</speech><speech lang="en">Yes</speech>')
    trace = play(
        rbd,
        [finish(1, "speech")],
        tags={"language": "ja"},
        languages=("en", "ja"),
        texts={"ja": {"Hello": "こんにちは", "Yes": "はい"}},
    )
    assert trace.lines("action") == [
        '0 action app 1 speech - text="こんにちは" lang="ja" <enter',
        '1 action app 1 speech - text="Yes" lang="en" <finished',
    ]


def test_a_missing_translation_falls_back_with_a_warning(play: Play) -> None:
    rbd = state("1", "<speech>Hello</speech>")
    trace = play(rbd, [], tags={"language": "ja"}, languages=("en", "ja"), texts={"ja": {}})
    assert trace.of("action")[0]["text"] == "Hello"
    assert [(e["kind"], e["where"]) for e in trace.of("warning")] == [("warning", "app, state 1")]


@pytest.mark.parametrize(("text", "told"), [("{n} / 7 %", 0), ("{n} mm", 1)])
def test_a_text_without_a_word_misses_no_translation(play: Play, text: str, told: int) -> None:
    rbd = state("1", f"<speech>{text}</speech>")
    tags = {"language": "ja", "n": 3}
    trace = play(rbd, [], tags=tags, languages=("en", "ja"), texts={"ja": {}})
    assert trace.of("action")[0]["text"] == text.replace("{n}", "3")
    assert len(trace.of("warning")) == told


def test_the_words_to_translate_are_the_text_as_written_references_included(play: Play) -> None:
    rbd = state("1", "<speech>Hello {n}</speech>")
    trace = play(
        rbd,
        [],
        tags={"language": "ja", "n": "Ann"},
        languages=("en", "ja"),
        texts={"ja": {"Hello {n}": "{n}さん、こんにちは"}},
    )
    assert trace.of("action")[0]["text"] == "Annさん、こんにちは"


# -- robots ------------------------------------------------------------------


def test_a_second_robot_action_on_a_resource_cancels_the_first(play: Play) -> None:
    rbd = state(
        "1",
        '<robot resource="base" command="goto" failed="f"><param name="place">lobby</param>'
        '</robot><robot resource="head" command="nod"/><robot resource="base" command="turn"/>',
    )
    trace = play(rbd, [])
    assert trace.lines("action", "cancelled", "mapping", "event") == [
        '0 action app 1 robot goto resource="base" params={"place":"lobby"} <enter',
        '0 mapping base app {"command":"goto","params":{"place":"lobby"}} <action',
        '0 action app 1 robot nod resource="head" <enter',
        '0 mapping head app {"command":"nod","params":{}} <action',
        "0 cancelled app robot goto <enter",
        '0 action app 1 robot turn resource="base" <enter',
        '0 mapping base app {"command":"turn","params":{}} <action',
    ]


# -- those that end at once --------------------------------------------------


def test_those_that_end_at_once_raise_done(play: Play) -> None:
    rbd = state(
        "1",
        '<set tag="a" done="d1">1</set><add tag="b" done="d2">1</add><append tag="c" done="d3">1'
        '</append><take from="c" tag="d" done="d4"/><clear tag="a" done="d5"/>'
        '<message topic="t" done="d6"/>',
    )
    trace = play(rbd, [])
    assert [e["name"] for e in trace.of("event")] == ["d1", "d2", "d3", "d4", "d5", "d6"]
    assert [e["t"] for e in trace.of("finished")] == [0] * 6
    assert [trace.chain(e) for e in trace.of("event")] == [
        ["event", "finished", "action", "enter"]
    ] * 6


def test_an_action_at_once_is_followed_by_its_data_and_its_end(play: Play) -> None:
    assert play(state("1", '<set tag="x">1</set>'), []).lines() == [
        "0 enter app 1 <-",
        '0 action app 1 set - tag="x" value=1 <enter',
        "0 data x 1 app v1 <action",
        "0 finished app set - ok null <action",
    ]


@pytest.mark.parametrize(
    ("before", "text", "after"),
    [(None, "2", [2]), (3, "2", [5]), (3, "-0.5", [2.5]), (3, "{n}", [13]), (1e30, "1", [1e30])],
)
def test_add_adds_a_number_to_a_number_and_missing_counts_nothing(
    play: Play, before: object, text: str, after: list[object]
) -> None:
    tags = {"n": 10} if before is None else {"n": 10, "x": before}
    trace = play(state("1", f'<add tag="x">{text}</add>'), [], tags=tags)
    assert trace.values("x")[len(tags) - 1 :] == after
    assert not trace.of("warning")


@pytest.mark.parametrize(
    ("before", "text"),
    [("3", "2"), (True, "2"), ([], "2"), (3, "two"), (3, "true"), (3, ""), (2**62, "{x}")],
)
def test_add_of_anything_else_warns_and_changes_nothing(
    play: Play, before: object, text: str
) -> None:
    rbd = state("1", f'<add tag="x" done="d">{text}</add>')
    trace = play(rbd, [], tags={"x": before})
    assert trace.values("x") == [before]
    assert len(trace.of("warning")) == 1
    assert len(trace.of("event", name="d")) == 1


def test_append_adds_to_a_list_and_missing_counts_empty(play: Play) -> None:
    rbd = state("1", '<append tag="x">{"a": 1}</append><append tag="x">b</append>')
    assert play(rbd, []).values("x") == [[{"a": 1}], [{"a": 1}, "b"]]


def test_append_to_what_is_no_list_warns_and_changes_nothing(play: Play) -> None:
    trace = play(state("1", '<append tag="x">1</append>'), [], tags={"x": "list"})
    assert trace.values("x") == ["list"]
    assert len(trace.of("warning")) == 1


def test_take_moves_the_first_entry(play: Play) -> None:
    trace = play(state("1", '<take from="l" tag="x"/>'), [], tags={"l": ["a", "b"]})
    assert trace.lines("action", "data", "finished")[1:] == [
        '0 action app 1 take - from="l" tag="x" <enter',
        '0 data l ["b"] app v2 <action',
        '0 data x "a" app v1 <action',
        "0 finished app take - ok null <action",
    ]


@pytest.mark.parametrize("entries", [None, []])
def test_take_from_an_empty_list_deletes_the_tag(play: Play, entries: object) -> None:
    tags = {"x": 1} if entries is None else {"x": 1, "l": entries}
    trace = play(state("1", '<take from="l" tag="x"/>'), [], tags=tags)
    assert trace.values("x") == [1, None]
    assert trace.values("l") == ([] if entries is None else [[]])


def test_take_of_the_last_entry_leaves_an_empty_list(play: Play) -> None:
    trace = play(state("1", '<take from="l" tag="x"/>'), [], tags={"l": [{"a": 1}]})
    assert (trace.values("l")[-1], trace.values("x")) == ([], [{"a": 1}])


def test_take_at_random_moves_any_entry_and_follows_the_seed(play: Play) -> None:
    rbd = state("1", '<take from="l" tag="x" order="random"/>')
    taken = set()
    for seed in range(20):
        trace = play(rbd, [], tags={"l": [1, 2, 3]}, seed=seed)
        assert sorted([*trace.values("l")[-1], *trace.values("x")]) == [1, 2, 3]
        assert play(rbd, [], tags={"l": [1, 2, 3]}, seed=seed).raw == trace.raw
        taken.add(trace.values("x")[0])
    assert taken == {1, 2, 3}


def test_clear_deletes_by_pattern_in_order_of_name(play: Play) -> None:
    tags = {"user.name": 1, "user": 2, "user.a.b": 3, "users": 4, "user.gone": 5}
    rbd = state("1", '<clear tag="user.gone"/><clear tag="user.**"/>')
    trace = play(rbd, [], tags=tags)
    assert [e["tag"] for e in trace.of("data") if e["value"] is None] == [
        "user.gone", "user", "user.a.b", "user.name",
    ]  # fmt: skip


def test_clear_never_touches_reserved_roots(play: Play) -> None:
    rbd = state(
        "1",
        '<service name="s" url="http://x/" wait="true"/><robot resource="head" command="nod"/>'
        '<clear tag="**"/><set tag="still">{service/s.ok} {robot/head.command} '
        "{application/app.state}</set>",
    )
    trace = play(rbd, [finish(1, "service")], tags={"x": 1})
    assert [e["tag"] for e in trace.of("data") if e["value"] is None] == ["x"]
    assert trace.values("still") == ["true nod 1"]


def test_a_message_with_params_sends_an_object(play: Play) -> None:
    rbd = state(
        "1",
        '<message topic="nurse/{where}"><param name="room">{room}</param>'
        '<param name="now">Room {room}</param></message>',
    )
    trace = play(rbd, [], tags={"room": 7, "where": "call"})
    assert trace.lines("action", "finished") == [
        '0 action app 1 message - topic="nurse/call" value={"room":7,"now":"Room 7"} <enter',
        "0 finished app message - ok null <action",
    ]


@pytest.mark.parametrize(
    ("text", "value"), [("{room}", 7), ("[1, 2]", [1, 2]), ("Room {room}", "Room 7"), ("", None)]
)
def test_a_message_with_text_sends_that_value(play: Play, text: str, value: object) -> None:
    trace = play(state("1", f'<message topic="t">{text}</message>'), [], tags={"room": 7})
    assert trace.of("action")[0]["value"] == value


# -- services ----------------------------------------------------------------

SERVICE = (
    '<service name="find" method="POST" url="{host}/find" done="got" failed="offline">'
    '<param name="x">{i}</param><result tag="names" path="names"/>'
    '<result tag="first" path="names.0.name"/></service>'
)
HOST = {"host": "http://h", "i": "A"}


def test_a_service_is_traced_with_its_own_fields(play: Play) -> None:
    trace = play(state("1", SERVICE), [], tags=HOST)
    assert trace.lines("action") == [
        '0 action app 1 service find params={"x":"A"} method="POST" url="http://h/find" <enter'
    ]


def test_results_are_set_before_done_is_judged(play: Play) -> None:
    rbd = state(
        "1", SERVICE, '<event name="got" next="2"><when><data tag="first" is="Ann"/></when></event>'
    )
    lines = [finish(1, "service", "find", result={"names": [{"name": "Ann"}]})]
    trace = play(rbd + '<state no="2"/>', lines, tags=HOST)
    assert trace.lines(since=1)[:6] == [
        '1 finished app service find ok {"names":[{"name":"Ann"}]} <-',
        '1 data service/find {"ok":true,"status":null,"error":null} app v1 <finished',
        '1 data names [{"name":"Ann"}] app v1 <finished',
        '1 data first "Ann" app v1 <finished',
        "1 event app got <finished",
        "1 exit app 1 <event",
    ]


def test_a_result_whose_path_is_missing_deletes_its_tag_with_a_warning(play: Play) -> None:
    lines = [finish(1, "service", result={"names": []})]
    trace = play(state("1", SERVICE), lines, tags={**HOST, "first": "Bo"})
    assert trace.values("first") == ["Bo", None]
    assert trace.values("names") == [[]]
    assert [trace.chain(e) for e in trace.of("warning")] == [["warning", "finished"]]


def test_a_failed_service_sets_nothing_but_what_happened_to_it(play: Play) -> None:
    lines = [finish(1, "service", ok=False, error="no answer", status=504, result={"names": [1]})]
    trace = play(state("1", SERVICE), lines, tags=HOST)
    assert trace.lines("data", "event", "finished", since=1) == [
        '1 finished app service find failed "no answer" <-',
        '1 data service/find {"ok":false,"status":504,"error":"no answer"} app v1 <finished',
        "1 event app offline <finished",
    ]


@pytest.mark.parametrize("url", ["board:quiz/ask", "media:quiz.json"])
def test_modules_and_files_are_asked_with_the_same_results_and_events(play: Play, url: str) -> None:
    rbd = state("1", f'<service name="q" url="{url}" done="got"><result tag="q"/></service>')
    trace = play(rbd, [finish(1, "service", result={"a": 1})])
    assert trace.values("q") == [{"a": 1}]
    assert trace.lines("event") == ["1 event app got <finished"]


# -- actions of an event -----------------------------------------------------


def test_actions_of_an_event_run_between_exit_and_entry_and_belong_to_the_new_state(
    play: Play,
) -> None:
    rbd = state("1", "", '<event name="go" next="2"><set tag="x">1</set></event>')
    trace = play(rbd + state("2", '<set tag="y">{x}</set>'), [{"at": 1, "event": "go"}])
    assert trace.lines(since=1) == [
        "1 event app go <-",
        "1 exit app 1 <event",
        "1 transition app 1 2 go <event",
        '1 action app 2 set - tag="x" value=1 <transition',
        "1 data x 1 app v1 <action",
        "1 finished app set - ok null <action",
        "1 enter app 2 <transition",
        '1 action app 2 set - tag="y" value=1 <enter',
        "1 data y 1 app v1 <action",
        "1 finished app set - ok null <action",
    ]


def test_a_service_of_an_event_is_cancelled_when_the_new_state_is_left(play: Play) -> None:
    rbd = state("1", "", '<event name="go" next="2"><service name="s" url="http://x/"/></event>')
    rbd += state("2", "", '<event name="go" next="1"/>')
    trace = play(rbd, [{"at": 1, "event": "go"}, {"at": 2, "event": "go"}])
    assert trace.lines("action", "cancelled") == [
        '1 action app 2 service s method="GET" url="http://x/" <transition',
        "2 cancelled app service s <exit",
    ]


def test_actions_of_an_event_wait_too(play: Play) -> None:
    rbd = state(
        "1",
        "",
        '<event name="go" next="2"><service name="s" url="http://x/" wait="true"/>'
        '<set tag="x">1</set></event>',
    )
    trace = play(rbd + state("2", ""), [{"at": 1, "event": "go"}, finish(3, "service")])
    assert [(e["t"], e["action"]) for e in trace.of("action")] == [(1, "service"), (3, "set")]
