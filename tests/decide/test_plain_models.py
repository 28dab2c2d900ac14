"""Authority, mapping, conditions and situations beside plain models of them.

formats.md: *SPDS* (authority, situations, mapping), *Conditions*.
"""

from __future__ import annotations

from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st
from tests.decide.random_projects import (
    FEW,
    MODULES,
    RESOURCES,
    SECOND,
    TAGS,
    Play,
    Scenario,
    conditions,
    entries,
    modules,
    projects,
    scenarios,
    sets_of_resources,
)

from situ.decide import inputs
from situ.decide.robot import Robot
from situ.decide.trace import Authority, Mapping, TraceEvent, to_fields
from situ.document.condition import Condition, Group
from situ.document.condition import Test as Leaf
from situ.document.project import Project
from situ.document.spds import Declaration, Entry, Situation, Spds

# -- authority and mapping ----------------------------------------------------


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


# -- conditions ---------------------------------------------------------------


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


# -- situations ---------------------------------------------------------------


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
