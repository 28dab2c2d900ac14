"""What situations take over from each other."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from situ.document.spds import Entry, Situation, Spds

NAMES = st.sampled_from("abcdef")
ENTRIES = st.lists(
    st.builds(Entry, st.sampled_from("mno"), st.one_of(st.none(), st.integers(0, 9))), max_size=3
)
SITUATIONS = st.builds(
    Situation, NAMES, extends=st.one_of(st.none(), NAMES), entries=ENTRIES.map(tuple)
)


@given(st.lists(SITUATIONS, max_size=7))
@settings(max_examples=80, deadline=None)
def test_the_priorities_of_all_situations_are_those_of_each(several: list[Situation]) -> None:
    """In circles of ``extends`` too, and where two have one name."""
    script = Spds("s", situations=tuple(several))
    assert script.every_priorities() == [script.priorities(one) for one in several]


def test_what_is_taken_over_follows_extends_and_none_takes_it_away() -> None:
    script = Spds(
        "s",
        situations=(
            Situation("c", extends="b", entries=(Entry("n", None),)),
            Situation("b", extends="a", entries=(Entry("m", 2), Entry("n", 3))),
            Situation("a", entries=(Entry("m", 1), Entry("o", 4))),
        ),
    )
    assert script.every_priorities() == [
        {"m": 2, "o": 4},
        {"m": 2, "o": 4, "n": 3},
        {"m": 1, "o": 4},
    ]
