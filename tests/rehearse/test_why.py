"""``situ why``: what led to something, and what kept something from happening (issue 3, 4)."""

from __future__ import annotations

import json
import re
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from tests.rehearse.recorded_robot import Recorded, recorder

from situ.cli import main
from situ.decide import inputs
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent, to_fields
from situ.document import deployed
from situ.document.modules import Module, Modules
from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse.reason import Answer, lines
from situ.rehearse.recording import Recording, read
from situ.rehearse.recording import record as record_run
from situ.rehearse.simulate import Rehearsal
from situ.rehearse.stays import stays
from situ.rehearse.telling import Teller
from situ.rehearse.why import chain, why_not

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make, Record

DOOR = """<application name="door">
<always><expectedevents><event name="home" next="1"/></expectedevents></always>
<state no="1" name="shut" always="false">
  <timeout next="3">30</timeout>
  <screen><components>
    <button id="open" x="1" y="1" width="9" height="9" event="open">Open</button>
  </components></screen>
  <backgroundactions><service name="find" url="http://x/" done="found" failed="lost"/>
  </backgroundactions>
  <expectedevents>
    <event name="open" next="3"><when><data tag="fire" is="true"/></when></event>
    <event name="open" next="2"><say>open up</say><when>
      <data tag="key" above="3"/>
      <none><data tag="alarm" exists="true" within="5"/></none>
      <any><data tag="day" is="mon" for="2"/><data tag="day" is="{open.day}"/></any>
    </when></event>
    <event name="found" next="2"/>
    <event next="4"><when><data tag="distance" below="1.5"/></when></event>
    <event name="returned"><set tag="x" done="raised">1</set></event>
    <event name="raised" next="2"/>
    <event name="undo" next="#back"/>
  </expectedevents>
</state>
<state no="2" name="open"><expectedevents>
  <event name="go" next="4"/><event name="undo" next="#back"/></expectedevents></state>
<state no="3" name="burning"><expectedevents><event name="go" next="1"/></expectedevents></state>
<state no="4" name="inside"><expectedevents><event name="undo" next="#back"/></expectedevents>
</state>
<state no="5" name="nowhere"/>
</application>"""

SCRIPT = """<spds name="s">
<modules><module name="arm" resources="base hand"/><module name="app" resources="base speech"/>
<module name="other" resources="base"/></modules>
<situation name="hot" limit="5"><condition><data tag="heat" above="40"/></condition>
<until><data tag="cooled" is="true"/></until><module name="arm" priority="90"/></situation>
<situation name="held" dwell="10"><condition><data tag="hold" is="true"/></condition>
<module name="arm" priority="90"/><module name="app" priority="10"/></situation>
<situation name="dark"><condition><data tag="light" below="5"/></condition></situation>
<situation name="calm"><module name="app" priority="10"/><module name="arm" priority="5"/>
<module name="other" priority="10"/></situation>
</spds>"""

APP = """<application name="app">
<state no="1"><backgroundactions>
<robot resource="base" command="wait" done="rested"/></backgroundactions>
<expectedevents><event name="go" next="2"/></expectedevents></state>
<state no="2"><backgroundactions>
  <speech wait="true">First</speech><speech>Hello {name}</speech><set tag="a">1</set>
  <robot resource="base" command="turn" optional="true"/></backgroundactions></state>
</application>"""


@pytest.fixture
def door(make: Make) -> Project:
    return make(DOOR)


@pytest.fixture
def lab(make: Make) -> Project:
    return make(APP, SCRIPT)


def _told(answer: Answer) -> str:
    """The reasons as lines, without the numbers of the events."""
    return re.sub(r"  \(#\d+\)", "", "\n".join(lines(answer.reasons)))


def _ask(project: Project, recording: Recording, at: float, kind: str, **wanted: Any) -> str:
    return _told(why_not(project, recording, {"kind": kind, **wanted}, at))


# -- chains --------------------------------------------------------------------


def test_a_chain_goes_from_the_outside_input_to_the_event(door: Project, record: Record) -> None:
    recording = record(door, {"at": 1, "set": {"key": 4, "distance": 1}})
    entered = next(e for e in recording.events if e["kind"] == "enter" and e["state"] == "4")
    told = [Teller(door).line(event) for event in chain(recording.events, entered["seq"])]
    assert [line.split("  ", 2)[2] for line in told] == [
        "scenario sets distance to 1",
        "door goes from 1 shut to 4 inside by an unnamed event",
        "door enters 4 inside",
    ]


def test_every_event_of_a_run_has_a_chain_back_to_the_outside(lab: Project, record: Record) -> None:
    recording = record(
        lab,
        {"at": 1, "event": "go"},
        {"at": 2, "acquire": {"module": "arm", "resources": ["base"]}},
        {"at": 2, "command": {"module": "arm", "resource": "base", "value": 1}},
        {"at": 3, "set": {"heat": 50}},
        {"at": 9, "lost": {"module": "arm"}},
    )
    teller = Teller(lab)
    for event in recording.events:
        found = chain(recording.events, event["seq"])
        assert found[-1] is event
        assert found[0]["cause"] is None
        assert teller.origin(found[0]) in ("the start", "from outside")
        assert all(a["seq"] == b["cause"] for a, b in pairwise(found))
        assert teller.tell(event) != event["kind"]


def test_there_is_no_chain_to_an_event_that_is_not_there(door: Project, record: Record) -> None:
    with pytest.raises(UsageError, match="no event 999 in this trace; its last is"):
        chain(record(door).events, 999)


def test_a_chain_of_a_trace_that_begins_later_begins_with_what_it_has() -> None:
    events = [{"seq": 7, "t": 1.0, "kind": "exit", "cause": 3}]
    assert chain(events, 7) == events


# -- why a state was not entered ------------------------------------------------


def test_the_event_that_did_not_come_and_what_would_raise_it(door: Project, record: Record) -> None:
    told = _ask(door, record(door, {"at": 9, "end": True}), 4, "enter", state="2")
    assert told.splitlines() == [
        "- event open did not come while door was in 1 shut, since 0 s",
        "  - button open of its screen raises it by a person's use of it",
        "  - it is what is heard as “open up”",
        "- event found did not come while door was in 1 shut, since 0 s",
        "  - service find raises it when it ends well: it has been running since 0 s",
        "- event raised did not come while door was in 1 shut, since 0 s",
        "  - set x = 1 of event returned raises it",
        "    - event returned did not come while door was in 1 shut, since 0 s",
        "      - it comes from outside: from a module, a message, or the blackboard",
    ]


