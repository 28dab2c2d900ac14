"""``kill -9`` of a module that holds authority: the next one has it (quality, *Faults*)."""

from __future__ import annotations

import random
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import situ
from situ.blackboard.protocol import LEASE

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
HOLDER = Path(__file__).parent / "holder.py"
HEARD = 0.05
"""Seconds beyond the lease in which the next one has heard of it, where nothing else runs."""


def test_the_next_module_has_it_in_the_step_in_which_the_killed_one_is_lost(
    runtime: Runtime, chance: random.Random, often: Callable[[int, int], int], soaking: bool
) -> None:
    runtime.start("--services", "core")
    took = []
    with (
        situ.connect(runtime.endpoint, "lift", ["head"], timeout=DEADLINE) as lift,
        lift.authority("head") as head,
        lift.trace() as events,
    ):
        for _ in range(often(1, 20)):
            with subprocess.Popen(
                [sys.executable, str(HOLDER), runtime.endpoint],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
            ) as holder:
                assert holder.stdout is not None
                assert holder.stdout.readline() == b"True\n"
                assert head.wait_lost(DEADLINE)
                for number in range(chance.randint(1, 200)):
                    lift.set("some", number)
                killed = time.monotonic()
                holder.kill()
                assert head.wait(DEADLINE)
                took.append(time.monotonic() - killed)
            lost = next(event for event in events if event["kind"] == "lost")
            authority = events.next(DEADLINE)
            assert authority is not None
            assert (lost["module"], authority["t"]) == ("nod", lost["t"])
            assert (authority["from"], authority["to"]) == ("nod", "lift")
            assert authority["cause"] == lost["seq"]
    assert runtime.stop() == 0
    print(f"\n{len(took)} kills, the next one had it in {max(took):.2f} s at the most")
    assert max(took) <= LEASE + HEARD or not soaking
