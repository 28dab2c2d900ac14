"""One message to bytes and back: ours, msgspec alone, and the standard library's json."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import msgspec
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each

from situ.blackboard import notices, protocol, topics, wire

VALUE = "x" * 100
"""What is set in all benches of the wire: a text of 100 bytes."""


class _Bare(msgspec.Struct, frozen=True, tag_field="do", tag="set"):
    id: int
    tags: dict[str, Any]


@contextlib.contextmanager
def _messages() -> Iterator[Mapping[str, Sample]]:
    request = protocol.Set(id=7, tags={"bench.there": VALUE})
    change = notices.Change(tag="bench.there", value=VALUE, version=7, writer="one", time=7)
    topic = topics.change("bench.there")
    bare, as_found = _Bare(7, {"bench.there": VALUE}), msgspec.to_builtins(request)
    encoder, decoder = msgspec.json.Encoder(), msgspec.json.Decoder(_Bare)
    yield {
        "set": _each(lambda: wire.read_request(wire.encode(request))),
        "change": _each(lambda: wire.read_notice(wire.notice(topic, change))),
        "a bare Struct": _each(lambda: decoder.decode(encoder.encode(bare))),
        "json": _each(lambda: json.loads(json.dumps(as_found))),
    }


def _each(both_ways: Callable[[], object]) -> Sample:
    def work(times: int) -> None:
        for _ in range(times):
            both_ways()

    return each(work, CPU)


_GOAL = Goal(1.0, of="ours")

BENCHES = (
    Bench(
        "message",
        (
            Row("encode and decode a set", "message", "set", "a bare Struct", "µs", _GOAL),
            Row("encode and decode a change", "message", "change", "a bare Struct", "µs", _GOAL),
            Row("encode and decode a set beside json", "message", "set", "json", "µs", Goal(1.0)),
        ),
        _messages,
    ),
)
