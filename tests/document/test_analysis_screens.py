"""Screens: what lies off the screen and what is in another's way, beside plain models of both."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.decide import inputs, trace
from situ.decide.robot import Robot
from situ.document import codec, mend
from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import (
    Always,
    Application,
    Button,
    Component,
    Event,
    Image,
    Input,
    List,
    Movie,
    Screen,
    State,
    Text,
)

FILE, PART = "a.rbd.xml", "p.rbd.xml"
CODES = ("off-screen", "covered-component")


def application(text: str, name: str = "a") -> Application:
    data = f'<application name="{name}">{text}</application>'.encode()
    document, problems = codec.read(data, FILE)
    assert isinstance(document, Application), problems
    assert not problems
    return document


def project(text: str, **parts: str) -> Project:
    return Project(
        root="nowhere",
        name="a",
        applications={FILE: application(text)},
        parts={f"{name}.rbd.xml": application(part, name) for name, part in parts.items()},
    )


def found(source: Project) -> list[Problem]:
    return [one for one in check(source) if one.code in CODES]


def screen(*components: str) -> str:
    return f"<screen><components>{''.join(components)}</components></screen>"


def shown(*components: str) -> Project:
    return project(f'<state no="1" final="true">{screen(*components)}</state>')


def told(*components: str) -> list[tuple[str, str]]:
    return [(one.code, one.place[-1]) for one in found(shown(*components))]


def at(kind: str, name: str, box: tuple[float, float, float, float], more: str = "") -> str:
    x, y, width, height = box
    needs = {"image": 'src="a.png"', "movie": 'src="a.webm"', "input": 'tag="x"'}
    needs["list"] = 'items="x"'
    given_ = f'x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" {needs.get(kind, "")}'
    words = more if more.startswith(("fill", "")) and "=" in more else ""
    text = "Hello" if kind == "text" and "empty" not in more else ""
    return f'<{kind} id="{name}" {given_} {words.replace("empty", "")}>{text}</{kind}>'


PANEL = 'fill="#fff" empty'
INSIDE = (10.0, 10.0, 30.0, 20.0)
ACROSS = (35.0, 25.0, 30.0, 20.0)
BESIDE = (40.0, 10.0, 30.0, 20.0)
OVER = (5.0, 5.0, 60.0, 60.0)

# -- off the screen ------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["text", "button", "input", "list"])
@pytest.mark.parametrize(
    ("box", "is_off"),
    [
        ((0, 0, 100, 100), False),
        ((0, 0, 100.4, 100), False),
        ((0, 0, 101, 100), True),
        ((0, 0, 100, 101), True),
        ((-1, 0, 10, 10), True),
        ((0, -1, 10, 10), True),
        ((95, 10, 10, 10), True),
    ],
)
def test_what_is_read_or_touched_lies_on_the_screen_whole(
    kind: str, box: tuple[float, float, float, float], is_off: bool
) -> None:
    assert told(at(kind, "a", box)) == ([("off-screen", "a")] if is_off else [])


@pytest.mark.parametrize(("kind", "more"), [("image", ""), ("movie", ""), ("text", PANEL)])
@pytest.mark.parametrize(
    ("box", "is_off"),
    [
        ((-10, -10, 120, 120), False),
        ((90, 90, 50, 50), False),
        ((100, 10, 20, 20), True),
        ((-20, 10, 20, 20), True),
        ((10, 100, 20, 20), True),
        ((10, -30, 20, 20), True),
    ],
)
def test_a_picture_or_a_panel_may_run_over_the_edge_not_lie_beyond_it(
    kind: str, more: str, box: tuple[float, float, float, float], is_off: bool
) -> None:
    assert told(at(kind, "a", box, more)) == ([("off-screen", "a")] if is_off else [])


def test_what_nobody_sees_is_nowhere() -> None:
    assert told(at("text", "a", (200, 10, 20, 20), 'color="#000" empty')) == []


@pytest.mark.parametrize(
    "box", [(60.0, -4.0, 60.0, 20.0), (0.0, 20.0, 150.0, 20.0), (-3.5, 99.0, 10.0, 10.0)]
)
def test_a_click_moves_it_in(box: tuple[float, float, float, float]) -> None:
    source = shown(at("text", "a", box))
    (one,) = found(source)
    ((words, document),) = mend.mends(source, one)
    assert words == "Move “a” in"
    assert one.mend is not None
    assert not one.mend.safe
    assert found(mend.put(source, FILE, document)) == []


# -- in each other's way -------------------------------------------------------------------


@pytest.mark.parametrize("upper", ["text", "button", "image", "movie", "input", "list"])
@pytest.mark.parametrize("lower", ["button", "input", "list"])
def test_nothing_lies_over_what_can_be_touched(lower: str, upper: str) -> None:
    one = at(lower, "a", INSIDE)
    assert told(one, at(upper, "b", ACROSS)) == [("covered-component", "a")]
    assert told(one, at(upper, "b", BESIDE)) == []


@pytest.mark.parametrize(
    ("upper", "more", "hides"),
    [
        ("text", "", True),
        ("text", PANEL, True),
        ("text", 'fill="transparent" empty', False),
        ("button", "", True),
        ("input", "", True),
        ("list", "", True),
        ("image", "", True),
        ("movie", "", True),
    ],
)
def test_a_text_can_be_read(upper: str, more: str, hides: bool) -> None:
    one = at("text", "a", INSIDE)
    assert told(one, at(upper, "b", ACROSS, more)) == (
        [("covered-component", "a")] if hides else []
    )
    assert told(one, at(upper, "b", BESIDE, more)) == []


@pytest.mark.parametrize(
    ("lower", "upper", "is_told"),
    [
        ("{a}", "{b}", False),
        ("Hello", "{b}", False),
        ("{a}", "Hello", False),
        ("Hello {a}", "{b}!", True),
        ("{}", "{{", True),
    ],
)
def test_texts_of_nothing_but_data_may_take_turns(lower: str, upper: str, is_told: bool) -> None:
    shape = 'x="10" y="10" width="30" height="20"'
    one = f'<text id="a" {shape}>{lower}</text>'
    assert told(one, f'<text id="b" {shape}>{upper}</text>') == (
        [("covered-component", "a")] if is_told else []
    )
    assert told(one, f'<text id="b" {shape} fill="#fff">{upper}</text>') != []


@pytest.mark.parametrize(("kind", "more"), [("image", ""), ("movie", ""), ("text", PANEL)])
def test_what_lies_behind_is_told_only_where_nothing_of_it_is_seen(kind: str, more: str) -> None:
    one = at(kind, "a", INSIDE, more)
    assert told(one, at("button", "b", ACROSS)) == []
    assert told(one, at("text", "b", OVER)) == []
    assert told(one, at("image", "b", OVER)) == [("covered-component", "a")]
    assert told(at(kind, "a", OVER, more), at("button", "b", INSIDE), at("text", "c", BESIDE)) == []


def test_what_shows_nothing_hides_nothing_and_is_not_hidden() -> None:
    nothing = at("text", "a", INSIDE, 'color="#000" empty')
    assert told(nothing, at("image", "b", OVER)) == []
    assert told(at("image", "b", INSIDE), at("text", "a", OVER, 'color="#000" empty')) == []


def test_half_a_percent_is_let_pass() -> None:
    one = at("button", "a", INSIDE)
    assert told(one, at("button", "b", (39.4, 10, 30, 20))) == [("covered-component", "a")]
    assert told(one, at("button", "b", (39.6, 10, 30, 20))) == []
    assert told(one, at("button", "b", (10, 29.4, 30, 20))) == [("covered-component", "a")]
    assert told(one, at("button", "b", (10, 29.6, 30, 20))) == []


def test_the_components_of_always_lie_above() -> None:
    text = f"<always>{screen(at('button', 'home', INSIDE))}</always>"
    one = f'<state no="1" final="true" {{}}>{screen(at("button", "a", ACROSS))}</state>'
    (problem,) = found(project(text + one.format("")))
    assert problem.place == ("state", "1", "screen", "a")
    assert "“home” lies over it" in problem.message
    assert "(part of every state, and above" in problem.message
    assert found(project(text + one.format('always="false"'))) == []


def test_the_always_of_an_outer_application_lies_above_that_of_a_part() -> None:
    holder = f"<always>{screen(at('button', 'home', INSIDE))}</always>"
    holder += '<state no="1"><flow src="p.rbd.xml"/></state>'
    part = f"<always>{screen(at('text', 'b', ACROSS))}</always><state no='1'/>"
    (problem,) = found(project(holder, p=part))
    assert problem.file.endswith(PART)
    assert problem.place == ("always", "screen", "b")
    assert f"part of every state of {FILE}" in problem.message


def test_a_kept_screen_lies_below_the_always_of_the_state_that_keeps_it() -> None:
    always = f"<always>{screen(at('button', 'home', INSIDE))}</always>"
    on = '<expectedevents><event name="e" next="{}"/></expectedevents>'
    one = f'<state no="1" always="false">{screen(at("button", "a", ACROSS))}{on.format(2)}</state>'
    two = f'<state no="2">{on.format(3)}</state>'
    (problem,) = found(project(always + one + two + '<state no="3"/>'))
    assert problem.place == ("state", "1", "screen", "a")
    clear = f'<state no="2" always="false"><screen/>{on.format(3)}</state>'
    assert found(project(always + one + clear + '<state no="3"/>')) == []


def test_what_an_event_of_the_part_takes_first_leads_out_of_no_part() -> None:
    always = f"<always>{screen(at('button', 'home', INSIDE))}</always>"
    on = '<expectedevents><event name="e" next="{}">{}</event></expectedevents>'
    flow = f'<state no="1" always="false"><flow src="p.rbd.xml"/>{on.format(2, "")}</state>'
    outer = f'{always}{flow}<state no="2"/>'
    when = '<when><data tag="x" is="1"/></when>'
    part = f'<state no="1">{screen(at("button", "a", ACROSS))}{{}}</state>'
    assert found(project(outer, p=part.format(on.format(1, "")))) == []
    for taken in (on.format(1, when), on.format("#back", "")):
        assert [p.place[-1] for p in found(project(outer, p=part.format(taken)))] == ["a"]


def test_a_copy_of_a_state_is_judged_for_itself() -> None:
    """An editor's copy holds the very same screen."""
    one = shown(at("text", "a", (90, 10, 30, 20))).applications[FILE].states[0]
    two = replace(one, no="2")
    copied = replace(project(""), applications={FILE: Application("a", None, None, (one, two))})
    assert [p.place[1] for p in found(copied)] == ["1", "2"]


