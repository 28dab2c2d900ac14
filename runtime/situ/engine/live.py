"""A robot that lives: sockets and a clock into ``Robot.step``, its effects to who carries them out.

One asyncio thread. What decides is ``Robot``, who may ask is ``Sessions``, what moves is the
performer; here they are only joined, and woken when something has come or fallen due.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable, Collection, Coroutine
from typing import Any, Protocol

import zmq
from msgspec.structs import replace

from situ.blackboard.backlog import Backlog
from situ.blackboard.core import Core, Held
from situ.blackboard.curve import KeysOf
from situ.blackboard.guard import Guard
from situ.blackboard.journal import DurableTags
from situ.blackboard.keys import RobotKeys
from situ.blackboard.protocol import Addresses
from situ.blackboard.rights import Identity, Rights
from situ.blackboard.server import Server
from situ.blackboard.services import SERVICES, carried_by, may_repeat
from situ.blackboard.session import Sessions, lost
from situ.decide import inputs
from situ.decide.effects import AnyEffect, Begin, Changed
from situ.decide.priorities import RUNTIME
from situ.decide.robot import Robot
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent
from situ.document.project import Project
from situ.engine.clock import time_of_day
from situ.engine.recovery import Recovery

CLOSING = 2.0
"""Seconds that the performer has to end what it does."""

_log = logging.getLogger("situ.run")

Submit = Callable[[inputs.AnyInput], None]
Heard = Callable[[list[TraceEvent], float], None]


class Performing(Protocol):
    """The part of ``situ.engine.perform.Performer`` that the loop needs."""

    @property
    def screen_url(self) -> str | None: ...

    async def start(self) -> None: ...

    def open_door(self, addresses: Addresses, keys: KeysOf | None) -> None: ...

    def perform(self, effect: AnyEffect) -> None: ...

    async def close(self) -> None: ...


class Live:
    """One robot on one asyncio loop, from ``start`` to ``stop``.

    endpoint, notify: where to bind, port 0 for a free one. performer(submit, tag) makes
    who carries out effects; tag reads the blackboard. heard: is told each step's trace
    events with the UNIX time. files: as in ``Core``. wall: UNIX time, which may jump; used for
    the time of day and ``time`` in the trace only.

    services: those that the performer carries out; where there is one. The others are left to
    clients.

    scripted: a scenario client gives the time (``Sessions``); what actions and adapters
    answer is then left out, for the scenario says what ends and what is measured.

    keys, insecure: as in ``Server``.

    durable: keeps durable tags; ``stop`` closes it. recovery: keeps what is needed to go on
    after the process was killed; where it has found such a run, this one goes on from there
    (docs/architecture.md, *How the core comes back*). Both only where nothing is scripted.
    """

    def __init__(
        self,
        project: Project,
        endpoint: str,
        notify: str,
        performer: Callable[[Submit, Callable[[str], Any]], Performing] | None = None,
        *,
        services: Collection[str] = SERVICES,
        files: dict[str, str] | None = None,
        scripted: bool = False,
        seed: int = 0,
        auto_finish: float | None = None,
        heard: Heard | None = None,
        wall: Callable[[], float] = time.time,
        durable: DurableTags | None = None,
        recovery: Recovery | None = None,
        keys: RobotKeys | None = None,
        insecure: bool = False,
    ) -> None:
        self._project = project
        self._bind = endpoint, notify
        self._make = performer
        self._services = frozenset(services) if performer is not None else frozenset()
        self._files = files
        self._scripted = scripted
        self._seed = seed
        self._auto_finish = auto_finish
        self._heard = heard
        self._wall = wall
        self._durable = durable
        self._recovery = recovery
        self._keys = keys
        self._insecure = insecure
        self._performer: Performing | None = None
        self._timers: dict[str, asyncio.TimerHandle] = {}
        self._started = 0.0
        self._came = asyncio.Event()
        self._stopping = False

    async def start(self) -> Addresses:
        """Binds, opens the screen, takes the first step; the addresses that clients need.

        Raises UsageError where an address can not be bound.
        """
        self._loop = asyncio.get_running_loop()
        self._context: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
        try:
            self._server = Server(
                *self._bind, context=self._context, keys=self._keys, insecure=self._insecure
            )
        except BaseException:
            self._context.term()
            raise
        project = self._project
        if not self._scripted:
            # The first situation may depend on the time of day.
            project = replace(project, tags={**time_of_day(self._wall()), **project.tags})
        self._robot = Robot(project)
        try:
            if self._make is not None:
                self._performer = self._make(self._submit, self._look)
                await self._performer.start()
        except BaseException:
            self._server.close()
            self._context.term()
            raise
        addresses = Addresses(
            requests=self._server.requests,
            notifications=self._server.notifications,
            http=self._performer.screen_url if self._performer is not None else None,
        )
        if self._performer is not None:
            self._performer.open_door(addresses, self._keys.door if self._keys else None)
        if not self._goes_on(project, addresses):
            self._begins(project, addresses)
        self._flush()
        for descriptor in self._server.descriptors():
            self._loop.add_reader(descriptor, self._drain)
        self._drain()
        if not self._scripted:
            self._keep_clock()
        return addresses

    def _begins(self, project: Project, addresses: Addresses) -> None:
        """The first step of a run."""
        self._started = self._loop.time()
        self._make_core(project, addresses, 0)
        self._core.heard = self._heard
        self._sessions.start(
            self._seed,
            self._auto_finish,
            self._durable.restored if self._durable is not None else None,
        )
        self._take_snapshot()

    def _goes_on(self, project: Project, addresses: Addresses) -> bool:
        """Goes on where the process before was killed; False where there is no such run."""
        if self._recovery is None or self._recovery.found is None:
            return False
        kept, past = self._recovery.found
        self._recovery.found = None
        try:
            self._started = kept.began
            self._make_core(project, addresses, kept.seq)
            self._core.backlog.restore(self._recovery.trace(kept))
            self._robot.restore(kept.robot)
            self._sessions.restore(kept.sessions, past, self._now())
            behind = self._durable.behind(self._robot.board.state) if self._durable else []
            self._core.heard = self._heard
            self._take_snapshot()
            _log.warning(
                "the robot goes on from %g s, where it was killed", self._core.moment / SECOND
            )
            self._begin_again()
            # Time went on while nobody was there.
            self._sessions.advance(self._now())
        except Exception as error:
            # Whatever it is, it would be there again after the next start.
            self._recovery.set_aside(error)
            self._robot = Robot(project)
            return False
        if behind:
            self._keep(behind, [])
        return True

    def _make_core(self, project: Project, addresses: Addresses, seq: int) -> None:
        self._core = Core(
            self._robot,
            project,
            epoch=self._wall() - self._now() / SECOND,
            files=self._files,
            backlog=Backlog(begin=seq),
            durability=self._durable,
        )
        gate = self._server.gate
        guard = None if gate is None else Guard(Rights(project), gate.audit)
        self._sessions = Sessions(
            self._core, addresses, scripted=self._scripted, own=self._services, guard=guard
        )

    def _look(self, name: str) -> Any:
        return self._robot.board.look(name)

    def _begin_again(self) -> None:
        """What was being carried out here: again, where twice is as good as once."""
        gone = []
        for effect in self._robot.outstanding():
            if not self._services.intersection(carried_by(effect)):
                continue
            if isinstance(effect, Begin) and not may_repeat(effect):
                gone.append(effect)
            elif self._performer is not None:
                self._performer.perform(effect)
        for effect in gone:
            self._core.step(lost(effect, "the robot's core was killed"))

    # -- what outlives the process -------------------------------------------

    def _take_snapshot(self) -> None:
        if self._recovery is not None:
            state = self._sessions.state()
            self._recovery.snapshot(self._started, self._robot, state, self._core.backlog)
            self._core.remembers = True

    def _keep(self, changes: list[Changed], held: list[Held]) -> None:
        assert self._durable is not None
        loop = self._loop

        def done(why: str | None) -> None:
            loop.call_soon_threadsafe(self._was_kept, held, why)

        self._durable.keep(changes, done)

    def _was_kept(self, held: list[Held], why: str | None) -> None:
        replies = [(one.peer, one.reply if why is None else one.no(why)) for one in held]
        self._server.send(replies, ())
        if not self._stopping:
            self._drain()

    async def stop(self, *, forget: bool = True) -> None:
        """Tells all clients, holds the robot, closes; within about ``CLOSING`` seconds.

        forget: the next start begins anew; else it goes on, as after a kill.
        """
        for descriptor in self._server.descriptors():
            self._loop.remove_reader(descriptor)
        for timer in self._timers.values():
            timer.cancel()
        self._stopping = True
        self._core.end()
        self._flush()
        if self._recovery is not None and forget:
            self._recovery.forget()
        if self._performer is not None:
            await _in_time(self._performer.close())
        if self._durable is not None:
            await asyncio.to_thread(self._durable.close)
        self._server.close()
        self._context.term()

    async def clients(self, count: int) -> None:
        """Returns when at least so many clients are connected."""
        while self._sessions.clients < count:
            self._came.clear()
            await self._came.wait()

    # -- scripted time -------------------------------------------------------

    @property
    def moment(self) -> int:
        """The robot's time in µs."""
        return self._core.moment

    def due(self) -> int | None:
        """When the robot next does something by itself, in µs of its time."""
        return self._core.due()

    def move(self, moment: int) -> None:
        """Moves a scripted robot's time, doing what falls due by then."""
        self._core.now = self._now()
        self._core.move(moment)
        self._flush()
        self._drain()

    # -- the loop ------------------------------------------------------------

    def _now(self) -> int:
        return int((self._loop.time() - self._started) * SECOND)

    def _drain(self) -> None:
        """Requests have come; takes them, with what follows."""
        if self._server.drain(self._received, self._flush):
            # The descriptors tell of a change once only, and others must have their turn.
            self._at("drain", self._loop.time(), self._drain)
        self._wait()

    def _received(self, peer: bytes, body: bytes, identity: Identity | None) -> None:
        try:
            self._sessions.receive(peer, body, self._now(), identity)
        except Exception:
            # The others are served on; the descriptors would not tell of them again.
            _log.exception("a request could not be carried out")
        self._came.set()

    def _submit(self, given: inputs.AnyInput) -> None:
        if self._stopping or (self._scripted and isinstance(given, (inputs.Finish, inputs.Set))):
            return
        refused = self._sessions.submit(given, self._now())
        if refused is not None:
            _log.warning("%s", refused)
        self._flush()
        self._drain()

    def _ring(self) -> None:
        """Something has fallen due. Who has sent something by now is not taken for dead."""
        if self._server.drain(self._received, self._flush):
            self._at("drain", self._loop.time(), self._ring)
            return
        self._sessions.advance(self._now())
        self._flush()
        self._drain()

    def _flush(self) -> None:
        """Sends and carries out what follows from the last steps; to be drained after it."""
        out = self._sessions.take()
        recovery = self._recovery
        if out.past and recovery is not None:
            recovery.append(out.past)
        if out.durable:
            self._keep(out.durable, out.held)
        self._server.send(out.replies, out.notices)
        if self._performer is not None:
            for effect in out.effects:
                self._performer.perform(effect)
        if recovery is not None and recovery.wanted:
            self._take_snapshot()

    def _wait(self) -> None:
        due = self._sessions.due()
        if due is not None:
            # A timer may ring a little early by the loop's reckoning; never by ours.
            self._at("due", self._started + (due + 1) / SECOND, self._ring)
        elif "due" in self._timers:
            self._timers.pop("due").cancel()

    def _at(self, name: str, when: float, call: Callable[[], None]) -> None:
        before = self._timers.get(name)
        if before is not None:
            # One that rings too early is set anew then; leases move with every message.
            if before.when() <= when:
                return
            before.cancel()
        self._timers[name] = self._loop.call_at(when, self._call, name, call)

    def _call(self, name: str, call: Callable[[], None]) -> None:
        self._timers.pop(name, None)
        call()

    # -- the time of day -----------------------------------------------------

    def _keep_clock(self) -> None:
        """``clock.time``, ``clock.date`` and ``clock.weekday``, anew with each minute."""
        changed = {
            tag: value
            for tag, value in time_of_day(self._wall()).items()
            if (entry := self._robot.board.get(tag)) is None or entry.value != value
        }
        # The clock on the wall may have been set; the trace follows it.
        self._core.epoch = self._wall() - self._now() / SECOND
        if changed:
            self._submit(inputs.Set(changed, RUNTIME))
        left = 60 - self._wall() % 60
        self._at("clock", self._loop.time() + left + 0.01, self._keep_clock)


async def _in_time(closing: Coroutine[Any, Any, None]) -> None:
    try:
        async with asyncio.timeout(CLOSING):
            await closing
    except TimeoutError:
        _log.warning("what the robot was doing did not end in %g s; it is left", CLOSING)
