"""docs/semantics.md, *Deploy*: what holds whatever the versions and the moment."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from msgspec.structs import replace
from tests.decide.random_projects import FEW, Play, Scenario, projects, scenarios

from situ.decide import inputs
from situ.decide.robot import Robot
from situ.decide.trace import Deployed, Failed, TraceEvent, to_fields
from situ.document.folder import sources
from situ.document.project import Project
from situ.document.rbd import Application, Event
from situ.document.ready import load_ready
from situ.rehearse import scenario
from situ.rehearse.expect import Expect
from situ.rehearse.simulate import Rehearsal

SCENARIOS = sorted(Path(__file__).parents[2].glob("examples/*/scenarios/*.jsonl"))


def deploy(
    play: Play,
    project: Project,
    version: int,
    force_after: float | None = 0,
    returning: bool = False,
) -> None:
    """Another version comes now."""
    play.robot.prepare(version, project)
    files = {"v": str(version)}
    play.feed([(0, inputs.Deploy(version, files, "operator:ann", force_after, returning))])


def plain(events: Sequence[TraceEvent]) -> list[object]:
    """The events but for those that tell of deploying, numbered anew."""
    told = [event for event in events if not isinstance(event, Deployed)]
    seqs: dict[int | None, int | None] = {one.seq: n for n, one in enumerate(told, 1)}
    return [
        to_fields(event) | {"seq": seqs[event.seq], "cause": seqs.get(event.cause)}
        for event in told
    ]


@FEW
@given(projects(), scenarios, scenarios)
def test_deploying_what_runs_already_changes_nothing(
    project: Project, before: Scenario, after: Scenario
) -> None:
    """At any moment, while actions run, while suspended or paused: byte for byte."""
    play, other = Play(project, 1.0), Play(project, 1.0)
    for one in (play, other):
        one.feed(before)
    assume(not any(isinstance(event, Failed) for event in play.events))
    deploy(other, project, 1, returning=True)
    for one in (play, other):
        one.feed(after)
    assert [e for e in other.events if isinstance(e, Deployed)]
    assert plain(other.events) == plain(play.events)
    assert other.robot.outstanding() == play.robot.outstanding()
    assert other.robot.expected() == play.robot.expected()
    assert other.effects == play.effects


def now(no: str | None) -> str | None:
    return "7" if no == "2" else no


def renumbered(source: Application) -> Application:
    """Its state 2 is 7 now."""

    def led(events: tuple[Event, ...]) -> tuple[Event, ...]:
        return tuple(replace(one, next=now(one.next)) for one in events)

    assert source.always is not None
    states = tuple(
        replace(
            one,
            no=now(one.no) or one.no,
            events=led(one.events),
            timeout=one.timeout and replace(one.timeout, next=now(one.timeout.next)),
        )
        for one in source.states
    )
    return replace(
        source, states=states, always=replace(source.always, events=led(source.always.events))
    )


@st.composite
def versions(draw: st.DrawFn) -> Project:
    """Some without an application, a script, a part or a state that others have."""
    project = draw(projects())
    kept = draw(st.sampled_from(["ab", "ba", "a", ""]))
    applications = {name: project.applications[f"{name}.rbd.xml"] for name in kept}
    if draw(st.booleans()):
        applications = {name: renumbered(one) for name, one in applications.items()}
    parts: dict[str, Application] = {}
    if draw(st.booleans()) and applications:
        running = draw(st.sampled_from(sorted(applications)))
        applications[running] = running_part(applications[running])
        parts["p.rbd.xml"] = replace(project.applications["b.rbd.xml"], name="p")
    script = draw(st.sampled_from([project.spds, None]))
    return replace(project, applications=applications, parts=parts, spds=script)


def running_part(source: Application) -> Application:
    """Its first state runs a part."""
    first, *others = source.states
    return replace(source, states=(replace(first, flow="p.rbd.xml"), *others))


def is_what_its_project_says(robot: Robot) -> None:
    names = [application.name for application in robot.project.applications.values()]
    assert list(robot.expected()) == names
    told = [tag for tag, _ in robot.board.entries("application/*")]
    assert told == sorted(f"application/{name}" for name in names)
    situation, script = robot.board.look("situation"), robot.project.spds
    if script is None:
        assert situation is None
        return
    current = script.situation(situation["name"])
    assert current is not None
    assert situation["priorities"] == script.priorities(current)


@FEW
@given(versions(), versions(), scenarios, scenarios, st.sampled_from([0, 0.7, None]))
def test_any_version_takes_over_from_any_other(
    project: Project, changed: Project, before: Scenario, after: Scenario, force_after: float | None
) -> None:
    """Nothing raises, the trace has no gap, and a snapshot goes on as if nothing had been."""
    play = Play(project, 1.0)
    play.feed(before)
    deploy(play, changed, 1, force_after)
    play.feed(after)
    assert [event.seq for event in play.events] == list(range(1, len(play.events) + 1))
    assert all(event.cause is None or 0 < event.cause < event.seq for event in play.events)
    is_what_its_project_says(play.robot)
    other = Robot(project)
    other.prepare(play.robot.version, play.robot.project)
    other.restore(play.robot.snapshot())
    assert other.snapshot() == play.robot.snapshot()
    assert other.outstanding() == play.robot.outstanding()


@pytest.mark.parametrize("script", SCENARIOS, ids=lambda path: f"{path.parts[-3]}/{path.stem}")
def test_an_example_goes_on_over_a_deploy_as_if_nothing_had_been(script: Path) -> None:
    """From the texts of its files, which have a comment more, in the midst of its scenarios."""
    project = load_ready(script.parents[1])
    files = sources(project)
    changed = {
        name: text + ("<!-- -->" if name.endswith(".xml") else "") for name, text in files.items()
    }
    names = [application.name for application in project.applications.values()]
    lines = scenario.load(str(script), names)
    given_ = [one for one in lines if not isinstance(one.does, (Expect, scenario.End))]
    told = _played(project, given_, None, {})
    for at in (len(given_) // 3, len(given_) // 2):
        assert _played(project, given_, at, changed) == told


def _played(
    project: Project, lines: list[scenario.Line], at: int | None, files: dict[str, str]
) -> list[object]:
    events: list[TraceEvent] = []
    rehearsal = Rehearsal(project, events.extend, auto_finish=2)
    for number, line in enumerate(lines):
        if number == at:
            rehearsal.give(inputs.Deploy(1, files, "operator:ann", 0), rehearsal.now)
        assert not isinstance(line.does, (Expect, scenario.End))
        rehearsal.give(line.does, line.at)
    rehearsal.advance(lines[-1].at + 60_000_000)
    assert len([one for one in events if isinstance(one, Deployed)]) == (at is not None)
    return plain(events)
