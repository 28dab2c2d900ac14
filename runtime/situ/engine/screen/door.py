"""The WebSocket door of the blackboard: ``/board``, with the bodies of the ZeroMQ door.

A relay: every visitor gets two ZeroMQ sockets of his own to the core, so that sessions, leases
and roles stay the core's business, wherever the screen is served. docs/protocol.md, *The
WebSocket door*, has the frames.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque

import zmq
from aiohttp import WSCloseCode, WSMsgType, web

from situ.blackboard import protocol, wire
from situ.blackboard.audit import Audit
from situ.blackboard.curve import Curve, KeysOf
from situ.blackboard.link import HELD as NOTICES
from situ.blackboard.link import NOW, has_come

LARGEST = 1_000_000
"""Bytes of one frame that comes in."""
HELD = 4_000_000
"""Bytes that wait for a visitor who does not read, before his notices wait in ZeroMQ."""
PATIENCE = 0.5
"""Seconds that a visitor has to say goodbye."""
BEAT = 5.0
"""Seconds between two pings; who answers none for half as long is gone."""
MOST = 64
TOPICS = 10_000


class Door:
    """Lets visitors in, one task each, from ``open`` to ``close``.

    With a core that has keys every visitor's sockets bear the keys of his own token, so that the
    core knows him, and holds him to his rights, as anybody else.
    """

    def __init__(self) -> None:
        self._audit = Audit()
        self._core: tuple[str, str] | None = None
        self._keys: KeysOf | None = None
        self._context: zmq.Context[zmq.Socket[bytes]] | None = None
        self._visitors: dict[web.WebSocketResponse, _Relay] = {}

    def open(self, requests: str, notifications: str, keys: KeysOf | None = None) -> None:
        """Visitors are led to the core at these addresses. keys: None where it has none."""
        self._core = requests, notifications
        self._keys = keys

    @property
    def keyed(self) -> bool:
        """Whether a visitor needs a token of his own."""
        return self._keys is not None

    def knows(self, token: str) -> bool:
        """Whether, with keys, somebody has this token."""
        return self._keys is not None and self._keys(token) is not None

    async def close(self) -> None:
        self._core = None
        visitors = dict(self._visitors)
        bye = (v.close(code=WSCloseCode.GOING_AWAY, message=b"the robot stops") for v in visitors)
        await asyncio.gather(*bye)
        for relay in visitors.values():
            # Who is being sent away already has not let go of it yet, and the context would wait.
            relay.close()
        if self._context is not None:
            self._context.term()
            self._context = None

    async def visit(self, request: web.Request, token: str) -> web.StreamResponse:
        """One visitor until he goes. token: his own; without keys he may come in already."""
        curve = None
        if self._keys is not None:
            where = {"socket": "board", "address": request.remote or "unknown"}
            curve = self._keys(token)
            if curve is None:
                self._audit.refuse("refused", **where, why="nobody known has this token")
                return web.Response(status=403, text=_NO_TOKEN)
            name = {} if curve.name is None else {"name": curve.name}
            self._audit.tell("connected", **where, **name, key=curve.public.decode())
        if self._core is None:
            return web.Response(status=503, text="The blackboard is not there yet; try again.\n")
        if len(self._visitors) >= MOST:
            return web.Response(status=503, text=f"{MOST} programs use this door already.\n")
        if self._context is None:
            self._context = zmq.Context()
        socket = web.WebSocketResponse(timeout=PATIENCE, max_msg_size=LARGEST, heartbeat=BEAT)
        await socket.prepare(request)
        relay = self._visitors[socket] = _Relay(self._context, *self._core, curve)
        told = asyncio.create_task(relay.tell(socket))
        try:
            async for message in socket:
                if message.type is not WSMsgType.TEXT:
                    await socket.close(code=WSCloseCode.UNSUPPORTED_DATA, message=b"text only")
                    continue
                try:
                    passed = relay.pass_on(message.data)
                except zmq.Again:
                    words = b"the core does not take what is sent"
                    await socket.close(code=WSCloseCode.TRY_AGAIN_LATER, message=words)
                    continue
                if not passed:
                    words = b"a frame is a request, +TOPIC or -TOPIC"
                    await socket.close(code=WSCloseCode.POLICY_VIOLATION, message=words)
        finally:
            del self._visitors[socket]
            told.cancel()
            relay.close()
        return socket


_NO_TOKEN = (
    "This robot lets in only whom it knows: a token is needed that situ keys add --token made.\n"
)


class _Relay:
    """The sockets of one visitor. A closed connection ends his session at once."""

    def __init__(
        self,
        context: zmq.Context[zmq.Socket[bytes]],
        requests: str,
        notifications: str,
        curve: Curve | None,
    ) -> None:
        self._loop = asyncio.get_running_loop()
        self._dealer = context.socket(zmq.DEALER)
        self._subscriber = context.socket(zmq.SUB)
        if curve is not None:
            curve.put_on(self._dealer)
            curve.put_on(self._subscriber)
        self._dealer.linger = 500
        self._subscriber.linger = 0
        self._subscriber.setsockopt(zmq.RCVHWM, NOTICES)
        self._dealer.connect(requests)
        self._subscriber.connect(notifications)
        self._topics: set[bytes] = set()
        self._frames: deque[str] = deque()
        self._size = 0
        self._some = asyncio.Event()
        for socket in (self._dealer, self._subscriber):
            self._loop.add_reader(socket.fileno(), self._drain)
        self._drain()

    def pass_on(self, frame: str) -> bool:
        """A visitor's frame to the core; False where it is none of this door. Raises zmq.Again
        where too many wait for the core already."""
        if frame[:1] == "{":
            self._dealer.send(frame.encode("utf-8", "replace"), NOW)
        elif frame[:1] in ("+", "-"):
            topic = frame[1:].encode("utf-8", "replace")
            if frame[0] == "+" and topic not in self._topics and len(self._topics) < TOPICS:
                self._topics.add(topic)
                self._subscriber.setsockopt(zmq.SUBSCRIBE, topic)
            elif frame[0] == "-" and topic in self._topics:
                self._topics.remove(topic)
                self._subscriber.setsockopt(zmq.UNSUBSCRIBE, topic)
        else:
            return False
        # Sending can hide that something came in.
        self._drain()
        return True

    def _drain(self) -> None:
        """Takes what the core says, while the visitor keeps up."""
        if self._dealer.closed:
            return
        for socket in (self._dealer, self._subscriber):
            while self._size < HELD and has_come(socket):
                frame = socket.recv(NOW).decode("utf-8", "replace")
                self._frames.append(frame)
                self._size += len(frame)
        if self._frames:
            self._some.set()

    async def tell(self, socket: web.WebSocketResponse) -> None:
        """Sends the visitor what is for him, as fast as he reads it."""
        try:
            while True:
                await self._some.wait()
                self._some.clear()
                while self._frames:
                    frame = self._frames.popleft()
                    await socket.send_str(frame)
                    self._size -= len(frame)
                self._drain()
        except ConnectionError:
            return

    def close(self) -> None:
        """May be called again."""
        if self._dealer.closed:
            return
        for socket in (self._dealer, self._subscriber):
            self._loop.remove_reader(socket.fileno())
        with contextlib.suppress(zmq.Again):
            self._dealer.send(wire.encode(protocol.Bye(id=0)), NOW)
        self._dealer.close()
        self._subscriber.close()
