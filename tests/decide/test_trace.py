"""formats.md, *Trace*: fields, writers, order in one step, causes."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tests.decide.conftest import Play, Trace

AT = 'x="1" y="1" width="9" height="9"'
RBD = f"""<application name="app" start="1">
  <state no="1"><timeout next="2">50</timeout>
    <screen><components><text id="t" {AT}>{{x}}</text><movie id="m" {AT} src="m.webm"/>
      <input id="in" {AT} tag="typed" kind="text" event="entered"/></components></screen>
    <backgroundactions><speech done="said">A</speech>
      <robot resource="head" command="nod"/><sound src="a.ogg"/>
      <service name="s" url="http://x/" failed="off"><result tag="r" path="a"/></service>
      <launch program="p"/><set tag="x">{{gone}}</set><add tag="n">1</add>
      <append tag="l">1</append><take from="l" tag="y"/><clear tag="y"/>
      <message topic="t">1</message></backgroundactions>
    <expectedevents><event name="go" next="2"><when><data tag="x" is="1"/></when></event>
    </expectedevents></state>
  <state no="2"><backgroundactions><robot resource="base" command="goto"/></backgroundactions>
  </state></application>"""
SPDS = """<observe><data tag="busy"/></observe>
  <modules><module name="app" resources="speech screen head base"/>
    <module name="m" resources="head base"><!-- --></module></modules>
  <situation name="busy" limit="5"><condition><data tag="busy" is="true"/></condition>
    <module name="m" priority="1"/></situation>
  <situation name="calm"><module name="app" priority="2"/><module name="m" priority="1"/>
  </situation>"""
LINES: list[dict[str, Any]] = [
    {"at": 1, "finish": {"action": "speech"}},
    {"at": 1, "finish": {"action": "service", "result": {}}},
    {"at": 2, "event": "go"},
    {"at": 2, "event": "unknown"},
    {"at": 3, "set": {"x": 1}},
    {"at": 4, "acquire": {"module": "m", "resources": ["base"], "optional": ["head"]}},
    {"at": 4, "command": {"module": "m", "resource": "base", "value": {"vx": 1}, "for": 2}},
    {"at": 5, "set": {"busy": True}},
    {"at": 6, "event": "go"},
    {"at": 12, "finish": {"action": "launch", "ok": False, "error": "crashed"}},
    {"at": 13, "use": {"component": "in", "value": "Z"}},
    {"at": 14, "event": "go"},
    {"at": 15, "abandon": {"module": "m", "resources": ["base", "head"]}},
    {"at": 16, "lost": {"module": "m"}},
    {"at": 17, "finish": {"action": "robot", "name": "none such"}},
    {"at": 18, "acquire": {"module": "m", "resources": ["wings"]}},
    {"at": 60, "end": True},
]
FIELDS = {
    "data": "tag value writer version",
    "condition": "situation holds",
    "situation": "from to",
    "acquire": "module resources",
    "abandon": "module resources",
    "lost": "module resources",
    "authority": "resource from to",
    "mapping": "resource module value",
    "event": "application name",
    "ignored": "application name reason",
    "exit": "application state",
    "enter": "application state",
    "transition": "application from to event",
    "screen": "application state components",
    "action": "application state action name",
    "finished": "application action name ok",
    "cancelled": "application action name",
    "suspend": "application missing",
    "resume": "application missing",
    "warning": "message where",
    "error": "message where",
}
OWN = {
    "speech": "text lang",
    "robot": "resource command params",
    "service": "url params",
    "launch": "program params",
    "message": "topic value",
    "set": "tag value",
    "add": "tag value",
    "append": "tag value",
    "take": "tag from",
    "clear": "tag",
    "movie": "src",
    "sound": "src",
}


def everything(play: Play) -> Trace:
    return play(RBD, LINES, spds=SPDS)


# -- fields ------------------------------------------------------------------


def test_every_kind_is_told_with_all_its_fields(play: Play) -> None:
    trace = everything(play)
    assert {event["kind"] for event in trace} == set(FIELDS)
    for event in trace:
        wanted = {"seq", "t", "kind", "cause", *FIELDS[event["kind"]].split()}
        assert wanted <= event.keys(), event
    for event in trace.of("finished"):
        assert ("result" in event) is event["ok"]
        assert ("error" in event) is not event["ok"]


def test_an_action_has_its_own_fields(play: Play) -> None:
    trace = everything(play)
    assert {event["action"] for event in trace.of("action")} == set(OWN)
    for event in trace.of("action"):
        assert set(OWN[event["action"]].split()) <= event.keys(), event


def test_the_name_of_an_action(play: Play) -> None:
    names = {(event["action"], event["name"]) for event in everything(play).of("action")}
    assert names == {
        ("service", "s"), ("robot", "nod"), ("robot", "goto"), ("launch", "p"), ("movie", "m"),
        *((action, None) for action in (
            "speech", "sound", "set", "add", "append", "take", "clear", "message")),
    }  # fmt: skip


def test_each_line_is_one_json_object(play: Play) -> None:
    trace = everything(play)
    lines = trace.raw.split(b"\n")
    assert lines.pop() == b""
    assert [json.loads(line) for line in lines] == json.loads(json.dumps(trace))


# -- seq, t and cause --------------------------------------------------------


def test_seq_counts_from_1_without_a_gap_and_time_never_goes_back(play: Play) -> None:
    trace = everything(play)
    assert [event["seq"] for event in trace] == list(range(1, len(trace) + 1))
    times = [event["t"] for event in trace]
    assert times == sorted(times)


def test_a_cause_is_always_smaller(play: Play) -> None:
    trace = everything(play)
    assert all(e["cause"] is None or 0 < e["cause"] < e["seq"] for e in trace)


def test_outside_input_and_the_start_have_no_cause(play: Play) -> None:
    trace = everything(play)
    first = {(e["t"], e["kind"]) for e in trace if e["cause"] is None}
    assert first == {
        (0, "situation"), (0, "enter"), (1, "finished"), (2, "event"), (3, "data"), (4, "acquire"),
        # A module's command is an input that has no event of its own.
        (4, "mapping"),
        (5, "data"), (6, "event"), (12, "finished"), (13, "data"), (13, "event"), (14, "event"),
        (15, "abandon"), (16, "lost"), (17, "warning"), (18, "error"),
    }  # fmt: skip


def test_every_movement_of_the_robot_leads_back_to_what_came_from_outside(play: Play) -> None:
    trace = everything(play)
    for event in trace.of("mapping"):
        first = event
        while (cause := trace.cause(first)) is not None:
            first = cause
        outside = ("enter", "acquire", "data", "event", "abandon", "finished")
        assert first["kind"] in outside or (first["t"], first["kind"]) == (4, "mapping")


# -- writers -----------------------------------------------------------------


def test_writers(play: Play) -> None:
    trace = play(RBD, LINES, spds=SPDS, tags={"x": 0})
    writers = {(e["tag"], e["writer"]) for e in trace.of("data")}
    assert {("x", "project"), ("x", "app"), ("x", "scenario"), ("typed", "screen")} <= writers
    assert {writer for _, writer in writers} == {"project", "app", "scenario", "screen"}


def test_the_tags_of_the_project_are_written_at_0(play: Play) -> None:
    trace = play('<state no="1"/>', [], tags={"services.records": "http://x", "n": 1})
    assert trace.lines() == [
        '0 data services.records "http://x" project v1 <-',
        "0 data n 1 project v1 <-",
        "0 enter app 1 <-",
    ]


# -- order in one step -------------------------------------------------------


def test_the_order_in_one_step(play: Play) -> None:
    """All of it: a transition of an application that another one loses its resources to."""
    first = f"""<application name="first"><state no="1">
      <screen><components><text id="a" {AT}>A</text></components></screen>
      <backgroundactions><speech>One</speech><launch program="p"/></backgroundactions>
      <expectedevents><event name="go" next="2"><set tag="x">1</set></event></expectedevents>
      </state><state no="2">
      <screen><components><text id="b" {AT}>B {{y}}</text></components></screen>
      <backgroundactions><set tag="y">1</set><robot resource="head" command="nod"/>
      <set tag="y">2</set></backgroundactions></state></application>"""
    second = """<application name="second"><state no="1"><backgroundactions>
      <robot resource="head" command="shake"/></backgroundactions></state></application>"""
    spds = """<modules><module name="first" resources="screen speech head"/>
      <module name="second" resources="head"/></modules><situation name="s">
      <module name="first" priority="2"/><module name="second" priority="1"/></situation>"""
    trace = play([first, second], [{"at": 1, "event": "go", "application": "first"}], spds=spds)
    assert trace.lines(since=1) == [
        "1 event first go <-",
        "1 exit first 1 <event",
        "1 cancelled first speech - <exit",
        "1 mapping speech first null <cancelled",
        "1 cancelled first launch p <exit",
        "1 transition first 1 2 go <event",
        '1 action first 2 set - tag="x" value=1 <transition',
        "1 data x 1 first v1 <action",
        "1 finished first set - ok null <action",
        "1 enter first 2 <transition",
        "1 acquire first [head screen] <enter",
        "1 authority head second first <acquire",
        "1 mapping head first null <authority",
        "1 authority speech first - <acquire",
        "1 suspend second [head] <authority^1",
        "1 cancelled second robot shake <suspend",
        "1 warning y has no value <enter",
        "1 screen first 2 [b=B ] <enter",
        "1 mapping screen first [b=B ] <screen",
        '1 action first 2 set - tag="y" value=1 <enter',
        "1 data y 1 first v1 <action",
        "1 finished first set - ok null <action",
        '1 action first 2 robot nod resource="head" <enter',
        '1 mapping head first {"command":"nod","params":{}} <action',
        '1 action first 2 set - tag="y" value=2 <enter',
        "1 data y 2 first v2 <action",
        "1 finished first set - ok null <action",
        "1 screen first 2 [b=B 2] <data",
        "1 mapping screen first [b=B 2] <screen",
    ]


def test_authority_is_told_by_resource_name(play: Play) -> None:
    rbd = """<state no="1"><backgroundactions><robot resource="zoom" command="a"/>
      <robot resource="arm" command="a"/><speech>A</speech></backgroundactions></state>"""
    assert [e["resource"] for e in play(rbd, []).of("authority")] == ["arm", "speech", "zoom"]


def test_a_request_that_does_not_change_is_not_told(play: Play) -> None:
    rbd = """<state no="1"><backgroundactions><speech>A</speech></backgroundactions>
      <expectedevents><event name="go" next="2"/></expectedevents></state>
      <state no="2"><backgroundactions><speech>B</speech></backgroundactions></state>"""
    trace = play(rbd, [{"at": 1, "event": "go"}])
    assert trace.lines("acquire", "abandon", "authority", since=1) == []


# -- causes of what time does ------------------------------------------------


def test_causes_of_what_time_does(play: Play) -> None:
    end: dict[str, Any] = {"at": 90, "end": True}
    rbd = """<state no="1"><timeout next="2">5</timeout></state><state no="2"><expectedevents>
      <event next="3"><when><data tag="x" is="1" for="20"/></when></event></expectedevents></state>
      <state no="3"><expectedevents><event next="4"/></expectedevents></state><state no="4"/>"""
    trace = play(rbd, [{"at": 1, "set": {"x": 1}}, end])
    assert trace.lines("transition") == [
        "5 transition app 1 2 timeout <enter",
        "21 transition app 2 3 - <data",
        "21 transition app 3 4 - <enter",
    ]
    spds = """<modules><module name="m" resources="head"/></modules>
      <situation name="a" dwell="9"><condition><data tag="x" is="1" within="1"/></condition>
      </situation><situation name="b" limit="9"><condition><data tag="y" is="1"/></condition>
      </situation><situation name="c"><module name="m" priority="1"/></situation>"""
    lines: list[dict[str, Any]] = [
        {"at": 1, "acquire": {"module": "m", "resources": ["head"]}},
        {"at": 1, "command": {"module": "m", "resource": "head", "value": 1, "for": 5}},
        {"at": 20, "set": {"x": 1}},
        {"at": 40, "set": {"y": 1}},
        end,
    ]
    assert play((), lines, spds=spds).lines("mapping", "condition", "situation", since=1) == [
        "1 mapping head m 1 <-",
        "6 mapping head m null <mapping",
        "20 condition a true <data",
        "20 situation c a <condition",
        "21 condition a false <data",
        "29 situation a c <situation",
        "40 condition b true <data",
        "40 situation c b <condition",
        "49 situation b c <situation",
    ]


def test_an_automatic_finish_is_caused_by_its_action(play: Play) -> None:
    rbd = """<state no="1"><backgroundactions><speech>A</speech></backgroundactions></state>"""
    trace = play(rbd, [{"at": 9, "end": True}], auto_finish=2)
    assert trace.lines("finished") == ["2 finished app speech - ok null <action"]
