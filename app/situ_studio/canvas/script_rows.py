"""A condition as lines: its tests, and its groups with what is in them further in. Pure."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from situ.document import words
from situ.document.condition import Condition, Group, Test
from situ_studio.canvas.script_faces import Row
from situ_studio.kinds import GROUPS
from situ_studio.wording.language import say, translated

_NAMES = dict(GROUPS)


def rows(condition: Condition | None) -> tuple[Row, ...]:
    """One for each test and group. A group that is all of the condition is not among them: the
    whole condition is joined as it says (``joint``)."""
    found: list[Row] = []

    def walk(children: Sequence[Test | Group], where: tuple[str, ...], depth: int) -> None:
        for index, child in enumerate(children):
            path = (*where, str(index))
            at = "/".join(path)
            if isinstance(child, Test):
                found.append(Row(at, words.predicate(child, say), depth, tag=child.tag))
            else:
                found.append(Row(at, translated(_NAMES[child.kind]), depth, child.kind))
                walk(child.children, path, depth + 1)

    if condition is not None:
        whole = whole_group(condition)
        if whole is not None:
            walk(whole.children, ("0",), 0)
        else:
            walk(condition.children, (), 0)
    return tuple(found)


def whole_group(condition: Condition) -> Group | None:
    """The group that is all that a condition has, where one is and has anything in it."""
    only = condition.children[0] if len(condition.children) == 1 else None
    return only if isinstance(only, Group) and only.children else None


def joint(condition: Condition | None) -> str:
    """What joins the lines: all, any, none; "" where there is nothing to join."""
    if condition is None:
        return ""
    whole = whole_group(condition)
    if whole is not None:
        return whole.kind
    return "all" if len(condition.children) > 1 else ""


def tests(condition: Condition | None) -> list[tuple[Test, tuple[str, ...]]]:
    """Every test with the rest of its place below the condition."""
    found: list[tuple[Test, tuple[str, ...]]] = []

    def walk(children: Sequence[Test | Group], where: tuple[str, ...]) -> None:
        for index, child in enumerate(children):
            here = (*where, str(index))
            if isinstance(child, Test):
                found.append((child, here))
            else:
                walk(child.children, here)

    if condition is not None:
        walk(condition.children, ())
    return found


class Shape(Struct, frozen=True):
    """All that a picture asks of a condition."""

    rows: tuple[Row, ...] = ()
    joint: str = ""
    whole: bool = False
    tests: tuple[tuple[Test, tuple[str, ...]], ...] = ()


class Shapes:
    """Of the conditions of one script after the other: what is still there is not made anew."""

    def __init__(self) -> None:
        self._made: dict[int, tuple[Condition, Shape]] = {}
        self._last: dict[int, tuple[Condition, Shape]] = {}

    def begin(self) -> None:
        """Another script: what the one before did not have is forgotten."""
        self._last, self._made = self._made, {}

    def of(self, condition: Condition | None) -> Shape:
        if condition is None:
            return NO_SHAPE
        # A condition that is kept here keeps its number.
        known = self._made.get(id(condition)) or self._last.get(id(condition))
        if known is None:
            known = condition, _shape(condition)
        self._made[id(condition)] = known
        return known[1]


NO_SHAPE = Shape()


def _shape(condition: Condition) -> Shape:
    return Shape(
        rows(condition),
        joint(condition),
        whole_group(condition) is not None,
        tuple(tests(condition)),
    )
