"""The cursor in a log: always at a moment that can be looked at, and written so that it is told."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from tests.gui.live.test_log import told

from situ_studio.live.log import TraceLog
from situ_studio.live.viewing import Viewing

NOON = datetime(2026, 11, 21, 12, tzinfo=UTC).astimezone().replace(hour=12)


def viewed(*times: float, at: str | None = None) -> Viewing:
    """A log of events at those times. at: what the clock on the wall said at the first."""
    log = TraceLog()
    more: dict[str, Any] = {} if at is None else {"time": at}
    log.add(told(seq, t, **more) for seq, t in enumerate(times, 1))
    return Viewing(log)


def test_a_cursor_whose_moment_is_no_longer_kept_is_at_the_first_that_is() -> None:
    log = TraceLog(limit=4, block=2)
    log.add([told(1, 1.0)])
    viewing = Viewing(log)
    viewing.pause()
    log.add(told(seq, float(seq)) for seq in range(2, 10))
    start, _ = viewing.span
    assert viewing.t == start > 1.0
    assert viewing.moment().t == start
    assert viewing.moment().board["a.b"].value == start


@pytest.mark.parametrize(
    ("times", "at"),
    [((1.0, 2.0), "yesterday"), ((1e18, 2e18), NOON.isoformat()), ((0.0, 1e18), NOON.isoformat())],
)
def test_where_no_clock_on_the_wall_can_be_told_moments_are_seconds(
    times: tuple[float, ...], at: str
) -> None:
    viewing = viewed(*times, at=at)
    assert viewing.written(times[1]) == f"{times[1]:.3f} s"
    assert viewing.clock() == f"{times[1]:.1f} s"


def test_moments_in_seconds_are_told_apart_however_late_they_are() -> None:
    viewing = viewed(1.7e9)
    assert viewing.written(1_700_000_000.25, finest=False) == "1700000000.25 s"
    assert viewing.written(1_700_000_000.5, finest=False) == "1700000000.5 s"
    assert viewing.written(30.0, finest=False) == "30 s"


def test_a_run_of_several_days_tells_the_day_and_one_of_minutes_does_not() -> None:
    short = viewed(0.0, 600.0, at=NOON.isoformat())
    assert (short.clock(), short.written(0.0)) == ("12:10:00", "12:00:00.000")
    long = viewed(0.0, 30 * 86400.0, at=NOON.isoformat())
    day = timedelta(days=1).total_seconds()
    assert long.clock() == f"{NOON + timedelta(days=30):%Y-%m-%d} 12:00:00"
    assert long.written(day) == f"{NOON + timedelta(days=1):%Y-%m-%d} 12:00:00.000"
    # At the edge the day stands at its beginning alone.
    assert long.written(day / 2, finest=False) == f"{NOON + timedelta(days=1):%Y-%m-%d}"
    assert long.written(day, finest=False) == "12:00:00"
