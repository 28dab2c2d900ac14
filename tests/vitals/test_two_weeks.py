"""Two weeks of examples/vitals in virtual time.

Only with ``SITU_SOAK=1`` (``make soak``). What is random is seeded: ``SITU_SEED``.
"""

from __future__ import annotations

import os
import resource

import pytest
from tests.vitals.days import BUSIEST, HOUR, SECOND, VITALS, Ward

from situ.document.ready import load_ready
from situ.rehearse.simulate import Rehearsal

DAYS = 14
MORE = 30 * 1024
"""KiB that the rest after the first six hours may need."""


def memory() -> int:
    """The most that this process has needed so far, in KiB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


@pytest.mark.skipif(not os.environ.get("SITU_SOAK"), reason="only in make soak")
def test_days_and_nights_go_by_every_state_is_come_to_and_nothing_grows() -> None:
    ward = Ward(int(os.environ.get("SITU_SEED", "0")))
    project = load_ready(VITALS)
    robot = Rehearsal(project, ward.hear)
    early = 0
    for at, given in ward.inputs(DAYS):
        robot.give(given, at)
        if not early and at > 6 * HOUR * SECOND:
            early = memory()
    print(f"{sum(ward.entered.values())} states, {dict(ward.situations)}")
    print(f"at most {ward.busiest} events at once, {memory() - early} KiB more after six hours")
    assert ward.wrong == []
    assert ward.busiest < BUSIEST
    assert memory() - early < MORE
    assert project.spds is not None
    assert set(ward.situations) == {one.name for one in project.spds.situations}
    came = {seen.split("/")[0] for seen in ward.entered}
    every = {f"{one.name} {s.no}" for one in project.applications.values() for s in one.states}
    assert sorted(every - came) == []
