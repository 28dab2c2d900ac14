"""What follows from an input or from what fell due, until nothing is left.

formats.md, *Time and steps*: situations and authority, then resumptions and unnamed
events, then the earliest raised event of all applications.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from situ.decide.debugger import Debugger
from situ.decide.hearing import phrases
from situ.decide.machine import Machine, Raised
from situ.decide.presence import Presence
from situ.decide.priorities import RUNTIME
from situ.decide.situations import Situations
from situ.decide.world import World

LIVELOCK = 100
"""More events, resumptions and situation changes than this in one moment are a livelock."""


class Settling:
    """One robot coming to rest. ``machines`` stand in the project's order.

    moment: of the present step; count: of events, resumptions and situation changes in it since
    the last input. livelocked: the present step was broken off. at_rest: the last step ended
    with nothing left to do.
    """

    def __init__(self, world: World, presence: Presence) -> None:
        self.moment = self.count = 0
        self.at_rest = False
        self.machines: list[Machine] = []
        self._world = world
        self._presence = presence
        project = world.project
        self._alone = dict.fromkeys((a.name for a in project.applications.values()), 1)
        self.livelocked = False
        self.situations: Situations | None = None
        if project.spds is not None:
            self.situations = Situations(project.spds, world.conditions, world.board, world.step)
        self.debugger = Debugger(world)
        self._shown: list[Machine] = []
        self._heard: list[Machine] = []

    def run(self, machines: list[Machine]) -> None:
        """These are the robot's applications."""
        self.machines = machines
        self.debugger.run(machines)
        self._shown = [one for one in machines if one.program.has_screens]
        self._heard = [one for one in machines if one.program.has_phrases]

    def settle(self) -> None:
        """Goes round until nothing is left; live screens at the end."""
        if self.situations is not None:
            self.observe()
        if self.debugger.active:
            self.debugger.look(0)
        for machine in self.machines:
            state = machine.state
            if state.queue or state.stale or state.suspended:
                self._go_round()
                break
        self.at_rest = not (self.livelocked or self.debugger.active)
        if self._heard:
            self.listen()
        for machine in self._shown:
            machine.refresh()

    def _go_round(self) -> None:
        while (follows := self._follows()) is not None and self._may_go_on():
            seen = len(self._world.step.events)
            follows()
            self.observe()
            if self.debugger.active:
                self.debugger.look(seen)

    def _follows(self) -> Callable[[], object] | None:
        if self.livelocked:
            return None
        debugger = self.debugger
        if not debugger.active:
            turn = self._turn(self.machines)
        else:
            turn = self._turn(debugger.free())
            while turn is not None and debugger.stops(turn[0]):
                turn = self._turn(debugger.free())
        return None if turn is None else turn[1]

    def _turn(self, machines: list[Machine]) -> tuple[Machine, Callable[[], object]] | None:
        """Whose turn it is, and for what."""
        for machine in machines:
            if machine.may_resume():
                return machine, machine.resume
        for machine in machines:
            taken = machine.unnamed()
            if taken is not None:
                return machine, partial(machine.take_unnamed, taken)
        first: tuple[Machine, Raised] | None = None
        for machine in machines:
            found = machine.earliest()
            if found is not None and (first is None or found.order < first[1].order):
                first = machine, found
        if first is None:
            return None
        machine, raised = first
        if raised.order <= self.debugger.state.backlog and not raised.own:
            # It waited during a pause; each input counts anew.
            self.count = 0
        return machine, partial(machine.judge_event, raised)

    def _may_go_on(self) -> bool:
        """Counts one more of what must not go on for ever."""
        self.count += 1
        if self.count <= LIVELOCK:
            return True
        # Later steps of this moment begin anew: what falls due in them is finite.
        self.livelocked, self.count = True, 0
        step = self._world.step
        last = step.events[-1].seq if step.events else None
        names = ", ".join(m.name for m in self.machines if m.state.queue or m.state.stale)
        step.error(
            last,
            f"livelock: more than {LIVELOCK} events without an end; waiting events are dropped, "
            "look for states that lead to each other without waiting",
            names or "situations",
        )
        for machine in self.machines:
            machine.stay()
        return False

    # -- situations and authority --------------------------------------------

    def observe(self) -> None:
        """Judges the situations that changed; the current one grants authority."""
        situations = self.situations
        while situations is not None and not self.livelocked:
            seq = situations.observe()
            if seq is None:
                return
            self._world.keep("situation", self._situation(), RUNTIME, seq)
            self.reassign(seq)
            self._may_go_on()

    def judge_anew(self, cause: int) -> None:
        """Another version: which situation is current now; authority is not yet granted by it."""
        value = None
        if self.situations is not None:
            self.situations.judge_anew(cause)
            value = self._situation()
        if value != self._world.board.look("situation"):
            self._world.keep("situation", value, RUNTIME, cause)

    def _situation(self) -> dict[str, Any]:
        """What stands at ``situation``."""
        assert self.situations is not None
        current = self.situations.current
        return {
            "name": current.name if current is not None else None,
            "priorities": dict(self.situations.granted()),
        }

    def reassign(self, cause: int | None) -> None:
        """Grants authority anew and tells the applications."""
        situations = self.situations
        granted = self._alone if situations is None else situations.granted()
        changed = self._world.priorities.assign(granted, cause)
        if changed:
            for machine in self.machines:
                machine.on_authority(changed, cause)

    def asked(self, module: str, seq: int) -> None:
        """A module, an application too, asks for authority: who it needs should be there."""
        self.warn_of_absent(module, seq)
        self.reassign(seq)

    def warn_of_absent(self, module: str, seq: int) -> None:
        """Who it needs and who is not there."""
        for absent in self._presence.lacks(module):
            self._world.step.warn(seq, f"{module} needs {absent}, which is absent", module)

    # -- phrases -------------------------------------------------------------

    def listen(self) -> None:
        """The phrases expected now stand at ``listen``."""
        heard = (text for machine in self._heard for text in phrases(self._world, machine))
        self._world.keep_if_new("listen", list(dict.fromkeys(heard)), None)