def test_the_fate_of_the_action_that_would_have_raised_it(door: Project, record: Record) -> None:
    finish = {"action": "service", "name": "find", "ok": False}
    told = _ask(door, record(door, {"at": 2, "finish": finish}), 4, "enter", state="2")
    assert "service find raises it when it ends well: it ended badly at 2 s" in told


@pytest.mark.parametrize("alone", [False, True])
def test_the_guard_that_did_not_hold_with_the_values_then(
    door: Project, record: Record, alone: bool
) -> None:
    recording = record(
        door,
        {"at": 1, "set": {"key": 2, "day": "mon"}},
        {"at": 2, "set": {"alarm": None, "open.day": "tue"}},
        {"at": 2.5, "event": "open"},
        {"at": 2.5, "set": {"key": 9}},
        alone=alone,
    )
    answer = why_not(door, recording, {"kind": "enter", "state": "2"}, 2.5)
    guard = answer.reasons[0]
    assert guard.code == "guard"
    assert guard.text == (
        "open came at 2.5 s, but its guard did not hold: "
        "key above 3: it was 2, set at 1 s by scenario; "
        "none of these held: day is mon, for 2 s: it was “mon”, set at 1 s by scenario; "
        "day is {open.day}: it was “mon”, set at 1 s by scenario; open.day was “tue”"
    )
    assert guard.values == {"key": 2, "alarm": None, "day": "mon"}


def test_within_and_for_count_as_they_did_then(door: Project, record: Record) -> None:
    recording = record(
        door,
        {"at": 1, "set": {"key": 4, "day": "mon", "alarm": 1}},
        {"at": 3.5, "event": "open"},
        {"at": 5.9, "event": "open"},
        {"at": 6, "event": "open"},
    )
    said = "this must not hold, and did: alarm exists, within 5 s: it was 1, set at 1 s by scenario"
    told = _ask(door, recording, 5.9, "enter", state="2")
    assert f"its guard did not hold: {said}\n" in told
    assert "it did happen later, at 6 s" in told
    answer = why_not(door, recording, {"kind": "enter", "state": "2"}, 6)
    assert answer.happened is not None


def test_the_earlier_event_that_was_taken_instead(door: Project, record: Record) -> None:
    recording = record(door, {"at": 1, "set": {"fire": True, "key": 9}}, {"at": 2, "event": "open"})
    told = _ask(door, recording, 2, "enter", state="2")
    assert (
        "open came at 2 s, and an event before this one took it: event open leads to 3 burning"
        in told
    )


def test_the_unnamed_event_whose_guard_did_not_hold(door: Project, record: Record) -> None:
    recording = record(door, {"at": 1, "set": {"distance": 2.3}})
    told = _ask(door, recording, 4, "enter", state="4")
    assert told == (
        "- the guard of its unnamed event did not hold: "
        "distance below 1.5: it was 2.3, set at 1 s by scenario"
    )


def test_the_timeout_that_had_not_run_out(door: Project, record: Record) -> None:
    told = _ask(door, record(door, {"at": 20, "end": True}), 20, "enter", state="3")
    assert "its timeout of 30 s had not run out: 20 s had passed" in told


def test_back_with_nowhere_to_go_back_to(door: Project, record: Record) -> None:
    told = _ask(door, record(door, {"at": 1, "event": "undo"}), 1, "enter", state="2")
    assert "- event undo leads back, and there was nothing to go back to" in told
    assert "event undo" not in _ask(
        door, record(door, {"at": 1, "end": True}), 1, "enter", state="2"
    )
    away = {"at": 1, "finish": {"action": "service"}}, {"at": 2, "event": "go"}
    told = _ask(door, record(door, *away, {"at": 3, "end": True}), 3, "enter", state="2")
    assert told.startswith("- event undo did not come while door was in 4 inside")
    told = _ask(door, record(door, *away, {"at": 3, "end": True}), 3, "enter", state="1")
    assert told.startswith("- event home did not come while door was in 4 inside")
    assert "undo" not in told


def test_reasons_name_the_events_that_tell_of_them(door: Project, record: Record) -> None:
    recording = record(door, {"at": 1, "event": "open"})
    (guard, *_) = why_not(door, recording, {"kind": "enter", "state": "2"}, 1).reasons
    told = next(event for event in recording.events if event["seq"] == guard.seq)
    assert (told["kind"], told["name"]) == ("event", "open")
    assert lines([guard])[0].endswith(f"  (#{guard.seq})")


def test_a_state_that_is_far_away_and_the_nearest_way_there(door: Project, record: Record) -> None:
    told = _ask(door, record(door, {"at": 30, "end": True}), 31, "enter", state="4")
    assert told.splitlines()[:2] == [
        (
            "- door was in 3 burning since 30 s; the nearest way to 4 inside: "
            "go → 1 shut, at once → 4 inside"
        ),
        "  - event go did not come while door was in 3 burning, since 30 s",
    ]


def test_a_state_that_nothing_leads_to_and_one_that_is_not_there(
    door: Project, record: Record
) -> None:
    recording = record(door, {"at": 3, "end": True})
    told = _ask(door, recording, 2, "enter", state="5")
    assert told == "- door was in 1 shut since 0 s, and no way leads from there to 5 nowhere"
    told = _ask(door, recording, 2, "enter", state="77", application="door")
    assert told == "- door has no state 77"


def test_the_suspension_that_stood_in_the_way_and_who_held_the_resource(
    lab: Project, record: Record
) -> None:
    recording = record(
        lab,
        {"at": 1, "acquire": {"module": "arm", "resources": ["base", "hand"]}},
        {"at": 2, "set": {"hold": True}},
        {"at": 3, "event": "go"},
    )
    answer = why_not(lab, recording, {"kind": "enter", "state": "2"}, 3)
    assert _told(answer).splitlines() == [
        "- go came at 3 s, but app was suspended since 2 s: it did not hold base",
        "  - arm held base since 2 s: priority 90 against 10 of app in situation held",
    ]
    assert _ask(lab, recording, 3, "resume", application="app").startswith(
        "- it could not go on, as app was suspended"
    )


def test_what_was_there_already(door: Project, record: Record) -> None:
    answer = why_not(door, record(door), {"kind": "enter", "state": "1"}, 3)
    assert [(r.code, r.text, r.seq) for r in answer.reasons] == [
        ("already", "door was in 1 shut already, since 0 s", 1)
    ]


