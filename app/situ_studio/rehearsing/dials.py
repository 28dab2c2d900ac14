"""The data that a rehearsal can turn: what the script observes, modules bring, conditions ask for.

No Qt. A dial says what kind of value a tag has, and between which bounds it is interesting.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, Literal

from msgspec import Struct

from situ.document import rbd
from situ.document.condition import Group, Test
from situ.document.names import is_reserved, is_tag
from situ.document.project import Project
from situ.document.values import is_number, read

Kind = Literal["boolean", "number", "other"]
_COMPARED = ("above", "below", "atleast", "atmost")
_BOUNDS = {"deg": (-180.0, 180.0), "%": (0.0, 100.0)}
"""Of units that say themselves how far they go."""


class Dial(Struct, frozen=True):
    """What can be set of one tag. low, high: of a number; values: what tests ask for otherwise."""

    tag: str
    kind: Kind
    unit: str = ""
    low: float = 0.0
    high: float = 1.0
    values: tuple[Any, ...] = ()


def dials(project: Project) -> tuple[Dial, ...]:
    """Those of a project: observed data first, then what modules bring, then what else is asked
    for and no application sets itself.
    """
    tested: dict[str, list[Test]] = {}
    for test in _tests(project):
        tested.setdefault(test.tag, []).append(test)
    known: dict[str, tuple[str | None, str | None]] = {}
    observed = project.spds.observe if project.spds is not None else ()
    for one in observed:
        known.setdefault(one.tag, (one.type, one.unit))
    for module in project.modules.modules if project.modules is not None else ():
        for brought in module.provides:
            if brought.data is not None:
                known.setdefault(brought.data, (brought.type, brought.unit))
    own = _written(project)
    for tag in tested:
        if (
            not any(tag == one or tag.startswith(f"{one}.") for one in own)
            and is_tag(tag)
            and not is_reserved(tag)
        ):
            known.setdefault(tag, (None, None))
    return tuple(_dial(tag, kind, unit, tested.get(tag, [])) for tag, (kind, unit) in known.items())


def _dial(tag: str, kind: str | None, unit: str | None, tests: list[Test]) -> Dial:
    values = [read(test.value) for test in tests if test.test in ("is", "isnot")]
    compared = [read(test.value) for test in tests if test.test in _COMPARED]
    numbers = [float(value) for value in (*compared, *values) if is_number(value)]
    if kind == "boolean" or (kind is None and values and all(isinstance(v, bool) for v in values)):
        return Dial(tag, "boolean")
    if kind == "number" or (kind is None and numbers):
        low, high = _BOUNDS.get(unit or "", _around(numbers))
        return Dial(tag, "number", unit or "", min(low, *numbers, low), max(high, *numbers, high))
    return Dial(tag, "other", unit or "", values=tuple(dict.fromkeys(map(_text, values))))


def _around(numbers: list[float]) -> tuple[float, float]:
    """Bounds in which all of these can be passed either way."""
    if not numbers:
        return 0.0, 10.0
    least, most = min(0.0, *numbers), max(0.0, *numbers)
    return (2 * least, 2 * most) if (least, most) != (0.0, 0.0) else (-1.0, 1.0)


def _text(value: Any) -> str:
    return value if isinstance(value, str) else str(value)


def _tests(project: Project) -> Iterator[Test]:
    if project.spds is not None:
        for situation in project.spds.situations:
            for condition in (situation.condition, situation.until):
                if condition is not None:
                    yield from _inside(condition.children)
    for application in project.flows.values():
        always = application.always.events if application.always is not None else ()
        for event in (*always, *(e for state in application.states for e in state.events)):
            if event.when is not None:
                yield from _inside(event.when.children)


def _inside(children: Iterable[Test | Group]) -> Iterator[Test]:
    for child in children:
        if isinstance(child, Group):
            yield from _inside(child.children)
        else:
            yield child


def _written(project: Project) -> set[str]:
    """The tags that applications set themselves."""
    found: set[str] = set()
    for application in project.flows.values():
        for state in application.states:
            actions: list[rbd.Action] = list(state.actions)
            for event in state.events:
                actions += event.actions
            for action in actions:
                if isinstance(action, rbd.Set | rbd.Add | rbd.Append | rbd.Take):
                    found.add(action.tag)
                elif isinstance(action, rbd.Service):
                    found.update(result.tag for result in action.results)
            for part in state.screen.components if state.screen is not None else ():
                tag = getattr(part, "tag", None)
                if tag is not None:
                    found.add(tag)
    return found
