"""Laws that hold whatever the project and the scenario: random ones, and plain models beside.

formats.md: *SPDS* (authority, situations, mapping), *Conditions*, *Trace*, and
architecture, idea 2 (the same input gives the same bytes; snapshot and restore).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any
from unittest.mock import patch

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from situ.decide import inputs, machine
from situ.decide.effects import AnyEffect, Begin, Cancel, Map
from situ.decide.flips import Flips
from situ.decide.robot import Robot
from situ.decide.trace import Authority, Data, Mapping, TraceEvent, to_fields, to_line
from situ.decide.trace import Condition as ConditionEvent
from situ.decide.values import compile_test
from situ.document.condition import Condition, Group
from situ.document.condition import Test as Leaf
from situ.document.project import Project
from situ.document.rbd import (
    AGAIN,
    BACK,
    Action,
    Add,
    Always,
    Application,
    Event,
    Launch,
    Message,
    Param,
    Repeat,
    Screen,
    Service,
    Set,
    Sound,
    Speech,
    State,
    Take,
    Text,
    Timeout,
)
from situ.document.rbd import Robot as RobotAction
from situ.document.spds import Declaration, Entry, Situation, Spds

if TYPE_CHECKING:
    from tests.decide.conftest import Build

FEW = settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
TAGS = ("x", "y")
RESOURCES = ("arm", "head", "screen", "speech")
MODULES = ("m", "n", "o")
NAMES = ("go", "on", "timeout", "said", "resumed")
SECOND = 1_000_000

# -- random projects ---------------------------------------------------------

values = st.sampled_from([None, 0, 1, 2, True, "a", [1, 2]])
seconds = st.sampled_from([0.5, 1, 2, 3])
tests = st.builds(
    Leaf,
    st.sampled_from(TAGS),
    st.sampled_from(["is", "isnot", "above", "atmost", "exists"]),
    st.sampled_from(["1", "true"]),
    st.none() | seconds,
    st.none() | seconds,
)
nodes = st.recursive(
    tests,
    lambda inner: st.builds(
        Group,
        st.sampled_from(["all", "any", "none"]),
        st.lists(inner, min_size=1, max_size=3).map(tuple),
    ),
    max_leaves=4,
)
conditions = st.builds(Condition, st.lists(nodes, min_size=1, max_size=2).map(tuple))
raised = st.none() | st.sampled_from(NAMES)
silent: st.SearchStrategy[Action] = st.one_of(
    st.builds(Set, tag=st.sampled_from(TAGS), text=st.sampled_from(["1", "{x}", "a {y}"])),
    st.builds(Add, tag=st.sampled_from(TAGS), text=st.just("1"), done=raised),
    st.builds(Take, source=st.just("y"), tag=st.just("x"), order=st.just("random")),
    st.builds(Message, topic=st.just("t"), text=st.just("{x}"), done=raised),
    st.builds(
        Service, name=st.just("s"), url=st.just("http://x/"), done=raised, wait=st.booleans(),
    ),
    st.builds(Launch, program=st.just("p"), failed=raised, keep=st.booleans()),
)  # fmt: skip
visible: st.SearchStrategy[Action] = st.one_of(
    st.builds(
        Speech, text=st.just("Say {x}"), done=raised, wait=st.booleans(), optional=st.booleans(),
    ),
    st.builds(Sound, src=st.just("a.ogg"), optional=st.booleans()),
    st.builds(
        RobotAction, resource=st.sampled_from(["arm", "head"]), command=st.just("c"),
        params=st.just((Param("p", "{x}"),)), done=raised, optional=st.booleans(),
        wait=st.booleans(),
    ),
)  # fmt: skip
screens = st.none() | st.sampled_from(
    [
        Screen(),
        Screen(
            touched="go",
            components=(Text(id="t", x=1, y=1, width=1, height=1, text="{x} {y}"),),
        ),
    ]
)
STATES = ("1", "2", "3")
targets = st.sampled_from([*STATES, AGAIN, BACK])
named = st.builds(
    Event,
    name=st.sampled_from(NAMES),
    next=st.none() | targets,
    when=st.none() | conditions,
    actions=st.lists(silent, max_size=2).map(tuple),
)
repeats = st.just(Event(name="on", actions=(Repeat(),)))
unnamed = st.builds(Event, next=targets, when=conditions)
events = st.lists(st.one_of(named, repeats, unnamed), max_size=3).map(tuple)
timeouts = st.none() | st.builds(Timeout, seconds, st.none() | targets, st.booleans())


@st.composite
def applications(draw: st.DrawFn, name: str) -> Application:
    states = tuple(
        State(
            no=no,
            timeout=draw(timeouts),
            screen=draw(screens),
            actions=draw(st.lists(st.one_of(silent, visible), max_size=3).map(tuple)),
            events=draw(events),
        )
        for no in STATES
    )
    return Application(name, "1", Always(events=draw(events)), states)


@st.composite
def scripts(draw: st.DrawFn) -> Spds:
    modules = (*MODULES, "a", "b")
    declared = tuple(Declaration(name, RESOURCES) for name in modules)
    situations = []
    for number in range(draw(st.integers(0, 3))):
        keeps: dict[str, Any] = draw(
            st.sampled_from([{}, {"dwell": 1.0}, {"limit": 2.0}, {"until": None}])
        )
        if "until" in keeps:
            keeps = {"until": draw(conditions)}
        situations.append(
            Situation(
                f"s{number}", condition=draw(conditions), entries=draw(entries(modules)), **keeps
            )
        )
    situations.append(Situation("last", entries=draw(entries(modules))))
    return Spds("script", (), declared, tuple(situations))


@st.composite
def entries(draw: st.DrawFn, modules: tuple[str, ...]) -> tuple[Entry, ...]:
    given_ = ((module, draw(st.none() | st.integers(0, 3))) for module in modules)
    return tuple(Entry(module, priority) for module, priority in given_ if priority is not None)


@st.composite
def projects(draw: st.DrawFn) -> Project:
    return Project(
        root=".",
        name="random",
        applications={f"{name}.rbd.xml": draw(applications(name)) for name in "ab"},
        spds=draw(scripts()),
        tags={"y": [1, 2, 3]},
    )


sets_of_resources = st.lists(st.sampled_from(RESOURCES), unique=True, max_size=3).map(tuple)
modules = st.sampled_from(MODULES)
one_or_all = st.sampled_from([None, "a", "b"])
operators: st.SearchStrategy[inputs.AnyInput] = st.one_of(
    st.builds(inputs.Pause, st.just("operator:ann"), one_or_all),
    st.builds(inputs.Resume, st.just("operator:ann"), one_or_all),
    st.builds(inputs.Step, st.just("operator:ann"), one_or_all),
    st.builds(inputs.Goto, st.just("operator:ann"), st.sampled_from(STATES), one_or_all),
    st.builds(inputs.Break, st.just("operator:ann"), one_or_all, st.sampled_from(STATES)),
    st.builds(
        lambda to, name: inputs.Break("operator:ann", name, to=to),
        st.sampled_from(STATES), one_or_all,
    ),
)  # fmt: skip
given_inputs: st.SearchStrategy[inputs.AnyInput] = st.one_of(
    st.builds(
        inputs.Set, st.dictionaries(st.sampled_from(TAGS), values, min_size=1), st.just("scenario")
    ),
    st.builds(inputs.Raise, st.sampled_from(NAMES)),
    st.just(inputs.Touch()),
    st.builds(inputs.Acquire, modules, sets_of_resources, sets_of_resources),
    st.builds(inputs.Abandon, modules, sets_of_resources),
    st.builds(
        inputs.Command, modules, st.sampled_from(RESOURCES), st.integers(0, 2), st.none() | seconds
    ),
    st.builds(inputs.Lost, modules),
    st.builds(inputs.Finish, st.sampled_from(["speech", "service", "robot", None])),
    operators,
)
scenarios = st.lists(st.tuples(st.integers(0, 4), given_inputs), max_size=25)
Scenario = list[tuple[int, inputs.AnyInput]]


class Play:
    """A robot that is fed a scenario: half seconds to wait, then an input."""

    def __init__(self, project: Project, auto_finish: float | None = None) -> None:
        self.robot = Robot(project)
        self.events: list[TraceEvent] = []
        self.effects: list[AnyEffect] = []
        self.now = 0
        self._take(*self.robot.step(inputs.Start(7, auto_finish), 0))

    def feed(self, scenario: Scenario) -> None:
        for wait, given_ in scenario:
            self.now += wait * SECOND // 2
            self.advance()
            self._take(*self.robot.step(given_, self.now))

    def advance(self) -> None:
        while (due := self.robot.due()) is not None and due <= self.now:
            self._take(*self.robot.step(None, due))

    def _take(self, events: list[TraceEvent], effects: list[AnyEffect]) -> None:
        self.events += events
        self.effects += effects

    @property
    def bytes(self) -> bytes:
        return b"".join(map(to_line, self.events))


# -- the trace ---------------------------------------------------------------


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


# -- what a driver has to do -------------------------------------------------


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


# -- authority and mapping ---------------------------------------------------


class Model:
    """Priority management, said as plainly as can be: all is worked out anew each time."""

    def __init__(self, script: Spds) -> None:
        self.priorities = script.priorities(script.situations[-1])
        self.requests: dict[str, tuple[frozenset[str], frozenset[str], int]] = {}
        self.holders: dict[str, str] = {}
        self.count = 0

    def take(self, given_: inputs.AnyInput) -> None:
        if isinstance(given_, inputs.Acquire):
            self._ask(given_.module, frozenset(given_.resources), frozenset(given_.optional))
        elif isinstance(given_, inputs.Abandon) and given_.module in self.requests:
            wanted, able, _ = self.requests[given_.module]
            gone = frozenset(given_.resources) or wanted | able
            self._ask(given_.module, wanted - gone, able - gone)
        elif isinstance(given_, inputs.Lost):
            self.requests.pop(given_.module, None)
        self._grant()

    def _ask(self, module: str, wanted: frozenset[str], able: frozenset[str]) -> None:
        self.count += 1
        place = self.requests[module][2] if module in self.requests else self.count
        if wanted or able:
            self.requests[module] = (wanted, able - wanted, place)
        else:
            self.requests.pop(module, None)

    def _grant(self) -> None:
        def turn(module: str) -> tuple[int, bool, int]:
            wanted, able, place = self.requests[module]
            has = any(self.holders.get(resource) == module for resource in wanted | able)
            return -self.priorities[module], not has, place

        holders: dict[str, str] = {}
        for module in sorted(filter(self.priorities.__contains__, self.requests), key=turn):
            wanted, able, _ = self.requests[module]
            if not wanted & holders.keys():
                holders.update(dict.fromkeys(wanted | (able - holders.keys()), module))
        self.holders = holders


only_modules = st.lists(
    st.one_of(
        st.builds(inputs.Acquire, modules, sets_of_resources, sets_of_resources),
        st.builds(inputs.Abandon, modules, sets_of_resources),
        st.builds(inputs.Lost, modules),
    ),
    max_size=30,
)


@FEW
@given(entries(MODULES), only_modules)
def test_authority_is_as_the_plain_model_has_it(
    given_: tuple[Entry, ...], asked: list[inputs.AnyInput]
) -> None:
    declared = tuple(Declaration(name, RESOURCES) for name in MODULES)
    script = Spds("script", (), declared, (Situation("s", entries=given_),))
    robot, model = Robot(Project(root=".", name="p", spds=script)), Model(script)
    robot.step(inputs.Start(), 0)
    holders: dict[str, str | None] = {}
    for moment, one in enumerate(asked, 1):
        events, _ = robot.step(one, moment)
        for event in events:
            if isinstance(event, Authority):
                assert holders.get(event.resource) == event.source
                holders[event.resource] = event.to
        model.take(one)
        assert {r: m for r, m in holders.items() if m is not None} == model.holders
        # All or none; and nobody waits for what is free.
        for module, (wanted, _, _) in model.requests.items():
            held = {r for r in wanted if holders.get(r) == module}
            assert held in (set(), wanted)
            if module in model.priorities and wanted and not held:
                assert any(holders.get(r) is not None for r in wanted)


@FEW
@given(projects(), scenarios)
def test_what_moves_the_robot_is_the_holders_valid_command(
    project: Project, scenario: Scenario
) -> None:
    play = Play(project, 1.0)
    holders: dict[str, str | None] = {}
    moved: dict[str, Any] = {}
    made: dict[tuple[str, str], tuple[Any, int | None]] = {}
    wanted: dict[str, set[str]] = {}
    for wait, one in scenario:
        play.feed([(wait, one)])
        for event in play.events:
            if isinstance(event, Authority):
                lost = (event.source or "", event.resource)
                if lost in made and made[lost][1] is None:
                    del made[lost]
                holders[event.resource] = event.to
            elif isinstance(event, Mapping):
                assert event.module == holders.get(event.resource)
                moved[event.resource] = event.value
        play.events = []
        if isinstance(one, inputs.Command):
            until = None if one.valid is None else play.now + int(one.valid * SECOND)
            holds = holders.get(one.resource) == one.module
            made[one.module, one.resource] = (one.value if holds or until else None, until)
        elif isinstance(one, inputs.Lost):
            made = {key: value for key, value in made.items() if key[0] != one.module}
            wanted.pop(one.module, None)
        elif isinstance(one, inputs.Abandon):
            gone = one.resources or RESOURCES
            made = {k: v for k, v in made.items() if k[0] != one.module or k[1] not in gone}
            wanted.get(one.module, set()).difference_update(gone)
        elif isinstance(one, inputs.Acquire):
            asked = {*one.resources, *one.optional}
            for resource in wanted.get(one.module, set()) - asked:
                made.pop((one.module, resource), None)
            wanted[one.module] = asked
        for resource, holder in holders.items():
            entry = play.robot.board.get(f"robot/{resource}")
            assert moved.get(resource) == (None if entry is None else entry.value)
            if holder is None:
                assert entry is None
            if holder in MODULES:
                value, until = made.get((holder, resource), (None, None))
                valid = until is None or until > play.now
                assert (None if entry is None else entry.value) == (value if valid else None)


# -- conditions --------------------------------------------------------------

Writes = list[tuple[int, dict[str, Any]]]


class History:
    """Direct evaluation: every test is judged from the list of all writes up to a moment."""

    def __init__(self, writes: Writes) -> None:
        self.writes = writes

    def holds(self, node: Leaf | Group | Condition, at: int) -> bool:
        if isinstance(node, Condition):
            return all(self.holds(child, at) for child in node.children)
        if isinstance(node, Group):
            found = [self.holds(child, at) for child in node.children]
            return {"all": all(found), "any": any(found), "none": not any(found)}[node.kind]
        if not self._test(node, self._value(node.tag, at)):
            return False
        if node.within is not None:
            last = max((t for t, tags in self.writes if node.tag in tags and t <= at), default=None)
            if last is None or at >= last + int(node.within * SECOND):
                return False
        if node.hold is not None:
            since = at
            for moment, tags in reversed([w for w in self.writes if w[0] <= at]):
                if node.tag in tags:
                    if not self._test(node, tags[node.tag]):
                        break
                    since = moment
            else:
                if self._test(node, None):
                    since = 0
            return at >= since + int(node.hold * SECOND)
        return True

    def _value(self, tag: str, at: int) -> Any:
        return next((w[tag] for t, w in reversed(self.writes) if tag in w and t <= at), None)

    @staticmethod
    def _test(test: Leaf, value: Any) -> bool:
        number = isinstance(value, (int, float)) and not isinstance(value, bool)
        wanted: Any = True if test.value == "true" else 1
        if test.test == "exists":
            return value is not None
        if test.test in ("is", "isnot"):
            return (type(value) is type(wanted) and value == wanted) is (test.test == "is")
        if wanted is True or not number:
            return False
        return bool(value > 1 if test.test == "above" else value <= 1)


# Moments are odd half seconds apart from the ends of within and for, which are judged
# between them; deletions of what is missing are no writes.
write_times = st.lists(
    st.tuples(
        st.integers(1, 5),
        st.dictionaries(st.sampled_from(TAGS), st.sampled_from([0, 1, 2, True, None]), min_size=1),
    ),
    min_size=1,
    max_size=10,
)


@settings(FEW, max_examples=150)
@given(conditions, write_times)
def test_conditions_are_as_direct_evaluation_has_them(
    condition: Condition, given_: list[tuple[int, dict[str, Any]]]
) -> None:
    script = Spds("s", (), (), (Situation("a", condition=condition), Situation("b")))
    robot = Robot(Project(root=".", name="p", spds=script))
    events, _ = robot.step(inputs.Start(), 0)
    now, holds = 0, [event for event in events if to_fields(event)["kind"] == "condition"] != []
    written: Writes = []
    missing: dict[str, Any] = {}
    assert holds is History([]).holds(condition, 0)
    for wait, tags in given_:
        now += wait * 510_000
        while (due := robot.due()) is not None and due <= now:
            holds = after(robot.step(None, due)[0], holds)
            assert holds is History(written).holds(condition, due)
        holds = after(robot.step(inputs.Set(tags, "m"), now)[0], holds)
        real = {t: v for t, v in tags.items() if v is not None or missing.get(t) is not None}
        missing.update(tags)
        written.append((now, real))
        assert holds is History(written).holds(condition, now)


def after(events: list[TraceEvent], holds: bool) -> bool:
    for event in events:
        fields = to_fields(event)
        if fields["kind"] == "condition":
            assert fields["holds"] is not holds
            holds = fields["holds"]
    return holds


# -- situations --------------------------------------------------------------

TRUE = tuple(Leaf(tag, "is", "true") for tag in ("p", "q", "u"))
kept = st.sampled_from(
    [{}, {"dwell": 2.0}, {"limit": 3.0}, {"until": 1}, {"until": 1, "limit": 3.0}]
)
flips = st.lists(
    st.tuples(
        st.integers(1, 7),
        st.dictionaries(st.sampled_from("pqu"), st.booleans(), min_size=1),
    ),
    max_size=14,
)


class Watch:
    """One situation, said plainly. since: when it became current in this time of holding."""

    def __init__(self, source: Situation) -> None:
        self.source = source
        self.since: int | None = None
        self.spent = False

    def length(self) -> int | None:
        length = self.source.dwell if self.source.dwell is not None else self.source.limit
        return None if length is None else int(length * SECOND)

    def holds(self, condition: bool, until: bool, now: int) -> bool:
        source = self.source
        if not condition:
            self.spent = False
        length = self.length()
        over = self.since is not None and length is not None and now >= self.since + length
        if source.dwell is not None:
            held = condition or (self.since is not None and not over)
        elif self.since is not None and (source.until is not None or source.limit is not None):
            held = not until and not over
            if not held:
                self.spent = condition
        else:
            held = condition and not until and not self.spent
        if not held:
            self.since = None
        return held


@settings(FEW, max_examples=120)
@given(kept, kept, flips)
def test_situations_are_as_the_plain_model_has_them(
    one: dict[str, Any], other: dict[str, Any], given_: list[tuple[int, dict[str, bool]]]
) -> None:
    until = Condition((TRUE[2],))
    sources = tuple(
        Situation(
            name,
            condition=Condition((test,)),
            until=until if "until" in keeps else None,
            dwell=keeps.get("dwell"),
            limit=keeps.get("limit"),
        )
        for name, test, keeps in (("a", TRUE[0], one), ("b", TRUE[1], other))
    )
    robot = Robot(
        Project(root=".", name="p", spds=Spds("s", (), (), (*sources, Situation("rest"))))
    )
    robot.step(inputs.Start(), 0)
    watches = [Watch(source) for source in sources]
    tags = {"p": False, "q": False, "u": False}

    def judge(now: int) -> str:
        held = [
            watch.holds(tags[tag], tags["u"] and watch.source.until is not None, now)
            for watch, tag in zip(watches, "pq", strict=True)
        ]
        for watch, holds in zip(watches, held, strict=True):
            if holds:
                if watch.since is None:
                    watch.since = now
                return watch.source.name
        return "rest"

    def current() -> Any:
        return robot.board.look("situation.name")

    now = 0
    for wait, flip in given_:
        now += wait * 400_000
        while (due := robot.due()) is not None and due <= now:
            robot.step(None, due)
            assert current() == judge(due)
        tags.update(flip)
        robot.step(inputs.Set(dict(flip), "m"), now)
        assert current() == judge(now)


# -- speed does not depend on how many there are ----------------------------

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