def test_transitions_of_another_state(door: Project, record: Record) -> None:
    recording = record(door, {"at": 3, "end": True})
    told = _ask(door, recording, 2, "transition", **{"from": "2", "to": "4", "event": "go"})
    assert told.startswith("- door was in 1 shut since 0 s")
    told = _ask(door, recording, 2, "transition", **{"from": "1", "to": "2", "event": "found"})
    assert told.splitlines()[0] == (
        "- event found did not come while door was in 1 shut, since 0 s"
    )


# -- situations ------------------------------------------------------------------


def test_the_condition_of_a_situation(lab: Project, record: Record) -> None:
    told = _ask(lab, record(lab, {"at": 1, "set": {"heat": 39}}), 2, "situation", to="hot")
    assert told == (
        "- the condition of hot did not hold: heat above 40: it was 39, set at 1 s by scenario"
    )


def test_a_situation_that_goes_first_or_is_kept(lab: Project, record: Record) -> None:
    lines_ = [{"at": 1, "set": {"hold": True, "light": 1}}, {"at": 2, "set": {"hold": False}}]
    recording = record(lab, *lines_)
    assert _ask(lab, recording, 1.5, "situation", to="dark").startswith(
        "- situation held, which goes before dark, was current since 1 s: hold is true"
    )
    assert _ask(lab, recording, 3, "situation", to="dark").startswith(
        "- situation held, which goes before dark, was current since 1 s; it stays at least 10 s"
    )


def test_a_situation_that_was_ended_by_its_limit_or_until(lab: Project, record: Record) -> None:
    recording = record(lab, {"at": 1, "set": {"heat": 50}}, {"at": 9, "set": {"cooled": True}})
    assert _ask(lab, recording, 7, "situation", to="hot").startswith(
        "- hot has ended at 6 s by until or limit"
    )
    assert _ask(lab, recording, 10, "situation", to="hot").startswith(
        "- until of hot held, so it does not begin: cooled is true: it was true, set at 9 s"
    )


def test_a_situation_that_ended_before_the_trace_begins_is_told_without_its_end(
    lab: Project, record: Record
) -> None:
    recording = record(lab, {"at": 1, "set": {"heat": 50}}, {"at": 9, "set": {"heat": 60}})
    late = [event for event in recording.events if event["t"] >= 9]
    assert _ask(lab, Recording.of(late), 10, "situation", to="hot") == (
        "- hot has ended by until or limit and begins again only after its condition has once "
        "been false"
    )


# -- authority and mapping ---------------------------------------------------------


@pytest.mark.parametrize(
    ("module", "resource", "told"),
    [
        ("arm", "hand", "- arm did not ask for hand"),
        ("arm", "head", "- arm did not declare head, only base and hand"),
        ("leg", "base", "- no module leg is declared"),
        ("app", "speech", "- app did not ask for speech, only for base"),
    ],
)
def test_a_module_that_can_not_hold_a_resource(
    lab: Project, record: Record, module: str, resource: str, told: str
) -> None:
    recording = record(lab, {"at": 2, "end": True})
    assert _ask(lab, recording, 1, "authority", resource=resource, to=module) == told


def test_the_priority_that_stood_in_the_way(lab: Project, record: Record) -> None:
    def ask(module: str, *more: dict[str, Any]) -> str:
        acquire = {"module": module, "resources": ["base"]}
        recording = record(lab, *more, {"at": 1, "acquire": acquire})
        return _ask(lab, recording, 1, "authority", resource="base", to=module)

    held = "- app held base since 0 s: priority 10"
    assert ask("arm") == f"{held} against 5 of arm in situation calm"
    assert ask("other") == f"{held} like other, and it came first"
    assert ask("other", {"at": 0, "set": {"light": 1}}).startswith(
        "- other has no priority in situation dark"
    )
    both = {"at": 0.5, "acquire": {"module": "arm", "resources": ["base", "hand"]}}
    told = _ask(lab, record(lab, both), 1, "authority", resource="hand", to="arm")
    assert told.splitlines() == [
        "- arm asks for base and hand together: all of them or none",
        f"  {held} against 5 of arm in situation calm",
    ]


def test_a_module_that_was_lost(lab: Project, record: Record) -> None:
    recording = record(
        lab,
        {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}},
        {"at": 2, "lost": {"module": "arm"}},
    )
    told = _ask(lab, recording, 3, "authority", resource="hand", to="arm")
    assert told.startswith("- arm was lost at 2 s and has not asked again")
    told = _ask(lab, recording, 1.5, "authority", resource="hand", to="arm")
    assert told.startswith("- arm held hand already, since 1 s")


def test_a_holder_without_a_valid_command(lab: Project, record: Record) -> None:
    def ask(*more: dict[str, Any], at: float = 3) -> str:
        acquire = {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}}
        return _ask(lab, record(lab, acquire, *more), at, "mapping", resource="hand", module="arm")

    assert ask().startswith("- arm held hand but had no valid command for it")
    command = {"module": "arm", "resource": "hand", "value": {"grip": 1}}
    assert 'hand was already moved by arm: {"grip":1}' in ask({"at": 2, "command": command})
    early = {"at": 0.5, "command": command}
    recording = record(lab, early, {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}})
    told = _ask(lab, recording, 3, "mapping", resource="hand", module="arm")
    assert told.startswith('- arm held hand but had no valid command for it; what it commanded, {"')


# -- actions ------------------------------------------------------------------------


def test_an_action_of_a_state_that_was_not_entered(lab: Project, record: Record) -> None:
    told = _ask(lab, record(lab), 1, "action", action="set", tag="a")
    assert told.splitlines()[0] == "- app was in 1 since 0 s"
    assert "event go did not come" in told


def test_an_action_that_waits_its_turn(lab: Project, record: Record) -> None:
    recording = record(lab, {"at": 1, "event": "go"}, {"at": 2, "end": True})
    wanted = {"action": "speech", "text": "Hello Ann"}
    told = _ask(lab, recording, 2, "action", **wanted)
    assert told.startswith("- it waits for speech “First”, running since 1 s")


def test_an_optional_action_whose_resource_was_not_held(lab: Project, record: Record) -> None:
    recording = record(
        lab,
        {"at": 0.5, "set": {"hold": True}},
        {"at": 1, "event": "go"},
        {"at": 2, "acquire": {"module": "arm", "resources": ["base"]}},
        {"at": 3, "finish": {"action": "speech"}},
    )
    told = _ask(lab, recording, 3, "action", action="robot", name="turn")
    assert told.splitlines()[0] == "- it is optional, and app did not hold base"
    assert "arm held base since 2 s: priority 90 against 10" in told


