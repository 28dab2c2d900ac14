"""The four cores together: one deterministic object without I/O (architecture, idea 2).

::

    robot = Robot(project)
    events, effects = robot.step(Start(), 0)
    while (due := robot.due()) is not None and due <= now:
        events, effects = robot.step(None, due)
    events, effects = robot.step(Touch(), now)

formats.md, *Time and steps*: a step is one input, or one thing that falls due, with
all that follows.
"""

from __future__ import annotations

import heapq
from collections.abc import Mapping

import msgspec
from msgspec import Struct

from situ.decide import inputs, trace
from situ.decide.board import Board, Entry
from situ.decide.conditions import ConditionsState
from situ.decide.debugger import DebuggerState
from situ.decide.deploying import Deploying, DeployingState, Version
from situ.decide.deployment import Deployment
from situ.decide.effects import AnyEffect, Begin, Map
from situ.decide.expected import Expectation, expected
from situ.decide.intake import ACCEPT
from situ.decide.machine import MachineState
from situ.decide.parts import Parts
from situ.decide.presence import PresenceState
from situ.decide.priorities import PrioritiesState
from situ.decide.replacing import take_over
from situ.decide.situations import SituationsState
from situ.decide.step import SECOND, TEST, StepState
from situ.decide.trace import TraceEvent
from situ.decide.world import World, WorldState
from situ.document.project import Project


class RobotState(Struct):
    """Everything that a robot knows, as a value that can be written and read."""

    step: StepState
    board: dict[str, Entry]
    conditions: ConditionsState
    priorities: PrioritiesState
    world: WorldState
    machines: list[MachineState]
    situations: SituationsState | None
    presence: PresenceState
    auto_finish: int | None
    moment: int
    count: int
    at_rest: bool
    debugger: DebuggerState
    deploying: DeployingState


