"""Whether conditions can hold, beside trying the values one by one.

The judge of the trials is the runtime's own ``compile_test``; the past that ``within`` and
``for`` look at is tried as short histories of sets.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from functools import partial
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.decide.board import reach
from situ.decide.values import compile_test
from situ.document import codec
from situ.document.condition import TESTS, Condition, Group, GroupName
from situ.document.condition import Test as Single
from situ.document.satisfy import Moment, every_test
from situ.document.spds import Spds
from situ.document.value_sets import ANY, Domain

LENGTHS = (1.0, 2.0)
AGES = (0.25, 0.75, 1.25, 1.75, 2.25)
STARTS = (0.5, 1.5, 2.5)


def condition(text: str) -> Condition:
    """The condition of ``<condition>`` with this content; references allowed."""
    source = f'<spds name="a"><situation name="s"><condition>{text}</condition></situation></spds>'
    document, _ = codec.read(source.encode(), "a.spds.xml")
    assert isinstance(document, Spds)
    found = document.situations[0].condition
    assert found is not None
    return found


def possible(*texts: str) -> bool | None:
    conditions = [condition(text) for text in texts]
    moment = Moment(conditions)
    return moment.possible(*(moment.node(one) for one in conditions))


def always(text: str) -> bool:
    one = condition(text)
    moment = Moment([one])
    return moment.possible(moment.opposite(moment.node(one))) is False


def holds(node: Condition | Group | Single, judge: Any) -> bool:
    if isinstance(node, Single):
        return bool(judge(node))
    found = [holds(child, judge) for child in node.children]
    kind = "all" if isinstance(node, Condition) else node.kind
    return all(found) if kind == "all" else any(found) is (kind == "any")


# -- by hand -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        '<data tag="a" above="3"/><data tag="a" below="3"/>',
        '<data tag="a" above="3"/><data tag="a" is="b"/>',
        '<data tag="a" is="true"/><data tag="a" is="1"/>',
        '<data tag="a" exists="false"/><data tag="a" atleast="0"/>',
        '<data tag="a" in="[]"/>',
        '<data tag="a" below="b"/><data tag="a" above="b"/>',
        '<data tag="a" in="[1, 2]"/><data tag="a" above="2"/>',
        '<data tag="a" isnot="1"/><data tag="a" in="[1]"/>',
        '<data tag="a" is="1"/><data tag="a" above="1"/>',
        '<data tag="a" exists="true"/><none><data tag="a" exists="true"/></none>',
        '<any><data tag="a" is="1"/><data tag="a" is="2"/></any><data tag="a" is="3"/>',
        # nothing lies between
        '<data tag="a" above="!"/><data tag="a" below="!"/>',
        '<data tag="a" above="9007199254740993"/><data tag="a" below="9007199254740994"/>',
        # what reaches into a value
        '<data tag="a" exists="false"/><data tag="a.0" exists="true"/>',
        '<data tag="a" is="[5]"/><data tag="a.0" is="6"/>',
        """<data tag="a" in='[{"b": 1}]'/><data tag="a.b" exists="false"/>""",
        '<data tag="a" is="text"/><data tag="a.0.b" exists="true"/>',
        # within and for
        '<data tag="a" is="1" within="2"/><none><data tag="a" is="1" within="3"/></none>',
        '<data tag="a" is="1" for="3"/><none><data tag="a" is="1" for="2"/></none>',
        '<data tag="a" above="5" for="3"/><none><data tag="a" above="4" for="2"/></none>',
        '<data tag="a" is="1" for="3"/><data tag="a" is="2"/>',
        '<data tag="a" is="1" for="3"/><data tag="a" is="2" for="1"/>',
        (
            '<data tag="a" is="1"/><none><data tag="a" is="1" for="1"/></none>'
            '<none><data tag="a" exists="true" within="1"/></none>'
        ),
        # two names
        '<data tag="a" above="{b}"/><data tag="a" below="{b}"/>',
        '<data tag="a" above="{b}"/><data tag="b" atleast="{a}"/>',
        '<data tag="a" is="{b}"/><data tag="a" is="1"/><data tag="b" is="2"/>',
        '<data tag="a" above="{b}"/><data tag="a" below="1"/><data tag="b" above="2"/>',
        '<data tag="a" is="{b}"/><data tag="b" exists="false"/>',
        '<data tag="a" in="{b}"/><data tag="a" is="1"/><data tag="b" is="[2, 3]"/>',
        '<data tag="a" isnot="{a}"/><data tag="a" exists="true"/>',
        '<data tag="a" in="{b}"/><data tag="b" in="{a}"/>',
        '<data tag="a" in="{b}"/><data tag="a" is="{b}"/>',
        '<data tag="a" is="[[5]]"/><data tag="a.0" is="[6]"/>',
        """<data tag="a" in="{b}"/><data tag="b" in='[{"x": 1}]'/>""",
    ],
)
def test_what_can_not_hold_is_known(text: str) -> None:
    assert possible(text) is False


@pytest.mark.parametrize(
    "text",
    [
        '<data tag="a" above="3"/><data tag="a" below="4"/>',
        '<data tag="a" above="9007199254740992"/><data tag="a" below="9007199254740994"/>',
        '<data tag="a" is="5"/><data tag="a" isnot="{b}"/>',
        '<data tag="a" exists="false"/><data tag="a.b" exists="true"/>',
        '<data tag="a" exists="false"/><data tag="a.b.c" exists="true"/>',
        '<data tag="a" exists="true"/><data tag="a.B" is="5"/>',
        '<data tag="a" is="[[5]]"/><data tag="a.0" exists="true"/>',
        '<data tag="a" in="{b}"/><data tag="a" in="{b}" within="3"/>',
        '<data tag="a" exists="true"/><data tag="a.0" exists="false"/>',
        '<data tag="a" is="1"/><none><data tag="a" is="1" within="3"/></none>',
        '<data tag="a" is="1" for="3"/><data tag="a" is="1" within="1"/>',
        '<data tag="a" is="1"/><none><data tag="a" is="1" for="3"/></none>',
        (
            '<data tag="a" exists="false"/><none><data tag="a" exists="false" for="1"/></none>'
            '<none><data tag="a" exists="false" within="1"/></none>'
        ),
        '<data tag="a" is="{b}"/><data tag="a" above="1"/><data tag="b" below="2"/>',
        '<data tag="a" in="{b}"/><data tag="a" is="3"/><data tag="b" is="[2, 3]"/>',
        '<data tag="a" is="{b}"/><data tag="b" is="{c}"/>',
        '<data tag="clock.time" atleast="08:00"/><data tag="clock.time" below="09:00"/>',
    ],
)
def test_what_can_hold_is_known(text: str) -> None:
    assert possible(text) is True


@pytest.mark.parametrize(
    "text",
    [
        '<any><data tag="a" exists="true"/><data tag="a" exists="false"/></any>',
        '<any><data tag="a" is="1"/><data tag="a" isnot="1"/></any>',
        '<any><data tag="a" is="1" for="2"/><none><data tag="a" is="1" for="2"/></none></any>',
        """<any><data tag="a" isnot="1"/><data tag="a" in='[1, "1"]'/></any>""",
        (
            '<any><data tag="a" isnot="{b}"/><data tag="b" atleast="{a}"/>'
            '<data tag="a" exists="true"/></any>'
        ),
    ],
)
def test_what_always_holds_is_known(text: str) -> None:
    assert always(text)


def test_what_was_not_searched_to_its_end_is_not_guessed() -> None:
    clauses = "".join(
        f'<any><data tag="a{i}" is="1"/><data tag="a{i + 1}" is="1"/></any>'
        f'<any><data tag="a{i}" isnot="1"/><data tag="a{i + 3}" isnot="1"/></any>'
        for i in range(30)
    )
    one = condition(clauses)
    moment = Moment([one])
    assert moment.possible(moment.node(one), budget=50) is None
    assert moment.possible(moment.node(one)) is True


@pytest.mark.parametrize(
    ("text", "can"),
    [
        ('<data tag="a" above="{b}"/><data tag="a" below="{b}"/>', False),
        ('<data tag="a" in="{b}"/><data tag="a" is="1"/><data tag="b" is="[2, 3]"/>', False),
        ('<data tag="a" atleast="{b}"/><data tag="a" isnot="{b}"/>', True),
    ],
)
def test_however_little_time_is_given_nothing_is_guessed(text: str, can: bool) -> None:
    one = condition(text)
    found = []
    for budget in range(1, 200):
        moment = Moment([one])
        found.append(moment.possible(moment.node(one), budget=budget))
    assert set(found) <= {None, can}
    assert found[-1] is can


def test_three_names_compared_in_a_circle_are_not_guessed() -> None:
    circle = '<data tag="a" above="{b}"/><data tag="b" above="{c}"/><data tag="c" above="{a}"/>'
    assert possible(circle) is None
    assert possible(circle, '<data tag="a" is="text"/><data tag="b" is="1"/>') is False


def test_a_list_or_an_object_that_no_test_names_is_one_of_the_others() -> None:
    values = Moment([condition('<data tag="a" is="[1]"/>')]).variables.values["a"]
    assert values.cell([2]) == values.other_list
    assert values.cell({"x": 1}) == values.other_object
    assert values.cell([1]) not in (values.other_list, values.other_object)


def _known(domains: dict[str, Domain], name: str) -> Domain:
    return domains.get(name, ANY)


def test_what_is_known_of_a_name_beforehand_counts() -> None:
    one = condition('<data tag="a" isnot="true"/><data tag="a" isnot="false"/>')
    both = condition('<data tag="a" exists="true"/>')
    moment = Moment([one, both], lambda name: Domain(frozenset(("boolean",))))
    assert moment.possible(moment.node(one)) is True
    assert moment.possible(moment.node(one), moment.node(both)) is False
    one = condition('<data tag="a" exists="true"/><data tag="a.B" is="5"/>')
    for kind, can in (("object", True), ("list", False), ("text", False)):
        domains = {"a": Domain(frozenset((kind,)))}
        moment = Moment([one], partial(_known, domains))
        assert moment.possible(moment.node(one)) is can
    several = condition("""<data tag="a" in='[[1], {"x": 2}, "b"]'/>""")
    for kind, can in (("list", True), ("object", True), ("text", True), ("number", False)):
        domains = {"a": Domain(frozenset((kind,)))}
        moment = Moment([several], domains.__getitem__)
        assert moment.possible(moment.node(several)) is can
    word = condition('<data tag="a" is="c"/>')
    moment = Moment([word], lambda name: Domain(frozenset(("text",)), ("a", "b")))
    assert moment.possible(moment.node(word)) is False


# -- beside trying ---------------------------------------------------------------------------

POOL = ["1", "2", "1.0", "b", "true", "[1]", '{"x": 2}', '"b"', "[1, 2]", ""]
PLAIN = [
    *(None, True, False, 0, 1, 1.5, 2, 3, "", "\0", "1", "10", "1.0", "11", "2", "20"),
    *(
        "a",
        "b",
        "bb",
        '"b"',
        '"bb"',
        "true",
        "truer",
        "~",
        "[1]",
        "[1]]",
        "[1, 2]",
        "[1, 3]",
        '{"x": 2}',
        "}",
    ),
]
LISTS = [[], [1], [2], [1, 2], [None, 1], ["b"], [True], [{"x": 2}], [[1]], {}, {"x": 2}, {"y": 1}]
VALUES = [
    *PLAIN,
    *LISTS,
    *([one] for one in (*PLAIN, *LISTS)),
    *({"x": one} for one in (*PLAIN, *LISTS)),
    *([one, 9] for one in (1, "b")),
    *({"x": one, "y": 9} for one in (1, 2, "b")),
]
COMPARED = [
    *PLAIN,
    -1,
    1.6,
    4,
    "bc",
    "~~",
    *LISTS,
    [1, 1],
    ["~", 2],
    {"y": 2},
    *([one] for one in PLAIN),
]


KINDS: tuple[GroupName, ...] = ("all", "any", "none")


class Maker:
    def __init__(self, seed: int, names: list[str], times: bool, refer: bool) -> None:
        self.random = Random(seed)
        self.names = names
        self.times = times
        self.refer = refer

    def condition(self) -> Condition:
        children = tuple(self.part(0) for _ in range(self.random.choice([1, 2, 2, 3])))
        return Condition(children)

    def part(self, depth: int) -> Group | Single:
        random = self.random
        if depth < 2 and random.random() < 0.4:
            kind = random.choice(KINDS)
            count = random.choice([1, 2, 2, 3])
            return Group(kind, tuple(self.part(depth + 1) for _ in range(count)))
        test = random.choice(TESTS)
        value = random.choice(POOL)
        if test == "exists":
            value = random.choice(["true", "false"])
        elif self.refer and random.random() < 0.5:
            value = f"{{{random.choice(self.names)}}}"
        elif test == "in":
            value = random.choice(["[]", "[1]", '["b", true]', "[[1], 2]", '[{"x": 2}, null]'])
        within = random.choice([None, *LENGTHS]) if self.times else None
        hold = random.choice([None, *LENGTHS]) if self.times else None
        return Single(random.choice(self.names), test, value, within, hold)


def boards(names: list[str]) -> Iterator[dict[str, Any]]:
    """Every way in which the tags among ``names`` can be set."""
    tags = sorted({name.partition(".")[0] for name in names} | {n for n in names if "0" not in n})
    for values in itertools.product(VALUES, repeat=len(tags)):
        yield dict(zip(tags, values, strict=True))


def look_in(board: dict[str, Any], name: str) -> Any:
    words = name.split(".")
    for count in range(len(words), 0, -1):
        found = board.get(".".join(words[:count]))
        if found is not None:
            return reach(found, ".".join(words[count:]))
    return None


@given(seed=st.integers(0, 2**64), names=st.sampled_from([["a"], ["a", "a.x"], ["a", "a.0"]]))
@settings(max_examples=60, deadline=None)
def test_conditions_hold_exactly_where_some_values_make_them(seed: int, names: list[str]) -> None:
    one = Maker(seed, names, times=False, refer=False).condition()
    moment = Moment([one])
    compiled = {id(t): compile_test(t.test, t.value)[0] for t in every_test(one)}
    met = {True: False, False: False}
    for board in boards(names):
        found = holds(one, lambda t, b=board: compiled[id(t)](look_in(b, t.tag), b.get))
        met[found] = True
    node = moment.node(one)
    assert moment.possible(node) is met[True]
    assert moment.possible(moment.opposite(node)) is met[False]


@given(seed=st.integers(0, 2**64))
@settings(max_examples=100, deadline=None)
def test_names_compared_with_each_other_are_decided_exactly(seed: int) -> None:
    one = Maker(seed, ["a", "b"], times=False, refer=True).condition()
    moment = Moment([one])
    compiled = {id(t): compile_test(t.test, t.value)[0] for t in every_test(one)}
    met = {True: False, False: False}
    for a, b in itertools.product(COMPARED, repeat=2):
        look = {"a": a, "b": b}.get
        met[holds(one, lambda t, look=look: compiled[id(t)](look(t.tag), look))] = True
    node = moment.node(one)
    assert moment.possible(node) is met[True]
    assert moment.possible(moment.opposite(node)) is met[False]


def test_a_value_is_no_member_of_itself() -> None:
    member, same = Single("a", "in", "{b}"), Single("a", "is", "{b}")
    moment = Moment([Condition((member, same)), Condition((member,))])
    assert moment.possible(moment.part(member), moment.part(same)) is False
    assert moment.possible(moment.part(member), moment.opposite(moment.part(same))) is True


def histories(pool: list[Any]) -> Iterator[tuple[float, list[tuple[float, Any]]]]:
    """(age of the start, sets as (age, value) from the oldest); at first it is missing."""
    for start in STARTS:
        ages = [age for age in AGES if age < start]
        for count in range(4):
            for when in itertools.combinations(sorted(ages, reverse=True), count):
                for values in itertools.product(pool, repeat=count):
                    yield start, list(zip(when, values, strict=True))


def judged(test: Single, start: float, sets: list[tuple[float, Any]]) -> bool:
    """A test at the end of a history, by the words of formats.md."""
    passes, _ = compile_test(test.test, test.value)
    begins = [(start, None), *sets]
    if test.within is not None and not (sets and sets[-1][0] < test.within):
        return False
    since = None
    for age, value in begins:
        if not passes(value, lambda name: None):
            since = None
        elif since is None:
            since = age
    return since is not None and (test.hold is None or since >= test.hold)


@given(seed=st.integers(0, 2**64))
@settings(max_examples=80, deadline=None)
def test_within_and_for_are_decided_exactly(seed: int) -> None:
    maker = Maker(seed, ["a"], times=True, refer=False)
    one = maker.condition()
    moment = Moment([one])
    found = list(every_test(one))
    # One value for each way in which the tests take values.
    ways: dict[tuple[bool, ...], Any] = {}
    for value in VALUES:
        way = tuple(compile_test(t.test, t.value)[0](value, lambda name: None) for t in found)
        ways.setdefault(way, value)
    pool = list(ways.values())[:5]
    if len(ways) > 5:
        return
    met = {True: False, False: False}
    for start, sets in histories(pool):
        met[holds(one, lambda t, s=start, h=sets: judged(t, s, h))] = True
    node = moment.node(one)
    assert moment.possible(node) is met[True]
    assert moment.possible(moment.opposite(node)) is met[False]
