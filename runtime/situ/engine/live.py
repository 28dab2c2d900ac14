"""A robot that lives in one asyncio loop, with who carries out its effects."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Collection, Coroutine
from typing import Any, Protocol

from msgspec.structs import replace

from situ.blackboard.replies import Addresses
from situ.blackboard.services import SERVICES, Carried
from situ.decide import inputs
from situ.decide.effects import Begin
from situ.document.project import Project
from situ.engine.deciding import Deciding, Setup
from situ.engine.performing import Performing, Submit

CLOSING = 2.0
"""Seconds that the performer has to end what it does."""

_log = logging.getLogger("situ.run")


class Broker(Protocol):
    """The part of ``situ.engine.mqtt.Bridge`` that the loop needs."""

    def start(self) -> None: ...

    def send(self, topic: str, value: Any) -> None: ...

    async def close(self) -> None: ...


class Live:
    """One robot on one asyncio loop, from ``start`` to ``stop``.

    performer(submit, tag) makes who carries out effects; tag reads the blackboard. services:
    those that it carries out; the others are left to clients. broker(submit) makes who else is
    told the messages of applications, and tells of events and tags from elsewhere.

    ``stop`` closes what keeps durable tags.
    """

    def __init__(
        self,
        project: Project,
        setup: Setup,
        performer: Callable[[Submit, Callable[[str], Any]], Performing] | None = None,
        services: Collection[str] = SERVICES,
        broker: Callable[[Submit], Broker] | None = None,
    ) -> None:
        self._loop: asyncio.AbstractEventLoop
        self._deciding = Deciding(
            project,
            setup,
            lambda: self._loop.time(),
            self._soon,
            services if performer is not None else (),
        )
        self._setup = setup
        self._make = performer
        self._broker = broker(self._submit) if broker is not None else None
        self._performer: Performing | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._came = asyncio.Event()
        self._up = False

    async def start(self) -> Addresses:
        """Binds, opens the screen, takes the first step; the addresses that clients need.

        Raises UsageError where an address can not be bound.
        """
        self._loop = asyncio.get_running_loop()
        deciding = self._deciding
        addresses = deciding.bind()
        try:
            if self._make is not None:
                self._performer = self._make(self._submit, deciding.look)
                await self._performer.start()
                addresses = replace(addresses, http=self._performer.screen_url)
                self._performer.open_door(
                    addresses, self._setup.keys.door if self._setup.keys else None
                )
        except BaseException:
            deciding.close()
            raise
        deciding.start(addresses, self._carry, self._turn_to)
        self._up = True
        for descriptor in deciding.descriptors():
            self._loop.add_reader(descriptor, self._turn)
        self._turn()
        if self._broker is not None:
            self._broker.start()
        return addresses

    async def stop(self, *, forget: bool = True) -> None:
        """Tells all clients, holds the robot, closes; within about ``CLOSING`` seconds.

        forget: the next start begins anew; else it goes on, as after a kill.
        """
        self._up = False
        for descriptor in self._deciding.descriptors():
            self._loop.remove_reader(descriptor)
        if self._timer is not None:
            self._timer.cancel()
        self._deciding.end(forget=forget)
        if self._performer is not None:
            await _in_time(self._performer.close())
        if self._broker is not None:
            await _in_time(self._broker.close())
        if self._setup.durable is not None:
            await asyncio.to_thread(self._setup.durable.close)
        self._deciding.close()

    async def clients(self, count: int) -> None:
        """Returns when at least so many clients are connected."""
        while self._deciding.clients < count:
            self._came.clear()
            await self._came.wait()

    # -- scripted time -------------------------------------------------------

    @property
    def moment(self) -> int:
        """The robot's time in µs."""
        return self._deciding.moment

    def due(self) -> int | None:
        """When the robot next does something by itself, in µs of its time."""
        return self._deciding.due()

    def move(self, moment: int) -> None:
        """Moves a scripted robot's time, doing what falls due by then."""
        self._deciding.move(moment)
        self._turn()

    # -- the loop ------------------------------------------------------------

    def _turn(self) -> None:
        due = self._deciding.turn()
        self._came.set()
        before = self._timer
        if before is not None:
            # One that rings too early is set anew then; leases move with every message.
            if due is not None and before.when() <= due:
                return
            before.cancel()
        self._timer = None if due is None else self._loop.call_at(due, self._ring)

    def _ring(self) -> None:
        self._timer = None
        self._turn()

    def _soon(self, call: Callable[[], None]) -> None:
        """From any thread."""
        self._loop.call_soon_threadsafe(self._then, call)

    def _then(self, call: Callable[[], None]) -> None:
        call()
        if self._up:
            self._turn()

    def _submit(self, given: inputs.AnyInput) -> None:
        self._deciding.submit(given)
        if self._up:
            self._turn()

    def _turn_to(self, project: Project) -> None:
        if self._performer is not None:
            self._performer.turn_to(project)

    def _carry(self, effect: Carried) -> None:
        if self._performer is not None:
            self._performer.perform(effect)
        if self._broker is not None and isinstance(effect, Begin) and effect.action == "message":
            self._broker.send(str(effect.fields["topic"]), effect.fields["value"])


async def _in_time(closing: Coroutine[Any, Any, None]) -> None:
    try:
        async with asyncio.timeout(CLOSING):
            await closing
    except TimeoutError:
        _log.warning("what the robot was doing did not end in %g s; it is left", CLOSING)
