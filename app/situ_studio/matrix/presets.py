"""The values that somebody asking *what if* may mean: from the tests of a script's conditions.

No Qt. The first one is what a click gives; it lets a test hold.
"""

from __future__ import annotations

import json
from typing import Any

from situ.decide.values import compile_test
from situ.document.condition import Test
from situ.document.spds import Spds
from situ.document.value_sets import constants
from situ.document.values import equal, is_number, read
from situ.rehearse.what_if import tests

_SAMPLES: dict[str | None, tuple[Any, ...]] = {
    "boolean": (True, False),
    "number": (0,),
    "text": ("…",),
    "list": ([], ["…"]),
    "object": ({},),
}
"""By type, what a value can be where no test says more."""


def presets(script: Spds) -> dict[str, tuple[Any, ...]]:
    """Every name that a condition looks at, in the order of ``observe``, then of the file, with
    the values that tell its tests apart; the first lets a test hold, if any does.
    """
    by_name: dict[str, list[Test]] = {}
    for test in tests(script):
        by_name.setdefault(test.tag, []).append(test)
    kinds = {observed.tag: observed.type for observed in script.observe}
    order = [tag for tag in kinds if tag in by_name]
    order += [tag for tag in by_name if tag not in kinds]
    return {tag: _values(by_name[tag], kinds.get(tag)) for tag in order}


def _values(several: list[Test], kind: str | None) -> tuple[Any, ...]:
    found: list[Any] = []
    for test in several:
        found += _near(test, kind)
    if kind == "boolean" or any(isinstance(one, bool) for one in found):
        found += [True, False]
    if not found:
        found += _SAMPLES.get(kind, (True,))
    distinct: list[Any] = []
    for one in found:
        if not any(type(one) is type(known) and equal(one, known) for known in distinct):
            distinct.append(one)
    holding = [one for one in distinct if any(_holds(test, one) for test in several)]
    return (*holding, *(one for one in distinct if one not in holding))


def _near(test: Test, kind: str | None) -> list[Any]:
    """The values that a test names, and for a bound one on either side."""
    if test.test in ("is", "isnot"):
        value = test.value if kind == "text" else read(test.value)
        return [value]
    found: list[Any] = []
    for value in constants(test):
        if test.test in ("above", "below", "atleast", "atmost") and is_number(value):
            step = 1 if float(value).is_integer() else abs(value) / 10 or 1
            below, above = _tidy(value - step), _tidy(value + step)
            found += [above, below] if test.test in ("above", "atleast") else [below, above]
        else:
            found.append(value)
    return found


def _tidy(value: float) -> float:
    return int(value) if float(value).is_integer() else float(f"{value:.6g}")


def _holds(test: Test, value: Any) -> bool:
    holds, _ = compile_test(test.test, test.value)
    return holds(value, lambda name: None)


def typed(text: str, kind: str | None) -> Any:
    """What somebody means who types a value: JSON, or text; None for nothing."""
    said = text.strip()
    if not said:
        return None
    return said if kind == "text" else read(said)


def short(value: Any) -> str:
    """A value on a chip: true is said by the name alone."""
    if value is True:
        return ""
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 16 else f"{text[:15]}…"
