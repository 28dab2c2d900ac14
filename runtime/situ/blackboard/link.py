"""A ``Dialog`` over ZeroMQ: two sockets, driven from outside.

Without threads and loops of its own: wait until one of ``descriptors()`` is readable or
``due()`` has come, then call ``turn()``; and call ``turn()`` after asking for something.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import zmq
from msgspec.structs import replace
from zmq.backend import zmq_poll

from situ.blackboard.calls import Person
from situ.blackboard.curve import Curve
from situ.blackboard.dialog import Dialog
from situ.errors import UsageError

HELD = 10_000

# As plain numbers: these stand in the way of every message, and pyzmq's enumerations are slow.
NOW = int(zmq.DONTWAIT)
INCOMING, MORE, _EVENTS = int(zmq.POLLIN), int(zmq.RCVMORE), int(zmq.EVENTS)


class Link:
    """The sockets of one client. A Qt application drives it like this::

        link = Link("tcp://127.0.0.1:5570", Person(role="viewer"))
        for descriptor in link.descriptors():
            QSocketNotifier(descriptor, QSocketNotifier.Type.Read, self).activated.connect(turn)
        timer = QTimer(self, singleShot=True, timeout=turn)
        feed = link.dialog.trace(since=1)

        def turn():
            link.turn()
            while (event := feed.take()) is not None: …
            timer.start(max(0, round((link.due() - link.clock()) * 1000)))

    The descriptors stay the same for as long as it lives, over all reconnects. They
    tell of a change once, so every ``turn`` takes all there is. Asking for something
    (``link.dialog.get("x")`` gives a ``Call``; ``call.then(…)`` is called from a ``turn``)
    is sent with the next ``turn``. One thread at a time.

    keys: for a robot that lets in only whom it knows; one that does not answers nothing to
    a client with keys. Raises UsageError where the endpoint is no address.
    """

    def __init__(
        self,
        endpoint: str,
        person: Person,
        *,
        context: zmq.Context[zmq.Socket[bytes]] | None = None,
        clock: Callable[[], float] = time.monotonic,
        keys: Curve | None = None,
    ) -> None:
        self.endpoint = endpoint
        self.clock = clock
        if keys is not None and person.role == "operator":
            # Who he is there is what his key says.
            person = replace(person, user=keys.name)
        self.dialog = Dialog(person)
        self._own = context is None
        self._context = zmq.Context() if context is None else context
        self._dealer = self._context.socket(zmq.DEALER)
        self._subscriber = self._context.socket(zmq.SUB)
        self._sockets = [(self._dealer, INCOMING), (self._subscriber, INCOMING)]
        self._told: str | None = None
        self._listening: str | None = None
        self._closed = False
        for socket in (self._dealer, self._subscriber):
            socket.linger = 0
            socket.setsockopt(zmq.RECONNECT_IVL, 50)
            if keys is not None:
                keys.put_on(socket)
        # A request is for the core that is there, never for one that comes later.
        self._dealer.setsockopt(zmq.IMMEDIATE, 1)
        self._subscriber.setsockopt(zmq.RCVHWM, HELD)
        # No limit: beyond one, subscriptions would be dropped unseen.
        self._subscriber.setsockopt(zmq.SNDHWM, 0)
        try:
            self._dealer.connect(endpoint)
        except zmq.ZMQError as error:
            self.close()
            raise UsageError(
                f"{endpoint}: {error.strerror}; write it as tcp://127.0.0.1:5570"
            ) from None

    def descriptors(self) -> tuple[int, int]:
        """To wait on for reading; do not read from them."""
        return self._dealer.fileno(), self._subscriber.fileno()

    def due(self) -> float:
        """When ``turn`` is to be called at the latest, by ``clock``."""
        return self.dialog.due()

    def turn(self) -> None:
        """Takes all that has come, does what is due, sends all that is to be sent."""
        if self._closed:
            return
        if self.clock() >= self.due():
            # If we stood still for a lease, what was asked since is for the session that comes:
            # sent into the one that has ended, nobody would know whether it was done.
            self._receive()
        # What is to be sent first: then one look is enough to know that nothing was missed.
        self._send()
        self._receive()
        while self._send():
            self._receive()

    def _receive(self) -> None:
        dialog = self.dialog
        while come := zmq_poll(self._sockets, 0):
            for one, _ in come:
                socket = self._dealer if one is self._dealer else self._subscriber
                frame = socket.recv(NOW)
                if socket.getsockopt(MORE):
                    # Nobody who speaks this protocol sends such.
                    socket.recv_multipart(NOW)
                elif socket is self._dealer:
                    dialog.receive(frame, self.clock())
                else:
                    dialog.hear(frame, self.clock())
        dialog.tick(self.clock())

    def _send(self) -> bool:
        """Whether something was sent; only then may the descriptors have missed news."""
        dialog = self.dialog
        some = False
        if dialog.notifications is not None and dialog.notifications != self._told:
            if self._listening is not None:
                self._subscriber.disconnect(self._listening)
            self._told = dialog.notifications
            self._listening = reachable(self._told, self.endpoint)
            self._subscriber.connect(self._listening)
        while dialog.subscribing:
            topic, on = dialog.subscribing.popleft()
            self._subscriber.setsockopt(zmq.SUBSCRIBE if on else zmq.UNSUBSCRIBE, topic)
            some = True
        while dialog.outgoing:
            try:
                self._dealer.send(dialog.outgoing[0], NOW)
            except zmq.Again:
                # Nobody is connected; the descriptor tells when somebody is.
                break
            dialog.outgoing.popleft()
            some = True
        return some

    def close(self) -> None:
        """Says nothing; ``dialog.bye()`` and a ``turn`` before it end the session at once."""
        if self._closed:
            return
        self._closed = True
        self._dealer.close()
        self._subscriber.close()
        if self._own:
            self._context.term()


def reachable(told: str, endpoint: str) -> str:
    """An address that a core tells of, for who reached it at ``endpoint``: a core that is bound to
    all of its machine's addresses can not know by which one it is seen."""
    scheme, _, place = told.partition("://")
    host, _, port = place.rpartition(":")
    if scheme != "tcp" or host not in _EVERY or not endpoint.startswith("tcp://"):
        return told
    return f"{endpoint.rpartition(':')[0]}:{port}"


_EVERY = ("0.0.0.0", "[::]", "*")


def has_come(socket: zmq.Socket[bytes]) -> bool:
    """Whether there is something to receive. Cheaper than to try, and to be told no."""
    return bool(int(socket.getsockopt(_EVENTS)) & INCOMING)
