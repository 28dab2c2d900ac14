"""What expectations keep of a run, which may last for days."""

from __future__ import annotations

import tracemalloc

from situ.decide.trace import Data
from situ.rehearse.expect import Expect, Expectations

EVENTS = 2000
LETTERS = 1000


def an_event(number: int) -> Data:
    value = f"{number:{LETTERS}}"
    return Data(number, float(number), None, "note", value, "scenario", number)


def test_what_no_expectation_can_find_any_more_is_forgotten() -> None:
    judged = Expectations()
    tracemalloc.start()
    try:
        for number in range(EVENTS):
            judged.add([an_event(number)])
            judged.expect(number, number, Expect({"kind": "data", "seq": number}))
            judged.judge()
        kept, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert (judged.fulfilled, judged.failures) == (EVENTS, [])
    assert kept < EVENTS * LETTERS / 10
