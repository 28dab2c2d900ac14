"""The data that a rehearsal can turn: what the script observes, modules bring, conditions ask for.

No Qt. A dial says what kind of value a tag has, and between which bounds it is interesting.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from msgspec import Struct

from situ.decide.values import in_text
from situ.document import rbd
from situ.document.analysis_data import actions, events, screens, tested
from situ.document.condition import Condition, Test
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
    return Dial(tag, "other", unit or "", values=tuple(dict.fromkeys(map(in_text, values))))


def _around(numbers: list[float]) -> tuple[float, float]:
    """Bounds in which all of these can be passed either way."""
    if not numbers:
        return 0.0, 10.0
    least, most = min(0.0, *numbers), max(0.0, *numbers)
    return (2 * least, 2 * most) if (least, most) != (0.0, 0.0) else (-1.0, 1.0)


def _tests(project: Project) -> Iterator[Test]:
    conditions: list[Condition | None] = []
    if project.spds is not None:
        for situation in project.spds.situations:
            conditions += (situation.condition, situation.until)
    for application in project.flows.values():
        conditions += (event.when for event, _ in events(application))
    for condition in conditions:
        if condition is not None:
            yield from (test for test, _ in tested(condition, ()))


def _written(project: Project) -> set[str]:
    """The tags that applications set themselves."""
    found: set[str] = set()
    for application in project.flows.values():
        for action in actions(application):
            if isinstance(action, rbd.Set | rbd.Add | rbd.Append | rbd.Take):
                found.add(action.tag)
            elif isinstance(action, rbd.Service):
                found.update(result.tag for result in action.results)
        for screen, _ in screens(application):
            tags = (getattr(component, "tag", None) for component in screen.components)
            found.update(tag for tag in tags if tag is not None)
    return found
