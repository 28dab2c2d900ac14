"""Situations and modules: what the searches find, beside runs of the robot itself."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.decide import inputs, trace
from situ.decide.robot import Robot
from situ.document import codec
from situ.document.check import check
from situ.document.condition import Condition, Group, TestName
from situ.document.condition import Test as Single
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application, Event, Screen, Sound, Speech, State
from situ.document.rbd import Robot as RobotAction
from situ.document.spds import Declaration, Entry, Situation, Spds

CODES = {"never-holds", "shadowed-situation", "never-wins", "tie", "undecided"}
VALUES: dict[str, tuple[Any, ...]] = {"x": (None, 0, 1, 2, "b", "c", "1"), "y": (None, 1)}
BOARDS = [dict(zip(VALUES, values, strict=True)) for values in itertools.product(*VALUES.values())]
TESTS_MADE: list[tuple[TestName, str]] = [
    *(("is", "1"), ("isnot", "1"), ("above", "1"), ("atmost", "1"), ("in", '[1, "b"]')),
    *(("exists", "true"), ("exists", "false"), ("is", "b")),
]


def project(script: Spds, *applications: Application) -> Project:
    return Project(
        root="nowhere",
        name="a",
        applications={f"{a.name}.rbd.xml": a for a in applications},
        spds_file="a.spds.xml",
        spds=script,
    )


def found(script: Spds, *applications: Application) -> list[Problem]:
    return [p for p in check(project(script, *applications)) if p.code in CODES]


def script(text: str) -> Spds:
    document, problems = codec.read(f'<spds name="a">{text}</spds>'.encode(), "a.spds.xml")
    assert isinstance(document, Spds), problems
    assert not problems
    return document


def told(text: str) -> list[tuple[str, tuple[str, ...]]]:
    return [(p.code, p.place) for p in found(script(text))]


def situation(name: str, test: str = "", rest: str = "", attributes: str = "") -> str:
    condition = f'<condition><data tag="x" {test}/></condition>' if test else ""
    return f'<situation name="{name}" {attributes}>{condition}{rest}</situation>'


LAST = situation("z")

# -- by hand -------------------------------------------------------------------------------


def test_a_situation_is_shadowed_by_one_or_by_several_together() -> None:
    text = situation("a", 'above="3"') + situation("b", 'in="[7]"') + LAST
    assert told(text) == [("shadowed-situation", ("situation", "b"))]
    text = situation("a", 'above="3"') + situation("b", 'atmost="3"')
    (problem,) = found(script(text + situation("c", 'in="[1, 5]"') + LAST))
    assert problem.place == ("situation", "c")
    assert 'one of "a" and "b"' in problem.message


def test_the_last_situation_is_shadowed_where_those_above_leave_nothing() -> None:
    text = situation("a", 'is="1"') + situation("b", 'isnot="1"') + LAST
    assert told(text) == [("shadowed-situation", ("situation", "z"))]


def test_what_within_or_for_leaves_open_shadows_nothing() -> None:
    text = situation("a", 'is="1" within="2"') + situation("b", 'is="1"') + LAST
    assert told(text) == []
    text = situation("a", 'is="1" for="2"') + situation("b", 'is="1"') + LAST
    assert told(text) == []
    text = situation("a", 'is="1"') + situation("b", 'is="1" for="2"') + LAST
    assert told(text) == [("shadowed-situation", ("situation", "b"))]


@pytest.mark.parametrize(
    ("attributes", "until", "shadows"),
    [
        ("", "", True),
        ('dwell="2"', "", True),
        ('limit="5"', "", False),
        ("", '<until><data tag="y" is="1"/></until>', False),
        # It never ends while its condition holds.
        ("", '<until><data tag="x" atmost="3"/></until>', True),
    ],
)
def test_what_has_ended_by_until_or_limit_leaves_room(
    attributes: str, until: str, shadows: bool
) -> None:
    text = situation("a", 'above="3"', until, attributes) + situation("b", 'in="[7]"') + LAST
    expected = [("shadowed-situation", ("situation", "b"))] if shadows else []
    assert told(text) == expected


def test_a_situation_whose_until_holds_with_its_condition_never_begins() -> None:
    until = '<until><data tag="x" exists="true"/></until>'
    assert told(situation("a", 'is="1"', until) + LAST) == [("never-holds", ("situation", "a"))]


def test_conditions_and_untils_that_never_hold_are_told() -> None:
    until = '<until><data tag="y" is="1"/><data tag="y" is="2"/></until>'
    assert told(situation("a", 'is="1"', until) + LAST) == [
        ("never-holds", ("situation", "a", "until"))
    ]
    assert told(situation("a", 'in="[]"') + LAST) == [
        ("never-holds", ("situation", "a", "condition"))
    ]


def test_a_declared_type_leaves_no_other_values() -> None:
    observe = '<observe><data tag="x" type="boolean"/></observe>'
    assert told(observe + situation("a", 'is="yes"') + LAST) == [
        ("never-holds", ("situation", "a", "condition"))
    ]
    both = situation("a", 'is="true"') + situation("b", 'is="false"')
    assert told(observe + both + situation("c", 'exists="true"') + LAST) == [
        ("shadowed-situation", ("situation", "c"))
    ]


MODULES = (
    '<modules><module name="m" resources="head"/><module name="n" resources="head base"/></modules>'
)


def test_equal_priorities_for_one_resource_are_a_tie() -> None:
    both = '<module name="m" priority="5"/><module name="n" priority="5"/>'
    assert told(MODULES + situation("z", rest=both)) == [("tie", ("situation", "z", "entry", "1"))]
    apart = MODULES.replace("head base", "base")
    assert told(apart + situation("z", rest=both)) == []


def test_a_tie_that_is_taken_over_is_told_once() -> None:
    both = '<module name="m" priority="5"/><module name="n" priority="5"/>'
    above = situation("a", 'is="1"', attributes='extends="z"')
    assert told(MODULES + above + situation("z", rest=both)) == [
        ("tie", ("situation", "z", "entry", "1"))
    ]


def test_of_two_situations_of_one_name_a_tie_is_told_of_its_own_and_not_mended_elsewhere() -> None:
    both = '<module name="m" priority="5"/><module name="n" priority="5"/>'
    one = '<module name="m" priority="5"/>'
    for first in ("", one):
        text = MODULES + situation("a", 'is="1"', first) + situation("a", 'is="2"', both) + LAST
        ties = [p for p in found(script(text)) if p.code == "tie"]
        assert [(p.place, p.mend) for p in ties] == [(("situation", "a", "entry", "1"), None)]


def test_a_module_without_a_priority_never_wins() -> None:
    one = '<module name="m" priority="5"/>'
    assert told(MODULES + situation("z", rest=one)) == [("never-wins", ("module", "n"))]


def test_a_module_with_a_priority_only_where_it_is_never_current_never_wins() -> None:
    text = MODULES + situation("a", 'exists="true"', '<module name="m" priority="5"/>')
    text += situation("b", 'is="1"', '<module name="n" priority="5"/>') + LAST
    assert told(text) == [
        ("shadowed-situation", ("situation", "b")),
        ("never-wins", ("situation", "b", "entry", "0")),
    ]


def screen_app(name: str, *uses: str) -> Application:
    """An application that always shows a screen, and what else its states use."""
    states = tuple(
        State(
            str(at),
            screen=Screen(background="#fff"),
            actions=(Speech(text="a"),) if used == "speech" else (),
            events=(Event("e", str((at + 1) % len(uses))),),
        )
        for at, used in enumerate(uses)
    )
    return Application(name, None, None, states)


def test_what_an_application_always_holds_nobody_below_it_wins() -> None:
    text = (
        '<modules><module name="app" resources="screen speech"/>'
        '<module name="m" resources="{}"/></modules>'
        '<situation name="z"><module name="app" priority="9"/>'
        '<module name="m" priority="5"/></situation>'
    )
    always = screen_app("app", "speech", "speech")
    now_and_then = screen_app("app", "speech", "nothing")

    def codes(resources: str, application: Application) -> list[str]:
        return [p.code for p in found(script(text.format(resources)), application)]

    assert codes("speech", always) == ["never-wins"]
    assert codes("speech", now_and_then) == []
    assert codes("screen", now_and_then) == ["never-wins"]
    assert codes("screen base", now_and_then) == []


def test_who_blocks_an_application_frees_what_else_it_uses() -> None:
    text = (
        '<modules><module name="app" resources="screen speech"/>'
        '<module name="m" resources="speech"/><module name="n" resources="screen"/></modules>'
        '<situation name="z"><module name="app" priority="9"/><module name="n" priority="12"/>'
        '<module name="m" priority="5"/></situation>'
    )
    assert found(script(text), screen_app("app", "speech")) == []


# -- beside the robot --------------------------------------------------------------------------


class Maker:
    def __init__(self, seed: int, times: bool) -> None:
        self.random = Random(seed)
        self.times = times

    def script(self) -> Spds:
        random = self.random
        count = random.choice([2, 3, 3, 4])
        above = tuple(self.situation(str(at)) for at in range(count))
        return Spds("a", (), (), (*above, Situation("z")))

    def situation(self, name: str) -> Situation:
        random = self.random
        until = self.condition() if random.random() < 0.25 else None
        limit = 7.0 if random.random() < 0.2 else None
        dwell = 2.0 if until is None and limit is None and random.random() < 0.2 else None
        condition = self.condition() if random.random() < 0.9 else None
        return Situation(name, None, dwell, limit, condition, until)

    def condition(self) -> Condition:
        return Condition(tuple(self.part(0) for _ in range(self.random.choice([1, 1, 2]))))

    def part(self, depth: int) -> Group | Single:
        random = self.random
        if depth < 1 and random.random() < 0.3:
            kind = "any" if random.random() < 0.6 else "none"
            return Group("any" if kind == "any" else "none", (self.part(1), self.part(1)))
        within, hold = (
            random.choice([None, None, 1.0, 3.0]) if self.times else None for _ in range(2)
        )
        if random.random() < 0.25:
            return Single("y", "exists", random.choice(["true", "false"]), within, hold)
        test, value = random.choice(TESTS_MADE)
        return Single("x", test, value, within, hold)


class Run:
    """The robot of a script, driven through every order of sets and waits."""

    def __init__(self, source: Spds, limit: int) -> None:
        self.current: set[str | None] = set()
        self.seen: set[Any] = set()
        self.waiting: list[bytes] = []
        for board in BOARDS:
            self.robot = Robot(replace(project(source), tags=board))
            self.look(self.robot.step(inputs.Start(), 0)[0])
        while self.waiting and len(self.seen) < limit:
            snapshot = self.waiting.pop(0)
            for board in BOARDS:
                self.robot.restore(snapshot)
                now = self.robot._world.step.state.now
                self.look(self.robot.step(inputs.Set(board, "m"), now + 100)[0])
            self.robot.restore(snapshot)
            due = self.robot.due()
            if due is not None:
                self.look(self.robot.step(None, due)[0])

    def look(self, events: list[trace.TraceEvent]) -> None:
        for event in events:
            if isinstance(event, trace.Situation):
                self.current.add(event.to)
        situations = self.robot._settling.situations
        assert situations is not None
        state = situations.state
        key = (
            state.current,
            tuple((o.condition, o.until, o.kept, o.dwelt, o.spent) for o in state.observations),
            tuple(self.robot.board.look(tag) for tag in VALUES),
        )
        if key not in self.seen:
            self.seen.add(key)
            self.waiting.append(self.robot.snapshot())


def never(problems: list[Problem]) -> set[str]:
    """The situations of which it is told that they are never current."""
    return {
        p.place[1]
        for p in problems
        if p.code == "shadowed-situation" or (p.code == "never-holds" and p.place[2:] != ("until",))
    }


@given(seed=st.integers(0, 2**64))
@settings(max_examples=40, deadline=None)
def test_situations_are_told_exactly_where_no_run_makes_them_current(seed: int) -> None:
    source = Maker(seed, times=False).script()
    problems = found(source)
    assert "undecided" not in {p.code for p in problems}
    run = Run(source, 600)
    names = {one.name for one in source.situations}
    assert not never(problems) & run.current
    # Whether two have ended at the same time is not asked.
    if sum(one.until is not None or one.limit is not None for one in source.situations) < 2:
        assert never(problems) == names - run.current


@given(seed=st.integers(0, 2**64))
@settings(max_examples=15, deadline=None)
def test_with_within_and_for_nothing_is_told_that_a_run_makes_current(seed: int) -> None:
    source = Maker(seed, times=True).script()
    run = Run(source, 150)
    assert not never(found(source)) & run.current


RESOURCES = ("r", "s")
PARTS = [frozenset(p) for n in range(3) for p in itertools.combinations(RESOURCES, n)]


def modules_made(seed: int) -> tuple[Spds, Application | None]:
    random = Random(seed)
    names = ["m", "n", "o"][: random.choice([2, 3])]
    with_application = random.random() < 0.5
    declared = [Declaration(n, tuple(sorted(random.choice(PARTS[1:])))) for n in names]
    application = None
    if with_application:
        count = random.choice([1, 2])
        states = []
        for at in range(count):
            uses = [
                RobotAction(resource=r, command="c", optional=random.random() < 0.3)
                for r in RESOURCES
                if random.random() < 0.6
            ]
            events = (Event("e", str((at + 1) % count)),)
            states.append(State(str(at), actions=tuple(uses), events=events))
        application = Application("app", None, None, tuple(states))
        declared.append(Declaration("app", RESOURCES))
    entries = [
        Entry(d.name, random.choice([1, 2, 3]))
        for d in declared
        if random.random() < 0.9 or d.name == "app"
    ]
    return Spds("a", (), tuple(declared), (Situation("z", entries=tuple(entries)),)), application


def winners(source: Spds, application: Application | None) -> set[str]:
    """Who can hold something, whoever asks for whatever in whatever order."""
    found_: set[str] = set()
    free = [d for d in source.modules if d.name != "app"]
    starts: list[str | None] = [None]
    if application is not None:
        starts = [state.no for state in application.states]
    for start in starts:
        apps = [] if application is None else [replace(application, start=start)]
        for order in itertools.permutations(free):
            for asked in itertools.product(*(_subsets(d.resources) for d in order)):
                robot = Robot(project(source, *apps))
                robot.step(inputs.Start(), 0)
                for declared, resources in zip(order, asked, strict=True):
                    if resources:
                        robot.step(inputs.Acquire(declared.name, resources), 0)
                holders = (robot._world.priorities.holder(r) for r in RESOURCES)
                found_ |= {holder for holder in holders if holder is not None}
    return found_


def _subsets(resources: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    for count in range(len(resources) + 1):
        yield from itertools.combinations(resources, count)


@given(seed=st.integers(0, 2**64))
@settings(max_examples=25, deadline=None)
def test_modules_are_told_exactly_where_no_requests_let_them_win(seed: int) -> None:
    source, application = modules_made(seed)
    apps = [] if application is None else [application]
    said = set()
    for problem in found(source, *apps):
        if problem.code == "never-wins":
            at = problem.place
            entries = source.situations[0].entries
            said.add(at[1] if at[0] == "module" else entries[int(at[3])].module)
    won = winners(source, application)
    told_of = {d.name for d in source.modules}
    if application is not None and application.name not in won:
        # One that uses nothing wins nothing, and wants nothing.
        uses = any(action for state in application.states for action in state.actions)
        told_of -= set() if uses else {"app"}
        said -= set() if uses else {"app"}
    assert not said & won
    priorities = list(source.priorities(source.situations[0]).values())
    # The application of a run asks first of all, so of equals it always wins there.
    if application is None or len(set(priorities)) == len(priorities):
        assert said == told_of - won


@given(seed=st.integers(0, 2**64))
@settings(max_examples=100, deadline=None)
def test_ties_are_told_exactly_for_equal_priorities_and_shared_resources(seed: int) -> None:
    source, application = modules_made(seed)
    apps = [] if application is None else [application]
    priorities = source.priorities(source.situations[0])
    asks = {d.name: set(d.resources) for d in source.modules}
    if application is not None:
        asks["app"] = {
            a.resource
            for state in application.states
            for a in state.actions
            if isinstance(a, RobotAction)
        }
    ties = {
        frozenset((one, other))
        for one, other in itertools.combinations(priorities, 2)
        if priorities[one] == priorities[other] and asks[one] & asks[other]
    }
    problems = [p for p in found(source, *apps) if p.code == "tie"]
    said = {frozenset(p.message.split('"')[1:4:2]) for p in problems}
    assert said == ties
    assert len(problems) == len(ties)


def test_a_sound_uses_the_resource_speech() -> None:
    text = (
        '<modules><module name="app" resources="speech"/>'
        '<module name="m" resources="speech"/></modules>'
        '<situation name="z"><module name="app" priority="9"/>'
        '<module name="m" priority="5"/></situation>'
    )
    sound = State("1", actions=(Sound(src="a.wav"),), final=True)
    assert [p.code for p in found(script(text), Application("app", None, None, (sound,)))] == [
        "never-wins"
    ]
