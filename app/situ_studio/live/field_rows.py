"""What was counted in the field as rows of a table: in words, and how they are sorted. No Qt."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from situ.rehearse.usage import Row as Used
from situ_studio.edits.words import state_called
from situ_studio.panels.table import Row
from situ_studio.wording.language import tr
from situ_studio.wording.lasting import lasting

_VALUES: tuple[Callable[[Used], Any], ...] = (
    lambda one: (one.application, _numbers(one.state)),
    lambda one: one.place,
    lambda one: one.times,
    lambda one: one.visits,
    lambda one: one.percent,
    lambda one: one.seconds,
    lambda one: one.mean,
    lambda one: one.timeouts,
    lambda one: one.gave_up,
)
NUMBERS = range(2, len(_VALUES))
"""The columns of numbers: the largest come first where they are sorted."""


def titles() -> tuple[str, ...]:
    return (
        tr("State"),
        tr("Place"),
        tr("Times"),
        tr("Visits"),
        tr("Of all visits"),
        tr("In all"),
        tr("Each time"),
        tr("Time ran out"),
        tr("Gave up"),
    )


def tips() -> tuple[str, ...]:
    """What each column says, for its head."""
    return (
        tr("The application and its state."),
        tr("Where the robot was when it began."),
        tr("How often the robot came to the state."),
        tr("In how many visits; one lasts from leaving the start state until it is back there."),
        tr("In how many of all visits at that place."),
        tr("How long the robot was there in all, without the time in which it was suspended."),
        tr("How long it was there each time."),
        tr("How often the time of the state ran out."),
        tr("How often the time ran out in a visit while the screen had something to be touched."),
    )


def by_column(used: Sequence[Used], column: int, down: bool) -> list[Used]:
    """Sorted by one column; those that are equal there stay in their order."""
    return sorted(used, key=_VALUES[column], reverse=down)


def rows(used: Sequence[Used]) -> list[Row]:
    """As the table shows them; keys are places in ``used``."""
    return [Row(str(n), cells(one)) for n, one in enumerate(used)]


def cells(one: Used, told: Callable[[float], str] = lasting) -> tuple[str, ...]:
    """told: a time in words."""
    named = tr("{0}, {1}").format(one.application, state_called(one.state, one.name))
    if not one.times:
        return (named, one.place, tr("never"), *("" for _ in NUMBERS[1:]))
    return (
        named,
        one.place,
        str(one.times),
        str(one.visits),
        tr("{0} %").format(f"{one.percent:g}"),
        told(one.seconds),
        told(one.mean),
        str(one.timeouts or ""),
        str(one.gave_up or ""),
    )


def _numbers(state: str) -> list[tuple[int, str]]:
    """2 before 10, also in parts (``5/2``)."""
    return [(int(no), "") if no.isdecimal() else (0, no) for no in state.split("/")]
