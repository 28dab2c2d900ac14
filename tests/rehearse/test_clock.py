"""What ``clock.…`` said is known from the writes that were seen and the times of events."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime, timedelta
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.rehearse.conftest import Make

from situ.decide import inputs
from situ.decide.clock import DATE, TIME, WEEKDAY, tags_at
from situ.rehearse import recorded
from situ.rehearse.clock import FAR, Given, Hidden, followed
from situ.rehearse.reason import lines
from situ.rehearse.recording import Recording
from situ.rehearse.why import why_not

NOON = datetime(2026, 3, 28, 23, 50, 20)
HOUR = timedelta(hours=1)


def event(t: float, begun: datetime = NOON, seq: int = 0) -> dict[str, Any]:
    time = (begun + timedelta(seconds=t)).isoformat() + "Z"
    return {"kind": "event", "seq": seq, "t": t, "cause": None, "application": "app", "time": time}


def kept(begun: datetime, zone: timedelta, seconds: float) -> list[Hidden]:
    """What a robot has: of its project from its start, and at each full minute a little late."""
    found: list[Hidden] = []
    stood: dict[str, str] = {}
    t = 0.0
    while t <= seconds:
        now = tags_at(begun + zone + timedelta(seconds=t))
        by = "situ" if t else "project"
        found += [Hidden(t, tag, now[tag], by) for tag in now if stood.get(tag) != now[tag]]
        stood = now
        passed = (begun + timedelta(seconds=t)).timestamp() % 60
        t = round(t + 60 - passed + 0.01, 6)
    return found


def at(writes: Iterable[Hidden], t: float) -> dict[str, Any]:
    return {one.tag: one.value for one in writes if one.t <= t}


def standing(writes: list[Hidden], t: float) -> list[Hidden]:
    """What somebody sees who comes then: of each tag the last, with when it was written."""
    return list({one.tag: one for one in writes if one.t <= t}.values())


@given(
    st.integers(0, 86_399),
    st.integers(-48, 56),
    st.lists(st.integers(0, 3 * 3600 * 10), min_size=1, max_size=20),
    st.integers(0, 3 * 3600),
    st.booleans(),
)
@example(0, 0, [27_000], 0, False)
@settings(max_examples=60, deadline=None)
def test_from_one_write_that_was_seen_the_clock_is_known_at_every_event(
    second: int, quarters: int, tenths: list[int], came: int, stayed: bool
) -> None:
    begun = datetime(2026, 3, 1) + timedelta(seconds=second)
    zone = timedelta(minutes=15) * quarters
    times = sorted({0.0, *(tenth / 10 for tenth in tenths)})
    # A minute that begins with the last event is written a little after it.
    truth = kept(begun, zone, times[-1] + came + 1)
    seen = standing(truth, float(came))
    if stayed:
        seen += [one for one in truth if one.t > came]
    found = followed([event(t, begun) for t in times], seen)
    assert [one.t for one in found] == sorted(one.t for one in found)
    for t in times:
        assert at(found, t + 0.02) == at(truth, t + 0.02), t
    # What was seen is all there, and once.
    assert {*seen} <= {*found}
    assert len({(one.t, one.tag) for one in found}) == len(found)


def test_where_nothing_was_seen_or_the_events_do_not_tell_the_time_nothing_is_known() -> None:
    assert followed([event(0.0)], []) == []
    seen = standing(kept(NOON, HOUR, 60), 0.0)
    bare = {**event(0.0), "time": None}
    wrong = ("yesterday", "0001-01-01T00:00:00+05:00")
    assert followed([bare, *({**bare, "time": one} for one in wrong)], seen) == seen
    # The time without its day does not tell how far it is from UTC.
    alone = [one for one in seen if one.tag == TIME]
    assert followed([event(0.0), event(600.0)], alone) == alone
    # Nor what somebody else has set there, nor what no time zone is.
    for other in (
        [Hidden(one.t, one.tag, one.value, "operator:ann") for one in seen],
        [Hidden(0.0, DATE, "2026-03-29", "situ"), Hidden(0.0, TIME, "07:13", "situ")],
        [Hidden(0.0, DATE, "2026-03-29", "situ"), Hidden(0.0, TIME, "07:13+01:00", "project")],
    ):
        assert followed([event(0.0), event(600.0)], other) == other


def test_between_two_that_differ_in_their_distance_to_utc_nothing_is_known() -> None:
    summer = kept(NOON, 2 * HOUR, 10_000)
    seen = [*standing(kept(NOON, HOUR, 60), 0.0), *standing(summer, 9_000.0)]
    found = followed([event(t) for t in (0.0, 30.0, 5_000.0, 9_110.0)], seen)
    assert at(found, 30.0)[TIME] == "00:50"
    assert at(found, 5_000.0) == {TIME: None, DATE: None, WEEKDAY: None}
    assert at(found, 9_110.0) == at(summer, 9_110.0)


def test_of_summer_time_that_began_before_what_was_seen_no_trace_tells() -> None:
    """Who comes after the night of the change: no event names the time zone of the robot."""
    changed = 4_180.0  # at 01:00 UTC
    winter, summer = kept(NOON, HOUR, 10_000), kept(NOON, 2 * HOUR, 10_000)
    truth = [one for one in winter if one.t < changed]
    truth += [one for one in summer if one.t >= changed]
    came = 9_000.0
    found = followed([event(t) for t in (0.0, 600.0, 9_110.0)], standing(truth, came))
    # Rightly from the change on; before it as if it had been before, too: an hour too much.
    for t in (changed + 60.02, came, 9_110.02):
        assert at(found, t)[TIME] == at(truth, t)[TIME]
    assert (at(truth, 600.0)[TIME], at(found, 600.0)[TIME]) == ("01:00", "02:00")
    # Who has seen one before the change as well is told nothing that is wrong.
    both = followed(
        [event(t) for t in (0.0, 600.0, 9_110.0)], [*standing(truth, 0.0), *standing(truth, came)]
    )
    assert at(both, 600.0)[TIME] is None


def test_a_day_before_and_after_what_was_seen_it_is_not_known() -> None:
    truth = kept(NOON, HOUR, 4 * FAR)
    seen = standing(truth, 2 * FAR)
    minutes = [float(t) for t in range(0, int(4 * FAR), 600)]
    found = followed([event(t) for t in minutes], seen)
    last = max(one.t for one in seen)
    for t in minutes:
        known = at(found, t + 0.02)
        if t < last - FAR:
            assert known == {}
        elif last - FAR + 60 < t < last + FAR - 60:
            assert known == at(truth, t + 0.02)
        elif t > last + FAR:
            assert {*known.values()} == {None}


def test_where_the_clock_on_the_wall_was_set_back_no_write_is_before_the_one_before_it() -> None:
    seen = standing(kept(NOON, HOUR, 60), 0.0)
    back = NOON - timedelta(minutes=30)
    found = followed([event(0.0), event(100.0), event(200.0, back), event(4_000.0, back)], seen)
    assert [one.t for one in found] == sorted(one.t for one in found)
    assert at(found, 4_000.0)[TIME] == tags_at(back + HOUR + timedelta(seconds=4_000))[TIME]


def test_what_the_clock_on_the_wall_passed_over_when_it_was_set_ahead_is_not_written() -> None:
    power_on = datetime(1970, 1, 1)
    events = [event(t, power_on) for t in (0.0, 90.0)] + [event(t) for t in (200.0, 4_000.0)]
    first = standing(kept(power_on, HOUR, 60), 0.0)
    then = tags_at(NOON + HOUR + timedelta(seconds=3_990))
    last = [Hidden(3_990.0, tag, value, "situ") for tag, value in then.items()]
    for seen in ([*first, *last], first, last):
        found = followed(events, seen)
        assert len(found) < 100
        for t in (30.0, 100.0, 190.0):
            assert at(found, t) == tags_at(power_on + HOUR + timedelta(seconds=t))
        for t in (200.0, 2_000.0, 4_000.0):
            assert at(found, t) == tags_at(NOON + HOUR + timedelta(seconds=t))


def test_a_recording_tells_what_stood_at_its_beginning_and_what_was_written() -> None:
    heading = recorded.Heading(tags={TIME: "08:30", "spo2": 97})
    start, minute = inputs.Start(), inputs.Set({TIME: "08:31", "spo2": 98}, "situ")
    clock = Given()
    assert clock.take(heading) == []
    assert clock.take(recorded.Taken(0, 0.0, start)) == [Hidden(0.0, TIME, "08:30", "project")]
    told = clock.take(recorded.Taken(60_000_000, 60.0, minute))
    assert told == [Hidden(60.0, TIME, "08:31", "situ")]


NIGHT = """<application name="app"><state no="1"><expectedevents>
<event name="go" next="2"><when><data tag="clock.time" below="00:53"/></when></event>
</expectedevents></state><state no="2"/></application>"""


@pytest.mark.parametrize(
    ("seen", "said"),
    [
        (kept(NOON, HOUR, 60), "clock.time below 00:53: it was “00:55”, set at 280 s by situ"),
        ([], "clock.time below 00:53: not told by a trace alone"),
        (
            [*kept(NOON, HOUR, 60), Hidden(290.0, TIME, None, "situ")],
            "clock.time below 00:53: not told by a trace alone",
        ),
    ],
)
def test_why_not_looks_at_the_clock_as_it_was_then(
    make: Make, seen: list[Hidden], said: str
) -> None:
    enter = {**event(0.0, seq=1), "kind": "enter", "state": "1"}
    go = {**event(300.0, seq=2), "name": "go"}
    ignored = {
        **event(300.0, seq=3),
        "kind": "ignored",
        "name": "go",
        "reason": "guard",
        "cause": 2,
    }
    events = [enter, go, ignored]
    known = followed(events, seen)
    recording = Recording.of(events, known)
    # The start is one step, and the clock is there by then.
    assert recording.steps[0].events == [enter]
    assert recording.steps[0].before == [one for one in known if not one.t]
    answer = why_not(make(NIGHT), recording, {"kind": "enter", "state": "2"}, 300.0)
    assert said in "\n".join(lines(answer.reasons))
    assert Recording.of([], known).steps == []
