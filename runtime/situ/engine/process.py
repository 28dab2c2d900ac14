"""Programs run to their end: no shell, text by standard input, killed when cancelled."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
from collections.abc import Sequence

from msgspec import Struct


class Ended(Struct, frozen=True):
    """How a program ended. status: its exit status, negative for a signal."""

    status: int
    out: bytes
    err: bytes

    @property
    def complaint(self) -> str:
        """The first line that it wrote to standard error, else its exit status, in words."""
        for line in self.err.decode("utf-8", "replace").splitlines():
            if line.strip():
                return line.strip()
        return f"it ended with exit status {self.status}"


async def run(argv: Sequence[str], data: bytes = b"") -> Ended:
    """Runs a program to its end.

    It leads a process group of its own; a cancelled ``run`` kills the group and
    returns only when the program is gone. Raises OSError where it can not start.
    """
    process = await asyncio.create_subprocess_exec(
        *argv,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        start_new_session=True,
    )
    try:
        out, err = await process.communicate(data)
    except BaseException:
        kill(process)
        # Reads what is left, so that the pipes close; then it is surely gone.
        await asyncio.shield(process.communicate())
        raise
    assert process.returncode is not None
    return Ended(process.returncode, out, err)


def kill(process: asyncio.subprocess.Process, with_signal: int = signal.SIGKILL) -> None:
    """Sends a signal to the program's whole group; nothing happens if it has ended."""
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, with_signal)
