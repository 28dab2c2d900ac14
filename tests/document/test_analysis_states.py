"""States, events and livelocks: what the searches find, beside runs of the robot itself.

Small applications are made at random; the robot is then driven through every order of
inputs that can make a difference. What is told as never happening must never happen there,
and what is not told must.
"""

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
from situ.decide.values import compile_test
from situ.document import codec
from situ.document.check import check
from situ.document.condition import Condition, Group, TestName
from situ.document.condition import Test as Single
from situ.document.finding import Place
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import (
    BACK,
    Action,
    Always,
    Application,
    Event,
    Message,
    Set,
    State,
    Timeout,
)

FILE = "a.rbd.xml"
NAMES = ("e", "f")
TAGS = ("x", "y")
VALUES: dict[str, tuple[Any, ...]] = {"x": (None, 0, 1, 2, "b", "c", "1"), "y": (None, 1)}
"""One value at least for each way in which the tests made here can come out."""

TESTS_MADE: list[tuple[TestName, str]] = [
    *(("is", "1"), ("isnot", "1"), ("above", "1"), ("atmost", "1"), ("in", '[1, "b"]')),
    *(("exists", "true"), ("exists", "false"), ("is", "b")),
]
BOARDS = [dict(zip(TAGS, values, strict=True)) for values in itertools.product(*VALUES.values())]
SEARCHES = {
    "never-holds",
    "event-never-taken",
    "unreachable-state",
    "dead-end",
    "no-way-back",
    "livelock",
    "undecided",
}


def project(application: Application) -> Project:
    return Project(root="nowhere", name="a", applications={FILE: application})


def found(application: Application) -> list[Problem]:
    return [p for p in check(project(application)) if p.code in SEARCHES]


def application(text: str) -> Application:
    document, problems = codec.read(f'<application name="a">{text}</application>'.encode(), FILE)
    assert isinstance(document, Application), problems
    assert not problems
    return document


def told(text: str) -> list[tuple[str, Place]]:
    return [(p.code, p.place) for p in found(application(text))]


def state(no: str, events: str = "", rest: str = "", attributes: str = "") -> str:
    return f'<state no="{no}" {attributes}>{rest}<expectedevents>{events}</expectedevents></state>'


IF = '<event {}><when><data tag="x" {}/></when></event>'

# -- by hand -------------------------------------------------------------------------------


def test_a_state_to_which_nothing_leads_is_not_reached() -> None:
    text = state("1", '<event name="e" next="2"/>') + state("2", '<event name="e" next="1"/>')
    assert told(text) == []
    assert told(text + state("3", '<event name="e" next="1"/>')) == [
        ("unreachable-state", ("state", "3"))
    ]


def test_a_state_is_not_reached_by_an_event_that_is_never_taken() -> None:
    text = (
        state("1", '<event name="e" next="2"/><event name="e" next="3"/>')
        + state("2", '<event name="e" next="1"/>')
        + state("3", '<event name="e" next="1"/>')
    )
    assert told(text) == [
        ("event-never-taken", ("state", "1", "event", "1")),
        ("unreachable-state", ("state", "3")),
    ]


def test_nothing_is_said_of_reaching_where_a_next_names_no_state() -> None:
    text = state("1", '<event name="e" next="7"/>') + state("2", '<event name="e" next="1"/>')
    assert told(text) == []


def test_a_dead_end_is_left_by_nothing_and_not_final() -> None:
    one = state("1", '<event name="e" next="2"/>')
    assert told(one + state("2", '<event name="e"/><event name="f" next="#again"/>')) == [
        ("dead-end", ("state", "2"))
    ]
    assert told(one + state("2", attributes='final="true"')) == []
    assert told(one + state("2", rest='<timeout next="1">5</timeout>')) == []
    assert told(one + state("2", '<event name="e" next="#back"/>')) == []
    always = '<always><expectedevents><event name="home" next="1"/></expectedevents></always>'
    assert told(always + one + state("2")) == []
    assert told(always + one + state("2", attributes='always="false"')) == [
        ("dead-end", ("state", "2"))
    ]


def test_no_way_back_is_told_once_for_all_states_from_where_there_is_none() -> None:
    text = (
        state("1", '<event name="e" next="2"/>')
        + state("2", '<event name="e" next="3"/>')
        + state("3", '<event name="e" next="2"/>')
    )
    assert told(text) == [("no-way-back", ("state", "2"))]


