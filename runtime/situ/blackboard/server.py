"""The ZeroMQ door: a ROUTER for requests, an XPUB for notices; no decisions.

No loop of its own: whoever owns it waits for ``descriptors`` and calls ``drain``.
"""

from __future__ import annotations

import ipaddress
from collections.abc import Callable, Iterable
from typing import Any
from urllib.parse import urlsplit

import zmq

from situ.blackboard import protocol
from situ.blackboard.link import NOW, has_come
from situ.errors import UsageError

TURN = 500
"""Messages taken in one ``drain``, so that a flood leaves time for what falls due."""
TOGETHER = 50
"""Messages that are answered together: what they bring about is written down at once."""
HELD = 10_000
"""Notices kept for a subscriber that does not read; then it loses some, and finds the gap."""


class Server:
    """Bound sockets; ``requests`` and ``notifications`` are their addresses as bound.

    Raises ``UsageError`` where an address is none, is taken, or is not loopback:
    without keys a blackboard is open, so it stays on its own machine.
    """

    def __init__(
        self, requests: str, notifications: str, *, context: zmq.Context[zmq.Socket[bytes]]
    ) -> None:
        self._router = context.socket(zmq.ROUTER)
        self._publisher = context.socket(zmq.XPUB)
        try:
            for socket in (self._router, self._publisher):
                socket.linger = 200
                socket.setsockopt(zmq.MAXMSGSIZE, protocol.MAXIMUM)
                socket.setsockopt(zmq.SNDHWM, HELD)
            # Else a reply to who has gone would vanish unseen and a slow one would block.
            self._router.setsockopt(zmq.ROUTER_MANDATORY, 1)
            self.requests = _bind(self._router, requests)
            self.notifications = _bind(self._publisher, notifications)
        except BaseException:
            self.close()
            raise

    def descriptors(self) -> tuple[int, int]:
        """To wait on for reading. They tell of a change once, so ``drain`` to the end."""
        return self._router.fileno(), self._publisher.fileno()

    def drain(self, received: Callable[[bytes, bytes], None], answer: Callable[[], None]) -> bool:
        """Takes what has come and gives it to ``received``; ``answer`` is to ``send`` what follows,
        once for all that came together (at most ``TOGETHER``). Echoes new subscribers.

        True where more may be waiting: then call again soon, the descriptors may not tell.
        """
        taken = 0
        for _ in range(TURN):
            if not has_come(self._router):
                if not taken:
                    return self._subscriptions()
                taken = 0
                answer()
                continue
            peer, *frames = self._router.recv_multipart(NOW)
            # A request is one frame; of anything else the sessions say what is wrong.
            received(peer, frames[0] if len(frames) == 1 else b"")
            taken += 1
            if taken == TOGETHER:
                taken = 0
                answer()
        if taken:
            answer()
        return True

    def _subscriptions(self) -> bool:
        for _ in range(TURN):
            if not has_come(self._publisher):
                return False
            frame = self._publisher.recv(NOW)
            if frame.startswith(b"\x01" + protocol.ECHO):
                self._publisher.send(frame[1:] + b"\n" + _ECHO, NOW)
        return True

    def send(self, replies: Iterable[tuple[Any, bytes]], notices: Iterable[bytes]) -> None:
        """Sends; a peer that has gone or does not read loses its reply.

        Sending can hide that something came in: ``drain`` afterwards.
        """
        for notice in notices:
            self._publisher.send(notice, NOW)
        for peer, body in replies:
            try:
                self._router.send(peer, _MORE)
                self._router.send(body, NOW)
            except zmq.ZMQError as error:
                if error.errno not in (zmq.EAGAIN, zmq.EHOSTUNREACH):
                    raise

    def close(self) -> None:
        self._router.close()
        self._publisher.close()


_ECHO = protocol.encode(protocol.Echo())
_MORE = NOW | int(zmq.SNDMORE)


def _bind(socket: zmq.Socket[bytes], address: str) -> str:
    check_local(address)
    if address.startswith("tcp://") and address.endswith(":0"):
        address = address[:-1] + "*"
    try:
        socket.bind(address)
    except zmq.ZMQError as error:
        raise UsageError(f"{address}: {error.strerror}; give another address or port 0") from None
    return socket.getsockopt_string(zmq.LAST_ENDPOINT)


def check_local(address: str) -> None:
    """Raises ``UsageError`` unless only this machine can reach what is bound there."""
    if address.startswith(("ipc://", "inproc://")):
        return
    parts = urlsplit(address)
    if parts.scheme not in ("tcp", "http") or not parts.hostname:
        raise UsageError(f"{address}: no address; write it as tcp://127.0.0.1:5570")
    port = parts.netloc.rpartition(":")[2]
    if port.lstrip("-").isdigit() and not 0 <= int(port) <= 65535:
        raise UsageError(f"{address}: there is no port {port}; choose one up to 65535, or 0")
    try:
        local = ipaddress.ip_address(parts.hostname).is_loopback
    except ValueError:
        local = parts.hostname == "localhost"
    if not local:
        raise UsageError(
            f"{address} can be reached from other machines, and a blackboard without keys "
            "is open to all of them: bind it to 127.0.0.1"
        )
