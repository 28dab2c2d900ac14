"""A robot that can be reached from the network is announced there, by a process beside it.

What strangers in the network send is read by that process alone: neither the core, which has the
robot's keys and its time, nor the supervisor has anything to do with it. It ends when its standard
input does, however the robot ends, and says goodbye (docs/security.md, *Announced*).
"""

from __future__ import annotations

import contextlib
import socket
import subprocess
import sys
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

import msgspec
from msgspec import Struct

from situ.blackboard.announced import Announced, fingerprint

if TYPE_CHECKING:
    from situ.document.project import Project

PATIENCE = 2.0
"""Seconds that it has to say goodbye."""


class Announcement(Struct, frozen=True):
    """What is announced. bound: the IPv4 address that the robot is bound to; 0.0.0.0 for all."""

    robot: Announced
    bound: str


def announcement(project: Project, requests: str, public: bytes | None) -> Announcement | None:
    """For a robot that is asked at ``requests``, an address as it was bound; None where only its
    own machine reaches it, or by IPv6 only, or where its owner does not want it. public: its
    public key; None: everybody may come in.
    """
    # Only the core asks this; the supervisor, and who announces, need no ZeroMQ.
    from situ.blackboard.server import is_local

    if not project.announce or is_local(requests):
        return None
    parts = urlsplit(requests)
    if parts.hostname is None or parts.port is None or ":" in parts.hostname:
        return None
    robot = Announced(
        project=project.name,
        host=socket.gethostname().partition(".")[0],
        port=parts.port,
        key="" if public is None else fingerprint(public),
    )
    return Announcement(robot, parts.hostname)


def not_announced(error: OSError) -> str:
    """One line for people."""
    why = error.strerror or error
    return f"situ run: the robot is not announced in the network: {why}"


class Announcing:
    """One robot's process that announces it, from ``begin`` to ``close``."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._told: Announcement | None = None

    def begin(self, announcement: Announcement) -> None:
        """Announces it, unless that has begun; what was announced before says goodbye. What goes
        wrong is told on standard error; the robot runs all the same."""
        if self._process is not None and announcement == self._told:
            return
        self.close()
        self._told = announcement
        command = [sys.executable, "-m", "situ.engine.announcer"]
        # A group of its own: what the terminal says is for us, and it ends by its input.
        try:
            self._process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, start_new_session=True
            )
        except OSError as error:
            print(not_announced(error), file=sys.stderr)
            return
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write(msgspec.json.encode(announcement) + b"\n")
            self._process.stdin.flush()

    def close(self) -> None:
        """Has it say goodbye, and waits for it, ``PATIENCE`` at the most."""
        process, self._process = self._process, None
        if process is None:
            return
        assert process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
        try:
            process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