@pytest.mark.parametrize(
    ("first", "second", "place"),
    [
        ("is='1'", "is='1'", 1),
        ("above='3'", "above='5'", 1),
        ("exists='true'", "is='b'", 1),
        ("isnot='1'", "is='b'", 1),
    ],
)
def test_an_event_is_never_taken_where_an_earlier_one_always_holds_too(
    first: str, second: str, place: int
) -> None:
    events = IF.format('name="e" next="2"', first) + IF.format('name="e" next="1"', second)
    text = state("1", events) + state("2", '<event name="e" next="1"/>')
    assert told(text) == [("event-never-taken", ("state", "1", "event", str(place)))]


def test_an_event_is_never_taken_where_earlier_ones_hold_together() -> None:
    events = (
        IF.format('name="e" next="2"', 'below="5"')
        + IF.format('name="e" next="2"', 'atleast="5"')
        + IF.format('name="e" next="2"', 'in="[1, 7]"')
        + IF.format('name="e" next="2"', 'is="b"')
    )
    text = state("1", events) + state("2", '<event name="e" next="1"/>')
    assert told(text) == [("event-never-taken", ("state", "1", "event", "2"))]


def test_what_a_state_left_at_once_expects_is_never_taken() -> None:
    left = IF.format('next="1"', 'exists="true"') + IF.format('next="1"', 'exists="false"')
    text = state("1", '<event name="e" next="2"/>') + state(
        "2", left + '<event name="e" next="1"/>', '<timeout next="1">5</timeout>'
    )
    assert told(text) == [
        ("event-never-taken", ("state", "2", "event", "2")),
        ("event-never-taken", ("state", "2", "timeout")),
    ]


def test_resumed_comes_before_what_leaves_a_state_at_once() -> None:
    text = state("1", '<event name="e" next="2"/>') + state(
        "2", '<event next="1"/><event name="resumed" next="1"/>'
    )
    assert told(text) == []


def test_back_is_never_taken_in_the_start_state() -> None:
    text = state("1", '<event name="e" next="#back"/><event name="e" next="2"/>') + state(
        "2", '<event name="e" next="#back"/>'
    )
    assert told(text) == [("event-never-taken", ("state", "1", "event", "0"))]


def test_an_event_of_always_is_told_only_where_no_state_ever_takes_it() -> None:
    always = '<always><expectedevents><event name="e" next="1"/></expectedevents></always>'
    own = state("1", '<event name="e" next="2"/>')
    assert told(always + own + state("2", '<event name="e" next="1"/>')) == [
        ("event-never-taken", ("always", "event", "0"))
    ]
    assert told(always + own + state("2", '<event name="f" next="1"/>')) == []


def test_a_guard_that_can_never_hold_is_told_once_with_what_excludes_each_other() -> None:
    guard = (
        '<event name="e" next="1"><when><data tag="x" above="3"/><data tag="y" is="1"/>'
        '<data tag="x" below="2"/></when></event>'
    )
    (problem,) = found(
        application(
            state("1", guard + '<event name="f" next="2"/>')
            + state("2", '<event name="e" next="1"/>')
        )
    )
    assert (problem.code, problem.place) == ("never-holds", ("state", "1", "event", "0", "when"))
    assert "x above 3 and x below 2" in problem.message
    assert "y" not in problem.message.partition("(")[2].partition(")")[0]


def test_a_loop_of_unnamed_events_is_a_livelock() -> None:
    one = state("1", IF.format('next="2"', 'above="3"') + '<event name="e" next="2"/>')
    assert told(
        one + state("2", IF.format('next="1"', 'above="5"') + '<event name="e" next="1"/>')
    ) == [("livelock", ("state", "1", "event", "0"))]
    assert (
        told(one + state("2", IF.format('next="1"', 'below="3"') + '<event name="e" next="1"/>'))
        == []
    )


