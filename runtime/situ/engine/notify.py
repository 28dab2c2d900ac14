"""Says how a process is, as sd_notify(3) has it: to systemd, or to the supervisor of ``situ run``.

Datagrams of lines ``NAME=value`` to the socket that ``NOTIFY_SOCKET`` names.
"""

from __future__ import annotations

import contextlib
import socket
from collections.abc import MutableMapping
from pathlib import Path

READY = "READY"
WATCHDOG = "WATCHDOG"
STATUS = "STATUS"
STOPPING = "STOPPING"
ADDRESSES = "X_SITU_ADDRESSES"
"""Ours: the addresses as JSON, with READY."""

LARGEST = 65_536


class Notifier:
    """Tells whoever started us; nobody, where he does not want to know.

    environment: what he said about it is taken out, so that no program of ours tells in our place.
    """

    def __init__(self, environment: MutableMapping[str, str]) -> None:
        address = environment.pop("NOTIFY_SOCKET", "")
        # A name that begins with @ has no file.
        self._address = "\0" + address[1:] if address.startswith("@") else address
        limit = environment.pop("WATCHDOG_USEC", "")
        environment.pop("WATCHDOG_PID", None)
        self.beat = int(limit) / 2_000_000 if limit.isdecimal() and self._address else None
        """Seconds between two signs of life that are wanted; None: none are."""

    def tell(self, **fields: str) -> None:
        """One message; whether it is heard is not our business."""
        if not self._address:
            return
        message = "\n".join(f"{name}={value}" for name, value in fields.items())
        with (
            contextlib.suppress(OSError),
            socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM | socket.SOCK_CLOEXEC) as sender,
        ):
            sender.setblocking(False)
            sender.sendto(message.encode(), self._address)


class Listener:
    """The other end: a socket in the file system, to be waited for and read."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM | socket.SOCK_CLOEXEC)
        self._socket.setblocking(False)
        self._socket.bind(str(path))

    def fileno(self) -> int:
        return self._socket.fileno()

    def take(self) -> dict[str, str] | None:
        """The next message; None where there is none."""
        try:
            message = self._socket.recv(LARGEST)
        except BlockingIOError:
            return None
        lines = message.decode("utf-8", "replace").splitlines()
        return {name: value for name, _, value in (line.partition("=") for line in lines)}

    def close(self) -> None:
        self._socket.close()
        self.path.unlink(missing_ok=True)
