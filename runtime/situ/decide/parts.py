"""What is made of one version of a project; blackboard, time and authority outlive it."""

from __future__ import annotations

from situ.decide.deploying import Deploying
from situ.decide.intake import Intake
from situ.decide.machine import Machine
from situ.decide.presence import Presence
from situ.decide.settling import Settling
from situ.decide.step import Timer
from situ.decide.world import World


class Parts:
    """The parts of a robot that runs the project of ``world``.

    Where the world has had another before, it has been told (``World.deploy``).
    """

    def __init__(self, world: World, deploying: Deploying) -> None:
        self.conditions = world.conditions
        self.presence = Presence(world.project)
        self.settling = Settling(world, self.presence)
        self.machines = [
            Machine(world, application, number, self.settling.asked)
            for number, application in enumerate(world.project.applications.values())
        ]
        self.settling.run(self.machines)
        deploying.machines = self.machines
        self.deploying = deploying
        self.intake = Intake(world, self.presence, self.settling, deploying)
        self._world = world

    def ring(self, timer: Timer) -> None:
        """Lets a timer that ``is_live`` do what it was set for."""
        kind, _, name = timer.owner.partition(":")
        if kind == "test":
            self.conditions.due(int(name), timer.token)
        elif kind == "situation":
            assert self.settling.situations is not None
            self.settling.situations.due(int(name))
        elif kind == "command":
            self._world.priorities.due(name)
        elif kind == "deploy":
            self.deploying.due()
        elif kind == "action":
            machine = self.machines[int(name)]
            cause = machine.actions.state.running[timer.token].seq
            machine.finish(timer.token, True, None, None, None, cause)
        else:
            machine = self.machines[int(name)]
            debugger = self.settling.debugger
            if not (debugger.active and debugger.stops_timeout(machine)):
                machine.due()

    def is_live(self, timer: Timer) -> bool:
        """Whether a timer still means something to its owner."""
        kind, _, name = timer.owner.partition(":")
        if kind == "test":
            return True
        if kind == "situation":
            assert self.settling.situations is not None
            return self.settling.situations.is_live(int(name), timer.token)
        if kind == "command":
            return self._world.priorities.is_live(name, timer.token)
        if kind == "deploy":
            return self.deploying.is_live(timer.token)
        if kind == "action":
            return timer.token in self.machines[int(name)].actions.state.running
        return self.machines[int(name)].timeouts.is_live(timer.token)