class Robot:
    """A robot that runs one project. Its state is private; the trace tells all of it.

    The project must have no errors (``situ.document.check``); with errors the
    behaviour is undefined, but nothing outside of this object is ever touched.
    version: its number; files: its texts, as in ``inputs.Deploy``. Both are told when another
    version is deployed, and are what is returned to.
    """

    def __init__(
        self, project: Project, version: int = 0, files: Mapping[str, str] | None = None
    ) -> None:
        self._world = World(project)
        self._step = self._world.step
        running = Version(version, dict(files or {}))
        self._deploying = Deploying(self._step, project, running, self._replace)
        self._run()

    def _run(self) -> None:
        """Makes all that is made of the project of this world."""
        self._parts = Parts(self._world, self._deploying)
        self._machines = self._parts.machines
        self._settling = self._parts.settling

    @property
    def project(self) -> Project:
        """What it runs now."""
        return self._world.project

    @property
    def version(self) -> int:
        """The number of what it runs now."""
        return self._deploying.state.running.number

    def deployment(self) -> Deployment:
        """Which version runs, which waits to run and for what."""
        return self._deploying.deployment()

    def prepare(self, version: int, project: Project) -> None:
        """``project`` is what the files of a version are that is to be deployed or returned to,
        so that they need not be read once more.
        """
        self._deploying.prepare(version, project)

    @property
    def board(self) -> Board:
        """The blackboard, to be read: ``get``, ``look``, ``entries``."""
        return self._world.board

    @property
    def seq(self) -> int:
        """The seq of the last trace event; 0 before the first."""
        return self._world.step.seq

    def modules(self) -> dict[str, bool]:
        """Every module known here, whether it is present."""
        return self._parts.presence.modules()

    def expected(self) -> dict[str, Expectation]:
        """What each application expects now, by its name."""
        return expected(self._world, self._machines)

    # -- steps ---------------------------------------------------------------

    def step(
        self, given: inputs.AnyInput | None, now: int
    ) -> tuple[list[TraceEvent], list[AnyEffect]]:
        """One input at ``now``, or (None) one thing that falls due by then, with all that follows.

        ``now`` is µs and never decreases; what falls due by ``now`` is done before an
        input is given. Gives the trace events and the effects, both in order.
        """
        step, settling = self._step, self._settling
        step.now, step.seconds = now, now / SECOND
        step.events, step.effects = [], []
        settling.livelocked = False
        if given is None:
            if now != settling.moment:
                settling.moment, settling.count = now, 0
            self._do_due(now)
        else:
            settling.moment, settling.count = now, 0
            ACCEPT[type(given)](self._parts.intake, given)
        self._settling.settle()
        if self._deploying.active and self._deploying.look():
            self._settling.settle()
        return step.events, step.effects

    def due(self) -> int | None:
        """When the next thing falls due, in µs; None where nothing will."""
        timers = self._world.step.timers
        while timers and not self._parts.is_live(timers[0]):
            heapq.heappop(timers)
        return timers[0].due if timers else None

    def _do_due(self, now: int) -> None:
        timers = self._world.step.timers
        due = self.due()
        if due is None or due > now:
            return
        first = heapq.heappop(timers)
        self._parts.ring(first)
        # All ends of ``within`` and ``for`` at one moment are one thing: at that moment
        # none of them holds any longer, so no condition may be judged between two.
        while (
            first.rank == TEST and timers and (timers[0].due, timers[0].rank) == (first.due, TEST)
        ):
            self._parts.ring(heapq.heappop(timers))

    def _replace(
        self,
        project: Project,
        version: int,
        files: tuple[str, ...],
        writer: str,
        cause: int | None,
    ) -> None:
        """Another version takes over (``deploying.Replace``)."""
        seq = self._step.trace(trace.Deployed, cause, version, files, writer)
        old = self._parts
        live = [timer for timer in self._step.timers if old.is_live(timer)]
        self._world.deploy(project)
        self._run()
        take_over(self._world, old, self._parts, live, seq)

    # -- the state as a value ------------------------------------------------

    def outstanding(self) -> list[Map | Begin]:
        """What a driver that has carried out nothing yet must carry out to be where this robot
        is, after a ``restore`` say: the present value of each resource, with those of its actions
        that have not ended, then the services and launches that have not, as they began.
        """
        running = {number for m in self._machines for number in m.actions.state.running}
        priorities = self._world.priorities
        found: list[Map | Begin] = []
        for resource, value in sorted(priorities.state.robot.items()):
            ids = priorities.state.actions[resource]
            if resource == "screen":
                ids = tuple(one if one in running else 0 for one in ids)
            else:
                ids = tuple(one for one in ids if one in running)
            found.append(Map(resource, priorities.holder(resource), value, ids))
        return [*found, *(begin for m in self._machines for begin in m.actions.outstanding())]

    def snapshot(self) -> bytes:
        """All that this robot knows, to be restored into a ``Robot`` of the same project, whichever
        version of it runs.
        """
        world, settling = self._world, self._settling
        world.state.random = world.random.getstate()
        # JSON, as the values are: it holds integers of any size.
        return msgspec.json.encode(
            RobotState(
                world.step.state, world.board.state, world.conditions.state,
                world.priorities.state, world.state, [m.state for m in self._machines],
                settling.situations.state if settling.situations is not None else None,
                self._parts.presence.state, world.auto_finish, settling.moment, settling.count,
                settling.at_rest, settling.debugger.state,
                self._deploying.state,
            )
        )  # fmt: skip

    def restore(self, snapshot: bytes) -> None:
        """Goes on from where ``snapshot`` was taken; every later step is the same as there.

        Raises msgspec.DecodeError where the bytes are no snapshot, ValueError where the files of
        the version that ran then can not be run.
        """
        state = msgspec.json.decode(snapshot, type=RobotState)
        world, running = self._world, state.deploying.running
        if running.number != self.version:
            world.deploy(self._deploying.project(running))
            self._run()
        settling = self._settling
        self._deploying.state = state.deploying
        world.step.state, world.board.state = state.step, state.board
        world.conditions.state, world.priorities.state = state.conditions, state.priorities
        world.state, world.auto_finish = state.world, state.auto_finish
        version, inner, gauss = state.world.random
        world.random.setstate((version, tuple(inner), gauss))
        for machine, kept in zip(self._machines, state.machines, strict=True):
            machine.restore(kept)
        if settling.situations is not None and state.situations is not None:
            settling.situations.restore(state.situations)
        self._parts.presence.state = state.presence
        settling.moment, settling.count = state.moment, state.count
        settling.at_rest = state.at_rest
        settling.debugger.restore(state.debugger)
