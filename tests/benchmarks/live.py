"""A running core and its clients in processes of their own, over tcp, beside bare sockets."""

from __future__ import annotations

import contextlib
import re
import shutil
import socket
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import zmq
from tests.benchmarks import peers
from tests.benchmarks.harness import (
    CPU,
    WALL,
    Bench,
    Goal,
    Missing,
    Row,
    Sample,
    each,
    library,
    rate,
)
from tests.benchmarks.messages import VALUE
from tests.benchmarks.peers import BACK, PATIENCE, THERE, topic
from tests.benchmarks.processes import CORE, core, line_of, peer, readable, started

import situ
from situ.blackboard import notices, topics, wire
from situ.blackboard.server import Server

NOTICES = 5_000
"""Fewer than a subscriber may leave waiting before it loses some."""

# -- set, be notified, set, be notified --------------------------------------

FORWARDS, ANSWERS = "pyzmq broker that forwards", "pyzmq broker that forwards and answers"

REDIS, REDIS_SOCKETS = "SET and PUBLISH by its client", "SET and PUBLISH by bare sockets"


@contextlib.contextmanager
def _trips() -> Iterator[Mapping[str, Sample]]:
    with contextlib.ExitStack() as stack:
        yield {
            CORE: stack.enter_context(_ours()),
            FORWARDS: stack.enter_context(_plain("")),
            ANSWERS: stack.enter_context(_plain("answer")),
        }


@contextlib.contextmanager
def _trips_beside_redis() -> Iterator[Mapping[str, Sample]]:
    with (
        # One each: they would answer each other's messages.
        _redis() as one,
        _redis() as other,
        _redis_client(one) as client,
        _redis_sockets(other) as sockets,
        _ours() as ours,
    ):
        yield {CORE: ours, REDIS: client, REDIS_SOCKETS: sockets}


@contextlib.contextmanager
def _ours() -> Iterator[Sample]:
    with (
        core() as (_, endpoint),
        situ.connect(endpoint, module="asks") as board,
        peer("module", endpoint),
    ):
        changes = board.watch(BACK)

        def trip() -> None:
            board.set(THERE, VALUE)
            if changes.next(PATIENCE) is None:
                raise RuntimeError("no change came back")

        yield _trips_of(trip)


@contextlib.contextmanager
def _plain(answer: str) -> Iterator[Sample]:
    with peer("forward", answer) as addresses, peer("forwarded", *addresses, answer):
        dealer, subscriber = peers.connected(addresses[0], addresses[1], BACK)
        frame = topic(THERE) + peers.BODY

        def trip() -> None:
            dealer.send(frame)
            if answer:
                dealer.recv()
            subscriber.recv()

        # Who subscribes is not heard at once.
        while not subscriber.poll(100):
            dealer.send(frame)
        while subscriber.poll(500):
            subscriber.recv()
        while dealer.poll(0):
            dealer.recv()
        with _patient(dealer, subscriber):
            yield _trips_of(trip)


@contextlib.contextmanager
def _redis() -> Iterator[str]:
    """The port of a Redis that keeps nothing on disk."""
    server = shutil.which("redis-server")
    if server is None:
        raise Missing("there is no redis-server: sudo apt-get install redis-server")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
    settings = ["--bind", "127.0.0.1", "--port", port, "--save", "", "--appendonly", "no"]
    process = subprocess.Popen([server, *settings], stdout=subprocess.DEVNULL)
    try:
        _listens(int(port))
        yield port
    finally:
        process.terminate()
        process.wait(PATIENCE)


def _listens(port: int) -> None:
    end = time.monotonic() + PATIENCE
    while True:
        try:
            return socket.create_connection(("127.0.0.1", port)).close()
        except ConnectionRefusedError:
            if time.monotonic() > end:
                raise
            time.sleep(0.01)


@contextlib.contextmanager
def _redis_client(port: str) -> Iterator[Sample]:
    """As people write it, with the library redis."""
    with (
        library("redis").Redis(port=int(port), socket_timeout=PATIENCE) as client,
        client.pubsub(ignore_subscribe_messages=True) as listening,
        peer("redis", port),
    ):
        listening.subscribe(BACK)
        listening.get_message(timeout=PATIENCE)

        def trip() -> None:
            client.pipeline(transaction=False).set(THERE, VALUE).publish(THERE, VALUE).execute()
            if listening.get_message(timeout=PATIENCE) is None:
                raise RuntimeError("no message came back")

        yield _trips_of(trip)


@contextlib.contextmanager
def _redis_sockets(port: str) -> Iterator[Sample]:
    """The least that a client can do: bytes that were made before, answers counted only."""
    with peers.RedisSockets(int(port), THERE, BACK) as redis, peer("redis_sockets", port):

        def trip() -> None:
            redis.send()
            redis.hear()

        yield _trips_of(trip)


def _trips_of(trip: Callable[[], None]) -> Sample:
    def trips(times: int) -> None:
        for _ in range(times):
            trip()

    return each(trips, WALL)


@contextlib.contextmanager
def _patient(*sockets: zmq.Socket[bytes]) -> Iterator[None]:
    """What does not come is an error, and nothing is left open."""
    for one in sockets:
        one.rcvtimeo = int(PATIENCE * 1000)
    try:
        yield
    finally:
        for one in sockets:
            one.close(linger=0)


