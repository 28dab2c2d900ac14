"""What is another one between two pictures, however they differ."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from situ_studio.canvas.graph import FEW, differing

KEYS = st.integers(0, 30)


class Value:
    """Compares by identity, as what is shown does."""


VALUES = tuple(Value() for _ in range(4))
PICTURES = st.dictionaries(KEYS, st.sampled_from(VALUES))


@given(PICTURES, PICTURES)
def test_of_any_two_pictures_it_tells_what_is_gone_and_what_is_not_the_very_same(
    before: dict[int, Value], now: dict[int, Value]
) -> None:
    gone, fresh = differing(before, now)
    assert sorted(gone) == sorted(before.keys() - now.keys())
    assert sorted(fresh) == sorted(k for k in now if before.get(k) is not now[k])


@given(PICTURES, st.lists(KEYS, max_size=FEW), PICTURES)
def test_of_a_picture_from_which_some_went_and_to_which_some_came_too(
    before: dict[int, Value], went: list[int], came: dict[int, Value]
) -> None:
    # A key of its own each time, as the ids of pipes are: equal, not the same.
    then = {(key, "of"): value for key, value in before.items()}
    now = {(key, "of"): value for key, value in before.items() if key not in went}
    now.update({(key, "of"): value for key, value in came.items()})
    gone, fresh = differing(then, now)
    assert set(gone) == then.keys() - now.keys()
    assert set(fresh) == {k for k in now if then.get(k) is not now[k]}
    assert len(gone) + len(fresh) == len({*gone, *fresh})
