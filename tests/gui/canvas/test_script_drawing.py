"""The drawing of a script and what gestures make of it, without a window: laws and values."""

from __future__ import annotations

import json
from itertools import combinations, pairwise
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import codec
from situ.document.beside import Toml
from situ.document.check import check
from situ.document.condition import Condition, Group
from situ.document.condition import Test as Question
from situ.document.modules import Module, Modules
from situ.document.project import Project
from situ.document.rbd import Application, Speech, State
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio.canvas import script_conditions as conditions
from situ_studio.canvas.script_layout import Pills, spread
from situ_studio.canvas.script_projection import picture
from situ_studio.canvas.script_rows import tests as every_test
from situ_studio.edits import new_script, places, words
from situ_studio.edits.notes import annotate, note_of
from situ_studio.panels.test_box import listed, several

TAGS = ("a", "b.c", "d")
TESTS = st.builds(Question, st.sampled_from(TAGS), st.just("is"), st.just("true"))
CHILDREN = st.recursive(
    TESTS,
    lambda inner: st.builds(
        Group,
        st.sampled_from(["all", "any", "none"]),
        st.lists(inner, min_size=1, max_size=3).map(tuple),
    ),
    max_leaves=5,
)
CONDITIONS = st.none() | st.builds(Condition, st.lists(CHILDREN, min_size=1, max_size=3).map(tuple))


@st.composite
def scripts(draw: st.DrawFn) -> Spds:
    """Any script that formats.md allows, but for what its names are."""
    count = draw(st.integers(1, 6))
    modules = [f"m{i}" for i in range(draw(st.integers(0, 5)))]
    resources = st.lists(st.sampled_from(["head", "base", "arm"]), max_size=3, unique=True)
    situations = []
    for index in range(count):
        last = index == count - 1
        entries = draw(st.lists(st.sampled_from(modules or ["other"]), max_size=3, unique=True))
        situations.append(
            Situation(
                f"s{index}",
                extends=None if last or draw(st.booleans()) else f"s{count - 1}",
                limit=None if last else draw(st.sampled_from([None, 9.0])),
                condition=None if last else draw(CONDITIONS),
                until=None if last else draw(CONDITIONS),
                entries=tuple(Entry(m, draw(st.sampled_from([None, 5]))) for m in entries),
            )
        )
    observed = tuple(Observed(tag) for tag in TAGS if draw(st.booleans()))
    declared = tuple(Declaration(m, tuple(draw(resources))) for m in modules)
    return Spds("any", observed, declared, tuple(situations))


@settings(max_examples=20, deadline=None)
@given(scripts())
def test_no_two_nodes_lie_on_each_other_and_each_pipe_has_its_ends(script: Spds) -> None:
    drawn = picture(script)
    cards = list(drawn.cards.values())
    for one, other in combinations(cards, 2):
        beside = one.x + one.width <= other.x or other.x + other.width <= one.x
        assert beside or one.y + one.height <= other.y or other.y + other.height <= one.y
    for link in drawn.links.values():
        assert link.exit in drawn.cards[link.source].outputs
        assert link.entry in drawn.cards[link.target].inputs
        if link.kind in ("observes", "priority"):
            assert places.get(script, link.place) is not None
    for card in cards:
        for name in (*card.inputs, *card.outputs):
            x, y = card.port(name)
            assert x in (0, card.width)
            assert 0 < y < card.height
    situations = [c for c in cards if c.kind == "situation"]
    assert [c.name for c in sorted(situations, key=lambda c: c.y)] == [
        s.name for s in script.situations
    ]


@settings(max_examples=20, deadline=None)
@given(scripts())
def test_every_test_of_a_script_has_a_line_and_a_pipe(script: Spds) -> None:
    drawn = picture(script)
    for situation in script.situations:
        for word in ("condition", "until"):
            found = every_test(getattr(situation, word))
            card = drawn.cards.get(f"{word} {situation.name}")
            lines = [row for row in card.rows if not row.group] if card is not None else []
            assert [row.tail for row in lines] == [tail for _, tail in found]
            ends = [
                link.entry
                for link in drawn.links.values()
                if link.target == f"{word} {situation.name}"
            ]
            assert sorted(ends) == sorted("/".join(tail) for _, tail in found)


