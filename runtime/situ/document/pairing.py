"""Which member of one list is which of another, and which of them changed their order."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Hashable, Sequence
from typing import Generic, TypeVar

from msgspec import Struct

T = TypeVar("T")

Key = Callable[[int, T], Hashable | None]
"""What a member (its index, itself) is known by in one pass; None: not in this pass."""


class Paired(Struct, Generic[T], frozen=True):
    """both: (index before, index after), in the order of after. gone, new: the rest."""

    both: tuple[tuple[int, int], ...]
    gone: tuple[int, ...]
    new: tuple[int, ...]

    @property
    def moved(self) -> tuple[tuple[int, int], ...]:
        """The fewest pairs that must move to make the old order the new one."""
        kept = set(_longest_rising([before for before, _ in self.both]))
        return tuple(pair for number, pair in enumerate(self.both) if number not in kept)


def pair(before: Sequence[T], after: Sequence[T], passes: Sequence[Key[T]]) -> Paired[T]:
    """Pairs members that one pass knows by the same key, those left over by the next.

    Several of one key are paired in their order, so that no member is left over
    that could have a partner in that pass.
    """
    left, right = dict(enumerate(before)), dict(enumerate(after))
    found: list[tuple[int, int]] = []
    for key in passes:
        waiting: dict[Hashable, list[int]] = {}
        for index, value in left.items():
            known = key(index, value)
            if known is not None:
                waiting.setdefault(known, []).append(index)
        for index, value in list(right.items()):
            known = key(index, value)
            if known is not None and waiting.get(known):
                partner = waiting[known].pop(0)
                found.append((partner, index))
                del left[partner], right[index]
    return Paired(
        tuple(sorted(found, key=lambda both: both[1])), tuple(sorted(left)), tuple(sorted(right))
    )


def _longest_rising(numbers: Sequence[int]) -> list[int]:
    """Places of a longest rising run of different numbers, not necessarily side by side."""
    ends: list[int] = []
    places: list[int] = []
    before: list[int | None] = []
    for place, number in enumerate(numbers):
        at = bisect_left(ends, number)
        before.append(places[at - 1] if at else None)
        if at == len(ends):
            ends.append(number)
            places.append(place)
        else:
            ends[at], places[at] = number, place
    found: list[int] = []
    last = places[-1] if places else None
    while last is not None:
        found.append(last)
        last = before[last]
    return found[::-1]
