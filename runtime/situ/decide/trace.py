"""The trace: one event a Struct, one JSON object a line (formats.md, *Trace*).

``seq`` counts 1, 2, 3 … without a gap per runtime, ``t`` is in seconds, ``cause``
is the seq of the event that caused it (smaller), None for outside input and the
start. Fields that only some events of a kind have are ``UNSET`` elsewhere and
then not written.
"""

from __future__ import annotations

from typing import Any

import msgspec
from msgspec import UNSET, Struct, UnsetType, field


class TraceEvent(Struct, frozen=True, gc=False, tag_field="kind", tag=str.lower):
    """What all events have. Values are trees, so the collector need not look at them."""

    seq: int
    t: float
    cause: int | None


class Data(TraceEvent, frozen=True):
    tag: str
    value: Any
    writer: str
    version: int


class Condition(TraceEvent, frozen=True):
    situation: str
    holds: bool


class Situation(TraceEvent, frozen=True):
    source: str | None = field(name="from")
    to: str | None


class Acquire(TraceEvent, frozen=True):
    """resources: all that it now asks for, sorted; optional: those it can do without."""

    module: str
    resources: tuple[str, ...]
    optional: tuple[str, ...] | UnsetType = UNSET


class Abandon(TraceEvent, frozen=True):
    """resources: those given back, sorted."""

    module: str
    resources: tuple[str, ...]


class Lost(TraceEvent, frozen=True):
    """resources: those it had asked for, sorted."""

    module: str
    resources: tuple[str, ...]


class Connected(TraceEvent, frozen=True):
    module: str
    resources: tuple[str, ...]


class Authority(TraceEvent, frozen=True):
    resource: str
    source: str | None = field(name="from")
    to: str | None


class Mapping(TraceEvent, frozen=True):
    """The value at ``robot/<resource>`` changed; module: who holds it."""

    resource: str
    module: str | None
    value: Any


class Event(TraceEvent, frozen=True):
    """writer: the operator who raised it."""

    application: str
    name: str
    writer: str | UnsetType = UNSET


class Ignored(TraceEvent, frozen=True):
    """reason: ``suspended``, ``guard`` or ``unexpected``."""

    application: str
    name: str
    reason: str


class Exit(TraceEvent, frozen=True):
    application: str
    state: str


class Enter(TraceEvent, frozen=True):
    application: str
    state: str


class Transition(TraceEvent, frozen=True):
    """event: None for a timeout (then ``timeout`` is true), for an unnamed event, and where an
    operator sent the application there (then ``writer`` is who).
    """

    application: str
    source: str = field(name="from")
    to: str
    event: str | None
    timeout: bool | UnsetType = UNSET
    writer: str | UnsetType = UNSET


class Screen(TraceEvent, frozen=True):
    """components: resolved, in document order, those of ``always`` last."""

    application: str
    state: str
    components: list[dict[str, Any]]
    background: str | UnsetType = UNSET


class Action(TraceEvent, frozen=True):
    """An action begins.

    name: a service's name, a robot's command, a launch's program, a movie's id.
    """

    application: str
    state: str
    action: str
    name: str | None
    text: str | UnsetType = UNSET
    lang: str | UnsetType | None = UNSET
    resource: str | UnsetType = UNSET
    command: str | UnsetType = UNSET
    params: dict[str, Any] | UnsetType = UNSET
    method: str | UnsetType = UNSET
    url: str | UnsetType = UNSET
    topic: str | UnsetType = UNSET
    program: str | UnsetType = UNSET
    src: str | UnsetType = UNSET
    source: str | UnsetType = field(name="from", default=UNSET)
    tag: str | UnsetType = UNSET
    value: Any = UNSET


class Finished(TraceEvent, frozen=True):
    """``result`` where it ended well, ``error`` where it did not."""

    application: str
    action: str
    name: str | None
    ok: bool
    result: Any = UNSET
    error: str | UnsetType | None = UNSET


class Cancelled(TraceEvent, frozen=True):
    application: str
    action: str
    name: str | None


class Suspend(TraceEvent, frozen=True):
    application: str
    missing: tuple[str, ...]


class Resume(TraceEvent, frozen=True):
    application: str
    missing: tuple[str, ...]


class Paused(TraceEvent, frozen=True):
    """breakpoint: the id of that which paused it; None where the ``writer`` did."""

    application: str
    state: str
    breakpoint: int | None
    writer: str | UnsetType = UNSET


class Resumed(TraceEvent, frozen=True):
    """breakpoint: that at which it had paused, or None. writer: who let it go on."""

    application: str
    state: str
    breakpoint: int | None
    writer: str


class Deployed(TraceEvent, frozen=True):
    """Another version runs from here on. files: the names of those that changed, sorted."""

    version: int
    files: tuple[str, ...]
    writer: str


class Warned(TraceEvent, frozen=True, tag="warning"):
    message: str
    where: str


class Failed(TraceEvent, frozen=True, tag="error"):
    message: str
    where: str


def to_line(event: TraceEvent) -> bytes:
    """The event as one line of JSON, with its newline; the same event gives the same bytes."""
    return _encoder.encode(event) + b"\n"


def to_fields(event: TraceEvent) -> dict[str, Any]:
    """The event as the plain object that stands in a trace, ``kind`` included."""
    # By way of JSON: to_builtins would leave tuples, which equal no list of a scenario.
    fields = msgspec.json.decode(_encoder.encode(event))
    assert isinstance(fields, dict)
    return fields


_encoder = msgspec.json.Encoder()
