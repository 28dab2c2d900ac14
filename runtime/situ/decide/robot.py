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
from collections.abc import Callable, Mapping
from typing import Any

import msgspec
from msgspec import UNSET, Struct

from situ.decide import inputs, trace
from situ.decide.board import Board, Entry
from situ.decide.conditions import ConditionsState
from situ.decide.effects import AnyEffect, Refuse
from situ.decide.machine import Machine, MachineState
from situ.decide.priorities import RUNTIME, PrioritiesState
from situ.decide.situations import Situations, SituationsState
from situ.decide.step import TEST, StepState, Timer, duration
from situ.decide.trace import TraceEvent
from situ.decide.values import in_text, is_number, read, template
from situ.decide.world import World, WorldState, refusal
from situ.document import names
from situ.document.project import Project
from situ.document.rbd import Button, Input, List

LIVELOCK = 100
"""More events, resumptions and situation changes than this in one moment are a livelock."""

CONFIDENT = 0.5
"""From this confidence on an utterance is taken for what was heard."""

NOT_UNDERSTOOD = "notunderstood"


class RobotState(Struct):
    """Everything that a robot knows, as a value that can be written and read."""

    step: StepState
    board: dict[str, Entry]
    conditions: ConditionsState
    priorities: PrioritiesState
    world: WorldState
    machines: list[MachineState]
    situations: SituationsState | None
    connected: dict[str, tuple[str, ...]]
    gone: list[str]
    everyone: bool
    auto_finish: int | None
    moment: int
    count: int


