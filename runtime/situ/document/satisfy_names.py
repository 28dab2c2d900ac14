"""The variables of a search over one moment, and what no single one of them says.

Each name has a variable for its value, one for its age where ``within`` asks for it, one
for each of its tests with ``for``; each two names that are compared share one. A variable's
possibilities are the bits of an integer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from situ.document import names
from situ.document.condition import Test
from situ.document.value_sets import MISSING, Domain, Values, constants, refers
from situ.document.values import reach

NO, YES = 1, 2
"""The possibilities of a variable that is true or false."""

APART, EQUAL, SAME, LESS, MORE = 1, 2, 4, 8, 16
"""How two values stand to each other; ``EQUAL``: two numbers or strings, ``SAME``: others."""

RELATIONS = {
    "is": EQUAL | SAME,
    "isnot": APART | LESS | MORE,
    "above": MORE,
    "below": LESS,
    "atleast": MORE | EQUAL,
    "atmost": LESS | EQUAL,
}


class Spent(Exception):
    """The budget of a question is spent."""


class Lasting:
    """A test with ``for``: the variable that says whether it has lasted, for how many µs, and
    the variable and possibilities of what has lasted.
    """

    __slots__ = ("base", "hold", "mask", "var")

    def __init__(self, var: int, base: int, mask: int, hold: int) -> None:
        self.var = var
        self.base = base
        self.mask = mask
        self.hold = hold


class Variables:
    """The variables for all of some tests.

    full: by variable, all of its possibilities. var: by name, the variable of its value.
    left: the looks that the question being answered may still take.
    """

    def __init__(self, given: Iterable[Test], domain: Callable[[str], Domain]) -> None:
        self.full: list[int] = []
        self.values: dict[str, Values] = {}
        self.var: dict[str, int] = {}
        self.left = 0
        self.lasting: dict[int, Lasting] = {}
        self._name: list[tuple[str, ...]] = []
        self._ages: dict[str, tuple[int, list[int]]] = {}
        self._known: dict[tuple[int, int, int], Lasting] = {}
        self._pairs: dict[int, tuple[str, str, bool]] = {}
        self._relations: dict[tuple[str, str], int] = {}
        self._members: dict[tuple[str, str], int] = {}
        self._parent: dict[str, tuple[str, str, bool]] = {}
        self._prepare(given, domain)

    def _prepare(self, given: Iterable[Test], domain: Callable[[str], Domain]) -> None:
        named: dict[str, list[object]] = {}
        ages: dict[str, set[int]] = {}
        pairs: list[tuple[str, str]] = []
        for test in given:
            named.setdefault(test.tag, []).extend(constants(test))
            other = refers(test)
            if other is not None:
                named.setdefault(other, [])
                pairs.append((test.tag, other))
            if test.within is not None:
                ages.setdefault(test.tag, set()).add(_duration(test.within))
        ordered = sorted(named, key=lambda name: (len(name), name))
        for name in ordered:
            self._find_parent(name, named)
        _share(named, pairs, self._parent, ordered)
        for name in ordered:
            self.values[name] = made = Values(named[name], domain(name))
            self.var[name] = self._variable(made.full, name)
        for name, found in ages.items():
            self._ages[name] = (self._variable((2 << len(found)) - 1, name), sorted(found))

    def _variable(self, full: int, *of: str) -> int:
        self.full.append(full)
        self._name.append(of)
        return len(self.full) - 1

    def _find_parent(self, name: str, known: dict[str, list[object]]) -> None:
        """The nearest name into which this one reaches, where one says something of the other."""
        if names.is_reserved(name):
            return
        cut = name.rfind(".")
        while cut > 0:
            above, path = name[:cut], name[cut + 1 :]
            if above in known:
                # Through a word that may be a tag of its own, nothing follows.
                step = f"{above}.{path.partition('.')[0]}"
                if "." not in path or not names.is_tag(step):
                    self._parent[name] = (above, path, names.is_tag(name))
                return
            cut = name.rfind(".", 0, cut)

    # -- what tests say of variables ---------------------------------------------

    def young(self, test: Test) -> tuple[int, int]:
        """The variable of a name's age, and the ages that the ``within`` of a test allows."""
        assert test.within is not None
        var, ends = self._ages[test.tag]
        return var, (2 << ends.index(_duration(test.within))) - 1

    def lasted(self, name: str, base: int, mask: int, seconds: float) -> int:
        """The variable that says whether a literal about ``name`` has lasted."""
        key = (base, mask, _duration(seconds))
        found = self._known.get(key)
        if found is None:
            var = self._variable(NO | YES, name)
            found = self._known[key] = self.lasting[var] = Lasting(var, *key)
        return found.var

    def compared(self, test: Test, other: str) -> tuple[int, int]:
        """The variable and the possibilities of a test that compares with another name."""
        name = test.tag
        if name == other:
            values = self.values[name]
            ordered = values.number | values.text
            kept = {
                "is": values.full & ~MISSING,
                "isnot": MISSING,
                "atleast": ordered & values.full,
                "atmost": ordered & values.full,
            }
            return self.var[name], kept.get(test.test, 0)
        if test.test == "in":
            var = self._members.get((name, other))
            if var is None:
                var = self._members[name, other] = self._variable(NO | YES, name, other)
                self._pairs[var] = (name, other, True)
            return var, YES
        mask = RELATIONS[test.test]
        if name > other:
            name, other, mask = other, name, _mirrored(mask)
        var = self._relations.get((name, other))
        if var is None:
            full = APART | EQUAL | SAME | LESS | MORE
            var = self._relations[name, other] = self._variable(full, name, other)
            self._pairs[var] = (name, other, False)
        return var, mask

    def groups(self) -> list[int]:
        """By variable, the number of its group; different groups are free of each other."""
        known: dict[str, str] = {}

        def find(name: str) -> str:
            while known.setdefault(name, name) != name:
                name = known[name]
            return name

        links = [(name, above) for name, (above, _, _) in self._parent.items()]
        for one, other in [*links, *self._relations, *self._members]:
            known[find(one)] = find(other)
        first: dict[str, int] = {}
        return [first.setdefault(find(of[0]), var) for var, of in enumerate(self._name)]

    def beside(self, name: str) -> list[int]:
        """The variables that say something of a name beside that of its value."""
        return [var for var, of in enumerate(self._name) if name in of and var != self.var[name]]

    def is_age(self, name: str, var: int) -> bool:
        return name in self._ages and self._ages[name][0] == var

    # -- what single variables do not say ----------------------------------------

    def fits(self, chosen: dict[int, int]) -> bool | None:
        """Whether there are values, ages and a past for what is left of each variable."""
        involved = {name for var in chosen for name in self._name[var]}
        for name in list(involved):
            while name in self._parent:
                name = self._parent[name][0]
                involved.add(name)
        # By variable of a value: its tests that have lasted, and those that have not.
        past: dict[int, tuple[list[Lasting], list[Lasting]]] = {}
        pairs = []
        for var, left in chosen.items():
            if var in self.lasting and left in (NO, YES):
                lasting = self.lasting[var]
                past.setdefault(lasting.base, ([], []))[left == NO].append(lasting)
            elif var in self._pairs:
                one, other, is_member = self._pairs[var]
                pairs.append((one, other, var, is_member))
        allowed = {}
        for name in involved:
            var = self.var[name]
            values = chosen.get(var, self.full[var])
            if var in past and past[var][1]:
                values = self._with_past(name, values, *past[var], chosen)
            if not values:
                return False
            allowed[name] = values
        linked = {n for one, other, _, _ in pairs for n in (one, other)}
        linked |= {name for name in involved if name in self._parent}
        linked |= {self._parent[name][0] for name in involved if name in self._parent}
        if not linked:
            return True
        ordered = sorted(linked, key=lambda name: (len(name), name))
        if not self._assign(ordered, 0, allowed, pairs, chosen, {}):
            return False
        return None if _has_circle((one, other) for one, other, _, _ in pairs) else True

    def _with_past(
        self,
        name: str,
        values: int,
        kept: list[Lasting],
        broken: list[Lasting],
        chosen: dict[int, int],
    ) -> int:
        """Those of the values that a name can have now, given what has and has not lasted."""
        full = self.full[self.var[name]]
        found = 0
        for lower, is_last in self._ages_left(name, chosen):
            allowed = values
            for one in broken:
                longer = [other for other in kept if other.hold >= one.hold]
                before = full & ~one.mask
                for other in longer:
                    before &= other.mask
                # Another value stood there in that time, or the robot started in it.
                if lower < one.hold and (before or not longer):
                    continue
                never_set = MISSING if is_last and not longer else 0
                allowed &= ~one.mask | never_set
            found |= allowed
        return found

    def _ages_left(self, name: str, chosen: dict[int, int]) -> Iterator[tuple[int, bool]]:
        """The youngest of each cell of ages that is left, and whether it is the oldest cell,
        which is also that of a name never set.
        """
        if name not in self._ages:
            yield 0, True
            return
        var, ends = self._ages[name]
        left = chosen.get(var, self.full[var])
        for place, lower in enumerate([0, *ends]):
            if left & 1 << place:
                yield lower, place == len(ends)

    def _assign(
        self,
        ordered: list[str],
        at: int,
        allowed: dict[str, int],
        pairs: list[tuple[str, str, int, bool]],
        chosen: dict[int, int],
        cells: dict[str, int],
    ) -> bool:
        """Looks for one cell for each name, so that each two that are linked fit."""
        if at == len(ordered):
            return True
        name = ordered[at]
        left = allowed[name]
        while left:
            self.left -= 1
            if self.left <= 0:
                raise Spent
            cell = left & -left
            left ^= cell
            cells[name] = cell
            if self._suits(name, pairs, chosen, cells) and self._assign(
                ordered, at + 1, allowed, pairs, chosen, cells
            ):
                return True
        del cells[name]
        return False

    def _suits(
        self,
        name: str,
        pairs: list[tuple[str, str, int, bool]],
        chosen: dict[int, int],
        cells: dict[str, int],
    ) -> bool:
        if name in self._parent:
            above, path, is_tag = self._parent[name]
            if not self._reaches(cells[above], above, path, cells[name], name, is_tag):
                return False
        for one, other, var, is_member in pairs:
            if name not in (one, other) or one not in cells or other not in cells:
                continue
            if is_member:
                left = self._member(one, cells[one], other, cells[other])
                if self._inside(other, one, chosen):
                    left &= NO
            else:
                left = self._relation(one, cells[one], other, cells[other])
                if self._inside(one, other, chosen) or self._inside(other, one, chosen):
                    left &= ~(EQUAL | SAME)
            if not left & chosen[var]:
                return False
        return True

    def _inside(self, one: str, other: str, chosen: dict[int, int]) -> bool:
        """Whether the first must be a member of the second: then not also the other way round."""
        var = self._members.get((one, other))
        return var is not None and chosen.get(var) == YES

    def _reaches(
        self, cell: int, above: str, path: str, inner: int, name: str, is_tag: bool
    ) -> bool:
        """Whether a name can have the value ``inner`` where the one above it has ``cell``."""
        values = self.values[above]
        held = MISSING
        if cell == values.other_object:
            return True
        if cell == values.other_list:
            first = path.partition(".")[0]
            if first.isascii() and first.isdigit():
                return True
        elif cell & values.composite:
            held = self.values[name].cell(values.held(cell, path))
        if is_tag:
            # It may as well be a tag of its own, which comes first.
            return inner != MISSING or held == MISSING
        return inner == held

    def _relation(self, one: str, cell: int, other: str, beside: int) -> int:
        """How two values can stand to each other; both names have the same cells."""
        values = self.values[one]
        if cell == MISSING or beside == MISSING:
            return APART
        for kind in (values.number, values.text):
            if cell & kind and beside & kind:
                if cell != beside:
                    return LESS if cell < beside else MORE
                return EQUAL | LESS | MORE if values.is_gap(cell) else EQUAL
        if cell != beside:
            return APART
        return SAME | APART if values.is_gap(cell) else SAME

    def _member(self, one: str, cell: int, other: str, beside: int) -> int:
        """Whether the first value can be, and can not be, a member of the second."""
        values = self.values[other]
        if cell == MISSING or not beside & values.composite or beside == values.other_object:
            return NO
        if beside == values.other_list:
            return NO | YES
        whole = values.held(beside, "")
        if not isinstance(whole, list):
            return NO
        mine = self.values[one]
        known = [member for member in whole if member is not None]
        return YES if any(mine.cell(member) == cell for member in known) else NO