def test_an_unnamed_event_of_always_that_leads_to_a_state_with_always_is_a_livelock() -> None:
    always = "<always><expectedevents>" + IF.format('next="2"', 'is="1"')
    always += "</expectedevents></always>"
    one = state("1", '<event name="e" next="2"/>')
    two = '<event name="e" next="1"/>'
    assert told(always + one + state("2", two)) == [("livelock", ("state", "2"))]
    assert told(always + one + state("2", two, attributes='always="false"')) == []


def test_what_is_written_on_the_way_can_end_a_loop() -> None:
    one = state("1", IF.format('next="2"', 'above="3"') + '<event name="e" next="2"/>')
    two = '<event next="1"><when><data tag="x" exists="true"/></when>{}</event>'
    rest = '<event name="e" next="1"/>'
    loop = ("livelock", ("state", "1", "event", "0"))
    assert told(one + state("2", two.format("") + rest)) == [loop]
    assert told(one + state("2", two.format('<set tag="x">1</set>') + rest)) == []
    assert told(one + state("2", two.format('<clear tag="x"/>') + rest)) == []
    for written in ("[9]", '{"a": 9}'):
        assert told(one + state("2", two.format(f'<set tag="x">{written}</set>') + rest)) == []
    assert told(one + state("2", two.format('<clear tag="y"/>') + rest)) == [loop]
    assert told(one + state("2", two.format('<set tag="x">8</set>') + rest)) == [loop]
    assert told(one + state("2", two.format('<add tag="x">8</add>') + rest)) == [
        ("undecided", ("state", "1", "event", "0"))
    ]


def test_done_of_what_ends_at_once_can_be_a_livelock() -> None:
    text = (
        '<state no="1"><backgroundactions>{}<message topic="t" done="sent"/></backgroundactions>'
        '<expectedevents><event name="sent" next="#again"/></expectedevents></state>'
    )
    assert ("livelock", ("state", "1", "event", "0")) in told(text.format(""))
    slow = '<speech wait="true">Hello</speech>'
    assert ("livelock", ("state", "1", "event", "0")) not in told(text.format(slow))
    inner = state(
        "1", '<event name="e"><message topic="t" done="e"/></event>', attributes='final="true"'
    )
    assert told(inner) == [("livelock", ("state", "1", "event", "0"))]


# -- beside the robot --------------------------------------------------------------------------


class Maker:
    """Small applications; every event sends a message that names its place."""

    def __init__(self, seed: int, writes: bool) -> None:
        self.random = Random(seed)
        self.writes = writes
        self.count = self.random.choice([2, 3, 3])

    def application(self) -> Application:
        states = tuple(self.state(no) for no in range(1, self.count + 1))
        always = None
        if self.random.random() < 0.4:
            events = self.events(("always",), self.random.choice([1, 1, 2]))
            always = Always(self.timeout() if self.random.random() < 0.3 else None, None, events)
        return Application("a", None, always, states)

    def state(self, no: int) -> State:
        place = ("state", str(no))
        random = self.random
        return State(
            str(no),
            always=random.random() < 0.8,
            final=random.random() < 0.1,
            timeout=self.timeout() if random.random() < 0.3 else None,
            actions=self.actions() if self.writes else (),
            events=self.events(place, random.choice([0, 1, 2, 2, 3])),
        )

    def timeout(self) -> Timeout:
        return Timeout(5.0, self.random.choice([self.next(), None]))

    def next(self) -> str:
        numbers = [str(no) for no in range(1, self.count + 1)]
        return self.random.choice([*numbers, *numbers, "#again", "#back"])

    def events(self, place: Place, count: int) -> tuple[Event, ...]:
        return tuple(self.event((*place, "event", str(at))) for at in range(count))

    def event(self, place: Place) -> Event:
        random = self.random
        name = random.choice([None, *NAMES])
        next_ = self.next() if name is None or random.random() < 0.8 else None
        when = self.condition() if random.random() < (0.8 if name is None else 0.5) else None
        mark = Message(topic="/".join(place))
        return Event(name, next_, when, (), (mark, *(self.actions() if self.writes else ())))

    def actions(self) -> tuple[Action, ...]:
        random = self.random
        found: list[Action] = []
        while random.random() < 0.3:
            done = random.choice([None, *NAMES])
            if random.random() < 0.6:
                text = random.choice(["1", "2", "b", "null"])
                found.append(Set(tag=random.choice(TAGS), text=text, done=done))
            else:
                found.append(Message(topic="t", done=done))
        return tuple(found)

    def condition(self) -> Condition:
        children = tuple(self.part(0) for _ in range(self.random.choice([1, 1, 2])))
        return Condition(children)

    def part(self, depth: int) -> Group | Single:
        random = self.random
        if depth < 1 and random.random() < 0.3:
            inner = tuple(self.part(1) for _ in range(2))
            return Group("any" if random.random() < 0.6 else "none", inner)
        if random.random() < 0.25:
            return Single("y", "exists", random.choice(["true", "false"]))
        test, value = random.choice(TESTS_MADE)
        return Single("x", test, value)