class Robot:
    """A robot that runs one project. Its state is private; the trace tells all of it.

    The project must have no errors (``situ.document.check``); with errors the
    behaviour is undefined, but nothing outside of this object is ever touched.
    """

    def __init__(self, project: Project) -> None:
        self.project = project
        self._world = World(project, self._granted)
        self._situations: Situations | None = None
        if project.spds is not None:
            world = self._world
            self._situations = Situations(project.spds, world.conditions, world.step)
        self._alone = dict.fromkeys((a.name for a in project.applications.values()), 1)
        self._machines = [
            Machine(self._world, application, number, self._asked)
            for number, application in enumerate(project.applications.values())
        ]
        self._by_name = {machine.name: machine for machine in self._machines}
        self._declared = project.declared()
        self._connected: dict[str, tuple[str, ...]] = {}
        self._gone: set[str] = set()
        self._everyone = True
        self._moment = self._count = 0
        self._livelocked = False
        self._world.board.listen(["heard"], self._on_heard)

    @property
    def board(self) -> Board:
        """The blackboard, to be read: ``get``, ``look``, ``entries``."""
        return self._world.board

    @property
    def seq(self) -> int:
        """The seq of the last trace event; 0 before the first."""
        return self._world.step.state.seq

    def modules(self) -> dict[str, bool]:
        """Every module known here, whether it is present."""
        known = {*self._declared, *self._connected} - self._by_name.keys()
        return {name: self._is_present(name) for name in sorted(known)}

    # -- steps ---------------------------------------------------------------

    def due(self) -> int | None:
        """When the next thing falls due, in µs; None where nothing will."""
        timers = self._world.step.state.timers
        while timers and not self._is_live(timers[0]):
            heapq.heappop(timers)
        return timers[0].due if timers else None

    def step(
        self, given: inputs.AnyInput | None, now: int
    ) -> tuple[list[TraceEvent], list[AnyEffect]]:
        """One input at ``now``, or (None) one thing that falls due by then, with all that follows.

        ``now`` is µs and never decreases; what falls due by ``now`` is done before an
        input is given. Gives the trace events and the effects, both in order.
        """
        self._world.step.begin(now)
        self._livelocked = False
        if given is not None or now != self._moment:
            self._moment, self._count = now, 0
        if given is None:
            self._do_due(now)
        else:
            _ACCEPT[type(given)](self, given)
        self._settle()
        return self._world.step.events, self._world.step.effects

    def _do_due(self, now: int) -> None:
        timers = self._world.step.state.timers
        due = self.due()
        if due is None or due > now:
            return
        first = heapq.heappop(timers)
        self._ring(first)
        # All ends of ``within`` and ``for`` at one moment are one thing: at that moment
        # none of them holds any longer, so no condition may be judged between two.
        while (
            first.rank == TEST and timers and (timers[0].due, timers[0].rank) == (first.due, TEST)
        ):
            self._ring(heapq.heappop(timers))

    def _ring(self, timer: Timer) -> None:
        kind, _, name = timer.owner.partition(":")
        if kind == "test":
            self._world.conditions.due(int(name), timer.token)
        elif kind == "situation" and self._situations is not None:
            self._situations.due(int(name), timer.token)
        elif kind == "command":
            self._world.priorities.due(name, timer.token)
        elif kind == "action":
            machine = self._machines[int(name)]
            if timer.token in machine.actions.state.running:
                cause = machine.actions.state.running[timer.token].seq
                machine.finish(timer.token, True, None, None, None, cause)
        elif kind == "application":
            self._machines[int(name)].due(timer.token)

    def _is_live(self, timer: Timer) -> bool:
        kind, _, name = timer.owner.partition(":")
        if kind == "situation" and self._situations is not None:
            return self._situations.is_live(int(name), timer.token)
        if kind == "command":
            return self._world.priorities.is_live(name, timer.token)
        if kind == "action":
            return timer.token in self._machines[int(name)].actions.state.running
        if kind == "application":
            return self._machines[int(name)].timeouts.state.token == timer.token
        return True

    # -- what follows --------------------------------------------------------

    def _settle(self) -> None:
        """Situations and authority, resumptions, unnamed events, then the earliest raised
        event, until nothing is left; live screens at the end.
        """
        self._observe()
        while (follows := self._follows()) is not None and self._may_go_on():
            follows()
            self._observe()
        self._listen()
        for machine in self._machines:
            machine.refresh()

    def _follows(self) -> Callable[[], object] | None:
        if self._livelocked:
            return None
        for machine in self._machines:
            if machine.may_resume():
                return machine.resume
        for machine in self._machines:
            taken = machine.unnamed()
            if taken is not None:
                return lambda m=machine, t=taken: m.take_unnamed(t)  # type: ignore[misc]
        waiting = [(o, m) for m in self._machines if (o := m.earliest()) is not None]
        return min(waiting, key=lambda one: one[0])[1].judge_event if waiting else None

    def _may_go_on(self) -> bool:
        """Counts one more of what must not go on for ever."""
        self._count += 1
        if self._count <= LIVELOCK:
            return True
        # Later steps of this moment begin anew: what falls due in them is finite.
        self._livelocked, self._count = True, 0
        last = self._world.step.events[-1].seq if self._world.step.events else None
        names_ = ", ".join(m.name for m in self._machines if m.state.queue or m.state.stale)
        self._world.step.error(
            last,
            f"livelock: more than {LIVELOCK} events without an end; waiting events are dropped, "
            "look for states that lead to each other without waiting",
            names_ or "situations",
        )
        for machine in self._machines:
            machine.stay()
        return False

    def _observe(self) -> None:
        while self._situations is not None and not self._livelocked:
            seq = self._situations.observe()
            if seq is None:
                return
            current = self._situations.current
            value = {
                "name": current.name if current is not None else None,
                "priorities": dict(self._situations.granted()),
            }
            self._world.keep("situation", value, RUNTIME, seq)
            self._reassign(seq)
            self._may_go_on()

    def _granted(self) -> Mapping[str, int]:
        return self._alone if self._situations is None else self._situations.granted()

    def _reassign(self, cause: int | None) -> None:
        changed = self._world.priorities.assign(cause)
        if changed:
            for machine in self._machines:
                machine.on_authority(changed, cause)

    def _asked(self, module: str, seq: int) -> None:
        """A module, an application too, asks for authority: who it needs should be there."""
        known = self.project.module(module)
        for required in known.requires if known is not None else ():
            if required.module is not None and not self._is_present(required.module):
                message = f"{module} needs {required.module}, which is absent"
                self._world.step.warn(seq, message, module)
        self._reassign(seq)

    def _listen(self) -> None:
        phrases = [phrase for machine in self._machines for phrase in machine.phrases()]
        self._world.keep_if_new("listen", list(dict.fromkeys(phrases)), None)

    # -- inputs --------------------------------------------------------------

    def _start(self, given: inputs.Start) -> None:
        world = self._world
        world.random.seed(given.seed)
        world.auto_finish = None if given.auto_finish is None else duration(given.auto_finish)
        self._everyone = given.everyone
        tags = self.project.tags
        world.write({t: v for t, v in tags.items() if t not in given.restored}, "project", None)
        world.restore(given.restored)
        world.conditions.start()
        self._listen()
        self._observe()
        for machine in self._machines:
            machine.start()

    def _set(self, given: inputs.Set) -> None:
        for tag in given.tags:
            no = refusal(tag, given.writer)
            if no is None and not names.is_tag(tag):
                no = f"{tag} is no tag: use words of a-z, 0-9, _ and - joined by dots"
            if no is not None:
                self._refuse(no, given.writer)
                return
        self._world.write(given.tags, given.writer, None)

    def _raise(self, given: inputs.Raise) -> None:
        order = self._world.next_raise()
        if given.application is not None and given.application not in self._by_name:
            self._refuse(f"there is no application {given.application}", given.event)
            return
        for machine in self._machines:
            if given.application in (None, machine.name):
                machine.raise_event(given.event, None, order)

    def _shower(self) -> Machine | None:
        """The application whose screen is shown."""
        return self._by_name.get(self._world.priorities.holder("screen") or "")

    def _touch(self, given: inputs.Touch) -> None:
        machine = self._shower()
        if machine is None:
            return
        machine.attend()
        event = machine.touched()
        if event is not None:
            machine.raise_event(event, None, self._world.next_raise())

    def _attend(self, given: inputs.Attend) -> None:
        machine = self._shower()
        if machine is not None:
            machine.attend()

    def _use(self, given: inputs.Use) -> None:
        machine = self._shower()
        component = machine.component(given.component) if machine is not None else None
        if machine is None or not isinstance(component, (Button, Input, List)):
            self._world.step.warn(
                None, f"no button, input or list {given.component} is shown", "screen"
            )
            return
        machine.attend()
        value: Any = given.value
        if isinstance(component, Button):
            value = self._pressed(component)
        elif isinstance(component, Input) and value is not UNSET:
            value = typed(component, value)
            if value is None:
                self._world.step.warn(
                    None, f"{given.component} takes a number, not {given.value!r}", "screen"
                )
                return
        if component.tag and value is not UNSET:
            self._world.write({component.tag: value}, "screen", None)
        if component.event is not None:
            machine.raise_event(component.event, None, self._world.next_raise())

    def _pressed(self, button: Button) -> Any:
        """What a button sets: its ``value``, read like the text of a ``set``."""
        filled, look = template(button.value or ""), self._world.board.look
        for name in filled.missing(look):
            self._world.step.warn(None, f"{name} has no value", button.id)
        return filled.value(look)

    def _acquire(self, given: inputs.Acquire) -> None:
        asked = (*given.resources, *given.optional)
        if not self._may_ask(given.module, asked):
            return
        self._gone.discard(given.module)
        world = self._world
        seq = world.priorities.ask(given.module, given.resources, given.optional, None, True)
        if seq is not None:
            self._asked(given.module, seq)

    def _abandon(self, given: inputs.Abandon) -> None:
        if self._may_ask(given.module, given.resources):
            seq = self._world.priorities.abandon(given.module, given.resources)
            if seq is not None:
                self._reassign(seq)

    def _command(self, given: inputs.Command) -> None:
        if self._may_ask(given.module, (given.resource,)):
            self._world.priorities.command(
                given.module, given.resource, given.value, given.valid, None
            )

    def _lost(self, given: inputs.Lost) -> None:
        if given.module in self._by_name or self._known(given.module) is None:
            self._refuse(f"there is no module {given.module}", given.module)
            return
        self._gone.add(given.module)
        self._connected.pop(given.module, None)
        self._reassign(self._world.priorities.lost(given.module))

    def _connect(self, given: inputs.Connected) -> None:
        self._gone.discard(given.module)
        self._connected[given.module] = given.resources
        self._world.step.trace(trace.Connected, None, given.module, tuple(sorted(given.resources)))

    def _finish(self, given: inputs.Finish) -> None:
        for machine, running in self._fitting(given):
            status = None if given.status is UNSET else given.status
            machine.finish(running, given.ok, given.result, given.error, status, None)
            return
        if given.id is None:
            what = " ".join(str(x) for x in (given.action, given.name) if x is not None)
            self._world.step.warn(None, f"no {what or 'action'} is running", "finish")

    def _fitting(self, given: inputs.Finish) -> list[tuple[Machine, int]]:
        found = []
        for machine in self._machines:
            if given.id is not None:
                if given.id in machine.actions.state.running:
                    return [(machine, given.id)]
            elif given.application in (None, machine.name):
                running = machine.actions.find(given.action, given.name)
                if running is not None:
                    found.append((machine, running.id))
        return sorted(found, key=lambda one: one[1])

    def _may_ask(self, module: str, resources: tuple[str, ...]) -> bool:
        declared = self._known(module)
        if module in self._by_name:
            self._refuse(f"{module} is an application; its states ask for it", module)
        elif declared is None:
            self._refuse(
                f"the module {module} is not declared: "
                "ask the task designer for a priority in the script",
                module,
            )
        elif strange := [r for r in resources if r not in declared]:
            self._refuse(
                f"{module} did not declare {', '.join(strange)}: declare it in the module "
                "information and ask the task designer for a priority",
                module,
            )
        else:
            return True
        return False

    def _known(self, module: str) -> tuple[str, ...] | None:
        return self._declared.get(module, self._connected.get(module))

    def _is_present(self, module: str) -> bool:
        if module in self._by_name or module in self._connected:
            return True
        return self._everyone and module in self._declared and module not in self._gone

    def _refuse(self, message: str, where: str) -> None:
        self._world.step.error(None, message, where)
        self._world.step.effects.append(Refuse(message))

    def _on_heard(self, tag: str, cause: int | None) -> None:
        """An utterance (formats.md, *Speech heard*)."""
        heard = self._world.board.look("heard")
        text = heard.get("text") if isinstance(heard, dict) else None
        listening = [machine for machine in self._machines if machine.phrases()]
        if not isinstance(text, str) or not listening:
            return
        confidence = heard.get("confidence", 1)
        sure = is_number(confidence) and confidence >= CONFIDENT
        meant = {m.name: m.event_for(text) for m in listening} if sure else {}
        understood = any(event is not None for event in meant.values())
        order = self._world.next_raise()
        for machine in listening:
            machine.attend()
            event = meant.get(machine.name) if understood else NOT_UNDERSTOOD
            if event is not None:
                machine.raise_event(event, cause, order)

    # -- the state as a value ------------------------------------------------

    def snapshot(self) -> bytes:
        """All that this robot knows, to be restored into a ``Robot`` of the same project."""
        world = self._world
        world.state.random = world.random.getstate()
        return msgspec.msgpack.encode(
            RobotState(
                world.step.state, world.board.state, world.conditions.state,
                world.priorities.state, world.state, [m.state for m in self._machines],
                self._situations.state if self._situations is not None else None,
                self._connected, sorted(self._gone), self._everyone, world.auto_finish,
                self._moment, self._count,
            )
        )  # fmt: skip

    def restore(self, snapshot: bytes) -> None:
        """Goes on from where ``snapshot`` was taken; every later step is the same as there.

        Raises msgspec.ValidationError where the bytes are no snapshot.
        """
        state = msgspec.msgpack.decode(snapshot, type=RobotState)
        world = self._world
        world.step.state, world.board.state = state.step, state.board
        world.step.now = state.step.now
        world.conditions.state, world.priorities.state = state.conditions, state.priorities
        world.state, world.auto_finish = state.world, state.auto_finish
        version, inner, gauss = state.world.random
        world.random.setstate((version, tuple(inner), gauss))
        for machine, kept in zip(self._machines, state.machines, strict=True):
            machine.restore(kept)
        if self._situations is not None and state.situations is not None:
            self._situations.state = state.situations
        self._connected, self._gone = state.connected, set(state.gone)
        self._everyone, self._moment = state.everyone, state.moment
        self._count = state.count


def typed(field: Input, value: Any) -> str | int | float | None:
    """What an input writes for what was typed: no more than ``max`` characters, as text, or
    for ``number`` as a number. None: it is no number.
    """
    text = in_text(value)[: field.max]
    if field.kind != "number":
        return text
    number = read(text)
    return number if is_number(number) else None


_ACCEPT: dict[type[inputs.Input], Callable[[Robot, Any], None]] = {
    inputs.Start: Robot._start,
    inputs.Set: Robot._set,
    inputs.Raise: Robot._raise,
    inputs.Touch: Robot._touch,
    inputs.Use: Robot._use,
    inputs.Attend: Robot._attend,
    inputs.Acquire: Robot._acquire,
    inputs.Abandon: Robot._abandon,
    inputs.Command: Robot._command,
    inputs.Lost: Robot._lost,
    inputs.Connected: Robot._connect,
    inputs.Finish: Robot._finish,
}
