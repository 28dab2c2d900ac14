"""``situ why``: what led to something, and what kept something from happening (issue 3, 4)."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from tests.rehearse.asked import CLOCK, answered
from tests.rehearse.recorded_robot import Recorded, recorder

from situ.cli import main
from situ.decide import inputs
from situ.decide.step import SECOND
from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse.reason import lines
from situ.rehearse.recording import Recording, read
from situ.rehearse.recording import record as record_run
from situ.rehearse.telling import Teller
from situ.rehearse.why import chain, why_not

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make, Record


# -- chains -------------------------------------------------------------------


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


# -- what there is to tell ----------------------------------------------------


def test_reasons_name_the_events_that_tell_of_them(door: Project, record: Record) -> None:
    recording = record(door, {"at": 1, "event": "open"})
    (guard, *_) = why_not(door, recording, {"kind": "enter", "state": "2"}, 1).reasons
    told = next(event for event in recording.events if event["seq"] == guard.seq)
    assert (told["kind"], told["name"]) == ("event", "open")
    assert lines([guard])[0].endswith(f"  (#{guard.seq})")


def test_what_was_there_already(door: Project, record: Record) -> None:
    answer = why_not(door, record(door), {"kind": "enter", "state": "1"}, 3)
    assert [(r.code, r.text, r.seq) for r in answer.reasons] == [
        ("already", "door was in 1 shut already, since 0 s", 1)
    ]


def test_nothing_had_started_yet(door: Project) -> None:
    nothing = Recording.of([])
    for kind, wanted in (("enter", {"state": "2"}), ("event", {"name": "x"}), ("resume", {}),
                         ("transition", {"from": "1", "to": "2"})):  # fmt: skip
        assert answered(door, nothing, 1, kind, **wanted) == "- door had not started yet"
    with pytest.raises(UsageError, match="no situation"):
        answered(door, nothing, 1, "situation", to="x")
    assert answered(door, nothing, 1, "authority", resource="screen", to="door") == (
        "- door did not ask for screen"
    )


def test_nothing_is_known_after_the_end_of_an_empty_recording(door: Project) -> None:
    wanted = {"kind": "enter", "state": "2"}
    assert why_not(door, Recording.of([]), wanted, 0).ends is None
    assert why_not(door, Recording.of([]), wanted, 1).ends == 0
    assert why_not(door, record_run(door, [])[0], wanted, 1).ends == 0


# -- what only the inputs tell ------------------------------------------------


def test_the_clock_is_in_no_trace_but_known_where_the_scenario_is(
    make: Make, record: Record
) -> None:
    project = make(CLOCK)
    events = {"at": 1, "set": {"clock.time": "08:30"}}, {"at": 2, "event": "go"}
    told = answered(project, record(project, *events), 2, "enter", state="2")
    assert "clock.time above 09:00: it was “08:30”, set at 1 s by scenario" in told
    told = answered(project, record(project, *events, alone=True), 2, "enter", state="2")
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
    told = answered(project, record(project, *lines_), 2, "situation", to="day")
    assert "it was “08:30”, set at 1 s by scenario" in told


# -- what is refused ----------------------------------------------------------


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
