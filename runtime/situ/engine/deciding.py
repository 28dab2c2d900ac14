"""A robot that lives, without the waiting: sockets and a clock into ``Robot.step``, and back.

What decides is ``Robot``, who may ask is ``Sessions``; here they are joined with the sockets, with
what outlives the process, and with whoever carries out effects. ``engine/live.py`` waits for it in
an asyncio loop, ``engine/core_loop.py`` without one.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from typing import Any

import zmq
from msgspec.structs import replace

from situ.blackboard.backlog import Backlog
from situ.blackboard.core import Core, Heard, Held
from situ.blackboard.guard import Guard
from situ.blackboard.identity import Identity
from situ.blackboard.journal import DurableTags
from situ.blackboard.keys import RobotKeys
from situ.blackboard.replies import Addresses
from situ.blackboard.rights import Rights
from situ.blackboard.server import Server
from situ.blackboard.services import PATIENCE, Carried, carried_by, may_repeat
from situ.blackboard.session import Sessions, lost
from situ.decide import inputs
from situ.decide.effects import Begin, Changed
from situ.decide.priorities import RUNTIME
from situ.decide.robot import Robot
from situ.decide.step import SECOND
from situ.decide.trace import TraceEvent
from situ.document.folder import LOCAL_FILE
from situ.document.project import Project
from situ.engine.clock import time_of_day
from situ.engine.deploy import Deployer
from situ.engine.record import Recorder, Run
from situ.engine.recovery import Kept, Recovery

FREE = "tcp://127.0.0.1:0"
"""A free port, for this machine only."""

_log = logging.getLogger("situ.run")


@dataclass(frozen=True, kw_only=True)
class Setup:
    """How a live robot is set up.

    endpoint, notify: where to bind, port 0 for a free one. keys, insecure: as in ``Server``.
    files, patience: as in ``Core``.

    scripted: a scenario client gives the time (``Sessions``); what actions and adapters
    answer is then left out, for the scenario says what ends and what is measured.

    heard: is told each step's trace events with the UNIX time. wall: UNIX time, which may jump;
    used for the time of day and ``time`` in the trace only.

    durable: keeps durable tags. recovery: keeps what is needed to go on after the process was
    killed; where it has found such a run, this one goes on from there (docs/architecture.md,
    *How the core comes back*). Both only where nothing is scripted.

    recorders: record every step; the robot's end ends them. deployer: takes other versions of
    the project.
    """

    endpoint: str = FREE
    notify: str = FREE
    keys: RobotKeys | None = None
    insecure: bool = False
    files: dict[str, str] | None = None
    patience: float = PATIENCE
    scripted: bool = False
    seed: int = 0
    auto_finish: float | None = None
    heard: Heard | None = None
    wall: Callable[[], float] = time.time
    durable: DurableTags | None = None
    recovery: Recovery | None = None
    recorders: Sequence[Recorder] = ()
    deployer: Deployer | None = None


class Deciding:
    """One robot, from ``bind`` and ``start`` to ``end`` and ``close``; one thread.

    Wait until one of ``descriptors()`` is readable or the time that ``turn`` told last has come,
    then call ``turn``; and call it after ``submit`` and ``move``.

    clock: seconds that never go back, the system's own where there is a recovery. soon: calls
    something later in this thread, from any thread. services: those that are carried out in this
    process, by ``carry`` of ``start``.
    """

    def __init__(
        self,
        project: Project,
        setup: Setup,
        clock: Callable[[], float],
        soon: Callable[[Callable[[], None]], None],
        services: Collection[str] = (),
    ) -> None:
        self._project = project
        self._setup = setup
        self._clock = clock
        self._soon = soon
        self._services = frozenset(services)
        self._turned: Callable[[Project], None] = _nobody
        self._carry: Callable[[Carried], None] = _nobody
        self._started = 0.0
        # When the time of day is to be looked at.
        self._minute: float | None = None
        self._stopping = False

    # -- life ----------------------------------------------------------------

    def bind(self) -> Addresses:
        """The addresses as bound. Raises UsageError where one can not be."""
        setup = self._setup
        self._context: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
        try:
            self._server = Server(
                setup.endpoint,
                setup.notify,
                context=self._context,
                keys=setup.keys,
                insecure=setup.insecure,
            )
        except BaseException:
            self._context.term()
            raise
        return Addresses(self._server.requests, self._server.notifications)

    def start(
        self,
        addresses: Addresses,
        carry: Callable[[Carried], None] | None = None,
        turned: Callable[[Project], None] | None = None,
    ) -> None:
        """Goes on where the process before was killed, or takes the first step. turned: is told
        the project when another version of it runs."""
        project = self._project
        if not self._setup.scripted:
            # The first situation may depend on the time of day.
            project = replace(project, tags={**time_of_day(self._setup.wall()), **project.tags})
        if carry is not None:
            self._carry = carry
        if turned is not None:
            self._turned = turned
        self._robot = self._make_robot(project)
        if not self._goes_on(project, addresses):
            self._begins(project, addresses)
        self._flush()
        if not self._setup.scripted:
            self._keep_clock()

    def end(self, *, forget: bool) -> None:
        """Tells all clients. forget: the next start begins anew; else it goes on, as after a
        kill. What is submitted from now on is passed over."""
        self._stopping = True
        self._core.end()
        self._flush()
        for recorder in self._setup.recorders:
            recorder.close()
        if self._setup.recovery is not None and forget:
            self._setup.recovery.forget()
        if self._setup.deployer is not None:
            self._setup.deployer.end()

    def close(self) -> None:
        """Closes the sockets; also after ``bind`` alone. Durable tags are kept by then, and what
        was to be called soon is called."""
        self._server.close()
        self._context.term()

    def _begins(self, project: Project, addresses: Addresses) -> None:
        """The first step of a run."""
        self._started = self._clock()
        self._make_core(project, addresses, 0)
        self._core.heard = self._setup.heard
        self._record(project, None)
        self._sessions.start(
            self._setup.seed,
            self._setup.auto_finish,
            self._setup.durable.restored if self._setup.durable is not None else None,
        )
        self._take_snapshot()
        self._deploys()

    def _goes_on(self, project: Project, addresses: Addresses) -> bool:
        """Goes on where the process before was killed; False where there is no such run."""
        if self._setup.recovery is None or self._setup.recovery.found is None:
            return False
        kept, past = self._setup.recovery.found
        self._setup.recovery.found = None
        try:
            self._started = kept.began
            self._make_core(project, addresses, kept.seq)
            self._core.backlog.restore(self._setup.recovery.trace(kept))
            if self._setup.deployer is not None:
                for _, given in past:
                    if isinstance(given, inputs.Deploy):
                        self._setup.deployer.prepare(self._robot, given.version)
            self._robot.restore(kept.robot)
            # What is done again may not have been recorded yet when the process died.
            self._record(project, kept)
            self._sessions.restore(kept.sessions, past, self._now())
            behind = (
                self._setup.durable.behind(self._robot.board.state) if self._setup.durable else []
            )
            self._core.heard = self._setup.heard
            self._take_snapshot()
            _log.warning(
                "the robot goes on from %g s, where it was killed", self._core.moment / SECOND
            )
            self._begin_again()
            # Time went on while nobody was there.
            self._sessions.advance(self._now())
            self._deploys()
        except Exception as error:
            # Whatever it is, it would be there again after the next start.
            self._setup.recovery.set_aside(error)
            self._robot = self._make_robot(project)
            return False
        if behind:
            self._keep(behind, [])
        return True

    def _make_robot(self, project: Project) -> Robot:
        if self._setup.deployer is None:
            return Robot(project)
        return Robot(project, self._setup.deployer.begun, self._setup.deployer.texts(project))

    def _deploys(self) -> None:
        """From here on other versions may come."""
        if self._setup.deployer is not None:
            self._core.deployer = self._setup.deployer
            self._setup.deployer.begin(
                self._robot,
                lambda given: self._sessions.submit(given, self._now()),
                self._beside,
                self._now,
                self._turn_to,
            )

    def _beside(self, call: Callable[[], None]) -> None:
        """From any thread: called in ours, where it still runs, with what follows."""

        def then() -> None:
            if not self._stopping:
                call()
                self._flush()

        self._soon(then)

    def _turn_to(self, project: Project, texts: dict[str, str]) -> None:
        """Another version runs: all that looks into its files looks into these."""
        files = {path: text for path, text in texts.items() if path != LOCAL_FILE}
        others = bool(project.private) != bool(self._core.project.private)
        self._sessions.turn_to(project, files)
        if others:
            self._server.subscribe_anew()
        if self._setup.recovery is not None:
            self._setup.recovery.turn_to(project)
        for recorder in self._setup.recorders:
            recorder.turn_to(project, self._robot.version, texts)
        self._turned(project)

    def _make_core(self, project: Project, addresses: Addresses, seq: int) -> None:
        self._core = Core(
            self._robot,
            project,
            epoch=self._setup.wall() - self._now() / SECOND,
            files=self._setup.files,
            backlog=Backlog(begin=seq),
            durability=self._setup.durable,
            patience=self._setup.patience,
        )
        gate = self._server.gate
        guard = None if gate is None else Guard(Rights(project), gate.audit)
        self._sessions = Sessions(
            self._core, addresses, scripted=self._setup.scripted, own=self._services, guard=guard
        )
        self._server.may_subscribe = self._sessions.may_subscribe

    def _begin_again(self) -> None:
        """What was being carried out here: again, where twice is as good as once."""
        gone = []
        for effect in self._robot.outstanding():
            if not self._services.intersection(carried_by(effect)):
                continue
            if isinstance(effect, Begin) and not may_repeat(effect):
                gone.append(effect)
            else:
                self._carry(effect)
        for effect in gone:
            self._core.step(lost(effect, "the robot's core was killed"))

    # -- for who waits -------------------------------------------------------

    def descriptors(self) -> tuple[int, ...]:
        """To wait on for reading. They tell of a change once."""
        return self._server.descriptors()

    def turn(self) -> float | None:
        """Takes what has come and does what has fallen due, with what follows; when it is to be
        called next at the latest, by the clock. None: not before something comes."""
        due = self._work()
        for recorder in self._setup.recorders:
            then = recorder.tend(self._clock())
            if then is not None:
                due = then if due is None else min(due, then)
        if (
            self._setup.deployer is not None
            and (then := self._setup.deployer.tend(self._clock())) is not None
        ):
            due = then if due is None else min(due, then)
        return due

    def _work(self) -> float | None:
        if self._minute is not None and self._clock() >= self._minute:
            self._keep_clock()
        if self._server.drain(self._received, self._flush):
            # Others must have their turn.
            return self._clock()
        due = self._sessions.due()
        if due is not None and self._now() >= due:
            # Who has sent something by now is not taken for dead: it is drained.
            self._sessions.advance(self._now())
            self._flush()
            # To be drained after that; and a robot that never keeps up leaves others their turn.
            return self._clock()
        if due is None:
            return self._minute
        # It may ring a little early by the clock's reckoning; never by ours.
        ring = self._started + (due + 1) / SECOND
        return ring if self._minute is None else min(ring, self._minute)

    def submit(self, given: inputs.AnyInput) -> None:
        """An input from the runtime's own parts."""
        if self._stopping or (
            self._setup.scripted and isinstance(given, (inputs.Finish, inputs.Set))
        ):
            return
        refused = self._sessions.submit(given, self._now())
        if refused is not None:
            _log.warning("%s", refused)
        self._flush()

    def look(self, name: str) -> Any:
        """A value of the blackboard; None where it is missing."""
        return self._robot.board.look(name)

    @property
    def clients(self) -> int:
        """How many clients are connected."""
        return self._sessions.clients

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

    # -- what comes and what follows -----------------------------------------

    def _now(self) -> int:
        return int((self._clock() - self._started) * SECOND)

    def _received(self, peer: bytes, body: bytes, identity: Identity | None) -> None:
        try:
            self._sessions.receive(peer, body, self._now(), identity)
        except Exception:
            # The others are served on; the descriptors would not tell of them again.
            _log.exception("a request could not be carried out")

    def _flush(self) -> None:
        """Sends and carries out what follows from the last steps; to be drained after it."""
        out = self._sessions.take()
        recovery = self._setup.recovery
        if out.past and recovery is not None:
            recovery.append(out.past)
        if out.durable:
            self._keep(out.durable, out.held)
        self._server.send(out.replies, out.notices)
        for effect in out.effects:
            self._carry(effect)
        deployer = self._setup.deployer
        if deployer is not None and deployer.unsettled:
            self._take_snapshot()
            deployer.settle()
        elif recovery is not None and recovery.wanted:
            self._take_snapshot()

    # -- what outlives the process -------------------------------------------

    def _take_snapshot(self) -> None:
        if self._setup.recovery is not None:
            for recorder in self._setup.recorders:
                recorder.flush(self._clock())
            state = self._sessions.state()
            self._setup.recovery.snapshot(self._started, self._robot, state, self._core.backlog)
            self._core.remembers = True

    def _keep(self, changes: list[Changed], held: list[Held]) -> None:
        assert self._setup.durable is not None
        soon = self._soon

        def done(why: str | None) -> None:
            soon(lambda: self._was_kept(held, why))

        self._setup.durable.keep(changes, done)

    def _was_kept(self, held: list[Held], why: str | None) -> None:
        replies = [(one.peer, one.reply if why is None else one.no(why)) for one in held]
        self._server.send(replies, ())

    def _record(self, project: Project, kept: Kept | None) -> None:
        """Every step from here on is recorded; kept: where a robot that was killed goes on."""
        if not self._setup.recorders:
            return
        runtime = self._sessions.runtime if kept is None else kept.sessions.runtime
        run = Run(runtime, project, self._robot.version)
        state = None if kept is None else kept.robot
        for recorder in self._setup.recorders:
            recorder.begin(run, self._robot, self._setup.wall(), state=state)
        self._core.taken = self._taken

    def _taken(
        self, us: int, given: inputs.AnyInput | None, events: list[TraceEvent], moment: float
    ) -> None:
        for recorder in self._setup.recorders:
            recorder.step(us, given, events, moment)

    # -- the time of day -----------------------------------------------------

    def _keep_clock(self) -> None:
        """``clock.time``, ``clock.date`` and ``clock.weekday``, anew with each minute."""
        changed = {
            tag: value
            for tag, value in time_of_day(self._setup.wall()).items()
            if (entry := self._robot.board.get(tag)) is None or entry.value != value
        }
        # The clock on the wall may have been set; the trace follows it.
        self._core.epoch = self._setup.wall() - self._now() / SECOND
        if changed:
            self.submit(inputs.Set(changed, RUNTIME))
        left = 60 - self._setup.wall() % 60
        self._minute = self._clock() + left + 0.01


def _nobody(_: Carried | Project) -> None:
    """All of it is carried out elsewhere."""