def test_an_action_that_is_nowhere(lab: Project, record: Record) -> None:
    told = _ask(lab, record(lab), 1, "action", action="launch", application="app")
    assert told == "- app has no such action"


BUSY = """<application name="busy">
<state no="1"><screen touched="poked"><components>
<movie id="film" x="1" y="1" width="9" height="9" src="f.webm" done="seen" failed="dark"/>
</components></screen>
<backgroundactions>
  <speech>One</speech><sound src="two.ogg"/><service name="s" url="http://x/" wait="true"/>
  <launch program="game" done="played"/></backgroundactions>
<timeout>5</timeout>
<expectedevents>
  <event name="poked"><when><data tag="a" is="1"/></when><message topic="hello">hi</message></event>
  <event name="timeout" next="2"/><event name="seen" next="2"/><event name="played" next="2"/>
  <event name="resumed" next="2"/><event name="notunderstood" next="2"/><event name="a"><set
  tag="x" done="b">1</set></event><event name="b"><set tag="x" done="a">1</set></event>
  <event next="3"><when><data tag="loop" is="1"/></when></event>
</expectedevents></state>
<state no="2"><backgroundactions><speech>Hello</speech></backgroundactions><expectedevents>
  <event name="b"><launch program="game"/></event></expectedevents></state>
<state no="3"><timeout next="2" idle="true">5</timeout><expectedevents><event next="1"><when>
<data tag="loop" is="1"/></when></event><event name="go"/><event name="go" next="2"/>
</expectedevents></state>
</application>"""


def test_an_action_whose_voice_is_taken_or_that_has_begun(make: Make, record: Record) -> None:
    busy = make(BUSY)
    recording = record(busy, {"at": 2, "end": True})
    told = _ask(busy, recording, 1, "action", action="sound")
    assert told == "- the voice was taken by speech “One” since 0 s"
    told = _ask(busy, recording, 1, "action", action="speech", text="One")
    assert told == "- it began at 0 s already"
    told = _ask(busy, recording, 1, "action", action="launch", state="1")
    assert told == "- it waits for service s, running since 0 s"
    ends = {"at": 0.5, "finish": {"action": "service"}}, {"at": 0.6, "finish": {"action": "launch"}}
    told = _ask(busy, record(busy, *ends), 1, "action", action="launch", state="2")
    assert told.splitlines()[0] == "- event b did not come while busy was in 2, since 0.6 s"


def test_of_several_actions_that_fit_each_is_told(make: Make, record: Record) -> None:
    busy = make(BUSY)
    told = _ask(busy, record(busy, {"at": 1, "touch": True}), 1, "action").splitlines()
    assert "- speech “One” of state 1" in told
    assert "- 6 more actions fit; name its state to be told of one" in told
    told = _ask(
        busy, record(busy, {"at": 1, "touch": True}), 1, "action", action="message"
    ).splitlines()
    assert told == ["- poked came at 1 s, but its guard did not hold: a is 1: it was never set"]
    told = _ask(busy, record(busy), 1, "action", action="set").splitlines()
    assert told[0] == "- set x = 1 of an event of state 1"
    assert told[1] == "  - event a did not come while busy was in 1, since 0 s"
    told = _ask(busy, record(busy), 1, "action", action="launch").splitlines()
    assert "- launch game of an event of state 2" in told


def test_a_speech_in_another_language_is_the_same_action(make: Make, record: Record) -> None:
    lab = make(APP, SCRIPT, languages=("en", "ja"), texts={"ja": {"First": "一"}})
    recording = record(lab, {"at": 0, "set": {"language": "ja"}}, {"at": 1, "event": "go"})
    told = _ask(lab, recording, 2, "action", action="speech", text="Hello Ann")
    assert told == "- it waits for speech “First”, running since 1 s"


def test_an_action_of_a_suspended_state(lab: Project, record: Record) -> None:
    recording = record(
        lab, {"at": 1, "set": {"light": 1}}, {"at": 2, "set": {"name": "x"}},
    )  # fmt: skip
    told = _ask(lab, recording, 2, "action", action="robot", name="wait").splitlines()
    assert told[0] == (
        "- the state is the right one, but app was suspended since 1 s: it did not hold base"
    )
    assert told[1] == "  - app has no priority in situation dark"


def test_what_would_have_raised_an_event(make: Make, record: Record) -> None:
    busy = make(BUSY)

    def ask(name: str, *more: dict[str, Any]) -> list[str]:
        return _ask(busy, record(busy, *more), 2, "event", name=name).splitlines()[1:]

    assert ask("poked") == ["  - a touch of the screen raises it"]
    assert ask("seen") == ["  - movie film of its screen raises it by its end"]
    assert ask("dark") == ["  - movie film of its screen raises it if it can not play"]
    assert ask("played") == ["  - launch game raises it when it ends well: it had not begun"]
    assert ask("timeout") == ["  - its timeout of 5 s had not run out: 2 s had passed"]
    assert ask("resumed") == ["  - it comes when a suspension ends"]
    assert "none of the phrases" in ask("notunderstood")[0]
    # a and b raise each other: that is told once.
    assert len(ask("a")) == 4


def test_a_timeout_that_stands_still_or_goes_on(make: Make, record: Record) -> None:
    lab = make(APP.replace('<state no="1">', '<state no="1"><timeout next="2">9</timeout>'), SCRIPT)
    told = _ask(lab, record(lab, {"at": 1, "set": {"light": 1}}), 3, "enter", state="2")
    assert "its timeout of 9 s had not run out; it stands still, since app was suspended" in told
    back = {"at": 1, "set": {"light": 1}}, {"at": 2, "set": {"light": 9}}
    told = _ask(lab, record(lab, *back, {"at": 4, "end": True}), 3, "enter", state="2")
    assert "its timeout of 9 s had not run out" in told.splitlines()[-1]


def test_an_unnamed_event_that_a_livelock_kept_from_being_taken(make: Make, record: Record) -> None:
    busy = make(BUSY)
    recording = record(busy, {"at": 1, "set": {"loop": 1}})
    state = [e for e in recording.events if e["kind"] == "enter"][-1]["state"]
    other = "3" if state == "1" else "1"
    answer = why_not(busy, recording, {"kind": "enter", "state": other}, 1.5)
    assert "livelock" in [reason.code for reason in answer.reasons]


