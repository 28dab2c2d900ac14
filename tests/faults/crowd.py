"""Many modules in one process, each of which sets its own tag so many times, ``PERIOD`` s apart:

    python crowd.py ENDPOINT MODULES TIMES PERIOD

The value is the number of the set and the system's monotonic time before it. At the end it prints
the time in which the slowest one was acknowledged, in seconds.
"""

from __future__ import annotations

import asyncio
import sys
import time
from contextlib import AsyncExitStack

from situ.blackboard.client import AsyncBoard, connect_async

PATIENCE = 30.0


async def crowd(endpoint: str, modules: int, times: int, period: float) -> float:
    async with AsyncExitStack() as stack:
        boards = [
            await stack.enter_async_context(connect_async(endpoint, f"m{number}", timeout=PATIENCE))
            for number in range(modules)
        ]
        begin = time.monotonic()
        return max(
            await asyncio.gather(
                *(
                    _sets(
                        board, f"load.m{number}", begin + period * number / modules, times, period
                    )
                    for number, board in enumerate(boards)
                )
            )
        )


async def _sets(board: AsyncBoard, tag: str, begin: float, times: int, period: float) -> float:
    slowest = 0.0
    for number in range(times):
        await asyncio.sleep(begin + number * period - time.monotonic())
        at = time.monotonic()
        await board.set(tag, [number, at])
        slowest = max(slowest, time.monotonic() - at)
    return slowest


if __name__ == "__main__":
    where, modules, times, period = sys.argv[1:]
    print(asyncio.run(crowd(where, int(modules), int(times), float(period))))