# -- get ---------------------------------------------------------------------


@contextlib.contextmanager
def _gets() -> Iterator[Mapping[str, Sample]]:
    with (
        core() as (_, endpoint),
        situ.connect(endpoint, module="asks") as board,
        peer("echo") as addresses,
    ):
        board.set({THERE: VALUE, BACK: VALUE})
        board.watch(BACK)
        dealer: zmq.Socket[bytes] = zmq.Context.instance().socket(zmq.DEALER)
        dealer.connect(addresses[0])
        known = {BACK: VALUE}

        def ask() -> None:
            dealer.send(peers.BODY)
            dealer.recv()

        def cached(times: int) -> None:
            for _ in range(times):
                board.get(BACK)

        def lookup(times: int) -> None:
            for _ in range(times):
                known[BACK]

        with _patient(dealer):
            yield {
                "get": _trips_of(lambda: board.get(THERE)),
                "DEALER and ROUTER": _trips_of(ask),
                "get, watched": each(cached, CPU),
                "dict lookup": each(lookup, CPU),
            }


# -- notifications -----------------------------------------------------------


@contextlib.contextmanager
def _notifications() -> Iterator[Mapping[str, Sample]]:
    context: zmq.Context[zmq.Socket[bytes]] = zmq.Context.instance()
    local = "tcp://127.0.0.1:0"
    with contextlib.ExitStack() as stack:
        publisher = context.socket(zmq.XPUB)
        stack.callback(publisher.close, linger=0)
        publisher.sndhwm = 0
        publisher.bind("tcp://127.0.0.1:*")
        server = Server(local, local, context=context)
        stack.callback(server.close)
        address = publisher.getsockopt_string(zmq.LAST_ENDPOINT)
        frame = _notice(7)

        def send_raw() -> None:
            for _ in range(NOTICES):
                publisher.send(frame)

        def send_encoded() -> None:
            for number in range(NOTICES):
                server.send((), (_notice(number),))

        def send_one(frame: bytes) -> None:
            server.send((), (frame,))

        ours = _heard("encoded", server.notifications, send_one, send_encoded)
        beside = _heard("raw", address, publisher.send, send_raw)
        yield {
            "encoded and decoded": stack.enter_context(ours),
            "raw PUB/SUB": stack.enter_context(beside),
        }


def _notice(version: int) -> bytes:
    change = notices.Change(tag=THERE, value=VALUE, version=version, writer="asks", time=version)
    return wire.notice(topics.change(THERE), change)


@contextlib.contextmanager
def _heard(
    role: str, address: str, send: Callable[[bytes], Any], send_all: Callable[[], None]
) -> Iterator[Sample]:
    with started("-m", "tests.benchmarks.peers", role, address, str(NOTICES)) as process:
        assert process.stdout is not None
        # Who subscribes is not heard at once.
        while not readable(process.stdout, 0.05):
            send(b"hello")
        line_of(process)
        send(b"go")

        def batches(times: int) -> None:
            for _ in range(times):
                send_all()
                line_of(process)

        yield rate(batches, WALL, NOTICES)


# -- memory ------------------------------------------------------------------


@contextlib.contextmanager
def _memory() -> Iterator[Mapping[str, Sample]]:
    with core() as (running, _), started("-m", "tests.benchmarks.peers", "idle") as idle:
        line_of(idle)
        yield {CORE: _resident(running), "interpreter, pyzmq and lxml": _resident(idle)}


def _resident(process: subprocess.Popen[str]) -> Sample:
    """MB of a process that lie in memory, those that it shares with others too."""

    def sample() -> float:
        status = Path(f"/proc/{process.pid}/status").read_text()
        found = re.search(r"^VmRSS:\s+(\d+) kB$", status, re.MULTILINE)
        assert found is not None
        return int(found[1]) / 1024

    return sample


_TRIP = f"set, notified, set, notified in 3 processes ({CORE})"

BENCHES = (
    Bench(
        "round trip",
        (
            Row(_TRIP, "round trip", CORE, FORWARDS, "µs", Goal(1.25)),
            Row(f"{_TRIP}, beside one that answers", "round trip", CORE, ANSWERS, "µs"),
        ),
        _trips,
    ),
    Bench(
        "round trip beside Redis",
        (
            Row(f"{_TRIP}, beside Redis", "round trip", CORE, REDIS_SOCKETS, "µs"),
            Row(f"{_TRIP}, beside Redis and its client", "round trip", CORE, REDIS, "µs"),
        ),
        _trips_beside_redis,
    ),
    Bench(
        "get",
        (
            Row(f"remote get ({CORE})", "get", "get", "DEALER and ROUTER", "µs", Goal(1.25)),
            Row("get of a watched tag", "get", "get, watched", "dict lookup", "µs"),
        ),
        _gets,
    ),
    Bench(
        "notifications",
        (
            Row(
                "notifications one way",
                "notifications",
                "encoded and decoded",
                "raw PUB/SUB",
                "k/s",
                Goal(0.5, least=True),
            ),
        ),
        _notifications,
    ),
    Bench(
        "memory",
        (
            Row(
                f"memory ({CORE})",
                "memory",
                CORE,
                "interpreter, pyzmq and lxml",
                "MB",
                Goal(30.0, of="more"),
            ),
        ),
        _memory,
    ),
)
