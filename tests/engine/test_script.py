"""A scenario played to a running robot: what it keeps of a run, which may last for days."""

from __future__ import annotations

import tracemalloc

from situ.decide.trace import Data
from situ.engine.script import Script
from situ.rehearse.expect import Expect
from situ.rehearse.scenario import End, Line

EVENTS = 2000
LETTERS = 1000
EXPECTED = Expect({"kind": "data", "seq": 3})


def an_event(number: int) -> Data:
    value = f"{number:{LETTERS}}"
    return Data(number, float(number), None, "note", value, "scenario", number)


def test_after_the_last_expectation_nothing_of_the_run_is_kept() -> None:
    end = Line(number=2, at=EVENTS * 1_000_000, does=End())
    script = Script([Line(number=1, at=3_000_000, does=EXPECTED), end])
    tracemalloc.start()
    try:
        for number in range(EVENTS):
            script.heard([an_event(number)], 0.0)
        kept, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert kept < EVENTS * LETTERS / 10
    # What comes in the very moment of the expectation is still looked at.
    script.verdict.expect(1, 3_000_000, EXPECTED)
    script.verdict.judge()
    assert (script.verdict.fulfilled, script.verdict.failures) == (1, [])
