"""What waits for those who do not read is bounded by bytes (docs/protocol.md, *Staying
without a gap*)."""

from __future__ import annotations

import contextlib
import select
from collections.abc import Callable, Iterator

import pytest
import zmq

from situ.blackboard.outbox import LARGE, Outbox
from situ.blackboard.server import Server

DEADLINE = 20_000
"""Milliseconds."""
HELD = 10_000
LIMIT = 8_000_000
SIZE = 500_000
"""A hundred of them are far more than the system itself keeps for a connection."""
CAME, GONE = b"\x01", b"\x00"

Make = Callable[..., zmq.Socket[bytes]]


@pytest.fixture
def make() -> Iterator[Make]:
    """A socket with options by name; waits at most ``DEADLINE`` ms for anything."""
    context: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
    all_made: list[zmq.Socket[bytes]] = []

    def made(kind: int, **options: int) -> zmq.Socket[bytes]:
        socket = context.socket(kind)
        all_made.append(socket)
        given = {"LINGER": 0, "RCVTIMEO": DEADLINE, "SNDTIMEO": DEADLINE, **options}
        for name, value in given.items():
            socket.setsockopt(getattr(zmq, name), value)
        return socket

    yield made
    for socket in all_made:
        socket.close()
    context.term()


def publish(make: Make, where: str = "tcp://127.0.0.1:*") -> tuple[zmq.Socket[bytes], str]:
    """A publisher that tells of every subscriber who comes or goes, and its address."""
    socket = make(zmq.XPUB, SNDHWM=HELD, XPUB_VERBOSER=1)
    socket.bind(where)
    return socket, socket.getsockopt_string(zmq.LAST_ENDPOINT)


def subscribe(make: Make, publisher: zmq.Socket[bytes], address: str) -> zmq.Socket[bytes]:
    """A subscriber of whom the publisher knows. It takes one message before it is asked."""
    socket = make(zmq.SUB, RCVHWM=1, RCVBUF=100_000)
    socket.subscribe(b"")
    socket.connect(address)
    assert publisher.recv() == CAME
    return socket


def test_who_does_not_read_is_cut_off_and_the_others_lose_nothing(
    make: Make, caplog: pytest.LogCaptureFixture
) -> None:
    publisher, address = publish(make)
    outbox = Outbox(publisher, address, LIMIT)
    reading = [subscribe(make, publisher, address) for _ in range(2)]
    stalled = subscribe(make, publisher, address)
    for number in range(100):
        message = b"%d " % number + bytes(SIZE)
        outbox.send(message)
        assert outbox.waiting <= 2 * LIMIT + SIZE
        for socket in reading:
            assert socket.recv() == message
    assert publisher.recv() == GONE
    (warning,) = caplog.records
    assert "does not read what it is sent, and 8 MB wait" in warning.getMessage()
    # Once it reads, it is back by itself and hears what is sent from now on.
    heard = [stalled.recv()]
    while not publisher.poll(0):
        heard += [stalled.recv()] if stalled.poll(0) else []
    assert publisher.recv() == CAME
    outbox.send(b"now")
    while heard[-1] != b"now":
        heard.append(stalled.recv())
    assert [message[:2] for message in heard[:3]] == [b"0 ", b"1 ", b"2 "]


def test_the_slowest_is_cut_off_where_all_read(make: Make) -> None:
    publisher, address = publish(make)
    outbox = Outbox(publisher, address, LIMIT)
    fast, slow = (subscribe(make, publisher, address) for _ in range(2))
    number = 0
    while not publisher.poll(0):
        number += 1
        message = b"%d " % number + bytes(SIZE)
        outbox.send(message)
        assert outbox.waiting <= 2 * LIMIT + SIZE
        if number % 5 == 0 and slow.poll(0):
            slow.recv()
        assert fast.recv() == message
    assert publisher.recv() == GONE


def test_replies_to_who_does_not_read_are_bounded_too(make: Make) -> None:
    router = make(zmq.ROUTER, SNDHWM=HELD, ROUTER_MANDATORY=1)
    router.bind("tcp://127.0.0.1:*")
    address = router.getsockopt_string(zmq.LAST_ENDPOINT)
    outbox = Outbox(router, address, LIMIT)
    client = make(zmq.DEALER, RCVHWM=1, RCVBUF=100_000)
    client.connect(address)
    client.send(b"everything, often")
    peer, _ = router.recv_multipart()

    def is_there() -> bool:
        try:
            outbox.send(bytes(SIZE), peer)
        except zmq.ZMQError as error:
            if error.errno != zmq.EHOSTUNREACH:
                raise
            return False
        return True

    while is_there():
        assert outbox.waiting <= 2 * LIMIT + SIZE


def test_where_nobody_can_be_cut_off_large_messages_are_dropped(make: Make) -> None:
    publisher, address = publish(make, "inproc://notices")
    outbox = Outbox(publisher, address, LIMIT)
    stalled = subscribe(make, publisher, address)
    for _ in range(100):
        outbox.send(bytes(SIZE))
    assert 2 * LIMIT <= outbox.waiting <= 2 * LIMIT + SIZE
    # Small ones still come, and once it reads, large ones too.
    outbox.send(b"small")
    while stalled.recv() != b"small":
        pass
    while outbox.waiting:
        pass
    outbox.send(bytes(LARGE))
    assert stalled.recv() == bytes(LARGE)


def test_requests_that_the_core_has_no_time_for_stay_with_the_client(make: Make) -> None:
    context: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
    server = Server("tcp://127.0.0.1:0", "tcp://127.0.0.1:0", context=context)
    client = make(zmq.DEALER, SNDHWM=1, SNDTIMEO=200)
    client.connect(server.requests)
    sent = 0
    with contextlib.suppress(zmq.Again):
        while sent < 200:
            client.send(b"%d " % sent + bytes(2 * SIZE))
            sent += 1
    assert sent < 200
    came: list[bytes] = []
    poll = select.poll()
    for descriptor in server.descriptors():
        poll.register(descriptor, select.POLLIN)
    while len(came) < sent:
        more = server.drain(lambda peer, body, who: came.append(body), lambda: None)
        assert more or len(came) == sent or poll.poll(DEADLINE)
    assert [body.split()[0] for body in came] == [b"%d" % number for number in range(sent)]
    server.close()
    context.term()
