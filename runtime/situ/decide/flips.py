"""Which of many tests of one name can have changed when its value did.

Thousands of situations may look at one tag. A write then asks this index, thresholds by
bisection and equality by hash, and only what it gives is judged anew.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from typing import Any

from situ.decide.values import Look
from situ.document.condition import Test
from situ.document.values import is_number, read

Key = tuple[str, Any]
"""A kind (``number``, ``string``, ``boolean``) and a value that can be hashed."""


class Flips:
    """The tests of one name; each is added with the number of who is to judge it.

    ``value`` is the one that the name had when it was last asked.
    """

    def __init__(self, name: str, look: Look) -> None:
        self.value: Any = None
        self._name = name
        self._look = look
        self._equal: dict[Key, list[int]] = {}
        self._orders: dict[tuple[str, bool], _Order] = {}
        self._exists: list[int] = []
        self._deep: list[int] = []

    def add(self, source: Test, number: int) -> None:
        wanted = read(source.value)
        if source.test == "exists":
            self._exists.append(number)
        elif source.test in ("is", "isnot"):
            # A string equals the text as written, whatever that reads as.
            self._add_equal([wanted, source.value], number)
        elif source.test == "in":
            self._add_equal(wanted if isinstance(wanted, list) else [], number)
        else:
            bound = wanted if is_number(wanted) else source.value
            which = _key(bound)[0], source.test in ("above", "atleast")
            self._orders.setdefault(which, _Order(*which)).add(bound, number)

    def _add_equal(self, members: list[Any], number: int) -> None:
        for member in members:
            if isinstance(member, (list, dict)):
                self._deep.append(number)
            elif member is not None:
                self._equal.setdefault(_key(member), []).append(number)

    def changed(self) -> Iterable[int]:
        """The numbers of all tests that may not be what they were when this was last asked."""
        before, now = self.value, self._look(self._name)
        self.value = now
        found = list(self._deep)
        if (before is None) != (now is None):
            found += self._exists
        if self._equal:
            one, other = _key(before), _key(now)
            if one != other:
                found += self._equal.get(one, ())
                found += self._equal.get(other, ())
        for order in self._orders.values():
            found += order.between(before, now)
        return found


class _Order:
    """Bounds of one kind, sorted: rising tests hold above them, the others below."""

    def __init__(self, kind: str, rising: bool) -> None:
        self._kind = kind
        self._rising = rising
        self._bounds: list[Any] = []
        self._numbers: list[int] = []

    def add(self, bound: Any, number: int) -> None:
        place = bisect_right(self._bounds, bound)
        self._bounds.insert(place, bound)
        self._numbers.insert(place, number)

    def between(self, before: Any, now: Any) -> list[int]:
        """Those whose bound lies between the two values, or at one of them."""
        is_before, is_now = _key(before)[0] == self._kind, _key(now)[0] == self._kind
        if is_before and is_now:
            low, high = (before, now) if before <= now else (now, before)
            first = bisect_left(self._bounds, low)
            return self._numbers[first : bisect_right(self._bounds, high, first)]
        if not is_before and not is_now:
            return []
        # What is of another kind fulfils none of them: it lies below all, or above all.
        inside = before if is_before else now
        if self._rising:
            return self._numbers[: bisect_right(self._bounds, inside)]
        return self._numbers[bisect_left(self._bounds, inside) :]


def _key(value: Any) -> Key:
    """Values that are equal have the same key; lists and objects, which are compared deeply,
    share one, and so does what is missing.
    """
    if isinstance(value, str):
        return "string", value
    if isinstance(value, bool):
        return "boolean", value
    return ("number", value) if isinstance(value, (int, float)) else ("", None)