def _duration(seconds: float) -> int:
    """Whole microseconds, as the runtime counts."""
    return max(1, round(seconds * 1_000_000))


def _mirrored(mask: int) -> int:
    kept = mask & ~(LESS | MORE)
    return kept | (MORE if mask & LESS else 0) | (LESS if mask & MORE else 0)


def _share(
    named: dict[str, list[object]],
    pairs: list[tuple[str, str]],
    parents: dict[str, tuple[str, str, bool]],
    ordered: list[str],
) -> None:
    """Names that are compared get the same cells; what a named list or object holds is named
    for those that reach into it.
    """
    together: dict[str, list[str]] = {name: [name] for name in named}
    for one, other in pairs:
        if together[one] is not together[other]:
            merged = together[one] + together[other]
            for name in merged:
                together[name] = merged
    for one, other in pairs:
        for value in list(named[other]):
            if isinstance(value, list):
                named[one].extend(member for member in value if member is not None)
    for name in ordered:
        if name in parents:
            above, path, _ = parents[name]
            for inner in together[above]:
                for value in list(named[inner]):
                    held = reach(value, path) if isinstance(value, (list, dict)) else None
                    if held is not None:
                        named[name].append(held)
    for several in {id(one): one for one in together.values() if len(one) > 1}.values():
        shared = [value for name in several for value in named[name]]
        for name in several:
            named[name] = shared


def _has_circle(pairs: Iterable[tuple[str, str]]) -> bool:
    """Whether pairs of names, each once, close a circle of three or more."""
    group: dict[str, str] = {}

    def find(name: str) -> str:
        while group.setdefault(name, name) != name:
            name = group[name]
        return name

    for one, other in {(min(pair), max(pair)) for pair in pairs}:
        first, second = find(one), find(other)
        if first == second:
            return True
        group[first] = second
    return False
