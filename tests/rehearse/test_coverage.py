"""What the scenarios of a project have covered (issue 3, point 4)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from situ.document.project import Project
from situ.rehearse.coverage import Coverage

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make, Record

RBD = """<application name="a">
<always><timeout next="1">9</timeout><expectedevents><event name="home" next="1"/>
</expectedevents></always>
<state no="1" name="first"><expectedevents>
  <event name="go" next="2"><when><data tag="x" is="1"/></when></event>
  <event name="go" next="2"><when><data tag="x" is="2"/></when></event>
  <event name="stay"><when><data tag="y" is="1"/></when></event>
  <event next="3"><when><data tag="z" above="5"/></when></event>
</expectedevents></state>
<state no="2"><timeout next="#again">4</timeout></state>
<state no="3"><expectedevents><event name="undo" next="#back"/></expectedevents></state>
</application>"""

SCRIPT = """<spds name="s"><modules><module name="a" resources="base"/></modules>
<situation name="hot"><condition><data tag="heat" above="9"/></condition>
<until><data tag="cool" is="true"/></until></situation>
<situation name="wet"><condition><data tag="rain" is="true"/></condition></situation>
<situation name="calm"><module name="a" priority="1"/></situation></spds>"""


def _cover(project: Project, *recordings: Any) -> Coverage:
    coverage = Coverage(project)
    for recording in recordings:
        coverage.add(recording)
    return coverage


def _covered(coverage: Coverage, kind: str) -> dict[str, int]:
    return {seen.label: seen.times for seen in coverage.groups()[kind] if seen.times}


def test_states_by_how_often_they_were_entered(make: Make, record: Record) -> None:
    project = make(RBD)
    recording = record(project, {"at": 1, "set": {"z": 6}}, {"at": 2, "event": "undo"})
    assert _covered(_cover(project, recording), "states") == {"a, 1 first": 2, "a, 3": 2}
    assert _cover(project, recording, recording).states["a", "1"].times == 4


def test_transitions_by_the_very_event_that_led_out(make: Make, record: Record) -> None:
    project = make(RBD)
    x, z = {"at": 1, "set": {"x": 2}}, {"at": 1, "set": {"z": 6}}
    coverage = _cover(
        project,
        record(project, x, {"at": 1, "event": "go"}, {"at": 6, "end": True}),
        record(project, z, {"at": 2, "set": {"z": 1}}, {"at": 3, "event": "undo"}),
        record(project, {"at": 2, "event": "home"}, {"at": 11, "end": True}),
    )
    told = [(s.label, s.place, s.times) for s in coverage.groups()["transitions"]]
    assert told == [
        ("a, 1 first – go → 2", ("state", "1", "event", "0"), 0),
        ("a, 1 first – go → 2", ("state", "1", "event", "1"), 1),
        ("a, 1 first – at once → 3", ("state", "1", "event", "3"), 1),
        ("a, always – home → 1 first", ("always", "event", "0"), 1),
        ("a, always – timeout → 1 first", ("always", "timeout"), 1),
        ("a, 2 – timeout → anew", ("state", "2", "timeout"), 1),
        ("a, 3 – undo → back", ("state", "3", "event", "0"), 1),
    ]


def test_guards_both_ways(make: Make, record: Record) -> None:
    project = make(RBD)
    recording = record(
        project,
        {"at": 1, "event": "go"},
        {"at": 2, "set": {"x": 2, "y": 1}},
        {"at": 3, "event": "stay"},
        {"at": 4, "event": "go"},
    )
    seen = _cover(project, recording).conditions

    def both(index: int) -> tuple[int, int]:
        found = seen["0.rbd.xml", ("state", "1", "event", str(index), "when")]
        return found.held, found.failed

    assert both(0) == (0, 2)
    assert both(1) == (1, 1)
    assert both(2) == (1, 0)
    assert both(3)[0] == 0
    assert both(3)[1] > 0
    assert [s.covered for s in seen.values()] == [False, True, False, False]


def test_guards_that_look_at_the_clock(make: Make, record: Record) -> None:
    project = make(
        '<application name="a"><state no="1"><expectedevents><event next="2"><when>'
        '<data tag="clock.time" is="08:00"/></when></event></expectedevents></state>'
        '<state no="2"/></application>'
    )
    recording = record(project, {"at": 1, "set": {"clock.time": "08:00"}})
    assert _cover(project, recording).conditions.popitem()[1].covered


def test_an_unnamed_event_that_holds_and_leads_nowhere_is_not_one_that_failed(
    make: Make, record: Record
) -> None:
    project = make(
        '<application name="a"><state no="1"><expectedevents><event next="#back"><when>'
        '<data tag="x" is="1"/></when></event></expectedevents></state></application>'
    )
    (seen,) = _cover(project, record(project, {"at": 0, "set": {"x": 1}})).conditions.values()
    assert not seen.covered


def test_an_unnamed_event_failed_where_one_after_it_was_taken_at_once(
    make: Make, record: Record
) -> None:
    project = make(
        '<application name="a"><state no="1"><expectedevents><event name="go" next="2"/>'
        '</expectedevents></state><state no="2"><expectedevents>'
        '<event next="1"><when><data tag="x" is="1"/></when></event>'
        '<event next="1"><when><data tag="y" is="1"/></when></event>'
        '<event next="1"><when><data tag="z" is="1"/></when></event>'
        "</expectedevents></state></application>"
    )
    recording = record(project, {"at": 1, "set": {"y": 1}}, {"at": 2, "event": "go"})
    seen = _cover(project, recording).conditions.values()
    assert [(one.held, one.failed) for one in seen] == [(0, 1), (1, 0), (0, 0)]


def test_situations_and_their_conditions_both_ways(make: Make, record: Record) -> None:
    project = make(RBD, SCRIPT)
    recording = record(
        project, {"at": 1, "set": {"heat": 20}}, {"at": 2, "set": {"heat": 1}},
        {"at": 3, "set": {"cool": True}},
    )  # fmt: skip
    coverage = _cover(project, recording)
    assert _covered(coverage, "situations") == {"hot": 1, "calm": 2}
    seen = coverage.conditions
    hot = seen["s.spds.xml", ("situation", "hot", "condition")]
    assert (hot.held, hot.failed) == (1, 2)
    assert seen["s.spds.xml", ("situation", "hot", "until")].covered
    wet = seen["s.spds.xml", ("situation", "wet", "condition")]
    assert (wet.held, wet.failed) == (0, 1)


def test_the_text_names_what_is_missing(make: Make, record: Record) -> None:
    project = make(RBD, SCRIPT)
    told = _cover(project, record(project, {"at": 1, "event": "home"})).lines()
    assert told[:3] == ["states       1 of 3 (33 %)", "  not a, 2", "  not a, 3"]
    assert "transitions  1 of 7 (14 %)" in told
    assert "situations   1 of 3 (33 %)" in told
    assert "  not true: condition of situation hot: heat above 9" in told
    assert "  not true nor false: 0.rbd.xml state 1 event 0: x is 1" in told


def test_the_json_is_what_the_editor_paints(make: Make, record: Record) -> None:
    project = make(RBD, SCRIPT)
    told = _cover(project, record(project, {"at": 1, "event": "home"})).document()
    assert told["transitions"]["covered"] == 1
    assert told["transitions"]["all"] == 7
    (taken,) = [one for one in told["transitions"]["list"] if one["covered"]]
    assert taken == {
        "file": "0.rbd.xml", "place": ["always", "event", "0"], "application": "a",
        "label": "a, always – home → 1 first", "times": 1, "from": "always", "exit": "home",
        "to": "1", "covered": True,
    }  # fmt: skip
    assert {"true", "false"} <= told["conditions"]["list"][0].keys()


def test_a_project_without_a_script_has_no_situations(make: Make, record: Record) -> None:
    project = make(RBD)
    coverage = _cover(project, record(project))
    assert coverage.document()["situations"] == {"covered": 0, "all": 0, "list": []}
    assert not any(line.startswith("situations") for line in coverage.lines())
