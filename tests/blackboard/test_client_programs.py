"""How programs end, fork and go wrong with a connection in their hands."""

from __future__ import annotations

import asyncio
import contextlib
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

import pytest

import situ
from situ.blackboard.client import Link, Person
from situ.errors import BlackboardError, Unreachable

DEADLINE = 20.0


def run(code: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-W", "ignore", "-c", code, *arguments],
        capture_output=True,
        text=True,
        timeout=DEADLINE,
        check=False,
    )


def is_free(endpoint: str, module: str) -> bool:
    """Whether the name is free now, and not only when a lease has ended."""
    link = Link(endpoint, Person(role="module", module=module))
    poll = select.poll()
    for descriptor in link.descriptors():
        poll.register(descriptor, select.POLLIN)
    dialog, end = link.dialog, time.monotonic() + DEADLINE
    while not dialog.connected and dialog.problem is None and time.monotonic() < end:
        link.turn()
        poll.poll(max(0, link.due() - link.clock()) * 1000)
    free = dialog.connected
    if free:
        dialog.bye()
        link.turn()
    link.close()
    return free


def test_a_program_that_forgets_to_close_says_goodbye(running: Any) -> None:
    code = "import situ, sys; board = situ.connect(sys.argv[1], 'nod', ['head']); print(board)"
    done = run(code, running.endpoint)
    assert done.stdout == f"<Board {running.endpoint}, module nod, connected>\n"
    assert (done.returncode, done.stderr) == (0, "")
    assert is_free(running.endpoint, "nod")


WAITING = """
import situ, sys
with (
    situ.connect(sys.argv[1], "chase", ["head"], timeout=3600) as board,
    board.authority("head") as head,
    board.watch("face.visible") as face,
):
    print("waits", flush=True)
    for change in face:
        if change.value == "wait for authority":
            print("held", head.wait(), flush=True)
            print("away", head.wait_lost(), flush=True)
            head.wait()
"""


def interrupt(program: subprocess.Popen[str]) -> str:
    program.send_signal(signal.SIGINT)
    _, err = program.communicate(timeout=DEADLINE)
    assert program.returncode == -signal.SIGINT
    return err


def test_ctrl_c_ends_a_program_that_waits_and_its_name_is_free(running: Any) -> None:
    command = [sys.executable, "-c", WAITING, running.endpoint]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == "waits\n"
        assert interrupt(program).endswith("KeyboardInterrupt\n")
    assert is_free(running.endpoint, "chase")


def test_ctrl_c_ends_a_program_whether_or_not_it_knows_that_the_robot_is_away(
    run_lab: Callable[..., Any],
) -> None:
    core = run_lab()
    with contextlib.ExitStack() as programs:

        def start(module: str, resource: str) -> subprocess.Popen[str]:
            code = WAITING.replace("chase", module).replace("head", resource)
            command = [sys.executable, "-c", code, core.endpoint]
            pipe = subprocess.PIPE
            return programs.enter_context(
                subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True)
            )

        started = start("chase", "head"), start("carry", "base")
        said = [program.stdout for program in started if program.stdout is not None]
        assert [out.readline() for out in said] == ["waits\n"] * 2
        with situ.connect(core.endpoint, timeout=DEADLINE) as board:
            board.set("face.visible", "wait for authority")
            assert [out.readline() for out in said] == ["held True\n"] * 2
            core.kill()
        assert interrupt(started[0]).endswith("KeyboardInterrupt\n")
        assert said[1].readline() == "away True\n"
        assert interrupt(started[1]).endswith("KeyboardInterrupt\n")


FORK = """
import os, situ, sys
from situ.errors import BlackboardError
with situ.connect(sys.argv[1], "nod", ["head"]) as board, board.watch("face.*") as face:
    child = os.fork()
    if child == 0:
        for use in (lambda: board.get("x"), lambda: board.watch("x"), lambda: face.next(1.0)):
            try:
                use()
            except BlackboardError as error:
                print(error)
        with situ.connect(sys.argv[1], "chase", ["head"]) as other:
            other.set("from.child", 1)
        sys.stdout.flush()
    else:
        os.waitpid(child, 0)
        print(board.get("from.child"), board.connected)
if child == 0:
    os._exit(0)
"""


def test_a_fork_is_told_to_connect_anew_and_harms_nobody(running: Any) -> None:
    done = run(FORK, running.endpoint)
    assert (done.returncode, done.stderr) == (0, "")
    *told, parents = done.stdout.splitlines()
    assert len(told) == 3
    assert all("connect in the child anew" in line for line in told)
    assert parents == "1 True"


def test_a_notebook_awaits_the_board_itself(running: Any) -> None:
    async def cells() -> None:
        board = await situ.connect_async(running.endpoint, "nod", ["head"])
        assert repr(board) == f"<AsyncBoard {running.endpoint}, module nod, connected>"
        assert await board.set("cell", 1)
        await board.close()
        assert repr(board).endswith("closed>")
        with pytest.raises(Unreachable, match="closed"):
            await board.get("cell")

    asyncio.run(cells())


def test_a_board_that_was_not_entered_says_so(running: Any) -> None:
    async def go() -> None:
        board = situ.connect_async(running.endpoint)
        with pytest.raises(BlackboardError, match="enter it first"):
            await board.get("x")
        board.link.close()

    asyncio.run(go())
