"""Speed does not depend on how many conditions and states there are: few are judged at a write."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.decide.random_projects import (
    FEW,
)

from situ.decide import inputs
from situ.decide.flips import Flips
from situ.decide.robot import Robot
from situ.decide.trace import Condition as ConditionEvent
from situ.decide.trace import Data, to_fields
from situ.decide.values import compile_test
from situ.document.condition import Condition
from situ.document.condition import Test as Leaf
from situ.document.project import Project
from situ.document.spds import Situation, Spds

if TYPE_CHECKING:
    from tests.decide.conftest import Build


written = st.sampled_from(
    ["1", "1.0", "2", "-3", "true", "false", "null", "a", '"a"', '"1"', "08:00", "[1]", '{"a": 1}']
)

members = st.sampled_from(["[1, 2]", '["a", true]', "[[1], null]", "1", "[]"])

plain_tests = st.one_of(
    st.builds(Leaf, st.just("x"), st.sampled_from(["is", "isnot"]), written),
    st.builds(
        Leaf, st.just("x"), st.sampled_from(["above", "below", "atleast", "atmost"]), written
    ),
    st.builds(Leaf, st.just("x"), st.just("in"), members),
    st.builds(Leaf, st.just("x"), st.just("exists"), st.sampled_from(["true", "false"])),
)

any_value = st.sampled_from(
    [None, 0, 1, 1.0, 1.5, 2, -3, True, False, "a", "1", "b", "08:00", "null", [1], [2], {"a": 1}]
)


@settings(FEW, max_examples=200)
@given(st.lists(plain_tests, max_size=8), st.lists(any_value, max_size=8))
def test_every_test_that_changes_with_its_value_is_found(
    tests: list[Leaf], values_: list[Any]
) -> None:
    now: dict[str, Any] = {}
    flips = Flips("x", now.get)
    for number, test in enumerate(tests):
        flips.add(test, number)
    judges = [compile_test(test.test, test.value)[0] for test in tests]
    before = [judge(None, now.get) for judge in judges]
    for value in values_:
        now["x"] = value
        after_ = [judge(value, now.get) for judge in judges]
        changed = {n for n, (a, b) in enumerate(zip(before, after_, strict=True)) if a != b}
        assert changed <= set(flips.changed())
        before = after_


@pytest.mark.parametrize("test", ["above", "atmost", "is", "isnot"])
def test_of_many_tests_of_one_name_only_those_near_its_value_are_judged(test: str) -> None:
    now: dict[str, Any] = {}
    flips = Flips("x", now.get)
    for number in range(1000):
        flips.add(Leaf("x", test, str(number)), number)  # type: ignore[arg-type]
    now["x"] = 500.5 if test in ("above", "atmost") else 500
    flips.changed()
    now["x"] += 1
    assert len(list(flips.changed())) <= 2


@settings(FEW, max_examples=60)
@given(
    st.lists(st.lists(plain_tests, min_size=1, max_size=2), min_size=1, max_size=4),
    st.lists(st.tuples(any_value, any_value), max_size=6),
)
def test_a_condition_is_caused_by_the_last_write_that_it_looks_at(
    found: list[list[Leaf]], values_: list[tuple[Any, Any]]
) -> None:
    """Two tags of one write: the second is the cause where the condition looks at it."""
    situations = tuple(
        Situation(
            f"s{number}",
            condition=Condition(
                tuple(msgspec.structs.replace(t, tag="xy"[n % 2]) for n, t in enumerate(tests))
            ),
        )
        for number, tests in enumerate(found)
    )
    robot = Robot(
        Project(root=".", name="p", spds=Spds("s", (), (), (*situations, Situation("r"))))
    )
    robot.step(inputs.Start(), 0)
    for x, y in values_:
        events, _ = robot.step(inputs.Set({"x": x, "y": y}, "m"), 1)
        told = {e.tag: e.seq for e in events if isinstance(e, Data)}
        for event in events:
            if isinstance(event, ConditionEvent):
                looks = "xy"[: len(found[int(event.situation[1:])])]
                assert event.cause == max(told[tag] for tag in looks if tag in told)


@pytest.mark.parametrize("others", [10, 400])
def test_a_write_judges_no_condition_that_does_not_look_at_it(build: Build, others: int) -> None:
    """What a step does is counted, not timed: calls into the conditions that changed."""
    more = "".join(
        f'<situation name="s{n}"><condition><data tag="t{n}" is="1"/></condition></situation>'
        for n in range(others)
    )
    first = '<situation name="a"><condition><data tag="x" is="1"/></condition></situation>'
    robot = Robot(build((), f'{first}{more}<situation name="rest"/>'))
    robot.step(inputs.Start(), 0)
    assert robot._settling.situations is not None
    judged: list[int] = []
    judge = robot._settling.situations._judge

    def counting(number: int, cause: int | None) -> None:
        judged.append(number)
        judge(number, cause)

    robot._settling.situations._judge = counting  # type: ignore[method-assign]
    robot.step(inputs.Set({"x": 1}, "m"), 1)
    assert judged == [0]


@pytest.mark.parametrize("states", [2, 400])
def test_a_write_is_told_once_however_many_states_wait_for_it(build: Build, states: int) -> None:
    waits = '<event next="end"><when><data tag="x" is="1"/></when></event>'
    rbd = "".join(
        f'<state no="{no}"><expectedevents>{waits}</expectedevents></state>' for no in range(states)
    )
    robot = Robot(build(f'{rbd}<state no="end"/>'))
    robot.step(inputs.Start(), 0)
    assert len(robot.board.listeners["x"]) == 1
    events, _ = robot.step(inputs.Set({"x": 1}, "m"), 1)
    assert [to_fields(event)["kind"] for event in events].count("transition") == 1
