"""What waits to leave by a socket, bounded by bytes: who does not read is cut off.

ZeroMQ bounds what waits for a peer by the number of messages, and 10,000 of 16 MB are more than
any robot has. So it is followed when each of the ``LARGE`` ones has left for the last of them.
"""

from __future__ import annotations

import contextlib
import logging
import os
import socket
import struct
from collections import deque
from collections.abc import Iterator
from functools import partial
from urllib.parse import urlsplit

import zmq
from zmq.backend import Socket as BareSocket

from situ.blackboard.link import NOW, has_come

LARGE = 4_096
"""Bytes from which on a message counts."""
LIMIT = 64_000_000
"""Bytes that may wait before somebody is cut off."""

Peer = tuple[str, int]
"""Its address."""

_log = logging.getLogger("situ.blackboard")


class Outbox:
    """Sends by a socket that is bound to ``address``, without waiting for anybody.

    Where ``limit`` bytes of large messages wait, the connections are closed that have taken
    nothing since it was half as many, or the slowest where all have taken something: such a
    client connects again by itself, and the versions tell it what it has missed. Where that does
    not help (on another transport than tcp, on another system than Linux), large messages are
    dropped at twice the limit, for everybody.
    """

    def __init__(self, zmq_socket: zmq.Socket[bytes], address: str, limit: int = LIMIT) -> None:
        self._socket = zmq_socket
        # The one below pyzmq's own, which first looks for what only other kinds of sockets have.
        self._send = partial(BareSocket.send, zmq_socket)
        self._port = urlsplit(address).port if address.startswith("tcp://") else None
        self._limit = limit
        self._waiting: deque[tuple[zmq.MessageTracker, int]] = deque()
        self._bytes = 0
        # How much each had taken when it was last looked at, and the bytes sent since.
        self._seen: dict[Peer, int] | None = None
        self._since = 0

    @property
    def waiting(self) -> int:
        """Bytes of large messages that have not left."""
        while self._waiting and self._waiting[0][0].done:
            self._bytes -= self._waiting.popleft()[1]
        return self._bytes

    def send(self, message: bytes, peer: bytes | None = None) -> None:
        """peer: for whom, where the socket is a ROUTER. Raises zmq.ZMQError as the socket does."""
        large = len(message) >= LARGE
        if large and not self._has_room(len(message)):
            return
        if peer is not None:
            self._send(peer, _MORE)
        if not large:
            self._send(message, NOW)
        else:
            frame = zmq.Frame(message, track=True, copy=False)
            self._socket.send(frame, NOW, copy=False)
            assert isinstance(frame.tracker, zmq.MessageTracker)
            self._waiting.append((frame.tracker, len(message)))
            self._bytes += len(message)

    def _has_room(self, size: int) -> bool:
        waiting = self.waiting
        if waiting < self._limit // 2:
            self._seen = None
            return True
        self._since += size
        if self._seen is None:
            self._look()
        elif waiting >= self._limit and self._since >= self._limit // 2:
            self._cut_off(self._seen)
            # What a closed connection held is let go a little later.
            self._look()
        if waiting < 2 * self._limit:
            return True
        # Nothing is sent, so that ZeroMQ would not even hear of connections that have ended.
        has_come(self._socket)
        return False

    def _look(self) -> None:
        self._seen = {peer: taken for peer, taken, _ in self._progress()}
        self._since = 0

    def _cut_off(self, seen: dict[Peer, int]) -> None:
        """Closes the connections that have taken least since."""
        slow = {
            peer: taken - seen[peer]
            for peer, taken, behind in self._progress()
            if behind and peer in seen
        }
        least = min(slow.values(), default=0)
        for one in self._connections():
            peer = _peer(one)
            if slow.get(peer) == least:
                _log.warning(
                    "%s:%d does not read what it is sent, and %d MB wait: its connection is "
                    "closed; it may connect again",
                    *(*peer, self._bytes // 1_000_000),
                )
                with contextlib.suppress(OSError):
                    one.shutdown(socket.SHUT_RDWR)

    def close_all(self) -> None:
        """Closes every connection: who may, connects again."""
        for one in self._connections():
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)

    def _progress(self) -> Iterator[tuple[Peer, int, bool]]:
        """Each peer, how many bytes its machine has taken, and whether more wait for it."""
        for one in self._connections():
            state = one.getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, _TAKEN.size)
            taken, unsent = _TAKEN.unpack(state)
            yield _peer(one), taken, bool(unsent)

    def _connections(self) -> Iterator[socket.socket]:
        """Those that were made to our port; good until the next one is asked for.

        ZeroMQ does not hand them out; it may close one of them at any moment, but not these
        duplicates.
        """
        if self._port is None or not hasattr(socket, "TCP_INFO"):
            return
        for name in os.listdir("/dev/fd"):
            with contextlib.suppress(OSError):
                yield from _taken_at(self._port, os.dup(int(name)))


def _taken_at(port: int, descriptor: int) -> Iterator[socket.socket]:
    """The connection behind a descriptor, if it is one that was made to the port; closes it."""
    try:
        one = socket.socket(fileno=descriptor)
    except OSError:
        os.close(descriptor)
        return
    with one:
        if one.family in _INTERNET and one.type == socket.SOCK_STREAM:
            one.getpeername()
            if one.getsockname()[1] == port:
                yield one


def _peer(one: socket.socket) -> Peer:
    host, port, *_ = one.getpeername()
    return host, port


_MORE = NOW | int(zmq.SNDMORE)
_INTERNET = (socket.AF_INET, socket.AF_INET6)
_TAKEN = struct.Struct("<120xQ16xI")
"""Of Linux's tcp_info: tcpi_bytes_acked, tcpi_notsent_bytes."""
