"""Programs that live no longer than who started them."""

from __future__ import annotations

import asyncio
import contextlib
import ctypes
import os
import signal
import sys
from collections.abc import Sequence
from types import TracebackType
from typing import Any

from situ.engine.process import kill

GRACE = 2.0
"""Seconds that programs get to end by themselves, before they are killed."""

_SET_PARENT_DEATH_SIGNAL = 1


class Children:
    """An async context: at its end every program started in it is told to end, then killed.

    Each leads a process group of its own, so that programs which it starts end with it. On
    Linux they are told to end by the system where their starter is killed itself.
    """

    def __init__(self) -> None:
        self._running: list[asyncio.subprocess.Process] = []

    async def __aenter__(self) -> Children:
        return self

    async def __aexit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        await self.close()

    async def start(self, argv: Sequence[str], **options: Any) -> asyncio.subprocess.Process:
        """Starts a program without standard input; ``options``: as of ``subprocess.Popen``.

        Raises OSError where it can not start.
        """
        options.setdefault("stdin", asyncio.subprocess.DEVNULL)
        started = await asyncio.create_subprocess_exec(
            *argv, start_new_session=True, preexec_fn=_end_with(os.getpid()), **options
        )
        self._running.append(started)
        return started

    async def close(self) -> None:
        """Ends what still runs, within about ``GRACE`` seconds, and returns when it is gone."""
        for process in self._running:
            kill(process, signal.SIGTERM)
        waits = [asyncio.create_task(process.wait()) for process in self._running]
        if waits:
            await asyncio.wait(waits, timeout=GRACE)
        for process in self._running:
            # Also those whose leader has ended: what it left behind.
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(process.pid, signal.SIGKILL)
        await asyncio.gather(*waits)
        self._running.clear()


def _end_with(parent: int) -> Any:
    """What a new process does first: asks for a signal for when its parent dies."""
    if sys.platform != "linux":
        return None
    # Loaded here: between fork and exec nothing may be imported.
    prctl = ctypes.CDLL(None, use_errno=True).prctl

    def ask() -> None:
        prctl(_SET_PARENT_DEATH_SIGNAL, signal.SIGTERM)
        if os.getppid() != parent:  # it died before we asked
            os._exit(1)

    return ask
