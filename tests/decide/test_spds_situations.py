"""formats.md, *SPDS*: which situation is current."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from situ.decide import trace
from situ.decide.inputs import Set, Start
from situ.decide.robot import Robot
from situ.document.condition import Condition
from situ.document.condition import Test as Leaf
from situ.document.project import Project
from situ.document.spds import Situation, Spds

if TYPE_CHECKING:
    from tests.decide.conftest import Play

END: dict[str, Any] = {"at": 100, "end": True}


def situation(name: str, condition: str = "", until: str = "", **more: str) -> str:
    attributes = "".join(f' {key}="{value}"' for key, value in more.items())
    inside = f"<condition>{condition}</condition>" if condition else ""
    inside += f"<until>{until}</until>" if until else ""
    return f'<situation name="{name}"{attributes}>{inside}</situation>'


def true(tag: str, more: str = "") -> str:
    return f'<data tag="{tag}" is="true" {more}/>'


def sets(**at: list[tuple[float, bool]]) -> list[dict[str, Any]]:
    """Lines that set tags: ``sets(x=[(1, True), (2, False)])``."""
    lines: list[dict[str, Any]] = [
        {"at": t, "set": {tag: value}} for tag, every in at.items() for t, value in every
    ]
    return [*sorted(lines, key=lambda line: line["at"]), END]


ON, OFF = True, False
REST = situation("rest")


# -- which is current --------------------------------------------------------


def test_the_first_in_document_order_that_holds_is_current(play: Play) -> None:
    spds = situation("a", true("x")) + situation("b", true("y")) + REST
    lines = sets(x=[(2, ON), (3, OFF)], y=[(1, ON), (4, OFF)])
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (1, "b"), (2, "a"), (3, "b"), (4, "rest"),
    ]  # fmt: skip


def test_while_none_holds_there_is_none() -> None:
    """A script that ``check`` refuses: its last situation has a condition."""
    spds = Spds("s", (), (), (Situation("a", condition=Condition((Leaf("x", "is", "1"),))),))
    robot = Robot(Project(root=".", name="p", spds=spds))
    events = [
        *robot.step(Start(), 0)[0],
        *robot.step(Set({"x": 1}, "m"), 1)[0],
        *robot.step(Set({"x": 2}, "m"), 2)[0],
    ]
    found = [(e.source, e.to) for e in events if isinstance(e, trace.Situation)]
    assert found == [(None, "a"), ("a", None)]
    assert robot.board.look("situation.name") is None


def test_a_change_behind_the_current_one_changes_nothing(play: Play) -> None:
    spds = situation("a", true("x")) + situation("b", true("y")) + REST
    lines = sets(x=[(1, ON)], y=[(2, ON), (3, OFF)])
    trace = play((), lines, spds=spds)
    assert trace.situations() == [(0, "rest"), (1, "a")]
    assert trace.lines("condition", since=2) == [
        "2 condition b true <data",
        "3 condition b false <data",
    ]


def test_one_without_condition_always_holds(play: Play) -> None:
    spds = situation("a", true("x")) + situation("b") + situation("c", true("y")) + REST
    assert play((), sets(y=[(1, ON)]), spds=spds).situations() == [(0, "b")]


def test_the_situation_names_what_it_comes_from(play: Play) -> None:
    spds = situation("a", true("x")) + REST
    assert play((), sets(x=[(1, ON), (2, OFF)]), spds=spds).lines("situation") == [
        "0 situation - rest <-",
        "1 situation rest a <condition",
        "2 situation a rest <condition",
    ]


def test_observe_and_modules_may_be_absent(play: Play) -> None:
    assert play((), [], spds=REST).situations() == [(0, "rest")]


# -- dwell -------------------------------------------------------------------

DWELL = situation("a", true("x"), dwell="3") + REST


def test_dwell_holds_at_least_so_long(play: Play) -> None:
    lines = sets(x=[(1, ON), (2, OFF)])
    assert play((), lines, spds=DWELL).lines(since=1) == [
        "1 data x true scenario v1 <-",
        "1 condition a true <data",
        "1 situation rest a <condition",
        "2 data x false scenario v2 <-",
        "2 condition a false <data",
        "4 situation a rest <situation",
    ]


def test_after_dwell_the_condition_counts_alone(play: Play) -> None:
    lines = sets(x=[(1, ON), (8, OFF)])
    assert play((), lines, spds=DWELL).situations() == [(0, "rest"), (1, "a"), (8, "rest")]


def test_dwell_is_counted_once(play: Play) -> None:
    """That the condition comes to hold again while it dwells begins nothing anew."""
    lines = sets(x=[(1, ON), (2, OFF), (3, ON), (3.5, OFF)])
    assert play((), lines, spds=DWELL).situations() == [(0, "rest"), (1, "a"), (4, "rest")]


def test_dwell_is_not_counted_again_after_one_that_took_over(play: Play) -> None:
    spds = situation("first", true("y")) + DWELL
    lines = sets(x=[(1, ON), (7, OFF)], y=[(2, ON), (6, OFF)])
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (1, "a"), (2, "first"), (6, "a"), (7, "rest"),
    ]  # fmt: skip


def test_one_that_stands_before_it_takes_over_while_it_dwells_which_goes_on(play: Play) -> None:
    spds = situation("first", true("y")) + DWELL
    lines = sets(x=[(1, ON), (1.5, OFF)], y=[(2, ON), (3, OFF)])
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (1, "a"), (2, "first"), (3, "a"), (4, "rest"),
    ]  # fmt: skip
    lines = sets(x=[(1, ON), (1.5, OFF)], y=[(2, ON), (5, OFF)])
    assert play((), lines, spds=spds).situations()[-1] == (5, "rest")


def test_dwell_begins_when_it_becomes_current_not_when_its_condition_holds(play: Play) -> None:
    spds = situation("first", true("y")) + DWELL
    lines = sets(x=[(1, ON), (6, OFF)], y=[(0.5, ON), (5, OFF)])
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (0.5, "first"), (5, "a"), (8, "rest"),
    ]  # fmt: skip


def test_when_it_begins_again_it_dwells_again(play: Play) -> None:
    lines = sets(x=[(1, ON), (2, OFF), (10, ON), (11, OFF)])
    assert play((), lines, spds=DWELL).situations() == [
        (0, "rest"), (1, "a"), (4, "rest"), (10, "a"), (13, "rest"),
    ]  # fmt: skip


# -- until -------------------------------------------------------------------

UNTIL = situation("a", true("x"), until=true("done")) + REST


def test_until_keeps_it_whatever_its_condition(play: Play) -> None:
    lines = sets(x=[(1, ON), (2, OFF)], done=[(9, ON)])
    assert play((), lines, spds=UNTIL).lines(since=2) == [
        "2 data x false scenario v2 <-",
        "2 condition a false <data",
        "9 data done true scenario v1 <-",
        "9 situation a rest <data",
    ]


def test_it_does_not_begin_while_until_holds(play: Play) -> None:
    lines = sets(x=[(2, ON)], done=[(1, ON), (5, OFF)])
    trace = play((), lines, spds=UNTIL)
    assert trace.situations() == [(0, "rest"), (5, "a")]
    # What let it begin is that until holds no longer.
    assert trace.lines("situation", since=5) == ["5 situation rest a <data"]


def test_ended_so_it_can_not_begin_before_its_condition_has_been_false(play: Play) -> None:
    lines = sets(x=[(1, ON), (6, OFF), (7, ON)], done=[(3, ON), (4, OFF)])
    assert play((), lines, spds=UNTIL).situations() == [
        (0, "rest"), (1, "a"), (3, "rest"), (7, "a"),
    ]  # fmt: skip


def test_ended_while_its_condition_was_false_it_can_begin_at_once(play: Play) -> None:
    lines = sets(x=[(1, ON), (2, OFF), (5, ON)], done=[(3, ON), (4, OFF)])
    assert play((), lines, spds=UNTIL).situations() == [
        (0, "rest"), (1, "a"), (3, "rest"), (5, "a"),
    ]  # fmt: skip


def test_one_that_stands_before_it_takes_over_and_until_goes_on_meanwhile(play: Play) -> None:
    spds = situation("first", true("y")) + UNTIL
    kept = sets(x=[(1, ON), (1.5, OFF)], y=[(2, ON), (3, OFF)], done=[(9, ON)])
    assert play((), kept, spds=spds).situations() == [
        (0, "rest"), (1, "a"), (2, "first"), (3, "a"), (9, "rest"),
    ]  # fmt: skip
    ended = sets(x=[(1, ON), (1.5, OFF)], y=[(2, ON), (4, OFF)], done=[(3, ON)])
    assert play((), ended, spds=spds).situations()[-2:] == [(2, "first"), (4, "rest")]


def test_what_never_was_current_is_not_kept_by_until(play: Play) -> None:
    spds = situation("first", true("y")) + UNTIL
    lines = sets(y=[(1, ON), (5, OFF)], x=[(2, ON), (3, OFF)])
    assert play((), lines, spds=spds).situations() == [(0, "rest"), (1, "first"), (5, "rest")]


def test_condition_and_until_have_causes_of_their_own(play: Play) -> None:
    spds = situation("first", true("y")) + UNTIL
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"x": True, "done": False}},
        {"at": 2, "set": {"done": True, "x": False}},
    ]
    assert play((), lines, spds=spds).lines("condition", "situation", since=1) == [
        "1 condition a true <data^1",
        "1 situation rest a <condition",
        "2 condition a false <data",
        "2 situation a rest <data^1",
    ]


def test_without_condition_it_ends_by_until_for_good(play: Play) -> None:
    """It has no condition that could be false once."""
    spds = situation("a", until=true("done")) + REST
    lines = sets(done=[(1, ON), (2, OFF)])
    assert play((), lines, spds=spds).situations() == [(0, "a"), (1, "rest")]


def test_the_end_of_a_within_may_let_it_begin(play: Play) -> None:
    spds = situation("a", true("x"), until=true("done", 'within="3"')) + REST
    lines = sets(done=[(1, ON)], x=[(2, ON)])
    trace = play((), lines, spds=spds)
    assert trace.situations() == [(0, "rest"), (4, "a")]
    assert trace.lines("situation", since=4) == ["4 situation rest a <data^1"]


# -- limit -------------------------------------------------------------------


def test_limit_ends_it_at_the_latest(play: Play) -> None:
    spds = situation("a", true("x"), until=true("done"), limit="3") + REST
    lines = sets(x=[(1, ON)])
    assert play((), lines, spds=spds).lines("situation", since=1) == [
        "1 situation rest a <condition",
        "4 situation a rest <situation",
    ]
    sooner = sets(x=[(1, ON)], done=[(2, ON)])
    assert play((), sooner, spds=spds).situations()[-1] == (2, "rest")


def test_limit_alone_keeps_it_that_long(play: Play) -> None:
    spds = situation("a", true("x"), limit="3") + REST
    lines = sets(x=[(1, ON), (2, OFF)])
    assert play((), lines, spds=spds).situations() == [(0, "rest"), (1, "a"), (4, "rest")]


def test_ended_by_its_limit_it_can_not_begin_before_its_condition_has_been_false(
    play: Play,
) -> None:
    spds = situation("a", true("x"), limit="3") + REST
    lines = sets(x=[(1, ON), (6, ON), (7, OFF), (8, ON)])
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (1, "a"), (4, "rest"), (8, "a"), (11, "rest"),
    ]  # fmt: skip


def test_limit_is_not_counted_anew_after_one_that_took_over(play: Play) -> None:
    spds = situation("first", true("y")) + situation("a", true("x"), limit="5") + REST
    lines = sets(x=[(1, ON)], y=[(2, ON), (4, OFF)])
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (1, "a"), (2, "first"), (4, "a"), (6, "rest"),
    ]  # fmt: skip


def test_limit_ends_it_also_while_another_has_taken_over(play: Play) -> None:
    spds = situation("first", true("y")) + situation("a", true("x"), limit="3") + REST
    lines = sets(x=[(1, ON)], y=[(2, ON), (6, OFF)])
    assert play((), lines, spds=spds).situations()[-1] == (6, "rest")


def test_condition_until_and_limit_at_one_moment(play: Play) -> None:
    """The papers' own: invited, until arrived or failed, at most so long."""
    spds = (
        situation(
            "invited",
            true("calling", 'within="5"') + true("waving", 'within="2"'),
            until="""<data tag="phase" in='["arrived", "failed"]' within="5"/>""",
            limit="9",
        )
        + REST
    )
    lines = [
        {"at": 1, "set": {"calling": True}},
        {"at": 2, "set": {"waving": True}},
        {"at": 6, "set": {"phase": "arrived"}},
        {"at": 7, "set": {"calling": True, "waving": True}},
        {"at": 20, "set": {"calling": True, "waving": True}},
        END,
    ]
    trace = play((), lines, spds=spds)
    # At 7 until still holds (till 11); then the condition no longer does (till 9).
    assert trace.situations() == [
        (0, "rest"), (2, "invited"), (6, "rest"), (20, "invited"), (29, "rest"),
    ]  # fmt: skip
    assert trace.lines("condition") == [
        "2 condition invited true <data",
        "4 condition invited false <data",
        "7 condition invited true <data",
        "9 condition invited false <data",
        "20 condition invited true <data",
        "22 condition invited false <data",
    ]


