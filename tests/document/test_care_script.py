"""Care with what decides and who is called: what must be found, and what must be left alone."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.document.care_projects import (
    WIDE,
    always,
    app,
    mended,
    places,
    state,
    told,
    whole,
)

from situ.decide.trace import TraceEvent, to_fields
from situ.document.analysis_search import Search
from situ.document.care_script import isnot_alone
from situ.document.project import Project
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate

# -- what stops the robot ----------------------------------------------------------

MODULES = (
    '<observe><data tag="stop" type="boolean"/></observe><modules>'
    '<module name="transfer" resources="base head"/><module name="gaze" resources="head"/>'
    '<module name="a" resources="screen speech"/></modules>'
)
DAY = (
    '<situation name="day"><module name="{}" priority="1"/><module name="a" priority="1"/>'
    "</situation>"
)
STOPPED = (
    '<situation name="stopped" {}><condition><data tag="stop" is="true"/></condition>{}</situation>'
)
EVENING = STOPPED.replace("stopped", "evening").replace("true", "false")
EVENING = EVENING.format("", '<module name="transfer" priority="2"/>')


@pytest.mark.parametrize(
    ("first", "mover", "is_told"),
    [
        ("", "transfer", True),
        ("", "gaze", False),
        (STOPPED.format("", ""), "transfer", False),
        # Who only turns the head, speaks or shows may go on.
        (STOPPED.format("", '<module name="gaze" priority="1"/>'), "transfer", False),
        (STOPPED.format("", '<module name="transfer" priority="1"/>'), "transfer", True),
        (STOPPED.format('limit="5"', ""), "transfer", True),
        (STOPPED.format('extends="day"', ""), "transfer", True),
        (
            STOPPED.format('extends="day"', '<module name="transfer" priority="none"/>'),
            "transfer",
            False,
        ),
        # Not the first.
        (EVENING + STOPPED.format("", ""), "transfer", True),
    ],
)
def test_a_script_without_a_first_situation_that_takes_all_away_is_told(
    first: str, mover: str, is_told: bool
) -> None:
    project = whole(state(), script=MODULES + first + DAY.format(mover))
    assert bool(told(project, "nothing-stops")) is is_told


def test_the_mend_begins_with_a_situation_that_stops() -> None:
    project = whole(state(), script=MODULES + DAY.format("transfer"))
    (problem,) = told(project, "nothing-stops")
    assert problem.place == ("situation", "day")
    after = mended(project, problem)
    assert told(after, "nothing-stops") == []
    assert after.spds is not None
    assert [one.name for one in after.spds.situations] == ["stopped", "day"]
    assert [one.tag for one in after.spds.observe] == ["robot.stop", "stop"]


def test_the_mend_observes_nothing_twice_and_takes_no_name_that_is_taken() -> None:
    observed = MODULES.replace('tag="stop"', 'tag="robot.stop"')
    project = whole(state(), script=observed + DAY.format("transfer"))
    after = mended(project, told(project, "nothing-stops")[0])
    assert after.spds is not None
    assert [one.tag for one in after.spds.observe] == ["robot.stop"]
    taken = MODULES + STOPPED.format('limit="5"', "") + DAY.format("transfer")
    (problem,) = told(whole(state(), script=taken), "nothing-stops")
    assert problem.mend is None


def test_an_application_that_moves_the_robot_must_be_stopped_too() -> None:
    moves = state(acts='<robot resource="base" command="go"/>')
    script = '<modules><module name="a" resources="base"/></modules>' + DAY.format("a").replace(
        '<module name="a" priority="1"/>', "", 1
    )
    assert told(whole(moves, script=script), "nothing-stops") != []


def test_without_a_script_the_first_robot_action_is_told_in_a_whole_project() -> None:
    acts = '<robot resource="head" command="nod"/><robot resource="base" command="go"/>'
    project = whole(state(acts=acts))
    assert places(project, "nothing-stops") == [("state", "1", "action", "1")]
    assert told(whole(state(acts=acts.partition("/>")[0] + "/>")), "nothing-stops") == []
    alone = Project(root="x", name="a", applications=project.applications)
    assert told(alone, "nothing-stops") == []


# -- isnot -------------------------------------------------------------------------


def when(condition: str) -> str:
    return f'<event name="e" next="#again"><when>{condition}</when></event>'


@pytest.mark.parametrize(
    ("condition", "place"),
    [
        ('<data tag="x" isnot="1"/>', "0"),
        ('<data tag="y" is="1"/><data tag="x" isnot="1"/>', "1"),
        ('<data tag="y" is="1"/><any><data tag="x" isnot="1"/><data tag="y" is="2"/></any>', "1 0"),
        ('<all><data tag="x" isnot="1"/></all>', "0 0"),
        ('<any><data tag="x" is="2"/><data tag="x" isnot="1"/></any>', "0 1"),
        ('<data tag="x" exists="false"/><data tag="x" isnot="1"/>', "1"),
        ('<data tag="x.y" isnot="1"/><data tag="x" exists="true"/>', "0"),
        ('<any/><data tag="x" isnot="1"/>', "1"),
        # Another test asks for the value.
        ('<data tag="x" exists="true"/><data tag="x" isnot="1"/>', ""),
        ('<data tag="x" isnot="1"/><data tag="x" above="0"/>', ""),
        ('<data tag="x" isnot="1" within="3"/>', ""),
        ('<data tag="x" isnot="1"/><data tag="x" isnot="2" within="3"/>', ""),
        ('<data tag="x" isnot="1"/><data tag="x.y" is="2"/>', ""),
        ('<data tag="x" exists="true"/><any><data tag="x" isnot="1"/></any>', ""),
        ('<all><data tag="x" exists="true"/></all><data tag="x" isnot="1"/>', ""),
        ('<any><data tag="x" is="2"/><data tag="x" is="3"/></any><data tag="x" isnot="1"/>', ""),
        ('<none><data tag="x" exists="false"/></none><data tag="x" isnot="1"/>', ""),
        # It is meant.
        ('<any><data tag="x" exists="false"/><data tag="x" isnot="1"/></any>', ""),
        ('<any><data tag="x" exists="false"/><all><data tag="x" isnot="1"/></all></any>', ""),
        # The opposite of a value that is missing.
        ('<none><data tag="x" isnot="1"/></none>', ""),
        # The runtime keeps it.
        ('<data tag="clock.weekday" isnot="1"/>', ""),
        ('<data tag="application/a.state" isnot="1"/>', ""),
        ('<data tag="clock.alarm" isnot="1"/>', "0"),
    ],
)
def test_an_isnot_that_holds_on_a_missing_value_is_told(condition: str, place: str) -> None:
    project = whole(state(events=when(condition)))
    at = ("state", "1", "event", "0", "when", *place.split())
    assert places(project, "isnot-without-exists") == ([at] if place else [])


def test_every_condition_is_looked_at() -> None:
    test = '<data tag="x" isnot="1"/>'
    script = (
        f'<situation name="s"><condition>{test}</condition><until>{test}</until></situation>'
        f'<situation name="t" dwell="1"><condition>{test}</condition></situation>'
    ) + DAY.format("a")
    project = whole(
        always(events=when(test)) + state(), app(state(events=when(test)), "part"), script=script
    )
    assert places(project, "isnot-without-exists") == [
        ("always", "event", "0", "when", "0"),
        ("state", "1", "event", "0", "when", "0"),
        ("situation", "s", "condition", "0"),
        ("situation", "s", "until", "0"),
        ("situation", "t", "condition", "0"),
    ]


def test_the_mend_asks_that_it_exists_where_all_must_hold() -> None:
    project = whole(state(events=when('<data tag="y" is="1"/><data tag="x" isnot="1"/>')))
    (problem,) = told(project, "isnot-without-exists")
    assert told(mended(project, problem), "isnot-without-exists") == []
    either = whole(state(events=when('<any><data tag="x" isnot="1"/></any>')))
    assert [problem.mend for problem in told(either, "isnot-without-exists")] == [None]


@pytest.mark.parametrize(
    ("tags", "acts", "is_told"),
    [
        ({"x": "a"}, "", False),
        ({"y": "a"}, "", True),
        ({}, '<set tag="x">1</set>', False),
        ({}, '<robot resource="head" command="nod" wait="true"/><set tag="x">1</set>', True),
        ({}, '<set tag="x">{y}</set>', True),
        # Something may take it away.
        ({"x": "a"}, '<clear tag="*"/>', True),
        ({"x": "a"}, '<clear tag="y.*"/>', False),
        ({"x": "a"}, '<set tag="x">{y}</set>', True),
        ({"x": "a"}, '<set tag="x">null</set>', True),
        ({"x": "a"}, '<set tag="x">a {y}</set>', False),
        ({"x": "a"}, '<take from="y" tag="x"/>', True),
        ({"x": "a"}, '<service name="s" url="http://a/b"><result tag="x"/></service>', True),
    ],
)
def test_what_is_given_and_never_taken_away_needs_no_exists(
    tags: dict[str, Any], acts: str, is_told: bool
) -> None:
    project = whole(state(acts=acts, events=when('<data tag="x" isnot="1"/>')), tags=tags)
    assert bool(told(project, "isnot-without-exists")) is is_told


def test_what_a_list_writes_may_be_missing() -> None:
    chosen = f'<list id="l" {WIDE} items="all" tag="x"/>'
    other = f'<list id="m" {WIDE} items="all"/>'
    events = when('<data tag="x" isnot="1"/>')
    assert told(whole(state(other, events=events), tags={"x": 2}), "isnot-without-exists") == []
    assert told(whole(state(chosen, events=events), tags={"x": 2}), "isnot-without-exists") != []


# -- calls -------------------------------------------------------------------------

SCREEN = f'<text id="t" {WIDE}>Hello</text>'
CALL = '<message topic="nurse/call">1</message>'
CALLED = f'<event name="fall">{CALL}</event>'
NIGHT = '<situation name="night"><condition><data tag="x" is="1"/></condition>{}</situation>'
OBSERVED = '<observe><data tag="x"/></observe>'


def calling(
    *applications: Any, night: str = "", day: str = "", resources: str = "base", own: int = 5
) -> Project:
    """The application is not in the script by night, unless ``night`` says so."""
    script = (
        f'{OBSERVED}<modules><module name="a" resources="screen speech base head"/>'
        f'<module name="m" resources="{resources}"/></modules>{NIGHT.format(night)}'
        f'<situation name="day"><module name="a" priority="{own}"/>{day}</situation>'
    )
    return whole(*applications, script=script)


ACTION = ("state", "1", "action", "0")
IN_EVENT = ("state", "1", "event", "0", "action", "0")


@pytest.mark.parametrize(
    ("state_", "place"),
    [
        (state(SCREEN, CALL), ACTION),
        (state(SCREEN, events=CALLED), IN_EVENT),
        (state(acts="<speech>Help</speech>", events=CALLED), IN_EVENT),
        (state(acts='<robot resource="head" command="nod"/>', events=CALLED), IN_EVENT),
        (state('<screen touched="fall"/>', events=CALLED), IN_EVENT),
        (state(SCREEN, CALL.replace("nurse/call", "nurseCall")), ACTION),
        (state(SCREEN, '<service name="callForHelp" url="http://a/b"/>'), ACTION),
        (state(SCREEN, CALL.replace("nurse/call", "fall/ALERT")), ACTION),
        # Nobody is called.
        (state(SCREEN, CALL.replace("nurse/call", "recall/called")), None),
        (state(SCREEN, '<service name="findPatients" url="http://a/call"/>'), None),
        # Nothing suspends it.
        (state(acts=CALL), None),
        (state("<screen/>", events=CALLED), None),
        (state(acts='<speech optional="true">Help</speech>', events=CALLED), None),
        (state(acts='<robot resource="head" command="nod" optional="true"/>', events=CALLED), None),
    ],
)
def test_a_call_that_is_only_made_where_it_can_be_suspended_is_told(
    state_: str, place: tuple[str, ...] | None
) -> None:
    assert places(calling(state_), "suspended-call") == ([place] if place else [])
    # Without a script nothing suspends it.
    assert told(whole(state_), "suspended-call") == []


@pytest.mark.parametrize(
    ("night", "day", "resources", "is_told"),
    [
        ('<module name="a" priority="1"/>', "", "base", False),
        ('<module name="a" priority="1"/><module name="m" priority="2"/>', "", "base", False),
        ('<module name="a" priority="1"/><module name="m" priority="2"/>', "", "screen", True),
        ('<module name="a" priority="1"/><module name="m" priority="1"/>', "", "screen", True),
        ('<module name="a" priority="2"/><module name="m" priority="1"/>', "", "screen", False),
        ('<module name="a" priority="1"/>', '<module name="m" priority="9"/>', "screen", True),
    ],
)
def test_what_suspends_a_call_is_no_priority_or_another_of_at_least_the_same(
    night: str, day: str, resources: str, is_told: bool
) -> None:
    project = calling(state(SCREEN, CALL), night=night, day=day, resources=resources)
    assert bool(told(project, "suspended-call")) is is_told


def test_one_sure_way_for_a_call_is_enough() -> None:
    sure = state(events=CALLED, no="2")
    leads = '<event name="x" next="2"/>'
    assert told(calling(state("<screen/>", CALL, leads) + sure), "suspended-call") == []
    shown = state(SCREEN, CALL, leads)
    apart = state("<screen/>", CALL.replace("nurse/call", "sos"), no="2")
    assert places(calling(shown + apart), "suspended-call") == [ACTION]


@pytest.mark.parametrize(
    ("states", "is_told"),
    [
        # The screen of the state before it is kept.
        (state(SCREEN, events='<event name="fall" next="2"/>') + state(acts=CALL, no="2"), True),
        (
            state(SCREEN, events='<event name="a" next="2"/>')
            + state(events='<event name="b" next="3"/>', no="2")
            + state(acts=CALL, no="3"),
            True,
        ),
        # Not always, or not surely.
        (
            state(SCREEN, events='<event name="a" next="2"/><event name="b" next="3"/>')
            + state(acts=CALL, no="2")
            + state("<screen/>", events='<event name="a" next="2"/>', no="3"),
            False,
        ),
        (
            state(acts=CALL, events='<event name="a" next="2"/>')
            + state(SCREEN, events='<event name="a" next="1"/>', no="2"),
            False,
        ),
        (state(SCREEN) + state(acts=CALL, no="2"), False),
    ],
)
def test_a_screen_that_is_surely_kept_suspends_a_call(states: str, is_told: bool) -> None:
    assert bool(told(calling(states), "suspended-call")) is is_told


def test_always_suspends_and_calls_where_it_is_part_of_a_state() -> None:
    assert told(calling(always(SCREEN) + state(acts=CALL)), "suspended-call") != []
    apart = state(acts=CALL, attributes='always="false"')
    assert told(calling(always(SCREEN) + apart), "suspended-call") == []
    calls = always(events=CALLED)
    place = ("always", "event", "0", "action", "0")
    assert places(calling(calls + state(SCREEN)), "suspended-call") == [place]
    # From one of its states it gets out.
    bare = state("<screen/>", no="2")
    assert told(calling(calls + state(SCREEN) + bare), "suspended-call") == []


def test_a_call_in_a_part_is_suspended_with_what_holds_it() -> None:
    flow = '<state no="1"><flow src="part1.rbd.xml"/></state>'
    part = app(state(acts=CALL), "part")
    assert told(calling(flow, part), "suspended-call") == []
    (problem,) = told(calling(always(SCREEN) + flow, part), "suspended-call")
    assert problem.file == "nowhere/part1.rbd.xml"
    twice = flow + flow.replace('no="1"', 'no="2"')
    assert told(calling(twice, part), "suspended-call") == []


PRIORITIES = st.sampled_from([None, 1, 3])


RESOURCES = st.sampled_from(["base", "screen"])


@settings(max_examples=40, deadline=None)
@given(PRIORITIES, st.sampled_from([1, 3]), PRIORITIES, PRIORITIES, RESOURCES)
def test_what_is_told_is_what_a_run_can_suspend(
    night: int | None, day: int, rival_night: int | None, rival_day: int | None, resources: str
) -> None:
    def entry(module: str, priority: int | None) -> str:
        return f'<module name="{module}" priority="{priority}"/>' if priority is not None else ""

    def of_rival(priority: int | None) -> str:
        # Never a tie: then who asked first would count.
        return entry("m", priority + 1 if priority is not None else None)

    project = calling(
        state(SCREEN, CALL),
        night=entry("a", night) + of_rival(rival_night),
        day=of_rival(rival_day),
        resources=resources,
        own=day,
    )
    lines = (
        f'{{"at":1,"acquire":{{"module":"m","resources":["{resources}"]}}}}\n'
        '{"at":2,"set":{"x":1}}\n{"at":3,"end":true}\n'
    )
    events: list[TraceEvent] = []
    simulate(project, scenario.parse(lines.encode(), "s.jsonl", ["a"]), tell=events.extend)
    suspended = any(to_fields(event)["kind"] == "suspend" for event in events)
    assert bool(told(project, "suspended-call")) is suspended


def test_where_a_place_is_anothers_too_nothing_is_mended() -> None:
    # The error about the two states comes first.
    twice = state() + state(events=when('<data tag="x" isnot="1"/>'))
    search = Search(whole(twice))
    isnot_alone(search)
    assert [one.mend for one in search.found["a0.rbd.xml"]] == [None]


def test_what_is_meant_is_accepted_where_it_stands() -> None:
    meant = state(events=when('<data tag="x" isnot="1" ed:accept="isnot-without-exists"/>'))
    assert told(whole(meant), "isnot-without-exists") == []
    around = state(SCREEN, CALL, attributes='ed:accept="suspended-call"')
    assert told(calling(around), "suspended-call") == []
    assert told(calling(around), "accept-unused") == []


def test_an_application_that_uses_nothing_has_a_priority_all_the_same() -> None:
    """The mend of a call that may wait is no mistake itself."""
    script = (
        '<modules><module name="a" resources=""/></modules>'
        '<situation name="day"><module name="a" priority="1"/></situation>'
    )
    project = whole(state(acts=CALL), script=script)
    for code in ("suspended-call", "never-wins", "application-without-priority"):
        assert told(project, code) == []
