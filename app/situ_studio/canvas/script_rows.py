"""A condition as lines: its tests, and its groups with what is in them further in. Pure."""

from __future__ import annotations

from collections.abc import Sequence

from situ.document import words
from situ.document.condition import Condition, Group, Test
from situ_studio.canvas.script_faces import Row
from situ_studio.edit import Place
from situ_studio.kinds import GROUPS
from situ_studio.language import say, translated

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


def holder(place: Place) -> Place:
    """Where a place of a test or a group stands: the group, or the condition itself."""
    return place[:-1] if len(place) > 3 else place
