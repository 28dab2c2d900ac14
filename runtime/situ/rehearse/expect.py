"""Expectations of a scenario, judged against a trace (formats.md, *Scenarios*)."""

from __future__ import annotations

from typing import Any

import msgspec
from msgspec import Struct

from situ.decide.trace import TraceEvent, to_fields
from situ.decide.values import equal


class Expect(Struct, frozen=True):
    """Some event after the one last found has these fields; nested ones compare like ``is``."""

    fields: dict[str, Any]


class Failure(Struct, frozen=True):
    """An expectation that no event fulfilled. number: its line; near: the closest event."""

    number: int
    at: int
    fields: dict[str, Any]
    near: dict[str, Any] | None

    def __str__(self) -> str:
        wanted = msgspec.json.encode(self.fields).decode()
        came = "nothing like it came"
        if self.near is not None:
            came = f"closest was {msgspec.json.encode(self.near).decode()}"
        return f"line {self.number}, at {self.at / 1e6:g} s: expected {wanted}; {came}"


class Expectations:
    """Judges expectations one after the other over a trace that grows."""

    def __init__(self) -> None:
        self._events: list[dict[str, Any]] = []
        self._from = 0
        self._waiting: list[tuple[int, int, Expect]] = []
        self.failures: list[Failure] = []
        self.fulfilled = 0

    def add(self, events: list[TraceEvent]) -> None:
        self._events += [to_fields(event) for event in events]

    def expect(self, number: int, at: int, expected: Expect) -> None:
        self._waiting.append((number, at, expected))

    def judge(self) -> None:
        """The moment of those that wait is over."""
        for number, at, expected in self._waiting:
            for place in range(self._from, len(self._events)):
                if fits(expected.fields, self._events[place]):
                    self._from = place + 1
                    self.fulfilled += 1
                    break
            else:
                near = self._nearest(expected.fields)
                self.failures.append(Failure(number, at, expected.fields, near))
        self._waiting.clear()
        # Nothing looks at them any more: a run may last for days.
        del self._events[: self._from]
        self._from = 0

    def _nearest(self, fields: dict[str, Any]) -> dict[str, Any] | None:
        kind = [e for e in self._events[self._from :] if e["kind"] == fields.get("kind")]
        # Of those that agree alike the last, which is nearest in time.
        return max(reversed(kind), key=lambda e: _agreement(fields, e), default=None)


def fits(fields: dict[str, Any], event: dict[str, Any]) -> bool:
    """Whether the event has all these fields."""
    return all(key in event and equal(value, event[key]) for key, value in fields.items())


def _agreement(fields: dict[str, Any], event: dict[str, Any]) -> int:
    return sum(key in event and equal(value, event[key]) for key, value in fields.items())
