"""Projects and scenarios of which nothing is known but that they may be: for laws."""

from __future__ import annotations

from typing import Any

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

from situ.decide import inputs
from situ.decide.effects import AnyEffect
from situ.decide.robot import Robot
from situ.decide.trace import TraceEvent, to_line
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

FEW = settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
TAGS = ("x", "y")
RESOURCES = ("arm", "head", "screen", "speech")
MODULES = ("m", "n", "o")
NAMES = ("go", "on", "timeout", "said", "resumed")
SECOND = 1_000_000
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

Scenario = list[tuple[int, inputs.AnyInput]]
scenarios = st.lists(st.tuples(st.integers(0, 4), given_inputs), max_size=25)


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
