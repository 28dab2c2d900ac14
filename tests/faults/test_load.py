"""Many modules and editors at once: nobody misses anything (quality, *Faults*)."""

from __future__ import annotations

import asyncio
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import AsyncExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tests.faults.session import Session

from situ.blackboard.client import AsyncBoard, Change, connect_async

if TYPE_CHECKING:
    from tests.faults.conftest import Runtime

DEADLINE = 30.0
CROWD = Path(__file__).parent / "crowd.py"
MODULES, EDITORS, PERIOD = 50, 5, 0.05
SLOW = 0.05
"""Seconds; asserted where nothing else runs, in ``make soak``."""


class Editor:
    """Who follows all changes and the trace; notes each gap, and how late each change came."""

    def __init__(self, board: AsyncBoard, wanted: int) -> None:
        self.session = Session(board)
        self.late: list[float] = []
        self.gaps: list[str] = []
        self.done = asyncio.Event()
        self._wanted = wanted
        self._versions: dict[str, int] = {}
        self._seq: int | None = None
        self._traced = 0

    def changed(self, change: Change) -> None:
        self.late.append(time.monotonic() - change.value[1])
        if change.version != self._versions.get(change.tag, 0) + 1:
            self.gaps.append(f"{change.tag}: {change.version}")
        self._versions[change.tag] = change.version
        self._look()

    def traced(self, event: dict[str, Any]) -> None:
        if self._seq is not None and event["seq"] != self._seq + 1:
            self.gaps.append(f"trace: {event['seq']} after {self._seq}")
        self._seq = event["seq"]
        self._traced += event["kind"] == "data" and event["tag"].startswith("load.")
        self._look()

    def _look(self) -> None:
        if sum(self._versions.values()) >= self._wanted and self._traced >= self._wanted:
            self.done.set()


async def _follow(endpoint: str, times: int) -> tuple[list[Editor], float]:
    """The editors, and in how many seconds the slowest set was acknowledged."""
    editors = []
    async with AsyncExitStack() as stack:
        for _ in range(EDITORS):
            board = await stack.enter_async_context(
                connect_async(endpoint, role="viewer", timeout=DEADLINE)
            )
            editor = Editor(board, MODULES * times)
            editors.append(editor)
            await stack.enter_async_context(board.watch("load.*", editor.changed))
            await stack.enter_async_context(board.trace(callback=editor.traced))
        load = await asyncio.create_subprocess_exec(
            *(sys.executable, str(CROWD), endpoint, str(MODULES), str(times), str(PERIOD)),
            stdout=subprocess.PIPE,
        )
        said, _ = await load.communicate()
        async with asyncio.timeout(DEADLINE):
            for editor in editors:
                await editor.done.wait()
                editor.session.end()
    return editors, float(said)


def test_fifty_modules_and_five_editors_miss_nothing(
    runtime: Runtime, often: Callable[[int, int], int], soaking: bool
) -> None:
    runtime.start()
    times = often(20, 12_000)
    editors, slowest = asyncio.run(_follow(runtime.endpoint, times))
    assert runtime.stop() == 0
    if soaking:
        assert all(editor.session.stayed for editor in editors)
    assert [gap for editor in editors if editor.session.stayed for gap in editor.gaps] == []
    late = sorted(one for editor in editors for one in editor.late)
    p99 = statistics.quantiles(late, n=100)[98]
    print(
        f"\n{MODULES * times} sets by {MODULES} modules, each told to {EDITORS} editors: "
        f"p50 {late[len(late) // 2] * 1000:.1f} ms, p99 {p99 * 1000:.1f} ms, "
        f"latest {late[-1] * 1000:.0f} ms; slowest acknowledgement {slowest * 1000:.0f} ms"
    )
    assert p99 <= SLOW or not soaking
