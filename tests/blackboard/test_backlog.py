"""The trace that is kept: bounded by events and by bytes, handed out in pages."""

from __future__ import annotations

import json

from situ.blackboard import backlog
from situ.blackboard.backlog import Backlog
from situ.decide.trace import Data


def data(seq: int, size: int = 1) -> Data:
    return Data(seq, 0.5, None, "x", "v" * size, "eyes", seq)


def seqs(kept: Backlog, since: int, limit: int = 1000) -> list[int]:
    return [json.loads(line)["seq"] for line in kept.since(since, limit)]


def test_the_oldest_are_forgotten_when_there_are_too_many() -> None:
    kept = Backlog(capacity=3)
    kept.add(map(data, range(1, 6)), 0.0)
    assert (kept.first, kept.last, seqs(kept, 1)) == (3, 5, [3, 4, 5])


def test_large_values_do_not_fill_the_memory() -> None:
    kept = Backlog(limit=10_000)
    for seq in range(1, 101):
        kept.add([data(seq, 1000)], 0.0)
    assert (kept.first, kept.last) == (92, 100)
    # The newest is kept though it is larger than all that may be.
    kept.add([data(101, 20_000)], 0.0)
    assert (kept.first, kept.last) == (101, 101)
    # What has gone no longer counts.
    for seq in range(102, 110):
        kept.add([data(seq, 1000)], 0.0)
    assert kept.first == 102


def test_a_page_ends_where_it_grows_too_large_and_has_one_event_at_least() -> None:
    kept = Backlog()
    kept.add([data(1), data(2, 2 * backlog.PAGE), data(3), data(4)], 0.0)
    assert seqs(kept, 1) == [1, 2]
    assert seqs(kept, 2) == [2]
    assert seqs(kept, 3) == [3, 4]


def test_each_event_has_the_time_it_was_made() -> None:
    kept = Backlog()
    kept.add([data(1)], 1_767_323_045.25)
    assert json.loads(next(kept.since(1, 1)))["time"] == "2026-01-02T03:04:05.250000Z"
