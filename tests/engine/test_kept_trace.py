"""The trace of a core that was killed: what of it is found again."""

from __future__ import annotations

from pathlib import Path

import pytest

from situ.blackboard.backlog import Backlog
from situ.decide.trace import Warned
from situ.engine import kept_trace
from situ.engine.kept_trace import KeptTrace


def more(backlog: Backlog, count: int) -> Backlog:
    """So many more events."""
    begin = backlog.last + 1
    backlog.add((Warned(seq, 0.0, None, "x" * 50, "") for seq in range(begin, begin + count)), 1.5)
    return backlog


def seqs(folder: Path, last: int, runtime: str = "rr") -> list[int]:
    return [seq for seq, _, _ in KeptTrace(folder).load(runtime, last)]


def test_all_up_to_the_last_snapshot_is_found_as_it_was(tmp_path: Path) -> None:
    kept, backlog = KeptTrace(tmp_path), Backlog()
    for count in (3, 0, 4):
        kept.follow("rr", more(backlog, count))
    found = KeptTrace(tmp_path).load("rr", 7)
    assert found == backlog.after(0, 1_000_000)
    again = Backlog(begin=7)
    again.restore(found)
    assert (again.first, again.last) == (1, 7)
    assert list(again.since(1, 99)) == list(backlog.since(1, 99))


def test_what_came_after_the_snapshot_is_left_out(tmp_path: Path) -> None:
    kept, backlog = KeptTrace(tmp_path), Backlog()
    kept.follow("rr", more(backlog, 5))
    # This one's snapshot was never made: the core was killed between the two.
    kept.follow("rr", more(backlog, 5))
    assert seqs(tmp_path, 5) == [1, 2, 3, 4, 5]
    assert seqs(tmp_path, 11) == []


def test_a_core_that_goes_on_goes_on_with_its_trace(tmp_path: Path) -> None:
    kept, backlog = KeptTrace(tmp_path), Backlog()
    kept.follow("rr", more(backlog, 5))
    with open(tmp_path / "trace", "ab") as file:
        file.write(b"torn")
    again = Backlog(begin=5)
    again.restore(KeptTrace(tmp_path).load("rr", 5))
    second = KeptTrace(tmp_path)
    second.follow("rr", again)
    second.follow("rr", more(again, 2))
    assert seqs(tmp_path, 7) == [1, 2, 3, 4, 5, 6, 7]


def test_it_is_bounded_and_what_is_left_has_no_gap(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kept_trace, "LIMIT", 2000)
    kept, backlog = KeptTrace(tmp_path), Backlog()
    for _ in range(30):
        kept.follow("rr", more(backlog, 5))
        assert sum(file.stat().st_size for file in tmp_path.iterdir()) < 8000
        found = seqs(tmp_path, backlog.last)
        assert found == list(range(backlog.last - len(found) + 1, backlog.last + 1))
        assert len(found) >= min(backlog.last, 10)


def test_events_that_are_too_large_are_a_gap_and_no_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kept_trace, "LIMIT", 2000)
    kept, backlog = KeptTrace(tmp_path), Backlog()
    kept.follow("rr", more(backlog, 2))
    backlog.add([Warned(3, 0.0, None, "x" * 5000, "")], 1.5)
    kept.follow("rr", backlog)
    assert seqs(tmp_path, 3) == []
    kept.follow("rr", more(backlog, 2))
    assert seqs(tmp_path, 5) == [4, 5]


def test_another_run_s_trace_and_a_damaged_one_are_none(tmp_path: Path) -> None:
    kept = KeptTrace(tmp_path)
    kept.follow("rr", more(Backlog(), 3))
    assert seqs(tmp_path, 3, "another run") == []
    (tmp_path / "trace").write_bytes(b"no frames")
    assert seqs(tmp_path, 3) == []
    kept.forget()
    assert list(tmp_path.iterdir()) == []
