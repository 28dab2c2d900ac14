"""Where two runs part: what each robot did there that the other did not.

Strand by strand their deeds are put beside one another so that as much as possible is the same
(E. W. Myers, An O(ND) Difference Algorithm and Its Variations, 1986); what remains are differences.
When something was done does not count, nor in which order different strands went on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from msgspec import Struct

from situ.rehearse.deeds import Deed, Deeds, Strand

PATIENCE = 300
"""Deeds that are looked through for what is the same again; after so many that differ, what was
found by then stands. Runs that have nothing in common would take forever else."""


class Stretch(Struct, frozen=True):
    """Deeds of one strand between two that both did. first, second: of each run, either may be
    empty. agreed: when each did what both did before; (0, 0) where there is none. at: when each
    came to it; of a run that did nothing there, when it would have been.
    """

    strand: Strand
    first: tuple[Deed, ...]
    second: tuple[Deed, ...]
    agreed: tuple[float, float]
    at: tuple[float, float]


class Difference(Struct, frozen=True):
    """A moment at which two runs part, in one strand or in several at once, states first.

    at: when, in seconds of each. agreed: when each did last what both did.
    """

    at: tuple[float, float]
    agreed: tuple[float, float]
    stretches: tuple[Stretch, ...]


class Alike(Struct, frozen=True):
    """Where two runs part, in the order of both times together; common: when each did the first
    thing that both did, None where there is nothing.
    """

    differences: list[Difference]
    common: tuple[float, float] | None


def alike(first: Deeds, second: Deeds) -> Alike:
    """Puts two runs beside one another.

    A run has no difference to itself, and the other way round all is the same, turned.
    """
    found: list[Stretch] = []
    both: list[tuple[float, float]] = []
    for strand in sorted(first.strands.keys() | second.strands.keys(), key=_order):
        a, b = first.strands.get(strand, []), second.strands.get(strand, [])
        pairs = matched(_what(a), _what(b))
        found += _stretches(strand, a, b, pairs)
        both += [(a[i].t, b[j].t) for i, j in pairs[:1]]
    gathered = [_joined(stretches) for stretches in _at_once(found)]
    return Alike(
        sorted(gathered, key=lambda one: (sum(one.at), min(one.at), one.stretches[0].strand)),
        min(both, key=lambda one: (sum(one), min(one)), default=None),
    )


def _order(strand: Strand) -> tuple[int, str]:
    return ("state", "situation", "resource").index(strand.kind), strand.name


def _what(deeds: Iterable[Deed]) -> list[str]:
    return [deed.what for deed in deeds]


def _stretches(
    strand: Strand, a: list[Deed], b: list[Deed], pairs: list[tuple[int, int]]
) -> Iterator[Stretch]:
    before = (-1, -1)
    for i, j in [*pairs, (len(a), len(b))]:
        one, other = tuple(a[before[0] + 1 : i]), tuple(b[before[1] + 1 : j])
        if one or other:
            agreed = (a[before[0]].t, b[before[1]].t) if before[0] >= 0 else (0.0, 0.0)
            ends = (a[i].t if i < len(a) else None, b[j].t if j < len(b) else None)
            at = (
                _when(one, ends[0], agreed[0], other, agreed[1]),
                _when(other, ends[1], agreed[1], one, agreed[0]),
            )
            yield Stretch(strand, one, other, agreed, at)
        before = i, j


def _when(
    mine: tuple[Deed, ...],
    end: float | None,
    agreed: float,
    others: tuple[Deed, ...],
    their_agreed: float,
) -> float:
    """When a run came there; as long after the two agreed as the other where it did nothing."""
    if mine:
        return mine[0].t
    would = round(agreed + others[0].t - their_agreed, 6)
    return would if end is None else min(would, end)


def _at_once(stretches: list[Stretch]) -> Iterator[list[Stretch]]:
    """Those together that began at one moment of either run."""
    group = list(range(len(stretches)))
    first_at: dict[tuple[int, float], int] = {}

    def root(number: int) -> int:
        while group[number] != number:
            group[number] = number = group[group[number]]
        return number

    for number, stretch in enumerate(stretches):
        for run, deeds in enumerate((stretch.first, stretch.second)):
            if deeds:
                group[root(number)] = root(first_at.setdefault((run, deeds[0].t), number))
    gathered: dict[int, list[Stretch]] = {}
    for number, stretch in enumerate(stretches):
        gathered.setdefault(root(number), []).append(stretch)
    yield from gathered.values()


def _joined(stretches: list[Stretch]) -> Difference:
    ones = [one.at[0] for one in stretches if one.first] or [one.at[0] for one in stretches]
    others = [one.at[1] for one in stretches if one.second] or [one.at[1] for one in stretches]
    agreed = max((one.agreed for one in stretches), key=lambda one: (sum(one), min(one)))
    return Difference((min(ones), min(others)), agreed, tuple(stretches))


# -- putting two strands beside one another ------------------------------------------------


def matched(a: Sequence[str], b: Sequence[str], patience: int = PATIENCE) -> list[tuple[int, int]]:
    """Pairs of places with the same in both, in order: as many as can be, as far as ``patience``
    reaches. The other way round they are the same pairs, turned.
    """
    if list(a) > list(b):
        return [(i, j) for j, i in matched(b, a, patience)]
    found: list[tuple[int, int]] = []
    i = j = 0
    while i < len(a) and j < len(b):
        pairs, i, j = _walk(a, b, i, j, patience)
        found += pairs
    return found


def _walk(
    a: Sequence[str], b: Sequence[str], i: int, j: int, patience: int
) -> tuple[list[tuple[int, int]], int, int]:
    """The pairs from there on, and where it came to: the ends, or as far as it has patience for.

    reached: by diagonal (how many deeds of ``a`` were left out more than of ``b``), how far into
    ``a`` so many left out can lead.
    """
    ends = len(a) - i, len(b) - j
    steps: list[dict[int, int]] = []
    best = far = 0
    for edits in range(min(sum(ends), patience) + 1):
        reached: dict[int, int] = {}
        for k in range(-edits, edits + 1, 2):
            came = _enter(steps, k, ends)
            if came is None:
                continue
            x = came[0]
            while x < ends[0] and x - k < ends[1] and a[i + x] == b[j + x - k]:
                x += 1
            reached[k] = x
            if 2 * x - k > far:
                best, far = k, 2 * x - k
        steps.append(reached)
        if far == sum(ends):
            break
    # One more left out always leads further, so it was the last step that came furthest.
    x = steps[-1][best]
    return _back(steps, best, ends, (i, j)), i + x, j + x - best


def _enter(
    steps: Sequence[dict[int, int]], k: int, ends: tuple[int, int]
) -> tuple[int, int] | None:
    """How far into ``a`` one more left out leads on the diagonal ``k``, and from which; None where
    that is past an end.
    """
    if not steps:
        return 0, 0
    of_a, of_b = steps[-1].get(k - 1), steps[-1].get(k + 1)
    found = []
    if of_a is not None and of_a < ends[0]:
        found.append((of_a + 1, k - 1))
    if of_b is not None and of_b - k <= ends[1]:
        found.append((of_b, k + 1))
    return max(found, default=None)


def _back(
    steps: list[dict[int, int]], k: int, ends: tuple[int, int], start: tuple[int, int]
) -> list[tuple[int, int]]:
    """The pairs on the way that led to the diagonal ``k`` of the last step."""
    pairs = []
    while steps:
        x = steps.pop()[k]
        came = _enter(steps, k, ends)
        assert came is not None
        pairs += [(start[0] + n, start[1] + n - k) for n in range(x - 1, came[0] - 1, -1)]
        k = came[1]
    return pairs[::-1]
