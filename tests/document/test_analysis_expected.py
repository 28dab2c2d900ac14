"""Events that nobody expects: what is told, beside runs of the robot itself.

Small applications with parts are made at random, in which everything raises an event of its own;
the robot is then driven through all that a person, its actions, the time and another module can
do. What is told must never be expected there, and what is never expected must be told.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import Struct
from msgspec.structs import replace

from situ.decide import inputs, trace
from situ.decide.robot import Robot
from situ.document import analysis_active, codec, mend
from situ.document.check import check
from situ.document.condition import Condition
from situ.document.condition import Test as Single
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import (
    AGAIN,
    BACK,
    Action,
    Always,
    Application,
    Button,
    Component,
    Event,
    Input,
    List,
    Message,
    Movie,
    Screen,
    Service,
    Set,
    Speech,
    State,
    Text,
    Timeout,
)
from situ.document.rbd import (
    Robot as Command,
)
from situ.document.spds import Declaration, Entry, Situation, Spds

FILE, PART = "a.rbd.xml", "p.rbd.xml"
AT: dict[str, Any] = {"x": 1.0, "y": 1.0, "width": 9.0, "height": 9.0}
SHAPE = 'x="1" y="1" width="9" height="9"'


def application(text: str, name: str = "a") -> Application:
    data = f'<application name="{name}">{text}</application>'.encode()
    document, problems = codec.read(data, FILE)
    assert isinstance(document, Application), problems
    assert not problems
    return document


def project(text: str, spds: Spds | None = None, **parts: str) -> Project:
    return Project(
        root="nowhere",
        name="a",
        applications={FILE: application(text)},
        parts={f"{name}.rbd.xml": application(part, name) for name, part in parts.items()},
        spds=spds,
        spds_file=None if spds is None else "a.spds.xml",
    )


def found(source: Project) -> list[Problem]:
    return [one for one in check(source) if one.code == "unexpected-event"]


def told(text: str, **parts: str) -> list[tuple[str, ...]]:
    return [one.place for one in found(project(text, None, **parts))]


def state(no: str, inside: str = "", events: str = "", more: str = "") -> str:
    return f'<state no="{no}" {more}>{inside}<expectedevents>{events}</expectedevents></state>'


def screen(inside: str = "", touched: str = "") -> str:
    more = f' touched="{touched}"' if touched else ""
    return f"<screen{more}><components>{inside}</components></screen>"


def acts(inside: str) -> str:
    return f"<backgroundactions>{inside}</backgroundactions>"


def event(name: str, to: str = "", inside: str = "") -> str:
    return f'<event name="{name}"{f" next={chr(34)}{to}{chr(34)}" if to else ""}>{inside}</event>'


GO = screen(f'<button id="go" {SHAPE} event="go"/>')
AT_GO = ("state", "1", "screen", "go")

# -- by hand -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("inside", "at"),
    [
        (GO, ("screen", "go")),
        (screen(f'<input id="go" {SHAPE} tag="x" event="go"/>'), ("screen", "go")),
        (screen(f'<list id="go" {SHAPE} items="x" event="go"/>'), ("screen", "go")),
        (screen(f'<movie id="go" {SHAPE} src="a" done="go"/>'), ("screen", "go")),
        (screen(f'<movie id="go" {SHAPE} src="a" failed="go"/>'), ("screen", "go")),
        (screen(touched="go"), ("screen",)),
        (acts('<speech done="go">a</speech>'), ("action", "0")),
        (acts('<sound src="a" failed="go"/>'), ("action", "0")),
        (acts('<launch program="a" done="go"/>'), ("action", "0")),
        (acts('<set tag="a" done="go">1</set>'), ("action", "0")),
    ],
)
def test_what_is_raised_must_be_expected_by_the_state(inside: str, at: tuple[str, ...]) -> None:
    other = event("other", "1")
    assert told(state("1", inside, other)) == [("state", "1", *at)]
    assert told(state("1", inside, event("go", "1"))) == []
    shared = f"<always><expectedevents>{event('go')}</expectedevents></always>"
    assert told(shared + state("1", inside, other)) == []
    assert told(shared + state("1", inside, other, 'always="false"')) == [("state", "1", *at)]


def test_an_event_that_fails_to_come_is_not_told() -> None:
    assert told(state("1", acts('<set tag="a" failed="go">1</set>'), event("e", "1"))) == []


def test_a_timeout_without_next_raises_its_event() -> None:
    one = state("1", "<timeout>5</timeout>", event("go", "1"))
    assert told(one) == [("state", "1", "timeout")]
    assert told(state("1", "<timeout>5</timeout>", event("timeout"))) == []
    shared = "<always><timeout>5</timeout></always>"
    assert told(shared + one) == [("state", "1", "timeout")]
    own = '<timeout next="#again">5</timeout>'
    assert told(shared + state("1", own, event("go"))) == []
    assert told(shared + state("1", "", event("go", "1"))) == [("always", "timeout")]


def test_a_kept_screen_is_expected_where_it_is_kept() -> None:
    one = state("1", GO, event("e", "2"))
    assert told(one + state("2", "", event("go", "1"))) == []
    assert told(one + state("2", "", event("f", "3")) + state("3", "", event("go", "1"))) == []
    assert told(one + state("2", "<screen/>", event("go", "1"))) == [AT_GO]
    passed = one + state("2", "<screen/>", event("f", "3")) + state("3", "", event("go", "1"))
    assert told(passed) == [AT_GO]
    back = state("1", "", event("e", "2")) + state("2", GO, event("b", BACK))
    assert told(back + state("3", "", event("go", "1"))) == [("state", "2", "screen", "go")]
    both = state("1", "", event("e", "2") + event("f", "3")) + state("2", GO, event("b", BACK))
    both += state("3", "", event("b", BACK)) + state("4", "", event("go", "1"))
    assert told(both) == [("state", "2", "screen", "go")]
    expecting = state("1", "", event("go") + event("e", "2"))
    assert told(expecting + state("2", GO, event("b", BACK))) == []


def test_the_screen_of_always_is_not_kept_where_always_is_left_out() -> None:
    shared = f"<always>{GO}</always>" + state("1", "", event("e", "2"))
    assert told(shared + state("2", "", event("go", "1"), 'always="false"')) == [
        ("always", "screen", "go")
    ]
    assert told(shared + state("2", "", event("go", "1"))) == []


def test_a_screen_is_kept_through_a_state_that_was_left_before_it_was_shown() -> None:
    resumed = state("2", "<screen/>", event("resumed", "3"))
    text = state("1", GO, event("e", "2")) + resumed + state("3", "", event("go", "1"))
    assert told(text) == [AT_GO]
    spds = Spds("s", situations=(Situation("s", entries=(Entry("a", 1),)),))
    assert found(project(text, spds)) == []


def test_a_component_that_writes_may_lead_on_before_its_event_is_judged() -> None:
    on = '<event next="2"><when><data tag="x" is="1"/></when></event>'
    two = state("2", "<screen/>", event("go", "1"))
    button = '<button id="go" {} event="go" {}/>'
    sets = screen(button.format(SHAPE, 'tag="x" value="1"'))
    assert told(state("1", sets, on) + two) == []
    assert told(state("1", screen(button.format(SHAPE, "")), on) + two) == [AT_GO]


def test_an_action_that_ends_at_once_may_be_judged_behind_another() -> None:
    several = acts('<message topic="a" done="one"/><message topic="b" done="two"/>')
    text = state("1", several, event("one", "2")) + state("2", "", event("two", "1"))
    assert told(text) == []
    slow = acts('<speech done="one">a</speech><clear tag="x"/><speech done="two">b</speech>')
    text = state("1", slow, event("one", "2")) + state("2", "", event("two", "1"))
    assert told(text) == [("state", "1", "action", "2")]


def test_what_is_kept_running_may_end_anywhere() -> None:
    service = '<service name="s" url="http://a/" done="go" {}/>'
    rest = state("2", "", event("f", "3")) + state("3", "", event("go", "1"))
    kept = acts(service.format('keep="true"'))
    assert told(state("1", kept, event("e", "2")) + rest) == []
    assert told(state("1", acts(service.format("")), event("e", "2")) + rest) == [
        ("state", "1", "action", "0")
    ]


def test_the_actions_of_an_event_belong_to_the_state_it_leads_to() -> None:
    sends = event("e", "2", '<message topic="t" done="sent"/>')
    place = ("state", "1", "event", "0", "action", "0")
    assert told(state("1", "", sends) + state("2", "", event("sent", "1"))) == []
    assert told(state("1", "", sends + event("sent")) + state("2", "", event("f", "1"))) == [place]
    inner = event("e", "", '<message topic="t" done="sent"/><repeat/>')
    assert told(state("1", "", inner + event("sent", "1"))) == []
    shared = f"<always><expectedevents>{inner}</expectedevents></always>"
    assert told(shared + state("1", "", event("f", "1"))) == [
        ("always", "event", "0", "action", "0")
    ]
    assert told(shared + state("1", "", event("sent", "1"))) == []
    # Nowhere to go back to: it is never taken.
    back = state("1", "", event("e", BACK, '<message topic="t" done="sent"/>'))
    assert told(back) == []


def test_a_touch_is_the_states_before_it_is_that_of_always() -> None:
    shared = f"<always>{screen(touched='touched')}</always>"
    e = event("e", "2")
    two = state("2", "", event("f", "1"))
    assert told(shared + state("1", screen(touched="e"), e) + two) == []
    assert told(shared + state("1", screen(touched="e"), e) + state("2", "<screen/>")) == [
        ("always", "screen")
    ]
    assert told(shared + state("1", screen(touched="e"), e + event("touched")) + two) == []
    assert told(shared + state("1", "", event("touched", "1"))) == []
    assert told(shared + state("1", "", event("f", "1"))) == [("always", "screen")]


def test_a_state_around_a_part_may_expect_what_is_raised_inside() -> None:
    holder = '<state no="1"><flow src="p.rbd.xml"/><expectedevents>{}</expectedevents></state>'
    part = state("1", GO, event("e", "1"))
    assert found(project(holder.format(event("go", "1")), p=part)) == []
    (one,) = found(project(holder.format(event("f", "1")), p=part))
    assert (one.file.rpartition("/")[2], one.place) == (PART, AT_GO)
    twice = holder.format(event("f", "2")) + holder.replace('"1"', '"2"', 1).format(
        event("go", "1")
    )
    assert found(project(twice, p=part)) == []


def test_nothing_is_said_of_a_part_that_is_missing_or_holds_itself() -> None:
    shared = f"<always>{GO}</always>"
    assert told(shared + '<state no="1"><flow src="nothing.rbd.xml"/></state>') == []
    circle = '<state no="2"><flow src="p.rbd.xml"/></state>'
    assert found(project(state("1", GO, event("f", "1")) + circle, p=circle)) == []
    assert told(state("1", GO, event("f", "1")) + circle, p="") == [AT_GO]


def test_two_states_that_share_one_value_are_judged_each_for_itself() -> None:
    """As when an editor has made a copy of a state."""
    one = application(state("1", GO, event("go", "1"))).states[0]
    two = replace(one, no="2", events=(Event("f", "1"),))
    copied = replace(project(""), applications={FILE: Application("a", None, None, (one, two))})
    assert [p.place for p in found(copied)] == [("state", "2", "screen", "go")]


def test_what_has_too_many_states_is_told_as_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(analysis_active, "MOST", 1)
    problems = check(project(state("1", GO, event("f", "2")) + state("2", "", event("f", "1"))))
    assert [(p.code, p.line) for p in problems] == [("undecided", 0)]


# -- words and mends -----------------------------------------------------------------------


def after(source: Project) -> tuple[Problem, list[tuple[str, ...]]]:
    """The one that is found, and what is found when it is mended."""
    (one,) = found(source)
    ((_, document),) = mend.mends(source, one)
    assert one.mend is not None
    assert not one.mend.safe
    return one, [p.place for p in found(mend.put(source, one.mend.file, document))]


def test_a_name_that_is_nearly_expected_was_meant() -> None:
    text = screen(f'<button id="go" {SHAPE} event="clickCotninue"/>')
    one, left = after(project(state("1", text, event("clickContinue", "1"))))
    assert "did you mean “clickContinue”?" in one.message
    assert left == []


@pytest.mark.parametrize(
    ("text", "says", "where"),
    [
        (
            state("1", GO, event("f", "1")),
            "This button raises “go”, but no state expects it: add an expected event",
            "state 1",
        ),
        (
            state("1", GO, event("f", "2")) + state("2", "<screen/>", event("go", "1")),
            "but the state “1” does not expect it: add",
            "state 1",
        ),
        (
            f"<always>{GO}</always>"
            + "".join(state(n, "", event("f", "1")) for n in "12345")
            + state("6", "", event("go", "1"), 'always="false"'),
            "but none of the states “1”, “2”, “3” and 2 more expects it",
            "every state",
        ),
        (state("1", screen(touched="go"), event("f", "1")), "A touch on this screen", "state 1"),
        (
            state("1", acts('<speech failed="go">a</speech>'), event("f", "1")),
            "The failure of this speech",
            "state 1",
        ),
        (
            state("1", "<timeout>5</timeout>", event("f", "1")),
            "let the timeout lead to a state",
            "state 1",
        ),
        (
            state("1", "", event("f", "2", '<message topic="t" done="go"/>'))
            + state("2", "", event("g", "1")),
            "The end of this message",
            "state 2",
        ),
    ],
)
def test_else_the_event_can_be_expected_at_a_click(text: str, says: str, where: str) -> None:
    one, left = after(project(text))
    assert says in one.message
    assert one.mend is not None
    assert one.mend.words.endswith(f"in {where}")
    assert left == []


# -- beside the robot ----------------------------------------------------------------------


class Maker:
    """Projects in which every raiser has an event of its own: ``r0``, ``r1`` …

    plain: without what may lead on before an event is judged (unnamed events, ``resumed``,
    ``#back``, actions that end at once, services, tags that components write).
    """

    def __init__(self, seed: int, plain: bool) -> None:
        self.random = Random(seed)
        self.plain = plain
        self.raised: list[str] = []
        self.names = 0
        self.count = 0

    def project(self) -> Project:
        random = self.random
        with_part = random.random() < 0.5
        files = {FILE: self.application(with_part)}
        if with_part:
            files[PART] = self.application(False)
        free = [*self.raised, *(f"x{n}" for n in range(4))]
        if not self.plain:
            free += ["resumed", "resumed"]
        random.shuffle(free)
        made = {file: self.named(one, free) for file, one in files.items()}
        suspends = not self.plain and random.random() < 0.5
        script = Spds(
            "s",
            (),
            (Declaration("m", ("screen",)), Declaration("a", ("screen", "speech", "base"))),
            (Situation("s", entries=(Entry("m", 2), Entry("a", 1))),),
        )
        return Project(
            root="nowhere",
            name="a",
            applications={FILE: made[FILE]},
            parts={PART: made[PART]} if with_part else {},
            spds=script if suspends else None,
            spds_file="a.spds.xml" if suspends else None,
        )

    def application(self, with_part: bool) -> Application:
        random = self.random
        numbers = ["1", "2", "3"]
        flows = {random.choice(numbers)} if with_part else set()
        states = tuple(self.state(no, numbers, no in flows) for no in numbers)
        always = None
        if random.random() < 0.5:
            shown = self.screen() if random.random() < 0.6 else None
            limit = self.timeout(numbers) if random.random() < 0.2 else None
            always = Always(limit, shown, self.events(numbers, 1))
        return Application("a", None, always, states)

    def state(self, no: str, numbers: list[str], is_flow: bool) -> State:
        random = self.random
        shown = random.choice([None, None, Screen(), self.screen(), self.screen()])
        return State(
            no,
            always=random.random() < 0.7,
            flow=PART if is_flow else None,
            timeout=self.timeout(numbers) if random.random() < 0.2 and not is_flow else None,
            screen=None if is_flow else shown,
            actions=() if is_flow else self.actions(),
            events=self.events(numbers, random.choice([1, 2, 2])),
        )

    def timeout(self, numbers: list[str]) -> Timeout:
        return Timeout(5.0, self.random.choice([AGAIN, *numbers]))

    def raiser(self) -> str:
        self.raised.append(f"r{len(self.raised)}")
        return self.raised[-1]

    def events(self, numbers: list[str], count: int) -> tuple[Event, ...]:
        """Named afterwards, when all that is raised is known."""
        made = []
        for _ in range(count):
            targets = [None, AGAIN, *numbers, *([] if self.plain else [BACK, BACK])]
            to = self.random.choice(targets)
            actions: list[Action] = []
            if not self.plain and self.random.random() < 0.3:
                actions.append(Message(topic="t", done=self.raiser()))
            made.append(Event("", to, None, (), tuple(actions)))
        return tuple(made)

    def named(self, one: Application, free: list[str]) -> Application:
        def name(events: tuple[Event, ...]) -> tuple[Event, ...]:
            made = []
            for event in events:
                self.names += 1
                when, called = None, free.pop() if free else f"y{self.names}"
                if not self.plain and event.next is not None and self.random.random() < 0.15:
                    called = ""
                    when = Condition((Single("x", "is", "1"),))
                made.append(Event(called or None, event.next, when, (), event.actions))
            return tuple(made)

        always = one.always
        if always is not None:
            always = Always(always.timeout, always.screen, name(always.events))
        states = [
            State(s.no, "", s.flow, s.always, False, s.timeout, s.screen, s.actions, name(s.events))
            for s in one.states
        ]
        return Application(one.name, None, always, tuple(states))

    def screen(self) -> Screen:
        random = self.random
        made: list[Component] = []
        touched = self.raiser() if random.random() < 0.4 else None
        for _ in range(random.choice([0, 1, 1, 2])):
            self.count += 1
            called: dict[str, Any] = {"id": f"c{self.count}", **AT}
            tag = "x" if not self.plain and random.random() < 0.4 else None
            match random.randrange(5):
                case 0 | 1:
                    made.append(Button(event=self.raiser(), tag=tag, value="1", **called))
                case 2:
                    tag = "x" if not self.plain else "typed"
                    made.append(Input(event=self.raiser(), tag=tag, kind="number", **called))
                case 3:
                    made.append(List(event=self.raiser(), items="x", tag=tag, **called))
                case _:
                    made.append(Movie(done=self.raiser(), src="a.webm", **called))
        return Screen(None, touched, tuple(made) or (Text(text="a", id=f"t{self.count}", **AT),))

    def actions(self) -> tuple[Action, ...]:
        random = self.random
        made: list[Action] = []
        while random.random() < 0.4:
            wait = not self.plain and random.random() < 0.4
            match random.randrange(2 if self.plain else 6):
                case 0:
                    made.append(Speech(text="a", done=self.raiser(), wait=wait))
                case 1:
                    made.append(
                        Command(resource="base", command="go", failed=self.raiser(), wait=wait)
                    )
                case 2 | 3:
                    made.append(
                        Service(
                            name=f"s{len(self.raised)}",
                            url="http://a/",
                            done=self.raiser(),
                            failed=self.raiser(),
                            keep=random.random() < 0.4,
                            wait=wait,
                        )
                    )
                case 4:
                    made.append(Set(tag="x", text=random.choice(["1", "2"]), done=self.raiser()))
                case _:
                    made.append(Message(topic="t", done=self.raiser()))
        return tuple(made)


class Seen(Struct):
    """Where a run stands; what its trace told is shown: the ids of the components."""

    snapshot: bytes
    now: int
    shown: tuple[str, ...] = ()


class Run:
    """The robot of a project, driven through what can happen; the names of the events that were
    judged in states which expect them, and in states which do not.
    """

    def __init__(self, source: Project, most: int) -> None:
        self.accepted: set[str] = set()
        self.ignored: set[str] = set()
        self.entered: set[str] = set()
        self._robot = Robot(source)
        self._asks = source.spds is not None
        files = (*source.applications.values(), *source.parts.values())
        holders = [one for file in files for one in (file.always, *file.states) if one is not None]
        self._names = sorted({e.name for one in holders for e in one.events if e.name is not None})
        known: set[Any] = set()
        waiting = [self._step(inputs.Start(), Seen(b"", 0))]
        while waiting:
            here = waiting.pop(0)
            key = self._key(here)
            if key in known:
                continue
            if len(known) == most:
                break
            known.add(key)
            for given_ in self._inputs(here):
                self._robot.restore(here.snapshot)
                waiting.append(self._step(given_, here))
            self._robot.restore(here.snapshot)
            due = self._robot.due()
            if due is not None:
                waiting.append(self._step(None, Seen(b"", due, here.shown)))

    def _step(self, given_: inputs.AnyInput | None, here: Seen) -> Seen:
        events, _ = self._robot.step(given_, here.now)
        shown = here.shown
        ignored = {one.cause for one in events if isinstance(one, trace.Ignored)}
        unexpected = {
            one.cause
            for one in events
            if isinstance(one, trace.Ignored) and one.reason == "unexpected"
        }
        # What came from outside tells nothing of who raises it here.
        outside = given_.event if isinstance(given_, inputs.Raise) else None
        for one in events:
            if isinstance(one, trace.Screen):
                shown = tuple(component["id"] for component in one.components)
            if isinstance(one, trace.Enter):
                self.entered.add(one.state)
            if isinstance(one, trace.Event):
                if one.name == outside:
                    continue
                if one.seq in unexpected:
                    self.ignored.add(one.name)
                elif one.seq not in ignored:
                    self.accepted.add(one.name)
        return Seen(self._robot.snapshot(), here.now, shown)

    def _key(self, here: Seen) -> Any:
        self._robot.restore(here.snapshot)
        look = self._robot.board.look
        moves = tuple(str(look(f"robot/{one}")) for one in ("screen", "speech", "base"))
        return (str(look("application/a")), look("x"), moves, here.shown)

    def _inputs(self, here: Seen) -> Iterator[inputs.AnyInput]:
        for component in here.shown:
            yield inputs.Use(component)
            yield inputs.Use(component, 1)
        yield inputs.Touch()
        for name in self._names:
            yield inputs.Raise(name)
        for action in ("speech", "robot", "service", "movie"):
            yield inputs.Finish(action, ok=True)
            yield inputs.Finish(action, ok=False)
        if self._asks:
            yield inputs.Acquire("m", ("screen",))
            yield inputs.Abandon("m")


def states_of(source: Project) -> set[str]:
    """The paths of all states."""
    found_ = set()
    for one in source.applications[FILE].states:
        found_.add(one.no)
        if one.flow is not None:
            found_.update(f"{one.no}/{inner.no}" for inner in source.parts[PART].states)
    return found_


def names_told(source: Project) -> set[str]:
    words = [re.search("raises “(.+?)”", one.message) for one in found(source)]
    return {word[1] for word in words if word is not None}


@given(seed=st.integers(0, 2**64))
@settings(max_examples=20, deadline=None)
def test_what_is_told_is_expected_in_no_run(seed: int) -> None:
    source = Maker(seed, plain=False).project()
    names = names_told(source)
    if names:
        assert not names & Run(source, 40).accepted


@given(seed=st.integers(0, 2**64))
@settings(max_examples=20, deadline=None)
def test_what_no_state_expects_in_any_run_is_told(seed: int) -> None:
    source = Maker(seed, plain=True).project()
    run = Run(source, 40)
    names = names_told(source)
    assert not names & run.accepted
    # Whether a state is reached is not asked by what is told, and here it must be.
    if run.entered >= states_of(source):
        own = {name for name in run.ignored if name.startswith("r")}
        assert own - run.accepted <= names
