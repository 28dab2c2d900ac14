"""The keys on a client's sockets."""

from __future__ import annotations

from collections.abc import Callable

import zmq
from msgspec import Struct

from situ.blackboard.identity import KeyRole


class Curve(Struct, frozen=True):
    """What a client's sockets need: both keys of its own, the robot's public one.

    name: whose keys they are, None where only the keys are known; role: as that robot was told.
    """

    public: bytes
    secret: bytes
    robot: bytes
    name: str | None = None
    role: KeyRole | None = None

    def put_on(self, socket: zmq.Socket[bytes]) -> None:
        """To be called before the socket connects."""
        socket.curve_publickey = self.public
        socket.curve_secretkey = self.secret
        socket.curve_serverkey = self.robot


KeysOf = Callable[[str], Curve | None]
"""The keys of whoever has a token of the WebSocket door; None: nobody has it."""