class Run:
    """The robot of an application, driven through everything that can happen."""

    def __init__(self, source: Application) -> None:
        self.livelock = False
        self.entered: set[str] = set()
        self.taken: set[str] = set()
        self.timeouts: set[str] = set()
        self.seen: set[Any] = set()
        self.waiting: list[bytes] = []
        for board in BOARDS:
            # A robot may have any values when it starts: [tags], or its own robot.local.toml.
            self.robot = Robot(replace(project(source), tags=board))
            self.look(*self.robot.step(inputs.Start(), 0))
        while self.waiting and len(self.seen) < 400:
            snapshot = self.waiting.pop(0)
            for given_ in self.inputs():
                self.robot.restore(snapshot)
                self.look(*self.robot.step(given_, self.robot._world.step.state.now))
            self.robot.restore(snapshot)
            due = self.robot.due()
            if due is not None:
                self.look(*self.robot.step(None, due))

    @staticmethod
    def inputs() -> Iterator[inputs.AnyInput]:
        for board in BOARDS:
            yield inputs.Set(board, "m")
        for name in NAMES:
            yield inputs.Raise(name)

    def look(self, events: list[trace.TraceEvent], _effects: object) -> None:
        livelock = False
        for event in events:
            if isinstance(event, trace.Failed):
                assert "livelock" in event.message
                livelock = self.livelock = True
            elif isinstance(event, trace.Enter):
                self.entered.add(event.state)
            elif isinstance(event, trace.Action) and event.action == "message":
                self.taken.add(str(event.topic))
            elif isinstance(event, trace.Transition) and event.timeout is True:
                self.timeouts.add(event.source)
        if livelock:
            return
        machine = self.robot._machines[0].state
        board = self.robot.board
        key = (
            machine.no,
            tuple(tuple(one[-4:]) for one in machine.stacks),
            tuple(board.look(tag) for tag in TAGS),
        )
        if key not in self.seen:
            self.seen.add(key)
            self.waiting.append(self.robot.snapshot())


@given(seed=st.integers(0, 2**64), writes=st.booleans())
@settings(max_examples=25, deadline=None)
def test_what_is_told_never_happens_and_livelocks_are_found_exactly(
    seed: int, writes: bool
) -> None:
    source = Maker(seed, writes).application()
    problems = found(source)
    run = Run(source)
    for problem in problems:
        match problem.code:
            case "unreachable-state":
                assert problem.place[1] not in run.entered
            case "event-never-taken" if problem.place[-1] != "timeout":
                assert "/".join(problem.place) not in run.taken
            case "event-never-taken":
                holders = [problem.place[1]] if problem.place[0] == "state" else []
                assert not run.timeouts & set(holders)
            case "never-holds":
                assert "/".join(problem.place[:-1]) not in run.taken
    codes = {problem.code for problem in problems}
    assert "undecided" not in codes
    assert ("livelock" in codes) is run.livelock


# -- beside trying all values, state by state --------------------------------------------------


def holds(node: Condition | Group | Single, board: dict[str, Any]) -> bool:
    if isinstance(node, Single):
        judge, _ = compile_test(node.test, node.value)
        return bool(judge(board.get(node.tag), board.get))
    each = [holds(child, board) for child in node.children]
    kind = "all" if isinstance(node, Condition) else node.kind
    return all(each) if kind == "all" else any(each) is (kind == "any")


