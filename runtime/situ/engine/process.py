"""Programs run to their end: no shell, text by standard input, killed when cancelled."""

from __future__ import annotations

import asyncio
import contextlib
import ctypes
import os
import signal
import sys
from collections.abc import Callable, Sequence

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
    returns only when the program is gone, and the system kills it where we are killed
    ourselves. Raises OSError where it can not start.
    """
    process = await asyncio.create_subprocess_exec(
        *argv,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        start_new_session=True,
        preexec_fn=ending_with_us(signal.SIGKILL),
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


def ending_with_us(number: signal.Signals) -> Callable[[], None] | None:
    """A ``preexec_fn``: the program gets this signal from the system when we die, however we do.

    None where the system can not (all but Linux).
    """
    if sys.platform != "linux":
        return None
    # Loaded here: between fork and exec nothing may be imported.
    prctl = ctypes.CDLL(None, use_errno=True).prctl
    starter = os.getpid()

    def ask() -> None:
        prctl(_SET_PARENT_DEATH_SIGNAL, number)
        if os.getppid() != starter:  # it died before we asked
            os._exit(1)

    return ask


_SET_PARENT_DEATH_SIGNAL = 1
