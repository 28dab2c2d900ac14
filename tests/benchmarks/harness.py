"""Ours and what stands beside it, measured in turns, so that only their ratio tells.

A machine is never twice the same: other programs run, its cores go to sleep. So a bench
measures all of its samples in every round, one after the other, in an order that turns with
the rounds; a row compares two of them. pyperf and pytest-benchmark measure one thing to its
end and then the next, which is why neither is used.
"""

from __future__ import annotations

import contextlib
import gc
import importlib
import math
import statistics
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal

from msgspec import Struct, field

ROUNDS = 11
"""Of every bench, unless told otherwise; never fewer than ``FEWEST``."""
FEWEST = 5
LONG = 0.05
"""Seconds that one sample takes, or as long as one single thing takes."""

Sample = Callable[[], float]
"""Measures once: the figure in the row's unit."""

Clock = Callable[[], float]
"""Seconds, from any moment on."""

WALL: Clock = time.perf_counter
CPU: Clock = time.process_time
"""For what only computes, in this process: others that run meanwhile do not count."""


class Missing(Exception):
    """A bench can not be measured here; says what is missing."""


class Goal(Struct, frozen=True):
    """A bound on ``of``: the ratio of ours to beside, ours alone, or ours less beside (``more``).

    least: ours is to be at least that (a rate), else at most.
    """

    bound: float
    of: Literal["ratio", "ours", "more"] = "ratio"
    least: bool = False

    def met(self, ours: float, beside: float) -> bool:
        reached = {"ratio": ours / beside, "ours": ours, "more": ours - beside}[self.of]
        return reached >= self.bound if self.least else reached <= self.bound

    def told(self, unit: str) -> str:
        sign = "≥" if self.least else "≤"
        plus = "beside + " if self.of == "more" else ""
        return f"{sign} {plus}{_number(self.bound)} {'×' if self.of == 'ratio' else unit}"


class Row(Struct, frozen=True):
    """One line of the table: two samples of a bench, and what their ratio has to be.

    of: the figure of the project's goals that it is about. goal None: only told.
    """

    name: str
    of: str
    ours: str
    beside: str
    unit: str
    goal: Goal | None = None


class Bench(Struct, frozen=True):
    """Rows that are measured together. ``open`` sets up what is measured, by name of the sample;
    it may raise ``Missing``.
    """

    name: str
    rows: tuple[Row, ...]
    open: Callable[[], contextlib.AbstractContextManager[Mapping[str, Sample]]]


class Result(Struct, frozen=True):
    """A row measured. ours, beside: medians over the rounds, in ``unit``; ratio: of these two.

    min, median, max: of the ratios of the single rounds. goal, met: None where there is none.
    against: what stands beside.
    """

    name: str
    ours: float
    beside: float
    ratio: float
    goal: str | None
    met: bool | None
    minimum: float = field(name="min")
    median: float
    maximum: float = field(name="max")
    rounds: int
    unit: str
    against: str


def measure(bench: Bench, rounds: int = ROUNDS) -> list[Result]:
    """Every row of the bench; raises ``Missing``, and ValueError for fewer than ``FEWEST`` rounds.

    Each sample is measured once more before the first round, and that is thrown away.
    """
    if rounds < FEWEST:
        raise ValueError(f"{rounds} rounds tell too little: at least {FEWEST} are needed")
    with bench.open() as samples:
        names = list(samples)
        measured: dict[str, list[float]] = {name: [] for name in names}
        for name in names:
            samples[name]()
        for turn in range(rounds):
            first = turn % len(names)
            gc.collect()
            for name in names[first:] + names[:first]:
                measured[name].append(samples[name]())
    return [_result(row, measured[row.ours], measured[row.beside]) for row in bench.rows]


def _result(row: Row, ours: Sequence[float], beside: Sequence[float]) -> Result:
    ratios = [one / other for one, other in zip(ours, beside, strict=True)]
    middle, other = statistics.median(ours), statistics.median(beside)
    return Result(
        name=row.name,
        ours=middle,
        beside=other,
        ratio=middle / other,
        goal=None if row.goal is None else row.goal.told(row.unit),
        met=None if row.goal is None else row.goal.met(middle, other),
        minimum=min(ratios),
        median=statistics.median(ratios),
        maximum=max(ratios),
        rounds=len(ratios),
        unit=row.unit,
        against=row.beside,
    )


def each(work: Callable[[int], object], clock: Clock, unit: float = 1e-6) -> Sample:
    """How long one thing takes where ``work`` does as many as it is told.

    So many that they take about ``LONG`` are measured at once, in every round as many.
    unit: in seconds; a figure is in µs unless told otherwise.
    """
    count = 0

    def sample() -> float:
        nonlocal count
        count = count or _enough(work, clock)
        return _took(work, count, clock) / count / unit

    return sample


def rate(work: Callable[[int], object], clock: Clock, many: int = 1) -> Sample:
    """How many thousand things are done a second. many: what ``work`` does at a time."""
    one = each(work, clock, unit=1e-3)
    return lambda: many / one()


def _took(work: Callable[[int], object], count: int, clock: Clock) -> float:
    began = clock()
    work(count)
    return clock() - began


def _enough(work: Callable[[int], object], clock: Clock) -> int:
    count = 1
    while (took := _took(work, count, clock)) < LONG / 10:
        count *= 2
    return math.ceil(count * LONG / took)


def library(name: str) -> Any:
    """A module of the extra ``bench``; raises ``Missing`` where it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError:
        raise Missing(f"{name} is not installed; make bench installs it") from None


def table(results: Iterable[Result]) -> str:
    """The results as a Markdown table."""
    lines = [
        ["what", "ours", "beside", "ratio (min to max)", "goal", "met"],
        ["---", "--:", "--:", "--:", "---", "---"],
    ]
    for one in results:
        spread = f"{_number(one.minimum)} to {_number(one.maximum)}"
        lines.append(
            [
                one.name,
                f"{_number(one.ours)} {one.unit}",
                f"{_number(one.beside)} {one.unit}: {one.against}",
                f"{_number(one.ratio)} ({spread})",
                one.goal or "",
                {True: "yes", False: "no", None: ""}[one.met],
            ]
        )
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _number(value: float) -> str:
    """Three figures, and never an exponent."""
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"
