"""One subscriber of twenty stands still: the others lose nothing, it finds its gaps, and what waits
for it does not fill the robot's memory (quality, *Faults*)."""

from __future__ import annotations

import asyncio
import json
import signal
import sys
import time
from collections.abc import Callable
from contextlib import AsyncExitStack
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

from tests.faults.session import Session

from situ.blackboard.client import AsyncBoard, Change, connect_async

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
FOLLOWER = Path(__file__).parent / "follower.py"
READING = 19
LARGE = 1_000_000
MEMORY = 300.0
"""Megabytes: what waits (64, and what comes while the connection is closed), the trace of the last
events (64), what is written down, and what passes through."""


class Reader:
    """Who follows a tag; its versions must follow each other."""

    def __init__(self, board: AsyncBoard) -> None:
        self.session = Session(board)
        self.versions: list[int] = []
        self.news = asyncio.Event()

    def changed(self, change: Change) -> None:
        self.versions.append(change.version)
        self.news.set()

    async def reaches(self, version: int) -> None:
        async with asyncio.timeout(DEADLINE):
            while not self.versions or self.versions[-1] < version:
                self.news.clear()
                await self.news.wait()


async def _stall(
    runtime: Runtime, seconds: float, count: int
) -> tuple[list[Reader], dict[str, list[int]], int]:
    """Sets ``count`` times and at least for so many seconds, while one stands still: the readers,
    what that one was told, and how often was set."""
    readers: list[Reader] = []
    async with AsyncExitStack() as stack:
        stalled = await asyncio.create_subprocess_exec(
            sys.executable, str(FOLLOWER), runtime.endpoint, stdout=asyncio.subprocess.PIPE
        )
        stack.callback(_kill, stalled)
        assert stalled.stdout is not None
        assert await stalled.stdout.readline() == b"following\n"
        for _ in range(READING):
            # One looks at the pictures: the session of who stands still soon ends, and what nobody
            # watches is told to nobody.
            tag = "small.number" if readers else "large.picture"
            board = await stack.enter_async_context(
                connect_async(runtime.endpoint, role="viewer", timeout=DEADLINE)
            )
            reader = Reader(board)
            readers.append(reader)
            await stack.enter_async_context(board.watch(tag, reader.changed))
        board = await stack.enter_async_context(connect_async(runtime.endpoint, timeout=DEADLINE))
        stalled.send_signal(signal.SIGSTOP)
        end = time.monotonic() + seconds
        number = 0
        while number < count or time.monotonic() < end:
            number += 1
            text = f"{number} " + "x" * LARGE
            await board.set({"large.picture": text, "small.number": number})
        for reader in readers:
            await reader.reaches(number)
            reader.session.end()
        stalled.send_signal(signal.SIGCONT)
        await board.set("all", {"large.picture": number, "small.number": number})
        said, _ = await asyncio.wait_for(stalled.communicate(), DEADLINE)
    return readers, json.loads(said), number


def _lost(versions: list[int]) -> list[tuple[int, int]]:
    """Where a version does not follow the one before."""
    return [(a, b) for a, b in pairwise([0, *versions]) if b != a + 1]


def _kill(process: asyncio.subprocess.Process) -> None:
    if process.returncode is None:
        process.kill()


def test_one_that_stands_still_costs_nobody_anything(
    runtime: Runtime, often: Callable[[int, int], int], soaking: bool
) -> None:
    runtime.start("--services", "core")
    before = runtime.memory
    readers, told, number = asyncio.run(_stall(runtime, often(0, 30), often(150, 600)))
    grown = runtime.peak - before
    assert runtime.stop() == 0
    log = runtime.log.read_text("utf-8")
    stayed = [reader for reader in readers if reader.session.stayed]
    assert len(stayed) == READING or not soaking
    assert [_lost(reader.versions) for reader in stayed] == [[]] * len(stayed), log
    assert [told[tag][1] for tag in ("large.picture", "small.number")] == [number, number]
    assert told["large.picture"][0] < number
    assert grown <= MEMORY
    assert log.count("does not read what it is sent") == 1
    print(
        f"\n{number} sets of {LARGE // 1_000_000} MB, one of {READING + 1} subscribers stopped: "
        f"it was told {told['large.picture'][0]} and has the last, the others missed none; "
        f"at the most {grown:.0f} MB more memory"
    )
