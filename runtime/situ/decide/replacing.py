"""One version of a project in place of another, in one step: what still exists is kept.

docs/semantics.md, *Deploy*. First everything is carried over, which traces nothing; then follows,
in this order, what is new, what is gone, who may do what, and what the applications do.
"""

from __future__ import annotations

import heapq

from msgspec.structs import replace

from situ.decide.machine import Machine
from situ.decide.parts import Parts
from situ.decide.step import Timer
from situ.decide.takeover import Takeover
from situ.decide.world import World


def take_over(world: World, old: Parts, new: Parts, live: list[Timer], cause: int) -> None:
    """Lets ``new`` go on from where ``old`` is; ``cause`` is the seq of what told of it. live: the
    timers of ``old`` that still meant something.
    """
    kept, gone = _carry(world, old, new, live, cause)
    tags = world.project.tags
    world.write(
        {tag: value for tag, value in tags.items() if tag not in world.board.state},
        "project",
        cause,
    )
    for machine in gone:
        _end(world, machine, cause)
    for one in kept.values():
        one.leave()
    settling = new.settling
    settling.debugger.fit(cause)
    settling.judge_anew(cause)
    _withdraw(world, new, {machine.name for machine in new.machines if machine.name in kept}, cause)
    for machine in new.machines:
        if machine.name in kept and (asked := kept[machine.name].ask()) is not None:
            settling.warn_of_absent(machine.name, asked)
    settling.reassign(cause)
    for machine in new.machines:
        if machine.name in kept:
            kept[machine.name].go_on()
        else:
            machine.start(cause)
    settling.listen()


def _carry(
    world: World, old: Parts, new: Parts, live: list[Timer], cause: int
) -> tuple[dict[str, Takeover], list[Machine]]:
    """All state and every live timer; gives the applications that both have, by name, and those
    that are gone.
    """
    numbers = {machine.name: number for number, machine in enumerate(new.machines)}
    kept: dict[str, Takeover] = {}
    gone: list[Machine] = []
    world.step.timers.clear()
    new.presence.state = old.presence.state
    moved = {"test": new.conditions.carry(old.conditions, cause), "situation": {}}
    if old.settling.situations is not None and new.settling.situations is not None:
        moved["situation"] = new.settling.situations.carry(old.settling.situations, live)
    moved["action"] = moved["application"] = {}
    for number, machine in enumerate(old.machines):
        to = numbers.get(machine.name)
        if to is None:
            gone.append(machine)
            continue
        moved["action"][number] = to
        kept[machine.name] = Takeover(machine, new.machines[to], cause)
        kept[machine.name].carry()
    new.settling.debugger.state = old.settling.debugger.state
    for timer in live:
        kind, _, name = timer.owner.partition(":")
        if kind not in moved:
            heapq.heappush(world.step.timers, timer)
        elif int(name) in moved[kind]:
            owner = f"{kind}:{moved[kind][int(name)]}"
            heapq.heappush(world.step.timers, replace(timer, owner=owner))
    return kept, gone


def _end(world: World, machine: Machine, cause: int) -> None:
    """An application that is gone leaves its state, and nothing of it runs on."""
    machine.leave(0, cause)
    for running in list(machine.actions.state.running.values()):
        machine.actions.cancel(running, cause)
    world.priorities.abandon(machine.name, (), cause)
    world.keep(f"application/{machine.name}", None, machine.name, cause)


def _withdraw(world: World, new: Parts, applications: set[str], cause: int) -> None:
    """Modules no longer ask for or command what they do not declare any longer."""
    state = world.priorities.state
    for module in sorted({*state.requests, *state.commands} - applications):
        request = state.requests.get(module)
        asked = (*request.resources, *request.optional) if request is not None else ()
        all_of_it = {*asked, *state.commands.get(module, ())}
        strange = tuple(
            sorted(one for one in all_of_it if new.presence.refusal(module, (one,)) is not None)
        )
        if strange:
            world.priorities.abandon(module, strange, cause)
