"""A run as it can be looked at afterwards: its trace, step by step, and what no trace tells."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable
from heapq import merge
from io import BytesIO
from itertools import groupby
from pathlib import Path
from typing import Any

import msgspec
from msgspec import Struct, field

from situ.decide.clock import CLOCK
from situ.decide.effects import AnyEffect, Changed
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent, to_fields
from situ.decide.world import untraced
from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse import recorded
from situ.rehearse.clock import Given, Hidden
from situ.rehearse.expect import Expectations
from situ.rehearse.scenario import Line
from situ.rehearse.simulate import simulate

Fields = dict[str, Any]
"""A trace event as it stands in a trace: ``kind``, ``seq``, ``t``, ``cause`` and its own."""


class Step(Struct):
    """One step: what the clock was set to before its events, these, what was kept after them."""

    events: list[Fields]
    before: list[Hidden] = field(default_factory=list)
    after: list[Hidden] = field(default_factory=list)

    @property
    def t(self) -> float:
        """Its time in seconds."""
        if self.events:
            return float(self.events[0]["t"])
        return next((hidden.t for hidden in (*self.before, *self.after)), 0.0)


class Recording(Struct):
    """The steps of a run. whole: what no trace tells is known too (it was simulated).

    end: the last moment that is known, in seconds: where the scenario ends, of a trace alone
    its last event.
    """

    steps: list[Step]
    whole: bool
    end: float = 0.0

    @property
    def events(self) -> list[Fields]:
        """The trace."""
        return [event for step in self.steps for event in step.events]

    @classmethod
    def of(cls, events: Iterable[Fields], clock: Iterable[Hidden] = ()) -> Recording:
        """From a trace alone, and from what is known of the writes of ``clock.…``, in order. Where
        its steps begin is guessed: with outside input, or later.
        """
        steps: list[Step] = []
        for event in events:
            if steps and event["cause"] is not None and steps[-1].events[0]["t"] == event["t"]:
                steps[-1].events.append(event)
            elif steps and event["t"] == 0 == steps[-1].events[0]["t"]:
                # The start is one step, though much of it has no cause.
                steps[-1].events.append(event)
            else:
                steps.append(Step([event]))
        steps = _with_clock(steps, clock)
        return cls(steps, whole=False, end=steps[-1].t if steps else 0.0)


def _with_clock(steps: list[Step], clock: Iterable[Hidden]) -> list[Step]:
    """The clock is set in steps of its own, before what happened then, at the start in that."""
    if not steps:
        return steps
    start, writes = steps[0], list(clock)
    later = bisect_right(writes, start.t, key=lambda one: one.t)
    start.before = writes[:later]
    set_ = [Step([], [*group]) for _, group in groupby(writes[later:], key=lambda one: one.t)]
    return [start, *merge(set_, steps[1:], key=lambda step: step.t)]


def record(
    project: Project, scenario: list[Line], seed: int = 0, auto_finish: float | None = None
) -> tuple[Recording, Expectations]:
    """Plays a scenario and keeps all of it. The project must have no errors."""
    steps: list[Step] = []
    kept: list[Hidden] = []

    def carry(effects: list[AnyEffect]) -> None:
        kept.extend(
            Hidden(one.time / SECOND, one.tag, one.value, one.writer)
            for one in effects
            if isinstance(one, Changed) and untraced(one.tag)
        )

    def tell(events: list[TraceEvent]) -> None:
        # The clock is set by an input, so before all that follows; the rest is kept by then.
        before = [one for one in kept if one.tag.startswith(CLOCK)]
        after = [one for one in kept if not one.tag.startswith(CLOCK)]
        kept.clear()
        steps.append(Step([to_fields(event) for event in events], before, after))

    verdict = simulate(project, scenario, seed, auto_finish, tell, carry)
    end = scenario[-1].at / SECOND if scenario else 0.0
    return Recording(steps, whole=True, end=end), verdict


def read_trace(path: str | Path) -> list[Fields]:
    """The events of a trace of JSON lines, or of a recording (MCAP).

    UsageError where it cannot be read or is no trace.
    """
    data = _data(path)
    lines: Iterable[bytes] = data.split(b"\n")
    if recorded.is_recording(data):
        found = recorded.pieces(BytesIO(data), str(path))
        lines = (piece.text for piece in found if isinstance(piece, recorded.Line))
    return _events(path, lines)


def read(path: str | Path) -> Recording:
    """A run from a trace of JSON lines, or from a recording (MCAP): that tells by its inputs where
    each step began and what the clock was set to, too, unless it is masked.

    UsageError where it cannot be read or is no trace.
    """
    data = _data(path)
    if not recorded.is_recording(data):
        return Recording.of(_events(path, data.split(b"\n")))
    lines: list[bytes] = []
    begins: list[tuple[int, list[Hidden]]] = []
    clock = Given()
    for piece in recorded.pieces(BytesIO(data), str(path)):
        if isinstance(piece, recorded.Line):
            lines.append(piece.text)
            continue
        before = clock.take(piece)
        if isinstance(piece, recorded.Taken):
            begins.append((len(lines), before))
    events = _events(path, lines)
    if not begins:
        return Recording.of(events)
    ends = [begin for begin, _ in begins[1:]] + [len(events)]
    steps = Recording.of(events[: begins[0][0]]).steps
    for (begin, before), end in zip(begins, ends, strict=True):
        if before or begin < end:
            steps.append(Step(events[begin:end], before))
    return Recording(steps, whole=False, end=steps[-1].t if steps else 0.0)


def _data(path: str | Path) -> bytes:
    try:
        return Path(path).read_bytes()
    except (OSError, ValueError) as error:
        raise UsageError(f"{path}: {getattr(error, 'strerror', None) or error}") from None


def _events(path: str | Path, lines: Iterable[bytes]) -> list[Fields]:
    events: list[Fields] = []
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            event = _line.decode(line)
            known = _KINDS.get(event.kind)
            if known is not None:
                known.decode(line)
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            raise UsageError(
                f"{path}:{number}: not an event of a trace: {error}; give what situ simulate "
                "or situ trace wrote"
            ) from None
        if events and event.seq <= events[-1]["seq"]:
            raise UsageError(
                f"{path}:{number}: seq {event.seq} after {events[-1]['seq']}: "
                "give the trace of one run"
            )
        events.append(msgspec.json.decode(line))
    return events


class _Line(Struct):
    """What every line of a trace has."""

    seq: int
    t: float
    kind: str
    cause: int | None


_line = msgspec.json.Decoder(_Line)
_KINDS = {
    str(kind.__struct_config__.tag): msgspec.json.Decoder(kind)
    for kind in TraceEvent.__subclasses__()
}
"""Those of the simulator; a live trace has some more."""
