"""Reasons why something did not happen, as values and in plain words."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Literal

from msgspec import Struct, field

from situ.rehearse.past import Judged
from situ.rehearse.recording import Fields

Code = Literal[
    "input", "guard", "earlier", "suspended", "back", "timeout", "elsewhere", "no-way", "condition",
    "order", "until", "kept", "spent", "request", "priority", "resources", "command", "wait",
    "voice", "optional", "livelock", "already", "note",
]  # fmt: skip


class Reason(Struct, frozen=True, kw_only=True):
    """One thing that stood in the way.

    code: what kind of thing. seq: the event of the trace that tells of it. values: names of
    the blackboard to their values then. below: what stood in the way of that in turn.
    """

    code: Code
    text: str
    seq: int | None = None
    values: dict[str, Any] = field(default_factory=dict)
    below: tuple[Reason, ...] = ()


class Answer(Struct, frozen=True, kw_only=True):
    """Why ``wanted`` did not happen at ``at`` seconds.

    happened: the event, where it did happen at that moment. Then, and only then, reasons
    may be empty. ends: where the recording ends, in seconds, if that is before ``at``: the
    reasons are true if nothing happened since.
    """

    wanted: dict[str, Any]
    at: float
    happened: Fields | None = None
    reasons: tuple[Reason, ...] = ()
    ends: float | None = None


def not_held(judged: Iterable[Judged]) -> tuple[list[str], dict[str, Any]]:
    """What of a condition did not hold, test by test, and the values that its tests looked at."""
    said: list[str] = []
    values: dict[str, Any] = {}
    for one in judged:
        _values(one, values)
        if not one.holds:
            said += _failing(one)
    return said, values


def _failing(judged: Judged) -> list[str]:
    group = judged.kind
    if group is None:
        return [judged.text]
    if group == "all":
        return [text for part in judged.parts if not part.holds for text in _failing(part)]
    if group == "any":
        inner = "; ".join(text for part in judged.parts for text in _failing(part))
        return [f"none of these held: {inner}"]
    return [f"this must not hold, and did: {part.text}" for part in judged.parts if part.holds]


def _values(judged: Judged, values: dict[str, Any]) -> None:
    if judged.name is not None:
        values[judged.name] = judged.value
    for part in judged.parts:
        _values(part, values)


def lines(reasons: Iterable[Reason], indent: str = "") -> list[str]:
    """The reasons as lines, those below indented."""
    found = []
    for reason in reasons:
        seq = f"  (#{reason.seq})" if reason.seq is not None else ""
        found.append(f"{indent}- {reason.text}{seq}")
        found += lines(reason.below, indent + "  ")
    return found