@settings(max_examples=20, deadline=None)
@given(st.lists(st.floats(0, 900, allow_nan=False), max_size=12), st.booleans())
def test_what_is_spread_keeps_its_order_and_its_distance(tops: list[float], in_rows: bool) -> None:
    wanted = [(str(i), top) for i, top in enumerate(tops)]
    placed = spread(wanted, 60, in_rows)
    order = sorted(range(len(tops)), key=lambda i: (tops[i], i))
    spots = [placed[str(i)] for i in order]
    assert all(later - earlier >= 60 for earlier, later in pairwise(spots))


def test_one_alone_stands_where_it_is_wanted() -> None:
    assert spread([("a", 300.0), ("b", 500.0)], 60) == {"a": 300, "b": 500}
    assert spread([("a", 300.0), ("b", 300.0)], 60) == {"a": 268, "b": 328}


# -- conditions ---------------------------------------------------------------------------------


@settings(max_examples=20, deadline=None)
@given(scripts(), st.data())
def test_a_group_taken_away_gives_back_what_was_grouped(script: Spds, data: st.DataObject) -> None:
    every = [s for s in script.situations if s.condition is not None]
    if not every:
        return
    situation = data.draw(st.sampled_from(every))
    assert situation.condition is not None
    place = ("situation", situation.name, "condition")
    index = data.draw(st.integers(0, len(situation.condition.children) - 1))
    one = (*place, str(index))
    wrapped, text = conditions.wrap(
        script, [one], data.draw(st.sampled_from(["all", "any", "none"]))
    )
    assert text
    assert conditions.unwrap(wrapped, one)[0] == script


@settings(max_examples=20, deadline=None)
@given(scripts(), st.data())
def test_a_test_that_is_pulled_elsewhere_is_neither_lost_nor_doubled(
    script: Spds, data: st.DataObject
) -> None:
    """And leaves no group empty."""
    named = [
        ("situation", s.name, word, *tail)
        for s in script.situations
        for word in ("condition", "until")
        for _, tail in every_test(getattr(s, word))
    ]
    if not named:
        return
    test, goal = data.draw(st.sampled_from(named)), data.draw(st.sampled_from(script.situations))
    value = places.get(script, test)
    after, _ = conditions.move_test(script, test, ("situation", goal.name))

    def count(one: Spds) -> int:
        return sum(
            found == value
            for s in one.situations
            for condition in (s.condition, s.until)
            for found, _ in every_test(condition)
        )

    assert count(after) == count(script)
    assert not any(_has_empty(c) for s in after.situations for c in (s.condition, s.until))


def _has_empty(value: Any) -> bool:
    if value is None or isinstance(value, Question):
        return False
    return not value.children or any(map(_has_empty, value.children))


@settings(max_examples=50, deadline=None)
@given(st.text("ab-–<>&! \n", max_size=12))
def test_a_note_is_a_comment_that_is_read_again(text: str) -> None:
    """Whatever is typed: nothing in it ends the comment. Empty, it is taken away."""
    script = Spds("w", situations=(Situation("only"),))
    for place in ((), ("situation", "only")):
        after, _ = annotate(script, place, text)
        found, problems = codec.read(codec.write(after), "w.spds.xml")
        assert problems == []
        assert isinstance(found, Spds)
        note = note_of(places.get(found, place) if place else found)
        assert note == note_of(places.get(after, place) if place else after)
        assert bool(note) == bool(text.replace("--", "–").strip(" \n-"))
        gone, _ = annotate(after, place, "")
        assert codec.write(gone) == codec.write(script)


JSON = st.lists(
    st.text("abc ,[]\"'1tn{", max_size=5) | st.integers(-9, 9) | st.booleans() | st.none(),
    max_size=4,
)


