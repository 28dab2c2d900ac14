"""Laws that hold whatever the project and the scenario: random ones.

formats.md: *Trace*, and architecture, idea 2 (the same input gives the same bytes; snapshot and
restore).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any
from unittest.mock import patch

from hypothesis import given, settings
from hypothesis import strategies as st
from tests.decide.random_projects import (
    FEW,
    NAMES,
    STATES,
    TAGS,
    Play,
    Scenario,
    conditions,
    projects,
    raised,
    scenarios,
    scripts,
    targets,
    timeouts,
    unnamed,
)

from situ.decide import inputs, machine
from situ.decide.effects import AnyEffect, Begin, Cancel, Map
from situ.decide.robot import Robot
from situ.document.project import Project
from situ.document.rbd import (
    Action,
    Add,
    Always,
    Application,
    Event,
    Set,
    Speech,
    State,
)
from situ.document.spds import Spds

# -- the trace ----------------------------------------------------------------


@FEW
@given(projects(), scenarios)
def test_the_same_input_gives_the_same_bytes(project: Project, scenario: Scenario) -> None:
    one, other = Play(project, 1.0), Play(project, 1.0)
    one.feed(scenario)
    other.feed(scenario)
    assert one.bytes == other.bytes


@FEW
@given(projects(), scenarios)
def test_seq_has_no_gap_and_causes_are_smaller(project: Project, scenario: Scenario) -> None:
    play = Play(project, 1.0)
    play.feed(scenario)
    assert [event.seq for event in play.events] == list(range(1, len(play.events) + 1))
    assert all(event.cause is None or 0 < event.cause < event.seq for event in play.events)
    assert all(one.t <= other.t for one, other in pairwise(play.events))


@FEW
@given(projects(), scenarios, scenarios)
def test_a_robot_goes_on_from_a_snapshot_as_if_nothing_had_been(
    project: Project, before: Scenario, after: Scenario
) -> None:
    play = Play(project, 1.0)
    play.feed(before)
    snapshot = play.robot.snapshot()
    other = Play(project)
    other.robot.restore(snapshot)
    other.now, other.events, play.events = play.now, [], []
    assert other.robot.snapshot() == snapshot
    play.feed(after)
    other.feed(after)
    assert other.bytes == play.bytes
    assert other.robot.snapshot() == play.robot.snapshot()


# -- the short way ------------------------------------------------------------


computes: st.SearchStrategy[Action] = st.one_of(
    st.builds(Set, tag=st.sampled_from(TAGS), text=st.sampled_from(["1", "true", "[1]", "{y}"])),
    st.builds(Set, tag=st.just("clock.time"), text=st.just("1")),
    st.builds(Set, tag=st.just("x"), text=st.just("1"), done=raised),
    st.builds(Add, tag=st.sampled_from(TAGS), text=st.just("1"), done=raised),
)

moves = st.builds(
    Event,
    name=st.sampled_from(NAMES[:3]),
    next=targets,
    when=st.none() | conditions,
    actions=st.lists(computes, max_size=2).map(tuple),
)


@st.composite
def computing(draw: st.DrawFn) -> Application:
    """States that mostly compute and move on; some speak, some wait for conditions."""
    speaks = st.lists(computes | st.just(Speech(text="A", done="said")), max_size=2)
    states = tuple(
        State(
            no=no,
            timeout=draw(timeouts),
            actions=draw(speaks.map(tuple)),
            events=tuple(draw(st.lists(moves | unnamed, max_size=3))),
        )
        for no in STATES
    )
    return Application("a", "1", Always(events=tuple(draw(st.lists(moves, max_size=1)))), states)


@settings(FEW, max_examples=50)
@given(computing(), st.none() | scripts(), scenarios)
def test_the_short_way_is_the_long_way(
    application: Application, script: Spds | None, scenario: Scenario
) -> None:
    """Where all that a transition does is known before, nothing of it changes."""
    project = Project(root=".", name="p", applications={"a.rbd.xml": application}, spds=script)
    short = Play(project, 1.0)
    short.feed(scenario)
    with patch.object(machine, "find", lambda *_: None):
        long = Play(project, 1.0)
        long.feed(scenario)
    assert short.bytes == long.bytes
    assert short.effects == long.effects


# -- what a driver has to do --------------------------------------------------


class Driver:
    """Carries out effects: what stands at each resource, and what has begun and not ended."""

    def __init__(self) -> None:
        self.mapped: dict[str, Map] = {}
        self.begun: dict[int, Begin] = {}
        self.ended: set[int] = set()

    def carry(self, effects: Sequence[AnyEffect]) -> None:
        for effect in effects:
            if isinstance(effect, Map):
                self.mapped[effect.resource] = effect
            elif isinstance(effect, Begin) and effect.action != "message":
                self.begun[effect.id] = effect
            elif isinstance(effect, Cancel) and effect.id not in self.ended:
                del self.begun[effect.id]

    def finish(self, number: int) -> inputs.Finish:
        self.ended.add(number)
        self.begun.pop(number, None)
        return inputs.Finish(id=number)

    def going_on(self) -> list[int]:
        mapped = {number for one in self.mapped.values() for number in one.actions if number}
        return sorted((mapped | self.begun.keys()) - self.ended)

    def values(self) -> dict[str, Any]:
        return {name: one.value for name, one in self.mapped.items()}


@FEW
@given(projects(), scenarios)
def test_what_is_outstanding_is_what_all_effects_came_to(
    project: Project, scenario: Scenario
) -> None:
    play, driver = Play(project), Driver()
    driver.carry(play.effects)
    for wait, given_ in scenario:
        if isinstance(given_, inputs.Finish):
            if not (going_on := driver.going_on()):
                continue
            given_ = driver.finish(going_on[wait % len(going_on)])
        play.effects.clear()
        play.feed([(wait, given_)])
        driver.carry(play.effects)
    fresh = Driver()
    fresh.carry(play.robot.outstanding())
    assert fresh.values() == driver.values()
    assert fresh.begun == driver.begun
    # An action that was cut off while a module commands the very same has no Map of its end.
    running = {n for one in play.robot._machines for n in one.actions.state.running}
    assert fresh.going_on() == [number for number in driver.going_on() if number in running]
    other = Robot(project)
    other.restore(play.robot.snapshot())
    assert other.outstanding() == play.robot.outstanding()
