"""What an operator may do to the applications of a running robot: pause them, look, go on.

A paused application's time stands still: its timeout does not count, what comes to it waits, and
nothing new begins; what runs already goes on. The rest of the robot, situations, priorities,
modules and suspensions, goes on too: safety does. docs/semantics.md, *The debugger*.
"""

from __future__ import annotations

from typing import Any

import msgspec
from msgspec import UNSET, Struct, UnsetType, field

from situ.decide import inputs, trace
from situ.decide.ahead import Passage, advance, next_passage, timeout_passage
from situ.decide.conditions import Compiled, Conditions
from situ.decide.machine import Machine
from situ.decide.priorities import RUNTIME
from situ.decide.world import BREAKPOINTS, PAUSED, World
from situ.document import when_text
from situ.document.condition import Condition

ONE_KIND = (
    "a breakpoint stands on a state, on a transition (from, to or both) or on a situation: "
    "name one of these"
)


class Breakpoint(Struct, omit_defaults=True):
    """One breakpoint (``inputs.Break``); writer: who set it."""

    id: int
    writer: str
    application: str | None = None
    state: str | None = None
    source: str | None = field(name="from", default=None)
    to: str | None = None
    situation: str | None = None
    when: str | None = None


class DebuggerState(Struct):
    """made: breakpoints so far. stopped: paused application to the breakpoint at which it is, if
    at one. passing: the applications of which what is judged next passes the breakpoints on
    transitions. backlog: what was raised up to here may have waited in a pause.
    """

    breakpoints: list[Breakpoint] = []
    made: int = 0
    stopped: dict[str, int] = {}
    passing: list[str] = []
    backlog: int = 0


