"""Modules that hang or lose their network, and cores that die: processes of their own, in both
forms of the client, which know nothing of it."""

from __future__ import annotations

import contextlib
import queue
import selectors
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.live_trace import DEADLINE, find

import situ

BLOCKING = """
import sys, situ
endpoint, name, resource = sys.argv[1:]
with (
    situ.connect(endpoint, module=name, resources=[resource]) as board,
    board.watch("count.*") as counts,
    board.authority(resource) as authority,
):
    last, held = 0, False
    while True:
        count = counts.next(0.1)
        if count is not None:
            last = count.value
            print("count", count.value, count.version, count.missed, flush=True)
        if authority.held != held:
            held = authority.held
            print("held", held, flush=True)
        authority.command({"count": last}, valid=0.5)
"""

ASYNCIO = """
import asyncio, sys, situ
endpoint, name, resource = sys.argv[1:]
async def main():
    async with (
        situ.connect_async(endpoint, module=name, resources=[resource]) as board,
        board.watch("count.*") as counts,
        board.authority(resource) as authority,
    ):
        last, held = 0, False
        while True:
            count = await counts.next(0.1)
            if count is not None:
                last = count.value
                print("count", count.value, count.version, count.missed, flush=True)
            if authority.held != held:
                held = authority.held
                print("held", held, flush=True)
            await authority.command({"count": last}, valid=0.5)
asyncio.run(main())
"""

FORMS = pytest.mark.parametrize("form", [BLOCKING, ASYNCIO], ids=["blocking", "asyncio"])


class Module:
    """One of them; ``said`` is what it prints."""

    def __init__(self, form: str, endpoint: str, name: str, resource: str) -> None:
        command = [sys.executable, "-c", form, endpoint, name, resource]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.said: queue.Queue[str] = queue.Queue()
        self._reader = threading.Thread(target=self._read)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.said.put(line.strip())

    def until(self, line: str) -> list[str]:
        """What it says up to this line."""
        found = [self.said.get(timeout=DEADLINE)]
        while not found[-1].startswith(line):
            found.append(self.said.get(timeout=DEADLINE))
        return found

    def close(self) -> None:
        self.process.kill()
        self.process.wait(DEADLINE)
        self._reader.join(DEADLINE)
        assert self.process.stdout is not None
        self.process.stdout.close()


@pytest.fixture
def start() -> Iterator[Callable[..., Module]]:
    with contextlib.ExitStack() as modules:

        def begin(*arguments: str) -> Module:
            module = Module(*arguments)
            modules.callback(module.close)
            return module

        yield begin


class Network:
    """A way to a core that can be cut: then nothing goes through, and nothing is closed."""

    def __init__(self, endpoint: str) -> None:
        host, _, port = endpoint.removeprefix("tcp://").rpartition(":")
        self._core = host, int(port)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.endpoint = f"tcp://127.0.0.1:{self._listener.getsockname()[1]}"
        self._whole = threading.Event()
        self._whole.set()
        self._over, self._end = socket.socketpair()
        self._sockets = [self._listener, self._over, self._end]
        self._thread = threading.Thread(target=self._carry)
        self._thread.start()

    def cut(self) -> None:
        self._whole.clear()

    def mend(self) -> None:
        self._whole.set()

    def close(self) -> None:
        self.mend()
        self._end.send(b"\0")
        self._thread.join(DEADLINE)
        for one in self._sockets:
            one.close()

    def _carry(self) -> None:
        with selectors.DefaultSelector() as waiting:
            waiting.register(self._listener, selectors.EVENT_READ)
            waiting.register(self._over, selectors.EVENT_READ)
            while True:
                for key, _ in waiting.select():
                    self._whole.wait()
                    if key.fileobj is self._over:
                        return
                    if key.fileobj is self._listener:
                        ends = self._listener.accept()[0], socket.create_connection(self._core)
                        self._sockets += ends
                        for one, other in (ends, ends[::-1]):
                            waiting.register(one, selectors.EVENT_READ, other)
                        continue
                    assert isinstance(key.fileobj, socket.socket)
                    try:
                        data = key.fileobj.recv(65536)
                        if data:
                            key.data.sendall(data)
                            continue
                        key.data.shutdown(socket.SHUT_WR)
                    except OSError:
                        pass  # one of the two has gone
                    waiting.unregister(key.fileobj)


