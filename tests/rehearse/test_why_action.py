"""Why an action did not begin (``why_action``)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tests.rehearse.asked import APP, BUSY, SCRIPT, answered

from situ.document.project import Project
from situ.rehearse.recording import Recording

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make, Record


def test_an_action_of_a_state_that_was_not_entered(lab: Project, record: Record) -> None:
    told = answered(lab, record(lab), 1, "action", action="set", tag="a")
    assert told.splitlines()[0] == "- app was in 1 since 0 s"
    assert "event go did not come" in told


def test_an_action_that_waits_its_turn(lab: Project, record: Record) -> None:
    recording = record(lab, {"at": 1, "event": "go"}, {"at": 2, "end": True})
    wanted = {"action": "speech", "text": "Hello Ann"}
    told = answered(lab, recording, 2, "action", **wanted)
    assert told.startswith("- it waits for speech “First”, running since 1 s")


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
    told = answered(
        project, record(project, ends, {"at": 3, "end": True}), 3, "action", action="launch"
    )
    assert told == "- it waits for robot head nod, running since 1 s"


def test_an_action_that_was_superseded_before_it_began(make: Make, record: Record) -> None:
    busy = make(BUSY)
    events = [e for e in record(busy).events if e["kind"] != "action"]
    told = answered(busy, Recording.of(events), 1, "action", action="service")
    assert told == "- it waits for an action before it, or has been superseded"


def test_an_optional_action_whose_resource_was_not_held(lab: Project, record: Record) -> None:
    recording = record(
        lab,
        {"at": 0.5, "set": {"hold": True}},
        {"at": 1, "event": "go"},
        {"at": 2, "acquire": {"module": "arm", "resources": ["base"]}},
        {"at": 3, "finish": {"action": "speech"}},
    )
    told = answered(lab, recording, 3, "action", action="robot", name="turn")
    assert told.splitlines()[0] == "- it is optional, and app did not hold base"
    assert "arm held base since 2 s: priority 90 against 10" in told


def test_an_action_that_is_nowhere(lab: Project, record: Record) -> None:
    told = answered(lab, record(lab), 1, "action", action="launch", application="app")
    assert told == "- app has no such action"


def test_an_action_whose_voice_is_taken_or_that_has_begun(make: Make, record: Record) -> None:
    busy = make(BUSY)
    recording = record(busy, {"at": 2, "end": True})
    told = answered(busy, recording, 1, "action", action="sound")
    assert told == "- the voice was taken by speech “One” since 0 s"
    told = answered(busy, recording, 1, "action", action="speech", text="One")
    assert told == "- it began at 0 s already"
    told = answered(busy, recording, 1, "action", action="launch", state="1")
    assert told == "- it waits for service s, running since 0 s"
    ends = {"at": 0.5, "finish": {"action": "service"}}, {"at": 0.6, "finish": {"action": "launch"}}
    told = answered(busy, record(busy, *ends), 1, "action", action="launch", state="2")
    assert told.splitlines()[0] == "- event b did not come while busy was in 2, since 0.6 s"


def test_of_several_actions_that_fit_each_is_told(make: Make, record: Record) -> None:
    busy = make(BUSY)
    told = answered(busy, record(busy, {"at": 1, "touch": True}), 1, "action").splitlines()
    assert "- speech “One” of state 1" in told
    assert "- 6 more actions fit; name its state to be told of one" in told
    told = answered(
        busy, record(busy, {"at": 1, "touch": True}), 1, "action", action="message"
    ).splitlines()
    assert told == ["- poked came at 1 s, but its guard did not hold: a is 1: it was never set"]
    told = answered(busy, record(busy), 1, "action", action="set").splitlines()
    assert told[0] == "- set x = 1 of an event of state 1"
    assert told[1] == "  - event a did not come while busy was in 1, since 0 s"
    told = answered(busy, record(busy), 1, "action", action="launch").splitlines()
    assert "- launch game of an event of state 2" in told


def test_a_speech_in_another_language_is_the_same_action(make: Make, record: Record) -> None:
    lab = make(APP, SCRIPT, languages=("en", "ja"), texts={"ja": {"First": "一"}})
    recording = record(lab, {"at": 0, "set": {"language": "ja"}}, {"at": 1, "event": "go"})
    told = answered(lab, recording, 2, "action", action="speech", text="Hello Ann")
    assert told == "- it waits for speech “First”, running since 1 s"


def test_an_action_of_a_suspended_state(lab: Project, record: Record) -> None:
    recording = record(
        lab, {"at": 1, "set": {"light": 1}}, {"at": 2, "set": {"name": "x"}},
    )  # fmt: skip
    told = answered(lab, recording, 2, "action", action="robot", name="wait").splitlines()
    assert told[0] == (
        "- the state is the right one, but app was suspended since 1 s: it did not hold base"
    )
    assert told[1] == "  - app has no priority in situation dark"