def test_an_unnamed_event_of_a_suspended_application(
    lab: Project, make: Make, record: Record
) -> None:
    unnamed = '<event next="2"><when><data tag="x" is="1"/></when></event></expectedevents>'
    lab = make(APP.replace("</expectedevents>", unnamed), SCRIPT)
    recording = record(lab, {"at": 1, "set": {"light": 1}}, {"at": 2, "set": {"x": 1}})
    told = _ask(lab, recording, 3, "enter", state="2")
    assert "- its unnamed event could be taken, but app was suspended since 1 s" in told
    assert "besides, app was suspended" in told
    two = unnamed.replace('next="2"', 'next="1"').replace("</expectedevents>", "") + unnamed
    lab = make(APP.replace("</expectedevents>", two), SCRIPT)
    told = _ask(lab, record(lab, {"at": 2, "set": {"x": 1}}), 2, "enter", state="2")
    assert "its unnamed event could be taken, but by then app was leaving" in told


TAKEN = """<application name="a"><state no="1"><timeout next="2" idle="true">5</timeout>
<expectedevents><event name="go"/><event name="go" next="2"/>
<event name="do"><service name="s" url="http://x/" wait="true"/><set tag="x">1</set></event>
</expectedevents></state><state no="2"/></application>"""


def test_an_event_that_another_took_without_leaving(make: Make, record: Record) -> None:
    project = make(TAKEN)
    told = _ask(project, record(project, {"at": 2, "event": "go"}), 3, "enter", state="2")
    assert told.splitlines() == [
        "- go came at 2 s, and an event before this one took it: event go stays",
        (
            "- its timeout of 5 s had not run out; it counts anew from the end of speech and "
            "from every touch"
        ),
    ]


def test_an_event_that_led_back_before_this_one_could_take_it(make: Make, record: Record) -> None:
    project = make(
        '<application name="a"><state no="1"><expectedevents><event name="on" next="2"/>'
        '</expectedevents></state><state no="2"><expectedevents><event name="go" next="#back"/>'
        '<event name="go" next="3"/></expectedevents></state><state no="3"/></application>'
    )
    recording = record(project, {"at": 1, "event": "on"}, {"at": 2, "event": "go"})
    told = _ask(project, recording, 2, "enter", state="3")
    assert ("go came at 2 s, and an event before this one took it: event go leads to back") in told


def test_an_action_of_an_event_that_was_taken(make: Make, record: Record) -> None:
    project = make(TAKEN)
    told = _ask(project, record(project, {"at": 2, "event": "do"}), 3, "action", action="set")
    assert told == "- do came at 2 s and was taken"


def test_nothing_had_started_yet(door: Project) -> None:
    nothing = Recording.of([])
    for kind, wanted in (("enter", {"state": "2"}), ("event", {"name": "x"}), ("resume", {}),
                         ("transition", {"from": "1", "to": "2"})):  # fmt: skip
        assert _ask(door, nothing, 1, kind, **wanted) == "- door had not started yet"
    with pytest.raises(UsageError, match="no situation"):
        _ask(door, nothing, 1, "situation", to="x")
    assert _ask(door, nothing, 1, "authority", resource="screen", to="door") == (
        "- door did not ask for screen"
    )


def test_a_trace_cut_off_in_a_transition(door: Project, record: Record) -> None:
    events = record(door, {"at": 1, "set": {"distance": 1}}).events
    cut = events[: [e["kind"] for e in events].index("transition") + 1]
    told = _ask(door, Recording.of(cut), 5, "enter", state="5")
    assert told == "- door was in 1 shut since 0 s, and no way leads from there to 5 nowhere"


def test_more_of_authority_and_situations(lab: Project, make: Make, record: Record) -> None:
    told = _ask(lab, record(lab), 1, "situation", to="calm")
    assert told == "- calm was current already, since 0 s"
    kept = SCRIPT.replace('dwell="10"', 'limit="10"').replace(
        '<situation name="held" limit="10"><condition><data tag="hold" is="true"/></condition>',
        '<situation name="held" limit="10"><condition><data tag="hold" is="true"/></condition>'
        '<until><data tag="stop" is="1"/></until>',
    )
    held = {"at": 1, "set": {"hold": True}}, {"at": 2, "set": {"hold": False}}
    project = make(APP, kept)
    told = _ask(project, record(project, *held), 2, "situation", to="calm")
    assert told == (
        "- situation held, which goes before calm, was current since 1 s; "
        "it stays until stop is 1 and it ends after 10 s at the latest"
    )
    free = make(APP)
    told = _ask(free, record(free), 1, "authority", resource="head", to="app")
    assert told == "- app did not ask for head, only for base"
    assert _ask(lab, record(lab), 1, "resume", application="app") == "- app was not suspended"


def test_a_module_that_nobody_gave_a_priority(make: Make, record: Record) -> None:
    known = Modules((Module("arm", ("hand",)),))
    free = make(APP, modules=known, modules_file="modules.xml")
    recording = record(free, {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}})
    told = _ask(free, recording, 2, "authority", resource="hand", to="arm")
    assert told == "- arm has no priority in this project"


def test_a_trace_cut_off_before_authority_was_given(lab: Project, record: Record) -> None:
    acquire = {"at": 1, "acquire": {"module": "arm", "resources": ["hand"]}}
    events = record(lab, acquire).events
    cut = [e for e in events if not (e["kind"] == "authority" and e["t"] == 1)]
    told = _ask(lab, Recording.of(cut), 1, "authority", resource="hand", to="arm")
    assert told == "- nobody held hand"
    late = Recording.of([e for e in events if e["kind"] == "acquire"])
    told = _ask(lab, late, 1, "authority", resource="hand", to="arm")
    assert told == "- arm has no priority in no situation"


def test_giving_back_some_keeps_the_rest(lab: Project, record: Record) -> None:
    given: list[dict[str, Any]] = [
        {"at": 1, "set": {"hold": True}},
        {"at": 1, "acquire": {"module": "arm", "resources": ["base", "hand"]}},
        {"at": 2, "abandon": {"module": "arm", "resources": ["base"]}},
        {"at": 3, "abandon": {"module": "arm", "resources": ["hand"]}},
    ]
    recording = record(lab, *given)
    told = _ask(lab, recording, 2, "authority", resource="base", to="arm")
    assert told == "- arm gave base back at 2 s and has not asked for it again"
    told = _ask(lab, recording, 3, "authority", resource="hand", to="arm")
    assert told == "- arm gave hand back at 3 s and has not asked for it again"
    alone = Recording.of([e for e in recording.events if e["kind"] == "abandon"])
    assert _ask(lab, alone, 4, "authority", resource="hand", to="arm") == told
    again = [
        {"at": 5, "acquire": {"module": "arm", "resources": ["hand"]}},
        {"at": 6, "acquire": {"module": "arm", "resources": ["base"]}},
    ]
    told = _ask(lab, record(lab, *given, *again), 6, "authority", resource="hand", to="arm")
    assert told == "- arm did not ask for hand, only for base"


