"""Programs that live no longer than who started them."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import os
import signal
from collections.abc import Sequence
from types import TracebackType
from typing import Any

from situ.engine.ending import ending_with_us
from situ.engine.process import kill

GRACE = 2.0
"""Seconds that programs get to end by themselves, before they are killed."""


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
        try:
            started = await asyncio.create_subprocess_exec(
                *argv, start_new_session=True, preexec_fn=ending_with_us(signal.SIGTERM), **options
            )
        except ValueError as error:
            # What was filled in has a sign that no argument can have.
            raise OSError(errno.EINVAL, str(error)) from None
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
