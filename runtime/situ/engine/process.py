"""Programs run to their end: no shell, text by standard input, killed when cancelled."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
from collections.abc import AsyncIterator, Sequence

from msgspec import Struct

from situ.engine.ending import ending_with_us


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
    process = await _start(argv)
    try:
        out, err = await process.communicate(data)
    except BaseException:
        kill(process)
        # Reads what is left, so that the pipes close; then it is surely gone.
        await asyncio.shield(process.communicate())
        raise
    assert process.returncode is not None
    return Ended(process.returncode, out, err)


class Running:
    """A program under way, with its streams; what it complains of is read meanwhile."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stderr is not None
        self.stdin = process.stdin
        self.stdout = process.stdout
        self._process = process
        self._errors = asyncio.create_task(process.stderr.read())

    async def ended(self) -> Ended:
        """Waits for its end; ``out`` is what nobody has read of its standard output."""
        out, err, status = await asyncio.gather(
            self.stdout.read(), self._errors, self._process.wait()
        )
        return Ended(status, out, err)


@contextlib.asynccontextmanager
async def running(argv: Sequence[str]) -> AsyncIterator[Running]:
    """Starts a program as ``run`` does, for who talks with it while it runs.

    At the end of the context its group is killed where it still runs, and it is gone.
    Raises OSError where it can not start.
    """
    process = await _start(argv)
    program = Running(process)
    try:
        yield program
    finally:
        kill(process)
        program.stdin.close()
        await asyncio.shield(program.ended())


async def _start(argv: Sequence[str]) -> asyncio.subprocess.Process:
    return await asyncio.create_subprocess_exec(
        *argv,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        start_new_session=True,
        preexec_fn=ending_with_us(signal.SIGKILL),
    )


def kill(process: asyncio.subprocess.Process, with_signal: int = signal.SIGKILL) -> None:
    """Sends a signal to the program's whole group; nothing happens if it has ended."""
    if process.returncode is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, with_signal)
