"""What the running robot does to a drawing: highlights that live in the view only."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from msgspec import Struct, field


class Taken(Struct, frozen=True):
    """A transition taken lately. exit: an event's position or ``timeout``; age: seconds since."""

    state: str
    exit: str
    age: float = 0.0


class LiveView(Struct, frozen=True):
    """An application at one moment of the trace; states go by number.

    active: where the application is. suspended: active ones without their resources.
    entered: seconds since each active state was entered. counts, times: how often
    each was entered, and seconds spent there. gave_up: how often its time ran out.
    taken: the latest first.
    transitions: (state, exit) to how often. breakpoints: states that have some, on themselves or
    on a transition. paused: active ones that an operator, or a breakpoint, has stopped.
    since: what the clock said when the counting began; "": at the robot's start.
    """

    active: frozenset[str] = frozenset()
    suspended: frozenset[str] = frozenset()
    entered: Mapping[str, float] = field(default_factory=dict)
    counts: Mapping[str, int] = field(default_factory=dict)
    times: Mapping[str, float] = field(default_factory=dict)
    gave_up: Mapping[str, int] = field(default_factory=dict)
    taken: tuple[Taken, ...] = ()
    transitions: Mapping[tuple[str, str], int] = field(default_factory=dict)
    breakpoints: frozenset[str] = frozenset()
    paused: frozenset[str] = frozenset()
    since: str = ""


def changes(old: LiveView, new: LiveView) -> tuple[set[str], set[tuple[str, str]]]:
    """The states whose cards, and the exits whose pipes, look otherwise at the second moment."""
    states = set(old.active | new.active)
    states |= {no for no in {**old.counts, **new.counts} if _differ(old.counts, new.counts, no)}
    ways = {**old.transitions, **new.transitions}
    counted_anew = {way for way in ways if _differ(old.transitions, new.transitions, way)}
    # That none of them was taken stands beside the exits, on the card.
    states |= {no for no, _ in counted_anew}
    exits = {(t.state, t.exit) for t in (*old.taken, *new.taken)}
    return states, exits | counted_anew


def _differ(old: Mapping[Any, Any], new: Mapping[Any, Any], key: Any) -> bool:
    return bool(old.get(key) != new.get(key))


class LiveScript(Struct, frozen=True):
    """A script at one moment: the current situation, what holds, who asks and who holds what.

    holds: situations whose condition holds. authority: resource to module.
    asking: module to the resources it asks for. values: tag to value. breakpoints: situations that
    have one. counts, times: how often each situation was current, and seconds in it.
    """

    situation: str | None = None
    holds: frozenset[str] = frozenset()
    authority: Mapping[str, str | None] = field(default_factory=dict)
    asking: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    values: Mapping[str, Any] = field(default_factory=dict)
    breakpoints: frozenset[str] = frozenset()
    counts: Mapping[str, int] = field(default_factory=dict)
    times: Mapping[str, float] = field(default_factory=dict)


FADE = 12.0
"""Seconds after which a taken transition is no longer shown."""


def strength(rank: int, age: float) -> float:
    """Opacity of a taken transition, the latest being rank 0; 0 where it is not shown."""
    if rank > 2 or age >= FADE:
        return 0.0
    return (1.0, 0.6, 0.32)[rank]