# -- priorities --------------------------------------------------------------

MODULES = """<modules><module name="m" resources="head"/><module name="n" resources="head"/>
  <module name="o" resources="head"/></modules>"""


def entry(module: str, priority: object) -> str:
    return f'<module name="{module}" priority="{priority}"/>'


def extending(name: str, extends: str, *entries: str) -> str:
    more = f' extends="{extends}"' if extends else ""
    return f'<situation name="{name}"{more}>{"".join(entries)}</situation>'


@pytest.mark.parametrize(
    ("situations", "expected"),
    [
        # extends takes over another's priorities, also through several.
        (
            extending("s", "t") + extending("t", "u") + extending("u", "", entry("m", 3)),
            {"m": 3},
        ),
        # Own entries override; none removes one.
        (
            extending("s", "t", entry("m", 7), entry("n", "none"))
            + extending("t", "", entry("m", 3), entry("n", 4), entry("o", -5)),
            {"m": 7, "o": -5},
        ),
        (
            extending("s", "t", entry("m", 1))
            + extending("t", "u", entry("m", "none"))
            + extending("u", "", entry("m", 3), entry("n", 4)),
            {"m": 1, "n": 4},
        ),
    ],
)
def test_extends_takes_over_priorities(
    play: Play, situations: str, expected: dict[str, int]
) -> None:
    rbd = (
        '<state no="1"><backgroundactions><set tag="out">{situation}</set></backgroundactions>'
        "</state>"
    )
    spds = MODULES.replace("</modules>", '<module name="app" resources=""/></modules>')
    end = f'<situation name="end">{entry("app", 1)}</situation>'
    trace = play(rbd, [], spds=spds + situations + end)
    assert trace.values("out") == [{"name": "s", "priorities": expected}]


def test_extends_takes_over_only_priorities(play: Play) -> None:
    spds = situation("a", true("x"), dwell="5") + situation("b", true("y"), extends="a") + REST
    lines = sets(y=[(1, ON), (2, OFF)])
    assert play((), lines, spds=spds).situations() == [(0, "rest"), (1, "b"), (2, "rest")]
