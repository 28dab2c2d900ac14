"""The other processes of the live benches: ``python -m tests.benchmarks.peers ROLE …``.

A peer says ``ready`` and its addresses in a line on standard output, and ends with its
standard input, so that none outlives who started it.
"""

from __future__ import annotations

import os
import socket
import sys
import threading
from collections.abc import Callable

import zmq
from tests.benchmarks.harness import library
from tests.benchmarks.messages import VALUE

THERE, BACK = "bench.there", "bench.back"
"""Tags, topics and channels of a round trip."""
PATIENCE = 20.0
"""Seconds after which what was not answered never will be."""

BODY = VALUE.encode()


def topic(tag: str) -> bytes:
    return b"t:%s\n" % tag.encode()


def forward(answer: str = "") -> None:
    """The least that a broker can do: what comes in at the ROUTER goes out at the XPUB.

    answer: not empty: who sent it is told so, as whoever sets a tag is.
    """
    router, publisher = _bound(zmq.ROUTER), _bound(zmq.XPUB)
    _say("ready", _address(router), _address(publisher))
    while True:
        peer, frame = router.recv_multipart()
        publisher.send(frame)
        if answer:
            router.send_multipart((peer, b"done"))


def forwarded(requests: str, notifications: str, answer: str = "") -> None:
    """Sends back what it hears through such a broker."""
    dealer, subscriber = connected(requests, notifications, THERE)
    _say("ready")
    while True:
        subscriber.recv()
        dealer.send(topic(BACK) + BODY)
        if answer:
            dealer.recv()


def connected(
    requests: str, notifications: str, tag: str
) -> tuple[zmq.Socket[bytes], zmq.Socket[bytes]]:
    """The sockets of a client of such a broker."""
    context: zmq.Context[zmq.Socket[bytes]] = zmq.Context.instance()
    dealer, subscriber = context.socket(zmq.DEALER), context.socket(zmq.SUB)
    subscriber.setsockopt(zmq.SUBSCRIBE, topic(tag))
    subscriber.connect(notifications)
    dealer.connect(requests)
    return dealer, subscriber


def echo() -> None:
    """A ROUTER that sends everything back."""
    router = _bound(zmq.ROUTER)
    _say("ready", _address(router))
    while True:
        router.send_multipart(router.recv_multipart())


def module(endpoint: str) -> None:
    """A module as people write them: it sets a tag whenever another changes."""
    import situ

    with situ.connect(endpoint, module="answers") as board:
        changes = board.watch(THERE)
        _say("ready")
        for change in changes:
            board.set(BACK, change.value)


def redis(port: str) -> None:
    """The same with Redis: SET and PUBLISH in one pipeline."""
    client = library("redis").Redis(port=int(port))
    listening = client.pubsub(ignore_subscribe_messages=True)
    listening.subscribe(THERE)
    _say("ready")
    for heard in listening.listen():
        client.pipeline(transaction=False).set(BACK, heard["data"]).publish(
            BACK, heard["data"]
        ).execute()


class RedisSockets:
    """A client of Redis that knows beforehand what will come, and only counts the bytes.

    ``send`` sets and publishes at ``to``; ``hear`` takes what was published at ``back``.
    """

    def __init__(self, port: int, to: str, back: str) -> None:
        self._ask = socket.create_connection(("127.0.0.1", port), PATIENCE)
        self._hear = socket.create_connection(("127.0.0.1", port), PATIENCE)
        for one in (self._ask, self._hear):
            one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._hear.sendall(_redis_words("SUBSCRIBE", back))
        self._hear.recv(4096)
        self._request = _redis_words("SET", to, VALUE) + _redis_words("PUBLISH", to, VALUE)
        self._heard = len(_redis_words("message", back, VALUE))

    def send(self) -> None:
        self._ask.sendall(self._request)
        _receive(self._ask, len(b"+OK\r\n:1\r\n"))

    def hear(self) -> None:
        _receive(self._hear, self._heard)

    def __enter__(self) -> RedisSockets:
        return self

    def __exit__(self, *_: object) -> None:
        self._ask.close()
        self._hear.close()


def _redis_words(*words: str) -> bytes:
    parts = "".join(f"${len(word)}\r\n{word}\r\n" for word in words)
    return f"*{len(words)}\r\n{parts}".encode()


def _receive(one: socket.socket, length: int) -> None:
    while length > 0:
        length -= len(one.recv(length)) or length


def redis_sockets(port: str) -> None:
    """The same without a library."""
    with RedisSockets(int(port), BACK, THERE) as client:
        _say("ready")
        client._hear.settimeout(None)
        while True:
            client.hear()
            client.send()


def raw(address: str, count: str) -> None:
    """Takes ``count`` frames at a time and says so."""
    _take(address, int(count), lambda frame: None)


def encoded(address: str, count: str) -> None:
    """The same, each frame decoded as a notice."""
    from situ.blackboard import wire

    _take(address, int(count), wire.read_notice)


def _take(address: str, count: int, read: Callable[[bytes], object]) -> None:
    subscriber: zmq.Socket[bytes] = zmq.Context.instance().socket(zmq.SUB)
    subscriber.setsockopt(zmq.RCVHWM, 0)
    subscriber.setsockopt(zmq.SUBSCRIBE, b"")
    subscriber.connect(address)
    subscriber.recv()
    _say("ready")
    while subscriber.recv() != b"go":
        pass
    while True:
        for _ in range(count):
            read(subscriber.recv())
        _say("all")


def idle() -> None:
    """An interpreter that has imported pyzmq and lxml, and waits."""
    from lxml import etree

    etree.fromstring(b"<x/>")
    zmq.Context.instance().socket(zmq.ROUTER)
    _say("ready")
    threading.Event().wait()


def _bound(kind: int) -> zmq.Socket[bytes]:
    bound: zmq.Socket[bytes] = zmq.Context.instance().socket(kind)
    bound.bind("tcp://127.0.0.1:*")
    return bound


def _address(bound: zmq.Socket[bytes]) -> str:
    return bound.getsockopt_string(zmq.LAST_ENDPOINT)


def _say(*words: str) -> None:
    print(*words, flush=True)


def _until_alone() -> None:
    sys.stdin.buffer.read()
    os._exit(0)


ROLES: dict[str, Callable[..., None]] = {
    role.__name__: role
    for role in (forward, forwarded, echo, module, redis, redis_sockets, raw, encoded, idle)
}

if __name__ == "__main__":
    threading.Thread(target=_until_alone, daemon=True).start()
    ROLES[sys.argv[1]](*sys.argv[2:])