def test_who_asked_in_vain_and_gave_up_is_told_what_stood_in_the_way_until_then(
    lab: Project, record: Record
) -> None:
    recording = record(
        lab,
        {"at": 1, "set": {"light": 3}},
        {"at": 2, "acquire": {"module": "arm", "resources": ["base", "hand"]}},
        {"at": 3, "set": {"light": 9}},
        {"at": 4, "abandon": {"module": "arm", "resources": ["hand"]}},
        {"at": 6, "abandon": {"module": "arm", "resources": ["base"]}},
        {"at": 8, "set": {"light": 3}},
    )
    vain = "in vain, and not again since"
    hand = [
        f"- arm asked for hand from 2 s to 4 s {vain}",
        "  - arm asks for base and hand together: all of them or none",
        "    - app held base since 3 s: priority 10 against 5 of arm in situation calm",
    ]
    base = [
        f"- arm asked for base from 2 s to 6 s {vain}",
        "  - app held base since 3 s: priority 10 against 5 of arm in situation calm",
    ]
    for at in (6, 8):
        for kind, field in (("authority", "to"), ("mapping", "module")):
            for resource, told in (("hand", hand), ("base", base)):
                wanted = {"resource": resource, field: "arm"}
                assert _ask(lab, recording, at, kind, **wanted).splitlines() == told
    # Given up in one go, of each is told what kept it from that one.
    at_once = record(
        lab,
        {"at": 2, "acquire": {"module": "arm", "resources": ["base", "hand"]}},
        {"at": 4, "abandon": {"module": "arm", "resources": ["base", "hand"]}},
    )
    for resource, count in (("base", 2), ("hand", 3)):
        told = _ask(lab, at_once, 6, "authority", resource=resource, to="arm").splitlines()
        assert told[0] == f"- arm asked for {resource} from 2 s to 4 s {vain}"
        assert len(told) == count
        assert told[-1].lstrip().startswith("- app held base since 0 s")
    # Asked for again it is told how that is now.
    again = record(
        lab,
        {"at": 2, "acquire": {"module": "arm", "resources": ["base"]}},
        {"at": 4, "abandon": {"module": "arm", "resources": ["base"]}},
        {"at": 5, "set": {"light": 3}},
        {"at": 6, "acquire": {"module": "arm", "resources": ["base"]}},
    )
    now = _ask(lab, again, 6, "authority", resource="base", to="arm")
    assert now == "- arm has no priority in situation dark"


def test_a_group_of_all_and_a_tag_that_was_deleted(make: Make, record: Record) -> None:
    group = '<any><all><data tag="x" is="1"/><data tag="y" is="1"/></all></any>'
    project = make(CLOCK.replace('<data tag="clock.time" above="09:00"/>', group))
    recording = record(
        project, {"at": 1, "set": {"x": 1, "y": 1}}, {"at": 2, "set": {"y": None}},
        {"at": 3, "event": "go"},
    )  # fmt: skip
    assert _ask(project, recording, 3, "enter", state="2") == (
        "- go came at 3 s, but its guard did not hold: none of these held: "
        "y is 1: it was nothing, deleted at 2 s by scenario"
    )


def test_which_application_is_meant_has_to_be_said_where_several_fit(
    make: Make, record: Record
) -> None:
    script = '<spds name="s"><situation name="on"><module name="a" priority="1"/>'
    script += '<module name="b" priority="1"/></situation></spds>'
    script = script.replace(
        '<situation', '<modules><module name="a" resources="base"/>'
        '<module name="b" resources="base"/></modules><situation', 1
    )  # fmt: skip
    two = [CLOCK.replace('"app"', f'"{name}"') for name in "ab"]
    project = make(two, script)
    with pytest.raises(UsageError, match="needs an “application” of a, b"):
        why_not(project, record(project), {"kind": "enter", "state": "2"}, 1)


def test_a_limit_alone_and_a_holder_of_less_priority(
    lab: Project, make: Make, record: Record
) -> None:
    until = SCRIPT.replace(' limit="5"', "")
    project = make(APP, until)
    heat = {"at": 1, "set": {"heat": 50}}, {"at": 2, "set": {"heat": 1}}
    told = _ask(project, record(project, *heat), 3, "situation", to="calm")
    assert told.endswith("was current since 1 s; it stays until cooled is true")
    # A trace without its situations: who holds a resource may have less priority than who asks.
    lines_ = {"at": 1, "acquire": {"module": "arm", "resources": ["base"]}}, heat[0]
    events = record(lab, *lines_).events
    late = [e for e in events if not (e["kind"] == "authority" and e["t"] == 1)]
    told = _ask(lab, Recording.of(late), 1, "authority", resource="base", to="arm")
    assert told == "- app held base since 0 s"


def test_an_action_that_was_superseded_before_it_began(make: Make, record: Record) -> None:
    busy = make(BUSY)
    events = [e for e in record(busy).events if e["kind"] != "action"]
    told = _ask(busy, Recording.of(events), 1, "action", action="service")
    assert told == "- it waits for an action before it, or has been superseded"


def test_an_action_waits_for_the_one_that_runs_and_not_for_one_that_ended(
    make: Make, record: Record
) -> None:
    project = make(
        '<application name="a"><state no="1"><backgroundactions>'
        '<robot resource="base" command="turn" wait="true"/>'
        '<robot resource="head" command="nod" wait="true"/><launch program="game"/>'
        "</backgroundactions></state></application>"
    )
    ends = {"at": 1, "finish": {"action": "robot", "name": "turn"}}
    told = _ask(
        project, record(project, ends, {"at": 3, "end": True}), 3, "action", action="launch"
    )
    assert told == "- it waits for robot head nod, running since 1 s"


def test_an_unnamed_event_on_whose_way_something_would_have_been_raised(
    make: Make, record: Record
) -> None:
    project = make(
        '<application name="a"><state no="1"><expectedevents><event next="2"><when>'
        '<data tag="x" is="1"/></when><set tag="y" done="raised">1</set></event>'
        '<event name="raised" next="3"/></expectedevents></state><state no="2"/>'
        '<state no="3"/></application>'
    )
    told = _ask(project, record(project, {"at": 2, "end": True}), 2, "enter", state="3")
    assert "of the unnamed event (x is 1) raises it" in told
    assert "the guard of its unnamed event did not hold: x is 1: it was never set" in told


