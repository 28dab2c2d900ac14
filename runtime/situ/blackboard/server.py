"""The ZeroMQ door: a ROUTER for requests, an XPUB for notices; no decisions.

No loop of its own: whoever owns it waits for ``descriptors`` and calls ``drain``.
"""

from __future__ import annotations

import ipaddress
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import zmq
from zmq.backend import zmq_poll

from situ.blackboard import notices, topics, wire
from situ.blackboard.identity import Identity
from situ.blackboard.keys import RobotKeys
from situ.blackboard.link import INCOMING, MORE, NOW
from situ.blackboard.outbox import Outbox
from situ.errors import UsageError

if TYPE_CHECKING:
    from situ.blackboard.gate import Gate

TURN = 500
"""Messages taken in one ``drain``, so that a flood leaves time for what falls due."""
TOGETHER = 50
"""Messages that are answered together: what they bring about is written down at once."""
HELD = 10_000
"""Notices kept for a subscriber that does not read; then it loses some, and finds the gap. Large
ones are bounded by their bytes (``Outbox``)."""
SHAKE = 5_000
"""Milliseconds in which a connection must have shown that it speaks ZeroMQ, with a known key."""

MaySubscribe = Callable[[Identity | None, bytes], bool]
"""Whether somebody may hear what is published under topics that begin so; None: an unknown key."""

Received = Callable[[bytes, bytes, Identity | None], None]
"""Is given a peer, what it sends, and with keys who that is."""


class Server:
    """Bound sockets; ``requests`` and ``notifications`` are their addresses as bound.

    keys: only whom they know gets in; without them everybody does, so that an address that
    other machines can reach is refused, but for ``insecure``. ``gate`` is None without keys; with
    them ``may_subscribe`` is asked about each topic, and what is not allowed is not heard.

    Raises ``UsageError`` where an address is none, is taken, or may not be bound.
    """

    def __init__(
        self,
        requests: str,
        notifications: str,
        *,
        context: zmq.Context[zmq.Socket[bytes]],
        keys: RobotKeys | None = None,
        insecure: bool = False,
    ) -> None:
        for address in (requests, notifications):
            check_reach(address, keyed=keys is not None, insecure=insecure)
        self.gate: Gate | None = None
        self.may_subscribe: MaySubscribe = lambda who, topic: True
        if keys is not None:
            # Here: a core without keys does without asyncio, which the monitor's module wants.
            from situ.blackboard.gate import Gate

            self.gate = Gate(keys, context)
        self._router = context.socket(zmq.ROUTER)
        self._publisher = context.socket(zmq.XPUB)
        try:
            if self.gate is not None:
                self.gate.guard(self._router, "requests")
                self.gate.guard(self._publisher, "notifications")
                # Each subscription comes here, and counts when it is set for the one who asked.
                self._publisher.setsockopt(zmq.XPUB_MANUAL, 1)
            for socket in (self._router, self._publisher):
                socket.linger = 200
                socket.setsockopt(zmq.MAXMSGSIZE, wire.MAXIMUM)
                socket.setsockopt(zmq.SNDHWM, HELD)
                socket.setsockopt(zmq.HANDSHAKE_IVL, SHAKE)
            # More than are answered together need not wait here: the rest stays with the client.
            self._router.setsockopt(zmq.RCVHWM, TOGETHER)
            # Else a reply to who has gone would vanish unseen and a slow one would block.
            self._router.setsockopt(zmq.ROUTER_MANDATORY, 1)
            self.requests = _bind(self._router, requests)
            self.notifications = _bind(self._publisher, notifications)
            self._sockets = [(self._router, INCOMING), (self._publisher, INCOMING)]
            self._replies = Outbox(self._router, self.requests)
            self._notices = Outbox(self._publisher, self.notifications)
        except BaseException:
            self.close()
            raise

    def descriptors(self) -> tuple[int, ...]:
        """To wait on for reading. They tell of a change once, so ``drain`` to the end."""
        guards = self.gate.descriptors() if self.gate is not None else ()
        return self._router.fileno(), self._publisher.fileno(), *guards

    def drain(self, received: Received, answer: Callable[[], None]) -> bool:
        """Takes what has come and gives it to ``received``; ``answer`` is to ``send`` what follows,
        once for all that came together (at most ``TOGETHER``). Echoes new subscribers.

        True where more may be waiting: then call again soon, the descriptors may not tell.
        """
        gate = self.gate
        if gate is not None and gate.drain():
            # Nobody but the client itself can tell which connections are a key's.
            self._replies.close_all()
            self._notices.close_all()
        # Who comes alone does not wait for another look; what came meanwhile is taken together.
        taken, together = 0, 1
        for _ in range(TURN):
            come = zmq_poll(self._sockets, 0)
            if not come and not taken:
                return False
            for socket, _ in come:
                if socket is self._publisher:
                    self._subscribed()
                else:
                    self._take(received)
                    taken += 1
            if taken and (not come or taken == together):
                taken, together = 0, TOGETHER
                answer()
        if taken:
            answer()
        return True

    def _take(self, received: Received) -> None:
        """One message. A request is one frame; of anything else the sessions say what is wrong."""
        router, gate = self._router, self.gate
        if gate is not None:
            first, *parts = router.recv_multipart(NOW, copy=False)
            body = parts[0].bytes if len(parts) == 1 else b""
            received(first.bytes, body, gate.who(parts[-1]))
            return
        peer, body = router.recv(NOW), router.recv(NOW)
        if router.getsockopt(MORE):
            router.recv_multipart(NOW)
            body = b""
        received(peer, body, None)

    def _subscribed(self) -> None:
        if self.gate is None:
            frame = self._publisher.recv(NOW)
        else:
            asked = self._publisher.recv(NOW, copy=False)
            frame = asked.bytes
            topic = frame[1:]
            if frame[:1] != b"\x01":
                self._publisher.setsockopt(zmq.UNSUBSCRIBE, topic)
            elif self.may_subscribe(self.gate.who(asked), topic):
                self._publisher.setsockopt(zmq.SUBSCRIBE, topic)
            else:
                return
        if frame.startswith(b"\x01" + topics.ECHO):
            self._publisher.send(frame[1:] + b"\n" + _ECHO, NOW)

    def subscribe_anew(self) -> None:
        """What somebody may hear is another now: with keys all show theirs and subscribe again."""
        if self.gate is not None:
            self._notices.close_all()

    def send(self, replies: Iterable[tuple[Any, bytes]], notices: Iterable[bytes]) -> None:
        """Sends; a peer that has gone or does not read loses its reply.

        Sending can hide that something came in: ``drain`` afterwards.
        """
        for notice in notices:
            self._notices.send(notice)
        for peer, body in replies:
            try:
                self._replies.send(body, peer)
            except zmq.ZMQError as error:
                if error.errno not in (zmq.EAGAIN, zmq.EHOSTUNREACH):
                    raise

    def close(self) -> None:
        if self.gate is not None:
            self.gate.close()
        self._router.close()
        self._publisher.close()


