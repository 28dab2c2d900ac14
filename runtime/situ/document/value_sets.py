"""Sets of values: what a test leaves of all the values that a name can have.

The values of a name (any JSON value, and *missing*) are parted into *cells* that
none of the tests at hand tells apart: missing, true, false, every number, string,
list or object that a test names, the gaps between the numbers and between the
strings, and one cell each for all other lists and objects. A set of values is then
an integer with a bit for each cell, and every test is exactly such a set.

Exact, since gaps in which no value lies are left out: a number is any finite float or
any integer, a string any sequence of code points, so nothing lies between
``"a"`` and ``"a\\0"``, and nothing below ``""``.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Iterable
from typing import Any

from msgspec import Struct

from situ.document import names
from situ.document.condition import Test
from situ.document.values import equal, is_number, reach, read

MISSING, TRUE, FALSE = 1, 2, 4
_FIRST = 3
ORDERS = ("above", "below", "atleast", "atmost")
NUMBER, TEXT, LIST, OBJECT, BOOLEAN = "number", "text", "list", "object", "boolean"
ANYTHING = frozenset((NUMBER, TEXT, LIST, OBJECT, BOOLEAN))


class Domain(Struct, frozen=True):
    """What is known of a name's values beforehand; it may always be missing, too.

    kinds: the types it can have. words: the strings it can be, None for any.
    """

    kinds: frozenset[str] = ANYTHING
    words: tuple[str, ...] | None = None


ANY = Domain()
NOTHING_EVER = Domain(frozenset())


def constants(test: Test) -> list[Any]:
    """The values that a test names; of one that compares with another name, none."""
    if test.test == "exists" or refers(test) is not None:
        return []
    wanted = read(test.value)
    if test.test in ORDERS:
        return [wanted if is_number(wanted) else test.value]
    if test.test == "in":
        return [one for one in wanted if one is not None] if isinstance(wanted, list) else []
    return [test.value] if wanted is None else [wanted, test.value]


def refers(test: Test) -> str | None:
    """The name with which a test compares, where its text is exactly one reference."""
    return None if test.test == "exists" else names.only_reference(test.value)


class Values:
    """The values of one name, parted by ``named``, the values that tests name.

    full: the set of all that it can be. What a set may hold beyond ``full`` means nothing.
    """

    def __init__(self, named: Iterable[Any], domain: Domain = ANY) -> None:
        numbers: set[Any] = set()
        strings: set[str] = set()
        self.composites: list[Any] = []
        for value in named:
            if isinstance(value, str):
                strings.add(value)
            elif is_number(value):
                numbers.add(value)
            elif isinstance(value, (list, dict)) and not any(
                equal(value, known) for known in self.composites
            ):
                self.composites.append(value)
        self.numbers = sorted(numbers)
        self.strings = sorted(strings)
        self._strings_from = _FIRST + 2 * len(self.numbers) + 1
        self._composites_from = self._strings_from + 2 * len(self.strings) + 1
        self.other_list = 1 << (self._composites_from + len(self.composites))
        self.other_object = self.other_list << 1
        self.number = _range(_FIRST, self._strings_from)
        self.text = _range(self._strings_from, self._composites_from)
        self.composite = _range(self._composites_from, self._composites_from + len(self.composites))
        self.composite |= self.other_list | self.other_object
        self.full = self._full(domain)
        self._tests: dict[tuple[str, str], int] = {}

    def of(self, test: Test) -> int:
        """The values for which a test holds, ``within`` and ``for`` left aside.

        The test compares with no other name.
        """
        key = (test.test, test.value)
        found = self._tests.get(key)
        if found is None:
            found = self._tests[key] = self._of(test) & self.full
        return found

    def cell(self, value: Any) -> int:
        """The set of one value that was among those named (None: missing), else of its like."""
        if value is None:
            return MISSING
        if isinstance(value, bool):
            return TRUE if value else FALSE
        if isinstance(value, str):
            return 1 << (self._strings_from + _place(self.strings, value))
        if is_number(value):
            return 1 << (_FIRST + _place(self.numbers, value))
        for place, known in enumerate(self.composites):
            if equal(known, value):
                return 1 << (self._composites_from + place)
        return self.other_list if isinstance(value, list) else self.other_object

    def is_gap(self, cell: int) -> bool:
        """Whether a cell has more than one value."""
        bit = cell.bit_length() - 1
        if cell & self.number:
            return (bit - _FIRST) % 2 == 0
        if cell & self.text:
            return (bit - self._strings_from) % 2 == 0
        return bool(cell & (self.other_list | self.other_object))

    def held(self, cell: int, path: str) -> Any:
        """What a list or object of a named cell has at ``path``; None where it has nothing."""
        place = cell.bit_length() - 1 - self._composites_from
        return reach(self.composites[place], path) if place < len(self.composites) else None

    # ------------------------------------------------------------------------

    def _of(self, test: Test) -> int:
        everything = self.number | self.text | self.composite | MISSING | TRUE | FALSE
        if test.test == "exists":
            is_there = read(test.value) is not False
            return everything & ~MISSING if is_there else MISSING
        named = constants(test)
        if test.test == "in":
            return self._any(named)
        if test.test == "is":
            return self._any(named)
        if test.test == "isnot":
            return everything & ~self._any(named)
        (bound,) = named
        if is_number(bound):
            place, low, high = _place(self.numbers, bound), _FIRST, self._strings_from
        else:
            place, low, high = (
                _place(self.strings, bound),
                self._strings_from,
                self._composites_from,
            )
        at = low + place
        return {
            "above": _range(at + 1, high),
            "atleast": _range(at, high),
            "below": _range(low, at),
            "atmost": _range(low, at + 1),
        }[test.test]

    def _any(self, values: list[Any]) -> int:
        found = 0
        for value in values:
            found |= self.cell(value)
        return found

    def _full(self, domain: Domain) -> int:
        found = MISSING
        if BOOLEAN in domain.kinds:
            found |= TRUE | FALSE
        if NUMBER in domain.kinds:
            found |= self.number
            numbers = self.numbers
            for place, number in enumerate(numbers):
                below = numbers[place - 1] if place else -math.inf
                if not _number_between(below, number):
                    found &= ~(1 << (_FIRST + 2 * place))
        if TEXT in domain.kinds:
            found |= self._texts(domain.words)
        if LIST in domain.kinds:
            found |= self.other_list
        if OBJECT in domain.kinds:
            found |= self.other_object
        for place, value in enumerate(self.composites):
            if (LIST if isinstance(value, list) else OBJECT) in domain.kinds:
                found |= 1 << (self._composites_from + place)
        return found

    def _texts(self, words: tuple[str, ...] | None) -> int:
        if words is not None:
            found = 0
            for word in words:
                found |= 1 << (self._strings_from + _place(self.strings, word))
            return found
        found = self.text
        for place, string in enumerate(self.strings):
            # The next string after "a" is "a\0"; the first of all is "".
            first = self.strings[place - 1] + "\0" if place else ""
            if first == string:
                found &= ~(1 << (self._strings_from + 2 * place))
        return found


def _range(low: int, high: int) -> int:
    """The bits from ``low`` up to, not with, ``high``."""
    return (1 << high) - (1 << low) if high > low else 0


def _place(ordered: list[Any], value: Any) -> int:
    """The place of a value among points and gaps: 0 below all, 1 the first point, 2 above it …"""
    place = bisect_left(ordered, value)
    return 2 * place + (place < len(ordered) and ordered[place] == value)


def _number_between(low: Any, high: Any) -> bool:
    """Whether a finite float or an integer lies strictly between two numbers."""
    if low == -math.inf or high == math.inf or math.floor(low) + 1 < high:
        return True
    if abs(low) > 2**53:
        return False  # Floats as large as this are integers.
    return bool(math.nextafter(float(low), math.inf) < high)