class Tried:
    """What is taken in which state with some values: places, and edges."""

    def __init__(self, source: Application) -> None:
        self.source = source
        self.start = source.states[0].no
        self.taken: dict[str, set[Place]] = {}
        self.edges: dict[str, set[str]] = {}
        self.back: set[str] = set()
        for one in source.states:
            self.taken[one.no], self.edges[one.no] = set(), set()
            for board in BOARDS:
                self.at(one, board)

    def at(self, one: State, board: dict[str, Any]) -> None:
        always = self.source.always if one.always else None
        events: list[tuple[Event, Place]] = [
            (e, ("state", one.no, "event", str(i))) for i, e in enumerate(one.events)
        ]
        if always is not None:
            events += [(e, ("always", "event", str(i))) for i, e in enumerate(always.events)]
        ready = [
            (event, place)
            for event, place in events
            if (event.when is None or holds(event.when, board))
            and not (event.next == BACK and one.no == self.start)
        ]
        unnamed = [(event, place) for event, place in ready if event.name is None]
        if unnamed:
            self.take(one, unnamed[0][0].next, unnamed[0][1])
            return
        for name in NAMES:
            first = next((x for x in ready if x[0].name == name), None)
            if first is not None:
                self.take(one, first[0].next, first[1])
        timeout = one.timeout
        place: Place = ("state", one.no, "timeout")
        if timeout is None and always is not None:
            timeout, place = always.timeout, ("always", "timeout")
        if timeout is not None and not (timeout.next == BACK and one.no == self.start):
            self.take(one, timeout.next, place)

    def take(self, one: State, next_: str | None, place: Place) -> None:
        self.taken[one.no].add(place)
        if next_ == BACK:
            self.back.add(one.no)
        elif next_ is not None:
            self.edges[one.no].add(one.no if next_ == "#again" else next_)

    def reach(self, edges: dict[str, set[str]], start: set[str]) -> set[str]:
        reached = set(start)
        while more := {t for s in reached for t in edges[s]} - reached:
            reached |= more
        return reached


@given(seed=st.integers(0, 2**64))
@settings(max_examples=300, deadline=None)
def test_events_and_states_are_told_exactly_where_no_values_take_or_reach_them(seed: int) -> None:
    source = Maker(seed, writes=False).application()
    problems = found(source)
    tried = Tried(source)
    places: set[Place] = set()
    if source.always is not None and any(one.always for one in source.states):
        places = {("always", "event", str(i)) for i in range(len(source.always.events))}
    for one in source.states:
        places |= {("state", one.no, "event", str(i)) for i in range(len(one.events))}
        if one.timeout is not None:
            places.add(("state", one.no, "timeout"))
    if (
        source.always
        and source.always.timeout is not None
        and any(s.always and s.timeout is None for s in source.states)
    ):
        places.add(("always", "timeout"))
    never = places - set().union(*tried.taken.values())
    codes = ("event-never-taken", "never-holds")
    said = {
        p.place[:-1] if p.code == "never-holds" else p.place for p in problems if p.code in codes
    }
    assert {p for p in said if p in places} == never
    reached = tried.reach(tried.edges, {tried.start})
    numbers = {one.no for one in source.states}
    assert {p.place[1] for p in problems if p.code == "unreachable-state"} == numbers - reached
    out = {no for no in numbers if no in tried.back or tried.edges[no] - {no}}
    final = {one.no for one in source.states if one.final}
    ends = {p.place[1] for p in problems if p.code == "dead-end"}
    assert ends == reached - out - final
    edges = {no: set(targets) for no, targets in tried.edges.items()}
    for no in tried.back:
        edges[no] |= {s for s, targets in tried.edges.items() if no in targets}
    good = {tried.start} | (reached - out) | final
    lost = {no for no in reached if not tried.reach(edges, {no}) & good}
    assert bool(lost) is ("no-way-back" in {p.code for p in problems})


def test_a_found_mend_takes_the_problem_away() -> None:
    from situ.document.mend import mends

    text = state("1", '<event name="e" next="2"/>' + IF.format('name="e" next="1"', 'is="1"'))
    source = application(text + state("2"))
    here = project(source)
    problems = [p for p in check(here) if p.code in SEARCHES]
    assert [p.code for p in problems] == ["event-never-taken", "dead-end"]
    for problem in problems:
        ((words, after),) = mends(here, problem)
        assert words
        assert isinstance(after, Application)
        left = [p.code for p in check(replace(here, applications={FILE: after}))]
        assert problem.code not in left