@pytest.fixture
def network(running: Any) -> Iterator[Network]:
    made = Network(running.endpoint)
    yield made
    made.close()


@pytest.fixture
def board(running: Any) -> Iterator[situ.Board]:
    with situ.connect(running.endpoint, timeout=DEADLINE) as connected:
        yield connected


@pytest.fixture
def carry(running: Any) -> Iterator[situ.Authority]:
    """Who has the head when nobody goes before."""
    with (
        situ.connect(running.endpoint, "carry", ["base", "head"], timeout=DEADLINE) as connected,
        connected.authority("head") as authority,
    ):
        yield authority


def passes(events: Any) -> None:
    """Chase is lost, and carry has its head in the same step."""
    lost = find(events, kind="lost", module="chase")
    passed = find(events, kind="authority", resource="head")
    assert (passed["to"], passed["t"], passed["cause"]) == ("carry", lost["t"], lost["seq"])


def comes_back(events: Any) -> None:
    """Chase is there, and has what it asked for, without anybody's doing."""
    find(events, kind="connected", module="chase")
    find(events, kind="authority", resource="head", to="chase")
    find(events, kind="mapping", resource="head", module="chase")


@FORMS
def test_a_module_that_hangs_gives_up_authority_and_is_itself_again(
    running: Any, board: situ.Board, carry: situ.Authority, start: Callable[..., Module], form: str
) -> None:
    with board.trace() as events:
        chase = start(form, running.endpoint, "chase", "head")
        find(events, kind="mapping", resource="head", module="chase")
        chase.process.send_signal(signal.SIGSTOP)
        passes(events)
        assert carry.wait(DEADLINE)
        chase.process.send_signal(signal.SIGCONT)
        comes_back(events)
        assert carry.wait_lost(DEADLINE)


@FORMS
def test_a_module_that_loses_its_network_gives_up_authority_and_is_itself_again(
    board: situ.Board,
    carry: situ.Authority,
    network: Network,
    start: Callable[..., Module],
    form: str,
) -> None:
    with board.trace() as events:
        chase = start(form, network.endpoint, "chase", "head")
        find(events, kind="mapping", resource="head", module="chase")
        chase.until("held True")
        network.cut()
        passes(events)
        # Nobody has told it, and it knows all the same.
        chase.until("held False")
        network.mend()
        comes_back(events)
        chase.until("held True")


def moves(board: situ.Board, resource: str, module: str, value: Any) -> None:
    """Waits until the module's command moves the resource."""
    with board.watch(f"robot/{resource}") as moved:
        while (change := moved.next(DEADLINE)) is not None and change.value != value:
            pass
        assert change is not None, f"nothing moves {resource} so"
        assert change.writer == module


def assert_no_gap(said: list[str]) -> None:
    """Every change of ``count.x`` was told, or told to have been missed."""
    version = 0
    for line in said:
        if line.startswith("count"):
            value, now, missed = line.split()[1:]
            if int(now) < version:
                version = 0  # of a core that began anew, which may have none yet
            assert int(now) == version + 1 + int(missed) or (value, now) == ("None", "0"), said
            version = int(now)


@pytest.mark.parametrize("how", ["it goes on", "it begins anew"])
def test_a_core_that_is_killed_and_started_again_needs_nothing_of_modules(
    run_lab: Callable[..., Any], start: Callable[..., Module], how: str
) -> None:
    first = run_lab()
    chase = start(BLOCKING, first.endpoint, "chase", "head")
    carry = start(ASYNCIO, first.endpoint, "carry", "base")
    with situ.connect(first.endpoint, timeout=DEADLINE) as board:
        board.set("count.x", 0)
        moves(board, "head", "chase", {"count": 0})
        moves(board, "base", "carry", {"count": 0})
        for count in (1, 2, 3):
            board.set("count.x", count)
        said = [one.until("count 3") for one in (chase, carry)]
        first.kill()
        again = ("--endpoint", first.endpoint, "--notify", first.notifications)
        run_lab(*again, "--http", "127.0.0.1:0", *(["--fresh"] if how == "it begins anew" else []))
        for count in (4, 5, 6):
            board.set("count.x", count)
        for one, before in zip((chase, carry), said, strict=True):
            assert_no_gap(before + one.until("count 6"))
        moves(board, "head", "chase", {"count": 6})
        moves(board, "base", "carry", {"count": 6})
        assert (chase.process.poll(), carry.process.poll()) == (None, None)
