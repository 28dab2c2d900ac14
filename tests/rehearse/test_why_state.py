"""Why a state was not entered, a transition not gone, an event not raised (``why_state``)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from tests.rehearse.asked import APP, BUSY, CLOCK, SCRIPT, answered, shown

from situ.document.project import Project
from situ.rehearse.recording import Recording
from situ.rehearse.why import why_not

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make, Record


def test_the_event_that_did_not_come_and_what_would_raise_it(door: Project, record: Record) -> None:
    told = answered(door, record(door, {"at": 9, "end": True}), 4, "enter", state="2")
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
    told = answered(door, record(door, {"at": 2, "finish": finish}), 4, "enter", state="2")
    assert "service find raises it when it ends well: it ended badly at 2 s" in told


def test_what_would_have_raised_an_event(make: Make, record: Record) -> None:
    busy = make(BUSY)

    def ask(name: str, *more: dict[str, Any]) -> list[str]:
        return answered(busy, record(busy, *more), 2, "event", name=name).splitlines()[1:]

    assert ask("poked") == ["  - a touch of the screen raises it"]
    assert ask("seen") == ["  - movie film of its screen raises it by its end"]
    assert ask("dark") == ["  - movie film of its screen raises it if it can not play"]
    assert ask("played") == ["  - launch game raises it when it ends well: it had not begun"]
    assert ask("timeout") == ["  - its timeout of 5 s had not run out: 2 s had passed"]
    assert ask("resumed") == ["  - it comes when a suspension ends"]
    assert "none of the phrases" in ask("notunderstood")[0]
    # a and b raise each other: that is told once.
    assert len(ask("a")) == 4


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
    assert shown(answer).splitlines() == [
        "- go came at 3 s, but app was suspended since 2 s: it did not hold base",
        "  - arm held base since 2 s: priority 90 against 10 of app in situation held",
    ]
    assert answered(lab, recording, 3, "resume", application="app").startswith(
        "- it could not go on, as app was suspended"
    )


def test_transitions_of_another_state(door: Project, record: Record) -> None:
    recording = record(door, {"at": 3, "end": True})
    told = answered(door, recording, 2, "transition", **{"from": "2", "to": "4", "event": "go"})
    assert told.startswith("- door was in 1 shut since 0 s")
    told = answered(door, recording, 2, "transition", **{"from": "1", "to": "2", "event": "found"})
    assert told.splitlines()[0] == (
        "- event found did not come while door was in 1 shut, since 0 s"
    )


# -- guards -------------------------------------------------------------------


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
    told = answered(door, recording, 5.9, "enter", state="2")
    assert f"its guard did not hold: {said}\n" in told
    assert "it did happen later, at 6 s" in told
    answer = why_not(door, recording, {"kind": "enter", "state": "2"}, 6)
    assert answer.happened is not None


def test_a_group_of_all_and_a_tag_that_was_deleted(make: Make, record: Record) -> None:
    group = '<any><all><data tag="x" is="1"/><data tag="y" is="1"/></all></any>'
    project = make(CLOCK.replace('<data tag="clock.time" above="09:00"/>', group))
    recording = record(
        project, {"at": 1, "set": {"x": 1, "y": 1}}, {"at": 2, "set": {"y": None}},
        {"at": 3, "event": "go"},
    )  # fmt: skip
    assert answered(project, recording, 3, "enter", state="2") == (
        "- go came at 3 s, but its guard did not hold: none of these held: "
        "y is 1: it was nothing, deleted at 2 s by scenario"
    )


def test_the_unnamed_event_whose_guard_did_not_hold(door: Project, record: Record) -> None:
    recording = record(door, {"at": 1, "set": {"distance": 2.3}})
    told = answered(door, recording, 4, "enter", state="4")
    assert told == (
        "- the guard of its unnamed event did not hold: "
        "distance below 1.5: it was 2.3, set at 1 s by scenario"
    )


def test_an_unnamed_event_of_a_suspended_application(
    lab: Project, make: Make, record: Record
) -> None:
    unnamed = '<event next="2"><when><data tag="x" is="1"/></when></event></expectedevents>'
    lab = make(APP.replace("</expectedevents>", unnamed), SCRIPT)
    recording = record(lab, {"at": 1, "set": {"light": 1}}, {"at": 2, "set": {"x": 1}})
    told = answered(lab, recording, 3, "enter", state="2")
    assert "- its unnamed event could be taken, but app was suspended since 1 s" in told
    assert "besides, app was suspended" in told
    two = unnamed.replace('next="2"', 'next="1"').replace("</expectedevents>", "") + unnamed
    lab = make(APP.replace("</expectedevents>", two), SCRIPT)
    told = answered(lab, record(lab, {"at": 2, "set": {"x": 1}}), 2, "enter", state="2")
    assert "its unnamed event could be taken, but by then app was leaving" in told


def test_an_unnamed_event_that_a_livelock_kept_from_being_taken(make: Make, record: Record) -> None:
    busy = make(BUSY)
    recording = record(busy, {"at": 1, "set": {"loop": 1}})
    state = [e for e in recording.events if e["kind"] == "enter"][-1]["state"]
    other = "3" if state == "1" else "1"
    answer = why_not(busy, recording, {"kind": "enter", "state": other}, 1.5)
    assert "livelock" in [reason.code for reason in answer.reasons]


def test_an_unnamed_event_on_whose_way_something_would_have_been_raised(
    make: Make, record: Record
) -> None:
    project = make(
        '<application name="a"><state no="1"><expectedevents><event next="2"><when>'
        '<data tag="x" is="1"/></when><set tag="y" done="raised">1</set></event>'
        '<event name="raised" next="3"/></expectedevents></state><state no="2"/>'
        '<state no="3"/></application>'
    )
    told = answered(project, record(project, {"at": 2, "end": True}), 2, "enter", state="3")
    assert "of the unnamed event (x is 1) raises it" in told
    assert "the guard of its unnamed event did not hold: x is 1: it was never set" in told


# -- what was taken instead ---------------------------------------------------


def test_the_earlier_event_that_was_taken_instead(door: Project, record: Record) -> None:
    recording = record(door, {"at": 1, "set": {"fire": True, "key": 9}}, {"at": 2, "event": "open"})
    told = answered(door, recording, 2, "enter", state="2")
    assert (
        "open came at 2 s, and an event before this one took it: event open leads to 3 burning"
        in told
    )


TAKEN = """<application name="a"><state no="1"><timeout next="2" idle="true">5</timeout>
<expectedevents><event name="go"/><event name="go" next="2"/>
<event name="do"><service name="s" url="http://x/" wait="true"/><set tag="x">1</set></event>
</expectedevents></state><state no="2"/></application>"""


def test_an_event_that_another_took_without_leaving(make: Make, record: Record) -> None:
    project = make(TAKEN)
    told = answered(project, record(project, {"at": 2, "event": "go"}), 3, "enter", state="2")
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
    told = answered(project, recording, 2, "enter", state="3")
    assert ("go came at 2 s, and an event before this one took it: event go leads to back") in told


def test_an_action_of_an_event_that_was_taken(make: Make, record: Record) -> None:
    project = make(TAKEN)
    told = answered(project, record(project, {"at": 2, "event": "do"}), 3, "action", action="set")
    assert told == "- do came at 2 s and was taken"


def test_back_with_nowhere_to_go_back_to(door: Project, record: Record) -> None:
    told = answered(door, record(door, {"at": 1, "event": "undo"}), 1, "enter", state="2")
    assert "- event undo leads back, and there was nothing to go back to" in told
    assert "event undo" not in answered(
        door, record(door, {"at": 1, "end": True}), 1, "enter", state="2"
    )
    away = {"at": 1, "finish": {"action": "service"}}, {"at": 2, "event": "go"}
    told = answered(door, record(door, *away, {"at": 3, "end": True}), 3, "enter", state="2")
    assert told.startswith("- event undo did not come while door was in 4 inside")
    told = answered(door, record(door, *away, {"at": 3, "end": True}), 3, "enter", state="1")
    assert told.startswith("- event home did not come while door was in 4 inside")
    assert "undo" not in told


# -- timeouts -----------------------------------------------------------------


def test_the_timeout_that_had_not_run_out(door: Project, record: Record) -> None:
    told = answered(door, record(door, {"at": 20, "end": True}), 20, "enter", state="3")
    assert "its timeout of 30 s had not run out: 20 s had passed" in told


def test_a_timeout_is_not_told_to_have_had_more_time_than_it_needs(
    door: Project, record: Record
) -> None:
    recording = record(door, {"at": 1, "end": True})
    said = "- its timeout of 30 s had not run out"
    assert f"{said}: 30 s had passed" in answered(door, recording, 30, "enter", state="3")
    assert said in answered(door, recording, 31, "enter", state="3").splitlines()


def test_a_timeout_that_stands_still_or_goes_on(make: Make, record: Record) -> None:
    lab = make(APP.replace('<state no="1">', '<state no="1"><timeout next="2">9</timeout>'), SCRIPT)
    told = answered(lab, record(lab, {"at": 1, "set": {"light": 1}}), 3, "enter", state="2")
    assert "its timeout of 9 s had not run out; it stands still, since app was suspended" in told
    back = {"at": 1, "set": {"light": 1}}, {"at": 2, "set": {"light": 9}}
    told = answered(lab, record(lab, *back, {"at": 4, "end": True}), 3, "enter", state="2")
    assert "its timeout of 9 s had not run out" in told.splitlines()[-1]


# -- the way there ------------------------------------------------------------


def test_a_state_that_is_far_away_and_the_nearest_way_there(door: Project, record: Record) -> None:
    told = answered(door, record(door, {"at": 30, "end": True}), 31, "enter", state="4")
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
    told = answered(door, recording, 2, "enter", state="5")
    assert told == "- door was in 1 shut since 0 s, and no way leads from there to 5 nowhere"
    told = answered(door, recording, 2, "enter", state="77", application="door")
    assert told == "- door has no state 77"


def test_a_trace_cut_off_in_a_transition(door: Project, record: Record) -> None:
    events = record(door, {"at": 1, "set": {"distance": 1}}).events
    cut = events[: [e["kind"] for e in events].index("transition") + 1]
    told = answered(door, Recording.of(cut), 5, "enter", state="5")
    assert told == "- door was in 1 shut since 0 s, and no way leads from there to 5 nowhere"