def test_what_lies_over_one_is_told_once() -> None:
    boxes = [at("text", f"b{n}", ACROSS, 'color="#000" empty') for n in range(5)]
    (problem,) = found(shown(at("button", "a", INSIDE), *boxes))
    assert "“b0”, “b1” and “b2” and 2 more lie over it" in problem.message


@pytest.mark.parametrize(
    ("lower", "upper", "can"),
    [
        (at("button", "a", INSIDE), at("image", "b", OVER), True),
        (at("text", "a", INSIDE), at("text", "b", OVER, PANEL), True),
        (at("text", "a", INSIDE), at("text", "b", OVER), False),
        (at("button", "a", INSIDE), at("button", "b", OVER), False),
        (at("button", "a", OVER), at("image", "b", INSIDE), False),
    ],
)
def test_what_can_lie_behind_is_put_there_at_a_click(lower: str, upper: str, can: bool) -> None:
    source = shown(at("text", "t", (70, 80, 20, 10)), lower, upper)
    (one,) = found(source)
    if not can:
        assert one.mend is None
        return
    ((words, document),) = mend.mends(source, one)
    assert words == "Put “b” beneath “a”"
    assert found(mend.put(source, FILE, document)) == []


# -- beside the robot and plain models -----------------------------------------------------


class Maker:
    """Applications whose components lie on a coarse grid, so that all cases come up."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.count = 0

    def project(self) -> Project:
        with_part = self.random.random() < 0.5
        files = {FILE: self.application(with_part)}
        parts = {PART: self.application(False)} if with_part else {}
        return Project(root="nowhere", name="a", applications=files, parts=parts)

    def application(self, with_part: bool) -> Application:
        random = self.random
        flow = random.choice("123") if with_part else ""
        states = tuple(
            State(
                no,
                flow=PART if no == flow else None,
                always=random.random() < 0.6,
                screen=None if no == flow else random.choice([None, Screen(), *self.screens()]),
                events=tuple(Event(f"x{n}", random.choice("123")) for n in range(2)),
            )
            for no in "123"
        )
        above = Always(None, self.screens()[0]) if random.random() < 0.6 else None
        return Application("a", None, above, states)

    def screens(self) -> list[Screen]:
        return [
            Screen(None, None, tuple(self.component() for _ in range(self.random.choice([1, 2]))))
            for _ in range(2)
        ]

    def component(self) -> Component:
        random = self.random
        self.count += 1
        name = f"c{self.count}"
        x, y = random.choice([-60, -20, 0, 20, 60, 100]), random.choice([0, 20, 40, 90])
        width, height = random.choice([20, 40, 100]), random.choice([20, 60])
        shape: dict[str, Any] = {"id": name, "x": float(x), "y": float(y)}
        shape.update(width=float(width), height=float(height), fill=random.choice([None, "#fff"]))
        match random.randrange(7):
            case 0 | 1:
                return Text(**shape, text=random.choice(["", "a"]))
            case 2:
                return Button(**shape)
            case 3:
                return Image(**shape, src="a.png")
            case 4:
                return Movie(**shape, src="a.webm")
            case 5:
                return Input(**shape, tag="x")
            case _:
                return List(**shape, items="x")


def layers(source: Project) -> Iterator[list[str]]:
    """Every screen that the robot shows, in all states that can be reached: ids, upper later."""
    robot = Robot(source)
    known: set[tuple[str, tuple[str, ...]]] = set()
    events, _ = robot.step(inputs.Start(), 0)
    waiting = [(robot.snapshot(), events, ())]
    while waiting:
        snapshot, events, shows = waiting.pop()
        for one in events:
            if isinstance(one, trace.Screen):
                shows = tuple(component["id"] for component in one.components)
        robot.restore(snapshot)
        key = (str(robot.board.look("application/a")), shows)
        if key in known:
            continue
        known.add(key)
        yield list(shows)
        for name in ("x0", "x1"):
            robot.restore(snapshot)
            events, _ = robot.step(inputs.Raise(name), 0)
            waiting.append((robot.snapshot(), events, shows))


def is_wanted(lower: Component, upper: Component) -> bool:
    """The rule in its plainest form, on a grid on which hairs do not matter."""
    touched = (Button, Input, List)
    left, right = max(lower.x, upper.x), min(lower.x + lower.width, upper.x + upper.width)
    top, bottom = max(lower.y, upper.y), min(lower.y + lower.height, upper.y + upper.height)
    if right <= left or bottom <= top:
        return False
    words = [isinstance(one, Text) and one.text != "" for one in (lower, upper)]
    seen = [not isinstance(one, Text) or one.fill is not None for one in (lower, upper)]
    if isinstance(lower, touched):
        return True
    if words[0]:
        return words[1] or seen[1]
    whole = (right - left, bottom - top) == (lower.width, lower.height)
    return whole and seen[0] and seen[1]


@given(seed=st.integers(0, 2**64))
@settings(max_examples=60, deadline=None)
def test_what_is_covered_is_told_exactly_where_the_robot_shows_it_so(seed: int) -> None:
    source = Maker(seed).project()
    components = {
        one.id: one
        for file in (*source.applications.values(), *source.parts.values())
        for holder in (file.always, *file.states)
        if holder is not None and holder.screen is not None
        for one in holder.screen.components
    }
    wanted, reached = set(), set()
    for shows in layers(source):
        boxes = [components[name] for name in shows]
        reached.update(shows)
        for number, lower in enumerate(boxes):
            if any(is_wanted(lower, upper) for upper in boxes[number + 1 :]):
                wanted.add(lower.id)
    covered = {p.place[-1] for p in found(source) if p.code == "covered-component"}
    assert wanted <= covered
    if len(reached) == len(components):
        assert covered <= wanted


@given(seed=st.integers(0, 2**64))
@settings(max_examples=40, deadline=None)
def test_what_lies_outside_is_told_exactly_by_the_points_that_lie_inside(seed: int) -> None:
    maker = Maker(seed)
    one = maker.component()
    state = State("1", screen=Screen(None, None, (one,)), final=True)
    source = Project(
        root="nowhere", name="a", applications={FILE: Application("a", None, None, (state,))}
    )
    spots = [
        0 < one.x + dx < 100 and 0 < one.y + dy < 100
        for dx in range(5, int(one.width), 10)
        for dy in range(5, int(one.height), 10)
    ]
    must_be_whole = isinstance(one, (Button, Input, List)) or (
        isinstance(one, Text) and one.text != ""
    )
    shows = not isinstance(one, Text) or one.fill is not None
    is_off = not all(spots) if must_be_whole else shows and not any(spots)
    assert [p.code for p in found(source)] == (["off-screen"] if is_off else [])