@settings(max_examples=50, deadline=None)
@given(JSON)
def test_what_is_one_of_several_is_typed_as_it_is_shown(values: list[Any]) -> None:
    array = json.dumps(values, ensure_ascii=False)
    assert json.loads(several(listed(array))) == values


@pytest.mark.parametrize(
    ("typed", "array"),
    [
        ("arrived, failed", '["arrived", "failed"]'),
        ("1, 2.5, true", "[1, 2.5, true]"),
        ('"1", two', '["1", "two"]'),
        ('["a, b"]', '["a, b"]'),
        ("", "[]"),
    ],
)
def test_words_divided_by_commas_become_an_array(typed: str, array: str) -> None:
    assert several(typed) == array


def test_a_priority_that_is_selected_says_whose_it_is_and_where() -> None:
    """In the heading of its form."""
    script = Spds("ward", situations=(Situation("called", entries=(Entry("nod", 5),)),))
    _, _, name, what = words.title(script, ("situation", "called", "entry", "0"))
    assert (name, what) == ("nod in called", "Priority")


def test_pills_stand_on_none_of_the_others() -> None:
    from PySide6.QtCore import QRectF

    pills = Pills()
    area = QRectF(60, 60, 30, 18)
    pills.put("one", area)
    assert not pills.is_free(area.translated(20, 10))
    assert pills.is_free(area.translated(40, 0))
    pills.put("one", area.translated(200, 0))
    assert pills.is_free(area)
    pills.remove("one")
    assert pills.is_free(area.translated(200, 0))


# -- a script for a project that has none ---------------------------------------------------------


def project(**more: Any) -> Project:
    one = Application("talk", states=(State("1", final=True, actions=(Speech(text="Hi"),)),))
    return Project(
        root="/nowhere", name="Ward 3", toml="situ.toml", applications={"talk.rbd.xml": one}, **more
    )


def test_a_new_script_changes_nothing_that_happens() -> None:
    """Each application is a module with what it uses, and keeps the priority that it had."""
    given = project()
    changed = new_script.begun(given, Toml('[project]\nname = "Ward 3"\n'), frozenset())
    assert list(changed) == ["ward-3.spds.xml", "situ.toml"]
    script = changed["ward-3.spds.xml"]
    assert script == Spds(
        "Ward 3",
        modules=(Declaration("talk", ("speech",)),),
        situations=(Situation("otherwise", entries=(Entry("talk", 1),)),),
    )
    after = replace(given, spds=script, spds_file="ward-3.spds.xml")
    assert [p for p in check(after) if p.severity == "error"] == []


def test_a_module_that_the_information_declares_is_not_declared_again() -> None:
    known = Modules((Module("talk", ("speech",)),))
    changed = new_script.begun(project(modules=known), Toml("[project]\n"), frozenset())
    script = changed["ward-3.spds.xml"]
    assert isinstance(script, Spds)
    assert script.modules == ()


def test_its_file_is_none_that_is_there() -> None:
    changed = new_script.begun(project(), Toml("[project]\n"), frozenset({"ward-3.spds.xml"}))
    assert next(iter(changed)) == "ward-3-2.spds.xml"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            '[project]\nname = "x"\nmedia = "m"\n\n[tags]\n',
            '[project]\nname = "x"\nmedia = "m"\nspds = "ward-3.spds.xml"\n\n[tags]\n',
        ),
        (
            '# all\n[ project ] # it\nmedia = "m"',
            '# all\n[ project ] # it\nmedia = "m"\nspds = "ward-3.spds.xml"\n',
        ),
        ("[project]", '[project]\nspds = "ward-3.spds.xml"\n'),
        ('project = {name = "x"}\n', 'project = {name = "x",spds = "ward-3.spds.xml"}\n'),
        ("[tags]\nx = 1\n", '[tags]\nx = 1\n\n[project]\nspds = "ward-3.spds.xml"\n'),
    ],
)
def test_the_project_names_it_and_all_else_stays(before: str, after: str) -> None:
    changed = new_script.begun(project(), Toml(before), frozenset())
    assert changed["situ.toml"] == Toml(after)
