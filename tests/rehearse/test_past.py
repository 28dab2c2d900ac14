"""The robot looked at afterwards is the robot that was: the past judges as it did."""

from __future__ import annotations

import json
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.rehearse.recorded_robot import Recorded, recorder

from situ.decide.inputs import Input
from situ.document.folder import load
from situ.document.project import Project
from situ.rehearse import scenario
from situ.rehearse.clock import Hidden
from situ.rehearse.coverage import Coverage
from situ.rehearse.past import Past
from situ.rehearse.recording import Recording, read, record
from situ.rehearse.ways import leads_to

if TYPE_CHECKING:
    from tests.rehearse.conftest import Make

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
EVERY = sorted(EXAMPLES.glob("*/scenarios/*.jsonl"))
# No trace tells the clock: what it led to can be judged from a recording only.
BY_THE_CLOCK = [file for file in EVERY if '"clock.' in file.read_text("utf-8")]
SCENARIOS = [file for file in EVERY if file not in BY_THE_CLOCK]

MAZE = """<application name="maze">
<always><timeout next="1">7</timeout><expectedevents>
  <event name="e" next="1"><when><data tag="a" is="3" within="2"/></when></event>
  <event name="back" next="#back"/></expectedevents></always>
<state no="1"><expectedevents>
  <event name="e" next="2"><when><data tag="a" above="1"/></when></event>
  <event name="e"><when><data tag="b" is="{a}"/></when><set tag="c">{a}</set></event>
  <event name="f" next="3"><when><none><data tag="a" exists="true" within="3"/></none></when>
  </event></expectedevents></state>
<state no="2"><timeout>2</timeout><expectedevents>
  <event name="timeout" next="3"><when><data tag="b" isnot="2"/></when></event>
  <event name="e" next="#again"/>
  <event next="3"><when><any><data tag="a" is="2" for="1.5"/><data tag="c" is="1"/></any></when>
  </event></expectedevents></state>
<state no="3" always="false"><backgroundactions><robot resource="base" command="x" done="f"/>
  </backgroundactions><expectedevents>
  <event name="f" next="1"/><event name="e" next="#back"/>
  <event name="resumed" next="2"><when><data tag="b" is="1"/></when></event>
  <event next="1"><when><data tag="application/maze.suspended" is="true"/></when></event>
  </expectedevents></state></application>"""
SCRIPT = """<spds name="s"><modules><module name="maze" resources="base"/></modules>
<situation name="off" limit="3"><condition><data tag="b" is="3"/></condition>
<until><data tag="a" is="1"/></until></situation>
<situation name="on"><module name="maze" priority="1"/></situation></spds>"""


def _lines(seed: int) -> list[dict[str, Any]]:
    random, at, found = Random(seed), 0.0, []
    for _ in range(random.randrange(1, 40)):
        at = round(at + random.choice([0, 0, 0.5, 1, 2.5]), 3)
        verb = random.choice(["set", "set", "event", "event", "finish"])
        given: dict[str, Any] = {"action": "robot"}
        if verb == "set":
            tags = random.sample(["a", "b", "c"], random.choice([1, 1, 2]))
            given = {tag: random.choice([1, 2, 3, None]) for tag in tags}
        found.append({"at": at, verb: random.choice("eeefb") if verb == "event" else given})
        if found[-1].get("event") == "b":
            found[-1]["event"] = "back"
    return found


def _record(project: Project, lines: list[dict[str, Any]]) -> Recording:
    text = "\n".join(map(json.dumps, lines)).encode()
    return record(project, scenario.parse(text, "s"))[0]


def _agrees(project: Project, recording: Recording) -> None:
    """Every event is judged in the past as the robot judged it."""
    past = Past(project, recording.whole)
    events = recording.events
    clock: dict[int, list[Hidden]] = {}
    seen = 0
    for step in recording.steps:
        clock.setdefault(seen, []).extend(step.before)
        seen += len(step.events)
    for place, event in enumerate(events):
        for hidden in clock.get(place, ()):
            past.keep(hidden)
        name, kind = event.get("application", ""), event["kind"]
        past.pass_time(event["t"])
        if kind == "event" and past.applications[name].suspended is None:
            tried = past.tried(name, event["name"])
            taken = tried[-1][0] if tried and tried[-1][1] else None
            after = events[place + 1] if place + 1 < len(events) else {"kind": None}
            left = after["kind"] == "exit" and after["cause"] == event["seq"]
            assert left == (taken is not None and taken.to is not None), (event, after)
            ignored = after["kind"] == "ignored" and after["cause"] == event["seq"]
            if ignored:
                assert taken is None
                assert (after["reason"] == "guard") == bool(tried)
        elif kind == "transition":
            way = past.taken(event)
            assert way is not None, event
            if way.to == "#back":
                assert past.back(name, way) == event["to"]
            else:
                assert leads_to(project, name, way, event["from"], event["to"])
        past.take(event)


@given(seed=st.integers(0, 10**9))
@settings(max_examples=150, deadline=None)
def test_every_event_is_judged_as_the_robot_judged_it(make: Make, seed: int) -> None:
    project = make(MAZE, SCRIPT)
    recording = _record(project, _lines(seed))
    _agrees(project, recording)
    _agrees(project, Recording.of(recording.events))


@pytest.mark.parametrize("path", SCENARIOS, ids=lambda path: f"{path.parts[-3]}-{path.stem}")
def test_the_examples_too(path: Path) -> None:
    project, _ = load(path.parents[1])
    assert project is not None
    names = [application.name for application in project.applications.values()]
    recording, _ = record(project, scenario.load(path, names))
    _agrees(project, recording)
    _covers_the_same(project, recording, Recording.of(recording.events))


@pytest.mark.parametrize("path", BY_THE_CLOCK[-1:], ids=lambda path: path.stem)
def test_a_recording_knows_what_the_clock_was_set_to(path: Path, tmp_path: Path) -> None:
    folder, file = path.parents[1], tmp_path / "run.mcap"
    run = Recorded(folder, recorder(file, folder))
    names = [application.name for application in run.project.applications.values()]
    lines = scenario.load(path, names)
    for line in lines:
        if isinstance(line.does, Input):
            run.at(line.at, line.does)
    run.at(lines[-1].at)
    run.recorder.close()
    found = read(file)
    _agrees(run.project, found)
    _covers_the_same(run.project, record(run.project, lines)[0], found)


def _covers_the_same(project: Project, one: Recording, other: Recording) -> None:
    first, second = Coverage(project), Coverage(project)
    first.add(one)
    second.add(other)
    for kind, seen in first.groups().items():
        again = second.groups()[kind]
        assert [s.covered for s in seen] == [s.covered for s in again]
