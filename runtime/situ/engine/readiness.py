"""Tells that a robot is ready, and that it lives: people, programs, systemd, the supervisor."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

import msgspec

from situ.engine.notify import ADDRESSES, READY, WATCHDOG, Notifier

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop

    from situ.blackboard.replies import Addresses
    from situ.engine.announcing import Announcement, Announcing

ANNOUNCEMENT = "announcement"
"""The key of an ``Announcement`` in what the supervisor is told."""


class Readiness:
    """Of one process of a robot. supervised: somebody started it who starts it again, and who
    tells people himself; as_json and aside: as in ``say_ready``."""

    def __init__(self, *, supervised: bool, as_json: bool, aside: bool) -> None:
        self.notifier = Notifier(os.environ)
        self._supervised = supervised
        self._as_json = as_json
        self._aside = aside
        self._parent = os.getppid()
        self._announcing: Announcing | None = None

    def up(
        self,
        project: str,
        version: int,
        addresses: Addresses,
        announcement: Announcement | None = None,
    ) -> None:
        """All is ready. version: the one that runs (``situ.engine.versions``). announcement: what
        whoever tells people has the network told, until ``close``."""
        said = {"project": project, "version": version, **msgspec.to_builtins(addresses)}
        if self._supervised:
            if announcement is not None:
                said[ANNOUNCEMENT] = msgspec.to_builtins(announcement)
            line = msgspec.json.encode(said).decode()
            self.notifier.tell(**{READY: "1", ADDRESSES: line})
            return
        say_ready(msgspec.json.encode(said).decode(), as_json=self._as_json, aside=self._aside)
        self.notifier.tell(**{READY: "1"})
        if announcement is not None:
            from situ.engine.announcing import Announcing

            self._announcing = Announcing()
            self._announcing.begin(announcement)

    def close(self) -> None:
        """The network is told that the robot has gone."""
        if self._announcing is not None:
            self._announcing.close()

    def beat(self, loop: AbstractEventLoop) -> None:
        """Says that we live, from now on, where somebody wants to know."""
        if self.notifier.beat is not None:
            self.notifier.tell(**{WATCHDOG: "1"})
            loop.call_later(self.notifier.beat, self.beat, loop)

    def is_the_end(self) -> bool:
        """Whether the next start begins anew: not where who would start it again was killed."""
        return not self._supervised or os.getppid() == self._parent


def say_ready(line: str, *, as_json: bool, aside: bool) -> None:
    """line: project and addresses as JSON; for people unless ``as_json``. aside: on standard
    error, for standard output is the trace's."""
    if not as_json:
        said = msgspec.json.decode(line)
        screen = f" screen {said['http']}" if said["http"] is not None else ""
        version = f" version {said['version']}" if said["version"] else ""
        line = f"situ run: {said['project']}{version} ready at {said['requests']}{screen}"
    print(line, file=sys.stderr if aside else sys.stdout, flush=True)