# -- what only the inputs tell --------------------------------------------------------


CLOCK = """<application name="app"><state no="1"><expectedevents>
<event name="go" next="2"><when><data tag="clock.time" above="09:00"/></when></event>
</expectedevents></state><state no="2"/></application>"""


def test_the_clock_is_in_no_trace_but_known_where_the_scenario_is(
    make: Make, record: Record
) -> None:
    project = make(CLOCK)
    events = {"at": 1, "set": {"clock.time": "08:30"}}, {"at": 2, "event": "go"}
    told = _ask(project, record(project, *events), 2, "enter", state="2")
    assert "clock.time above 09:00: it was “08:30”, set at 1 s by scenario" in told
    told = _ask(project, record(project, *events, alone=True), 2, "enter", state="2")
    assert "clock.time above 09:00: not told by a trace alone" in told


def test_a_recording_of_the_robot_tells_the_clock(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By its inputs; a ring's file, which begins later, by the robot's state."""
    (tmp_path / "app.rbd.xml").write_text(CLOCK)
    (tmp_path / "situ.toml").write_text('[project]\nname = "p"\napplications = ["app.rbd.xml"]\n')
    first, second = tmp_path / "first.mcap", tmp_path / "second.mcap"
    run = Recorded(tmp_path, recorder(first, tmp_path))
    run.at(SECOND, inputs.Set({"clock.time": "08:30"}, "situ"))
    later = Recorded(tmp_path, recorder(second, tmp_path), state=run.robot.snapshot())
    for one in (run, later):
        one.at(2 * SECOND, inputs.Raise("go"))
        one.recorder.close()
    wanted = '{"kind": "enter", "state": "2"}'
    asked = ("--project", str(tmp_path), "--not", wanted, "--at", "2")
    assert main(["why", str(first), *asked]) == 0
    said = "clock.time above 09:00: it was “08:30”, set at 1 s by situ"
    assert said in capsys.readouterr().out
    (step,) = read(second).steps
    assert [(one.t, one.tag, one.value) for one in step.before] == [(2, "clock.time", "08:30")]


def test_a_situation_that_waits_for_the_clock(make: Make, record: Record) -> None:
    condition = '<condition><data tag="clock.time" atleast="09:00"/></condition>'
    script = (
        '<spds name="s"><observe><data tag="clock.time"/></observe><modules><module name="app" '
        f'resources="base"/></modules><situation name="day">{condition}</situation>'
        '<situation name="night"><module name="app" priority="1"/></situation></spds>'
    )
    project = make('<application name="app"><state no="1"/></application>', script)
    lines_ = {"at": 1, "set": {"clock.time": "08:30"}}, {"at": 3, "end": True}
    told = _ask(project, record(project, *lines_), 2, "situation", to="day")
    assert "it was “08:30”, set at 1 s by scenario" in told


# -- what is refused ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("wanted", "said"),
    [
        ({"kind": "exit"}, "wants a “kind” of enter, transition"),
        ({"state": "1"}, "wants a “kind”"),
        ({"kind": "enter"}, "needs “state”"),
        ({"kind": "situation", "to": "none"}, "no situation none, only hot, held, dark, calm"),
        ({"kind": "enter", "state": "1", "application": "x"}, "no application x, only app"),
    ],
)
def test_a_question_that_can_not_be_answered(
    lab: Project, record: Record, wanted: dict[str, Any], said: str
) -> None:
    with pytest.raises(UsageError, match=said):
        why_not(lab, record(lab), wanted, 1)


# -- the command ------------------------------------------------------------------------


@pytest.fixture
def files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> dict[str, str]:
    names = {n: str(tmp_path / n) for n in ("door.rbd.xml", "s.jsonl", "trace.jsonl")}
    Path(names["door.rbd.xml"]).write_text(DOOR, encoding="utf-8")
    Path(names["s.jsonl"]).write_text('{"at":1,"event":"home"}\n{"at":2,"set":{"distance":1}}\n')
    status = main(
        ["simulate", names["door.rbd.xml"], "--script", names["s.jsonl"], "--trace",
         names["trace.jsonl"]]
    )  # fmt: skip
    assert status == 0
    capsys.readouterr()
    return {
        "project": names["door.rbd.xml"],
        "script": names["s.jsonl"],
        "trace": names["trace.jsonl"],
    }


def test_the_chain_is_printed(files: dict[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    last = len(Path(files["trace"]).read_text().splitlines())
    for args in (
        [files["trace"], str(last), "--project", files["project"]],
        [str(last), "--project", files["project"], "--script", files["script"]],
    ):
        assert main(["why", *args]) == 0
        out = capsys.readouterr().out.splitlines()
        assert out[0].endswith("scenario sets distance to 1  (from outside)")
        assert out[-1] == f"2 s  #{last}  door enters 4 inside"
    assert main(["why", files["trace"], str(last), "--json"]) == 0
    assert [event["kind"] for event in json.loads(capsys.readouterr().out)] == [
        "data", "transition", "enter",
    ]  # fmt: skip


def test_what_stood_in_the_way_is_printed(
    files: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["--project", files["project"], "--not", '{"kind":"enter","state":"4"}', "--at"]
    for source in ([files["trace"]], ["--script", files["script"]]):
        assert main(["why", *source, *asked, "1.5"]) == 0
        assert capsys.readouterr().out.splitlines()[:2] == [
            "Not at 1.5 s:",
            "- the guard of its unnamed event did not hold: distance below 1.5: it was never set",
        ]
    assert main(["why", files["trace"], *asked, "2"]) == 0
    assert capsys.readouterr().out.startswith("It did happen: 2 s  #")
    assert main(["why", files["trace"], *asked, "3"]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == [
        "By 3 s it had happened:",
        "- door was in 4 inside already, since 2 s  (#13)",
    ]
    assert main(["why", files["trace"], *asked, "1.5", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["reasons"][0]["code"], told["ends"]) == ("guard", None)


def test_a_moment_after_the_end_of_what_is_recorded_is_told_in_one_line(
    files: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["--project", files["project"], "--not", '{"kind":"enter","state":"2"}', "--at"]
    with Path(files["script"]).open("a") as script:
        script.write('{"at":5,"end":true}\n')
    # A trace alone is known until its last event.
    for source, end in ([files["trace"]], 2), (["--script", files["script"]], 5):
        said = f"What is recorded ends at {end} s: the rest is so if nothing happened since."
        assert main(["why", *source, *asked, str(end)]) == 0
        assert said not in capsys.readouterr().out
        assert main(["why", *source, *asked, str(end + 0.1)]) == 0
        assert capsys.readouterr().out.splitlines()[:2] == [said, f"Not at {end + 0.1:g} s:"]
        assert main(["why", *source, *asked, "99", "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["ends"] == end


def test_a_timeout_is_not_told_to_have_had_more_time_than_it_needs(
    door: Project, record: Record
) -> None:
    recording = record(door, {"at": 1, "end": True})
    said = "- its timeout of 30 s had not run out"
    assert f"{said}: 30 s had passed" in _ask(door, recording, 30, "enter", state="3")
    assert said in _ask(door, recording, 31, "enter", state="3").splitlines()


def test_nothing_is_known_after_the_end_of_an_empty_recording(door: Project) -> None:
    wanted = {"kind": "enter", "state": "2"}
    assert why_not(door, Recording.of([]), wanted, 0).ends is None
    assert why_not(door, Recording.of([]), wanted, 1).ends == 0
    assert why_not(door, record_run(door, [])[0], wanted, 1).ends == 0


@pytest.mark.parametrize(
    "args",
    [
        [],
        ["{trace}"],
        ["{trace}", "x"],
        ["{trace}", "0"],
        ["{trace}", "1", "--not", "{{}}"],
        ["{trace}", "--not", '{{"kind":"enter"}}'],
        ["{trace}", "--not", "[]", "--at", "1", "--project", "{project}"],
        ["{trace}", "--not", "nonsense", "--at", "1", "--project", "{project}"],
        ["{script}", "1"],
        ["/none", "1"],
        ["{project}", "1"],
        ["1", "--script", "{script}"],
        ["--not", '{{"kind":"enter","state":"1"}}', "--at", "1", "--project", "{project}"],
        ["{trace}", "1", "--project", "/none"],
    ],
)
def test_wrong_usage_is_one_line_and_status_2(
    files: dict[str, str], capsys: pytest.CaptureFixture[str], args: list[str]
) -> None:
    assert main(["why", *(arg.format(**files) for arg in args)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1


# -- parts ---------------------------------------------------------------------

VISIT = """<application name="visit">
<always><expectedevents><event name="home" next="1"/></expectedevents></always>
<state no="1" name="hall"><expectedevents><event name="in" next="2"/>
  <event name="anew" next="#again"/></expectedevents></state>
<state no="2" name="desk"><flow src="desk.rbd.xml"/><expectedevents>
  <event name="done.known" next="3"/><event name="done" next="1"/>
  <event name="anew" next="#again"/></expectedevents></state>
<state no="3" name="room"><expectedevents><event name="out" next="1"/></expectedevents></state>
</application>"""
DESK = """<application name="desk">
<state no="a" name="ask"><expectedevents><event name="yes" next="b"/><event name="no" next="gone"/>
</expectedevents></state>
<state no="b" name="look up"><expectedevents><event name="found" next="known"/></expectedevents>
</state>
<state no="known" final="true"/><state no="gone" final="true"/>
</application>"""


@pytest.fixture
def visit(make: Make) -> Project:
    return make(VISIT, parts={"desk.rbd.xml": make(DESK).applications["0.rbd.xml"]})


@pytest.fixture
def visited(visit: Project, record: Record) -> Recording:
    events = {1: "in", 2: "yes", 4: "home", 5: "in", 6: "no"}
    return record(visit, *({"at": at, "event": name} for at, name in events.items()))


def test_the_end_of_a_part_comes_from_its_end_state_and_that_has_a_way(
    visit: Project, visited: Recording
) -> None:
    assert _ask(visit, visited, 3, "enter", state="3") == (
        "- event done.known did not come while visit was in 2/b look up, since 2 s\n"
        "  - it comes when the part enters its end state 2/known\n"
        "    - event found did not come while visit was in 2/b look up, since 2 s\n"
        "      - it comes from outside: from a module, a message, or the blackboard"
    )


def test_done_comes_from_ends_without_an_event_of_their_own(
    visit: Project, visited: Recording
) -> None:
    told = _ask(visit, visited, 1.5, "event", name="done")
    assert "enters its end state 2/gone" in told
    assert "event no did not come" in told
    assert "known" not in told


def test_the_nearest_way_to_an_end_is_told_from_afar(visit: Project, visited: Recording) -> None:
    told = _ask(visit, visited, 1.5, "transition", **{"from": "2", "to": "3"})
    assert (
        "visit was in 2/a ask since 1 s; the nearest way to 2/known: "
        "yes → 2/b look up, found → 2/known"
    ) in told


def test_a_state_that_holds_a_part_is_one_to_be_in_and_to_go_to(
    visit: Project, visited: Recording
) -> None:
    assert _ask(visit, visited, 5.5, "enter", state="2") == (
        "- visit was in 2 desk already, since 5 s"
    )
    told = _ask(visit, visited, 4.5, "transition", **{"from": "2", "to": "3"})
    assert told.startswith("- visit was in 1 hall since 4 s\n  - event in did not come")
    told = _ask(visit, visited, 4.5, "enter", state="2/b")
    assert "the nearest way to 2/b look up: in → 2/a ask, yes → 2/b look up" in told


def test_a_part_begun_anew_is_entered_at_its_start(visit: Project, visited: Recording) -> None:
    told = _ask(visit, visited, 2.5, "enter", state="2/a")
    assert "event anew did not come while visit was in 2/b look up" in told
    assert "event anew" not in _ask(visit, visited, 2.5, "transition", **{"from": "2/b", "to": "3"})


def test_a_state_that_there_is_not_is_told_so(visit: Project, visited: Recording) -> None:
    with pytest.raises(UsageError, match="visit has no state 2/c"):
        _ask(visit, visited, 2, "enter", state="2/c")


def test_a_state_left_because_a_deploy_lacks_it_is_left() -> None:
    flow = '<application name="app"><state no="{}"><expectedevents><event name="go" next="2"/>'
    flow += '</expectedevents></state><state no="2"/></application>'
    before, after = ({"a.rbd.xml": flow.format(no)} for no in ("1", "7"))
    events: list[TraceEvent] = []
    project, new = (deployed.read(files)[0] for files in (before, after))
    assert project is not None
    assert new is not None
    rehearsal = Rehearsal(project, events.extend)
    rehearsal.give(inputs.Deploy(1, after, "operator:ann"), 2_000_000)
    recording = Recording.of(list(map(to_fields, events)))
    found, _ = stays(new, recording, "app", 9)
    assert [(one.state, one.at(1), one.at(9)) for one in found] == [
        ("1", True, False),
        ("7", False, True),
    ]
