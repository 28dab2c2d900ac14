"""What an application does next and where that leads, which a debugger asks beforehand.

The order is that of ``settling``: a resumption, unnamed events, then what was raised.
"""

from __future__ import annotations

from situ.decide.machine import DONE, Machine
from situ.document.rbd import BACK, RESUMED

Passage = tuple[str, str, int | None]
"""From which state to which, by their paths, and the seq of what causes it."""


def next_passage(machine: Machine) -> Passage | None:
    """Where what is judged next would lead; None: nowhere."""
    named = machine.here.named
    if machine.may_resume():
        taken, cause = machine.first(named.get(RESUMED, ())), machine.state.granted
    elif (taken := machine.unnamed()) is not None:
        cause = machine.state.stale[taken.key]
    else:
        raised = machine.earliest()
        if raised is None or machine.state.suspended:
            return None
        cause = raised.cause
        if raised.holder is None:
            taken = machine.first(named.get(raised.name, ()))
        else:
            done = machine.of_holder(raised.name, raised.holder)
            taken = machine.first(done) or machine.first(machine.of_holder(DONE, raised.holder))
    if taken is None or taken.next is None:
        return None
    return (*machine.leads(taken.next, taken.level), cause)


def timeout_passage(machine: Machine) -> Passage | None:
    """The same of the timeout, which falls due."""
    here, clock = machine.here, machine.timeouts.clock
    assert clock is not None
    level = here.timeout_level
    if here.next is None or (here.next == BACK and not machine.state.stacks[level]):
        return None
    return (*machine.leads(here.next, level), clock.cause)


def advance(machine: Machine) -> None:
    """Lets it judge the next thing now; where none waits, its timeout falls due."""
    clock = machine.timeouts.clock
    if machine.may_resume():
        machine.resume()
    elif (taken := machine.unnamed()) is not None:
        machine.take_unnamed(taken)
    elif (raised := machine.earliest()) is not None:
        machine.judge_event(raised)
    elif clock is not None and clock.due is not None:
        rings = machine.here.next is None
        machine.due()
        if rings:
            machine.judge_event(machine.state.queue[-1])
