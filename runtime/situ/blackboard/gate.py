"""Who gets in: CURVE on the server's sockets, and the answers that ZeroMQ asks for (ZAP, RFC 27).

No thread: the sockets of a gate are drained by whoever drains the server's.
"""

from __future__ import annotations

import contextlib
import errno
import os
import socket as sockets
import time
from collections.abc import Callable
from typing import Any

import zmq
from zmq.utils import z85
from zmq.utils.monitor import parse_monitor_message

from situ.blackboard.audit import Audit
from situ.blackboard.identity import Identity
from situ.blackboard.keys import RobotKeys
from situ.blackboard.link import NOW, has_come

ZAP = "inproc://zeromq.zap.01"
LOOK = 1.0
"""Seconds after which a key that was added or removed counts, at the latest."""
_FAILED = int(zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL) | int(zmq.EVENT_HANDSHAKE_FAILED_NO_DETAIL)
_ENDED = int(zmq.EVENT_DISCONNECTED)


class Gate:
    """Made before the sockets that it guards are bound; one for each context."""

    def __init__(
        self,
        keys: RobotKeys,
        context: zmq.Context[zmq.Socket[bytes]],
        *,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.audit = Audit(clock)
        self._keys = keys
        self._clock = clock
        self._looked = clock()
        self._gone = False
        self._monitors: list[_Monitor] = []
        self._zap = context.socket(zmq.REP)
        self._zap.linger = 0
        self._zap.bind(ZAP)

    def guard(self, socket: zmq.Socket[bytes], name: str) -> None:
        """Nobody gets in there without a key that is known. name: for the log."""
        socket.curve_server = True
        socket.curve_publickey = self._keys.public
        socket.curve_secretkey = self._keys.secret
        socket.zap_domain = name.encode()
        self._monitors.append(_Monitor(socket, name))

    def descriptors(self) -> tuple[int, ...]:
        return self._zap.fileno(), *(monitor.socket.fileno() for monitor in self._monitors)

    def drain(self) -> bool:
        """Answers who asks to come in; reads the keys anew where that is due. True where somebody
        is known no longer: all are to show their keys again."""
        now = self._clock()
        if now >= self._looked + LOOK:
            self._looked = now
            self._gone = self._keys.refresh()
        while has_come(self._zap):
            self._zap.send_multipart(self._admit(self._zap.recv_multipart(NOW)), NOW)
        for monitor in self._monitors:
            for address, why in monitor.refused():
                self.audit.refuse("refused", socket=monitor.name, address=address, why=why)
        gone, self._gone = self._gone, False
        return gone

    def _admit(self, asked: list[bytes]) -> list[bytes]:
        version, number, domain, address, _, mechanism, *credentials = asked
        fields = {"socket": domain.decode(), "address": address.decode("utf-8", "replace")}
        if mechanism != b"CURVE" or len(credentials) != 1 or len(credentials[0]) != 32:
            self.audit.refuse("refused", **fields, why="it does not speak CURVE")
            return [version, number, b"400", b"no key", b"", b""]
        key = z85.encode(credentials[0]).decode()
        who = self._keys.identity(key)
        if who is None:
            # It may have been added a moment ago.
            self._gone = self._keys.refresh() or self._gone
            who = self._keys.identity(key)
        if who is None:
            self.audit.refuse("refused", **fields, key=key, why="nobody known has this key")
            return [version, number, b"400", b"unknown key", b"", b""]
        self.audit.tell("connected", **fields, name=who.name, role=who.role, key=key)
        # By the key, not the name: a name may be given to another key while this one is connected.
        return [version, number, b"200", b"", key.encode(), b""]

    def who(self, frame: zmq.Frame) -> Identity | None:
        """Who sent this frame; None: nobody who is known any longer."""
        try:
            key: Any = frame.get("User-Id")
        except zmq.ZMQError:
            return None
        return self._keys.identity(key)

    def close(self) -> None:
        """Before the sockets that it guards."""
        for monitor in self._monitors:
            monitor.close()
        self._zap.close()


class _Monitor:
    """Finds out about those who end before they have shown a key: nobody asks ZAP about them."""

    def __init__(self, socket: zmq.Socket[bytes], name: str) -> None:
        self.name = name
        self._watched = socket
        accepted = int(zmq.EVENT_ACCEPTED)
        self.socket = socket.get_monitor_socket(accepted | _FAILED | _ENDED)
        self._addresses: dict[int, str] = {}
        self._failed: str | None = None

    def refused(self) -> list[tuple[str, str]]:
        """The addresses of those that did not come in since the last call, and why."""
        found = []
        while has_come(self.socket):
            event = parse_monitor_message(self.socket.recv_multipart(NOW))
            kind, value = int(event["event"]), int(event["value"])
            if kind == int(zmq.EVENT_ACCEPTED):
                self._addresses[value] = _address(value)
            elif kind == _ENDED:
                # The end of a connection follows its failure, and only it has the descriptor.
                address = self._addresses.pop(value, "unknown")
                if self._failed is not None:
                    found.append((address, self._failed))
                    self._failed = None
            else:
                self._failed = _why(kind, value)
        return found

    def close(self) -> None:
        self.refused()
        self._watched.disable_monitor()
        self.socket.close(0)


def _why(kind: int, value: int) -> str:
    """What a failed handshake was: where ZeroMQ has no detail, value is what the system said."""
    if kind == int(zmq.EVENT_HANDSHAKE_FAILED_NO_DETAIL):
        if value in (errno.EPIPE, errno.ECONNRESET):
            return "it went away before it had shown a key"
        if value == errno.EAGAIN:
            return "it has not shown a key in time"
    return "it does not speak CURVE, or not with this robot's key"


def _address(descriptor: int) -> str:
    """Of whom is at the other end; it may have gone by now."""
    with contextlib.suppress(OSError), sockets.socket(fileno=os.dup(descriptor)) as connection:
        return str(connection.getpeername()[0])
    return "unknown"
