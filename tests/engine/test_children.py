"""Programs that live no longer than who started them."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
from pathlib import Path

import pytest

from situ.engine.children import Children

STUBBORN = "import signal; signal.signal(signal.SIGTERM, signal.SIG_IGN); print('up', flush=True)"
FOREVER = "; signal.pause()"


def test_one_that_ignores_being_told_to_end_is_killed() -> None:
    async def scene() -> int | None:
        async with Children() as children:
            child = await children.start(
                [sys.executable, "-c", STUBBORN + FOREVER], stdout=asyncio.subprocess.PIPE
            )
            assert child.stdout is not None
            assert await child.stdout.readline() == b"up\n"
        return child.returncode

    assert asyncio.run(scene()) == -9


def test_what_no_argument_can_hold_is_told_as_all_that_can_not_start() -> None:
    async def start() -> None:
        async with Children() as children:
            await children.start([sys.executable, "-c", "", "sip:\0"])

    with pytest.raises(OSError, match="null byte"):
        asyncio.run(start())


def test_what_it_started_itself_ends_with_it() -> None:
    grandchild = (
        f"import subprocess, sys; subprocess.run([sys.executable, '-c', {STUBBORN + FOREVER!r}])"
    )

    async def scene() -> bytes:
        async with Children() as children:
            child = await children.start(
                [sys.executable, "-c", grandchild], stdout=asyncio.subprocess.PIPE
            )
            assert child.stdout is not None
            assert await child.stdout.readline() == b"up\n"
        # The pipe ends when the last process that has it is gone.
        return await child.stdout.read()

    assert asyncio.run(scene()) == b""


def test_they_are_told_to_end_when_their_starter_is_killed() -> None:
    starter = (
        "import asyncio, os, sys\n"
        "from situ.engine.children import Children\n"
        "async def main():\n"
        "    async with Children() as children:\n"
        "        await children.start([sys.executable, '-c', "
        "\"print('up', flush=True); import signal; signal.pause()\"])\n"
        "        await asyncio.Event().wait()\n"
        "asyncio.run(main())\n"
    )
    with subprocess.Popen([sys.executable, "-c", starter], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"up\n"
        os.kill(process.pid, 9)
        # Comes to an end only when the child is gone too.
        assert process.stdout.read() == b""


RUN = "from situ.engine.process import run; begun = run(['sh', '-c', program])"
LAUNCH = (
    "import logging; from situ.engine.actions.launch import Launcher; "
    "begun = Launcher(folder, logging.getLogger()).launch('game', {})"
)


@pytest.mark.parametrize("begun", [RUN, LAUNCH], ids=["run", "launched"])
def test_what_an_action_runs_ends_when_the_robot_is_killed(begun: str, tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    program = f"exec > {pipe}; echo up; exec tail -f /dev/null"
    (tmp_path / "launch.toml").write_text(f'game = ["sh", "-c", "{program}"]')
    starter = (
        "import asyncio, pathlib, sys\n"
        "folder, program = pathlib.Path(sys.argv[1]), sys.argv[2]\n"
        f"{begun}\n"
        "asyncio.run(begun)\n"
    )
    with (
        subprocess.Popen([sys.executable, "-c", starter, str(tmp_path), program]) as process,
        open(pipe, "rb") as told,
    ):
        assert told.readline() == b"up\n"
        os.kill(process.pid, 9)
        # Comes to an end only when the program is gone too.
        assert told.read() == b""