class Debugger:
    """The debugger of one robot. active: there is a breakpoint or a paused application; while
    there is none nothing of this is asked for.
    """

    def __init__(self, world: World) -> None:
        self.state = DebuggerState()
        self.active = False
        self._world = world
        self._machines: list[Machine] = []
        self._guards: dict[int, Compiled] = {}

    def run(self, machines: list[Machine]) -> None:
        """These are the robot's applications."""
        self._machines = machines

    def restore(self, state: DebuggerState) -> None:
        """Goes on from a state of the same project; board and applications were restored before."""
        self.state, self._guards = state, {}
        for one in state.breakpoints:
            if one.when is not None:
                condition = when_text.read(one.when)
                assert isinstance(condition, Condition)
                self._guard(one.id, condition)
        self._settle()

    def fit(self, cause: int) -> None:
        """Another version: what does not fit it any longer is taken away. Its state has been
        carried over.
        """
        state, running = self.state, {machine.name for machine in self._machines}
        before = list(state.breakpoints)
        fitting = [one for one in before if self._misfit(one) is None]
        state.stopped = {
            name: one
            for name, one in state.stopped.items()
            if name in running and any(one == kept.id for kept in fitting)
        }
        state.breakpoints = fitting
        self.restore(state)
        if len(fitting) < len(before):
            self._tell(RUNTIME, cause)
        if self._world.board.get(PAUSED) is not None:
            self._publish()

    def accept(self, given: inputs.Debugging) -> str | None:
        """Does what an operator asks for; why not, where it can not be done."""
        no: str | None
        if isinstance(given, inputs.Break):
            no = self._break(given)
        elif isinstance(given, inputs.Unbreak):
            no = self._unbreak(given)
        elif isinstance(given, (inputs.Pause, inputs.Resume)):
            no = self._pause_or_resume(given)
        else:
            machine = self._one(given.application)
            if isinstance(machine, str):
                no = machine
            elif isinstance(given, inputs.Step):
                no = self._advance(machine, given.writer)
            else:
                no = self._go_to(machine, given)
        self._settle()
        return no

    # -- what the robot asks -------------------------------------------------

    def free(self) -> list[Machine]:
        """The applications that are not paused."""
        return [machine for machine in self._machines if not machine.paused]

    def look(self, seen: int) -> None:
        """Pauses at states entered and situations begun since the event ``seen`` of this step."""
        for event in self._world.step.events[seen:]:
            if isinstance(event, (trace.Enter, trace.Situation)):
                for one in self.state.breakpoints:
                    self._look(one, event)

    def stops(self, machine: Machine) -> bool:
        """Whether it pauses before what it would judge now."""
        return not self._use_pass(machine) and self._stops(machine, next_passage(machine))

    def stops_timeout(self, machine: Machine) -> bool:
        """Whether it pauses before its timeout, which falls due now."""
        return not self._use_pass(machine) and self._stops(machine, timeout_passage(machine))

    # -- breakpoints ---------------------------------------------------------

    def _break(self, given: inputs.Break) -> str | None:
        on_transition = given.source is not None or given.to is not None
        if (given.state is not None) + on_transition + (given.situation is not None) != 1:
            return ONE_KIND
        application = given.application
        if (no := self._misfit(given)) is not None:
            return no
        if given.situation is None:
            application = application or self._machines[0].name
        condition = None if given.when is None else when_text.read(given.when)
        if isinstance(condition, str):
            return condition
        self.state.made += 1
        number = self.state.made
        if condition is not None:
            self._guard(number, condition)
        self.state.breakpoints.append(
            Breakpoint(
                number, given.writer, application, given.state, given.source, given.to,
                given.situation, given.when,
            )
        )  # fmt: skip
        self._tell(given.writer)
        return None

    def _misfit(self, one: inputs.Break | Breakpoint) -> str | None:
        """Why there is nothing at which it could pause; None where there is."""
        if one.situation is None or one.application is not None:
            machine = self._one(one.application)
            if isinstance(machine, str):
                return machine
            for path in (one.state, one.source, one.to):
                if path is not None and path not in machine.program.innermost:
                    return _no_state(machine, path)
        if one.situation is not None:
            spds = self._world.project.spds
            known = [each.name for each in spds.situations] if spds is not None else []
            if one.situation not in known:
                return f"there is no situation {one.situation}; {_there_is(known)}"
        return None

    def _unbreak(self, given: inputs.Unbreak) -> str | None:
        state = self.state
        kept = [one for one in state.breakpoints if given.id is not None and one.id != given.id]
        if given.id is not None and len(kept) == len(state.breakpoints):
            known = [str(one.id) for one in state.breakpoints]
            return f"there is no breakpoint {given.id}; {_there_is(known)}"
        if len(kept) < len(state.breakpoints):
            state.breakpoints = kept
            self._tell(given.writer)
        return None

    def _tell(self, writer: str, cause: int | None = None) -> None:
        """The breakpoints stand on the blackboard, and in the trace with who changed them."""
        world = self._world
        value: list[dict[str, Any]] = msgspec.to_builtins(self.state.breakpoints)
        world.keep(BREAKPOINTS, value, writer, world.step.seq + 1)
        version = world.board.state[BREAKPOINTS].version
        world.step.trace(trace.Data, cause, BREAKPOINTS, value, writer, version)

    def _guard(self, number: int, condition: Condition) -> None:
        # Conditions of its own: those of the robot are told apart by their numbers.
        conditions = Conditions(self._world.board, self._world.step)
        self._guards[number] = conditions.compile(condition, None)

    def _holds(self, one: Breakpoint) -> bool:
        return one.when is None or self._guards[one.id]()

    # -- pausing -------------------------------------------------------------

    def _look(self, one: Breakpoint, event: trace.Enter | trace.Situation) -> None:
        if isinstance(event, trace.Enter):
            if (one.application, one.state) != (event.application, event.state):
                return
            stopped = [event.application]
        elif one.situation is None or one.situation != event.to:
            return
        else:
            stopped = [one.application or machine.name for machine in self._machines]
        for machine in self.free():
            if machine.name in stopped and self._holds(one):
                self._pause(machine, event.seq, one.id)

    def _stops(self, machine: Machine, passage: Passage | None) -> bool:
        if passage is None:
            return False
        source, to, cause = passage
        for one in self.state.breakpoints:
            if (
                one.application == machine.name
                and (one.source is not None or one.to is not None)
                and one.source in (None, source)
                and one.to in (None, to)
                and self._holds(one)
            ):
                self._pause(machine, cause, one.id)
                self.state.passing.append(machine.name)
                return True
        return False

    def _use_pass(self, machine: Machine) -> bool:
        """Whether it may pass the breakpoints on transitions; it may so only once."""
        passes = machine.name in self.state.passing
        if passes:
            self.state.passing.remove(machine.name)
        return passes

    def _pause(
        self,
        machine: Machine,
        cause: int | None,
        stopped: int | None,
        writer: str | UnsetType = UNSET,
    ) -> None:
        machine.hold()
        self._use_pass(machine)
        self.state.stopped.pop(machine.name, None)
        if stopped is not None:
            self.state.stopped[machine.name] = stopped
        no = machine.state.no
        self._world.step.trace(trace.Paused, cause, machine.name, no, stopped, writer)
        self._publish()

    def _pause_or_resume(self, given: inputs.Pause | inputs.Resume) -> str | None:
        machines = self._machines
        if given.application is not None:
            machine = self._one(given.application)
            if isinstance(machine, str):
                return machine
            machines = [machine]
        pauses = isinstance(given, inputs.Pause)
        for machine in machines:
            if machine.paused == pauses:
                continue
            if pauses:
                self._pause(machine, None, None, given.writer)
            else:
                self._resume(machine, given.writer)
        return None

    def _resume(self, machine: Machine, writer: str) -> None:
        world, name = self._world, machine.name
        stopped = self.state.stopped.pop(name, None)
        self.state.backlog = world.state.raised
        machine.release(
            world.step.trace(trace.Resumed, None, name, machine.state.no, stopped, writer)
        )
        self._publish()

    def _publish(self) -> None:
        """Who is paused stands on the blackboard, with the breakpoint that paused it."""
        paused = {m.name: self.state.stopped.get(m.name) for m in self._machines if m.paused}
        self._world.keep_if_new(PAUSED, paused, self._world.step.seq)

    def _advance(self, machine: Machine, writer: str) -> str | None:
        if not machine.paused:
            return f"{machine.name} is not paused: pause it first"
        step = self._world.step
        before = step.seq
        machine.release(None)
        if step.seq == before:
            advance(machine)
        if step.seq == before:
            machine.hold()
            return f"nothing waits in {machine.name}: raise an event, or let it go on"
        self._pause(machine, None, None, writer)
        return None

    def _go_to(self, machine: Machine, given: inputs.Goto) -> str | None:
        if given.state not in machine.program.innermost:
            return _no_state(machine, given.state)
        self._use_pass(machine)
        machine.go_to(given.state, given.writer)
        if machine.paused:
            # To enter a state lets its actions begin; those behind them wait again.
            machine.hold()
        return None

    # ------------------------------------------------------------------------

    def _one(self, application: str | None) -> Machine | str:
        """The application of that name; where none is named, the only one; else what is wrong."""
        for machine in self._machines:
            if machine.name == application or (application is None and len(self._machines) == 1):
                return machine
        known = _there_is([machine.name for machine in self._machines])
        if application is None:
            return f"which application? {known}"
        return f"there is no application {application}; {known}"

    def _settle(self) -> None:
        self.active = bool(self.state.breakpoints) or len(self.free()) < len(self._machines)


def _no_state(machine: Machine, path: str) -> str:
    known = _there_is(list(machine.program.innermost))
    return f"{machine.name} has no state {path}; {known}"


def _there_is(known: list[str]) -> str:
    return f"there is {', '.join(known) or 'none'}"
