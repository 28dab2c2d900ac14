"""Who holds what when all ask: the core's rule, and what only the order of asking decides."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import permutations

from hypothesis import given, settings
from hypothesis import strategies as st

from situ.decide.all_ask import Holding, Requests
from situ.decide.all_ask import who_holds as held_by


def who_holds(
    asking: Mapping[str, tuple[str, ...]], priorities: Mapping[str, int]
) -> dict[str, Holding]:
    return held_by(Requests(asking), priorities)


MODULES = {
    "transfer": ("base", "head"),
    "nod": ("head",),
    "chase": ("head",),
    "converse": ("speech", "screen"),
}


def test_when_all_ask_the_highest_priority_takes_all_of_its_resources_or_none() -> None:
    held = who_holds(MODULES, {"nod": 40, "transfer": 30, "converse": 20})
    assert held["head"] == Holding("nod")
    assert held["base"] == Holding(None), "transfer needs the head too"
    assert held["speech"] == held["screen"] == Holding("converse")


def test_when_all_ask_a_module_without_a_priority_holds_nothing() -> None:
    assert set(who_holds(MODULES, {}).values()) == {Holding(None)}
    assert list(who_holds(MODULES, {})) == ["base", "head", "speech", "screen"]


def test_when_all_ask_equal_priorities_are_told_where_the_order_decides() -> None:
    held = who_holds(MODULES, {"nod": 20, "chase": 20, "transfer": 20, "converse": 20})
    assert held["head"] == Holding("transfer", ("chase", "nod"))
    assert held["base"] == Holding("transfer", ("chase", "nod")), "nobody where nod was first"
    assert held["speech"] == Holding("converse")


ASKING = st.dictionaries(
    st.sampled_from("abcd"),
    st.sets(st.sampled_from(("x", "y", "z")), min_size=1).map(lambda s: tuple(sorted(s))),
)


@given(ASKING, st.sampled_from(("x", "y", "z")))
@settings(max_examples=60, deadline=None)
def test_rivals_are_told_exactly_where_another_order_gives_another_holder(
    asking: dict[str, tuple[str, ...]], resource: str
) -> None:
    priorities = dict.fromkeys(asking, 1)
    orders = [{m: asking[m] for m in order} for order in permutations(asking)]
    found = [who_holds(order, priorities).get(resource) for order in orders]
    mine = who_holds(asking, priorities).get(resource)
    assert bool(mine is not None and mine.rivals) == (len({f and f.module for f in found}) > 1)


def test_when_all_ask_equals_below_the_holder_are_no_rivals() -> None:
    held = who_holds(MODULES, {"transfer": 30, "nod": 20, "chase": 20})
    assert held["head"] == Holding("transfer")