_ECHO = wire.encode(notices.Echo())


def _bind(socket: zmq.Socket[bytes], address: str) -> str:
    if address.startswith("tcp://") and address.endswith(":0"):
        address = address[:-1] + "*"
    try:
        socket.bind(address)
    except zmq.ZMQError as error:
        raise UsageError(f"{address}: {error.strerror}; give another address or port 0") from None
    return socket.getsockopt_string(zmq.LAST_ENDPOINT)


def check_reach(address: str, *, keyed: bool, insecure: bool) -> None:
    """Raises ``UsageError`` where something may not be bound there: for want of keys, unless that
    is ``insecure`` on purpose, or because it is no address."""
    if is_local(address) or keyed or insecure:
        return
    raise UsageError(
        f"{address} can be reached from other machines, and a blackboard without keys is open to "
        "all of them: make keys with situ keys new, bind it to 127.0.0.1, or say --insecure"
    )


def is_local(address: str) -> bool:
    """Whether only this machine can reach what is bound there; ``UsageError`` if it is none."""
    if address.startswith(("ipc://", "inproc://")):
        return True
    parts = urlsplit(address)
    if parts.scheme not in ("tcp", "http") or not parts.hostname:
        raise UsageError(f"{address}: no address; write it as tcp://127.0.0.1:5570")
    port = parts.netloc.rpartition(":")[2]
    if port.lstrip("-").isdigit() and not 0 <= int(port) <= 65535:
        raise UsageError(f"{address}: there is no port {port}; choose one up to 65535, or 0")
    try:
        return ipaddress.ip_address(parts.hostname).is_loopback
    except ValueError:
        return parts.hostname == "localhost"
